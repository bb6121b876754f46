"""A trial: one random scene goes both roads, and what they tell apart is told (испытание)."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

import numpy as np

from plans.linkage.quantities import MotionComparison, compare, compare_extremes
from plans.linkage.study import LinkageStudy
from plans.model.motion import FORCES, Motion
from plans.quantity import Comparison
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.trials.chains import chain
from tests.trials.changes import change
from tests.trials.crank_rockers import crank_rocker

KINDS = {"crank-rockers": (crank_rocker, 10_000), "chains": (chain, 2_000), "changes": (change, 2_000)}


def text_of(kind: str, number: int) -> str:
    """Write the scene of a trial: the same for ever by its kind and number."""
    return KINDS[kind][0](Random(f"{kind} {number}"))


def study_of(kind: str, number: int) -> Study:
    """Read the scene of a trial."""
    return Study(parse_scene(text_of(kind, number), f"{kind}-{number}.toml"))


def apart(study: Study) -> Iterator[str]:
    """Tell where the roads differ, and where they give up other positions, or the same for another reason."""
    linkage = study["linkage"]
    compared: list[Comparison] = [compare_extremes(linkage, compare(linkage))]
    if "forces" in linkage.scene.sheets:
        compared.append(study.comparison("forces"))
    for one in compared:
        yield from (f"{found.name} ({found.plan})" for found in one.findings if float(found.excess.max()) > 1)
        yield from (f"{by} alone has no forces: {gap.reason}" for by, gap in one.alone if gap.plan == FORCES)
    yield from _one_sided(linkage, compared[0])


def _one_sided(linkage: LinkageStudy, comparison: Comparison) -> Iterator[str]:
    """Look at the gaps of both roads before any position is left out of the comparison."""
    assert isinstance(comparison, MotionComparison)
    ours, theirs = linkage.motion(2), comparison.road.motion(linkage.turn.phi, 2)
    for k, (one, other) in enumerate(zip(_states(ours), _states(theirs), strict=True)):
        if one != other or _told(ours, k) != _told(theirs, k):
            yield f"position {k}: construction {one} {_told(ours, k)}, analysis {other} {_told(theirs, k)}"


def _states(motion: Motion) -> list[int]:
    """Count at every position how many orders of the motion are whole: places, velocities, accelerations."""
    have, orders = np.ones(len(motion.phi), dtype=bool), np.zeros(len(motion.phi), dtype=np.intp)
    for order in range(3):
        rows = [row[order] for row in (*motion.points.values(), *motion.links.values())]
        have = have & np.all([np.isfinite(np.broadcast_to(row, have.shape)) for row in rows if row is not None], axis=0)
        orders += have
    return orders.tolist()


def _told(motion: Motion, position: int) -> str:
    """Give plan and reason of a gap as a road tells them."""
    return ", ".join(sorted({f"{gap.plan}: {gap.reason}" for gap in motion.gaps if gap.position == position}))
