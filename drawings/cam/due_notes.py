"""What notes and tables of cams must say by the analysis alone, and the drawing that a cam is made by (кулачок)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from drawings.cam.due_values import CamValues
from drawings.checks.expected import NOTES, Expected, cells, measured, phrases
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.cam.course import WorkshopTurns, stations
from plans.cam.quantities import EQUAL, NEAR
from plans.cam.study import CamStudy
from plans.cam.tables import smoothing
from plans.model.cam import DWELL, GROOVE, MM, RATIO, ROLLER, TABLE, Cam, Phase, dimensions
from plans.model.cam_motion import HARD, CamFound, Contour, Extreme, Points, Shock
from plans.model.motion import Floats
from plans.quantity import Quantity
from plans.study import Study

DEGREES, RPM = math.degrees(1), 30 / math.pi
DIGITS = 4


def every_cam(study: Study) -> Iterator[Expected]:
    """Give the numbers that are told of all cams of a scene."""
    for found in study.comparison("cam").analysis.cams:
        yield from numbers_of(study, found.cam.name).notes()


@lru_cache(maxsize=8)
def numbers_of(study: Study, name: str) -> CamNumbers:
    """Give the numbers of one cam of a scene; each of its sheets asks for them."""
    comparison = study.comparison("cam")
    cams = {found.cam.name: found for found in comparison.analysis.cams}
    beside = f" {name}" if len(cams) > 1 else ""
    rows = {row.name.removesuffix(beside): row for row in comparison.findings if row.name.endswith(beside)}
    return CamNumbers(CamValues(cams[name], study.of(CamStudy).drawings[name]), rows)


@dataclass(frozen=True)
class CamNumbers:
    """The numbers of one cam in the units that are told, and how far rounding may move each."""

    values: CamValues
    findings: Mapping[str, Quantity]

    @property
    def found(self) -> CamFound:
        """What the analysis finds of it."""
        return self.values.found

    @property
    def cam(self) -> Cam:
        """The cam as it is asked for."""
        return self.values.cam

    def slack(self, name: str) -> float:
        """How far rounding may move what was compared under a name; what was not may be anything."""
        return float(np.max(self.findings[name].allowed, initial=0.0)) if name in self.findings else math.inf

    @property
    def across(self) -> float:
        """The unit that the cam's turn, or its travel, is told in."""
        return MM if self.cam.translates else DEGREES

    @property
    def way(self) -> float:
        """The unit that the follower's way is told in."""
        return DEGREES if self.cam.rocks else MM

    def place(self, turned: float) -> tuple[float, float]:
        """Where the cam is: what is level there is known to half of the digits."""
        return self.across * turned, self.across * NEAR * self.cam.turn

    def size(self, name: str) -> tuple[float, float]:
        """A main size, mm or degrees."""
        sizes, slack = self.found.sizes, self.slack("R_0")
        level = math.sqrt(max(sizes.base**2 - sizes.offset**2, 0.0))
        moved = sizes.base * slack + (abs(sizes.offset) * self.slack("e") if sizes.offset else 0.0)
        known = {
            "R_0": (MM * sizes.base, MM * slack),
            "e": (MM * sizes.offset, MM * self.slack("e")),
            "S_0": (MM * level, MM * moved / level if level else math.inf),
            "L": (MM * sizes.centre, MM * self.slack("L")),
            "ψ_0": (DEGREES * sizes.initial, DEGREES * self.slack("ψ_0")),
            "r_rol": (MM * self.found.roller, MM * self.slack("r_r")),
        }
        return known[name]

    def radius(self, name: str, extreme: Extreme) -> tuple[float, float]:
        """A radius of curvature, mm; but under a flat face its reciprocal is compared."""
        return MM * extreme.value, MM * self.slack(name) * (1.0 if self.cam.flat else extreme.value**2)

    def jump(self, shock: Shock) -> tuple[float, float]:
        """What jumps at a shock: with the cam's speed of velocity or acceleration, else of S' or S''."""
        speed = (self.cam.speed or 1.0) ** shock.order
        return speed * shock.jump, speed * self.slack("ΔS'" if shock.order == HARD else "ΔS''")

    def unit(self, shock: Shock) -> str:
        """The unit of what jumps."""
        if self.cam.speed is None:
            unit = dimensions(self.cam)[shock.order]
            return "" if unit == RATIO else unit
        return f"{'rad' if self.cam.rocks else 'm'}/s{'' if shock.order == HARD else '2'}"

    def notes(self) -> Iterator[Expected]:
        """Give the rows of all that may be told; what is not told of this cam may lack."""
        rows = ((f"{name} {self.cam.name}", *numbers) for name, numbers in dict(self._numbers()).items())
        yield from phrases(NOTES, rows, DIGITS, may_lack=True)

    def _numbers(self) -> Iterator[tuple[str, tuple[float, float]]]:
        cam, found = self.cam, self.found
        yield from ((name, self.size(name)) for name in ("R_0", "e", "S_0", "L", "ψ_0", "r_rol"))
        yield "lift", (self.way * cam.lift, 0.0)
        yield from ((letter, (size, 0.0)) for letter, (size, _) in cam.told.items())
        speed = cam.speed or 0.0
        yield from (("n", (RPM * speed, 0.0)), ("ω", (speed, 0.0)), ("setting", (DEGREES * cam.setting, 0.0)))
        for side, far in zip(("back", "front"), found.face, strict=True):
            yield side, (MM * (far if cam.rocks else abs(far)), MM * self.slack(f"face_{side}"))
        for kind, largest in found.pressure.items():
            yield f"α {kind}", (DEGREES * largest.value, DEGREES * self.slack(f"α_{kind}"))
            yield f"φ α {kind}", self.place(largest.turned)
        for name, extreme, sign in (("ρ_min", found.sharpest, 1), ("ρ_hol", found.hollow, -1)):
            if extreme is not None:
                value, slack = self.radius(name.replace("hol", "hollow"), extreme)
                yield from ((name, (sign * value, slack)), (f"φ {name}", self.place(extreme.turned)))
        for k, shock in enumerate(found.shocks):
            yield from ((f"jump {k}", self.jump(shock)), (f"φ jump {k}", self.place(shock.turned)))
        yield from self._pressing()
        yield from self._flaws()
        yield from self._smoothed()

    def _pressing(self) -> Iterator[tuple[str, tuple[float, float]]]:
        pressing = self.found.pressing
        if pressing is None:
            return
        for name, extreme in (("N_min", pressing.least), ("N_max", pressing.most), ("wear", pressing.wear)):
            yield name, (extreme.value, self.slack(name.replace("wear", "N·v_sl")))
            yield f"φ {name}", self.place(extreme.turned)
        yield "preload", (pressing.preload, self.slack("preload"))

    def _flaws(self) -> Iterator[tuple[str, tuple[float, float]]]:
        """Give each flaw with its ends and its worst place, and what would mend them."""
        found = self.found
        units = {"pressure": DEGREES, "lift-off": 1.0, "outrun": 1.0, "crossing": self.way}
        for k, flaw in enumerate(found.flaws):
            worst = units.get(flaw.kind, MM) * flaw.worst.value
            yield f"flaw {k}", (worst, math.inf if flaw.kind == "crossing" else EQUAL * abs(worst))
            yield f"flaw {k} most", (abs(worst), EQUAL * abs(worst))
            ends = {f"flaw {k} start": flaw.start, f"flaw {k} end": flaw.end, f"flaw {k}": flaw.worst.turned}
            yield from ((f"φ {name}", self.place(turned)) for name, turned in ends.items())
        if found.mending is not None:
            yield "mending", (MM * found.mending, MM * self.slack("R_0 mending"))
        if found.advised is not None:
            sizes = {"R_0": found.advised.base, "e": found.advised.offset, "L": found.advised.centre}
            yield from ((f"{k} advised", (MM * size, MM * self.slack(f"{k} advised"))) for k, size in sizes.items())

    def _smoothed(self) -> Iterator[tuple[str, tuple[float, float]]]:
        """Give how far smoothed tables are off their points; the smoothing itself is one for both roads."""
        for k, phase in enumerate(self.cam.moving()):
            if phase.law is not None and phase.law.name == TABLE and phase.law.tolerance > 0:
                off, at = smoothing(phase.law)
                size = self.way * abs(phase.change)
                yield f"off {k}", (size * off, 0.0)
                yield f"allowed {k}", (size * phase.law.tolerance, 0.0)
                yield f"φ off {k}", (self.across * (phase.start + at * phase.angle), 0.0)


PLAN, RADII = "manufacturing", "radii"  # the names of the figure and of the table
FINE = 5
TURN = 360.0


def made_curve(found: CamFound, at: Contour) -> Points:
    """Give the curve that a workshop is told: the working profile, but of a groove where the centre of its mill goes.

    The sheet says it by itself: what it tells of another curve is seen here.
    """
    milled = found.cam.closure == GROOVE and found.cam.follower.end == ROLLER
    return at.pitch if milled else at.profile


def profile_cells(cam: Cam, spots: Points) -> Floats:
    """Give abscissas and ordinates, mm, (N, 2); of a cam that turns radii, and angles against the rotation, degrees."""
    if cam.translates:
        return MM * np.column_stack((spots.real, spots.imag))
    angles = -cam.sense * np.degrees(np.unwrap(np.angle(spots / spots[0])))
    return np.column_stack((MM * np.abs(spots), angles))


def dwells(values: CamValues) -> list[tuple[Phase, float]]:
    """Give the dwells with the radii of their arcs, m."""
    resting = [phase for phase in values.cam.phases if phase.kind == DWELL]
    at = values.at(np.array([(phase.start + phase.end) / 2 for phase in resting]))
    return [*zip(resting, np.abs(made_curve(values.found, at)).tolist(), strict=True)]


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of one cam."""
    values = numbers_of(study, leaves[0].metadata["cam"]).values
    cam, drafting, turns = values.cam, drafting_of(study.scene), stations(values.cam)
    spots, slack = made_curve(values.found, values.at(turns.turned)), float(np.max(values.compared.slack.profile))
    yield from _figure(values, turns, spots, slack, drafting)
    every = leaves[0].metadata["every"]
    for k, (name, spot, (first, second)) in enumerate(zip(turns.names, spots, profile_cells(cam, spots), strict=True)):
        far = float(np.abs(spot))
        off = MM * slack if cam.translates else math.degrees(slack / far) if far else math.inf
        row = (float(first), MM * slack), (float(second), off)
        yield from cells(RADII, drafting.number(name, FINE), row, may_lack=k % every > 0)
    yield from (*_notes(values, slack), *_hub(values, spots, slack), *every_cam(study))


def _figure(
    values: CamValues, turns: WorkshopTurns, spots: Points, slack: float, drafting: Drafting
) -> Iterator[Expected]:
    """Give the curves, the radii or ordinates, the sense of motion."""
    cam = values.cam
    for name, path in values.curves():
        yield Expected(Kind.CURVE, PLAN, name, path, slack + values.drawn)
    for number, (k, turn) in enumerate(turns.rays()):
        said = drafting.number(turn, FINE)
        letter = f"x {said}" if cam.translates else f"φ {said}°"
        end = 1j * spots[k].imag if cam.translates else complex(spots[k])
        yield Expected(Kind.VECTOR, PLAN, "r", end, slack, number, letter=letter)
    yield Expected(Kind.DIRECTION, PLAN, *(("v", -cam.sense) if cam.translates else ("ω", cam.sense)))


def _notes(values: CamValues, slack: float) -> Iterator[Expected]:
    """Give the numbers that a workshop is told: roller, groove, arcs of the dwells."""
    name, roller, resting = values.cam.name, values.found.roller, dwells(values)
    sizes = {f"r_rol {name}": MM * roller, f"breadth {name}": 2 * MM * roller}
    sizes |= {f"r {k} {name}": MM * radius for k, (_, radius) in enumerate(resting)}
    rows = ((quantity, size, 2 * MM * slack) for quantity, size in sizes.items())
    yield from phrases(NOTES, rows, FINE, may_lack=True)
    for k, (phase, _) in enumerate(resting):
        for quantity, turn in ((f"start {k} {name}", phase.start), (f"end {k} {name}", phase.end)):
            yield Expected(Kind.PHRASE, NOTES, quantity, math.degrees(turn), digits=FINE, may_lack=True, period=TURN)


EDGE = 1441  # points of the profile that the wall is measured to


def _hub(values: CamValues, spots: Points, slack: float) -> Iterator[Expected]:
    """Give bore and keyway: their dimensions, the keyway's corners, what is said of them."""
    hub, name = values.cam.hub, values.cam.name
    if hub is None:
        return
    sizes = {"bore": hub.bore, "keyway": hub.width, "over keyway": hub.bore + hub.depth}
    for size in sizes if hub.width else ["bore"]:
        yield from measured(Expected(Kind.LENGTH, "hub", size, sizes[size]), MM * sizes[size], digits=FINE)
    key, end = spots[0] / abs(spots[0]) * np.exp(-1j * values.cam.sense * hub.angle), hub.bore / 2 + hub.depth
    sides = key * np.array([0, end, end, 0] + hub.width / 2 * np.array([-1j, -1j, 1j, 1j]))
    for side, spot in enumerate(sides[1:3] if hub.width else ()):
        yield Expected(Kind.POINT, PLAN, f"keyway {side}", complex(spot), slack * hub.bore / abs(spots[0]))
        yield Expected(Kind.POINT, "hub", f"keyway {side}", complex(1j * spot / key), slack)
    rim = values.at(np.linspace(0.0, values.cam.turn, EDGE)).profile
    ways = [np.abs(rim) - hub.bore / 2]
    for start, side in zip(sides, np.diff(sides), strict=False) if hub.width else ():
        ways.append(np.abs(rim - start - side * np.clip(((rim - start) / side).real, 0.0, 1.0)))
    told = sizes | {"keyway depth": hub.depth, "hub length": hub.length or 0.0, "wall": float(np.min(ways))}
    rows = [(f"{size} {name}", MM * value, MM * slack) for size, value in told.items()]
    yield from phrases(NOTES, (*rows, (f"keyway angle {name}", math.degrees(hub.angle), 0.0)), FINE, may_lack=True)
