"""The draughtsman: the record drawn again by a hand whose every mark on paper is a little out (чертёжник).

Each drawing is a chance one (seeded), many are drawn together. What touches the paper is out by up to `slip` mm to
either side, in x and in y: a pricked point, a ruled line at its start, a compass's opening, a vector carried with the
set square. What is reckoned (a proportion, a turn by a known number) is taken from what is drawn, and adds nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from geometry import meet as loci
from geometry.board import Arc, Line, Mark, behind
from geometry.hand_error import EDGE, EVEN, Sizes, SlippingHand, Slopes, is_nothing, pricked_givens
from geometry.meet import cross
from geometry.three_leads import ROUNDS, BodyPose, HeldBody

Complexes = npt.NDArray[np.complex128]

DRAWINGS = 200  # of which 5 % are ten: enough to tell where the worst of them begin
SEED = 1
SMALL = 1e-5  # of a slip: a displacement so small that its square is lost, and still a million roundings


class Chance(Protocol):
    """What says by how much of a slip each mark is out."""

    def uniform(self, low: float, high: float, size: tuple[int, ...], /) -> Sizes:
        """Give numbers between two bounds."""


@dataclass(frozen=True)
class Draughtsman:
    """A hand that slips: scales of the plans (true units a mm, one for each position), and where chance is."""

    slip: float  # mm
    scales: Mapping[str, Sizes]
    drawings: int = DRAWINGS
    chance: Chance = field(default_factory=lambda: np.random.default_rng(SEED))

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


def copies(hand: Draughtsman, *wanted: Mark) -> dict[Mark, Any]:
    """Draw the record behind some marks by hand: where each mark came to lie; a plan without a scale is known."""
    marks = behind(*wanted)
    places, done = pricked_givens(marks), dict[Mark, Any]()
    with np.errstate(invalid="ignore", divide="ignore"):  # loci that the hand made miss each other are NaN
        for mark in marks:
            inputs = [done[source] for source in mark.step.inputs]
            if mark.subject not in hand.scales:
                done[mark] = _known(mark)
            elif not inputs:
                done[mark] = _given(hand, mark, mark in places)
            else:
                done[mark] = _RULES[mark.step.op](hand, mark, inputs)
    return done


def slopes(hand: SlippingHand, *wanted: Mark) -> dict[Mark, Slopes]:
    """Give how far each slip of a hand moves each mark, as `hand_error.slopes` does: each slip tried by itself."""
    counter = _OneByOne(0)
    true = copies(Draughtsman(0.0, hand.scales, 1, counter), *wanted)
    tried = Draughtsman(hand.slip * SMALL, hand.scales, max(2 * counter.slips, 1), _OneByOne(0))
    moved = copies(tried, *wanted)
    shape = tried.drawings, max(map(len, hand.scales.values()), default=1)
    with np.errstate(invalid="ignore"):
        return {
            mark: np.broadcast_to(EVEN / SMALL * (moved[mark] - true[mark]), shape).astype(np.complex128)
            for mark in true
            if not isinstance(mark.value, tuple)
        }


class _OneByOne:
    """Slips of which each drawing has one alone, in x or in y."""

    def __init__(self, slips: int) -> None:
        self.slips = slips

    def uniform(self, low: float, high: float, size: tuple[int, ...], /) -> Sizes:
        """Let the next two drawings slip, the one in x and the other in y."""
        found = np.zeros(size)
        if size[1] > 1:
            found[0, 2 * self.slips], found[1, 2 * self.slips + 1] = high, high
        self.slips += 1
        return found


def _known(mark: Mark) -> Any:
    """Give what stands on a plan that is not drawn by hand."""
    if isinstance(mark.value, Line):
        return Line(mark.value.through, mark.value.direction / np.abs(mark.value.direction))
    return mark.value


def _given(hand: Draughtsman, mark: Mark, place: bool) -> Any:
    """Prick a given point; a pole is where it is, and a given direction is drawn when it is used."""
    if isinstance(mark.value, tuple) or not place or is_nothing(mark, hand.scales[mark.subject]):
        return mark.value
    return mark.point + hand.pricked(mark.subject)


def _laid_off(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> Any:
    start, vector = inputs
    if is_nothing(mark.step.inputs[1], hand.scales[mark.subject]):  # whatever the slips before would make of it
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


class _Settled(np.ndarray[Any, np.dtype[np.complex128]]):
    """Where a body was settled, with its direction."""

    turn: Complexes


def _settled(hand: Draughtsman, mark: Mark, inputs: Sequence[Any]) -> _Settled:
    """Settle a body on leads whose lengths are a little out."""
    settling, met = mark.step.settling, mark.meeting
    assert settling is not None and met is not None  # it was settled
    leads = [lead._replace(size=lead.size + hand.pricked(mark.subject).real) for lead in settling.body.leads]
    body, known = HeldBody((leads[0], leads[1], leads[2])), settling.known(inputs[:-1])
    pose = BodyPose(met.first, met.second)
    for _ in range(ROUNDS):
        held = body.held(known, pose)
        moves = [(miss * shift, miss * turn) for miss, (shift, turn) in zip(held.misses, held.moves, strict=True)]
        shift, turn = (sum(row) for row in zip(*moves, strict=True))
        pose = BodyPose(pose.reach - shift, pose.turn * np.exp(-1j * turn))
    found = np.asarray(inputs[0] + pose.reach).view(_Settled)
    found.turn = pose.turn
    return found


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
    "settle": _settled,
    "direct": lambda hand, mark, inputs: inputs[0].turn,
    "turn": lambda hand, mark, inputs: inputs[0] * mark.step.size,
    "transfer": _transferred,
    "similar": lambda hand, mark, inputs: inputs[2] * inputs[0] / inputs[1] * mark.step.size,
    "divide": _divided,
    "close": lambda hand, mark, inputs: -sum(inputs),
    "moment": _moment,
    "couple": lambda hand, mark, inputs: (inputs[1] / inputs[0]).imag * mark.step.size,
    "balance": _balanced,
}
