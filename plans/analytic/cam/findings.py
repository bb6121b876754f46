"""All that the analysis finds of one cam (кулачок, итог расчёта)."""

from __future__ import annotations

from plans.analytic.cam.contact import forces_of
from plans.analytic.cam.contour import contour
from plans.analytic.cam.extremes import Extremes
from plans.analytic.cam.flaws import Flaws
from plans.analytic.cam.shocks import shocks
from plans.model.cam import ROLLER, Cam
from plans.model.cam_motion import ANALYSIS, CamFound, Extreme, Sizes
from plans.model.motion import Floats


def cam_found(cam: Cam, sizes: Sizes, turned: Floats) -> CamFound:
    """Find a cam's profile at some turns, rad, its extremes over the whole turn, and its flaws."""
    extremes = Extremes(cam, sizes)
    roller, rule = roller_radius(cam, extremes.sharpest, sizes.base)
    forces = forces_of(cam, roller)
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
        flaws=Flaws(extremes, roller, forces).all(),
        rule=rule,
        pressing=extremes.pressing(forces) if forces and not extremes.outrun else None,
        mending=extremes.mending,
    )


def roller_radius(cam: Cam, sharpest: Extreme | None, base: float) -> tuple[float, str]:
    """Give the roller's radius, m, and by what it was taken: r <= 0.7 ρ_min, r <= 0.4 R0, the smaller (M2.14).

    A cam that translates has no R0, a curve that is nowhere convex no ρ_min.
    """
    if cam.follower.end != ROLLER:
        return 0.0, "given"
    if cam.roller is not None:
        return cam.roller, "given"
    bend = 0.7 * sharpest.value if sharpest else float("inf")
    wear = 0.4 * base if base > 0 else float("inf")
    if min(bend, wear) == float("inf"):
        return 0.0, "curvature"
    return (wear, "wear") if wear < bend else (bend, "curvature")
