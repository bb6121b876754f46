"""The curves of a cam on paper: pitch curve, working profile, and where something is wrong with it (профиль)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from drawings.figures.cam.profile_view import ProfileView
from drawings.layout.place import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import LineStyle, Polyline, Stroke
from drawings.symbols.dashes import fit
from drawings.symbols.symbols import ground
from plans.model.cam_motion import Flaw
from plans.model.motion import Complexes

SHOWN = ("undercut", "crossing", "concave", "cusp")  # flaws of the profile's own shape
HEAVY = 1.4  # times a main line: a stretch with a flaw
SIDE = 30.0  # mm of ground under a cam that translates
UNDER = 1.2  # mm from its body to the ground


class FlawMark(NamedTuple):
    """A flaw on paper: its kind, and the worst place of its stretch."""

    kind: str
    spot: complex


def pitch(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the pitch curve where it is not the profile itself."""
    if view.apart:
        yield _chain(view.curve.pitch, hand.axis, not view.cam.translates, place)


def profile(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the working profile, of a groove both sides: sound stretches solid, those with a flaw heavier and dashed."""
    flawed = _flawed(view)
    for number, outline in enumerate(view.outlines):
        if number or not flawed.any():
            yield _chain(outline, hand.result, not view.cam.translates, place)
        else:
            broken = LineStyle(HEAVY * hand.main, hand.dashed)
            yield from _stretches(outline, ~flawed, hand.result, place)
            yield from _stretches(outline, flawed, broken, place)
    if view.cam.translates:
        yield from _body(view, place, hand)


def flaws(view: ProfileView, place: Place) -> tuple[FlawMark, ...]:
    """Give the flaws of the profile's shape, each at its worst place."""
    turns, curve = view.curve.turned, view.curve.profile
    return tuple(
        FlawMark(one.kind, place.on(complex(curve[int(np.argmin(abs(turns - one.worst.turned)))])))
        for one in view.found.flaws
        if one.kind in SHOWN
    )


def _flawed(view: ProfileView) -> npt.NDArray[np.bool_]:
    """Tell of each place of the curve whether a flaw of the shape is there."""
    own = np.zeros(len(view.curve.turned), dtype=bool)
    for one in view.found.flaws:
        if one.kind in SHOWN:
            own |= _within(view, one)
    return own


def _within(view: ProfileView, one: Flaw) -> npt.NDArray[np.bool_]:
    """Tell of each place whether a flaw's stretch holds it; one may run over the beginning of the turn."""
    turns = view.curve.turned
    inside = (turns >= one.start) & (turns <= one.end)
    return inside if one.start <= one.end else (turns >= one.start) | (turns <= one.end)


def _stretches(outline: Complexes, chosen: npt.NDArray[np.bool_], style: LineStyle, place: Place) -> Iterator[Stroke]:
    """Draw the pieces of an outline between places of which one at least is chosen."""
    pieces = chosen[:-1] & chosen[1:] if style.dash else chosen[:-1] | chosen[1:]
    edges = np.flatnonzero(np.diff(np.concatenate([[False], pieces, [False]])))
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        yield _chain(outline[start : end + 1], style, False, place)


def _chain(curve: Complexes, style: LineStyle, closed: bool, place: Place) -> Polyline:
    """Draw a curve by its many points; a closed one comes back to its first."""
    own = curve[:-1] if closed else curve
    line = Polyline(tuple(place.on(complex(spot)) for spot in own), closed, style)
    if not style.dash:
        return line
    length = float(np.abs(np.diff(curve)).sum()) / place.scale.mu
    return line._replace(style=fit(style, length, closed))


def _body(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Close the body of a cam that translates below its profile, on the ground that it slides on."""
    left, right = (place.on(one) for one in view.body)
    ends = (place.on(complex(view.curve.profile[k])) for k in (0, -1))
    first, last = sorted(ends, key=lambda spot: spot.real)
    yield Polyline((first, left, right, last), False, hand.result)
    middle, half = (left + right) / 2 - 1j * UNDER * hand.symbol, SIDE * hand.symbol / 2
    yield from ground(middle - half, middle + half, -1j, hand)
