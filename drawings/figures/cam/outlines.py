"""The curves of a cam on paper: pitch curve, working profile, and where something is wrong with it (профиль)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from drawings.figures.cam.profile_curve import profile_curve
from drawings.figures.cam.profile_view import OUTER, PITCH, WORKING, ProfileView
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import LineStyle, Polyline, Stroke
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.symbols import ground
from plans.model.cam_motion import Flaw
from plans.model.motion import Complexes

# Flaws of a curve's own shape, and the curve that has them.
SHOWN = {"undercut": WORKING, "crossing": WORKING, "concave": WORKING, "sharp": WORKING, "hollow": OUTER}
HEAVY = 1.4  # times a main line: a stretch with a flaw
SIDE = 30.0  # mm of ground under a cam that translates
UNDER = 1.2  # mm from its body to the ground


class FlawMark(NamedTuple):
    """A flaw on paper: its kind, and the worst place of its stretch."""

    kind: str
    spot: complex


def curves(view: ProfileView, plan: str, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw pitch curve and profile, of a groove both sides; stretches with a flaw heavier and dashed."""
    for one in sorted(view.curves, key=lambda one: one.name != PITCH):
        flawed = _flawed(view, one.name)
        style = hand.axis if one.name == PITCH else hand.other if flawed.any() else hand.result
        yield profile_curve(one.path, place, plan, one.name, style)
        if flawed.any():
            points = _points(view, one.name)
            yield from _stretches(points, ~flawed, hand.result, place)
            yield from _stretches(points, flawed, LineStyle(HEAVY * hand.main, hand.dashed), place)
    if view.cam.translates:
        yield from _body(view, place, hand)


def flaws(view: ProfileView, place: Place) -> Iterator[FlawMark]:
    """Give the flaws of the curves' shapes, each at its worst place."""
    for one in view.found.flaws:
        if one.kind in SHOWN:
            nearest = int(np.argmin(abs(view.curve.turned - one.worst.turned)))
            yield FlawMark(one.kind, place.on(complex(_points(view, SHOWN[one.kind])[nearest])))


def _points(view: ProfileView, name: str) -> Complexes:
    """Give a curve by its many points, m."""
    outer = view.curve.outer
    return view.curve.profile if name == WORKING or outer is None else outer


def _flawed(view: ProfileView, name: str) -> npt.NDArray[np.bool_]:
    """Tell of each place of a curve whether a flaw of its shape is there."""
    own = np.zeros(len(view.curve.turned), dtype=bool)
    for one in view.found.flaws:
        if SHOWN.get(one.kind) == name:
            own |= _within(view, one)
    return own


def _within(view: ProfileView, one: Flaw) -> npt.NDArray[np.bool_]:
    """Tell of each place whether a flaw's stretch holds it; one may run over the beginning of the turn."""
    turns = view.curve.turned
    inside = (turns >= one.start) & (turns <= one.end)
    return inside if one.start <= one.end else (turns >= one.start) | (turns <= one.end)


def _stretches(outline: Complexes, chosen: npt.NDArray[np.bool_], style: LineStyle, place: Place) -> Iterator[Stroke]:
    """Draw the pieces of an outline between chosen places, solid ones as far as the dashed ones begin."""
    pieces = chosen[:-1] & chosen[1:] if style.dash else chosen[:-1] | chosen[1:]
    edges = np.flatnonzero(np.diff(np.concatenate([[False], pieces, [False]])))
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        points = tuple(place.on(complex(spot)) for spot in outline[start : end + 1])
        yield from fit_dashes([Polyline(points, False, style)])


def _body(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Close the body of a cam that translates below its profile, on the ground that it slides on."""
    left, right = (place.on(one) for one in view.body)
    ends = (place.on(complex(view.curve.profile[k])) for k in (0, -1))
    first, last = sorted(ends, key=lambda spot: spot.real)
    yield Polyline((first, left, right, last), False, hand.result)
    middle, half = (left + right) / 2 - 1j * UNDER * hand.symbol, SIDE * hand.symbol / 2
    yield from ground(middle - half, middle + half, -1j, hand)
