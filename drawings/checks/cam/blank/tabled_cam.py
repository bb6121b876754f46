"""The profile of a cam to be made at the turns that its sheet tells, by the analysis (табличные точки профиля)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.page.drafting import Drafting
from plans.analytic.cam.contour import contour
from plans.cam.course import Course, settled
from plans.model.cam import DWELL, GROOVE, Cam, Phase
from plans.model.cam_motion import CamFound, Contour, Points
from plans.model.motion import Floats

PLAN = "manufacturing"  # the name of the figure
TABLED, RADIUS_EACH, ORDINATE_EACH = (
    72,
    6,
    10,
)  # turns that are told; from one drawn radius, or ordinate of a travel, to the next
ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)  # lengths in mm, by powers of ten, from one tabled travel to the next
MM = 1000.0  # of a metre
# Flaws of a shape for which it is not to be made.
FLAWS = ("undercut", "crossing", "concave", "sharp", "hollow")


class TabledCam(NamedTuple):
    """A cam that the analysis found, and its contour at the turns that a sheet tells."""

    found: CamFound
    at: Contour

    @property
    def cam(self) -> Cam:
        """The cam as it is asked for."""
        return self.found.cam

    @property
    def grooved(self) -> bool:
        """Whether the path of a mill is told: that of the middle of a groove."""
        return self.cam.closure == GROOVE and self.found.roller > 0

    @property
    def told(self) -> Points:
        """The points that are told, m, (N,)."""
        return self.at.pitch if self.grooved else self.at.profile

    @property
    def names(self) -> list[float]:
        """The turns in degrees, or the travels in mm, by which the points are named."""
        own = MM * self.at.turned if self.cam.translates else np.degrees(self.at.turned)
        return [float(one) for one in own.round(9)]

    def rays(self) -> Iterator[tuple[int, float]]:
        """Give the points whose radii, or ordinates, are drawn, with their names."""
        every = ORDINATE_EACH if self.cam.translates else RADIUS_EACH
        yield from ((k, name) for k, name in enumerate(self.names) if k and k % every == 0)

    def cells(self, k: int) -> tuple[float, float]:
        """Give abscissa and ordinate, mm; of a cam that turns the radius, and the angle against the rotation, °."""
        spot = MM * complex(self.told[k])
        if self.cam.translates:
            return spot.real, spot.imag
        return abs(spot), float(self._angles[k])

    @property
    def _angles(self) -> Floats:
        """The angles from the zero ray through the first point, against the rotation, degrees."""
        return np.asarray(-self.cam.sense * np.degrees(np.unwrap(np.angle(self.told / self.told[0]))))

    def dwells(self) -> Iterator[tuple[Phase, float]]:
        """Give the dwells with the radii of their arcs, m."""
        own = [one for one in self.cam.phases if one.kind == DWELL]
        middles = np.array([(one.start + one.end) / 2 for one in own])
        if own:
            at = contour(self.cam, self.found.sizes, self.found.roller, middles)
            yield from zip(own, np.abs(at.pitch if self.grooved else at.profile).tolist(), strict=True)


def tabled(found: CamFound) -> TabledCam:
    """Look at a cam at the turns that its sheet tells: every 5 degrees, or by a round length of travel."""
    cam = found.cam
    if cam.translates:
        least = MM * cam.turn / TABLED
        power = 10.0 ** math.floor(math.log10(least))
        step = next(one * power for one in ROUND if one * power >= least * (1 - 1e-12)) / MM
        turned = np.append(np.arange(0.0, cam.turn - step / 2, step), cam.turn)
    else:
        turned = cam.turn * np.arange(TABLED) / TABLED
    return TabledCam(found, contour(cam, found.sizes, found.roller, settled(turned, Course(cam))))


def notes(one: TabledCam, exact: Drafting, drafting: Drafting) -> Iterator[str]:
    """Give what a workshop must be told, its numbers with all digits but those that the scene gives."""
    cam, word = one.cam, drafting.word
    turns = ("counter-clockwise cam", "clockwise cam"), ("leftward cam", "rightward cam")
    yield word(turns[cam.translates][cam.sense < 0])
    curve = word("mill path" if one.grooved else "profile told")
    yield word("plane datum" if cam.translates else "polar datum", curve=curve)
    if one.found.roller:
        sizes = {"radius": exact.number(MM * one.found.roller)}
        sizes |= {"breadth": exact.number(2 * MM * one.found.roller)} if one.grooved else {}
        yield drafting.letter(word("groove of cam" if one.grooved else "roller of cam", **sizes))
    if not cam.translates:
        dwells = [_dwell(phase, radius, exact) for phase, radius in one.dwells()]
        yield from [word("dwells of cam", radii=";  ".join(dwells))] if dwells else []
        yield word("bore of cam")
    yield word("drawn pieces", tolerance=drafting.number(MM * cam.tolerance))
    wrong = dict.fromkeys(flaw.kind for flaw in one.found.flaws if flaw.kind in FLAWS)
    if wrong:
        yield word("profile flaws", flaws=", ".join(word(f"cam {kind}") for kind in wrong))


def _dwell(phase: Phase, radius: float, exact: Drafting) -> str:
    start, end = (exact.number(math.degrees(turn)) for turn in (phase.start, phase.end))
    return f"r = {exact.number(MM * radius)}, φ {start} … {end}°"
