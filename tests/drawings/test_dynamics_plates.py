"""The sheet of a machine's motion: measured back against published values, its figures in line, readable, few."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache

import pytest

from drawings.figures.dynamics.curves import dense
from drawings.figures.dynamics.loop import Loop, Tangent
from drawings.figures.dynamics.rays import MARKED, strips
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, check, measure
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import drafting_of
from drawings.page.scale import Scale
from drawings.paper.strokes import Circle, Group, Leaf, Line, Text
from drawings.paper.walk import groups, texts, walk
from drawings.pens.svg import svg
from drawings.sheets.dynamics import Machine, leaves, sheets
from plans.model.dynamics import TURN
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.collisions import collisions
from tests.drawings.held import faults_on
from tests.parts import first
from tests.plans.dynamics_scenes import text

FLYWHEEL = 'fluctuation = "1/25"\nflywheel = { diameter = 0.9 }'
GRAPHS = ("works", "surplus", "speeds")


@cache
def study(paper: str = "A1", language: str = "en", asked: str = FLYWHEEL, standard: str = "GOST") -> Study:
    sheet = f'[sheet]\nformat = "{paper}"\nlanguage = "{language}"\nstandard = "{standard}"\n'
    return Study(parse_scene(text(asked=asked) + sheet))


@cache
def exact(paper: str) -> tuple[Leaf, ...]:
    """Lay out the exact motion of the machine of M4.9, without the error of the strips."""
    own = study(paper)
    found = own.comparison("dynamics").exact
    return sheets(own.scene, Machine(own["dynamics"].task, found, found))


def measured(leaf: Leaf) -> Measured:
    found = measure(svg(lettered(leaf)))
    assert check(found) == []
    return found


def vectors(paper: str) -> dict[tuple[str, str], MeasuredVector]:
    return {(one.plan, one.name): one for leaf in exact(paper) for one in measured(leaf).vectors}


@pytest.mark.rest
@pytest.mark.parametrize("paper", first(["A1", "A3"]))
def test_published_segments_are_measured_back(paper: str) -> None:
    """M4.9: o1k and o1l in mm of 4 J, to what the written coordinates resolve."""
    found = vectors(paper)
    for name, length in (("o1k", 5.316480454), ("o1l", -52.69712643)):
        one = found["loop", name]
        assert abs(one.value - 4j * length) <= 2e-4 * one.scale


@pytest.mark.parametrize("paper", first(["A1", "A3"]))
def test_published_angles_are_measured_back(paper: str) -> None:
    """M4.9: the angles are those of scales of 4 J/mm and 0.0025 kg*m2/mm."""
    found = vectors(paper)
    scales = next(" ".join(texts_of(leaf, "loop")) for leaf in exact(paper) if texts_of(leaf, "loop"))
    energy, inertia = (float(re.search(rf"μ{letter} = ([\d.]+)", scales)[1]) for letter in "TJ")
    for name, angle in (("ψmax", 2.939081068), ("ψmin", 2.713436623)):
        along = found["loop", name].value
        slope = math.tan(math.radians(angle)) * (4 / 0.0025) * inertia / energy
        assert along.imag / along.real == pytest.approx(slope, abs=3e-4 / abs(along))


def texts_of(leaf: Leaf, name: str) -> list[str]:
    return [one.plain for group in groups(leaf.groups) if group.name == name for one in texts((group,))]


def test_a_tangent_that_touches_the_end_of_the_turn_touches_its_beginning() -> None:
    """Both are one point of the loop: rounding alone decides which of them is touched first."""
    own = study()["dynamics"]
    wheel = own.account.flywheel
    ends = tuple(one._replace(turned=TURN) for one in wheel.touches)
    shown = Loop(own.cycle, dense(own.cycle), strips(own.cycle, 24), replace(wheel, touches=ends))
    assert shown.touches == (0, 0)
    found = replace(own.account, flywheel=shown.flywheel)
    assert sheets(study().scene, Machine(own.task, found, found))


@pytest.mark.parametrize("steep", [0.1, 0.4, 2.0, 20.0])
def test_a_tangent_with_its_angle_ends_below_the_title_of_its_loop(steep: float) -> None:
    own = study()["dynamics"]
    wheel = own.account.flywheel
    inertia = Scale(steep / wheel.slopes[1], "J", "kg*m2")
    shown = Tangent(
        (0.0, 60 * inertia.mu), 30.0, wheel, Axes(0j, inertia, Scale(1.0, "T", "J")), drafting_of(study().scene).hand, 1
    )
    assert shown.slope == pytest.approx(steep)
    ends = [one.end for one in shown.lines if isinstance(one, Line)]
    assert max(end.imag for end in ends) <= 30 + BEYOND + 1e-9
    assert shown.end.imag >= 30 - 1e-9 or shown.end.real >= 60


def test_graphs_stand_over_one_angle() -> None:
    found = vectors("A1")
    for k in ("3", "7", "9"):
        across = {found[name, k].start.real for name in GRAPHS}
        assert max(across) - min(across) <= 2e-4
    assert found["moments", "5"].start.real == pytest.approx(found["works", "5"].start.real, abs=2e-4)


def test_the_loop_stands_in_line_with_energy_and_inertia() -> None:
    """Its points are level with those of the surplus energy, and under those of the turned inertia."""
    (leaf,) = exact("A1")
    points = {one.name: one.at for one in measured(leaf).points if one.plan == "loop"}
    found = vectors("A1")
    for k in ("4", "8", "16"):
        assert points[k].imag == pytest.approx(found["surplus", k].end.imag, abs=2e-4)
        assert points[k].real == pytest.approx(found["inertia", k].end.real, abs=2e-4)


def test_ordinates_are_the_works_and_moments_of_the_load() -> None:
    """Of 2000 N over S = H - (0.1 + 0.4) + x in the turn of the crank, where it acts; M_us is 2000 times dS/dphi."""
    found = vectors("A1")
    rod = math.sqrt(0.4**2 - 0.1**2)
    assert found["moments", "6"].value.imag == pytest.approx(200.0, abs=2e-4 * found["moments", "6"].scale)
    start = 0.5 - 0.05 * 0.2
    one = found["works", "6"]
    assert one.value.imag == pytest.approx(2000 * (start - rod), abs=2e-4 * one.scale)
    surplus = found["surplus", "6"]
    assert surplus.value.imag == pytest.approx(-115.4033308, abs=2e-4 * surplus.scale)  # as M4.9 prints it


@pytest.mark.parametrize("paper", ["A1", "A3"])
def test_the_pole_distance_joins_both_scales(paper: str) -> None:
    """The scale of works is mu_M times mu_phi times H_p (M2.3)."""
    leaf = next(leaf for leaf in exact(paper) if texts_of(leaf, "moments"))
    told = {
        letter: float(value)
        for name in ("moments", "works")
        for one in texts_of(leaf, name)
        for letter, value in re.findall(r"(μ.|Hp) = ([\d.]+)", one)
    }
    assert told["μA"] == pytest.approx(told["μM"] * told["μφ"] * told["Hp"], rel=1e-3)


CASES = [("A1", "en", 1), ("A1", "ru", 1), ("A2", "ru", 2), ("A3", "en", 2), ("A3", "ru", 2)]


@pytest.mark.rest
@pytest.mark.parametrize("case", first(CASES))
def test_sheets_are_few_and_no_letter_touches_a_line(case: tuple[str, str, int]) -> None:
    paper, language, count = case
    own = study(paper, language)
    found = leaves(own)
    assert len(found) == count
    assert [one for leaf in found for one in collisions(lettered(leaf))] == []
    assert faults_on(own, "dynamics", found) == []


MACHINES = [
    ("divisions = 12", set(), set()),  # the reduction and the works alone
    ('fluctuation = "1/5"\nshafts = [{ inertia = 80 }]', {"ψmax", "o1k"}, {"needs no flywheel"}),
    ('fluctuation = "1/500"\ndivisions = 360', {"ψmin", "o1l"}, set()),
    ('fluctuation = "1/25"\nmotor = { rotor = 0.02, ratio = 10 }', {"ψmin"}, {"without the flywheel"}),
]


@pytest.mark.rest
@pytest.mark.parametrize("machine", first(MACHINES))
def test_machines_of_every_kind_are_drawn(machine: tuple[str, set[str], set[str]]) -> None:
    asked, names, words = machine
    own = study("A3", asked=asked)
    found = leaves(own)
    seen = {one.name for leaf in found for one in measured(leaf).vectors if one.plan == "loop"}
    assert names <= seen and bool(seen) == bool(names)
    told = " ".join(one.plain for leaf in found for one in texts(leaf.groups))
    assert all(word in told for word in words)
    assert faults_on(own, "dynamics", found) == []


@pytest.mark.rest
def test_many_strips_are_not_marked_one_by_one() -> None:
    """A thousand strips would be a grey bar: numbered ones alone have points."""
    found = leaves(study("A1", asked='fluctuation = "1/25"\ndivisions = 1000'))
    dots = [one for leaf in found for one in walk(leaf.groups) if isinstance(one, Circle)]
    assert len(dots) < 5 * MARKED
    assert all(isinstance(group, Group) for leaf in found for group in leaf.groups)
    assert any(isinstance(one, Text) and one.plain == "1000" for leaf in found for one in walk(leaf.groups))


@pytest.mark.rest
def test_a_run_has_its_tachogram() -> None:
    """The speed at the end of each stage, as the table of the run has it; at rest there is no ordinate."""
    motor = 'motor = { rotor = 0.02, ratio = 10, starting = "60 N*m", synchronous = "1250 rpm" }'
    own = study("A3", asked=f'{FLYWHEEL}\n{motor}\nrun = {{ brake = "100 N*m" }}')
    found = {one.name: one for leaf in leaves(own) for one in measured(leaf).vectors if one.plan == "tachogram"}
    run = own["dynamics"].run
    due = {f"t_{k + 1}": float(run.omega[stage.last]) for k, stage in enumerate(run.stages)}
    assert len(due) == 3 and found.keys() == {name for name, omega in due.items() if omega > 1e-3}
    for name, one in found.items():
        assert one.value.imag == pytest.approx(due[name], abs=2e-4 * one.scale)


def test_rounding_is_not_told_in_digits() -> None:
    """What vanishes but for rounding is 0 in the table, not a number of twenty digits."""
    (leaf,) = exact("A1")
    cells = [one.plain for group in groups(leaf.groups) if group.name == "positions-1" for one in texts((group,))]
    assert len(cells) > 100 and max(map(len, cells)) <= 10


ODD = [
    ('speed = "1500 rpm"\npositions = 24', "A1"),  # steep tangents
    ('speed = "120 rpm"\npositions = 24\nstart = 70', "A1"),  # the inertia falls: the loop stands left of its axis
    ('speed = "-120 rpm"\npositions = 24', "A3"),
]


@pytest.mark.rest
@pytest.mark.parametrize("odd", first(ODD))
def test_tangents_stay_among_their_figures(odd: tuple[str, str]) -> None:
    drive, paper = odd
    scene = text(asked='fluctuation = "1/25"').replace('speed = "120 rpm"\npositions = 24', drive)
    own = Study(parse_scene(f'{scene}[sheet]\nformat = "{paper}"\n'))
    for leaf in leaves(own):
        assert collisions(lettered(leaf)) == []
    assert faults_on(own, "dynamics", leaves(own)) == []
