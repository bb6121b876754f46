"""What the follower really does where a loop of the profile is cut away (действительный закон при подрезании).

The cutter takes the loop off, and a corner is left where the profile crosses itself: the follower rests on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from plans.cam.profile.crossing import Crossing, in_frame
from plans.cam.profile.stretches import Span, Stretches
from plans.cam.profile.tip import Tip, guide_start
from plans.model.cam import TURN
from plans.model.cam_motion import Extreme
from plans.model.motion import Floats

LOOKS: Final = 129  # turns over a loop, looked at again between the neighbours of the greatest
ROUNDS: Final = 5


def loop_of(crossing: Crossing, spans: Sequence[Span], turn: float = TURN) -> tuple[float, float]:
    """Give the turns between which the loop is: what was undercut lies on it, or else it is the shorter part.

    >>> loop_of(Crossing(0.1, 6.0, 0j), ())
    (6.0, 0.1)
    """
    first, second, _ = crossing
    inside = [first <= (one.start + one.end) / 2 <= second for one in spans]
    wide = second - first > turn / 2 if not spans else not any(inside)
    return (second, first) if wide else (first, second)


def resting(stretches: Stretches, roller: float, corner: complex, turned: Floats) -> Floats:
    """Give S with which the follower rests on a corner of the cam, (N,); NaN where it cannot."""
    tip = Tip(stretches.course, stretches.sizes, turned)
    place = in_frame(tip, corner)
    with np.errstate(invalid="ignore"):
        return _rocker(tip, place, roller) if tip.cam.rocks else _upright(tip, place, roller)


def _upright(tip: Tip, place: np.ndarray, roller: float) -> Floats:
    if tip.cam.flat:
        return np.asarray(place.imag - tip.sizes.base)
    aside = place.real - tip.cam.sense * tip.sizes.offset
    return np.asarray(place.imag + np.sqrt(roller**2 - aside**2) - guide_start(tip.sizes))


def _rocker(tip: Tip, place: np.ndarray, roller: float) -> Floats:
    """Give it for a rocker: the corner is at the roller's radius from its pin, or lies on its face."""
    follower, way = tip.cam.follower, place - tip.sizes.pivot
    size = np.abs(way)
    if tip.cam.flat:
        along = way / (np.sqrt(size**2 - follower.face**2) + 1j * tip.cam.rising * follower.face)
    else:
        length = follower.length or 0.0
        lifted = np.arccos((length**2 + size**2 - roller**2) / (2 * length * size))
        along = way / size * np.exp(1j * tip.cam.rising * lifted)
    return np.asarray(tip.cam.lift / 2 + tip.cam.rising * np.angle(along * tip.cam.rising))


def loss(stretches: Stretches, roller: float, crossing: Crossing, loop: tuple[float, float]) -> Extreme:
    """Give how much of S is lost at most on a loop that is cut away, and where."""
    cam = stretches.course.cam
    start, end = loop[0], loop[1] + (cam.turn if loop[1] < loop[0] else 0.0)
    best = Extreme(0.0, loop[0])
    for _ in range(ROUNDS):
        turned = np.linspace(start, end, LOOKS)
        own = np.where(turned > cam.turn, turned - cam.turn, turned)
        lost = stretches.course.at(own).s - resting(stretches, roller, crossing.point, own)
        if np.isnan(lost).all():
            return Extreme(float("nan"), loop[0])
        place = int(np.nanargmax(lost))
        best = max(best, Extreme(float(lost[place]), float(own[place])))
        start, end = turned[max(place - 1, 0)], turned[min(place + 1, LOOKS - 1)]
    return best
