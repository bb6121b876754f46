"""Figures of the main sizes and of the pressure angle: marks where formulas put them, letters clear of all lines."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from drawings.checks.letters import unlettered
from drawings.figures.cam import pressure_graph, size_diagram
from drawings.figures.cam.pressure_graph import PressureView, pressure_view
from drawings.figures.cam.size_view import SizeView
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.sheets import cam_column
from plans.analytic.cam.laws import travel
from plans.analytic.cam.pressure import greatest, pressure
from plans.analytic.cam.sizes import sizes
from plans.cam.course import Course, positions
from plans.cam.sizes import sizing
from plans.cam.study import CamDrawing
from plans.model.cam import DWELL, FORCE, Cam, GivenSizes, limits_of
from tests.drawings.collisions import collisions
from tests.drawings.exhibits import exhibited, read_back
from tests.parts import first
from tests.plans.sized_cams import degrees, flat, flat_rocker, rocking, translating

CAMS = {
    "groove": translating(),
    "clockwise": translating(-1),
    "force": translating(closure=FORCE, limits=degrees(30)),
    "given": translating(given=GivenSizes(0.05, 0.012)),
    "radial": translating(given=GivenSizes(offset=0.0)),
    "rocker": rocking(),
    "against": rocking(-1, -1),
    "on an arc": rocking(given=GivenSizes(centre=0.14)),
    "flat": flat(),
    "flat rocker": flat_rocker(given=GivenSizes(centre=0.12)),
}
PAPER = 3e-4  # mm/mm: rounding of coordinates on paper


@cache
def diagram(name: str, size: str = "A3", language: str = "en") -> tuple[Leaf, Measured]:
    leaf = exhibited([(size_diagram, SizeView(sizing(Course(CAMS[name]))))], size, language)
    return leaf, read_back(leaf)


def by_formulas(cam: Cam) -> PressureView:
    own, turned, stations = sizes(cam), np.linspace(0, cam.turn, 721), positions(cam)
    angles = [np.degrees(pressure(cam, own, one)) for one in (turned, stations)]
    return PressureView(cam, limits_of(cam), turned, angles[0], stations, angles[1], greatest(cam, own))


@pytest.mark.parametrize("name", first([one for one in CAMS if not one.startswith("flat")]))
def test_points_of_the_diagram_lie_where_formulas_put_them(name: str) -> None:
    """D = -S' + iS from A, mirrored where the cam turns clockwise; of a rocker (1 - ψ') of its arm from O1."""
    cam, (_, measured) = CAMS[name], diagram(name)
    own, at = sizes(cam), travel(cam, positions(cam))
    if cam.rocks:
        arm = cam.rising * (cam.follower.length or 0) * np.exp(1j * cam.rising * (at.s - cam.lift / 2))
        true, centre = arm * (1 - cam.follower.sense * at.slope), -own.pivot
    else:
        level = math.sqrt(own.base**2 - own.offset**2)
        true, centre = 1j * at.s - cam.sense * at.slope, complex(-cam.sense * own.offset, -level)
    found = {one.position: one for one in measured.points if one.name == "D"}
    assert len(found) > len(true) / 2
    for k, one in found.items():
        assert abs(one.value - true[k]) <= PAPER * one.scale
    (own_centre,) = (one for one in measured.points if one.name == "O")
    assert abs(own_centre.value - centre) <= PAPER * own_centre.scale


@pytest.mark.parametrize("name", first(CAMS))
def test_the_least_radius_is_as_long_as_it_is(name: str) -> None:
    cam, (_, measured) = CAMS[name], diagram(name)
    lengths = {one.name: one.value for one in measured.vectors}
    if name != "flat":
        assert abs(lengths["R_0"]) == pytest.approx(sizes(cam).base, rel=1e-5)
    if cam.rocks:
        assert lengths["L"] == pytest.approx(sizes(cam).pivot, rel=1e-5)


@pytest.mark.parametrize(
    "case", first([(name, size, tongue) for size, tongue in (("A4", "ru"), ("A1", "en")) for name in CAMS])
)
def test_letters_of_the_diagram_are_clear_of_all_lines(case: tuple[str, str, str]) -> None:
    leaf, _ = diagram(*case)
    assert collisions(leaf) == []
    assert list(unlettered(leaf)) == []


@pytest.mark.parametrize("name", first(CAMS))
def test_the_graph_shows_the_pressure_angle_and_its_extremes(name: str) -> None:
    view = by_formulas(CAMS[name])
    leaf = exhibited([(pressure_graph, view)], "A3", "ru")
    measured = read_back(leaf)
    assert collisions(leaf) == []
    assert list(unlettered(leaf)) == []
    found = {(one.name, one.position): one.value for one in measured.vectors}
    for k, angle in enumerate(view.ordinates.tolist()):
        assert found.get((str(k), k), 1j * angle) == pytest.approx(1j * angle, abs=1e-3)
    for kind, one in view.extremes.items():
        if kind != DWELL and one.value:
            assert found[kind, None] == pytest.approx(1j * math.degrees(one.value), abs=1e-3)


def test_the_view_of_the_construction_is_that_of_the_formulas() -> None:
    drawing = CamDrawing(rocking())
    found, true = pressure_view(drawing.sizing.limits, drawing.curve, drawing.found), by_formulas(rocking())
    assert found.ordinates == pytest.approx(true.ordinates, abs=1e-9)
    assert {kind: one.value for kind, one in found.marked} == pytest.approx(
        {kind: one.value for kind, one in true.marked}, abs=1e-12
    )
    assert found.span == pytest.approx(true.span)


@pytest.mark.parametrize("name", first([one for one in CAMS if one != "flat"]))
def test_the_graph_stands_under_the_diagrams_of_the_law_over_one_axis(name: str) -> None:
    drawing = CamDrawing(CAMS[name])
    view = pressure_view(drawing.sizing.limits, drawing.curve, drawing.found)
    leaf = exhibited([(cam_column, (drawing.diagrams, view))], "A2", "ru")
    vectors = read_back(leaf).vectors
    assert collisions(leaf) == []
    assert list(unlettered(leaf)) == []
    law = {one.name: one.start.real for one in vectors if one.plan == f"law-{CAMS[name].name}-velocity"}
    angle = {
        one.name: one.start.real for one in vectors if one.plan == pressure_graph.NAME and one.position is not None
    }
    shared = law.keys() & angle.keys()
    assert len(shared) > 2
    assert {k: angle[k] for k in shared} == pytest.approx({k: law[k] for k in shared}, abs=1e-3)
