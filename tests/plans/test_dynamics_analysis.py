"""A machine's motion by analysis: worked values of the method digest, to all printed digits (M4.2-M4.12, theme 7)."""

from __future__ import annotations

import cmath
from functools import cache
from math import radians

import numpy as np
import pytest

from plans.analytic.dynamics.flywheel import Exact, methods
from plans.analytic.dynamics.reduction import ExactReduction, reduced
from plans.analytic.dynamics.speeds import Swing, steady
from plans.analytic.kinematics import Analysis
from plans.model.dynamics import Shaft, Task
from plans.model.kinetostatics import Loading
from plans.model.machine import Body
from tests.plans import linkages
from tests.plans.steady_machines import DELTA, SPEED, Steady, machine, worked

SIXTY = radians(60)


def ten(value: float) -> float:
    """Expect a value to ten significant digits."""
    return pytest.approx(value, rel=5e-10)


@cache
def planer() -> Exact:
    return worked().exact


TASK = Task(SPEED, DELTA, 24)


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
    motion = ExactReduction(Analysis(linkage), one.machine, lambda _: Loading((), ()), phi)
    assert reduced(motion, np.array([phi])).inertia[0] == ten(0.6666666667)


def test_task_of_theme_7_planetary_gear() -> None:
    """Task 4: z = 20, 30, three satellites of 1.2 kg at 0.10 m; at the carrier and at shaft 1."""
    u1, u2 = 2 * (20 + 30) / 20, -(20 + 30) / 30
    parts = (0.05, 1.0), (0.002, u1), (3 * 0.004, u2), (3 * 1.2 * 0.10**2, 1.0)
    carrier = Task(1.0, None, 24, tuple(Shaft("", *part) for part in parts)).present
    assert (carrier, Shaft("", carrier, 1 / u1).reduced) == (ten(0.1693333333), ten(0.006773333333))


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
    assert (told.gutyar, told.book) == (ten(36.73754573), ten(36.73758392))
    assert methods(planer(), TASK._replace(delta=None)) is None
