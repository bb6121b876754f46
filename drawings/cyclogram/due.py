"""What must stand on the sheet of a cyclogram by the analysis alone: plan, charts, table (лист циклограммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks.expected import Expected, cells
from drawings.cyclogram.due_rows import chart, machine_rows
from drawings.linkage.due import mass_centres, measures
from drawings.page.page import drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.points import placed
from plans.cyclogram.quantities import CyclogramComparison
from plans.cyclogram.study import CyclogramStudy
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.cyclogram import Cyclogram
from plans.model.mechanism import FRAME
from plans.model.motion import POSITIONS
from plans.study import Study

CHARACTERISTIC, TABLE = "characteristic", "stations"
FAR = 1e-9  # of the mechanism's size: both roads agree in a place far better
ANGLES, LENGTHS, WHOLE = 1e-5, 1e-3, 360.0  # degrees and mm that both roads may differ by; a turn


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's cyclogram."""
    found: Cyclogram = study.of(CyclogramComparison).analysis
    rows = machine_rows(found, study.of(CyclogramStudy).cams)
    yield from chart(rows, found.positions[0].turned)
    yield from _table(study, found)
    for leaf in leaves[:1]:
        yield from _plan(study, found, leaf.metadata["characteristic"])
        for row in measures(study.of(LinkageStudy), study.of(MotionComparison), drafting_of(study.scene)):
            yield row._replace(may_lack=True)


def _plan(study: Study, found: Cyclogram, shown: int) -> Iterator[Expected]:
    """Give the crank's pins of all positions, and the points of the one in full lines."""
    ours = study.of(CyclogramStudy)
    mechanism, turned = ours.pictured.mechanism, [position.turned for position in found.positions]
    # The sketch is of the first position of the scene: there the analysis is assembled, and goes on to the others.
    phi = np.concatenate([ours.linkage.turn.phi[:1], found.sense * np.array(turned)])
    motion = study.of(MotionComparison).road.around(phi, 0)
    drive, fixed = mechanism.drive, mechanism.links[FRAME].points
    places = {name: complex(point.r[1 + shown]) for name, point in motion.points.items()} | dict(fixed)
    size = max(abs(place) for place in places.values())
    for name, place in places.items():
        if name != drive.pivot:
            yield Expected(Kind.POINT, POSITIONS.plan, name, place, FAR * size, shown)
    for name, (link, centre) in mass_centres(ours.pictured).items():
        spot = complex(placed(mechanism, motion, link, centre)[1 + shown])
        yield Expected(Kind.POINT, POSITIONS.plan, name, spot, FAR * size, shown)
    for k, pin in enumerate(motion.points[drive.end].r[1:].tolist()):
        lacks = k == shown
        yield Expected(Kind.POINT, CHARACTERISTIC, f"{drive.end}_{k}", complex(pin), FAR * size, k, may_lack=lacks)


def _table(study: Study, found: Cyclogram) -> Iterator[Expected]:
    word = drafting_of(study.scene).word
    for k, position in enumerate(found.positions):
        row = f"{k}  {word(f'role {position.role}')}"
        gone = position.share * (1000 * found.stroke if found.sliding else math.degrees(found.stroke))
        yield from cells(TABLE, row, [(gone, LENGTHS), (math.degrees(position.turned), ANGLES, WHOLE)])
