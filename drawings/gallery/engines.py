"""The usual engines in Markdown: which forces and moments of the first orders their mechanisms leave (двигатели)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from drawings.lettering.words import number
from plans.bank.engines import ENGINES, Engine
from plans.bank.harmonics import SliderCrank
from plans.bank.study import BankStudy
from plans.model.balance.bank import BankBalance, BankTask, Harmonic, Member, Unit
from plans.words.words import word

UNIT, SPEED = Unit(0.04, 0.14, 0.0, 0.5), 300.0  # of every engine: what is told are ratios alone
ORDERS = (1, 2, 4, 6)
DIGITS = 4
OPENING = """
### The usual engines

What a [bank](../../README.md) of equal cylinders leaves of each order: forces as so many times the largest force of
that order of one cylinder, moments along the shaft as so many times that force by the pitch of the cylinders. What
turns with the crank alone (↻, of the first order) can be taken by counterweights on the crank. Angles are in degrees;
cylinders at one place along the shaft stand together.

| engine | cranks | guides | forces left, order: times | moments left, order: times |
|---|---|---|---|---|
"""


def engines() -> str:
    """Write the table of the usual engines."""
    return OPENING + "".join(map(row, ENGINES))


def row(engine: Engine) -> str:
    """Write the row of an engine: each order with what is left of it, or nothing."""
    balance = BankStudy(BankTask(UNIT, engine.members, SPEED, ORDERS), SliderCrank(UNIT, SPEED)).balance
    cells = word("en", f"engine.{engine.key}"), *_angles(engine), _left(balance, balance.forces)
    return f"| {' | '.join((*cells, _left(balance, balance.moments)))} |\n"


def _angles(engine: Engine) -> Iterator[str]:
    """Write the angles of the cranks and of the guides along the shaft, those at one place together."""
    places: dict[Fraction, list[Member]] = {}
    for member in engine.members:
        places.setdefault(member.place, []).append(member)
    yield ", ".join(_together(one.crank for one in place) for place in places.values())
    yield ", ".join(dict.fromkeys(_together(one.axis for one in place) for place in places.values()))


def _together(angles: Iterable[Fraction]) -> str:
    return " and ".join(dict.fromkeys(f"{float(angle):g}" for angle in angles)).replace("-", "−")


def _left(balance: BankBalance, found: Mapping[int, Harmonic]) -> str:
    """Write each order of which something is left, in what one cylinder has of it."""
    told = [_share(one, balance.single[order]) for order, one in found.items() if not one.vanishes]
    return "; ".join(told) or "none"


def _share(one: Harmonic, single: Harmonic) -> str:
    turns = " ↻" if one.order == 1 and abs(one.back) <= one.slack else ""
    return f"{one.order}: {number(one.size / single.size, 'en', DIGITS)}{turns}"
