"""The one list of quantities: each by both roads, their comparison, the gaps that one road alone names (величины)."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple, Protocol, Self, TypeAlias

import numpy as np

from geometry.board import Mark, Reading, Span, between
from geometry.hand_error import SlippingHand, Slopes, number_error, size_error, slopes
from plans.model.motion import Complexes, Floats, Gap
from plans.words.words import Message, message


def plain(values: Any) -> list[float | None]:
    """Give numbers, null for NaN and for what is infinite, and no -0."""
    return [value if math.isfinite(value) else None for value in (values + 0.0).tolist()]


def pairs(values: Any) -> list[list[float] | None]:
    """Give vectors as [x, y], null for NaN."""
    both = zip((values.real + 0.0).tolist(), (values.imag + 0.0).tolist(), strict=True)
    return [None if math.isnan(x) or math.isnan(y) else [x, y] for x, y in both]


def gap_numbers(gap: Gap) -> dict[str, Any]:
    """Give a gap as plain data."""
    return {**gap._asdict(), "where": str(gap.where), "advice": str(gap.advice)}


EQUILIBRIUM = "equilibrium"  # by what sums that must vanish are told: no plan draws them
Shown: TypeAlias = Span | Reading | Mark  # a vector between two marks, a rate, a force or a moment


class Quantity(NamedTuple):
    """One quantity over all positions by both roads, with the allowed difference; NaN at gaps.

    What the construction shows of it is what `explain` tells the steps of, and what a hand may be out in.
    """

    plan: str
    name: str  # "v_B", "ω_3"
    unit: str
    construction: Complexes | Floats
    analysis: Complexes | Floats
    difference: Floats
    allowed: Floats
    largest: float  # the largest of its kind on the plan, over all positions
    shown: Shown | None = None

    @classmethod
    def of(
        cls,
        named: tuple[str, str, str],
        pair: tuple[Any, Any],
        allowed: Floats | float,
        largest: float | None = None,
        shown: Shown | None = None,
    ) -> Self:
        """Put a quantity by both roads beside each other, by plan, name and unit: a value, or one for each position."""
        ours, theirs = map(np.atleast_1d, pair)
        off = np.asarray(np.abs(ours - theirs), dtype=float)
        most = float(np.nanmax(np.abs(theirs), initial=0.0)) if largest is None else largest
        return cls(*named, ours, theirs, off, np.broadcast_to(allowed, off.shape), most, shown)

    @classmethod
    def vanishing(cls, name: str, unit: str, left: Any, allowed: Floats | float, largest: float) -> Self:
        """Put the size of a sum that must vanish beside the zero that it must be."""
        return cls.of((EQUILIBRIUM, name, unit), (left, 0.0 * left), allowed, largest)

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks that show it, if any."""
        return (self.shown,) if isinstance(self.shown, Mark) else tuple(self.shown or ())

    @property
    def excess(self) -> Floats:
        """The difference in units of the allowed one; an undetermined comparison counts as infinite."""
        with np.errstate(divide="ignore", invalid="ignore"):
            share = np.where(self.difference == 0, 0.0, self.difference / self.allowed)
        gap = np.isnan(np.abs(self.construction)) & np.isnan(np.abs(self.analysis))
        return np.where(gap, 0.0, np.where(np.isnan(share), np.inf, share))

    @property
    def per_cent(self) -> float:
        """The worst difference in per cent of the plan's largest."""
        if not np.isfinite(self.difference).any() or self.largest == 0:
            return 0.0
        return float(100 * np.nanmax(self.difference) / self.largest)


class Numbers(NamedTuple):
    """What a technique found by one road as plain data, and whether some of it has no numbers."""

    data: dict[str, Any]
    flawed: bool = False

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        return self.data


def numbers_of(found: Iterable[Quantity], by: str) -> dict[str, Any]:
    """Give quantities by a road as plain data, by their names: a value, or one for each position."""
    roads = {finding.name: finding.analysis if by == "analysis" else finding.construction for finding in found}
    rows = {name: pairs(values) if np.iscomplexobj(values) else plain(values) for name, values in roads.items()}
    return {name: row if len(row) > 1 else row[0] for name, row in rows.items()}


class Stated(Protocol):
    """What a technique found by one road."""

    @property
    def flawed(self) -> bool: ...  # noqa: D102
    def plain(self) -> dict[str, Any]: ...  # noqa: D102


class Road(Protocol):
    """What one road found: by which it was found, and where it finds nothing."""

    @property
    def by(self) -> str: ...  # noqa: D102
    @property
    def unanswered(self) -> tuple[Gap, ...]: ...  # noqa: D102


class Lone(NamedTuple):
    """A gap that one road alone names, or for another reason than the other."""

    by: str
    gap: Gap


@dataclass(frozen=True, eq=False, repr=False)
class Comparison:
    """What one technique found by both roads, and the findings of their comparison."""

    construction: Any
    analysis: Any
    findings: tuple[Quantity, ...]
    motion: "Comparison | None" = field(default=None, kw_only=True)  # that it rests on

    def of(self, plan: str) -> tuple[Quantity, ...]:
        """Give the findings of one plan."""
        return tuple(finding for finding in self.findings if finding.plan == plan)

    @property
    def worst(self) -> float:
        """The largest difference in units of its allowed one."""
        return max((float(np.max(finding.excess)) for finding in self.findings), default=0.0)

    @property
    def apart(self) -> Message:
        """Say in what the two roads differ most."""
        worst = self.foremost
        return message("check.differ", name=worst.name, times=f"{float(worst.excess.max()):.3g}")

    @property
    def foremost(self) -> Quantity:
        """The finding with the largest difference in units of its allowed one."""
        return max(self.findings, key=lambda finding: float(finding.excess.max()))

    @property
    def alone(self) -> tuple[Lone, ...]:
        """Gaps that one road names and the other does not, or for another reason."""
        return (*_alone(self.construction, self.analysis), *_alone(self.analysis, self.construction))

    @property
    def left_out(self) -> dict[str, list[int]]:
        """Positions left out of the comparison, as both roads give them up, by the first plan that has none of them."""
        found: dict[str, list[int]] = {}
        for gap in self.construction.unanswered:
            found.setdefault(gap.plan, []).append(gap.position)
        return found

    @property
    def agrees(self) -> bool:
        """Whether every difference is within its allowed one, and both roads name the same gaps, over one motion."""
        return self.worst <= 1.0 and not self.alone and (self.motion is None or self.motion.agrees)


def _alone(road: Road, other: Road) -> Iterator[Lone]:
    named = {(gap.position, gap.plan, gap.reason) for gap in other.unanswered}
    yield from (Lone(road.by, gap) for gap in road.unanswered if (gap.position, gap.plan, gap.reason) not in named)


def together(comparisons: Iterable[Comparison]) -> Sequence[Quantity]:
    """Give the findings of some comparisons in their order."""
    return [finding for comparison in comparisons for finding in comparison.findings]


SLIP = 0.2  # mm to either side: a fair hand's
MOST_SIDES = 40  # of a polygon that is laid off side by side; of more a sheet draws the sum alone

Slipping: TypeAlias = Callable[..., dict[Mark, Slopes]]  # of a hand and marks


def by_hand(
    findings: Iterable[Quantity], scales: Mapping[str, float], position: int = 0, by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give within what 95 of 100 drawings are of what is read off boards in a position, by the names of the findings.

    `scales` are those of the boards, true units a mm: what is read off another board is not drawn, and has no error.
    """
    read = {found.name: found.shown for found in findings if found.shown is not None and _board(found.shown) in scales}
    found = errors_by_hand(read, SlippingHand(SLIP, {board: np.array([mu]) for board, mu in scales.items()}), by)
    return {(name, position): float(error[position if len(error) > 1 else 0]) for name, error in found.items()}


def _board(shown: Shown) -> str:
    """Give the board that something is read off, before it is turned or divided by a number."""
    mark = shown if isinstance(shown, Mark) else shown[-1]
    while mark.step.op == "turn":
        mark = mark.step.inputs[0]
    return mark.subject


def errors_by_hand(read: Mapping[str, Shown], hand: SlippingHand, by: Slipping = slopes) -> dict[str, Floats]:
    """Give within what 95 of 100 drawings of a hand are of what is read off a record, by its letters.

    `by` finds how far each slip moves each mark: by the rules of the acts, or by trying them.
    """
    scales = tuple((board, tuple(np.asarray(row).tolist())) for board, row in hand.scales.items())
    return dict(zip(read, _errors(tuple(read.values()), hand.slip, scales, by), strict=True))


@lru_cache(maxsize=16)  # a sheet is told them, and held to them
def _errors(
    read: tuple[Shown, ...], slip: float, scales: tuple[tuple[str, tuple[float, ...]], ...], by: Slipping
) -> list[Floats]:
    hand = SlippingHand(slip, {board: np.array(row) for board, row in scales})
    found = by(hand, *(mark for shown in read for mark in _marks(shown)))
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        return [_error(shown, found) for shown in read]


def _marks(shown: Shown) -> tuple[Mark, ...]:
    return (shown,) if isinstance(shown, Mark) else tuple(shown)


def _error(shown: Shown, found: Mapping[Mark, Slopes]) -> Floats:
    match shown:
        case Span(start, end):
            return size_error(np.asarray(between(start, end)), found[end] - found[start])
        case Reading(arm, turning):
            over, ratio = np.asarray(arm.point), np.asarray(turning.point) / np.asarray(arm.point)
            return number_error(-1j * (found[turning] - ratio * found[arm]) / over)
        case _:
            force = np.asarray(shown.point)
            return number_error(found[shown]) if shown.is_moment else size_error(force, found[shown])
