"""All that the analysis finds of one cam (кулачок, итог расчёта)."""

from __future__ import annotations

from dataclasses import replace

from plans.analytic.cam.contact import forces_of
from plans.analytic.cam.contour import contour
from plans.analytic.cam.extremes import Extremes
from plans.analytic.cam.flaws import Flaws
from plans.analytic.cam.shocks import shocks
from plans.analytic.cam.sizes import sizes as sizes_of
from plans.model.cam import GROOVE, NO_SIZES, ROLLER, Cam
from plans.model.cam_faults import CamError
from plans.model.cam_motion import ANALYSIS, CamFound, Sizes
from plans.model.motion import Floats


def cam_found(cam: Cam, sizes: Sizes, turned: Floats) -> CamFound:
    """Find a cam's profile at some turns, rad, its extremes over the whole turn, and its flaws."""
    extremes = Extremes(cam, sizes)
    roller, rule = roller_radius(cam, extremes, sizes.base)
    forces = forces_of(cam, roller)
    flaws = Flaws(extremes, roller, forces).all()
    return CamFound(
        by=ANALYSIS,
        cam=cam,
        sizes=sizes,
        roller=roller,
        contour=contour(cam, sizes, roller, turned),
        shocks=shocks(cam),
        peaks=extremes.peaks,
        pressure=extremes.pressure,
        sharpest=extremes.sharpest,
        hollow=extremes.hollow,
        face=extremes.face,
        flaws=flaws,
        rule=rule,
        pressing=extremes.pressing(forces) if forces and not extremes.outrun else None,
        mending=extremes.mending,
        advised=advised(cam) if any(one.kind == "pressure" for one in flaws) else None,
    )


def advised(cam: Cam) -> Sizes | None:
    """Give the sizes that keep to the limits where none is given, if there are such."""
    if cam.flat or cam.translates:
        return None
    try:
        return sizes_of(replace(cam, given=NO_SIZES))
    except CamError:
        return None


def roller_radius(cam: Cam, extremes: Extremes, base: float) -> tuple[float, str]:
    """Give the roller's radius, m, and by what it was taken: r <= 0.7 ρ_min, r <= 0.4 R0, the smaller (M2.14).

    In a groove 0.7 of the hollow's radius bounds it too. A cam that translates has no R0, a curve that is nowhere
    convex no ρ_min.
    """
    if cam.follower.end != ROLLER:
        return 0.0, "given"
    if cam.roller is not None:
        return cam.roller, "given"
    bends = {"curvature": extremes.sharpest, "hollow": extremes.hollow if cam.closure == GROOVE else None}
    rules = [(0.7 * abs(one.value), rule) for rule, one in bends.items() if one]
    rules += [(0.4 * base, "wear")] if base > 0 else []
    return min(rules, default=(0.0, "curvature"))
