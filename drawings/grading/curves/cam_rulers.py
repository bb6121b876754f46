"""Where rulers at the permitted angles meet, laid to a diagram of S and S' as a student has it (касательные)."""

from __future__ import annotations

import math

from drawings.grading.curves.asked_figure import Sizes
from plans.analytic.cam.sizes import Side, least, sides_of
from plans.model.cam import Cam
from plans.model.cam_motion import Sizes as MainSizes


def ruled(cam: Cam, sizes: MainSizes, drawn: tuple[Sizes, Sizes], true: tuple[Sizes, Sizes]) -> complex:
    """Give A as it is seen from O, where S' and S at some places are drawn otherwise than they are.

    Sizes that are given stay where they are, and so do all where rulers leave no room for O.
    """
    offset, level = sizes.offset, math.sqrt(max(sizes.base**2 - sizes.offset**2, 0.0))
    if cam.given.base is None and cam.given.offset is None and not cam.translates:
        own = tuple(one._replace(most=one.most + _moved(one, drawn, true)) for one in sides_of(cam))
        if all(one.most > 0 for one in own):
            offset, level = least(own)
    return complex(cam.sense * offset, level)


def _moved(one: Side, drawn: tuple[Sizes, Sizes], true: tuple[Sizes, Sizes]) -> float:
    """Give by how much a ruler has moved along the axis of S', m: at the point that it touches then and now."""
    touches = [float((one.sign * velocity - one.tangent * way).max()) for velocity, way in (drawn, true)]
    return touches[0] - touches[1]
