"""The self-check of the polygon of static moments and of the hodographs of the main vector (кривые)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks import reading
from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance.balance_expected import Expected, Side
from drawings.checks.balance.balance_schemes import PRIMES, runs
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance import shaking_hodograph, static_polygon
from drawings.figures.balance.scheme import AFTER, BEFORE
from drawings.figures.balance.shaking_hodograph import NUMBERED
from drawings.layout.parallel_offsets import APART
from drawings.lettering.balance_letters import FORCE, RESULT
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import group_named
from plans.model.motion import Complexes

LETTERS = {BEFORE: FORCE, AFTER: f"{FORCE}'"}
LEAST = 0.1  # mm: a vector that is shorter may be a point
LANES = 3.0  # rooms of a letter that a vector of a polygon may stand aside


def polygon(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold the polygon of static moments: each side, their sum, and what is said where there is none."""
    name = static_polygon.NAME
    if name not in leaf.metadata["figures"]:
        return
    part, seen = group_named(leaf.groups, name), marks.vectors(expected.measured, name)
    (sides, slack), mu = static_moments(expected), marks.scale(expected.measured, name)
    yield from marks.held(seen, {one.name: one.value for one in sides}, name, slack)
    if sides:
        hand = expected.drafting.hand
        lane = LANES * abs(static_polygon.ROOM) * hand.letter + APART * hand.symbol
        yield from marks.laid(seen, sides, name, marks.pole(part), 2 * slack / mu, lane)
    yield from _said(leaf, expected, sides)
    if part is not None and seen:
        yield from reading.scales(part, {mu})


def static_moments(expected: Expected) -> tuple[list[Side], float]:
    """Give the sides of the polygon, their sum last, without what is nothing, and how far each may be off, kg*m."""
    sides, name = list(expected.moments()), static_polygon.NAME
    size, whole = sum(abs(one.value) for one in sides), sum(one.value for one in sides)
    slack = expected.slack("Σmr/m", position=expected.shown) * expected.balance.before.centre.mass
    slack += expected.near * marks.scale(expected.measured, name) + KNOWN * size
    return [one for one in [*sides, Side(RESULT, 0j, whole)] if abs(one.value) > KNOWN * size], slack


def _said(leaf: Leaf, expected: Expected, sides: list[Side]) -> Iterator[Wrong]:
    """See that title and heading say what the polygon is, and that it closes by itself where it does."""
    name, word = static_polygon.NAME, expected.drafting.word
    part = group_named(leaf.groups, name)
    title = f"{word('polygon of static moments')}, {word('position', position=expected.shown)}"
    yield from marks.titled(part, name, title)
    told = " ".join(marks.lettering(part))
    due = {"no vectors": not sides, "closes by itself": bool(sides) and sides[-1].name != RESULT}
    for key, holds in due.items():
        if (Text(0j, word(key)).plain in told) != holds:
            yield on("title", name, text=word(key))


def shaking(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold the hodographs of the main vector: the ends at all positions, the shown vectors, the curves."""
    name = shaking_hodograph.NAME
    if name not in leaf.metadata["figures"]:
        return
    part, mu = group_named(leaf.groups, name), marks.scale(expected.measured, name)
    states = [state for state, one in expected.states.items() if one.shaking > expected.none.force]
    yield from _ends(expected, states, mu)
    yield from _arrows(expected, states, mu)
    for state in states if expected.whole else ():
        yield from _curve(leaf, expected, state, mu)
    if len(states) > 1:
        thin, thick = (group_named(leaf.groups, f"{name}-{state}") for state in (BEFORE, AFTER))
        yield from marks.thinner(thin, thick, name)
    yield from marks.explained(part, name, expected.drafting.word("thin before"), len(states) > 1)
    yield from marks.titled(part, name, expected.drafting.word("shaking hodograph"))
    if part is not None:
        yield from reading.scales(part, {mu})


def _slack(expected: Expected, mu: float) -> float:
    """Give how far a main vector may be off, N."""
    largest = max(one.shaking for one in expected.states.values())
    return max(expected.slack(f"{FORCE}{prime}") for prime in PRIMES.values()) + expected.near * mu + KNOWN * largest


def _ends(expected: Expected, states: Sequence[str], mu: float) -> Iterator[Wrong]:
    """Hold the ends at the positions; those of a curve too small to be numbered may be left out."""
    name, ends = shaking_hodograph.NAME, dict[str, complex]()
    seen = marks.points(expected.measured, name)
    for state in states:
        one = expected.states[state]
        numbered = _spread(one.around.force) >= (NUMBERED + expected.near) * mu
        due = {f"{state} {k}" for k in expected.told} if numbered else set[str]()
        row = {f"{state} {k}": complex(value) for k, value in enumerate(one.centre.force) if cmath.isfinite(value)}
        ends |= {end: value for end, value in row.items() if end in due or end in seen}
    yield from marks.held(seen, ends, name, _slack(expected, mu))


def _arrows(expected: Expected, states: Sequence[str], mu: float) -> Iterator[Wrong]:
    """Hold the vectors in the shown position; one that is too short for an arrow may be left out, one of a gap must."""
    name = shaking_hodograph.NAME
    seen = marks.vectors(expected.measured, name)
    tips = {LETTERS[state]: complex(expected.states[state].centre.force[expected.shown]) for state in states}
    due = {letter: value for letter, value in tips.items() if letter in seen or abs(value) > LEAST * mu}
    yield from marks.held(seen, due, name, _slack(expected, mu))


def _spread(curve: Complexes) -> float:
    """Give how far a curve reaches, N: the larger side of the box about it."""
    known = curve[np.isfinite(curve)]
    return max((float(np.ptp(row)) for row in (known.real, known.imag) if row.size), default=0.0)


def _curve(leaf: Leaf, expected: Expected, state: str, mu: float) -> Iterator[Wrong]:
    """Hold the curve of a state over the turn."""
    name = shaking_hodograph.NAME
    pole = next((one.at - one.value / mu for one in marks.points(expected.measured, name).values()), 0j)
    around = expected.states[state].around.force
    near = expected.slack(f"{FORCE}{PRIMES[state]}", "costs") / mu + expected.near
    chains = marks.lines(group_named(leaf.groups, f"{name}-{state}"))
    places = [[pole + spot / mu for spot in spots] for spots in runs(np.asarray(around))]
    if not marks.goes_through(chains, places, near):
        yield on("path", name, name=state)
