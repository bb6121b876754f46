"""The tables of planted faults: what each row replaces stands in its file, once, so that no row is left behind."""

import tomllib
from functools import cache
from pathlib import Path

from tests.rows import over

ROOT = Path(__file__).parents[1]
TABLES = sorted((ROOT / "tests" / "cases").glob("*faults.toml"))


@cache
def written(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


@over("table", TABLES)
def test_what_a_row_replaces_stands_in_its_file_once(table: Path) -> None:
    faults = [one for one in tomllib.loads(table.read_text(encoding="utf-8"))["faults"] if "right" in one]
    left = [one["name"] for one in faults if written(one["file"]).count(one["right"]) != 1]
    assert faults and not left, f"left behind: {left}. Fix: renew what they replace"
