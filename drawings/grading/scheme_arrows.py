"""Arrows and arcs that are not to scale, on loading schemes and the lever: each has its way (стрелки на схемах)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.grading import verdict
from drawings.grading.allowance import DEVIATIONS, Allowances
from drawings.grading.curves.drawn_figure import chains
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.onlooker import TIP
from drawings.grading.verdict import Verdict
from drawings.paper.strokes import Arc, Fill, Group, Leaf, Line
from drawings.paper.walk import groups
from drawings.reading.sheet import SeenSheet
from geometry.hand_error import EDGE
from plans.model.motion import Complexes

FIGURE = "scheme-"  # how the name of the figure of a loading scheme begins
COUPLE = "M^Φ"  # how the letters of a moment of inertia forces begin
SHARES = np.linspace(0.0, 1.0, 9)  # of an arc
# What is said of a force that shows the other way, by how its letters begin.
TURNED = {"Φ": verdict.INERTIA, "G": verdict.UPWARD, "R": verdict.REACTION, "P": verdict.REACTION}
REVERSED = (verdict.INERTIA, verdict.UPWARD, verdict.REACTION, verdict.REVERSED)


def arrows_on(leaf: Leaf, plan: str, position: int | None) -> dict[str, Complexes]:
    """Give the arrows and arcs on the figure of a scheme or a lever by their names, from their starts to their heads.

    Of two of one name there is none: nothing tells which of them is meant.
    """
    found: dict[str, list[Complexes]] = {}
    for group in groups(_figures(leaf, plan, position)):
        path = _headed(group)
        if path is not None:
            found.setdefault(group.data.get("name", ""), []).append(path)
    return {name: paths[0] for name, paths in found.items() if len(paths) == 1}


def _figures(leaf: Leaf, plan: str, position: int | None) -> tuple[Group, ...]:
    """Give the figures on a sheet that are of a scheme, or of a lever, in a position."""
    figure = f"{plan.replace('scheme ', FIGURE)}-{position}"
    return tuple(group for group in groups(leaf.groups) if group.name == figure)


def _headed(group: Group) -> Complexes | None:
    """Give places along a force's arrow or a couple's arc up to its head, whichever way it was drawn; None of neither.

    A straight arrow without a head goes as it is drawn; an arc without one has no sense.
    """
    kind, shaft = group.data.get("kind"), group.strokes[0] if group.strokes else None
    tips = [spot for head in group.strokes if isinstance(head, Fill) for spot in head.points]
    path: Complexes | None = None
    if kind == "force" and isinstance(shaft, Line):
        path = np.array([shaft.start, shaft.end])
    elif kind == "couple" and tips:
        arcs = ([arc.at(share) for share in SHARES.tolist()] for arc in group.strokes if isinstance(arc, Arc))
        path = next((np.array(arc) for arc in arcs), next(chains(group.strokes), None))
    if path is None:
        return None
    ends = [any(abs(end - tip) <= TIP for tip in tips) for end in (path[0], path[-1])]
    if ends == [True, False]:
        return path[::-1]
    return path if kind == "force" or ends == [False, True] else None


def arrow_verdicts(sheet: SeenSheet, plan: DrawnPlan, by: Allowances) -> Iterator[Verdict]:
    """Judge the arrows and arcs of a figure: each has the direction of its force, the sense of its moment.

    Of a figure that an editor has taken apart nothing tells which of the arrows of a name are of it.
    """
    asked = plan.asked
    if asked.ways and not _figures(sheet.leaf, *asked.place):
        yield Verdict(*asked.place, "", verdict.UNGROUPED)
        return
    drawn = arrows_on(sheet.leaf, *asked.place) if asked.ways else {}
    for name, way in asked.ways.items():
        path = drawn.get(name)
        if path is None:
            kind = verdict.MISSING
        elif isinstance(way, complex):
            kind = _of_force(name, path, way, max(by.to(name).slip, sheet.measured.quantum))
        else:
            wrong = verdict.COUPLE if name.startswith(COUPLE) else verdict.REVERSED
            kind = verdict.RIGHT if sense_of(path) == way else wrong
        at = None if path is None else (complex(path[0]), complex(path[-1]))
        yield Verdict(*asked.place, name, kind, at=at, letters=("", name))


def _of_force(name: str, path: Complexes, way: complex, slip: float) -> str:
    # No arrow that is not to scale is the largest of a plan: where a share is allowed, the slip of a fair hand is.
    arrow = complex(path[-1] - path[0])
    allowed = DEVIATIONS * slip * (2 / abs(arrow) + 1 / EDGE) if arrow else 0.0
    off = abs(math.remainder(cmath.phase(arrow) - cmath.phase(way), math.tau))
    if off <= allowed:
        return verdict.RIGHT
    back = TURNED.get(name.partition("_")[0], verdict.REVERSED)
    return back if math.pi - off <= allowed else verdict.TURNED


def sense_of(path: Complexes) -> float:
    """Tell in which sense a line turns that is followed to its head: 1 counter-clockwise.

    >>> sense_of(np.array([1 + 0j, 1j, -1 + 0j])), sense_of(np.array([1 + 0j, -1j, -1 + 0j]))
    (1.0, -1.0)
    """
    run = np.diff(path)
    return math.copysign(1.0, float((run[:-1].conj() * run[1:]).imag.sum()))


def once(verdicts: Sequence[Verdict]) -> Iterator[Verdict]:
    """Give verdicts where a force or a moment shown the wrong way on its scheme loses nothing more in a polygon."""
    wrong = (*REVERSED, verdict.COUPLE)
    shown = {(said.position, said.name) for said in verdicts if said.plan.startswith("scheme ") and said.kind in wrong}
    for said in verdicts:
        again = said.kind in REVERSED and (said.position, said.name) in shown
        again |= said.kind == verdict.COUPLE and (said.position, said.of) in shown
        yield said._replace(kind=verdict.FOLLOWS) if again and not said.plan.startswith("scheme ") else said
