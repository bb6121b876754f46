"""A machine's motion by analysis: worked values of the method digest, to all printed digits (M4.2-M4.12, theme 7)."""

from __future__ import annotations

import cmath
from functools import cache
from math import atan, degrees, pi, radians

import numpy as np
import pytest

from plans.analytic.dynamics.flywheel import (
    Exact,
    book_slopes,
    exact,
    flywheel,
    methods,
    speed_slopes,
    wheel,
)
from plans.analytic.dynamics.reduction import Reduction, reduced
from plans.analytic.dynamics.speeds import Swing, steady, with_flywheel
from plans.analytic.kinematics import Analysis
from plans.model.dynamics import Flywheel, Rim, Shaft, Task
from plans.model.kinetostatics import Applied, Loading
from plans.model.machine import Body, Diagram, Force, Machine
from plans.model.motion import Motion
from tests.plans import linkages
from tests.plans.steady_machines import BODIES, DELTA, SPEED, Steady, edges, machine, worked

PUSHED = Force("F", 3, "B", 0j, 1200.0, 1 + 0j)  # of M4.4
SIXTY = radians(60)


def ten(value: float) -> float:
    """Expect a value to ten significant digits."""
    return pytest.approx(value, rel=5e-10)


def at(machinery: Machine, phi: float = SIXTY):
    """Reduce the linkage of M4.2 with some masses and loads at one crank angle."""
    one = Steady(linkages.slider_crank(0.1, 0.4), machinery, phi)
    return reduced(one.reduction, np.array([phi]))


@cache
def planer() -> Exact:
    return worked().exact


@cache
def its_flywheel() -> Flywheel:
    return flywheel(planer(), TASK)


TASK = Task(SPEED, DELTA, 24)


@pytest.mark.parametrize(
    ("body", "term"),
    [
        (BODIES[1], 0.0148),
        (BODIES[2]._replace(inertia=0.0), 0.03685623963),
        (BODIES[2]._replace(mass=0.0), 0.0009836065574),
        (BODIES[3], 0.07634803215),
    ],
)
def test_each_mass_of_the_slider_crank_reduced(body: Body, term: float) -> None:
    """M4.2: the terms of formula (6.3) at 60 degrees."""
    assert at(machine(bodies={body.link: body})).inertia[0] == ten(term)


def test_all_masses_reduced_and_the_slope_of_their_inertia() -> None:
    found = at(machine())
    assert found.inertia[0] == ten(0.1289878783)
    assert found.slope[0] == ten(0.07465262898)


def test_the_machine_unit_reduced() -> None:
    """M4.3: rotor and carrier beside the linkage (6.5)."""
    task = Task(1.0, None, 24, (Shaft("rotor", 0.05, 5.6 * 2.5), Shaft("H", 0.40, -2.5)))
    assert at(machine()).inertia[0] + task.present == ten(12.42898788)


def test_a_load_and_a_weight_reduced() -> None:
    """M4.4: by their power; the weight is that of the rod alone."""
    found = at(machine(PUSHED, bodies={2: BODIES[2]}, gravity=-9.81j))
    assert found.moment[0] == ten(-118.4552813)


def test_task_of_theme_7_slider_crank() -> None:
    """Task 2: crank at 60 degrees, the rod at 30 to the way of the slider, which alone has a mass."""
    rod = 0.1 * np.sin(SIXTY) / np.sin(radians(30))
    one = Steady(linkages.slider_crank(0.1, rod), machine(bodies={3: Body(3, 50.0, 0.0, 0j)}), SIXTY)
    assert reduced(one.reduction, np.array([SIXTY])).inertia[0] == ten(0.6666666667)


def test_task_of_theme_7_four_bar() -> None:
    """Task 3: angles OAB = 90 and ABC = 60, BC twice OA, the rocker alone has inertia."""
    A, B = 0.1j, 0.3 + 0.1j
    C = B + 0.2 * cmath.exp(1j * radians(240))
    turn = abs(C) / C
    sketch = {"A": A * turn, "B": B * turn}
    linkage = linkages.four_bar(0.1, 0.3, 0.2, abs(C), sketch=sketch, omega=1.0, epsilon=0.0)
    phi = cmath.phase(A * turn)
    one = Steady(linkage, machine(bodies={3: Body(3, 0.0, 2.0, 0j)}), phi)
    motion = Reduction(Analysis(linkage), one.machine, lambda _: Loading((), ()), phi)
    assert reduced(motion, np.array([phi])).inertia[0] == ten(0.6666666667)


def test_task_of_theme_7_planetary_gear() -> None:
    """Task 4: z = 20, 30, three satellites of 1.2 kg at 0.10 m; at the carrier and at shaft 1."""
    u1, u2 = 2 * (20 + 30) / 20, -(20 + 30) / 30
    parts = (0.05, 1.0), (0.002, u1), (3 * 0.004, u2), (3 * 1.2 * 0.10**2, 1.0)
    carrier = Task(1.0, None, 24, tuple(Shaft("", *part) for part in parts)).present
    assert (carrier, Shaft("", carrier, 1 / u1).reduced) == (ten(0.1693333333), ten(0.006773333333))


def test_planing_load_over_a_turn() -> None:
    """M4.7: the work of 2000 N over 0.9 of the stroke, and the moment of the drive."""
    found = planer()
    assert found.settled
    assert np.degrees(found.breaks) == pytest.approx([0, 23.1632606, 150.3837539, 180], abs=5e-8)
    assert -found.work(np.array([2 * pi]))[0] == ten(360.0)
    assert found.driving == ten(57.29577951)
    quarter = np.array([pi / 2])
    assert found.surplus(quarter)[0] == ten(-115.4033308)
    assert found.varying(quarter)[0] == ten(0.100625)


CLEARANCE, AREA, LOW, HIGH, POWER = 0.02, 0.01, 1e5, 5e5, 1.3


def indicated(motion: Motion) -> Loading:
    """Load the piston as an indicator diagram does: compression, delivery, re-expansion, suction (M4.7)."""
    point = motion.points["B"]
    room = point.r.real - 0.3 + CLEARANCE  # m: from the cylinder's head, which the piston nears
    inward = point.v.real < 0
    squeezed = np.minimum(HIGH, LOW * ((CLEARANCE + 0.2) / room) ** POWER)
    expanded = np.maximum(LOW, HIGH * (CLEARANCE / room) ** POWER)
    pressure = np.where(inward, squeezed, expanded) - LOW
    return Loading((Applied("F", 3, "B", 0j, pressure * AREA + 0j),), ())


def test_compressor_with_all_branches_of_its_diagram() -> None:
    """M4.7: work of either stroke, and the moment of the drive."""
    begins = 1 - 0.04379012405 / 0.2  # share at which delivery begins, and that at which re-expansion has ended
    ends = 1 - 0.04897619444 / 0.2
    branches = Force("F", 3, "B", 0j, 1.0, 1 + 0j, diagram=Diagram((0.0, ends, begins, 1.0), (0.0, 0.0, 1.0, 1.0)))
    one = worked(branches)
    reduction = Reduction(Analysis(one.mechanism, first=False), one.machine, indicated, 0.0)
    found = exact(reduction, one.strokes)
    forward, whole = found.work(np.array([pi, 2 * pi]))
    assert -forward == pytest.approx(348.7860211, rel=1e-9)
    assert whole - forward == pytest.approx(54.43649076, rel=1e-9)
    assert (-whole, found.driving) == (pytest.approx(294.3495304, rel=1e-9), pytest.approx(46.84718275, rel=1e-9))


def test_energy_mass_diagram() -> None:
    """M4.8: the ray to 150 degrees, on the scales of M4.9."""
    found, its = planer(), its_flywheel()
    there = np.array([radians(150)])
    energy, inertia = its.energy + found.surplus(there)[0], its.whole + found.varying(there)[0]
    psi = degrees(atan((energy / 4.0) / (inertia / 0.0025)))
    assert psi == ten(2.713540195)
    assert Swing(found, its.whole, its.energy).omega(there)[0] == ten(12.31527858)


def test_flywheel_by_the_loop() -> None:
    """M4.9: tangents, what they touch and cut off, J0, T0 and the flywheel."""
    its = its_flywheel()
    psi = [degrees(atan(slope * 0.0025 / 4.0)) for slope in its.slopes]
    assert psi == [ten(2.713436623), ten(2.939081068)]
    low, high = its.touches
    assert np.degrees([high.turned, low.turned]) == pytest.approx([23.1632606, 150.3837539], abs=5e-8)
    on_paper = [(high.varying, high.surplus), (low.varying, low.surplus)]
    sizes = [value / scale for point in on_paper for value, scale in zip(point, (0.0025, 4.0), strict=True)]
    assert sizes == [ten(9.238783703), ten(5.790815149), ten(6.183607631), ten(-52.40406151)]
    assert (its.cuts[1] / 4.0, its.cuts[0] / 4.0) == (ten(5.316480454), ten(-52.69712643))
    assert (its.whole, its.energy, its.inertia) == (ten(36.73754573), ten(2996.601908), ten(36.70337073))


def test_flywheel_by_the_book_s_angles() -> None:
    """M4.9: without the square of delta; put back, it keeps delta to a ten-millionth less."""
    slopes = book_slopes(TASK)
    psi = [degrees(atan(slope * 0.0025 / 4.0)) for slope in slopes]
    assert psi == [ten(2.712308183), ten(2.937953067)]
    found = flywheel(planer(), TASK, slopes)
    assert found.whole == ten(36.73758392)
    assert kept(found.whole) == ten(0.03999995844)


def kept(inertia: float) -> float:
    """Give the fluctuation of the worked machine with an inertia at position 0."""
    swing = steady(planer(), inertia, SPEED)
    assert isinstance(swing, Swing)
    low, high = swing.extremes()[1]
    assert (low + high) / 2 == pytest.approx(SPEED, rel=1e-14)
    return (high - low) / SPEED


def test_mertsalov_and_gutyar() -> None:
    """M4.10: range of energy, J0 and what it achieves; Gutyar's is that of the exact tangents."""
    told = methods(planer(), TASK)
    assert told is not None
    assert (told.height, told.mertsalov) == (ten(232.1764391), ten(36.75686191))
    assert np.degrees([one.turned for one in told.touches]) == pytest.approx([150.3837539, 23.1632606], abs=5e-8)
    assert kept(told.mertsalov) == ten(0.03997899058)
    assert told.gutyar == ten(36.73754573)
    assert told.book == ten(36.73758392)
    assert methods(planer(), TASK._replace(delta=None)) is None


def test_mass_of_the_rim_and_a_faster_shaft() -> None:
    """M4.11: on its own shaft, and on one that turns 14 times faster."""
    slow, fast = wheel(11.8, Rim(1.0, 0.9)), wheel(11.8, Rim(-14.0, 0.3))
    assert slow is not None
    assert fast is not None
    assert slow.mass == ten(58.27160494)
    assert (fast.inertia, fast.mass) == (ten(0.06020408163), ten(2.675736961))


def test_motion_of_the_shaft() -> None:
    """M4.12: speed and acceleration at 120 degrees; the scan of M4.9."""
    swing = with_flywheel(planer(), TASK, its_flywheel())
    assert isinstance(swing, Swing)
    there = np.array([radians(120)])
    assert (swing.omega(there)[0], swing.epsilon(there)[0]) == (ten(12.37534206), ten(-2.350325167))
    scan = swing.speeds(edges(planer(), 720))
    assert scan.extremes == (ten(12.3150432), ten(12.81769803))
    assert (f"{scan.omega.min():.5f}", f"{scan.omega.max():.5f}") == ("12.31504", "12.81770")
    assert (scan.delta, scan.mean) == (pytest.approx(DELTA, rel=1e-12), pytest.approx(SPEED, rel=1e-14))
    assert speed_slopes(TASK) == pytest.approx([one**2 / 2 for one in scan.extremes], rel=1e-12)
