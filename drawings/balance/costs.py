"""Counterweights by their sizes, and what they cost, as sheet and report table them (цена уравновешивания)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

from drawings.forces.letters import letter_of
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import FORCE, MOMENT, counterweight
from drawings.page.page import Drafting
from plans.balance.weights import line_of
from plans.forces.cut import indices
from plans.forces.drive import BALANCING
from plans.model.balance.linkage import DISC, Counterweight, State
from plans.model.mechanism import Mechanism
from plans.model.motion import NOTHING


class Nothing(NamedTuple):
    """The force N, the moment N*m about the shaft and the way m that are no more than rounding."""

    force: float
    moment: float
    way: float


def nothing(states: Iterable[State], size: float) -> Nothing:
    """Tell what is nothing in all states of a mechanism of some size, m: by its largest forces in any of them."""
    largest = max(state.forces.largest for state in states)
    return Nothing(NOTHING * largest, NOTHING * largest * size, NOTHING * size)


WEIGHTS, COSTS = "counterweights", "costs"  # the names of the tables
DIGITS = 5
NONE = "—"
MILLIMETRES = 1000.0
MM, METRES = ("mm", MILLIMETRES), ("m", 1.0)
SHARE_DIGITS, PLACES = 3, 3  # of a change in per cent: digits, and decimals, below which there is none


def counterweights(weights: Sequence[Counterweight], mechanism: Mechanism, drafting: Drafting) -> RuledTable:
    """Tell each counterweight: static moment about its link's beginning, mass, direction off the link's line, sizes."""
    mm = drafting.word("mm")
    heads = (
        f"m·a, {drafting.word('kg*m')}", f"m, {drafting.word('kg')}", drafting.word("from"),
        f"a, {mm}", "∠, °", drafting.word("shape"), f"R, {mm}", f"b, {mm}",
    )  # fmt: skip
    lines = [TableRow(counterweight(w.link, drafting.language), _weight(w, mechanism, drafting)) for w in weights]
    return table(lines, drafting.word("counterweight column"), heads, drafting.hand.text)._replace(name=WEIGHTS)


def _weight(weight: Counterweight, mechanism: Mechanism, drafting: Drafting) -> tuple[str, ...]:
    if not weight.needed:
        return "0", "0", *(NONE for _ in range(6))
    place, number = weight.place, drafting.number
    sizes = (MILLIMETRES * size for size in (weight.outer, place.thickness))
    return (
        number(abs(weight.moment), DIGITS), number(weight.mass, DIGITS), weight.begin,
        number(MILLIMETRES * weight.distance, DIGITS), number(degrees(weight, mechanism), DIGITS),
        shape(weight, drafting),
        *(number(size, DIGITS) for size in sizes),
    )  # fmt: skip


def degrees(weight: Counterweight, mechanism: Mechanism) -> float:
    """Give the direction of a counterweight from its link's line in degrees, without noise about 0 and 180."""
    moment = weight.moment / line_of(mechanism, weight.link, weight.begin)
    angle = math.degrees(cmath.phase(moment))
    return abs(angle) if abs(moment.imag) <= NOTHING * abs(moment) else angle


def shape(weight: Counterweight, drafting: Drafting) -> str:
    """Say what shape a counterweight has."""
    if weight.place.shape == DISC:
        return drafting.word("disc")
    return drafting.word("sector", angle=drafting.number(math.degrees(2 * weight.place.half_angle)))


class Cost(NamedTuple):
    """What counterweights change: its name with the unit, its value in a state; what is no more than `least` is 0."""

    name: str
    of: Callable[[State], float]
    least: float = 0.0

    def value(self, state: State) -> float:
        """Give its value in a state."""
        value = self.of(state)
        return 0.0 if abs(value) <= self.least else value


def costs(before: State, after: State | None, none: Nothing, drafting: Drafting, shaft: str) -> RuledTable:
    """Tell what is largest of the mass centre's way, main vector and moment, reactions, balancing moment, and mass."""
    heads = ("before column", "after column", "change column")
    costs = quantities(before, none, drafting, shaft)
    words = tuple(drafting.word(head) for head in (heads if after is not None else heads[:1]))
    lines = [TableRow(cost.name, cells(cost, before, after, drafting)) for cost in costs]
    heading = drafting.word("largest value", count=before.count)
    return table(lines, heading, words, drafting.hand.text)._replace(name=COSTS, least=6)


def quantities(
    state: State, none: Nothing, drafting: Drafting, shaft: str, length: tuple[str, float] = MM
) -> Iterator[Cost]:
    """List what is told of a state, every pair's reaction among it; lengths by a unit and how many make a metre."""
    word, (unit, parts) = drafting.word, length
    yield Cost(word("path of S", unit=word(unit)), lambda state: parts * state.path, parts * none.way)
    yield Cost(f"{FORCE}, {word('N')}", lambda state: state.shaking, none.force)
    moment = word("moment about", letter=MOMENT, point=shaft, unit=word("N*m"))
    yield Cost(moment, lambda state: state.rocking, none.moment)
    for key, pair in state.forces.reactions.items():
        letter = letter_of(f"R_{indices(pair.giver, pair.taker)}", drafting)
        yield Cost(f"{letter}, {word('N')}", partial(_reaction, key), none.force)
    balancing = f"{letter_of(BALANCING, drafting)}, {word('N*m')}"
    yield Cost(balancing, lambda state: state.balancing, none.moment)
    yield Cost(word("moving mass", unit=word("kg")), lambda state: state.centre.mass)


def _reaction(key: str, state: State) -> float:
    return state.reactions[key]


def cells(cost: Cost, before: State, after: State | None, drafting: Drafting, digits: int = DIGITS) -> tuple[str, ...]:
    """Write a quantity before and after, and how it changes."""
    was = cost.value(before)
    if after is None:
        return (drafting.number(was, digits),)
    now = cost.value(after)
    return drafting.number(was, digits), drafting.number(now, digits), change(was, now, drafting)


def change(before: float, after: float, drafting: Drafting) -> str:
    """Write how much more it is, in per cent; of what was nothing there is no share."""
    if not before:
        return NONE
    share = round(100 * (after / before - 1), PLACES)
    text = drafting.number(share, SHARE_DIGITS)
    return f"+{text}" if share > 0 else text
