"""The numbers of links, each in a small circle beside its link (номера звеньев)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from drawings.figures.linkage.pairs import Joints
from drawings.layout.labels import Labels
from drawings.lettering.extent import bounds
from drawings.paper.hand import Hand
from drawings.paper.strokes import Box, Circle, Group, Stroke, Text
from drawings.symbols.symbols import BLOCK

SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78)  # where along a bar its number may stand
OFFS = (0.6, 2.0, 4.0, 7.0, 11.0)  # mm between a bar and the circle
ROUND = 0.85  # radius of the circle, in sizes of its number: of two digits it is wider
DIRECTIONS = 16


def link_numbers(joints: Joints, links: list[int], labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Number the links where the lines of all figures leave room."""
    for link in links:
        yield _number(str(link), list(_spots(joints, link, hand)), labels, hand)


def _spots(joints: Joints, link: int, hand: Hand) -> Iterator[complex]:
    """Give the places beside a link, the nearest first; beside a block where the link is no more than one."""
    radius = _radius(str(link), hand)
    bones, place = joints.bones, joints.place
    bars = [
        tuple(place.on(complex(bones.numbered.of(link, end)[bones.shown])) for end in bar)
        for outline in joints.outlines
        if outline.link == link
        for bar in outline.bars
    ]
    bars = [bar for bar in bars if abs(bar[1] - bar[0]) > 4 * radius]
    for off in OFFS:
        for share in SHARES if bars else ():
            for start, end in bars:
                across = 1j * (end - start) / abs(end - start) * (radius + off)
                yield from (start + share * (end - start) + side * across for side in (1, -1))
        if not bars:
            middle = _middle(joints, link)
            reach = abs(complex(*BLOCK)) / 2 * joints.hand.symbol + radius + off
            yield from (middle + cmath.rect(reach, 2 * math.pi * (k + 0.5) / DIRECTIONS) for k in range(DIRECTIONS))


def _middle(joints: Joints, link: int) -> complex:
    bones = joints.bones
    spots = bones.mechanism.links[link].points.values()
    places = [joints.place.on(complex(bones.numbered.of(link, spot)[bones.shown])) for spot in spots]
    return sum(places) / len(places)


def _radius(content: str, hand: Hand) -> float:
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    return max(ROUND * hand.text, abs(complex(right - left, top - bottom)) / 2 + 0.15 * hand.text)


def _number(content: str, spots: list[complex], labels: Labels, hand: Hand) -> Stroke:
    """Draw a number in its circle at the first free place."""
    radius = _radius(content, hand)

    def covered(spot: complex) -> int:
        return labels.ink.under(_square(spot, radius + 0.4))

    spot = next((spot for spot in spots if not covered(spot)), None) or min(spots, key=covered)
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    text = Text(spot - complex(left + right, bottom + top) / 2, content, hand.text, "middle")
    group = Group((Circle(spot, radius, hand.other), text), "", {}, content)
    labels.ink.draw([group])
    return group


def _square(middle: complex, half: float) -> Box:
    return middle.real - half, middle.imag - half, middle.real + half, middle.imag + half
