"""The plan of characteristic positions held to the analysis: links, pins, notches, dimensions (план положений)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.checks.linkage import (
    bars,
    drive_arrows,
    guides,
    pair_symbols,
    paths,
    position_marks,
    stroke_dimensions,
    strokes,
    ticks,
)
from drawings.checks.linkage.laid import Ground, LaidMechanism
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.notches import about, notched
from drawings.checks.linkage.position_marks import named
from drawings.checks.linkage.stroke_dimensions import DueStroke, length, on_guide
from drawings.checks.numbers import position_numbers
from drawings.checks.vectors import plan_headings
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Arc, Circle, Group, Leaf, Stroke
from drawings.paper.walk import flat
from geometry.board import Arc as Notch
from plans.checks.compare import road_of
from plans.cyclogram.study import CyclogramStudy
from plans.linkage.travel import frame_slide
from plans.model.cyclogram import BEGIN, END, ENTRY, EXIT, Cyclogram
from plans.model.mechanism import FRAME
from plans.model.order import POSITIONS

PLAN, TITLE = "characteristic", "characteristic positions"
OVERRUNS, NOTCHES, PINS = "overruns", "notches", "pins"  # the names of its groups
# The groups of a plan of positions, and its own.
KNOWN = {"paths", "all-positions", "extremes", "guides", "ties", "path-ticks", "grounds", "shown-position", "pairs"}
KNOWN |= {"stroke", "rotation", "phases", "swing", OVERRUNS, NOTCHES, PINS}
LONG = 6.0  # mm of a notch's arc on each side of the place that it leads to, by the size of symbols
FAR = 1e-9  # of the mechanism's size: both roads agree in a place far better


def faults(measured: Measured, leaf: Leaf, study: CyclogramStudy, found: Cyclogram, at: Ground) -> Iterator[Wrong]:
    """Hold all that the plan shows to the analysis: it lies as that has the mechanism in each of its positions."""
    turned, road = np.array([one.turned for one in found.positions]), road_of(study.linkage)
    shown = found.number(ENTRY if found.of(ENTRY) else EXIT)
    laid = LaidMechanism(study.pictured, road.motion(found.sense * turned, 0), shown, at)
    plan = LaidPlan(leaf, laid, road, FAR * laid.reach / at.scale)
    own = Characteristic(plan, study, found)
    yield from own.points(measured)
    yield from own.strangers()
    yield from plan_headings.of_positions(leaf, at.scale, drafting_of(study.scene), TITLE)
    for part in (bars, position_numbers, guides, pair_symbols, paths, drive_arrows):
        yield from part.faults(plan)
    yield from position_marks.faults(leaf, laid)
    yield from ticks.faults(leaf, laid)
    yield from strokes.faults(leaf, laid, plan.told)
    yield from stroke_dimensions.faults(leaf, laid, road, others=False)
    yield from stroke_dimensions.held(own.drawn(OVERRUNS), list(own.overruns()))
    yield from own.notches()


class Notched(NamedTuple):
    """A notch of the construction on paper: the centre of its arc, and the place that it leads to."""

    centre: complex
    tip: complex


class Characteristic(NamedTuple):
    """What the plan has beside a plan of any positions."""

    plan: LaidPlan
    study: CyclogramStudy
    found: Cyclogram

    def drawn(self, name: str) -> list[Stroke]:
        """Give the strokes of the groups of a name, as they follow each other."""
        return [stroke for group in named(self.plan.leaf, name) for stroke in group.strokes]

    def strangers(self) -> Iterator[Wrong]:
        """See that the plan has no other layers, and as many pins as positions in thin lines, with the pivot's."""
        layers = self.drawn(PLAN)
        if any(not isinstance(one, Group) or one.name not in KNOWN for one in layers):
            yield on("line", PLAN)
        pins = [stroke for one in layers if isinstance(one, Group) and one.name == PINS for stroke in flat((one,))]
        if len(pins) != len(self.found.positions) or not all(isinstance(one, Circle) for one in pins):
            yield on("stranger_on", PLAN, name=PINS)

    def points(self, measured: Measured) -> Iterator[Wrong]:
        """Hold the crank's pins and the points of the position in full lines; none may be missing."""
        true, seen = self._true(), {(one.plan, one.name): one for one in measured.points}
        size = max(abs(value) for value in true.values())
        for (plan, name), value in true.items():
            mark = seen.get((plan, name))
            if mark is None:
                yield on("missing_on", PLAN, name=name)
            elif not abs(mark.value - value) <= FAR * size + 2 * measured.quantum * mark.scale:
                yield on("differs_on", PLAN, name=name)
        yield from (on("stranger_on", PLAN, name=name) for plan, name in seen.keys() - true.keys())

    def _true(self) -> dict[tuple[str, str], complex]:
        """Give the places that the plan must show, m from the datum, by plan and name."""
        laid, motion = self.plan.laid, self.plan.laid.motion
        drive, fixed = laid.mechanism.drive, laid.mechanism.links[FRAME].points
        places = {name: complex(points.r[laid.position]) for name, points in motion.points.items()}
        places |= dict(fixed) | {name: laid.true(*centre) for name, centre in laid.centres.items()}
        shown = {(POSITIONS.plan, name): place for name, place in places.items() if name != drive.pivot}
        pins = enumerate(motion.points[drive.end].r.tolist())
        return shown | {(PLAN, f"{drive.end}_{k}"): complex(pin) for k, pin in pins if k != laid.position}

    def overruns(self) -> Iterator[DueStroke]:
        """Give the dimensions that must be there: how far a tool that slides goes past both ends of the work."""
        slide = frame_slide(self.plan.laid.mechanism, self.found.output.link)
        for role, extreme in ((ENTRY, BEGIN), (EXIT, END)):
            own = self.found.of(role)
            if slide is not None and own:
                reach = own[0].place, self.found.of(extreme)[0].place
                text = length(abs(reach[0] - reach[1]), self.plan.laid.study.language)
                yield DueStroke(text, on_guide(self.plan.laid, slide, reach))

    def notches(self) -> Iterator[Wrong]:
        """See that each notch from the tool back to the crank stands at its place, and that there is no other arc."""
        plan, arcs = self.plan, [one for one in self.plan.strokes(NOTCHES) if isinstance(one, Arc)]
        due = [*self._notched()]
        if not all(any(notched(arc, one.centre, one.tip, plan) for arc in arcs) for one in due):
            yield on("notch", PLAN, name=NOTCHES)
        if len(arcs) < len(plan.strokes(NOTCHES)) or not all(
            any(about(arc, one.centre, one.tip, plan) and self._near(arc, one) for one in due) for arc in arcs
        ):
            yield on("stranger_on", PLAN, name=NOTCHES)

    def _near(self, arc: Arc, one: Notched) -> bool:
        longest = LONG * drafting_of(self.study.scene).hand.symbol + self.plan.near
        return max(abs(arc.at(share) - one.tip) for share in (0.0, 1.0)) <= longest

    def _notched(self) -> Iterator[Notched]:
        """Give the notches by what the construction has struck from points that move."""
        marks = (mark for board in self.study.boards for mark in board if mark.step.op == "meet")
        for mark in marks:
            for (source, ray), locus in zip(mark.rays, mark.step.inputs, strict=False):
                centres, rays = np.broadcast_arrays(np.atleast_1d(source.point), np.atleast_1d(ray))
                if isinstance(locus.value, Notch) and np.ptp(centres.real) + np.ptp(centres.imag) > 0:
                    for centre, arm in zip(centres.tolist(), rays.tolist(), strict=True):
                        yield Notched(self.plan.laid.at.on(centre), self.plan.laid.at.on(centre + arm))
