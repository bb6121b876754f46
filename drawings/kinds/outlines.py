"""The poses of links, and their outlines in the link's own frame, m: straight bars, rigid corners (контуры звеньев)."""

import cmath
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import NamedTuple, Protocol

import numpy as np

from plans.model.mechanism import FRAME, Link, Mechanism, Slide, Way
from plans.model.motion import Complexes, Floats

_LETTER = re.compile(r"S\d*")


def is_centre(name: str) -> bool:
    """Tell whether a point is a mass centre by its letter.

    >>> is_centre("S2"), is_centre("S"), is_centre("SB")
    (True, True, False)
    """
    return bool(_LETTER.fullmatch(name))


class Bones(Protocol):
    """What links and their pairs are drawn from: a mechanism, its poses, and which of them is shown."""

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""

    @property
    def links(self) -> list[int]:
        """The links that are drawn."""

    @property
    def numbered(self) -> "Poses":
        """The poses."""

    @property
    def shown(self) -> int:
        """Which of them is shown."""

    @property
    def reach(self) -> float:
        """The mechanism's size, m."""

    @property
    def masses(self) -> Mapping[str, tuple[int, complex]]:
        """The mass centres that no point names: letter, link, place in its own frame."""

    @property
    def travels(self) -> Mapping[Slide, tuple[float, float]]:
        """How far along its line each slide's block comes, m."""

    def spot(self, name: str, position: int) -> complex:
        """Give a point's place; NaN at a gap."""


@dataclass(frozen=True, eq=False, repr=False)
class Poses:
    """A mechanism in several positions: the places of its points and the directions of its links; NaN at gaps."""

    links: Mapping[int, Link]
    points: Mapping[str, Complexes]
    turns: Mapping[int, Complexes]

    def __len__(self) -> int:
        return len(self.turns[FRAME])

    def of(self, link: int, spot: complex) -> Complexes:
        """Give the places of a spot that is fixed in a link, measured in the link's own frame."""
        if link == FRAME:
            return np.full(len(self), spot)
        name, place = next(iter(self.links[link].points.items()))
        return np.asarray(self.points[name] + self.turns[link] * (spot - place))

    def line(self, slide: Slide) -> Complexes:
        """Give the directions of a slide's line."""
        return np.asarray(self.turns[slide.owner] * slide.on_owner.direction)

    def along(self, slide: Slide) -> Floats:
        """Give how far a slide's block stands along its line, m from the point that the line goes through."""
        pins = self.points[slide.point] - self.of(slide.owner, slide.on_owner.through)
        return np.asarray((pins * np.conj(self.line(slide))).real)

    def blocks(self, slide: Slide) -> Complexes:
        """Give the places of a slide's block: the foot on its line of the slider's named point."""
        return self.of(slide.owner, slide.on_owner.through) + self.line(slide) * self.along(slide)


def places(bones: Bones) -> dict[str, complex]:
    """Give the shown places of all named points and of the mass centres that no point names, m; none at a gap."""
    poses, k = bones.numbered, bones.shown
    found = {name: bones.spot(name, k) for name in sorted(poses.points)}
    found |= {name: complex(poses.of(*mass)[k]) for name, mass in bones.masses.items()}
    return {name: spot for name, spot in found.items() if not math.isnan(spot.real)}


# Points of a link lie on one line when none is off it by more than this share of its length: rounding of coordinates
# that a scene gives with twelve digits, and no distance on any sheet.
FLAT = 1e-9

Bar = tuple[complex, complex]
Reach = Mapping[Slide, tuple[float, float]]  # how far slots reach along their slides' lines, m


class RigidCorner(NamedTuple):
    """A rigid corner of a link: where two of its bars meet, and their unit directions away from it."""

    at: complex
    first: complex
    second: complex


class LinkOutline(NamedTuple):
    """A link's bars and rigid corners, in its own frame."""

    link: int
    bars: tuple[Bar, ...]
    corners: tuple[RigidCorner, ...] = ()


def outlines(bones: Bones, reach: Reach) -> list[LinkOutline]:
    """Give the outlines of all moving links through all their points, their slots as long as they must reach."""
    return [_outline(bones, link, reach) for link in bones.links]


def reach_of(bones: Bones, poses: Poses, k: int) -> Reach:
    """Give how far slots reach to their stones in one position."""
    places = {slide: float(poses.along(slide)[k]) for slide in bones.mechanism.slides}
    return {slide: (along, along) for slide, along in places.items() if not math.isnan(along)}


def _outline(bones: Bones, link: int, reach: Reach) -> LinkOutline:
    spots = list(_spots(bones, link).values())
    bars, corners = _body(spots)
    for slide, (low, high) in reach.items():
        if slide.owner == link:
            bars, more = _slotted(bars, spots, slide.on_owner, low, high)
            corners += more
    for slide in bones.mechanism.slides:
        foot = offset_foot(bones, slide)
        if slide.slider == link and foot is not None:
            pin = bones.mechanism.links[link].points[slide.point]
            corners += [_corner(pin, foot, end) for bar in bars if pin in bar for end in bar if end != pin]
            bars = [*bars, (pin, foot)]
    return LinkOutline(link, tuple(bars), tuple(corners))


def offset_foot(bones: Bones, slide: Slide) -> complex | None:
    """Give the foot of a slider's point on its line, in the slider's own frame; None where the point lies on it."""
    points, way = bones.mechanism.links[slide.slider].points, slide.on_slider
    off = along(way, points[slide.point])
    size = max(abs(off), bones.reach)
    return None if abs(off.imag) <= FLAT * size else points[slide.point] - 1j * off.imag * way.direction


def _spots(bones: Bones, link: int) -> Mapping[str, complex]:
    """Give the points that a link's bars run through; a mass centre is a mark beside them."""
    points, hinges = bones.mechanism.links[link].points, bones.mechanism.hinges
    spots = {name: spot for name, spot in points.items() if not is_centre(name) or name in hinges}
    return spots if len(spots) > 1 else points


def _body(spots: Sequence[complex]) -> tuple[list[Bar], list[RigidCorner]]:
    """Join a link's points: one bar where they lie on one line, else a closed polygon of rigid corners."""
    if len(spots) < 2:
        return [], []
    first, last = max(combinations(spots, 2), key=lambda pair: abs(pair[1] - pair[0]))
    if first == last:
        return [], []
    run = (last - first) / abs(last - first)
    if all(abs(((spot - first) * run.conjugate()).imag) <= FLAT * abs(last - first) for spot in spots):
        return [(first, last)], []
    middle = sum(spots) / len(spots)
    round_ = sorted(spots, key=lambda spot: cmath.phase((spot - middle) / run))
    bars = list(pairwise([*round_, round_[0]]))
    return bars, [_corner(at, before, after) for (before, at), (_, after) in pairwise([bars[-1], *bars])]


def _corner(at: complex, first: complex, second: complex) -> RigidCorner:
    return RigidCorner(at, (first - at) / abs(first - at), (second - at) / abs(second - at))


def _slotted(
    bars: list[Bar], spots: Sequence[complex], way: Way, low: float, high: float
) -> tuple[list[Bar], list[RigidCorner]]:
    """Lengthen the bar on a slot's line, or lay one along it, so that it reaches from `low` to `high` along it."""
    on_line = [
        bar
        for bar in bars
        if all(abs(along(way, end).imag) <= FLAT * max(abs(bar[1] - bar[0]), high - low) for end in bar)
    ]
    rest = [bar for bar in bars if bar not in on_line]
    if not on_line:
        return _crossing(bars, spots, way, low, high)
    ends = [along(way, end).real for bar in on_line for end in bar]
    if not rest:
        return [_piece(way, min([low, *ends]), max([high, *ends]))], []
    pieces = [(low, min(ends)), (max(ends), high)]
    return [*bars, *(_piece(way, a, b) for a, b in pieces if a < b)], []


def _crossing(
    bars: list[Bar], spots: Sequence[complex], way: Way, low: float, high: float
) -> tuple[list[Bar], list[RigidCorner]]:
    """Lay a bar along a slot's line on which no other lies, and tie it to the link where it meets none of it."""
    spot, foot = _hung(spots, way)
    rest = bars if spot == foot else [*bars, (spot, foot)]
    place = along(way, foot).real
    arms = [side for side, goes in ((-way.direction, low < place), (way.direction, high > place)) if goes]
    others = [(end - foot) / abs(end - foot) for bar in rest if _holds(bar, foot) for end in bar if end != foot]
    slot = _piece(way, min(low, place), max(high, place))
    return [*rest, slot], [RigidCorner(foot, arm, other) for arm in arms for other in others]


def _hung(spots: Sequence[complex], way: Way) -> Bar:
    """Give the spot of a link that a slot hangs on, and where on the slot's line: the same where the line meets it."""
    off = [abs(along(way, spot).imag) for spot in spots]
    slack = FLAT * max(abs(along(way, spot)) for spot in spots)
    point = next(spot for spot, away in zip(spots, off, strict=True) if away <= min(off) + slack)
    if min(off) <= slack:
        return point, point
    for start, end in _body(spots)[0]:
        first, last = along(way, start).imag, along(way, end).imag
        if first * last < 0:
            crossed = start + (end - start) * first / (first - last)
            return crossed, crossed
    return point, way.through + along(way, point).real * way.direction


def _holds(bar: Bar, spot: complex) -> bool:
    """Tell whether a spot lies on a bar, or on the line of one beyond its end."""
    run = bar[1] - bar[0]
    return abs(((spot - bar[0]) * run.conjugate()).imag) <= FLAT * abs(run) ** 2


def along(way: Way, spot: complex) -> complex:
    """Measure where a spot lies from a line's point: along the line, and to its left."""
    return (spot - way.through) * way.direction.conjugate()


def _piece(way: Way, low: float, high: float) -> Bar:
    return way.through + low * way.direction, way.through + high * way.direction
