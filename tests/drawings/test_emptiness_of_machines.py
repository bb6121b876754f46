"""Sheets of dynamics, cams, cyclograms, rotors, balancing and banks are filled as those of linkages are."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from drawings.page.page import Page, page_of
from drawings.paper.formats import SIZES
from drawings.paper.strokes import Leaf
from drawings.sheets import balancing, bank, cam, cam_profile, cyclogram, dynamics, rotor
from plans.scene.scene import Scene, read_scene
from plans.study import Study
from tests.drawings.emptiness import emptiness
from tests.drawings.test_emptiness import LARGEST, LAST
from tests.gallery import SCENES
from tests.parts import first

KINDS = {
    "balancing": balancing, "bank": bank, "cam": cam, "cyclogram": cyclogram, "dynamics": dynamics,
    "profile": cam_profile, "rotor": rotor,
}  # fmt: skip
# Of a chain of cams a bar chart that stands with the notes alone leaves a strip on an A4 (0.169), beside the profile of
# a flat-faced cam one is left on an A3 (0.155).
NARROW = 0.17
STRIPS = {("automaton", "A3"), ("automaton", "A4")}
MACHINES = [path for path in SCENES if KINDS.keys() & set(read_scene(path).sheets)]
ROWS = [*product(reversed(MACHINES), ("A4", "A3", "A2", "A1"))]


@pytest.mark.parametrize("row", first(ROWS), ids=lambda row: f"{row[0].stem}-{row[1]}")
def test_no_sheet_of_a_machine_is_left_empty(row: tuple[Path, str]) -> None:
    path, size = row
    scene = read_scene(path)
    study = Study(scene.changed(sheet=scene.sheet.changed(format=size, orientation=None)))
    for kind in KINDS.keys() & set(scene.sheets):
        found = [emptiness(leaf, _page(study.scene, kind, leaf)) for leaf in KINDS[kind].leaves(study)]
        most = NARROW if (path.stem, size) in STRIPS else LARGEST
        assert all(one <= most for one in found[:-1]) and found[-1] <= LAST, (kind, found)


def _page(scene: Scene, kind: str, leaf: Leaf) -> Page:
    """Give the page of a leaf, which may be of a smaller format than its scene's."""
    pages = (page_of(scene.changed(sheet=scene.sheet.changed(format=size)), kind) for size in SIZES)
    return next(page for page in pages if page.size == (leaf.width, leaf.height))
