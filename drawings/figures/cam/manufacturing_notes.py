"""The notes of a cam to be made: what a workshop must know beside the curve (технические требования)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.figures.cam.manufacturing_figure import TabledProfile
from drawings.figures.cam.outlines import SHOWN
from drawings.lettering.phrase import Slot, joined
from drawings.page.drafting import Drafting

MM = 1000.0  # of a metre
DIGITS = 5


def notes(shown: TabledProfile, drafting: Drafting) -> Iterator[str]:
    """Say what a workshop must know beside the curve."""
    cam = shown.cam
    yield drafting.word(_moves(shown))
    curve = drafting.word("mill path" if shown.grooved else "profile told")
    yield drafting.word("plane datum" if cam.translates else "polar datum", curve=curve)
    if shown.found.roller:
        yield drafting.letter(_roller(shown, drafting))
    if not cam.translates:
        yield from _dwells(shown, drafting)
        yield drafting.word("bore of cam")
    yield drafting.word("drawn pieces", tolerance=drafting.number(MM * cam.tolerance))
    wrong = dict.fromkeys(one.kind for one in shown.found.flaws if one.kind in SHOWN)
    if wrong:
        yield drafting.word("profile flaws", flaws=", ".join(drafting.word(f"cam {kind}") for kind in wrong))


def _moves(shown: TabledProfile) -> str:
    """Name the sense in which the cam moves."""
    names = ("leftward cam", "rightward cam") if shown.cam.translates else ("counter-clockwise cam", "clockwise cam")
    return names[shown.cam.sense < 0]


def _roller(shown: TabledProfile, drafting: Drafting) -> str:
    radius = Slot(f"r_rol {shown.cam.name}", MM * shown.found.roller, DIGITS)
    if not shown.grooved:
        return drafting.phrase("roller of cam", radius=radius)
    breadth = Slot(f"breadth {shown.cam.name}", 2 * MM * shown.found.roller, DIGITS)
    return drafting.phrase("groove of cam", radius=radius, breadth=breadth)


def _dwells(shown: TabledProfile, drafting: Drafting) -> Iterator[str]:
    """Tell the radii of the arcs, and between which turns they are."""
    told = []
    for k, (one, radius) in enumerate(shown.dwells()):
        turns = (("r", MM * radius), ("start", math.degrees(one.start)), ("end", math.degrees(one.end)))
        size, *ends = (drafting.slot(Slot(f"{name} {k} {shown.cam.name}", value, DIGITS)) for name, value in turns)
        told.append(joined("", ("r = ", size, ", φ ", joined(" … ", ends), "°")))
    if told:
        yield drafting.phrase("dwells of cam", radii=joined(";  ", told))
