"""Sheets that a real Inkscape opened and saved again, by its command line: they are graded as they were before."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.drawings import cell_students, test_curve_grading, test_grading
from tests.drawings.students import task
from tests.drawings.test_graded_mistakes import TABLES, Table

INKSCAPE = shutil.which("inkscape")
pytestmark = [pytest.mark.deep, pytest.mark.skipif(not INKSCAPE, reason="needs Inkscape")]

# What is done to the sheet before it is saved; in px, as Inkscape's actions take it.
GROUP = "select-all:all;selection-group"
WAYS = {
    "as it is": "",
    "in one group": GROUP,
    "in no groups": "select-all:groups;selection-ungroup",
    "moved": f"{GROUP};transform-translate:-30,20",
    "smaller": f"{GROUP};transform-scale:0.7",
    "turned": f"{GROUP};transform-rotate:90",
    "moved and regrouped": f"{GROUP};transform-translate:7.3,-11;selection-ungroup;{GROUP}",
    "all lines paths": "select-by-element:line;object-to-path;select-clear;select-by-element:circle;object-to-path",
}


def saved(source: bytes, folder: Path, actions: str = "", plain: bool = False) -> bytes:
    """Open a sheet in Inkscape, do something to it and save it, as its own SVG or as a plain one."""
    before, after = folder / "before.svg", folder / "after.svg"
    before.write_bytes(source)
    after.unlink(missing_ok=True)
    export = [
        *filter(None, [actions]),
        f"export-filename:{after}",
        *(["export-plain-svg"] if plain else []),
        "export-do",
    ]
    command = [str(INKSCAPE), f"--actions={';'.join(export)}", str(before)]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    assert b"inkscape" in after.read_bytes() or plain
    return after.read_bytes()


@pytest.mark.parametrize("plain", [False, True], ids=["inkscape", "plain"])
@pytest.mark.parametrize("way", WAYS)
def test_our_own_sheet_is_right(tmp_path: Path, way: str, plain: bool) -> None:
    own = task("shaper")
    source = saved(own.originals.drawn(own.originals.sheets[0]), tmp_path, WAYS[way], plain)
    names = test_grading.said(own, source)
    assert names == []


@pytest.mark.parametrize("scene", ["slider-crank", "engine-share", "fan"])
def test_every_sheet_is_right(tmp_path: Path, scene: str) -> None:
    own = task(scene)
    for sheet in own.originals.sheets:
        if any(plan.sheet == sheet.name for plan in own.plans):
            names = test_grading.said(own, saved(own.originals.drawn(sheet), tmp_path))
            assert names == []


def test_our_own_graphs_are_right(tmp_path: Path) -> None:
    own = task("planer")
    for way in ("as it is", "moved", "in no groups"):
        source = saved(own.originals.drawn(own.originals.sheets[0]), tmp_path, WAYS[way])
        names = test_curve_grading.said(own, source)
        assert names == [], way


# What leaves a sheet on its paper, whatever its format, and its data on its lines.
KEPT = ("as it is", "in one group", "in no groups", "moved and regrouped")
ROWS = [(row, own) for own in TABLES.values() if own.made is not cell_students.made for row in own.rows]


@pytest.mark.parametrize(
    ("number", "row", "table"), [(k, *row) for k, row in enumerate(ROWS)],
    ids=[f"{row['scene']}: {row['name']}" for row, _ in ROWS],
)  # fmt: skip
def test_a_mistake_is_named_as_before(tmp_path: Path, number: int, row: dict[str, Any], table: Table) -> None:
    own = task(row["scene"])
    way = KEPT[number % len(KEPT)]
    source = saved(table.made(own, row), tmp_path, WAYS[way], plain=bool(number % 2))
    names = table.said(own, source)
    assert names == sorted(row["says"]), way
