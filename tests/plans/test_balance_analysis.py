"""Balancing by analysis: the textbook's worked values, and what must hold of any balanced mechanism (M7.4-M7.7)."""

from __future__ import annotations

import numpy as np
import pytest

from plans.analytic.balance.balance import balance
from plans.model.balance.linkage import FULL, NONE, PARTIAL, Place, Task
from tests.plans.balanced import engine, four_bar, rod_six_link, six_link

SIXTY = (np.pi / 3,)


def printed(value: float, text: str) -> bool:
    """Tell whether a value, rounded to the digits of a text, is that text."""
    return f"{value:z.{len(text.partition('.')[2])}f}" == text


def both(value: complex, x: str, y: str) -> bool:
    return printed(value.real, x) and printed(value.imag, y)


def test_mass_centre_of_the_four_bar() -> None:
    """Book 8.2.2, (8.6): methods M7.4, all printed digits."""
    centre = balance(four_bar().course(SIXTY), Task(NONE)).before.centre
    assert centre.mass == 11
    assert both(centre.r[0], "0.2474528462", "0.1533593396")
    assert both(centre.a[0], "-6.266385528", "-2.252402396")
    assert both(centre.force[0], "68.9302408", "24.77642635")


def test_mass_centre_of_the_six_link() -> None:
    """Book 8.2.2, figure 8.7: methods M7.4, all printed digits."""
    centre = balance(rod_six_link().course(SIXTY), Task(NONE)).before.centre
    assert both(centre.r[0], "0.4288752518", "0.130838553")


FOUR_BAR = {
    "a": ((Place(1, mass=9), Place(2, mass=6)), ("-0.1533333333", "-0.32"), ("0.02692307692", "0.0")),
    "b": ((Place(1, mass=5), Place(3, mass=8)), ("-0.06", "-0.18"), ("0.2158333333", "0.0")),
}


@pytest.mark.parametrize("variant", FOUR_BAR)
def test_full_balancing_of_the_four_bar(variant) -> None:
    """Book 8.2.2, (8.8), figures 8.8, 8.9: methods M7.5, all printed digits, and the mass centre still."""
    places, centres, still = FOUR_BAR[variant]
    case, task = four_bar(), Task(FULL, places)
    found = balance(case.course(SIXTY), task, case.blanks(task))
    for one, text in zip(found.counterweights, centres, strict=True):
        assert printed(one.centre.real, text)
    assert both(found.after.centre.r[0], *still)
    assert found.after.around.path <= 1e-14 * 0.4
    assert found.after.shaking <= 1e-14 * found.before.shaking


def test_partial_balancing_of_the_engine() -> None:
    """Book 8.2.2, (8.9), figure 8.11: methods M7.6, all printed digits; the centre stays on the guide."""
    case, task = engine(), Task(PARTIAL, (Place(1, mass=2),))
    found = balance(case.course(SIXTY), task, case.blanks(task), ("B",))
    assert printed(found.counterweights[0].centre.real, "-0.185")
    assert printed((found.left["B"] / found.after.centre.mass).real, "0.5588235294")
    assert np.ptp(found.after.around.r.imag) <= 1e-14 * 0.4
    assert printed(found.after.shaking, "475.000000") and found.shares is None


def test_full_balancing_of_the_engine() -> None:
    """Book 8.2.2, figure 8.11: methods M7.6, all printed digits."""
    case, task = engine(), Task(FULL, (Place(1, mass=28), Place(2, mass=16)))
    found = balance(case.course(SIXTY), task, case.blanks(task))
    first, second = found.counterweights
    assert printed(first.centre.real, "-0.1042857143") and printed(second.centre.real, "-0.2375")
    assert found.after.around.path <= 1e-14 * 0.4


def test_an_offset_guide_is_balanced_as_one_through_the_shaft() -> None:
    moments = []
    for offset in (0.0, 0.07):
        case, task = engine(offset), Task(FULL, (Place(1, mass=28), Place(2, mass=16)))
        found = balance(case.course(SIXTY), task, case.blanks(task))
        moments.append([one.moment for one in found.counterweights])
        assert found.after.around.path <= 1e-14 * 0.4
    assert np.allclose(*moments, rtol=1e-15)


def test_full_balancing_of_the_six_link() -> None:
    """Book 8.2.2, figure 8.10: methods M7.7, all printed digits."""
    case = six_link()
    task = Task(FULL, (Place(1, mass=6), Place(3, mass=160), Place(4, mass=30)))
    found = balance(case.course(SIXTY), task, case.blanks(task))
    told = [one.centre.real for one in found.counterweights]
    assert [f"{one:.11f}" for one in told] == ["-0.06333333333", "-0.25437500000", "-0.14333333333"]
    assert both(found.after.centre.r[0], "0.0000000000", "-0.3329809725")
    assert found.after.around.path <= 1e-14 * 0.7
