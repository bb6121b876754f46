"""Shocks by the limits of the closed forms at both sides of every seam (жёсткие и мягкие удары, M2.5)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from plans.analytic.cam.laws import breaks, limits
from plans.model.cam import Cam, Phase
from plans.model.cam_motion import Shock

REST = (0.0, 0.0)
# A sine of a half turn leaves half an eps of its amplitude, a law by points an eps for each: of the largest S' or S''.
NOTHING = 4096 * float(np.finfo(np.float64).eps)


class Seam(NamedTuple):
    """Where two laws or two parts of one meet, rad, and S' and S'' before and after it."""

    turned: float
    before: tuple[float, float]
    after: tuple[float, float]


def shocks(cam: Cam) -> tuple[Shock, ...]:
    """Find where S' jumps, a hard shock, or S'' alone, a soft one."""
    seams = sorted(_seams(cam))
    most = [max(_usual(cam, k + 1), *(abs(side[k]) for one in seams for side in one[1:])) for k in (0, 1)]
    return tuple(shock for seam in seams for shock in _shock(seam, most))


def _usual(cam: Cam, order: int) -> float:
    """Give the mean S' of the steepest phase, or what it comes to once more by its angle."""
    return max((abs(one.change) / one.angle**order for one in cam.phases if one.change), default=0.0)


def _shock(seam: Seam, most: list[float]) -> Iterator[Shock]:
    for order, (one, other) in enumerate(zip(seam.before, seam.after, strict=True), 1):
        if abs(other - one) > NOTHING * most[order - 1]:
            yield Shock(seam.turned, order, other - one)
            return


def _seams(cam: Cam) -> Iterator[Seam]:
    """Give the seams between phases, each last one before the first, and those within the laws."""
    phases = [one for one in cam.phases if one.angle > 0]
    ends = [(_side(one, 0.0, False), _side(one, 1.0, True)) for one in phases]
    yield Seam(0.0, REST if cam.translates else ends[-1][1], ends[0][0])
    for (_, before), (after, _), phase in zip(ends, ends[1:], phases[1:], strict=False):
        yield Seam(phase.start, before, after)
    if cam.translates:
        yield Seam(cam.turn, ends[-1][1], REST)
    for phase in phases:
        yield from _inner(phase)


def _inner(phase: Phase) -> Iterator[Seam]:
    for share in breaks(phase.law) if phase.law else ():
        yield Seam(phase.start + share * phase.angle, _side(phase, share, True), _side(phase, share, False))


def _side(phase: Phase, share: float, before: bool) -> tuple[float, float]:
    """Give S' and S'' on one side of a share of a phase."""
    if phase.law is None:
        return REST
    first, second = (limits(phase.law, share, order, before) for order in (1, 2))
    return phase.change / phase.angle * first, phase.change / phase.angle**2 * second
