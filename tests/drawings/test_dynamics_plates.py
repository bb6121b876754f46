"""The sheet of a machine's motion: measured back against published values, and what rounding may not tell."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache

import pytest

from drawings.dynamics.graphs import dense, strips
from drawings.dynamics.loop import Loop, Tangent
from drawings.dynamics.sheet import Machine, results, sheets
from drawings.kinds.axes import BEYOND, Axes
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, check, measure
from drawings.measure.measured import MeasuredVector
from drawings.page.scale import Scale, drafting_of
from drawings.paper.strokes import Leaf, Line
from drawings.paper.walk import groups, texts
from drawings.pens.svg import svg
from plans.model.dynamics import TURN
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import first
from tests.plans.dynamics_scenes import text

FLYWHEEL = 'fluctuation = "1/25"\nflywheel = { diameter = 0.9 }'


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


def test_the_difference_of_a_segment_is_told_of_both() -> None:
    """A tangent that goes all but through o1 cuts off next to nothing: a share of that would say nothing."""
    account = study().comparison("dynamics").exact
    drawn = replace(account, flywheel=replace(account.flywheel, cuts=(-2e-9, 20.1)))
    exact = replace(account, flywheel=replace(account.flywheel, cuts=(-1e-9, 20.0)))
    lines = results(drawn, exact, None, drafting_of(study().scene)).lines
    found = {line.name: line.cells[-1] for line in lines}
    assert (found["o_1k·μ_T, J"], found["o_1l·μ_T, J"]) == ("0.500", "0.000")


def test_rounding_is_not_told_in_digits() -> None:
    """What vanishes but for rounding is 0 in the table, not a number of twenty digits."""
    (leaf,) = exact("A1")
    cells = [one.plain for group in groups(leaf.groups) if group.name == "positions-1" for one in texts((group,))]
    assert len(cells) > 100 and max(map(len, cells)) <= 10
