"""The numbers of links, each in a small circle beside its link (номера звеньев)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.linkage.pairs import Joints
from drawings.layout.ink import LETTERED
from drawings.layout.labels import Labels
from drawings.lettering.extent import bounds
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Box, Circle, Group, Line, Stroke, Text
from drawings.symbols.symbols import BLOCK
from plans.model.mechanism import FRAME

SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78)  # where along a bar its number may stand
OFFS = (0.6, 2.0, 4.0, 7.0, 11.0, 16.0, 22.0, 30.0, 40.0, 55.0)  # mm between a bar and the circle
BESIDE = 2.0  # mm: from further off a leader leads to the link
DOT = 0.5  # mm, radius of the dot that a leader ends with on its link
ROUND = 0.85  # radius of the circle, in sizes of its number: of two digits it is wider
DIRECTIONS = 16


class NumberPlace(NamedTuple):
    """A place for a number: the middle of its circle, the place of the link that it is for, mm between them."""

    middle: complex
    foot: complex
    off: float


def link_numbers(joints: Joints, links: list[int], labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Number the links where the lines of all figures leave room."""
    for link in links:
        spots = [spot for spot in _spots(joints, link, hand) if not cmath.isnan(spot.middle)]
        yield from (_number(str(link), spots, labels, hand),) if spots else ()


def frame_number(joints: Joints, labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Number the frame beside the stand of the drive's hinge, or of the first that has one."""
    fixed_points, drive = joints.bones.mechanism.links[FRAME].points, joints.bones.mechanism.drive
    hinges = sorted((name for name in fixed_points if name in joints.hinges), key=lambda name: name != drive.pivot)
    if hinges:
        bases = [line for line in joints.stand(hinges[0]) if isinstance(line, Line)]
        spots = [spot for line in bases[2:3] for spot in _around((line.start + line.end) / 2, FRAME, 0.0, hand)]
        yield _number(str(FRAME), spots, labels, hand)


def _spots(joints: Joints, link: int, hand: Hand) -> Iterator[NumberPlace]:
    """Give the places beside a link, the nearest first; beside a block where the link is no more than one."""
    radius = _radius(str(link), hand)
    outlines = (outline for outline in joints.outlines if outline.link == link)
    bars = [bar for outline in outlines for bar in joints.placed(outline) if abs(bar[1] - bar[0]) > 4 * radius]
    if not bars:
        yield from _around(_middle(joints, link), link, abs(complex(*BLOCK)) / 2 * joints.hand.symbol, hand)
    for off in OFFS if bars else ():
        for share in SHARES:
            for start, end in bars:
                across, foot = 1j * (end - start) / abs(end - start), start + share * (end - start)
                yield from (NumberPlace(foot + side * across * (radius + off), foot, off) for side in (1, -1))


def _around(foot: complex, link: int, clear: float, hand: Hand) -> Iterator[NumberPlace]:
    """Give the places round a spot that is kept clear so far."""
    for off in OFFS:
        reach = clear + _radius(str(link), hand) + off
        turns = (2 * math.pi * (k + 0.5) / DIRECTIONS for k in range(DIRECTIONS))
        yield from (NumberPlace(foot + cmath.rect(reach, turn), foot, off) for turn in turns)


def _middle(joints: Joints, link: int) -> complex:
    bones = joints.bones
    spots = bones.mechanism.links[link].points.values()
    places = [joints.place.on(complex(bones.numbered.of(link, spot)[bones.shown])) for spot in spots]
    return sum(places) / len(places)


def _radius(content: str, hand: Hand) -> float:
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    return max(ROUND * hand.text, abs(complex(right - left, top - bottom)) / 2 + 0.15 * hand.text)


def _number(content: str, spots: list[NumberPlace], labels: Labels, hand: Hand) -> Stroke:
    """Draw a number in its circle at the first free place, with a leader where that is not beside its link."""
    radius = _radius(content, hand)

    def covered(spot: NumberPlace) -> int:
        through = labels.ink.along(spot.middle, spot.foot) // LETTERED if spot.off > BESIDE else 0
        return labels.ink.under(_square(spot.middle, radius + 0.4)) + through

    spot = next((spot for spot in spots if not covered(spot)), None) or min(spots, key=covered)
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    text = Text(spot.middle - complex(left + right, bottom + top) / 2, content, hand.text, "middle")
    led = _leader(spot, radius, hand) if spot.off > BESIDE else ()
    group = Group((Circle(spot.middle, radius, hand.other), text, *led), "", {}, content)
    labels.ink.draw([group])
    return group


def _leader(spot: NumberPlace, radius: float, hand: Hand) -> tuple[Stroke, ...]:
    """Lead from a circle's rim to a dot on its link."""
    rim = spot.middle + (spot.foot - spot.middle) / abs(spot.foot - spot.middle) * radius
    return Line(rim, spot.foot, hand.drafted), Circle(spot.foot, DOT * hand.symbol, INK)


def _square(middle: complex, half: float) -> Box:
    return middle.real - half, middle.imag - half, middle.real + half, middle.imag + half
