"""The draughtsman's toll: what drawing by hand costs in exactness, drawing by drawing (чертёжник на испытании)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.board import Mark
from geometry.draughtsman import Draughtsman, copies
from geometry.meet import cross
from plans.bench.error import shares
from plans.bench.truth import MOMENT, Replay, Truth
from plans.model.motion import Floats
from plans.model.order import ORDERS

SLIPS = (0.1, 0.2)  # mm: a good hand's and a fair one's
RATES = {told.key for order in ORDERS[1:] for told in (order.point, order.link)}
TOLD = 0.01  # of the largest: a smaller value has no per cent of itself


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
