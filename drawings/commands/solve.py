"""plandraft solve: all numbers of a scene as JSON, by construction or by analysis."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from drawings.commands.process import tell
from drawings.commands.talk import noted
from drawings.commands.trace import Trace
from drawings.files.json_text import print_json
from drawings.report.numbers import pairs, plain
from plans.linkage.study import LinkageStudy
from plans.model.motion import Extremes, Gap, Motion
from plans.model.order import ORDERS
from plans.scene.scene import read_scene

if TYPE_CHECKING:
    from plans.model.kinetostatics import Kinetostatics
    from plans.model.losses import Friction

GAPS = 4
FORCES = ("forces", "friction")


def run(options: argparse.Namespace) -> int:
    """Print the numbers; give the exit code."""
    trace: Trace = options.trace or Trace()
    with trace.stage("reading the scene"):
        study = LinkageStudy(noted(read_scene(options.scene), forces=not {*FORCES}.isdisjoint(options.only or ())))
    wanted = options.only or wanted_of(study)
    orders = [order.number for order in ORDERS if order.plan in wanted]
    forces = [name for name in FORCES if name in wanted]
    with trace.stage(options.by):
        road = _analysis if options.by == "analysis" else _construction
        found = road(study, 2 if forces else max(orders), forces)
    with trace.stage("writing"):
        told = described(study, found.motion, orders, found.extremes)
        print_json({**told, **found.told})
    if options.trace:
        tell(trace.told(study.made))
    return GAPS if found.gaps or found.told.get("jams") else 0


def wanted_of(study: LinkageStudy) -> list[str]:
    """Give what the sheets of a scene ask for: the motion, and forces and friction where a force sheet is wanted."""
    wanted = [order.plan for order in ORDERS]
    if "forces" in study.scene.sheets:
        wanted += [*FORCES] if study.scene.friction else ["forces"]
    return wanted


class Numbers(NamedTuple):
    """What one road found: motion, extremes, and the numbers of forces and friction as plain data."""

    motion: Motion
    extremes: Extremes | None
    told: dict[str, Any]
    gaps: bool


def _construction(study: LinkageStudy, order: int, forces: Sequence[str]) -> Numbers:
    motion = study.motion(order)
    extremes = study.found.extremes if study.scene.drive.first is None and study.found else None
    if not forces:
        return Numbers(motion, extremes, {}, bool(motion.gaps))
    from plans.forces.statics import Statics

    statics = Statics(study)

    def rubbed() -> Friction:
        from plans.forces.friction import friction

        return friction(study.mechanism, study.groups, statics.machine, motion, statics.loading(motion), statics.forces)

    told = _forces(study, forces, statics.forces, rubbed)
    return Numbers(motion, extremes, told, bool(statics.forces.gaps))


def _analysis(study: LinkageStudy, order: int, forces: Sequence[str]) -> Numbers:
    """Solve by analysis alone: a start at an extreme is found by analysis too."""
    from plans.analytic.kinematics import Analysis

    road = Analysis(study.mechanism, first=study.scene.drive.first is not None, looks=study.looks.phi)
    found, phi = None, None
    if not road.first:
        found = road.extremes(study.output)
        if found is not None:  # else the turn says why there is none
            count = study.scene.drive.count
            phi = found.phi[0] + study.sense * 2 * np.pi * np.arange(count) / count
    motion = road.motion(study.turn.phi if phi is None else phi, order)
    if not forces:
        return Numbers(motion, found, {}, bool(motion.gaps))
    from plans.analytic.kinetostatics import kinetostatics
    from plans.forces.loading import loading
    from plans.forces.statics import Statics

    statics = Statics(study)
    loads = loading(statics.machine, motion, statics.over(road.extremes))
    solved = kinetostatics(road, statics.machine, motion, loads, statics.pairs)

    def rubbed() -> Friction:
        from plans.analytic.friction import friction

        return friction(road, statics.machine, motion, loads, solved, statics.pairs)

    return Numbers(motion, found, _forces(study, forces, solved, rubbed), bool(solved.gaps))


def _forces(
    study: LinkageStudy, wanted: Sequence[str], forces: Kinetostatics, friction: Callable[[], Friction]
) -> dict[str, Any]:
    """Give what is wanted of the forces of one road as plain data; their gaps stand beside those of the motion."""
    from drawings.report.force_numbers import described as described_forces
    from drawings.report.force_numbers import rubbed

    told: dict[str, Any] = {"gaps": [_gap(gap) for gap in forces.gaps]}
    if "forces" in wanted:
        told |= described_forces(forces, complex(*(float(x) for x in study.mechanism.datum)))
    if "friction" in wanted:
        told |= rubbed(friction())
    return told


def described(study: LinkageStudy, motion: Motion, orders: list[int], extremes: Extremes | None) -> dict[str, Any]:
    """Give the numbers as plain data: SI units and radians, null at gaps, coordinates of the scene."""
    datum = complex(*(float(x) for x in study.mechanism.datum))
    result: dict[str, Any] = {
        "scene": study.scene.title,
        "by": motion.by,
        "phi": plain(motion.phi),
        "gaps": [_gap(gap) for gap in motion.gaps],
        "points": {
            name: {ORDERS[k].point.key: pairs(found[k] + (datum if k == 0 else 0)) for k in orders}
            for name, found in sorted(motion.points.items())
        },
        "links": {
            str(number): {ORDERS[k].link.key: plain(found[k]) for k in orders}
            for number, found in sorted(motion.links.items())
        },
    }
    if extremes is not None:
        result["extremes"] = {
            "phi": list(extremes.phi),
            "reach": list(extremes.reach),
            "stroke": extremes.stroke,
            "overlap": extremes.overlap,
            "ratio": extremes.ratio,
        }
    return result


def _gap(gap: Gap) -> dict[str, Any]:
    return {
        "position": gap.position, "phi": gap.phi, "plan": gap.plan, "reason": gap.reason, "where": gap.where,
        "miss": gap.miss, "advice": gap.advice,
    }  # fmt: skip
