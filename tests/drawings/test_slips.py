"""Slips that are easy to make, planted into our own code: a sign, a factor, a letter exchanged, another assembly."""

import tomllib
from pathlib import Path

import pytest

from drawings.commands.draw import draw
from drawings.gallery.catalogue import GALLERY
from drawings.paper.strokes import SheetError
from geometry.errors import DraftError
from tests.drawings.planting import DrawingFault, planted
from tests.parts import some

TABLES = sorted((Path(__file__).parents[1] / "cases" / "slips").glob("*.toml"))
READ = [tomllib.loads(table.read_text("utf-8")) for table in TABLES]
SLIPS = [
    DrawingFault(name, **{"scene": table["scene"]} | one) for table in READ for name, one in table["slips"].items()
]
EVERYDAY = 50  # of the slips, one is planted every day
STOPPED = (DraftError, SheetError, ArithmeticError, LookupError, ValueError, AssertionError)


@pytest.mark.parametrize("slip", some(SLIPS, EVERYDAY, [slip.name for slip in SLIPS]))
def test_a_slip_is_seen(slip: DrawingFault, tmp_path: Path) -> None:
    scene = GALLERY / f"{slip.scene}.toml"
    with planted(slip):
        try:
            paths = draw(scene, tmp_path).paths
        except STOPPED:
            return
    drawn = {path.name: path.read_bytes() for path in paths}
    assert any((GALLERY / name).read_bytes() != own for name, own in drawn.items())


@pytest.mark.parametrize("slip", SLIPS, ids=lambda slip: slip.name)
def test_a_slip_changes_its_text(slip: DrawingFault) -> None:
    assert slip.right not in slip.text or slip.right in slip.wrong
