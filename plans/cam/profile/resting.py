"""What the follower really does where a loop of the profile is cut away (действительный закон при подрезании).

The cutter takes the loop off, and a corner is left where the profile crosses itself: the follower rests on it.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from plans.cam.profile.crossing import Crossing
from plans.cam.profile.stretches import Stretches
from plans.cam.profile.tip import Tip, guide_start
from plans.model.cam_motion import Extreme
from plans.model.motion import Floats

LOOKS: Final = 129  # turns over a loop, looked at again between the neighbours of the greatest
ROUNDS: Final = 5
NOTHING: Final = 1e-9  # of the lift: a loss so small is what rounding makes of a corner on which nothing is lost


def resting(stretches: Stretches, roller: float, corner: complex, turned: Floats) -> Floats:
    """Give S with which the follower rests on a corner of the cam, (N,); NaN where it cannot."""
    tip = Tip(stretches.course, stretches.sizes, turned)
    place = tip.in_frame(corner)
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


def loss(stretches: Stretches, roller: float, crossing: Crossing) -> Extreme:
    """Give how much of S is lost at most on a loop that is cut away, and where."""
    cam, (start, end, point) = stretches.course.cam, crossing
    end += cam.turn if end < start else 0.0
    best = Extreme(0.0, start)
    for _ in range(ROUNDS):
        turned = np.linspace(start, end, LOOKS)
        own = np.where(turned > cam.turn, turned - cam.turn, turned)
        lost = stretches.course.at(own).s - resting(stretches, roller, point, own)
        if np.isnan(lost).all():
            return Extreme(float("nan"), crossing.start)
        place = int(np.nanargmax(lost))
        best = max(best, Extreme(float(lost[place]), float(own[place])))
        start, end = turned[max(place - 1, 0)], turned[min(place + 1, LOOKS - 1)]
    return best if best.value > NOTHING * cam.lift else Extreme(0.0, crossing.start)
