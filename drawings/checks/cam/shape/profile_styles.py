"""The kinds of lines that a cam's curves are drawn by: main, dash-dot, of one with flaws dashed (линии профилей)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.wrong import Wrong, on
from drawings.paper.hand import Hand
from drawings.paper.strokes import Curve
from drawings.paper.walk import groups
from plans.model.cam_motion import CamFound

# Flaws of a shape by the curve that has them.
FLAWED = {"profile": ("undercut", "crossing", "concave", "sharp"), "outer": ("hollow",)}


def faults(strokes: FigureStrokes, plan: str, found: CamFound, hand: Hand) -> Iterator[Wrong]:
    """Hold the line of each curve: the pitch curve thin dash-dot, a profile main, one with flaws thin and dashed."""
    told = {one.kind for one in found.flaws}
    for one in groups((strokes.group,)):
        if one.data.get("kind") == "profile":
            name = one.data["name"]
            flawed = not told.isdisjoint(FLAWED.get(name, ()))
            wide = hand.construction if name == "pitch" else hand.thin if flawed else hand.main
            due = wide, flawed or name == "pitch"
            styles = [(line.style.width, bool(line.style.dash)) for line in one.strokes if isinstance(line, Curve)]
            if styles != [due]:
                yield on("path", plan, name=name)
