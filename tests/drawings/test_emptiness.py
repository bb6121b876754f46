"""Sheets are filled: no large empty rectangle is left on any, measured on a grid of their ink."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from drawings.page.page import Page, page_of
from drawings.paper.hand import SIZES
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import sheet_kind
from plans.scene.scene import Scene, read_scene
from plans.study import Study
from tests.drawings.emptiness import emptiness
from tests.gallery import SCENES
from tests.parts import first

LARGEST, LAST, SMALLEST = 0.15, 0.25, 0.30  # shares that an empty rectangle may take, on the last of some sheets, on A4
# Of a chain of cams a bar chart that stands with the notes alone leaves a strip on an A4 (0.169), beside the profile of
# a flat-faced cam one is left on an A3 (0.155).
# Where one plan alone stands on a sheet, at a scale whose next larger one does not fit, a strip is left beside it: of
# a press the slim plan with the notes (0.172), of a slotted lever the plan with its lengths (0.171), of a six-link
# one scheme with its centres (0.204), of a cam under a spring its diagrams and its main sizes (0.174, 0.216). A load
# diagram, no longer than twenty letters, stands alone between a pump's lever and its graph (0.231). Of a linkage at a
# scale that was asked for the plan alone is shown. Beside the loop in projection a pump has two tables (0.201). Beside
# turned plans a strip is left: of a slider-crank (0.155), a tangent mechanism (0.169), a slotted link upright (0.180).
# Of a box of gears each plan of velocities stands alone with its plan of angular ones (0.231), of an axle and a rack
# press the scheme and its triangles (0.158, 0.176). Of a boxer's bank two views have a strip beside them (0.175).
NARROW, ALONE, SMALL, FEW = 0.17, 0.22, 0.24, 0.31
STRIPS = {
    ("automaton", "A3"): NARROW,
    ("automaton", "A4"): NARROW,
    ("press-cycle", "A3"): ALONE,
    ("slotted-lever", "A4"): ALONE,
    ("centres-shaper", "A4"): ALONE,
    ("spring-cam", "A4"): ALONE,
    ("rocking-pump", "A4"): SMALL,
    ("gear-box", "A4"): SMALL,
    ("axle-differential", "A4"): NARROW,
    ("press-rack", "A4"): ALONE,
    ("boxer", "A4"): ALONE,
    ("reciprocating-pump", "A3"): ALONE,
    ("turned-slider-crank", "A3"): NARROW,
    ("turned-tangent", "A1"): NARROW,
    ("turned-slotted-link", "A4"): ALONE,
    **dict.fromkeys(product(("lambda-positions",), ("A1", "A2", "A3", "A4")), FEW),
}
ROWS = [*product(SCENES, ("A2", "A3", "A1", "A4"))]
ROWS.sort(key=lambda row: row[0].stem != "vee-four")  # a bank: it is laid out in the shortest time


@pytest.mark.parametrize("row", first(ROWS), ids=lambda row: f"{row[0].stem}-{row[1]}")
def test_no_sheet_is_left_empty(row: tuple[Path, str]) -> None:
    path, size = row
    scene = read_scene(path)
    study = Study(scene.changed(sheet=scene.sheet.changed(format=size, orientation=None)))
    for kind in study.scene.sheets:
        leaves = sheet_kind(kind).leaves(study)
        found = [emptiness(leaf, _page(study.scene, kind, leaf)) for leaf in leaves]
        most, last = STRIPS.get((path.stem, size), LARGEST), SMALLEST if size == "A4" else LAST
        closing = most if len(found) == 1 else last  # one sheet alone is as full as any
        assert all(one <= most for one in found[:-1]) and found[-1] <= closing, (kind, found)


def _page(scene: Scene, kind: str, leaf: Leaf) -> Page:
    """Give the page of a leaf, which may be of a smaller format than its scene's."""
    pages = (page_of(scene.changed(sheet=scene.sheet.changed(format=size)), kind) for size in SIZES)
    return next(page for page in pages if page.size == (leaf.width, leaf.height))
