"""Sums: how large the house, its self-check and its tests may be in all, and any file by itself (вес)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PRODUCT = ("geometry", "plans", "drawings")
# Lines at the most: of what is shipped, of what is checked when a sheet is drawn, of the tests with their cases.
MOST: Mapping[str, tuple[int, tuple[str, ...]]] = {
    "product": (111_230, tuple(f"{top}/**/*.py" for top in PRODUCT)),
    "self-check": (6_180, ("drawings/checks/**/*.py", "drawings/*/due*.py")),
    "tests": (46_242, ("tests/**/*.py", "tests/**/*.toml", "tests/**/*.json")),
}
LONGEST = 400  # lines of a file of the product


def lines(*patterns: str) -> Iterator[tuple[Path, int]]:
    """Count the lines of files."""
    for path in sorted({path for pattern in patterns for path in ROOT.glob(pattern)}):
        yield path, path.read_bytes().count(b"\n")


@pytest.mark.parametrize("part", MOST)
def test_the_house_is_no_larger_than_it_may_be(part: str) -> None:
    most, patterns = MOST[part]
    assert sum(count for _, count in lines(*patterns)) <= most


def test_no_file_is_longer_than_a_reader_bears() -> None:
    long = {path.relative_to(ROOT).as_posix(): count for path, count in lines(*MOST["product"][1]) if count > LONGEST}
    assert long == {}
