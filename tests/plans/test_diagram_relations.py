"""Kinematic diagrams: of a mechanism turned, mirrored, enlarged, faster; their integrals, gaps inside, numbers."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import degrees, radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.calculus import Derivative
from plans.diagrams.study import ChordCurves, DiagramsStudy
from plans.linkage.study import LinkageStudy
from plans.model.diagrams import Axis, Diagrams, axis_of, chord_error
from plans.model.motion import Floats, Rates
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import examples
from tests.plans.chains import numbers
from tests.plans.pushed_machines import PLAIN, PUSH, Picture, slider
from tests.plans.scenes import scene

# A crank OA with a slider B beside its centre, a rocker CB, and a second crank DB that turns fully.
SLIDER_CRANK = scene(
    frame="O = {O}", links="OA AB B", lengths="OA = {OA}; AB = {AB}",
    slides=["link = 3; along = {{ through = {K}, angle = {guide} }}"], sketch="A = {A}; B = {B}",
)  # fmt: skip
ROCKER = scene(
    frame="O = {O}; C = {C}", links="OA AB CB", lengths="OA = {OA}; AB = {AB}; CB = {CB}", sketch="A = {A}; B = {B}"
)
PLACES = {"O": 0j, "A": 0.1 + 0j}
MECHANISMS: dict[str, tuple[str, dict[str, complex], dict[str, float]]] = {
    "slider": (SLIDER_CRANK, {"K": 0.03 + 0.04j, "B": 0.39 + 0.04j}, {"OA": 0.1, "AB": 0.3}),
    "rocker": (ROCKER, {"C": 0.35 + 0j, "B": 0.3 + 0.29j}, {"OA": 0.1, "AB": 0.4, "CB": 0.3}),
    "drag": (ROCKER, {"A": 0.2 + 0j, "C": 0.05 + 0j, "B": 0.05 + 0.3j}, {"OA": 0.2, "AB": 0.4, "CB": 0.3}),
    # AC is 0.449 m at most: the crank stops at 170.8 degrees on either side.
    "barred": (ROCKER, {"C": 0.35 + 0j, "B": 0.25 + 0.19j}, {"OA": 0.1, "AB": 0.249, "CB": 0.2}),
}
FREE = sorted(MECHANISMS.keys() - {"barred"})
TRUE = 1e-9  # of the largest


def study_of(name: str, picture: Picture = PLAIN, positions: str = "12", rates: tuple[float, float] = (10, 0)) -> Study:
    text, places, lengths = MECHANISMS[name]
    told = {letter: picture.place(at) for letter, at in (PLACES | places).items()}
    told |= {line: picture.length(size) for line, size in lengths.items()}
    mechanism = text.format(**told, guide=picture.angle(1 + 0j))
    omega, epsilon = (picture.sense * rate for rate in rates)
    start = f"start = {picture.angle(1 + 0j)}\n" if not positions.startswith("[") else ""
    drive = f"[drive]\nlink = 1\nspeed = {omega!r}\nacceleration = {epsilon!r}\n{start}positions = {positions}"
    return Study(parse_scene(f'sheets = ["kinematics"]\n{mechanism}{drive}'))


@cache
def plain(name: str) -> Diagrams:
    found: Diagrams = study_of(name, rates=(10, 7))["diagrams"].diagrams
    return found


def rows(found: Diagrams) -> tuple[Floats, ...]:
    """Give the way and the velocities, then the accelerations."""
    return found.at.s, found.at.v, found.speeds, found.true_speeds, found.at.a, found.growths, found.true_growths


def alike(new: Diagrams, old: Diagrams, size: float, rate: float = 1.0) -> None:
    """See that diagrams are those of before, so many times as large and as fast."""
    assert new.axis.turned == pytest.approx(old.axis.turned, abs=1e-12)
    assert new.axis.numbers == old.axis.numbers
    for order, one, other in zip((0, 1, 1, 1, 2, 2, 2), rows(new), rows(old), strict=True):
        due = size * rate**order * other
        assert one == pytest.approx(due, abs=TRUE * float(np.abs(due).max()))


@examples(2, 20)
@given(st.sampled_from(FREE), numbers(-3.1, 3.1), st.booleans(), st.sampled_from((0.3, 1.0, 3.7)))
def test_a_mechanism_turned_mirrored_and_enlarged_has_the_same_diagrams(name, turn, mirrored, size):
    _alike_in(name, Picture(turn, mirrored, size))


@pytest.mark.parametrize(("name", "turn"), [("slider", 2.0), ("rocker", -1.0), ("rocker", -1.5), ("drag", 2.0)])
def test_a_mechanism_mirrored_and_turned_about_has_the_same_diagrams(name: str, turn: float) -> None:
    """The rocker's angle goes beyond 180 degrees in one of them."""
    _alike_in(name, Picture(turn, True, 3.7))


def _alike_in(name: str, picture: Picture) -> None:
    comparison = study_of(name, picture, rates=(10, 7)).comparison("diagrams")
    assert comparison.agrees
    # What is ahead of an even turn is mirrored; a stroke is counted from where it begins.
    size = {"slider": picture.size, "rocker": 1.0, "drag": picture.sense}[name]
    for found in (comparison.construction, comparison.analysis):
        alike(found, plain(name), size)


@pytest.mark.parametrize("name", FREE)
def test_a_faster_crank_stretches_the_diagrams(name: str) -> None:
    alike(study_of(name, rates=(20, 28))["diagrams"].diagrams, plain(name), 1.0, 2.0)


@pytest.mark.parametrize("name", FREE)
def test_v_integrated_is_the_way_and_a_integrated_is_v(name: str) -> None:
    """The chords' exactly; of the plans by Simpson's rule, of 48 parts each, an error of the fourth order."""
    found = study_of(name, positions="48")["diagrams"].diagrams
    axis, times = found.axis, np.diff(found.axis.turned) / 10
    way = np.diff(found.at.s)
    assert found.speeds * times == pytest.approx(way, abs=1e-15)
    apart = np.diff(axis.middles) / 10
    assert found.growths[1:-1] * apart == pytest.approx(np.diff(found.speeds), abs=1e-12)
    simpson = times / 6 * (found.at.v[:-1] + 4 * found.true_speeds + found.at.v[1:])
    assert simpson == pytest.approx(way, abs=2e-6 * float(np.ptp(found.at.s)))
    assert float((found.at.a[:-1] * times).sum()) == pytest.approx(0.0, abs=1e-9 * float(np.abs(found.at.a).max()))


def test_no_chord_spans_a_barrier_between_two_positions() -> None:
    study = study_of("barred", positions="[150, 155, 160, 165, 195, 200, 205, 210]")
    assert not study["linkage"].lost.any()
    for by in ("construction", "analysis"):
        told = study.numbers("diagrams", by).plain()["diagrams"]
        assert [value is None for value in told["ω_chords"]["values"]] == [k == 3 for k in range(7)]
        assert [value is None for value in told["ε_chords"]["values"]] == [k in (0, 3, 4, 7) for k in range(8)]


def _axis(told: list[float], sense: int = 1, lost: tuple[int, ...] = (), barred: tuple[float, ...] = ()) -> Axis:
    gone = np.isin(np.arange(len(told)), lost)
    return axis_of(np.radians(told), sense, gone, [radians(edge) for edge in barred])


@pytest.mark.parametrize(
    ("sense", "lost", "barred", "joined"),
    [
        (1, (), (), [True] * 5),
        (1, (2,), (), [True, False, False, True, True]),
        (1, (), (35.0,), [True, True, False, True, True]),
        (-1, (), (-35.0,), [True, True, False, True, True]),
        (-1, (), (35.0,), [True] * 5),
    ],
)
def test_positions_follow_one_another_but_over_a_gap_or_a_barrier(
    sense: int, lost: tuple[int, ...], barred: tuple[float, ...], joined: list[bool]
) -> None:
    axis = _axis([sense * angle for angle in (10, 20, 30, 40, 50, 60)], sense, lost, barred)
    assert axis.joined.tolist() == joined
    assert np.degrees(axis.turned) == pytest.approx([0, 10, 20, 30, 40, 50])
    assert degrees(axis.start) == pytest.approx(10 * sense)


def test_the_nodes_between_positions_are_even_and_hold_the_positions() -> None:
    (nodes,) = _axis([0, 30, 90]).nodes(8)
    assert np.degrees(nodes) == pytest.approx([0, 7.5, 15, 22.5, 30, 45, 60, 75, 90])


def test_the_error_of_chords_is_a_share_of_the_largest_and_of_equal_ones_the_first_is_told() -> None:
    exact = np.array([0.0, 2.0, -4.0, 2.0, np.nan])
    found = chord_error(exact + np.array([0.0, 0.1, 0.2, -0.2, np.nan]), exact)
    assert found is not None
    assert (found.share, found.at) == (pytest.approx(0.05), 2)
    assert chord_error(exact, exact) is None


@pytest.mark.parametrize("name", FREE)
def test_both_roads_are_compared_as_sharply_as_their_roundings(name: str) -> None:
    comparison = study_of(name).comparison("diagrams")
    letters = "Sva" if name == "slider" else "ψωε"
    told = [f"{letters[k]} {what}" for k in (1, 2) for what in ("chords", "middles")]
    assert [one.name for one in comparison.findings] == [*letters, *told]
    for one in comparison.findings:
        assert np.nanmax(one.allowed) <= TRUE * one.largest


@pytest.mark.parametrize("name", FREE)
@pytest.mark.parametrize("rates", [(10, 7), (-10, 3)])
def test_solve_tells_the_rows_where_they_belong_by_both_roads(name: str, rates: tuple[float, float]) -> None:
    study = study_of(name, rates=rates)
    found, letters = study["diagrams"].diagrams, "Sva" if name == "slider" else "ψωε"
    first, second = (study.numbers("diagrams", by).plain()["diagrams"] for by in ("construction", "analysis"))
    assert first["turned"] == found.axis.turned.tolist()
    chords = ((letters[1], found.axis.middles, found.speeds), (letters[2], found.axis.places, found.growths))
    for letter, turned, values in chords:
        assert first[f"{letter}_chords"] == {"turned": turned.tolist(), "values": values.tolist()}
        assert second[f"{letter}_chords"]["values"] == pytest.approx(values.tolist(), rel=1e-7, abs=1e-9)
    for letter in letters:
        assert second[letter] == pytest.approx(first[letter], rel=1e-7, abs=1e-9)


def test_the_way_is_counted_from_where_its_note_says() -> None:
    counted = {name: study_of(name)["diagrams"].counted for name in MECHANISMS}
    assert counted == {"slider": "working", "rocker": "working", "drag": "ahead", "barred": "least"}


def test_a_crank_that_is_not_even_and_a_drive_over_a_stroke_have_none() -> None:
    linkage = study_of("slider")["linkage"]

    def pace(phi: Floats) -> Rates:
        return Rates(10 + np.sin(phi), 0.0 * phi)

    uneven = DiagramsStudy(linkage.paced(pace), True)
    assert isinstance(uneven.linkage, LinkageStudy)
    assert str(uneven.left_out) == "the crank does not rotate uniformly, so that no one scale of time holds"
    pushed = DiagramsStudy(slider(stroke=PUSH)["linkage"], True)
    assert pushed.left_out is not None
    assert pushed.diagrams is None


def test_chords_that_are_out_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    true = ChordCurves._growth

    def off(self: ChordCurves, k: int, run: slice) -> Derivative | None:
        return true(replace(self, omega=self.omega * (1 + 1e-6)), k, run)

    monkeypatch.setattr(ChordCurves, "_growth", off)
    comparison = study_of("slider").comparison("diagrams")
    assert [one.name for one in comparison.findings if np.nanmax(one.excess) > 1] == ["a chords"]
