"""Both roads to the harmonics of a bank, timed and judged against sums in 50 digits of exact angles (эталон)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from geometry.replay import DIGITS
from plans.analytic.balance.bank import SliderCrank as Series
from plans.analytic.balance.bank import bank_balance
from plans.bank.harmonics import harmonics, of_ordinates
from plans.bank.letters import FORCE, MOMENT, SINGLE, letters
from plans.bank.polygons import polygons
from plans.bank.shaking import SliderCrank
from plans.bank.study import BankStudy
from plans.bench.error import Errors
from plans.bench.truth import digits
from plans.model.balance.bank import BankTask, Harmonic, Member, Unit

DRAWN, SERIES = "construction: polygons", "analysis: closed series"
FEW = (12, 24, 48)  # ordinates as they are taken on paper
DEFINED = (
    "error: the largest difference from the truth of the vectors of all orders, of one mechanism f, of the bank's "
    "force F and moment M; in shares of the largest f, and of M of that at the largest place along the shaft"
)
TRUE = (
    f"truth: sums in {DIGITS} digits over even crank angles, twice as many until they settle, "
    "at exact angles and places"
)
Told = Mapping[str, Mapping[int, Harmonic]]
Way = Callable[[], Told]


def ways(task: BankTask) -> list[tuple[str, int | None, Way]]:
    """List the roads, those of few ordinates with their number; each begins anew with every run."""
    unit = _unit(task)
    few: list[tuple[str, int | None, Way]] = [(DRAWN, count, partial(_few, task, count)) for count in FEW]
    enough = len(harmonics(SliderCrank(unit, task.speed), task.orders).ordinates)
    return [*few, (DRAWN, enough, partial(_drawn, task)), (SERIES, None, partial(_summed, task))]


def _unit(task: BankTask) -> Unit:
    if task.unit is None:
        raise ValueError("the truth is of a slider-crank by its sizes")
    return task.unit


def _few(task: BankTask, count: int) -> Told:
    source = SliderCrank(_unit(task), task.speed)
    single = of_ordinates(source, source.shaking(Fraction(0), count), task.orders)
    found = polygons(single, task.members)
    return {
        SINGLE: {order: single.harmonic(order) for order in task.orders},
        FORCE: {order: found.force(order) for order in task.orders},
        MOMENT: {order: found.moment(order) for order in task.orders},
    }


def _drawn(task: BankTask) -> Told:
    found = BankStudy(task, SliderCrank(_unit(task), task.speed)).balance
    return {SINGLE: found.single, FORCE: found.forces, MOMENT: found.moments}


def _summed(task: BankTask) -> Told:
    found = bank_balance(task, Series(_unit(task), task.speed))
    return {SINGLE: found.single, FORCE: found.forces, MOMENT: found.moments}


def truth(task: BankTask) -> Mapping[tuple[str, int], Any]:
    """Find the vectors of all signed orders in many digits, by the kind of the letter and the order."""
    mp, unit = digits(), _unit(task)
    found: dict[tuple[str, int], Any] = {}
    for order in task.orders:
        slider = order**2 * mp.mpf(unit.reciprocating) * _slider(mp, unit, order) / 2
        for signed in (order, -order):
            rotating = mp.mpf(unit.rotating) * mp.mpf(unit.crank) if signed == 1 else 0
            single = mp.mpf(task.speed) ** 2 * (slider + rotating)
            shares = [(single * _turned(mp, one, signed), one.place) for one in task.members]
            moments = [share * place.numerator / mp.mpf(place.denominator) for share, place in shares]
            found |= {(SINGLE, signed): single, (FORCE, signed): mp.fsum(share for share, _ in shares)}
            found[MOMENT, signed] = mp.fsum(moments)
    return found


def _slider(mp: Any, unit: Unit, order: int) -> Any:
    """Give the amplitude of an order in the slider's distance, by sums over even angles: they settle very soon."""
    ratio, count = mp.mpf(unit.crank) / mp.mpf(unit.rod), 64
    before = None
    while True:
        now = _cosines(mp, ratio, order, count)
        if before is not None and abs(now - before) <= mp.mpf(10) ** (5 - DIGITS):
            return mp.mpf(unit.rod) * now + (mp.mpf(unit.crank) if order == 1 else 0)
        before, count = now, 2 * count


def _cosines(mp: Any, ratio: Any, order: int, count: int) -> Any:
    angles = (mp.mpf(2 * k) / count for k in range(count))
    rows = (mp.sqrt(1 - (ratio * mp.sinpi(angle)) ** 2) * mp.cospi(order * angle) for angle in angles)
    return 2 * mp.fsum(rows) / count


def _turned(mp: Any, one: Member, signed: int) -> Any:
    angle = signed * one.phase + one.axis
    return mp.expjpi(mp.mpf(angle.numerator) / angle.denominator / 180)


def errors(told: Told, true: Mapping[tuple[str, int], Any], members: Sequence[Member]) -> Errors:
    """Judge what a road has found."""
    most = max(abs(complex(value)) for (kind, _), value in true.items() if kind == SINGLE)
    arm = max((abs(float(one.place)) for one in members), default=0.0) or 1.0
    kinds: dict[str, float] = {}
    worst = ""
    for (kind, signed), value in true.items():
        one = told[kind][abs(signed)]
        near = one.ahead if signed > 0 else one.back
        share = float(abs(near - value)) / (most * (arm if kind == MOMENT else 1.0))
        worst = letters(kind, signed) if share > max(kinds.values(), default=-1.0) else worst
        kinds[kind] = max(kinds.get(kind, 0.0), share)
    return Errors(kinds, worst)
