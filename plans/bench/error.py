"""The error of a technique, in shares of the plan's largest, and what drawing by hand adds to it (погрешность)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.board import Mark
from geometry.draughtsman import Draughtsman, copies
from geometry.meet import cross
from plans.bench.truth import MOMENT, REACTION, Replay, Truth, Values
from plans.forces.reading.form import FORCES
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ORDERS, POSITIONS, Floats

SLIPS = (0.1, 0.2)  # mm: a good hand's and a fair one's
RATES = {told.key for order in ORDERS[1:] for told in (order.point, order.link)}
TOLD = 0.01  # of the largest: a smaller value has no per cent of itself
SIZED = 360  # positions whose largest vector is the plan's largest: every degree of the turn
DEFINED = (
    "error: the largest difference from the truth over the positions looked at, of the pins' and points' r, v, a and "
    "the links' angle, omega, epsilon; each in shares of the largest of its own plan over the turn (an angle: of pi; "
    "an omega or epsilon: of the largest one, or of the largest v or a over the mechanism's size if that is more)"
)
FORCES_DEFINED = (
    "of forces: the largest difference of the reactions and of the drive's force, in shares of the largest reaction "
    "over the turn; of their moments and the balancing moment, in shares of that reaction times the mechanism's size. "
    "The truth's loads follow its own motion; where a stroke ends it takes from the construction"
)
TRUE = "truth: the construction's record carried out in 50 digits, from exact crank angles, by formulas of its own"


@dataclass(frozen=True)
class Errors:
    """The largest errors of a technique, by kind of quantity; `worst` names the quantity of the largest of all."""

    kinds: Mapping[str, float]
    worst: str = ""
    typical: float | None = None  # where there is chance: the median of the drawings' largest errors

    @property
    def largest(self) -> float | None:
        """The largest error of all kinds; None where there is none."""
        return self.typical if self.typical is not None else max(self.kinds.values(), default=None)

    @classmethod
    def joined(cls, shares: Iterable[tuple[str, str, float]]) -> Errors:
        """Join the errors of single quantities, each with its kind and its name."""
        found, kinds = list(shares), dict[str, float]()
        for kind, _, share in found:
            kinds[kind] = max(kinds.get(kind, 0.0), share)
        return cls(kinds, max(found, key=lambda one: one[2])[1] if found else "")


def sizes(study: LinkageStudy) -> dict[str, float]:
    """Give the largest of each kind over a turn, by which its errors are counted."""
    motion = study.motion(2)
    moving = [m for name, m in motion.points.items() if name not in study.mechanism.links[FRAME].points]
    found = {order.point.key: _largest([np.abs(point[order.number]) for point in moving]) for order in ORDERS}
    places = np.array([point.r for point in motion.points.values()])
    extent = _largest([places - places[0]])
    found[POSITIONS.link.key] = np.pi
    for order in ORDERS[1:]:
        # Rates of links that only translate are truly zero, and no share of themselves.
        slowest = found[order.point.key] / extent if extent > 0 else 0.0
        rates = [link[order.number] for link in motion.links.values()]
        found[order.link.key] = max(_largest(rates), slowest)
    if FORCES in study.scene.sheets:
        found[REACTION] = _largest([np.abs(one.force) for one in Statics(study).forces.reactions.values()])
        found[MOMENT] = found[REACTION] * extent
    return found


def shares(found: Values, truth: Truth, largest: Mapping[str, float]) -> dict[tuple[str, str], Floats]:
    """Give every value's error as a share of its kind's largest; NaN is infinitely wrong."""
    result = {}
    for key, given in found.items():
        off = truth.values[key].off(given)
        if key[0] == "angle":
            off = np.abs((off + np.pi) % (2 * np.pi) - np.pi)  # pi and -pi are one direction
        share = off / largest[key[0]] if largest[key[0]] > 0 else np.where(off == 0, 0.0, np.inf)
        result[key] = np.where(np.isnan(share), np.inf, share)
    return result


def errors(found: Values, truth: Truth, largest: Mapping[str, float]) -> Errors:
    """Give the largest errors of some values."""
    off = shares(found, truth, largest)
    return Errors.joined((key[0], "_".join(key), float(share.max())) for key, share in off.items())


def _largest(arrays: list[Floats]) -> float:
    sized = [float(np.nanmax(np.abs(array))) for array in arrays if np.isfinite(array).any()]
    return max(sized, default=0.0)


def drawn(replay: Replay, hand: Draughtsman) -> dict[tuple[str, str], Any]:
    """Draw the record by hand; give what is read off the drawings, each (drawings, positions)."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return _read(replay, copies(hand, *replay.wanted), (hand.drawings, len(replay.positions)))


def _read(replay: Replay, done: Mapping[Mark, Any], shape: tuple[int, int]) -> dict[tuple[str, str], Any]:
    found = {key: done[mark] for key, mark in replay.points.items()}
    found |= {("angle", link): np.angle(done[arm] / span) for link, (arm, span) in replay.arms.items()}
    for key, (arm, turning) in replay.rates.items():
        found[key] = cross(done[arm], done[turning]) / np.abs(done[arm]) ** 2
    for key, (mark, sense) in replay.forces.items():
        found[key] = sense * (np.real(done[mark]) if key[0] == MOMENT else done[mark])
    return {key: np.broadcast_to(values, shape) for key, values in found.items()}


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
