"""The draughtsman: the record drawn again by a hand whose every mark on paper is a little out (чертёжник).

Each drawing is a chance one (seeded), many are drawn together. What touches the paper is out by up to `slip` mm to
either side, in x and in y: a pricked point, a ruled line at its start, a compass's opening, a vector carried with the
set square. What is reckoned (a proportion, a turn by a known number) is taken from what is drawn, and adds nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from geometry import meet as loci
from geometry.board import Arc, Line, Mark
from geometry.hand_error import EDGE, pricked_givens
from geometry.meet import cross
from geometry.steps import behind
from plans.bench.error import shares
from plans.bench.truth import MOMENT, Replay, Truth
from plans.model.motion import Complexes, Floats
from plans.model.order import ORDERS

DRAWINGS = 200  # of which 5 % are ten: enough to tell where the worst of them begin
SLIPS = (0.1, 0.2)  # mm: a good hand's and a fair one's
SEED = 1
RATES = {told.key for order in ORDERS[1:] for told in (order.point, order.link)}
TOLD = 0.01  # of the largest: a smaller value has no per cent of itself


@dataclass(frozen=True)
class Draughtsman:
    """A hand that slips: scales of the plans (true units a mm, one for each position), and where chance is."""

    slip: float  # mm
    scales: Mapping[str, Floats]
    drawings: int = DRAWINGS
    chance: np.random.Generator = field(default_factory=lambda: np.random.default_rng(SEED))

    def pricked(self, plan: str) -> Complexes:
        """Give by how much the points pricked on a plan are out, true units, (drawings, positions)."""
        if plan not in self.scales:
            return np.zeros(1, dtype=np.complex128)
        mu = self.scales[plan]
        x, y = self.chance.uniform(-1.0, 1.0, (2, self.drawings, len(mu)))
        return np.asarray(self.slip * mu * (x + 1j * y))

    def carried(self, plan: str, vector: Complexes) -> Complexes:
        """Give by how much vectors are out that were carried away from a plan with set square and dividers."""
        if plan not in self.scales:
            return np.zeros(1, dtype=np.complex128)
        length = np.abs(vector) / self.scales[plan]
        return np.asarray(self.pricked(plan) * np.maximum(length / EDGE, 1.0))


def drawn(replay: Replay, hand: Draughtsman) -> dict[tuple[str, str], Any]:
    """Draw the record by hand; give what is read off the drawings, each (drawings, positions)."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return _read(replay, copies(hand, *replay.wanted), (hand.drawings, len(replay.positions)))


def copies(hand: Draughtsman, *wanted: Mark) -> dict[Mark, Any]:
    """Draw the record behind some marks by hand: where each mark came to lie; a plan without a scale is known."""
    marks = behind(*wanted)
    places, done = pricked_givens(marks), dict[Mark, Any]()
    with np.errstate(invalid="ignore", divide="ignore"):  # loci that the hand made miss each other are NaN
        for mark in marks:
            inputs = [done[source] for source in mark.step.inputs]
            if mark.subject not in hand.scales:
                done[mark] = mark.value
            elif not inputs:
                done[mark] = _given(hand, mark, mark in places)
            else:
                done[mark] = _RULES[mark.step.op](hand, mark, inputs)
    return done


def _read(replay: Replay, done: Mapping[Mark, Any], shape: tuple[int, int]) -> dict[tuple[str, str], Any]:
    found = {key: done[mark] for key, mark in replay.points.items()}
    found |= {("angle", link): np.angle(done[arm] / span) for link, (arm, span) in replay.arms.items()}
    for key, (arm, turning) in replay.rates.items():
        found[key] = cross(done[arm], done[turning]) / np.abs(done[arm]) ** 2
    for key, (mark, sense) in replay.forces.items():
        found[key] = sense * (np.real(done[mark]) if key[0] == MOMENT else done[mark])
    return {key: np.broadcast_to(values, shape) for key, values in found.items()}


def _given(hand: Draughtsman, mark: Mark, place: bool) -> Any:
    """Prick a given point; a pole is where it is, and a given direction is drawn when it is used."""
    if isinstance(mark.value, tuple) or not place or not np.any(mark.point):
        return mark.value
    return mark.point + hand.pricked(mark.subject)


def _laid_off(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    start, vector = inputs
    if not np.any(vector):  # nothing is laid off
        return start
    return start + vector + hand.pricked(mark.subject)


def _ruled(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Line:
    through, along = inputs
    direction = along / np.abs(along)
    return Line(through + hand.pricked(mark.subject), 1j * direction if mark.step.op == "square" else direction)


def _struck(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Arc:
    return Arc(inputs[0], mark.step.size.real + hand.pricked(mark.subject).real)


def _met(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    first, second, side = inputs[0], inputs[1], mark.step.side
    match first, second:
        case Arc(), Arc():
            met = loci.arc_arc(second.centre - first.centre, first.radius, second.radius, side)
            return first.centre + met.first + hand.pricked(mark.subject)
        case Line(), Arc():
            met = loci.line_arc(second.centre - first.through, first.direction, second.radius, side)
        case _:
            met = loci.line_line(second.through - first.through, first.direction, second.direction)
    return first.through + met.first + hand.pricked(mark.subject)


def _tangent(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    base = inputs[1] - inputs[0] + hand.pricked(mark.subject)
    return loci.tangent_direction(base, mark.step.size.real, mark.step.side).first


def _transferred(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    return inputs[0] + hand.carried(mark.step.inputs[0].subject, inputs[0])


def _divided(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    circle, directions = inputs
    return circle.centre + circle.radius * directions + hand.pricked(mark.subject)


def _moment(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    """Measure an arm off the drawing with the ruler."""
    about, at, force = inputs
    return cross(at - about + hand.pricked(mark.step.inputs[0].subject), force)


def _balanced(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    about, line, *moments = inputs
    arm = line.through - about + hand.pricked(mark.step.inputs[0].subject)
    return loci.lever(arm, line.direction, sum(moments)).first


_RULES: dict[str, Callable[[Draughtsman, Mark, Sequence[Any]], Any]] = {
    "lay_off": _laid_off,
    "join": lambda hand, mark, inputs: inputs[1] - inputs[0],
    "parallel": _ruled,
    "square": _ruled,
    "arc": _struck,
    "meet": _met,
    "tangent": _tangent,
    "turn": lambda hand, mark, inputs: inputs[0] * mark.step.size,
    "transfer": _transferred,
    "similar": lambda hand, mark, inputs: inputs[2] * inputs[0] / inputs[1] * mark.step.size,
    "divide": _divided,
    "close": lambda hand, mark, inputs: -sum(inputs),
    "moment": _moment,
    "couple": lambda hand, mark, inputs: (inputs[1] / inputs[0]).imag * mark.step.size,
    "balance": _balanced,
}


@dataclass(frozen=True)
class Toll:
    """What drawing by hand costs in exactness, over many drawings."""

    worst: Floats  # of each drawing, the largest error of all its quantities
    kinds: Mapping[str, Floats]  # the same of each kind of quantity
    single: Floats  # of every v, a, omega, epsilon that is no near zero: its error in shares of itself


def toll(replay: Replay, hand: Draughtsman, truth: Truth, largest: Mapping[str, float]) -> Toll:
    """Draw by hand and hold what is read against the truth."""
    found = drawn(replay, hand)
    off = shares(found, truth, largest)
    kinds = {
        kind: np.max([share.max(axis=1) for key, share in off.items() if key[0] == kind], axis=0)
        for kind in dict.fromkeys(key[0] for key in off)
    }
    return Toll(np.max(list(kinds.values()), axis=0), kinds, _single(off, truth, largest))


def _single(off: Mapping[tuple[str, str], Floats], truth: Truth, largest: Mapping[str, float]) -> Floats:
    """Give the errors of single values in shares of themselves, as a book's printed values are judged."""
    found = []
    for key, share in off.items():
        size = np.abs(truth.values[key].near) / largest[key[0]] if largest[key[0]] else np.zeros(share.shape[1])
        if key[0] in RATES:
            found.append((share[:, size >= TOLD] / size[size >= TOLD]).ravel())
    return np.concatenate(found) if found else np.zeros(0)
