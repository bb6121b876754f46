"""The tables of balancing: counterweights with their sizes, and what they change (таблицы уравновешивания)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.figures.forces.force_letters import letter_of
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.balance_letters import FORCE, MOMENT, counterweight
from drawings.page.drafting import Drafting
from plans.forces.cut import indices
from plans.forces.primary import BALANCING
from plans.model.balance.linkage import DISC, Balance, Counterweight, State
from plans.model.kinetostatics import NOTHING

WEIGHTS, COSTS = "counterweights", "costs"  # the names of the tables
DIGITS = 5
NONE = "—"
MILLIMETRES = 1000.0


def counterweights(weights: Sequence[Counterweight], drafting: Drafting) -> RuledTable:
    """Tell each counterweight: static moment about its link's beginning, mass, place, shape and sizes."""
    mm = drafting.word("mm")
    heads = (
        drafting.word("on link"), f"m·a, {drafting.word('kg*m')}", f"m, {drafting.word('kg')}", drafting.word("from"),
        f"a, {mm}", "∠, °", drafting.word("shape"), f"R, {mm}", f"b, {mm}",
    )  # fmt: skip
    lines = [TableRow(counterweight(one.link, drafting.language), _weight(one, drafting)) for one in weights]
    return table(lines, drafting.word("counterweight column"), heads, drafting.hand.text)._replace(name=WEIGHTS)


def _weight(one: Counterweight, drafting: Drafting) -> tuple[str, ...]:
    if not one.needed:
        return str(one.link), "0", "0", *(NONE for _ in range(6))
    place, number = one.place, drafting.number
    sizes = (MILLIMETRES * size for size in (one.outer, place.thickness))
    return (
        str(one.link), number(abs(one.moment), DIGITS), number(one.mass, DIGITS), one.begin,
        number(MILLIMETRES * one.distance, DIGITS), number(_degrees(one.moment), DIGITS), _shape(one, drafting),
        *(number(size, DIGITS) for size in sizes),
    )  # fmt: skip


def _degrees(moment: complex) -> float:
    """Give a direction in its link's own frame in degrees, without the noise of a rounding about 0 and 180."""
    angle = math.degrees(cmath.phase(moment))
    return abs(angle) if abs(moment.imag) <= NOTHING * abs(moment) else angle


def _shape(one: Counterweight, drafting: Drafting) -> str:
    if one.place.shape == DISC:
        return drafting.word("disc")
    return drafting.word("sector", angle=drafting.number(math.degrees(2 * one.place.half_angle)))


class Cost(NamedTuple):
    """What counterweights change: its name with the unit, before and after; what is no more than `least` is none."""

    name: str
    before: float
    after: float | None
    least: float = 0.0


def costs(balance: Balance, drafting: Drafting, size: float) -> RuledTable:
    """Tell path, main vector and moment, reactions, balancing moment and mass before and after; `size` m is whose."""
    told = tuple(_costs(balance, drafting, size))
    heads = ("before column", "after column", "change")
    words = tuple(drafting.word(head) for head in (heads if balance.after is not None else heads[:1]))
    lines = [TableRow(one.name, _cells(one, drafting)) for one in told]
    return table(lines, drafting.word("largest value"), words, drafting.hand.text)._replace(name=COSTS)


def _costs(balance: Balance, drafting: Drafting, size: float) -> Iterator[Cost]:
    before, after, word = balance.before, balance.after, drafting.word
    least = NOTHING * before.forces.largest
    yield Cost(
        word("path of S", unit=word("mm")), MILLIMETRES * before.around.path,
        None if after is None else MILLIMETRES * after.around.path, NOTHING * MILLIMETRES * size,
    )  # fmt: skip
    yield _cost(f"{FORCE}, {word('N')}", "shaking", before, after)
    yield _cost(f"{MOMENT}, {word('N*m')}", "rocking", before, after)
    for key, one in before.forces.reactions.items():
        name = letter_of(f"R_{indices(one.giver, one.taker)}", drafting)
        then = None if after is None else after.reactions[key]
        yield Cost(f"{name}, {word('N')}", before.reactions[key], then, least)
    yield _cost(f"{letter_of(BALANCING, drafting)}, {word('N*m')}", "balancing", before, after)
    yield Cost(word("moving mass", unit=word("kg")), before.centre.mass, None if after is None else after.centre.mass)


def _cost(name: str, quantity: str, before: State, after: State | None) -> Cost:
    was = getattr(before, quantity)
    return Cost(name, was, None if after is None else getattr(after, quantity), NOTHING * was)


def _cells(one: Cost, drafting: Drafting) -> tuple[str, ...]:
    before = _told(one.before, one.least, drafting)
    if one.after is None:
        return (before,)
    change = _change(one, drafting)
    return before, _told(one.after, one.least, drafting), change


def _told(value: float, least: float, drafting: Drafting) -> str:
    return "0" if abs(value) <= least else drafting.number(value, DIGITS)


def _change(one: Cost, drafting: Drafting) -> str:
    """Write how much more it is, in per cent; of what was nothing there is no share."""
    if one.after is None or abs(one.before) <= one.least:
        return NONE
    after = 0.0 if abs(one.after) <= one.least else one.after
    share = 100 * (after / one.before - 1)
    text = drafting.number(share, 3) if abs(share) >= 1e-3 else "0"
    return f"+{text}" if share >= 1e-3 else text
