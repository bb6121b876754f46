"""The self-check of what stands beside the links: their numbers, mass centres and their ties (номера, центры масс)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks.linkage.laid import LaidMechanism, within
from drawings.checks.wrong import on
from drawings.figures.linkage.link_numbers import BESIDE
from drawings.figures.linkage.masses import is_centre
from drawings.figures.linkage.position_letters import LINKS
from drawings.figures.linkage.position_plan import TIES
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Circle, Group, Leaf, Line, Polyline, Text
from drawings.paper.walk import flat, groups
from drawings.symbols.symbols import BLOCK, DOUBLE, MASS, STAND
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats
from plans.model.order import POSITIONS
from plans.words.words import Message

SYMBOLS = "pairs", "shown-position"  # the groups of the symbols of pairs and mass centres, and of blocks
WAY = np.linspace(0.0, 1.0, 201)  # places on the way to a mass centre, closer than the thinnest line is wide
HIDING = max(2 * DOUBLE[0], abs(complex(*BLOCK)))  # mm that a symbol hides of a line at the most
EXACT = 4 * QUANTUM  # mm: the sheet's origin and scale are read off marks that are rounded twice


def faults(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """Hold numbers and ties against the links as the analysis places them."""
    yield from _numbers(leaf, laid)
    yield from _ties(leaf, laid)


def named(leaf: Leaf, name: str) -> Iterator[Group]:
    """Give the groups of a sheet that have a name."""
    return (group for group in groups(leaf.groups) if group.name == name)


def _numbers(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """See that each link that has a place bears its number, beside it or by a leader that ends on it."""
    seen = {content: number for group in named(leaf, LINKS) for content, number in _numbered(group)}
    for link in laid.mechanism.links:
        number = seen.get(str(link))
        if number is None:
            yield from () if _placeless(laid, link) else (on("link_number", POSITIONS.plan, name=str(link)),)
        elif not _beside(number, link, laid):
            yield on("link_number", POSITIONS.plan, name=str(link))


def _numbered(group: Group) -> Iterator[tuple[str, Group]]:
    for one in group.strokes:
        match one:
            case Group((Circle(), Text() as text, *_)):
                yield text.plain, one


def _placeless(laid: LaidMechanism, link: int) -> bool:
    """Tell whether a link has no place to be numbered at: at a gap, or a frame of guides alone."""
    points = laid.mechanism.links[link].points
    if link == FRAME:
        return not any(name in laid.mechanism.hinges for name in points)
    return all(math.isnan(laid.on(link, own).real) for own in points.values())


def _beside(number: Group, link: int, laid: LaidMechanism) -> bool:
    """Tell whether a number stands at its link; the frame's stands under the stand of a hinge."""
    circle, dot = number.strokes[0], number.strokes[-1]
    assert isinstance(circle, Circle)
    if not is_led(number):
        return False
    if isinstance(dot, Circle) and dot is not circle:
        if link != FRAME and within(laid.corners(link), dot.centre):
            return True
        return laid.apart(link, dot.centre) <= EXACT + (STAND[0] if link == FRAME else 0.0)
    clear = STAND[0] if link == FRAME else abs(complex(*BLOCK)) / 2
    return laid.apart(link, circle.centre) <= circle.radius + BESIDE + clear + EXACT


def is_led(number: Group) -> bool:
    """Tell whether a number has no leader, or one from its circle's rim to the dot on its link."""
    match number.strokes:
        case (Circle(), Text()):
            return True
        case (Circle() as circle, Text(), Line() as leader, Circle() as dot):
            from_rim = abs(abs(leader.start - circle.centre) - circle.radius) <= EXACT
            return from_rim and abs(leader.end - dot.centre) <= EXACT
    return False


def _ties(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """See that each mass centre off its link is tied to it."""
    lines = [line for group in named(leaf, TIES) for line in group.strokes if isinstance(line, Line)]
    for name, link, spot in centres(laid):
        ends = list(_reached(lines, spot))
        tied = any(laid.apart(link, end) <= HIDING / 2 or _covered(leaf, laid.foot(link, end), end) for end in ends)
        if not tied and laid.apart(link, spot) > MASS and not _covered(leaf, laid.foot(link, spot), spot):
            yield on("tie", POSITIONS.plan, name=name)


def _covered(leaf: Leaf, foot: complex, spot: complex) -> bool:
    """Tell whether symbols of pairs cover all of the way from a link to its mass centre, so that no tie is seen."""
    way: Complexes = np.asarray(foot + WAY * (spot - foot), dtype=np.complex128)
    strokes = [stroke for name in SYMBOLS for group in named(leaf, name) for stroke in flat((group,))]
    off = [np.abs(way - one.centre) - one.radius for one in strokes if isinstance(one, Circle)]
    off += [_outside(one.points, way) for one in strokes if isinstance(one, Polyline) and one.closed]
    return bool((np.min([np.full(len(way), np.inf), *off], axis=0) <= EXACT).all())


def _outside(corners: Sequence[complex], way: Complexes) -> Floats:
    """Give how far places are beyond the farthest side of a block, mm; less than nothing inside it."""
    sides = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    turned = 1j if sum((start.conjugate() * end).imag for start, end in sides) < 0 else -1j
    units = [(start, turned * (end - start) / abs(end - start)) for start, end in sides if start != end]
    return np.asarray(np.max([((way - start) * unit.conjugate()).real for start, unit in units], axis=0))


def centres(laid: LaidMechanism) -> Iterator[tuple[str, int, complex]]:
    """Give the mass centres that are drawn: letter, link, place on paper."""
    hinges = laid.mechanism.hinges
    named = {
        name: (link.number, own)
        for link in laid.mechanism.links.values()
        for name, own in link.points.items()
        if is_centre(name) and name not in hinges
    }
    for name, (number, own) in (named | laid.centres).items():
        yield name, number, laid.on(number, own)


def _reached(lines: Sequence[Line], spot: complex) -> Iterator[complex]:
    """Give the places to which lines run from the symbol of a mass centre, as far as each goes toward its link.

    What it crosses may part it: from the mass centre on each piece begins where a symbol may hide the end of the last.
    Beyond the link another line may go on, as the axis of its guide does.
    """
    for last in (one for one in lines if _far(one, spot) <= MASS + EXACT):
        way = (last.start - last.end) / abs(last.start - last.end)
        own = [one for one in lines if all(_aside(end, spot, way) <= EXACT for end in (one.start, one.end))]
        for side in (1, -1):
            reached = 0.0
            runs = sorted(sorted(((end - spot) / way).real * side for end in (one.start, one.end)) for one in own)
            for near, far in runs:
                reached = max(reached, far) if near <= reached + HIDING else reached
                if reached > 0:
                    yield spot + side * reached * way


def _far(line: Line, spot: complex) -> float:
    """Give how far a spot is from the nearer end of a line, mm."""
    return min(abs(line.start - spot), abs(line.end - spot))


def _aside(end: complex, spot: complex, way: complex) -> float:
    """Give how far a place is from the line through a spot in a direction, mm."""
    return abs(((end - spot) / way).imag)
