"""The self-check of the sheet of a cam to be made: what is drawn passes, faults of a draughtsman withhold it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest

from drawings.checks.cam.cam_page import pole_of
from drawings.checks.cam.verify_profile import check
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.verify import SelfCheckFailed, verify
from drawings.figures.cam.manufacturing import PLAN, manufacture
from drawings.lettering.lettering import lettered
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Curve, Group, Leaf, Line, Stroke
from drawings.pens.svg import svg
from drawings.sheets.cam_profile import sheets
from plans.analytic.cam.findings import cam_found
from plans.cam.course import positions
from plans.model.cam_motion import CamFound
from plans.scene.scene import parse_scene
from plans.words.words import said
from tests.drawings.cam_contours import EVERY, view_of
from tests.drawings.exhibits import SHEET
from tests.drawings.slips import Change, changed, dropped, note, reworded, row_dropped, shifted, turned, without
from tests.parts import first

SCENE = parse_scene(SHEET.format(format="A3", language="en"))


@cache
def made(name: str) -> tuple[Leaf, CamFound]:
    """Give the sheet of a cam, and what the analysis finds of it."""
    own = view_of(name).found
    (leaf,) = sheets(SCENE, [manufacture(own)])
    return leaf, cam_found(own.cam, own.sizes, positions(own.cam))


def checked(leaf: Leaf, found: CamFound, folder: Path) -> None:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    verify(path, leaf, partial(check, found=found, drafting=drafting_of(SCENE)))


@pytest.mark.rest
@pytest.mark.parametrize("name", first(EVERY))
def test_what_is_drawn_agrees_with_the_analysis(name: str, tmp_path: Path) -> None:
    checked(*made(name), tmp_path)


def bent(name: str, by: complex) -> Change:
    """Draw a curve of the cam otherwise than it is."""

    def change(stroke: Stroke) -> Stroke:
        if not isinstance(stroke, Group) or stroke.data.get("name") != name or stroke.data["kind"] != "profile":
            return stroke
        (curve,) = stroke.strokes
        assert isinstance(curve, Curve)
        middle = np.mean([piece.start for piece in curve.pieces])
        pieces = tuple(piece.placed(by, complex(middle * (1 - by))) for piece in curve.pieces)
        return replace(stroke, strokes=(curve._replace(pieces=pieces),))

    return change


@pytest.mark.parametrize(
    "fault",
    first(
        [
            (bent("profile", 1.001), "profile on cam to be made"),
            (bent("profile", np.exp(0.001j)), "profile on cam to be made"),
            (bent("pitch", 1.001), "pitch on cam to be made"),
            (dropped("profile", PLAN), "profile on cam to be made is missing"),
            (turned("r", PLAN), "r 30 on cam to be made (against the analysis)"),
            (shifted("r", PLAN, 0.002), "r 30 on cam to be made (against the analysis)"),
            (dropped("r", PLAN), "r 30 on cam to be made is missing"),
            (reworded("33.015", "33.016"), "33.016 for 5 in the table of radii"),
            (reworded("5.213", "5.312"), "5.312 for 5 in the table of radii"),
            (row_dropped("90"), "90 is missing from the table of radii"),
            (without("radii-1"), "0 is missing from the table of radii"),
            (without("notes"), "is missing from the notes"),
            (note("counter-", ""), "in the notes"),
            (note("12 mm", "13 mm"), "in the notes"),
            (note("62.345", "62.354"), "in the notes"),
            (reworded("φ 60°", "φ 61°"), "the letter r on cam to be made"),
        ]
    ),
)
def test_a_planted_fault_is_seen(fault: tuple[Change, str], tmp_path: Path) -> None:
    (change, wrong), (leaf, found) = fault, made("offset")
    spoilt = changed(leaf, change)
    assert spoilt != leaf
    with pytest.raises(SelfCheckFailed) as told:
        checked(spoilt, found, tmp_path)
    assert wrong in str(told.value)
    assert "against the analysis" not in said(told.value, "ru")


def test_a_pole_that_has_lost_its_circle_is_nowhere() -> None:
    pole = Group((Line(0j, 1 + 0j),), "", {"kind": "pole", "scale": "0.001"})
    assert pole_of(FigureStrokes(Group((pole,), "profile"))) is None
