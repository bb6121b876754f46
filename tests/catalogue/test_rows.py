"""The rows of the catalogue: each has its cases, or says why it has none; a row is never forgotten."""

from __future__ import annotations

import ast
import re
import tomllib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tests.catalogue.scenes import TEXTS
from tests.rows import over

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
ROWS: dict[str, dict[str, Any]] = tomllib.loads((ROOT / "tests/cases/catalogue.toml").read_text("utf-8"))


def row(text: str) -> str:
    """Give the row that a name begins with: A7 for a07_other_encoding, A7 in words, test_a7_other_encoding."""
    match = re.match(r"(?:test_)?([A-HJKa-hjk])0*(\d+)[ _]", text)
    return f"{match[1].upper()}{match[2]}" if match else ""


def named() -> Iterator[str]:
    """Give everything that is named after a row: scenes, cases in tables, and tests."""
    yield from TEXTS
    for path in HERE.glob("test_*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Dict):
                yield from (
                    key.value for key in node.keys if isinstance(key, ast.Constant) and isinstance(key.value, str)
                )
            elif isinstance(node, ast.FunctionDef):
                yield node.name


CASES = Counter(row(name) for name in named())


def exists(test: str) -> bool:
    path, _, name = test.partition("::")
    return f"\ndef {name}(" in (ROOT / path).read_text("utf-8")


@over("name", ROWS)
def test_a_row_has_its_cases_or_says_why_not(name: str) -> None:
    told = ROWS[name]
    assert set(told) <= {"input", "tests", "cases", "none", "design"}
    assert all(exists(test) for test in told.get("tests", ()))
    assert set(told.get("cases", ())) <= TEXTS.keys()
    covered = CASES[name] + len(told.get("tests", ())) + len(told.get("cases", ()))
    assert bool(covered) != ("none" in told), covered


def test_no_case_is_named_after_a_row_that_is_none() -> None:
    assert set(CASES) - {""} <= set(ROWS)


def test_the_catalogue_is_whole() -> None:
    counts = Counter(name[0] for name in ROWS)
    assert counts == {"A": 24, "B": 26, "C": 14, "D": 16, "E": 24, "F": 8, "G": 14, "H": 20, "J": 7, "K": 20}
