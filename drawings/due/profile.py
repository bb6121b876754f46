"""What must stand on the sheet of a cam to be made, by the analysis alone: curves, radii, table, notes (чертёж)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import NOTES, Expected
from drawings.due.cam_notes import every_cam, numbers_of
from drawings.due.cam_values import CamValues
from drawings.layout.table import cell_name
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.statement import Kind
from drawings.paper.strokes import Leaf
from plans.analytic.cam.contour import contour
from plans.cam.course import Course, settled
from plans.model.cam import DWELL, GROOVE, Cam, Phase
from plans.model.cam_motion import CamFound, Contour, Points
from plans.model.motion import Floats
from plans.study import Study

PLAN, RADII = "manufacturing", "radii"  # the names of the figure and of the table
TABLED, RADIUS_EACH, ORDINATE_EACH = 72, 6, 10  # turns that are told; from one drawn radius, or ordinate, to the next
ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)  # lengths in mm, by powers of ten, from one tabled travel to the next
MM, DIGITS = 1000.0, 5
TURN = 360.0


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

    @property
    def cells(self) -> Floats:
        """Abscissas and ordinates, mm, (N, 2); of a cam that turns radii, and angles against the rotation, degrees."""
        if self.cam.translates:
            return MM * np.column_stack((self.told.real, self.told.imag))
        angles = -self.cam.sense * np.degrees(np.unwrap(np.angle(self.told / self.told[0])))
        return np.column_stack((MM * np.abs(self.told), angles))

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


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of one cam (row of the table of sheets)."""
    values = numbers_of(study, leaves[0].metadata["cam"]).values
    found = values.found
    drafting, exact, slack = drafting_of(study.scene), tabled(found), float(np.max(values.compared.slack.profile))
    yield from _figure(values, exact, slack, drafting)
    every = leaves[0].metadata["every"]
    for k, (first, second) in enumerate(exact.cells):
        row = drafting.number(exact.names[k], DIGITS)
        far = float(np.abs(exact.told[k]))
        off = MM * slack if found.cam.translates else math.degrees(slack / far) if far else math.inf
        lacks = k % every > 0
        yield Expected(Kind.NUMBER, RADII, cell_name(row, 0), float(first), MM * slack, may_lack=lacks)
        yield Expected(Kind.NUMBER, RADII, cell_name(row, 1), float(second), off, may_lack=lacks)
    yield from (*_notes(exact, slack), *every_cam(study))


def _figure(values: CamValues, exact: TabledCam, slack: float, drafting: Drafting) -> Iterator[Expected]:
    """Give the curves, the radii or ordinates, the sense of motion."""
    cam = values.cam
    for name, path in values.curves():
        yield Expected(Kind.CURVE, PLAN, name, path, slack + values.drawn)
    for number, (k, turn) in enumerate(exact.rays()):
        said = drafting.number(turn, DIGITS)
        letter = f"x {said}" if cam.translates else f"φ {said}°"
        spot = complex(exact.told[k])
        yield Expected(Kind.VECTOR, PLAN, "r", 1j * spot.imag if cam.translates else spot, slack, number, letter=letter)
    yield Expected(Kind.DIRECTION, PLAN, *(("v", -cam.sense) if cam.translates else ("ω", cam.sense)))


def _notes(exact: TabledCam, slack: float) -> Iterator[Expected]:
    """Give the numbers that a workshop is told: roller, groove, arcs of the dwells."""
    name, roller = exact.cam.name, exact.found.roller
    sizes = {f"r_rol {name}": MM * roller, f"breadth {name}": 2 * MM * roller}
    sizes |= {f"r {k} {name}": MM * radius for k, (_, radius) in enumerate(exact.dwells())}
    for quantity, size in sizes.items():
        yield Expected(Kind.PHRASE, NOTES, quantity, size, 2 * MM * slack, digits=DIGITS, may_lack=True)
    for k, (phase, _) in enumerate(exact.dwells()):
        for quantity, turn in ((f"start {k} {name}", phase.start), (f"end {k} {name}", phase.end)):
            yield Expected(Kind.PHRASE, NOTES, quantity, math.degrees(turn), digits=DIGITS, may_lack=True, period=TURN)
