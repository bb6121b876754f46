"""plandraft solve: all numbers of a scene as JSON, by construction or by analysis."""

from __future__ import annotations

import argparse
import json
import math
import sys
from typing import Any

import numpy as np

from drawings.talk import noted
from drawings.trace import Trace
from plans.motion import LINK_KEYS, ORDERS, POINT_KEYS, Extremes, Gap, Motion
from plans.scene import read_scene
from plans.study import Study

GAPS = 4


def run(options: argparse.Namespace) -> int:
    """Print the numbers; give the exit code."""
    trace: Trace = options.trace or Trace()
    with trace.stage("reading the scene"):
        study = Study(noted(read_scene(options.scene)))
    orders = [ORDERS.index(name) for name in options.only] if options.only else [0, 1, 2]
    with trace.stage(options.by):
        if options.by == "analysis":
            motion, extremes = _analysis(study, max(orders))
        else:
            motion = study.motion(max(orders))
            extremes = study.found.extremes if study.scene.drive.first is None and study.found else None
    with trace.stage("writing"):
        print(json.dumps(described(study, motion, orders, extremes), allow_nan=False))
    if options.trace:
        print(trace.told(study.made), file=sys.stderr)
    return GAPS if motion.gaps else 0


def _analysis(study: Study, order: int) -> tuple[Motion, Extremes | None]:
    """Solve by analysis alone: a start at an extreme is found by analysis too."""
    from plans.analytic.extremes import extremes
    from plans.analytic.kinematics import solve

    if study.scene.drive.first is not None:
        return solve(study.mechanism, study.turn.phi, order), None
    found = extremes(study.mechanism, study.output)
    if found is None:
        return solve(study.mechanism, study.turn.phi, order, first=False), None  # the turn says why there is none
    count = study.scene.drive.count
    phi = found.phi[0] + study.sense * 2 * np.pi * np.arange(count) / count
    return solve(study.mechanism, phi, order, first=False), found


def described(study: Study, motion: Motion, orders: list[int], extremes: Extremes | None) -> dict[str, Any]:
    """Give the numbers as plain data: SI units and radians, null at gaps, coordinates of the scene."""
    datum = complex(*(float(x) for x in study.mechanism.datum))
    result: dict[str, Any] = {
        "scene": study.scene.title,
        "by": motion.by,
        "phi": _plain(motion.phi),
        "gaps": [_gap(gap) for gap in motion.gaps],
        "points": {
            name: {POINT_KEYS[k]: _pairs(getattr(found, POINT_KEYS[k]) + (datum if k == 0 else 0)) for k in orders}
            for name, found in sorted(motion.points.items())
        },
        "links": {
            str(number): {LINK_KEYS[k]: _plain(getattr(found, LINK_KEYS[k])) for k in orders}
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


def _plain(values: Any) -> list[float | None]:
    """Give numbers, null for NaN, and no -0."""
    return [None if math.isnan(value) else value for value in (values + 0.0).tolist()]


def _pairs(values: Any) -> list[list[float] | None]:
    both = zip((values.real + 0.0).tolist(), (values.imag + 0.0).tolist(), strict=True)
    return [None if math.isnan(x) or math.isnan(y) else [x, y] for x, y in both]
