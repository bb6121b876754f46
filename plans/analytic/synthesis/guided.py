"""A rod guided, a function met at points: centres of circles as complex determinants, poles as fixed points (М1.1)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise, product

from plans.model.synthesis.design import Design, TaskReading
from plans.model.synthesis.positions import TIED, TOUCH, TWO, FunctionTask, RodTask, bent, real


def centres(places: Sequence[complex], arm: float | None) -> Iterator[complex]:
    """Give the centre of the circle through three places, or both centres of those of a radius through two.

    From a the centre w of a, a + u, a + v has w u* + w* u = |u|^2, w v* + w* v = |v|^2.
    """
    first = places[0]
    u, v = places[1] - first, places[-1] - first
    if len(places) == TWO:
        assert arm is not None  # asked before
        rise = math.sqrt(max((2 * arm - abs(u)) * (2 * arm + abs(u)), 0.0)) / 2
        if u and rise > TOUCH * arm:
            yield from (first + u / 2 + side * 1j * u / abs(u) * rise for side in (1, -1))
        return
    turned = u.conjugate() * v - u * v.conjugate()
    if bent(places):
        yield first + (abs(u) ** 2 * v - abs(v) ** 2 * u) / turned


def rods(task: RodTask) -> tuple[TaskReading, ...]:
    """Give every four-bar that guides the rod through its positions in their order."""
    kept = "hinges" if task.hinges else "pivots"
    return (TaskReading((kept, *(("arms",) if task.arms else ())), tuple(_rods(task))),)


def _rods(task: RodTask) -> Iterator[Design]:
    known, arms = task.hinges or task.pivots or (), task.arms or (None, None)
    moves = task.moves
    for pair in product(*(_links(task, moves, at, arm) for at, arm in zip(known, arms, strict=True))):
        (pivot, hinges), (other, ends) = pair
        if design := _four_bar(pivot, other, hinges, ends):
            poles = {f"P_{i + 1}{j + 1}": pole(moves[i], moves[j]) for i, j in task.poles}
            turned = _middles("a", hinges) | _middles("b", ends) if task.hinges else {}
            for name, at in zip("OC", task.pivots or (), strict=bool(task.pivots)):
                seen = [(at - shift) / u for u, shift in moves]
                turned |= {f"{name}_{j}": one for j, one in enumerate(seen[1:], 2)} | _middles(name.lower(), seen)
            places = {**design.places, **_numbered("D", task.places), **poles, **turned}
            yield Design(design.sizes, places, merit=design.merit)


def _middles(letter: str, places: Sequence[complex]) -> dict[str, complex]:
    return {f"{letter}_{k}{k + 1}": (one + other) / 2 for k, (one, other) in enumerate(pairwise(places), 1)}


Move = tuple[complex, complex]  # z to u z + shift


def pole(one: Move, other: Move) -> complex:
    """Give the point of the rod that is in one place in two positions: the fixed point of the move between them."""
    turn = other[0] / one[0]
    return (other[1] - turn * one[1]) / (1 - turn)


def _links(
    task: RodTask, moves: Sequence[Move], at: complex, arm: float | None
) -> Iterator[tuple[complex, list[complex]]]:
    """Give the pivots of a hinge, or the hinges of a pivot, each as the pivot and the places of the hinge."""
    if task.hinges:
        places = [turn * at + shift for turn, shift in moves]
        yield from ((centre, places) for centre in centres(places, arm))
        return
    for hinge in centres([(at - shift) / turn for turn, shift in moves], arm):
        yield at, [turn * hinge + shift for turn, shift in moves]


def _four_bar(
    pivot: complex, other: complex, hinges: Sequence[complex], ends: Sequence[complex], letters: str = "φψ"
) -> Design | None:
    """Give the four-bar of two links where OA, by φ, or CB, by ψ, leads it from position to position in their order."""
    lengths = abs(hinges[0] - pivot), abs(ends[0] - hinges[0]), abs(ends[0] - other), abs(other - pivot)
    sizes = dict(zip(("l_1", "l_2", "l_3", "l_4"), lengths, strict=True))
    places = {"O": pivot, "C": other} | _numbered("A", hinges) | _numbered("B", ends)
    for letter in letters if real(lengths) else "":
        leading = (pivot, other, hinges, ends) if letter == "φ" else (other, pivot, ends, hinges)
        if turned := led(*leading):
            angles = ((a - b).conjugate() * (leading[1] - b) for a, b in zip(*leading[2:], strict=True))
            tight = min(math.atan2(abs(one.imag), abs(one.real)) for one in angles)
            told = {f"{letter}_1{k}": turn for k, turn in enumerate(turned[1:], 2)}
            if tight > TOUCH:
                return Design({**sizes, **told, "μ_min": tight}, places, merit=round(tight, TIED))
    return None


def _numbered(letter: str, places: Sequence[complex]) -> dict[str, complex]:
    return {f"{letter}_{k}": at for k, at in enumerate(places, 1)}


def dead(line: complex, crank: float, coupler: float, rocker: float) -> Iterator[float]:
    """Give the angles rad of a crank at which coupler and driven link are in one line, by the cosine rule."""
    frame = abs(line)
    for reach in (coupler + rocker, abs(coupler - rocker)):
        cosine = (crank**2 + frame**2 - reach**2) / (2 * crank * frame)
        if abs(cosine) <= 1:
            yield from (cmath.phase(line) + sense * math.acos(cosine) for sense in (1, -1))


def led(pivot: complex, other: complex, hinges: Sequence[complex], ends: Sequence[complex]) -> list[float] | None:
    """Give the turns rad of a leading link from the first position, in its sense; None where it cannot lead."""
    hands = [((other - a).conjugate() * (b - a)).imag for a, b in zip(hinges, ends, strict=True)]
    if min(hands) < 0 < max(hands):
        return None
    lengths = abs(hinges[0] - pivot), abs(ends[0] - hinges[0]), abs(ends[0] - other)
    barred, first = [*dead(other - pivot, *lengths)], cmath.phase(hinges[0] - pivot)
    steps = [cmath.phase((b - pivot) / (a - pivot)) for a, b in pairwise(hinges)]
    for sense in (1, -1):
        ahead = [sense * step % math.tau for step in steps]
        if min(ahead) > 0 and sum(ahead) < min([math.tau, *(sense * (one - first) % math.tau for one in barred)]):
            return [0.0, *(sense * way for way in accumulate(ahead))]
    return None


def functions(task: FunctionTask) -> tuple[TaskReading, ...]:
    """Give every four-bar whose rocker turns with the crank as asked."""
    return (TaskReading(("crank", "frame", *(("rocker",) if task.rocker else ())), tuple(_functions(task))),)


def _functions(task: FunctionTask) -> Iterator[Design]:
    frame = complex(task.frame)
    pins = [cmath.rect(task.crank, angle) for angle in task.inputs]
    turns = [cmath.rect(1.0, angle - task.outputs[0]) for angle in task.outputs]
    inverted = [frame + (pin - frame) / turn for pin, turn in zip(pins, turns, strict=True)]
    # of two positions the end of the rocker is at its length from C, and as far from both pins
    for end in centres(inverted, None) if task.rocker is None else _beside(inverted, frame, task.rocker):
        ends = [frame + (end - frame) * turn for turn in turns]
        if design := _four_bar(0j, frame, pins, ends, "φ"):
            sizes = {**design.sizes, "ψ_1": cmath.phase(end - frame)}
            seen = {f"A_{k}'": at for k, at in enumerate(inverted[1:], 2)} | _middles("a", inverted)
            yield Design(sizes, {**design.places, **seen}, merit=design.merit)


def _beside(pins: Sequence[complex], pivot: complex, arm: float) -> Iterator[complex]:
    """Give the points at a distance from a pivot and as far from one pin as from another."""
    chord, middle = pins[1] - pins[0], (pins[0] + pins[1]) / 2
    if not chord:
        return
    along = chord / abs(chord)
    off = ((pivot - middle) * along.conjugate()).real  # of the pivot from the line of such points
    rise = math.sqrt(max((arm - off) * (arm + off), 0.0))
    if rise > TOUCH * arm:
        yield from (pivot + along * complex(-off, side * rise) for side in (1, -1))
