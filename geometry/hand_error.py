"""What a drawing made by hand may be out: the slips of its acts, carried through the record (точность от руки).

Whatever touches the paper is out by up to `slip` mm to either side, evenly, in x and in y: a pricked point, a ruled
line at its start, a compass's opening, a vector carried with the set square, a measured arm. What is reckoned (a
proportion, a turn by a known number) adds nothing. Each slip is a source of its own; a mark's slopes tell how far each
of them moves it, so that errors which come from one slip are added as they are, and all others as chance adds them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Arc, Line, Mark, behind, between, held_leads
from geometry.meet import cross, dot

Slopes = npt.NDArray[np.complex128]  # (sources, N): by the standard deviation of each slip
Sizes = npt.NDArray[np.float64]

SURE, POINT = 0.95, 1.959964  # the share of all drawings that is told of, and the deviations that hold so many
FLAT = 0.1481, 0.1664  # of the cubic in the fourth moment


def number_error(moved: Slopes) -> Sizes:
    """Give within what 95 per cent of the drawings are of a number that the slips move so, (N,)."""
    slips = np.real(moved)
    return np.asarray(_point(slips) * np.sqrt((slips**2).sum(axis=0)))


def size_error(vector: npt.NDArray[np.complex128], moved: Slopes) -> Sizes:
    """Give within what 95 per cent of the drawings are of the size of a vector, (N,); of a vector 0, of its place.

    A vector that is no longer than its error is looked at in a whole cloud of its ends, spread as the slips spread it.
    """
    across = np.sqrt((moved.real**2).sum(axis=0))
    skew = np.divide((moved.real * moved.imag).sum(axis=0), across, out=np.zeros_like(across), where=across != 0)
    up = np.sqrt(np.maximum((moved.imag**2).sum(axis=0) - skew**2, 0.0))
    ends = vector + _CLOUD.real[:, None] * (across + 1j * skew) + 1j * _CLOUD.imag[:, None] * up
    off = np.partition(np.abs(np.abs(ends) - np.abs(vector)), _TOLD, axis=0)[_TOLD]
    return np.asarray(off * _point(np.asarray(dot(np.asarray(vector), moved))) / POINT)


def _point(slips: Sizes) -> Sizes:
    """Give within how many standard deviations of a sum of slips 95 per cent of it are.

    Of many slips they are 1.960, of one alone, which is even within its bounds, 0.95 sqrt 3. Between them it hangs on
    the fourth moment: a cubic through the exact values of one, of three alike and of many, which gives that of two
    alike, 1.9016, and of one with another half as large, 1.834, to 0.3 per cent.
    """
    square = (slips**2).sum(axis=0)
    flat = np.divide((slips**4).sum(axis=0), square**2, out=np.zeros_like(square), where=square != 0)
    return np.asarray(POINT - FLAT[0] * flat**2 - FLAT[1] * flat**3)


_CHANCES = 1000  # points of a cloud
_TOLD = round(SURE * _CHANCES) - 1  # the one of them, by its size, that is told of: 50 lie beyond it


def _cloud(count: int) -> npt.NDArray[np.complex128]:
    """Give points spread about zero as chance spreads them, yet evenly: radii by rank, angles as in a sunflower."""
    rank = (np.arange(count) + 0.5) / count
    return np.asarray(np.sqrt(-2 * np.log1p(-rank)) * np.exp(1j * np.pi * (3 - np.sqrt(5.0)) * np.arange(count)))


_CLOUD = _cloud(_CHANCES)


EDGE = 100.0  # mm of a set square's edge that lies along a line: a longer line is carried no more truly
EVEN = 1 / np.sqrt(3.0)  # standard deviation of what is evenly within 1 to either side
# Where the slips may change by more than this share what is divided by, such as the sine of a meeting, the error is no
# longer in proportion to them: what is left out of it is the square of the share, a tenth. A dead centre is near.
BENT = float(np.sqrt(0.1))
# mm: a vector that is no longer is not laid off. Rounding makes some 1e-12 of a zero; a hand sees nothing of either.
NOTHING = 1e-6

# Which inputs of a verb are places on the paper, where a given point must have been pricked.
PLACES: Mapping[str, tuple[int, ...]] = {
    "lay_off": (0,), "join": (0, 1), "parallel": (0,), "square": (0,), "arc": (0,), "tangent": (0, 1),
    "moment": (0, 1), "balance": (0,), "settle": (0, 1, 2),
}  # fmt: skip
RECKONED = {"join", "turn", "similar", "close", "couple", "direct"}  # verbs that touch no paper
SLIPS = {"settle": 3, **dict.fromkeys(RECKONED, 0)}  # of verbs that do not slip once


class SlippingHand(NamedTuple):
    """A hand that slips: by how many mm at most, and the scales of the plans it draws, true units a mm, (N,).

    A plan without a scale is not drawn: what stands on it is known.
    """

    slip: float
    scales: Mapping[str, Sizes]


def pricked_givens(marks: Sequence[Mark]) -> set[Mark]:
    """Give the marks whose places on the paper others are drawn from."""
    return {mark.step.inputs[k] for mark in marks for k in PLACES.get(mark.step.op, ())}


def is_nothing(mark: Mark, scale: Sizes) -> bool:
    """Tell whether a vector, or a place from its pole, is nothing at a scale but rounding, in every position."""
    return bool(np.all(np.abs(mark.point) <= NOTHING * scale))


def slopes(hand: SlippingHand, *marks: Mark) -> dict[Mark, Slopes]:
    """Give how far each slip of a hand moves each mark behind some marks; NaN where that is not in proportion.

    >>> from geometry.board import Board
    >>> board = Board("positions")
    >>> end = board.lay_off("B", board.given("A", 0j), board.given("AB", 5 + 0j))
    >>> found = slopes(SlippingHand(0.2, {"positions": np.ones(1)}), end)[end]
    >>> round(float((np.abs(found) ** 2).sum()) / 0.2**2, 12)  # a third in x, a third in y
    0.666666666667
    """
    record = behind(*marks)
    drawing = _HandRecord(hand, sum(SLIPS.get(mark.step.op, 1) for mark in record))
    places = pricked_givens(record)
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN inside, a dead centre infinite
        for mark in record:
            drawing.carry(mark, mark in places)
    return {mark: moved.place[: drawing.sources] for mark, moved in drawing.done.items()}


class _Moved(NamedTuple):
    """How far the slips move a mark: its point or vector, and a line's direction, rad, or an arc's radius."""

    place: Slopes
    turn: Sizes | float = 0.0


class _HandRecord:
    """A record on its way through the hand: what each mark is moved by, and the slips made so far."""

    def __init__(self, hand: SlippingHand, acts: int) -> None:
        self.hand, self.most, self.sources = hand, 2 * acts, 0
        self.count = max((len(row) for row in hand.scales.values()), default=1)
        self.done: dict[Mark, _Moved] = {}

    def carry(self, mark: Mark, place: bool) -> None:
        """Carry the slips through the act that drew a mark."""
        if mark.subject not in self.hand.scales:
            self.done[mark] = _Moved(self.still())
        elif not mark.step.inputs:
            free = isinstance(mark.value, tuple) or is_nothing(mark, self.hand.scales[mark.subject])
            self.done[mark] = _Moved(self.slip(mark.subject) if place and not free else self.still())
        else:
            self.done[mark] = _RULES[mark.step.op](self, mark, [self.done[source] for source in mark.step.inputs])

    def still(self) -> Slopes:
        """Give the slopes of what does not move."""
        return np.zeros((self.most, self.count), dtype=np.complex128)

    def slip(self, plan: str, times: Sizes | float = 1.0, *, both: bool = True) -> Slopes:
        """Slip once more on a plan: in x and in y, or along one line."""
        found = self.still()
        found[self.sources] = EVEN * self.hand.slip * np.asarray(self.hand.scales.get(plan, 0.0)) * times
        if both:
            found[self.sources + 1] = 1j * found[self.sources]
        self.sources += 2
        return found

    def firm(self, divisor: npt.NDArray[np.complex128] | Sizes, moved: Slopes) -> Sizes | Slopes:
        """Give what is divided by; NaN where the slips may change it too much."""
        bent = POINT * np.sqrt((np.abs(moved) ** 2).sum(axis=0)) > BENT * np.abs(divisor)
        return np.asarray(np.where(bent, np.nan, divisor))


def _laid_off(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    start, vector = inputs
    if is_nothing(mark.step.inputs[1], drawing.hand.scales[mark.subject]):
        return start
    return _Moved(start.place + vector.place + drawing.slip(mark.subject))


def _ruled(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    through, along = inputs
    vector = drawing.firm(np.asarray(mark.step.inputs[1].point), along.place)
    return _Moved(through.place + drawing.slip(mark.subject), (along.place / vector).imag)


def _struck(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    return _Moved(inputs[0].place, drawing.slip(mark.subject, both=False).real)


def _met(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    """Solve for the meeting that keeps on both loci: each says how far it is moved square to itself."""
    pairs = zip(mark.step.inputs, inputs, mark.rays, strict=True)
    (along, first), (other, second) = (_pushed(locus, moved, np.asarray(ray)) for locus, moved, (_, ray) in pairs)
    sine = np.asarray(cross(along, other))
    place = 1j * (along * second - other * first) / sine
    turned = [_turned(*row, place) for row in zip(mark.step.inputs, inputs, mark.rays, strict=True)]
    firm = drawing.firm(sine, np.asarray(dot(along, other) * (turned[1] - turned[0]), dtype=np.complex128))
    return _Moved(np.where(np.isnan(firm), np.nan, place) + drawing.slip(mark.subject))


def _pushed(locus: Mark, moved: _Moved, ray: npt.NDArray[np.complex128]) -> tuple[npt.NDArray[np.complex128], Sizes]:
    """Give the unit normal of a locus where it meets, and how far it is moved along it there."""
    if isinstance(locus.value, Arc):
        normal = ray / np.abs(ray)
        return normal, np.asarray(dot(normal, moved.place) + moved.turn)
    along = _direction(locus)
    return 1j * along, np.asarray(dot(1j * along, moved.place) + dot(along, ray) * moved.turn)


def _turned(locus: Mark, moved: _Moved, ray: tuple[Mark, object], place: Slopes) -> Sizes:
    """Give by how much the normal of a locus turns where it meets, rad."""
    if isinstance(locus.value, Line):
        return np.asarray(moved.turn)
    return ((place - moved.place) / np.asarray(ray[1], dtype=np.complex128)).imag


def _direction(line: Mark) -> npt.NDArray[np.complex128]:
    assert isinstance(line.value, Line)  # asked of lines alone
    vector = np.asarray(line.value.direction)
    return np.asarray(vector / np.abs(vector))


def _tangent(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    unit, base = np.asarray(mark.point), np.asarray(between(*mark.step.inputs))
    moved = inputs[1].place - inputs[0].place + drawing.slip(mark.subject)
    reach = drawing.firm(np.asarray(dot(unit, base)), moved)
    return _Moved(1j * unit * cross(unit, moved) / reach)


def _settled(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    """Carry what moves the beginnings of the leads, and a slip of each length, by what a length moves the body."""
    place, turn = drawing.still(), drawing.still().real
    for lead in held_leads(mark):
        out = dot(lead.along, inputs[lead.begin].place) + lead.sense * drawing.slip(mark.subject, both=False).real
        if lead.way is not None:
            out = out - dot(1j * inputs[lead.way].place, lead.arm)
        place, turn = place + lead.shift * out, turn + lead.spin * out
    firm = drawing.firm(np.asarray(mark.sharpness), np.asarray(turn, dtype=np.complex128))
    return _Moved(np.where(np.isnan(firm), np.nan, place), turn)


def _transferred(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    plan = mark.step.inputs[0].subject
    mu = np.asarray(drawing.hand.scales.get(plan, np.inf))
    return _Moved(inputs[0].place + drawing.slip(plan, np.maximum(np.abs(mark.point) / mu / EDGE, 1.0)))


def _similar(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    image, of, shape = (np.asarray(source.point) for source in mark.step.inputs)
    firm = drawing.firm(of, inputs[1].place)
    ratio = image / firm
    grown = ratio * inputs[2].place + shape / firm * (inputs[0].place - ratio * inputs[1].place)
    return _Moved(np.asarray(mark.step.size) * grown)


def _divided(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    circle, directions = mark.step.inputs
    radius = circle.value.radius if isinstance(circle.value, Arc) else 0.0
    moved = inputs[0].place + np.asarray(directions.point) * inputs[0].turn + radius * inputs[1].place
    return _Moved(moved + drawing.slip(mark.subject))


def _moment(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    about, at, force = mark.step.inputs
    arm = inputs[1].place - inputs[0].place + drawing.slip(about.subject)
    found = cross(arm, np.asarray(force.point)) + cross(np.asarray(between(about, at)), inputs[2].place)
    return _Moved(np.asarray(found, dtype=np.complex128))


def _couple(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    arm, turning = (np.asarray(source.point) for source in mark.step.inputs)
    firm = drawing.firm(arm, inputs[0].place)
    grown = (inputs[1].place - turning / firm * inputs[0].place) / firm
    return _Moved(np.asarray(np.real(mark.step.size) * grown.imag, dtype=np.complex128))


def _balanced(drawing: _HandRecord, mark: Mark, inputs: list[_Moved]) -> _Moved:
    about, line = mark.step.inputs[:2]
    unit, base = _direction(line), np.asarray(between(about, line.step.inputs[0]))
    arm = inputs[1].place - inputs[0].place + drawing.slip(about.subject)
    moved = np.asarray(cross(arm, unit) + dot(base, unit) * inputs[1].turn, dtype=np.complex128)
    lever = drawing.firm(np.asarray(cross(base, unit)), moved)
    size = dot(unit, np.asarray(mark.point))
    total = sum((moved.place for moved in inputs[2:]), drawing.still())
    return _Moved(unit * (-(total + size * moved) / lever + 1j * size * inputs[1].turn))


_RULES: dict[str, Callable[[_HandRecord, Mark, list[_Moved]], _Moved]] = {
    "lay_off": _laid_off,
    "join": lambda _, mark, inputs: _Moved(inputs[1].place - inputs[0].place),
    "parallel": _ruled,
    "square": _ruled,
    "arc": _struck,
    "meet": _met,
    "tangent": _tangent,
    "settle": _settled,
    "direct": lambda _, mark, inputs: _Moved(1j * np.asarray(mark.point) * inputs[0].turn),
    "turn": lambda _, mark, inputs: _Moved(np.asarray(mark.step.size) * inputs[0].place),
    "transfer": _transferred,
    "similar": _similar,
    "divide": _divided,
    "close": lambda drawing, mark, inputs: _Moved(-sum((moved.place for moved in inputs), drawing.still())),
    "moment": _moment,
    "couple": _couple,
    "balance": _balanced,
}
