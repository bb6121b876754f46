"""The self-check of the graphs of balancing: the main moment over the turn, the choice of the share (графики)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance.balance_schemes import PRIMES
from drawings.checks.balance.share_level import bare, curve_letter, level, taken
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.precise import KNOWN
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance import moment_graph, share_graph
from drawings.figures.balance.scheme import BEFORE
from drawings.figures.graphs.curve_graph import BEFORE as THIN
from drawings.lettering.words import number
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Group, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import group_named, walk
from drawings.symbols.symbols import TICK
from plans.model.balance.linkage import Choice
from plans.words.words import message

TURN = 360.0  # degrees
SHORT = 0.1  # mm: an ordinate that is shorter may be a point
DIGITS = 4  # of the least values
CROWDED = 6.0  # sizes of a number: two numbers of two figures with a letter's room on both sides of each


def rocking(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold the main moment over the turn: the ordinates, where they stand, the curves before and after."""
    name = moment_graph.NAME
    if name not in leaf.metadata["figures"]:
        return
    part, seen = group_named(leaf.groups, name), marks.vectors(expected.measured, name)
    scales = {} if part is None else written_scales(part)
    mu = marks.scale(expected.measured, name) if seen else scales.get("M", 1.0)
    yield from _ordinates(expected, seen, mu)
    yield from marks.titled(part, name, expected.drafting.word("rocking graph", point=expected.mechanism.drive.pivot))
    yield from _scale(scales, "M", mu, expected)
    yield from _across(scales, "φ")
    if part is None or "φ" not in scales:
        return
    zero = zero_of(expected, seen, scales["φ"]) if seen else corner_of(part)
    yield from _feet(expected, seen, zero, scales["φ"])
    yield from _thin(part, expected)
    for state in expected.states if expected.whole else ():
        yield from _curve(part, expected, state, (zero, scales["φ"], mu))


def crowded(k: int, seen: Mapping[str, MeasuredVector], expected: Expected) -> bool:
    """Tell whether two positions that are drawn leave no room between them for one more that can be numbered."""
    feet = {int(name): one.start.real for name, one in seen.items() if name.isdigit()}
    if len(feet) < 2:
        return False
    first, last, count = min(feet), max(feet), len(expected.balance.before.centre.phi)
    feet[count] = feet[first] + (feet[last] - feet[first]) * (count - first) / (last - first)  # the end of the turn
    below, above = max((n for n in feet if n < k), default=None), min(n for n in feet if n > k)
    return below is not None and feet[above] - feet[below] < CROWDED * expected.drafting.hand.number


def _ordinates(expected: Expected, seen: Mapping[str, MeasuredVector], mu: float) -> Iterator[Wrong]:
    """Hold the ordinates at the positions, those of the state that is told last."""
    own = list(expected.states.values())[-1].centre.moment
    values = np.where(np.abs(own) <= expected.none.moment, 0.0, own)
    largest = max(one.rocking for one in expected.states.values())
    slack = max(expected.slack(f"M_Φ{prime}") for prime in PRIMES.values()) + expected.near * mu + KNOWN * largest
    told = {
        str(k) for k in expected.told if abs(values[k]) > SHORT * mu and not crowded(k, seen, expected)
    } | seen.keys()
    due = {str(k): 1j * float(value) for k, value in enumerate(values) if str(k) in told}
    yield from marks.held(seen, due, moment_graph.NAME, slack)


def _thin(part: Group, expected: Expected) -> Iterator[Wrong]:
    """See that the curve before is the thinner one, and that this is said where there are two."""
    name, both = moment_graph.NAME, expected.whole and len(expected.states) > 1
    thin, thick = (Group(tuple(_apart(part, before))) for before in (True, False))
    yield from marks.thinner(thin, Group(_long(thick)), name) if both else ()
    yield from marks.explained(part, name, expected.drafting.word("thin before"), both)


def _across(scales: Mapping[str, float], letter: str) -> Iterator[Wrong]:
    """See that the scale of the axis across is written, by which all that stands along it is held."""
    if letter not in scales:
        yield message("wrong.scale", text=f"μ_{letter}")


def _scale(scales: Mapping[str, float], letter: str, mu: float, expected: Expected) -> Iterator[Wrong]:
    """See that the written scale is the one that the marks are drawn to."""
    language = expected.drafting.language
    if number(scales.get(letter, 0.0), language) != number(mu, language):
        yield message("wrong.scale", text=f"μ_{letter}")


def stations_of(expected: Expected) -> list[float]:
    """Give the angles of the positions from position 0 on in the sense of rotation, degrees."""
    phi = expected.balance.before.centre.phi
    return [float(one) for one in np.degrees(expected.own.linkage.sense * (phi - phi[0])) % TURN]


def zero_of(expected: Expected, seen: Mapping[str, MeasuredVector], mu: float) -> complex:
    """Give the place on paper of position 0, by an ordinate that is there."""
    name, one = next(iter(seen.items()))
    return one.start - stations_of(expected)[int(name)] / mu


def corner_of(part: Group) -> complex:
    """Give the place on paper of position 0, by the axis of the angle: no ordinate of a moment that is 0 is there."""
    axes = [one for one in part.strokes if isinstance(one, Line) and one.start.imag == one.end.imag]
    return max(axes, key=lambda one: abs(one.end - one.start)).start if axes else 0j


def _feet(expected: Expected, seen: Mapping[str, MeasuredVector], zero: complex, mu: float) -> Iterator[Wrong]:
    """See that each ordinate stands at the angle of its position; a crank that swings begins anywhere in the turn."""
    stations = stations_of(expected)
    for name, one in seen.items():
        off = one.start - zero - stations[int(name)] / mu
        turns = round(off.real * mu / TURN)
        if not abs(off - turns * TURN / mu) <= expected.near + KNOWN * TURN / mu:
            yield on("foot", moment_graph.NAME, name=name)


def _apart(part: Group, before: bool) -> Iterator[Stroke]:
    """Give the strokes of the thin curve, or all others."""
    return (one for one in part.strokes if (isinstance(one, Group) and one.name == THIN) == before)


def _long(part: Group) -> tuple[Stroke, ...]:
    """Give the longest chain of a part: the curve."""
    chains = (one for one in walk((part,)) if isinstance(one, Polyline))
    return tuple(sorted(chains, key=lambda one: len(one.points))[-1:])


def _curve(part: Group, expected: Expected, state: str, axes: tuple[complex, float, float]) -> Iterator[Wrong]:
    """See that a curve goes through every moment of a turn without gaps: the thin one of the state before."""
    zero, across, up = axes
    around, name = expected.states[state].around, moment_graph.NAME
    before = state == BEFORE and len(expected.states) > 1
    chains = marks.lines(Group(tuple(_apart(part, before))))
    if np.isnan(around.moment).any():
        return  # beside a gap the curve is cut off where it outgrows its positions
    angles = np.degrees(expected.own.linkage.sense * (around.phi - around.phi[0]))
    moments = np.where(np.abs(around.moment) <= expected.none.moment, 0.0, around.moment)
    spots = [zero + angle / across + 1j * moment / up for angle, moment in zip(angles, moments, strict=True)]
    near = expected.slack(f"M_Φ{PRIMES[state]}", "costs") / up + 2 * expected.near + KNOWN * TURN / across
    longest = [chain for chain in chains if len(chain) > len(spots) / 2]
    if not marks.follows(longest, spots, near):
        yield on("path", name, name=state)


def shares(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold the choice of the share: both curves, their least places as drawn and lettered, the share that is taken."""
    name, found = share_graph.NAME, expected.balance.shares
    if name not in leaf.metadata["figures"] or found is None:
        return
    part, seen = group_named(leaf.groups, name), marks.vectors(expected.measured, name)
    best = {share_graph.FORCES: found.least_force, share_graph.REACTIONS: found.least_reaction}
    mu = marks.scale(expected.measured, name)
    yield from _least(expected, seen, best, mu)
    yield from marks.titled(part, name, expected.drafting.word("share graph"))
    scales = {} if part is None else written_scales(part)
    yield from _scale(scales, "F", mu, expected)
    yield from _across(scales, "k")
    if part is None or not seen or "k" not in scales:
        return
    kind, one = next(iter(seen.items()))
    zero = one.start - best[kind].share / scales["k"]
    for kind, choice in best.items():
        spots = [zero + each.share / scales["k"] + 1j * value_of(each, kind) / mu for each in found.curve]
        yield from _choice(leaf, part, expected, kind, choice, (zero, scales["k"], mu), spots)
    yield from _divisions(part, expected, zero, scales["k"])
    yield from _levels(part, expected, zero, mu)
    yield from taken(leaf, expected, zero, scales["k"])
    yield from level(leaf, part, expected, zero, (scales["k"], mu))


def _least(
    expected: Expected, seen: Mapping[str, MeasuredVector], best: Mapping[str, Choice], mu: float
) -> Iterator[Wrong]:
    """Hold the ordinates of the least values; one no longer than a tick may be left out."""
    due = {kind: 1j * value_of(one, kind) for kind, one in best.items()}
    slack = expected.near * mu + KNOWN * max(abs(value) for value in due.values())
    due = {kind: value for kind, value in due.items() if kind in seen or abs(value) > (TICK + expected.near) * mu}
    yield from marks.held(seen, due, share_graph.NAME, slack)


def value_of(one: Choice, kind: str) -> float:
    """Give what is largest with a share, N."""
    return one.force if kind == share_graph.FORCES else one.reaction


def _choice(
    leaf: Leaf, part: Group, expected: Expected, kind: str, best: Choice,
    axes: tuple[complex, float, float], spots: Sequence[complex],
) -> Iterator[Wrong]:  # fmt: skip
    """Hold a curve through all its shares, where its least value stands, and what is lettered there."""
    zero, across, up = axes
    name, near = share_graph.NAME, 2 * expected.near
    lowest = zero + best.share / across + 1j * value_of(best, kind) / up
    row = sorted([*spots, lowest], key=lambda spot: spot.real)
    corners = [spot for chain in marks.lines(group_named(leaf.groups, f"{name}-{kind}")) for spot in chain]
    if not corners or any(min(abs(spot - corner) for corner in corners) > near for spot in row):
        yield on("path", name, name=kind)
    one = marks.vectors(expected.measured, name).get(kind)
    if one is not None and not abs(one.start - zero - best.share / across) <= near + KNOWN / across:
        yield on("foot", name, name=kind)
    letter = curve_letter(expected, kind)
    if not _lettered(part, letter, row[-1]):
        yield on("letter", name, name=kind)
    if not any(tells(text, letter, best, kind, expected) for text in marks.lettering(part)):
        yield on("letter", name, name=kind)


def _lettered(part: Group, letter: str, spot: complex) -> bool:
    """Tell whether a letter stands beside a spot."""
    return distance(labels_of((part,)).get(Text(0j, letter).plain, ()), [spot]) <= NEAREST


def _divisions(part: Group, expected: Expected, zero: complex, across: float) -> Iterator[Wrong]:
    """See that the axis of the share is numbered rightly."""
    for k in range(share_graph.DIVISIONS + 1):
        share = k / share_graph.DIVISIONS
        if not _lettered(part, expected.drafting.number(share), zero + share / across):
            yield on("letter", share_graph.NAME, name=expected.drafting.number(share))


def _levels(part: Group, expected: Expected, zero: complex, up: float) -> Iterator[Wrong]:
    """See that the axis of forces is numbered rightly, up to the largest force that the graph shows."""
    name, found, step = share_graph.NAME, expected.balance.shares, share_graph.LEVEL * up
    assert found is not None  # asked before
    curves = (value_of(one, kind) for one in found.curve for kind in (share_graph.FORCES, share_graph.REACTIONS))
    high = max(bare(expected), *curves)
    for k in range(1, int(high * (1 - KNOWN) / step) + 1):
        if not _lettered(part, expected.drafting.number(k * step), zero + 1j * share_graph.LEVEL * k):
            yield on("letter", name, name=expected.drafting.number(k * step))


def tells(text: str, letter: str, best: Choice, kind: str, expected: Expected) -> bool:
    """Tell whether a text gives the least value and the share of it."""
    told, _, share = text.removeprefix(f"{Text(0j, letter).plain} = ").partition(f";  {share_graph.SHARE} = ")
    size, _, unit = told.partition(" ")
    if told == text or unit != Text(0j, expected.drafting.word("N")).plain:
        return False
    largest = value_of(best, kind)
    return reads(share, best.share, KNOWN, DIGITS) and reads(size, largest, KNOWN * largest, DIGITS)
