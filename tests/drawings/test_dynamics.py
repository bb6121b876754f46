"""The dynamics sheet: its plates, the flywheel's sketch, speeds by energies."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from drawings.checks.readers import frames
from drawings.commands.explain import explained
from drawings.dynamics import graphs
from drawings.dynamics.due import expected
from drawings.dynamics.due_graphs import INERTIA, SURPLUS, WORKS, AnalysedTurn
from drawings.dynamics.flywheel_sketch import Outlines
from drawings.dynamics.report import chapters, notes_of
from drawings.dynamics.sheet import MachineMotion, leaves, positions, results, sheets
from drawings.grading.curves.dynamics_figures import TurnCourses, speeds_before
from drawings.page.page import drafting_of
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Kind, Line, Polyline
from drawings.paper.walk import groups, texts, walk
from drawings.symbols.symbols import hatching
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.study import DynamicsStudy
from plans.model.dynamics import ANALYSIS, Rim, Speeds, Wheel
from plans.model.motion import Floats
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.dynamics_scenes import text
from tests.plans.scenes import scene
from tests.plans.test_run_table import sized


@cache
def study() -> Study:
    return Study(parse_scene(text(asked='fluctuation = "1/25"\nflywheel = { diameter = 0.9 }')))


def test_rounding_is_not_told_in_digits() -> None:
    """What vanishes but for rounding is 0 in the table, not a number of twenty digits."""
    own = study().comparison("dynamics").exact
    (leaf,) = sheets(study().scene, MachineMotion(study()["dynamics"].task, own, own))
    cells = [one.plain for group in groups(leaf.groups) if group.name == "positions-1" for one in texts((group,))]
    assert len(cells) > 100 and max(map(len, cells)) <= 10


WIDE, THICK = sized(36.70337073, Rim(1.0, 1.2, 7200.0, 1.5)), sized(36.70337073, Rim(1.0, 0.55, 7200.0, 1.5))


@pytest.mark.parametrize("rim", [WIDE, THICK])
def test_the_outline_is_that_of_a_wheel(rim: Wheel) -> None:
    """Bore within hub, hub within rim; the half of the cut has the rim's full section at its top."""
    wheel = Outlines(rim)
    assert 0 < wheel.bore < wheel.hub < wheel.inner < wheel.outer
    top = [corner for corner in wheel.half if corner.imag == wheel.outer]
    assert sorted(corner.real for corner in top) == pytest.approx([-rim.breadth / 2, rim.breadth / 2])
    assert wheel.outer - wheel.inner == pytest.approx(rim.thickness)


def test_hatching_is_as_long_as_the_area_asks() -> None:
    """Lines at 45 degrees, a step apart: their length times the step is about the area within."""
    hand = hand_of("A1")
    outline = [complex(*xy) for xy in ((0, 0), (40, 0), (40, 10), (25, 10), (25, 30), (40, 30), (40, 40), (0, 40))]
    lines = list(hatching(outline, hand))
    assert {round(math.degrees(cmath.phase(line.end - line.start))) for line in lines} == {45}
    assert sum(abs(line.end - line.start) for line in lines) * 2.0 == pytest.approx(1300.0, rel=0.01)
    assert not any(mid.real > 25 and 10 < mid.imag < 30 for mid in ((line.start + line.end) / 2 for line in lines))


TURNED = np.linspace(0.0, 2 * np.pi, 73)
MASSES = 1.0 + 0.4 * np.cos(2 * TURNED)  # kg*m2


def swinging(delta: float) -> tuple[Speeds, Floats]:
    """Give a motion of mean speed 1 rad/s that swings by delta, and the surplus energy that it is of."""
    omega = 1.0 + delta / 2 * np.sin(TURNED)
    kinetic = MASSES * omega**2 / 2
    growth = np.zeros((len(TURNED) - 1, 2))
    extremes = float(omega.min()), float(omega.max())
    return Speeds(ANALYSIS, TURNED, omega, growth, extremes, MASSES[0], kinetic[0]), kinetic - kinetic[0]


def drawn_on(true: Speeds, surplus: Floats) -> Floats:
    own = {SURPLUS: np.asarray(1j * surplus), INERTIA: (MASSES - true.inertia).astype(np.complex128)}
    return speeds_before(true, own).imag


@pytest.mark.parametrize("delta", [0.1, 1.0, 1.5, 1.9])
def test_speeds_follow_from_the_energies_that_are_drawn(delta: float) -> None:
    true, surplus = swinging(delta)
    assert drawn_on(true, surplus) == pytest.approx(true.omega, rel=1e-9)
    other = drawn_on(true, 0.98 * surplus)
    assert (other.min() + other.max()) / 2 == pytest.approx(1.0, rel=1e-9)
    kinetic = MASSES * other**2 / 2
    assert kinetic - kinetic[0] == pytest.approx(0.98 * surplus, abs=1e-9)
    true, surplus = swinging(1.9)  # at three times whose energies the machine would stop: nothing follows
    assert np.isnan(drawn_on(true, 3 * surplus)).all()


def test_the_difference_of_a_segment_is_told_of_both() -> None:
    """A tangent that goes all but through o1 cuts off next to nothing: a share of that would say nothing."""
    account = study().comparison("dynamics").exact
    drawn = replace(account, flywheel=replace(account.flywheel, cuts=(-2e-9, 20.1)))
    exact = replace(account, flywheel=replace(account.flywheel, cuts=(-1e-9, 20.0)))
    lines = results(drawn, exact, None, drafting_of(study().scene)).lines
    found = {line.name: line.cells[-1] for line in lines}
    assert (found["o_1k·μ_T, J"], found["o_1l·μ_T, J"]) == ("0.500", "0.000")


PRESS = Path(__file__).parents[1] / "cases/dynamics/press-touched-between-positions.toml"


@pytest.mark.parametrize("asked", [25, 5, 60])
def test_tangents_touch_the_loop_that_is_drawn(asked: int) -> None:
    """No point of the drawn loop is beyond a tangent, and the speed that follows from it fluctuates as asked."""
    own = Study(parse_scene(PRESS.read_text(encoding="utf-8").replace("1/25", f"1/{asked}")))["dynamics"].account
    dense = graphs.dense(own.cycle)
    energy = own.cycle.driving * dense.turned + dense.work
    (low, high), (below, above) = own.flywheel.slopes, own.flywheel.cuts
    over, under = energy - high * dense.varying - above, below - energy + low * dense.varying
    tall = np.ptp(energy)
    assert all(-1e-3 * tall <= beyond.max() <= 1e-9 * tall for beyond in (over, under))
    assert not {touch.turned for touch in own.flywheel.touches} & set(own.cycle.turned)
    speeds = graphs.omega(own.cycle, dense, own.speeds)
    mean, delta = 90 * math.pi / 30, 1 / asked
    assert (speeds.min(), speeds.max()) == pytest.approx((mean * (1 - delta / 2), mean * (1 + delta / 2)), rel=1e-4)
    assert speeds.max() <= own.speeds.extremes[1] * (1 + 1e-12) and speeds.min() >= own.speeds.extremes[0] * (1 - 1e-12)


@pytest.mark.parametrize("paper", ["A1", "A2", "A3"])
def test_the_loop_stands_in_projection_on_every_format(paper: str) -> None:
    """The loop is level with the surplus energy, and right under the inertia; no set has more sheets than it needs."""
    study = Study(parse_scene(PRESS.read_text(encoding="utf-8").replace('"A1"', f'"{paper}"')))
    drawn = leaves(study)
    assert len(drawn) == {"A1": 1, "A2": 2, "A3": 3}[paper]
    (own,) = [found for leaf in drawn if "loop" in (found := {place[0]: row for place, row in frames(leaf).items()})]
    assert own["loop"].zero.imag == pytest.approx(own["surplus"].zero.imag, abs=1e-6)
    assert own["loop"].zero.real == pytest.approx(own["inertia"].zero.real, abs=1e-6)
    assert own["loop"].zero.real > own["surplus"].zero.real and own["loop"].zero.imag < own["inertia"].zero.imag


def test_a_following_sheet_is_filled_and_no_column_is_empty() -> None:
    """What does not stand beside the plate goes on together: the values with the flywheel; of no speed none is told."""
    first, second = leaves(Study(parse_scene(PRESS.read_text(encoding="utf-8").replace('"A1"', '"A2"'))))
    told = [{group.name for group in groups(leaf.groups)} for leaf in (first, second)]
    assert "positions-1" in told[1] - told[0] and "flywheel_sketch" in told[1] - told[0]
    own = study()["dynamics"]
    lines = positions(own.task, replace(own.account, speeds=None), drafting_of(study().scene)).lines
    assert all(len(line.cells) == 5 for line in lines) and any("−0" in line.name for line in lines)


@pytest.mark.parametrize(("places", "size"), [("0.85, 0.87, 0.95, 0.96", "9e3, 9e3, 0"), ("0.5, 0.7, 0.72", "700, 0")])
def test_of_a_blow_neither_moments_nor_works_take_all_the_room(places: str, size: str) -> None:
    """The moment of a blow is high and its work low: 8 mm at least of either, by a pole 16 to 41 mm from the axis."""
    blow = f"diagram = {{ travel = [0, {places}, 1], force = [0, 0, {size}, 0] }}"
    own = Study(parse_scene(text(scene(forces=[f'on = 3; point = "B"; against = "motion"; {blow}']))))
    cycle = own["dynamics"].cycle
    (found,) = [{place[0]: frame for place, frame in frames(leaf).items()} for leaf in leaves(own)]
    high, low = np.ptp(cycle.moments) / found["moments"].up, np.ptp(cycle.work) / found["works"].up
    assert high > low > 8.0
    assert np.ptp(cycle.work) / found["surplus"].up < 4 * low  # the loop does not take it all either
    pole = found["works"].up / (found["moments"].up * found["moments"].across)
    assert 15.9 < pole < 41.1


def test_a_jump_is_dashed_and_no_part_of_the_curve() -> None:
    """The curve of a moment that jumps ends on either side; between is a dashed line, with no ordinate over it."""
    cycle = study()["dynamics"].cycle
    jumps = {cycle.turned[k] for k in graphs.strips(cycle, 24).jumps}
    assert len(jumps) == 2
    (own,) = [found for leaf in leaves(study()) for found in groups(leaf.groups) if found.name == "moments"]
    lines = [line for line in walk(own.strokes) if isinstance(line, Line) and line.start.real == line.end.real]
    dashed = [line.start.real for line in lines if line.style.dash]
    assert len(dashed) == len(jumps)
    # The solid lines there are the ticks of the axis.
    assert max(abs(line.end - line.start) for line in lines if line.start.real in dashed and not line.style.dash) < 3.0
    for curve in (line for line in walk(own.strokes) if isinstance(line, Polyline)):
        assert all(abs(other - one) < 0.1 for one, other in pairwise(curve.points) if one.real == other.real)


@pytest.mark.parametrize("law", ["value = 3200", 'value = 3200; during = "idle stroke"'])
def test_a_load_has_its_diagram_and_is_told_too(law: str) -> None:
    laid = leaves(Study(parse_scene(text(scene(forces=[f'on = 3; point = "B"; against = "motion"; {law}'])))))
    said = " ".join(one.plain for leaf in laid for one in texts(leaf.groups)).replace("\N{NO-BREAK SPACE}", " ")
    assert "3200 N against the motion of B" in said
    assert "Weights are not counted" in said
    assert "load_diagram-F_us" in {group.name for leaf in laid for group in groups(leaf.groups)}


@pytest.mark.parametrize("forces", [False, True])
def test_masses_and_their_centres_are_told_where_no_force_sheet_of_the_set_tells_them(forces: bool) -> None:
    laid = leaves(machine := Study(parse_scene(text().replace('["dyn', '["forces", "dyn' if forces else '["dyn'))))
    told = [*chapters(machine, {"dynamics": laid}).subject, *(one.plain for leaf in laid for one in texts(leaf.groups))]
    words = "lAB", "JS2", "AB: S2 (150; 0)", "S at (0.15; 0) m"
    assert [word in " ".join(told) for word in words] == [not forces] * 4


@pytest.mark.parametrize(
    ("motor", "told", "falls"),
    [
        ('starting = "2 kN*m", synchronous = "123 rpm"', "2000 N·m at rest, in a straight line to 0 at 123 rpm", True),
        ('breakdown = 900, slip = 0.2, synchronous = "123 rpm"', "at most 900 N·m at the slip 0.2, 0 at 123 rpm", True),
        ('speeds = [0, "60 rpm", "123 rpm"], moments = [900, 800, 0]', "900; 800; 0 N·m at 0; 60; 123 rpm", True),
        ("moment = 60", "60 N·m at every speed", False),
    ],
)
def test_a_motor_is_given_with_its_rotor_and_the_brake_and_the_drive_that_is_even_is_told(
    motor: str, told: str, falls: bool
) -> None:
    asked = f'motor = {{ rotor = 0.4, {motor} }}\nrun = {{ brake = "0.15 kN*m", turns = 1 }}\n'
    laid = leaves(machine := Study(parse_scene(text(asked=asked + "shafts = [{ inertia = 2 }]"))))
    said = " ".join(one.plain for leaf in laid for one in texts(leaf.groups))
    for words in (f"Motor: {told}".replace("Motor: at most", "Motor by Kloss: at most"), "0.4 kg", "Brake: 150 N·m"):
        assert words in said and words in " ".join(notes_of(machine).asked())
    assert ("Mdr = const" in said) == falls


@pytest.mark.parametrize(("said", "doubted"), [("", True), ("useful = false", False)])
def test_loads_that_drive_are_doubted_unless_they_are_those_of_an_engine(said: str, doubted: bool) -> None:
    gas = f'on = 3; point = "B"; value = 900; direction = 180; during = "working stroke"; {said}'
    machine = Study(parse_scene(text(scene(forces=[gas]))))
    assert bool([*notes_of(machine).directed()]) == doubted


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", ("by a constant Mus = 28.73", "Mdr falls to 0 N", "Δφ, ° Mdr, N·m Adr, J ΔT")),
        ("ru", ("при постоянном Mп.с = 28,73", "Mдв падает до 0 Н", "Δφ, ° Mдв, Н·м Aдв, Дж ΔT")),
    ],
)
def test_what_an_engine_drives_is_a_constant_resistance(language: str, words: tuple[str, ...]) -> None:
    """900 N give 180 J over a stroke of 0.2 m, drawn upwards as a drive's; half way it has 900 N of 0.1 m."""
    gas = scene(forces=['on = 3; point = "B"; value = 900; direction = 180; during = "working stroke"; useful = false'])
    machine = Study(parse_scene(text(gas) + f'[sheet]\nlanguage = "{language}"\n'))
    laid = leaves(machine)
    said = " ".join(one.plain for leaf in laid for one in texts(leaf.groups)).replace("\N{NO-BREAK SPACE}", " ")
    assert [one for one in words if one not in said] == []
    curves = {one.name: one.value for one in expected(machine, laid) if one.kind is Kind.CURVE}
    stated = {group.states.name for leaf in laid for group in groups(leaf.groups) if group.states}
    assert {"M_{dr}", "M_{us}", "A_{dr}", "A_{us}"} <= stated & {*curves}
    for name, at, value in ("M_{dr}", math.pi / 2, 90), ("A_{us}", math.tau, 180):
        assert curves[name](np.array([at])) == pytest.approx(value, rel=5e-3)
    turn = TurnCourses(AnalysedTurn(machine.of(DynamicsStudy).task, machine.of(DynamicsComparison).analysis))
    for name, course in (WORKS, turn.works), (SURPLUS, turn.surplus):
        assert course(turn.true) == pytest.approx(turn.true[name], abs=1e-9)
    for mark, value in ("M_dr", "M_dr = 90 "), ("M_us", "M_us = 28.7"), ("A_dr(2π)", "A_dr(2π) = 180.5"):
        noted = " ".join(map(str, explained(machine, 6, mark).notes))
        assert value in noted


REDUCED = text(scene(forces=['on = 3; point = "B"; value = 1200; direction = 0']), asked="reduction = true")


@pytest.mark.parametrize(
    ("figure", "position", "size"),
    [
        ("moments", 6, -120.0),  # the rod does not turn: the piston is as fast as the crank's end, 1200 N of 0.1 m
        ("moments", 18, 120.0),
        ("inertia", 6, 0.0148 + 12 * 0.1**2),  # the crank's about O, and rod and piston in its end
        ("inertia", 0, 0.0148 + (0.06 + 4 * 0.25**2) / 16),  # the rod turns about B a quarter as fast
    ],
)
def test_the_reduction_alone_has_its_graphs(figure: str, position: int, size: float) -> None:
    study = Study(parse_scene(REDUCED))
    (leaf,) = leaves(study)
    rows = {(one.figure, one.name): one.value for one in expected(study, (leaf,)) if one.kind is Kind.VECTOR}
    drawn = [group.data for group in groups(leaf.groups) if group.data.get("plan") == figure]
    (found,) = [complex(*map(float, data["value"].split())) for data in drawn if data["name"] == str(position)]
    assert found == pytest.approx(1j * size) and rows[figure, str(position)] == pytest.approx(1j * size)
    said = " ".join(one.plain for one in texts(leaf.groups)).replace("\N{NO-BREAK SPACE}", " ")
    assert "lOA = 100" in said and "m3 = 8" in said and "Δφ, °" in said
