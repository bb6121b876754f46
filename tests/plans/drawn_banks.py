"""Banks for tests: the textbook's, engines, and any that hypothesis draws."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from hypothesis import strategies as st

from plans.analytic.balance.bank import ExactSliderCrank as Series
from plans.analytic.balance.bank import bank_balance
from plans.bank.harmonics import SliderCrank
from plans.bank.study import BankStudy
from plans.model.balance.bank import Asked, BankBalance, BankTask, Member, Unit

# methods.md's worked data of the book's figures 8.13 and 8.14: what M7.6 leaves moves along the guide
BOOK = BankTask(
    Unit(0.1, 0.4, 0.0, 9.5),
    (Member("1", Fraction(0), Fraction(0), Fraction(0)),),
    20.0,
    (1, 2, 4),
    (Asked(1, 2.0, 0.06, 0.5),),
)
ENGINE = Unit(0.04, 0.14, 0.3, 0.5)


def study(task: BankTask) -> BankStudy:
    """Give the study of a bank of slider-cranks."""
    assert task.unit is not None
    return BankStudy(task, SliderCrank(task.unit, task.speed))


def drawn(task: BankTask) -> BankBalance:
    """Find a bank by construction."""
    return study(task).balance


def series(task: BankTask) -> Series:
    """Give the mechanism of a bank for the analysis."""
    assert task.unit is not None
    return Series(task.unit, task.speed)


def summed(task: BankTask) -> BankBalance:
    """Find a bank by analysis."""
    return bank_balance(task, series(task))


def task(members: Sequence[Member], unit: Unit = ENGINE, orders: tuple[int, ...] = (1, 2, 4)) -> BankTask:
    """Give a bank of some mechanisms."""
    return BankTask(unit, tuple(members), 100.0, orders)


angles = st.integers(-3599, 3600).map(lambda k: Fraction(k, 10))
places = st.integers(-1000, 1000).map(lambda k: Fraction(k, 1000))
ratios = st.floats(0.001, 0.9)


@st.composite
def members(draw: st.DrawFn) -> tuple[Member, ...]:
    """Draw the mechanisms of a bank, one to six."""
    rows = draw(st.lists(st.tuples(angles, places, angles), min_size=1, max_size=6))
    return tuple(Member(str(number), *row) for number, row in enumerate(rows, 1))


@st.composite
def units(draw: st.DrawFn) -> Unit:
    """Draw a slider-crank."""
    masses = st.floats(0.0, 5.0)
    return Unit(draw(ratios) * 0.2, 0.2, draw(masses), draw(masses) + 0.1)


def banks() -> st.SearchStrategy[BankTask]:
    """Draw a bank."""
    return st.builds(task, members(), units())
