"""The self-check of the figure of a profile: what is drawn passes, a careless draughtsman's faults are seen."""

from __future__ import annotations

from functools import cache

import pytest

from drawings.checks.cam.profile_marks import wrong_marks
from drawings.checks.cam.profiles import Analysed, wrong
from drawings.figures.cam import profile_figure
from drawings.figures.cam.profile_view import NAME
from drawings.lettering.lettering import lettered
from drawings.measure.measure import measure
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from plans.analytic.cam.findings import cam_found
from plans.cam.course import positions
from plans.model.cam_motion import CamFound
from plans.scene.scene import parse_scene
from tests.drawings.cam_contours import EVERY, view_of
from tests.drawings.exhibits import SHEET, exhibited
from tests.drawings.slips import Change, changed, dropped, rewritten, shifted, stretched, turned
from tests.parts import first

DRAFTING = drafting_of(parse_scene(SHEET.format(format="A1", language="en")))


@cache
def made(name: str) -> tuple[Leaf, CamFound]:
    """Give a figure, and what the analysis finds of its cam."""
    own = view_of(name).found
    return exhibited([(profile_figure, view_of(name))], "A1"), cam_found(own.cam, own.sizes, positions(own.cam))


def seen(leaf: Leaf, found: CamFound) -> list[str]:
    return [str(one) for one in wrong_marks(measure(svg(lettered(leaf))), leaf, found, DRAFTING)]


@pytest.mark.parametrize("name", first(EVERY))
def test_what_is_drawn_agrees_with_the_analysis(name: str) -> None:
    assert seen(*made(name)) == []


def test_the_curves_of_the_figure_are_measured_too() -> None:
    leaf, found = made("groove")
    exact = Analysed(found.cam, found.sizes, found.roller, found.contour)
    assert list(wrong(measure(svg(lettered(leaf))).profiles, NAME, exact)) == []


@pytest.mark.parametrize(
    "fault",
    first(
        [
            ("groove", shifted("P", NAME, 0.002), "P on profile in position 0 (against the analysis)"),
            ("groove", turned("Q", NAME), "Q on profile in position 0 (against the analysis)"),
            ("groove", shifted("K", NAME, 0.002j), "K on profile in position 2 (against the analysis)"),
            ("groove", stretched("R_0", NAME), "R_0 on profile (against the analysis)"),
            ("groove", turned("e", NAME), "e on profile (against the analysis)"),
            ("groove", stretched("ρ_min", NAME), "ρ_min on profile (against the analysis)"),
            ("groove", dropped("P", NAME), "P 0 on profile is missing"),
            ("groove", rewritten("φrise = 120°", "φ = 120°"), "φrise = 120° on profile is missing"),
            ("rocker", shifted("O_1", NAME, 0.002), "O_1 on profile in position 1 (against the analysis)"),
            ("rocker", stretched("L", NAME), "L on profile (against the analysis)"),
            ("rocker", dropped("L", NAME), "L on profile is missing"),
            ("rocker", rewritten("φdwell = 30°", "φ = 30°"), "φdwell = 30° on profile is missing"),
        ]
    ),
)
def test_a_planted_fault_is_seen(fault: tuple[str, Change, str]) -> None:
    name, change, told = fault
    leaf, found = made(name)
    spoilt = changed(leaf, change)
    assert told in seen(spoilt, found)
