"""What must stand on the sheets of a cam, by the analysis alone: law, sizes, angle, profile, table (кулачок)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from drawings.cam.due_notes import DEGREES, CamNumbers, every_cam, numbers_of
from drawings.cam.due_values import ACCELERATION, TRAVEL, VELOCITY, CamValues, law_named
from drawings.checks.expected import Cell, Expected, by_hand, cells, measured, phrases, subject
from drawings.cyclogram.due_rows import cam_rows, chart
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from drawings.paper.walk import groups, stated
from drawings.reading.pathdata import pair
from geometry.strips import departure
from plans.analytic.cam.contour import ContourValues
from plans.cam.numbers import cam_by_hand, readings
from plans.cyclogram.rows import EVERY
from plans.model.cam import MM, RETURN, RISE, limits_of
from plans.model.cam_motion import HARD
from plans.model.motion import Floats
from plans.study import Study

PROFILE, SIZES, PRESSURE = "profile", "sizes", "pressure"  # the names of the figures
LETTERS = {ACCELERATION: "''", VELOCITY: "'", TRAVEL: ""}
COMPARED = {ACCELERATION: "S''", VELOCITY: "S' chords", TRAVEL: "S chords"}
DIGITS = 5
NEAREST = 1e-9  # of the largest value: chords that are exact but for the roundings of their steps


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of one cam, or of the shaft of several."""
    name = subject(leaves[0])
    if name == EVERY:
        yield from chart(cam_rows([found.cam for found in study.comparison("cam").analysis.cams]))
    else:
        facts = (leaf.metadata["scales"] for leaf in leaves)
        scales: Mapping[str, float] = next((named for named in facts if SIZES in named), {})
        marks = [mark for leaf in leaves for mark in groups(leaf.groups)]
        of_profile = (mark.data for mark in marks if mark.data.get("plan") == PROFILE)
        drawn = {data["name"]: data for data in of_profile if data.get("name") in ("R_0", "ρ_min")}
        said = [mark.states for leaf in leaves for mark in stated(leaf.groups) if mark.states is not None]
        axes = {(axis.figure, axis.name): axis.scale for axis in said if axis.kind is Kind.AXIS}
        cam = _ExpectedCam(numbers_of(study, name), scales, drawn, axes, drafting_of(study.scene))
        yield from chain(cam.laws(), cam.phases(), cam.pressure(), cam.profile(), cam.sizes(), cam.table())
    yield from every_cam(study)


@dataclass(frozen=True)
class _ExpectedCam:
    """A cam by the analysis, with the scales and the data of chosen directions that its sheets show."""

    numbers: CamNumbers
    scales: Mapping[str, float]
    drawn: Mapping[str, Mapping[str, str]]
    axes: Mapping[tuple[str, str], float]
    drafting: Drafting

    @property
    def values(self) -> CamValues:
        return self.numbers.values

    @cached_property
    def slack(self) -> float:
        """How far rounding may have moved a point of the profile, m."""
        return float(np.max(self.values.compared.slack.profile))

    def laws(self) -> Iterator[Expected]:
        """Give the diagrams of the law: ordinates, curves, impulses, how far chords are off."""
        values, cam = self.values, self.values.cam
        letter = "ψ" if cam.rocks else "S"
        for key, row in values.rows.items():
            plan, slack = law_named(cam, key), self.numbers.slack(COMPARED[key])
            for k, name in enumerate(values.names):
                yield Expected(Kind.VECTOR, plan, name, 1j * row.after[k], slack, k, may_lack=True, letter=name)
            ends = (0.0, cam.turn)
            yield Expected(Kind.CURVE, plan, letter + LETTERS[key], row.curve, slack, ends=ends)
        for shock in values.found.shocks:
            if shock.order == HARD:
                yield from self._impulse(shock.turned, math.copysign(1.0, shock.jump))
        slope, s = values.compared.chords
        for key, chords, exact in ((VELOCITY, slope, values.before.slope[1:]), (TRAVEL, s, values.after.s)):
            share = departure(chords, exact).share
            yield Expected(Kind.PHRASE, law_named(cam, key), "off", 100 * share, 100 * NEAREST, digits=2)
        for key, above in ((VELOCITY, ACCELERATION), (TRAVEL, VELOCITY)):
            yield from self._pole(law_named(cam, key), law_named(cam, above))

    def _pole(self, plan: str, above: str) -> Iterator[Expected]:
        """Give the distance of the pole, mm: by it the scale of a diagram follows from the scales of the one above."""
        turn, high, here = (self.axes.get(axis, math.nan) for axis in ((above, "x"), (above, "y"), (plan, "y")))
        yield Expected(Kind.PHRASE, plan, "H", here / (high * turn), digits=4, may_lack=True)

    def _impulse(self, turned: float, sense: float) -> Iterator[Expected]:
        """Give the arrow of an impulse of S''; the end of a turn is its beginning."""
        values = self.values
        plan, turn = law_named(values.cam, ACCELERATION), values.cam.turn
        for k, edge in enumerate(values.edges):
            off = abs(edge - turned)
            if min(off, off if values.cam.translates else abs(turn - off)) <= NEAREST * turn:
                yield Expected(Kind.DIRECTION, plan, values.names[k], 1j * sense, 0.0, k, may_lack=True)

    def phases(self) -> Iterator[Expected]:
        """Give the phases by their dimensions, arcs and numbers; a cam may rest so shortly that it has none."""
        cam = self.values.cam
        law, unit = law_named(cam, "phases"), MM if cam.translates else DEGREES
        for k, phase in enumerate(cam.phases):
            name, size = f"φ_{k}", phase.end - phase.start
            yield Expected(Kind.LENGTH, law, name, size, may_lack=not phase.angle > 0)
            kind = Kind.LENGTH if cam.translates else Kind.ANGLE
            yield Expected(kind, PROFILE, name, size, NEAREST)
            for figure in (law, PROFILE, PRESSURE):
                lacks = figure == PRESSURE or not phase.angle > 0
                yield Expected(Kind.PHRASE, figure, name, unit * size, digits=DIGITS, may_lack=lacks)

    def pressure(self) -> Iterator[Expected]:
        """Give the graph of the pressure angle: curve, ordinates, extremes, limits."""
        values, cam, found = self.values, self.values.cam, self.values.found
        if not cam.pressed:
            return

        def angle(turned: Floats) -> Floats:
            return np.degrees(ContourValues(cam, values.sizes, turned).pressure)

        slack = DEGREES * self.numbers.slack("α")
        yield Expected(Kind.CURVE, PRESSURE, "α", angle, slack, ends=(0.0, cam.turn))
        for k, value in enumerate(np.degrees(values.contour.pressure).tolist()):
            yield Expected(Kind.VECTOR, PRESSURE, str(k), 1j * value, slack, k, may_lack=True, letter=str(k))
        for kind, extreme in found.pressure.items():
            value, off = DEGREES * extreme.value, DEGREES * self.numbers.slack(f"α_{kind}")
            lacks = not abs(value) > off
            row = Expected(Kind.VECTOR, PRESSURE, kind, 1j * value, off, may_lack=lacks)
            yield from measured(row, value, digits=4, unit=1.0)
        limits = ((kind, high if kind == RISE else low) for kind, (low, high) in self._limits())
        levels = ((f"[α_{kind}]", abs(DEGREES * limit), 0.0) for kind, limit in limits)
        yield from phrases(PRESSURE, levels, digits=4, may_lack=True)

    def _limits(self) -> Iterator[tuple[str, tuple[float, float]]]:
        """Give the limits that the sizes are found for, rad."""
        for kind in (RISE, RETURN):
            interval = limits_of(self.values.cam).interval(kind, self.values.cam.closure)
            if interval is not None:
                yield kind, interval

    def profile(self) -> Iterator[Expected]:
        """Give the figure of the profile: curves, points, normals, sizes, senses."""
        values, cam, found = self.values, self.values.cam, self.values.found
        for name, path in values.curves():
            yield Expected(Kind.CURVE, PROFILE, name, path, self.slack + values.drawn)
        for name, spots in values.points().items():
            for k, spot in enumerate(spots.tolist()):
                yield Expected(Kind.POINT, PROFILE, name, spot, self.slack, k, may_lack=True, letter=str(k))
        for name, ways in values.normals().items():
            for k, way in enumerate(ways.tolist()):
                yield Expected(Kind.VECTOR, PROFILE, name, way, self.slack, k, may_lack=True, letter=str(k))
        yield from self._lengths()
        senses = {"v": -cam.sense} if cam.translates else {"ω": cam.sense, "−ω": -cam.sense}
        yield from (Expected(Kind.DIRECTION, PROFILE, name, complex(sense)) for name, sense in senses.items())
        if cam.rocks and not cam.translates:
            initial = abs(found.sizes.initial)
            row = Expected(Kind.ANGLE, PROFILE, "ψ_0", initial, self.numbers.slack("ψ_0"), may_lack=True)
            yield from measured(row, DEGREES * initial, digits=4, unit=DEGREES)

    def _lengths(self) -> Iterator[Expected]:
        """Give the sizes in the figure of the profile; two of them go where there is room, or about a sharp place."""
        values, sizes, found = self.values, self.values.sizes, self.values.found
        true = {"R_0": complex(sizes.base), "e": complex(values.cam.sense * sizes.offset), "L": sizes.pivot}
        true = {} if values.cam.translates else true
        numbers = {name: self.numbers.size(name) for name in true}
        if found.sharpest is not None:
            true["ρ_min"] = complex(found.sharpest.value)
            numbers["ρ_min"] = self.numbers.radius("ρ_min", found.sharpest)
        for name, value in true.items():
            way = cmath.phase(pair(self.drawn[name]["value"])) if name in self.drawn else 0.0
            number, slack = numbers[name]
            row = Expected(Kind.VECTOR, PROFILE, name, value * cmath.rect(1.0, way), slack / MM, may_lack=True)
            yield from measured(row, number, digits=4)
        if sizes.pivot:
            yield Expected(Kind.POINT, PROFILE, "O_1", sizes.pivot, self.numbers.slack("O1"))

    def sizes(self) -> Iterator[Expected]:
        """Give the diagram of the sizes: its curve and points, O, the sizes that are dimensioned, the limits."""
        values, cam = self.values, self.values.cam
        if cam.translates:
            return
        arm = values.compared.slack.reach if cam.rocks else 1.0
        slack = self.slack + self.numbers.slack("S''" if cam.flat else "S'") * arm
        yield Expected(Kind.POINT, SIZES, "O", -values.zero, self.numbers.slack("R_0"))
        if not (cam.flat and cam.rocks):
            yield Expected(Kind.CURVE, SIZES, "D", values.diagram, slack)
            for k, end in enumerate(values.ends(values.contour).tolist()):
                yield Expected(Kind.POINT, SIZES, "D", end, slack, k, may_lack=True, letter=str(k))
            for k in range(1, len(values.edges)):
                yield Expected(Kind.POINT, SIZES, f"T_{k}", values.diagram, slack, may_lack=True)
        yield Expected(Kind.POINT, SIZES, "O'", -values.zero, math.inf, may_lack=True)  # by the chord: beside O
        reaches = {"L": values.zero} if cam.rocks else {}
        if not cam.flat:
            reaches["R_0"] = values.lowest
        elif cam.rocks:
            reaches["R_0"] = complex(values.contour.lever[0]) * values.turned_back * values.sizes.base
        for name, reach in reaches.items():
            yield Expected(Kind.VECTOR, SIZES, name, reach, self.numbers.slack("R_0"))
        yield from self._dimensions()

    def _dimensions(self) -> Iterator[Expected]:
        cam, numbers = self.values.cam, self.numbers
        sizes = {name: numbers.size(name) for name in ("R_0", "e", "S_0", "L")}
        sizes |= {
            name: (MM * (size or 0.0), 0.0) for name, size in (("l", cam.follower.length), ("h", cam.follower.face))
        }
        if self.values.found.sharpest is not None:
            sizes["ρ_{min}"] = numbers.radius("ρ_min", self.values.found.sharpest)
        for name, (number, slack) in sizes.items():
            row = Expected(Kind.LENGTH, SIZES, name, abs(number) / MM, slack / MM, may_lack=True)
            yield from measured(row, number, digits=4)
        for kind, (low, high) in self._limits():
            ends = (f"α_{kind}", high if kind == RISE else -low), (f"−α_{kind}", low)
            yield from phrases(SIZES, ((name, DEGREES * angle, 0.0) for name, angle in ends), 4, may_lack=True)

    def table(self) -> Iterator[Expected]:
        """Give the cells of the table: by plan, by analysis, drawing error; of what is given that it is."""
        drawing = self.values.drawing
        slips = cam_by_hand(drawing, self.scales) if any(readings(drawing)) else None
        for letter, unit, (value, slack), given in self._quantities():
            title = self.drafting.letter(letter)
            name = f"{title}, {self.drafting.word(unit)}" if unit else title
            found = self.drafting.word("cam given") if given else (value, slack)
            row: list[Cell] = [(value, slack), found]
            if slips is not None:
                error = math.nan if given else slips.get((letter, 0), math.nan)
                row.append(by_hand(error, abs(value) or 1.0))
            yield from cells(SIZES, name, row, digits=DIGITS)

    def _quantities(self) -> Iterator[tuple[str, str, Any, bool]]:
        """Give letter, unit, value with its slack, and whether the scene gives it, of every row."""
        cam, found, numbers = self.values.cam, self.values.found, self.numbers
        if not cam.translates:
            yield "R_0", "mm", numbers.size("R_0"), cam.given.base is not None
        if not (cam.rocks or cam.flat or cam.translates):
            yield "e", "mm", numbers.size("e"), cam.given.offset is not None
            yield "S_0", "mm", numbers.size("S_0"), False
        if cam.rocks:
            yield "L", "mm", numbers.size("L"), cam.given.centre is not None
            yield "ψ_0", "°", numbers.size("ψ_0"), False
        if found.roller:
            yield "r_{rol}", "mm", numbers.size("r_rol"), cam.roller is not None
        yield "Ψ" if cam.rocks else "H", "°" if cam.rocks else "mm", (numbers.way * cam.lift, 0.0), True
        for name, mark, extreme in (("ρ_min", "ρ_{min}", found.sharpest), ("ρ_hollow", "ρ_{hol}", found.hollow)):
            if extreme is not None:
                yield mark, "mm", numbers.radius(name, extreme), False
                yield self._at(mark, extreme.turned)
        for k, (side, far) in enumerate(zip(("back", "front"), found.face if cam.flat else (), strict=False), 1):
            yield f"b_{k}", "mm", (MM * abs(far), MM * self.numbers.slack(f"face_{side}")), False
        for kind in (RISE, RETURN) if cam.pressed else ():
            if kind in found.pressure:
                mark, extreme = f"α_{{{kind}}}", found.pressure[kind]
                yield mark, "°", (DEGREES * extreme.value, DEGREES * self.numbers.slack(f"α_{kind}")), False
                yield self._at(mark, extreme.turned)
        yield from self._motion()

    def _motion(self) -> Iterator[tuple[str, str, Any, bool]]:
        """Give the largest velocity and acceleration, and the shocks."""
        cam, found, way = self.values.cam, self.values.found, "ωε" if self.values.cam.rocks else "va"
        for order, (name, peak) in enumerate(found.peaks.items() if cam.speed is not None else (), 1):
            speed = (cam.speed or 0.0) ** order
            unit = f"{'rad' if cam.rocks else 'm'}/s{'' if order == HARD else '2'}"
            most = abs(peak.value) * speed, self.numbers.slack(f"{name}_max") * speed
            yield f"{way[order - 1]}_{{max}}", unit, most, False
        bare = "ψ" if cam.rocks else "S"
        for k, shock in enumerate(found.shocks, 1):
            jumps = bare + "'" * shock.order if cam.speed is None else way[shock.order - 1]
            yield f"Δ{jumps}_{{{k}}}", self.numbers.unit(shock), self.numbers.jump(shock), False
            yield self._at(f"Δ{jumps}_{{{k}}}", shock.turned)

    def _at(self, letter: str, turned: float) -> tuple[str, str, Any, bool]:
        key, unit = ("cam travel at", "mm") if self.values.cam.translates else ("cam angle at", "°")
        return self.drafting.word(key, letter=letter), unit, self.numbers.place(turned), False
