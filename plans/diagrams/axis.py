"""The axis of the diagrams: positions in the order in which the crank passes them, and where it cannot (ось углов)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from plans.linkage.study import LinkageStudy
from plans.model.diagrams import TURN, Axis
from plans.model.motion import Floats

Numbers = npt.NDArray[np.int_]
ROUNDED = 1e-9  # rad: far more than a rounding of an angle, and far less than two positions are apart


def axis_of(study: LinkageStudy) -> Axis:
    """Put the positions of a study in order; the axis begins after the widest stretch in which none is reached.

    The positions of a whole turn are a closed row, and the first one stands again at the end.
    """
    ahead = np.mod(study.sense * (study.turn.phi - study.turn.phi[0]) + ROUNDED, TURN) - ROUNDED
    order = np.argsort(ahead, kind="stable")
    if isinstance(study.form.drive.positions, int) and not study.barriers and not study.lost.any():
        return _whole(order, ahead[order], float(study.turn.phi[0]))
    if study.lost.all():
        return Axis((), np.zeros(0), np.zeros(0, dtype=bool), False)
    return _open(study, order, ahead[order])


def _whole(numbers: Numbers, turned: Floats, start: float) -> Axis:
    row = (*numbers.tolist(), int(numbers[0]))
    return Axis(row, np.append(turned, TURN), np.ones(len(numbers), dtype=bool), True, start)


def _open(study: LinkageStudy, numbers: Numbers, turned: Floats) -> Axis:
    """Let the axis go from the first to the last position that is reached."""
    held = np.flatnonzero(~study.lost[numbers])
    apart = np.diff(turned[held], prepend=turned[held[-1]] - TURN)
    first, last = int(held[np.argmax(apart)]), int(held[np.argmax(apart) - 1])
    count = (last - first) % len(numbers) + 1
    numbers, turned = np.roll(numbers, -first)[:count], np.roll(turned, -first)[:count]
    turned = np.mod(turned - turned[0], TURN)
    start = float(study.turn.phi[numbers[0]])
    return Axis(tuple(numbers.tolist()), turned, _joined(study, numbers, turned), False, start)


def _joined(study: LinkageStudy, numbers: Numbers, turned: Floats) -> npt.NDArray[np.bool_]:
    """Tell the parts between two positions that are reached, in which nothing bars the crank, (M - 1,)."""
    joined = np.asarray(~study.lost[numbers[:-1]] & ~study.lost[numbers[1:]])
    for edge in (edge for barrier in study.barriers for edge in (barrier.start, barrier.end)):
        spot = np.mod(study.sense * (edge - study.turn.phi[numbers[0]]), TURN)
        joined &= ~((turned[:-1] < spot) & (spot < turned[1:]))
    return joined
