"""Both roads to a rotor and to a bank, timed and judged against sums in 50 digits (испытание уравновешивания)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from geometry.replay import DIGITS
from plans.analytic.balance.bank import SliderCrank as Series
from plans.analytic.balance.bank import bank_balance
from plans.analytic.rotor import balance
from plans.bank.harmonics import FORCE, MOMENT, SINGLE, SliderCrank, harmonics, letters, of_ordinates
from plans.bank.polygons import polygons
from plans.bank.study import BankStudy
from plans.bench.error import Errors
from plans.bench.trial import Found, Order, Road, terms, timed
from plans.bench.truth import REACTION, Exact, digits, split, turned
from plans.model.balance.bank import BankTask, Harmonic, Member, Unit
from plans.model.rotor import Balance, Rotor
from plans.rotor.balancing import unbalance_letters
from plans.rotor.study import BEARINGS, RotorStudy
from plans.scene.scene import Scene

POLYGONS, SUMS, SERIES = "construction: polygons", "analysis: sums", "analysis: closed series"
STATIC = "mD"  # the kind of a static moment
ROTOR = (
    "error: the largest difference from the truth of the counterweights' static moments, in shares of the largest "
    "static moment of their polygon; of the reactions, in shares of the largest one",
    f"truth: sums in {DIGITS} digits of the static moments as they are read, at exact angles and places",
    "a rotor has no positions: --positions does nothing here",
)
FEW = (12, 24, 48)  # ordinates as they are taken on paper
BANK = (
    "error: the largest difference from the truth of the vectors of all orders, of one mechanism f, of the bank's "
    "force F and moment M; in shares of the largest f, and of M of that at the largest place along the shaft",
    f"truth: sums in {DIGITS} digits over even crank angles, twice as many until they settle, "
    "at exact angles and places",
    "a bank has no positions of its own: --positions does nothing here, and positions are the ordinates of a turn",
)
OF_LINKAGE = "the harmonics of a linkage have no truth here: the bench judges banks of slider-cranks by their sizes"
Truth = Mapping[str, Exact]  # of each vector by its name
Told = Mapping[str, Mapping[int, Harmonic]]


def rotor_roads(rotor: Rotor, true: Truth) -> list[Road]:
    """List the roads to a rotor's balance; each begins anew with every run."""

    def judge(found: Balance) -> Errors:
        values = {unbalance_letters(one.plane.name): one.moment.value for one in found.corrections}
        values |= {f"R_{name}": one.value for name, one in zip(BEARINGS, found.before, strict=False)}
        return judged(values, true)

    drawn = Road(lambda: RotorStudy(rotor).balance, None, {POLYGONS: judge})
    return [drawn, Road(lambda: balance(rotor), None, {SUMS: judge})]


def rotor_truth(rotor: Rotor) -> Truth:
    """Find the counterweights and the reactions before any correction in many digits."""
    mp = digits()
    loads = [(mp.mpf(one.moment) * turned(mp, one.angle / 360), one.place) for one in rotor.masses]
    places = [plane.place for plane in rotor.planes]
    found = {unbalance_letters(plane.name): _shared(mp, loads, plane.place, places) for plane in rotor.planes}
    if rotor.bearings and rotor.speed is not None:
        for name, place in zip(BEARINGS, rotor.bearings, strict=True):
            found[f"R_{name}"] = mp.mpf(rotor.speed) ** 2 * _shared(mp, loads, place, rotor.bearings)
    return {name: split([value]) for name, value in found.items()}


def judged(values: Mapping[str, complex], true: Truth) -> Errors:
    """Give the errors of static moments and reactions, each in shares of the largest of its kind."""
    kinds = {name: REACTION if name.startswith("R_") else STATIC for name in true}
    most = {kind: max(abs(one.near[0]) for name, one in true.items() if kinds[name] == kind) for kind in kinds.values()}
    off = {name: float(true[name].off(np.array([value]))[0]) for name, value in values.items()}
    return Errors.joined((kinds[n], n, error / most[kinds[n]] if most[kinds[n]] else 0.0) for n, error in off.items())


def _shared(mp: Any, loads: Sequence[tuple[Any, Fraction]], here: Fraction, places: Sequence[Fraction]) -> Any:
    """Give what balances vectors at a place, by moments about the other one, or all of it where there is no other."""
    others = [place for place in places if place != here]
    shares = [(place - others[0]) / (here - others[0]) if others else Fraction(1) for _, place in loads]
    terms = [load * share.numerator / mp.mpf(share.denominator) for (load, _), share in zip(loads, shares, strict=True)]
    return -mp.fsum(terms)


def bank(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge both roads to the harmonics of a scene's bank."""
    task: BankTask = scene.meaning["bank"].task
    tell("the bank")
    if task.unit is None:
        return Found([], [OF_LINKAGE])
    return Found(timed(bank_roads(task, task.unit), order.rounds), [*BANK, *terms(order)])


def bank_roads(task: BankTask, unit: Unit) -> list[Road]:
    """List the roads to a bank's harmonics, those of few ordinates with their number; each begins anew."""
    judge = partial(bank_errors, true=bank_truth(task, unit), members=task.members)
    source = SliderCrank(unit, task.speed)
    enough = len(harmonics(source, task.orders).ordinates)
    note = "so many ordinates as are taken on paper"
    few = [Road(partial(_few, task, source, count), count, {POLYGONS: judge}, note, 0) for count in FEW]
    drawn = Road(lambda: _told(BankStudy(task, SliderCrank(unit, task.speed)).balance), enough, {POLYGONS: judge}, of=0)
    series = Road(lambda: _told(bank_balance(task, Series(unit, task.speed))), None, {SERIES: judge})
    return [*few, drawn, series]


def _few(task: BankTask, source: SliderCrank, count: int) -> Told:
    single = of_ordinates(source, source.shaking(Fraction(0), count), task.orders)
    found = polygons(single, task.members)
    ways = {SINGLE: single.harmonic, FORCE: found.force, MOMENT: found.moment}
    return {kind: {order: way(order) for order in task.orders} for kind, way in ways.items()}


def _told(found: Any) -> Told:
    return {SINGLE: found.single, FORCE: found.forces, MOMENT: found.moments}


def bank_truth(task: BankTask, unit: Unit) -> Mapping[tuple[str, int], Any]:
    """Find the vectors of all signed orders in many digits, by the kind of the letter and the order."""
    mp = digits()
    found: dict[tuple[str, int], Any] = {}
    for order in task.orders:
        slider = order**2 * mp.mpf(unit.reciprocating) * _slider(mp, unit, order) / 2
        for signed in (order, -order):
            rotating = mp.mpf(unit.rotating) * mp.mpf(unit.crank) if signed == 1 else 0
            single = mp.mpf(task.speed) ** 2 * (slider + rotating)
            shares = [(single * turned(mp, (signed * one.phase + one.axis) / 360), one.place) for one in task.members]
            moments = [share * place.numerator / mp.mpf(place.denominator) for share, place in shares]
            found |= {(SINGLE, signed): single, (FORCE, signed): mp.fsum(share for share, _ in shares)}
            found[MOMENT, signed] = mp.fsum(moments)
    return found


def _slider(mp: Any, unit: Unit, order: int) -> Any:
    """Give the amplitude of an order in the slider's distance, by sums over even angles: they settle very soon."""
    ratio, count, before = mp.mpf(unit.crank) / mp.mpf(unit.rod), 64, mp.inf
    while abs((now := _cosines(mp, ratio, order, count)) - before) > mp.mpf(10) ** (5 - DIGITS):
        before, count = now, 2 * count
    return mp.mpf(unit.rod) * now + (mp.mpf(unit.crank) if order == 1 else 0)


def _cosines(mp: Any, ratio: Any, order: int, count: int) -> Any:
    angles = (mp.mpf(2 * k) / count for k in range(count))
    rows = (mp.sqrt(1 - (ratio * mp.sinpi(angle)) ** 2) * mp.cospi(order * angle) for angle in angles)
    return 2 * mp.fsum(rows) / count


def bank_errors(told: Told, true: Mapping[tuple[str, int], Any], members: Sequence[Member]) -> Errors:
    """Judge the harmonics that a road has found."""
    most = max(abs(complex(value)) for (kind, _), value in true.items() if kind == SINGLE)
    arm = max((abs(float(one.place)) for one in members), default=0.0) or 1.0
    harmonic = {(kind, signed): told[kind][abs(signed)] for kind, signed in true}
    near = {key: one.ahead if key[1] > 0 else one.back for key, one in harmonic.items()}
    return Errors.joined(
        (
            kind,
            letters(kind, signed),
            float(abs(near[kind, signed] - value)) / (most * (arm if kind == MOMENT else 1.0)),
        )
        for (kind, signed), value in true.items()
    )
