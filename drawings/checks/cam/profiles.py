"""Profiles of a written sheet against the analysis: points of it, and its law by rolling (проверка профилей)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from drawings.checks.cam.rolling import apart, rolled
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.profile_view import OUTER, PITCH, WORKING
from drawings.measure.measured_profile import MeasuredProfile
from plans.analytic.cam.contour import contour
from plans.model.cam import POINTED, Cam
from plans.model.cam_motion import CamFound, Contour, Points, Sizes
from plans.model.motion import Floats
from plans.words.words import Message, message

SLIPPED = 1e-12  # of the radius: what arithmetic moves


FLAWS = ("undercut", "hollow", "crossing", "concave")  # of a shape that no follower can go along
TURNS = 360  # parts of a turn at which a written profile is looked at


class Analysed(NamedTuple):
    """What the analysis alone says of a cam: the task, sizes, the roller's radius m, the contour at many turns.

    A `flawed` profile, with loops or hollows that the follower cannot enter, does not return the law: only its points
    are held to the analysis.
    """

    cam: Cam
    sizes: Sizes
    roller: float
    contour: Contour
    flawed: bool = False

    def points(self, name: str) -> Points | None:
        """Give the exact points of a profile by its name, None of one that there is not."""
        known = {PITCH: self.contour.pitch, WORKING: self.contour.profile, OUTER: self.contour.outer}
        return known.get(name)

    def rate(self) -> Floats:
        """Give what S changes by over the way of the profile along its normal, (N,): 1, or 1/m of a rocker.

        At a corner of the profile it is that of its steeper side.
        """
        arm = np.abs(self.contour.tip - self.sizes.pivot) if self.cam.rocks else 1.0
        before = contour(self.cam, self.sizes, self.roller, self.contour.turned, before=True).pressure
        return np.asarray(1 / (arm * np.minimum(np.cos(self.contour.pressure), np.cos(before))))


def analysed(found: CamFound, parts: int = TURNS) -> Analysed:
    """Look at a cam that the analysis found at equal parts of its turn."""
    cam, sizes, roller = found.cam, found.sizes, found.roller
    turned = np.linspace(0.0, cam.turn, parts, endpoint=cam.translates)
    if cam.translates and cam.rocks:  # its tip goes across: over the very ends it may miss the profile
        turned = turned[1:-1]
    flawed = any(one.kind in FLAWS for one in found.flaws)
    return Analysed(cam, sizes, roller, contour(cam, sizes, roller, turned), flawed)


def wrong(profiles: Sequence[MeasuredProfile], plan: str, analysed: Analysed) -> Iterator[Wrong]:
    """Say what is wrong with the profiles of a cam on its plan; its own profile must be there."""
    own = [one for one in profiles if one.plan == plan]
    names = {one.name for one in own}
    grooved = analysed.contour.outer is not None and analysed.roller > 0  # of a point both sides are one
    needed = {WORKING} | ({OUTER} if grooved else set())
    yield from (on("missing_on", plan, name=name) for name in sorted(needed - names))
    for one in own:
        exact = analysed.points(one.name)
        if exact is None:
            yield on("stranger_on", plan, name=one.name)
        else:
            yield from _one(one, exact, analysed)


def _one(profile: MeasuredProfile, exact: Points, analysed: Analysed) -> Iterator[Wrong]:
    cam, turned = analysed.cam, analysed.contour.turned
    closed = not cam.translates
    slack = profile.deviation + profile.quantum + SLIPPED * float(np.abs(exact).max())
    if profile.deviation > cam.tolerance * (1 + SLIPPED):
        yield on("coarse", profile.plan, name=profile.name, off=_told(profile.deviation))
    if closed and not profile.gap <= 2 * slack:
        yield on("open", profile.plan)
    off = apart(profile.pieces, closed, exact)
    if not (off <= slack).all():
        yield on("off_curve", profile.plan, name=profile.name, off=_told(off.max()), at=_where(turned, off, cam))
        return
    if profile.name == PITCH or not analysed.flawed:
        yield from _unrolled(profile, analysed, slack)


def _unrolled(profile: MeasuredProfile, analysed: Analysed, slack: float) -> Iterator[Wrong]:
    """Say so where a follower that is rolled over a profile does not return the law."""
    cam, contour, roller = analysed.cam, analysed.contour, analysed.roller
    if profile.name == PITCH and not cam.flat:
        cam = replace(cam, follower=cam.follower._replace(end=POINTED))
    found = rolled(profile.pieces, cam, analysed.sizes, roller, contour.turned, outer=profile.name == OUTER)
    off = np.abs(found - contour.travel.s) / analysed.rate()
    if not (off <= slack).all():
        yield on("unrolled", profile.plan, name=profile.name, off=_told(off.max()), at=_where(contour.turned, off, cam))


def _told(off: float) -> str:
    """Write a distance in mm."""
    return f"{off * 1e3:.2g}"


def _where(turned: Floats, off: Floats, cam: Cam) -> Message:
    """Say where it is the most: degrees, of a cam that translates mm."""
    where = float(turned[int(np.argmax(off))])
    if cam.translates:
        return message("wrong.at_travel", size=f"{where * 1e3:.4g}")
    return message("wrong.at_turn", size=f"{math.degrees(where):.4g}")
