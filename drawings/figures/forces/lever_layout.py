"""The lever on paper: where its forces, their arms and the stand of its pole find room (рычаг Жуковского)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from drawings.figures.forces.force_kinds import BALANCE, PAIR
from drawings.figures.forces.force_letters import letter_of
from drawings.layout.parallel_offsets import Segment, merging
from drawings.layout.place import Place
from drawings.lettering.indices import with_index
from drawings.lettering.words import letter as by_language
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.symbols.arms import Arm
from drawings.symbols.force_arrow import ForceArrow, not_to_scale
from drawings.symbols.polygon import ShownVector
from drawings.symbols.symbols import ARROW_LENGTH, STAND

LONGEST, SHORTEST = 26.0, 13.0  # mm, to the factor of the hand's symbols: the greatest force, and one that is nothing
AFTER = 2.0  # mm between two forces that follow one another on one line of action
ROOM = 1.2  # lengths of an arrowhead: a shorter arm is left to the eye
ARMS, TELLING = 5, 0.02  # arms shown at the most, and the share of the greatest moment that is worth one
# What speaks against a place of a force: that it runs along another, out of the figure, is away from its image.
ON_FORCE, OUTSIDE, AWAY = 4, 3, 2
STANDS = 12  # directions tried for the stand of the pole
BOTH, PARALLEL = 2, 0.1  # of forces on one line through an image one comes and one goes; parallel to 3 degrees
SAME = 0.5  # mm: places nearer than this are one


class Reach(NamedTuple):
    """The arm of a force about the pole: its force, its true length m/s, and its letter.

    The letter is h_1 where it is drawn, pd where it is a line of the plan itself, and none where neither is so.
    """

    force: str
    length: float
    letter: str


class Taken(NamedTuple):
    """Lines on paper that a force should not run along: the rods of the lever, and the forces drawn before."""

    rods: list[Segment]
    forces: list[Segment]
    box: Field  # of the figure


def forces(pushes: Sequence[ShownVector], place: Place, taken: Taken, drafting: Drafting) -> list[ForceArrow]:
    """Place the forces, the greatest first: each from its image or to it, where it runs along no other line."""
    greatest = max((abs(one.value) for one in pushes), default=1.0)
    arrows = []
    for one in sorted(pushes, key=lambda one: -abs(one.value)):
        length = (SHORTEST + (LONGEST - SHORTEST) * abs(one.value) / greatest) * drafting.hand.symbol
        arrow = _beside(letter_of(one.name, drafting), one.value, place.on(one.at), length, taken)
        taken.forces.append((arrow.start, arrow.tip))
        arrows.append(arrow)
    return arrows


def _beside(letter: str, force: complex, image: complex, length: float, taken: Taken) -> ForceArrow:
    """Draw a force from its image or to it; where both run along others, further on along its line of action."""
    along, step = force / abs(force), length + AFTER
    tries = [not_to_scale(letter, force, image, length), not_to_scale(letter, force, image, length, ending=True)]
    tries += [not_to_scale(letter, force, image + along * step * k, length, ending=k < 0) for k in (1, -1, 2, -2)]

    def cost(arrow: ForceArrow) -> int:
        ends = arrow.start, arrow.tip
        over = ON_FORCE * sum(merging(ends, other) for other in taken.forces)
        over += OUTSIDE * (not _within(arrow.free, taken.box))
        return over + any(merging(ends, rod) for rod in taken.rods) + AWAY * (abs(arrow.at - image) > SAME)

    return min(tries, key=cost)


def _within(spot: complex, box: Field) -> bool:
    return box.left <= spot.real <= box.right and box.bottom <= spot.imag <= box.top


def _shown(arm: Arm, box: Field) -> bool:
    """Tell whether an arm is neither too short to be drawn nor ends beside the figure."""
    return arm.length > ROOM * ARROW_LENGTH and _within(arm.foot, box)


def reach(pushes: Sequence[ShownVector]) -> float:
    """Give how far forces reach from their images, mm: one of their length, or two where many share a line there."""
    lines = [(one.at, (one.direction) ** 2) for one in pushes]
    most = max((sum(at == image and abs(way - own) < PARALLEL for image, way in lines) for at, own in lines), default=0)
    return LONGEST + (SHORTEST + AFTER if most > BOTH else 0.0)


def arms(
    pushes: Sequence[ShownVector], images: Mapping[complex, str], place: Place, taken: Taken, language: str
) -> list[tuple[Reach, Arm | None]]:
    """Give all arms, and of the greatest moments those that run along nothing else to be drawn, numbered as hung."""
    loads = [one for one in pushes if one.kind != PAIR]
    every = {one.name: Arm("", place.on(0j), place.on(one.at), one.direction) for one in loads}
    chosen, numbers = _chosen(loads, every, taken), iter(range(1, ARMS + 1))
    reaches: list[tuple[Reach, Arm | None]] = []
    for one in loads:
        arm, letter = every[one.name], ""
        if one.name in chosen:
            index = "bal" if one.kind == BALANCE else str(next(numbers))
            letter = by_language(language, f"h′_{{{index}}}")
        elif _ray(arm):
            letter = "p" + with_index(images[min(images, key=lambda true: abs(true - one.at))])
        kept = replace(arm, letter=letter) if one.name in chosen else None
        reaches.append((Reach(one.name, arm.length * place.scale.mu, letter), kept))
    return reaches


def _chosen(loads: Sequence[ShownVector], every: Mapping[str, Arm], taken: Taken) -> set[str]:
    """Choose the arms that are drawn."""
    least = TELLING * max((abs(one.moment) for one in loads), default=0.0)
    lines, chosen = [*taken.rods, *taken.forces], set[str]()
    for one in sorted(loads, key=lambda one: -abs(one.moment)):
        arm = every[one.name]
        ends, action = (arm.about, arm.foot), (arm.at, arm.foot)
        if len(chosen) == ARMS or abs(one.moment) <= least or _ray(arm) or not _shown(arm, taken.box):
            continue
        if not any(merging(ends, other) for other in lines) and not any(merging(action, rod) for rod in taken.rods):
            chosen.add(one.name)
            lines.append(ends)
    return chosen


def _ray(arm: Arm) -> bool:
    """Tell whether an arm is the ray of the plan to the image where its force acts."""
    return abs(arm.foot - arm.at) < SAME


def downward(lines: list[Segment], pole: complex, hand: Hand) -> complex:
    """Turn the stand of the pole to where no line runs; downward if it can be."""
    depth = STAND[0] * hand.symbol
    turns = sorted((math.remainder(math.tau * k / STANDS, math.tau) for k in range(STANDS)), key=abs)

    def clear(turn: float) -> float:
        return min((_distance(pole - 1j * depth * cmath.rect(1.0, turn), line) for line in lines), default=math.inf)

    free = [turn for turn in turns if clear(turn) > (STAND[1] + STAND[2]) * hand.symbol]
    return -1j * cmath.rect(1.0, free[0] if free else max(turns, key=clear))


def _distance(spot: complex, line: Segment) -> float:
    start, along = line[0], line[1] - line[0]
    share = ((spot - start) * along.conjugate()).real / abs(along) ** 2 if along else 0.0
    return abs(spot - start - along * min(max(share, 0.0), 1.0))
