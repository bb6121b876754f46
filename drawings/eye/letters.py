"""Letters recognised from their strokes: each shape of a size is looked up once (распознавание букв)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from drawings.eye.shapes import LetterShape, Signature, accented, shapes
from drawings.paper.strokes import LEAN

# A letter's points are written in hundredths of a millimetre: none is off by more than half of one in x and in y.
NEAR = math.sqrt(2) * 0.005 + 1e-6
# The angle (rad) by which that may turn a letter: of the lowest ones, x at the smallest size, 1.3 mm high.
ASKEW = 2 * NEAR / 1.3
UNREAD = "\ufffd"


class Stance(NamedTuple):
    """How a text stands: turned by so many degrees, upright or slanted."""

    rotation: float
    slanted: bool

    @property
    def turn(self) -> complex:
        """The direction of its line of writing."""
        return _turned(self.rotation)


@lru_cache(maxsize=256)
def _turned(rotation: float) -> complex:
    quarters, rest = divmod(rotation, 90)
    return complex(1j ** int(quarters)) * cmath.rect(1, math.radians(rest))


# As texts of a drawing stand, the most usual way first: along it, up its left side, upside down, down its right side.
STANCES = tuple(Stance(rotation, slanted) for rotation in (0.0, 90.0, 180.0, 270.0) for slanted in (False, True))


class Reading(NamedTuple):
    """What letter a shape may be, where the corner of its cell is from its first point, mm, and its width, mm."""

    letter: str
    stance: Stance
    corner: complex
    width: float


class Trail(NamedTuple):
    """What a pen went through in one letter: the kinds of its strokes, its points from the first one (mm, y up)."""

    signature: Signature
    points: tuple[complex, ...]


@lru_cache(maxsize=16384)
def readings(trail: Trail, unit: float, near: float = NEAR) -> tuple[Reading, ...]:
    """Give what letters a trail may be that a pen of a width in mm has drawn; () if it is none."""
    return tuple(_of(shapes().get(trail.signature, ()), trail, unit, near)) or tuple(
        _of(accented(trail.signature), trail, unit, near)
    )


def angles(trails: Sequence[tuple[Trail, float]]) -> Iterator[float]:
    """Give the angles (rad) at which the largest of some trails, with its pen, is a letter; readable ones first."""
    trail, unit = max(trails, key=lambda one: max(map(abs, one[0].points)))
    own = (*shapes().get(trail.signature, ()), *accented(trail.signature))
    found = (_angle(letter, trail, unit, stance) for stance in STANCES[:2] for letter in own)
    yield from sorted(dict.fromkeys(one for one in found if one is not None), key=abs)


def _angle(letter: LetterShape, trail: Trail, unit: float, stance: Stance) -> float | None:
    """Give the angle at which a trail is a letter, if it is: that of its farthest point."""
    first = _leaning(letter.points[0], stance)
    own = [_leaning(point, stance) - first for point in letter.points]
    far = max(range(len(own)), key=lambda k: abs(own[k]))
    if own[far] == 0 or trail.points[far] == 0:
        return None
    turn = trail.points[far] / own[far]
    turn *= unit / abs(turn)
    fits = all(abs(turn * point - seen) <= 2 * NEAR for point, seen in zip(own, trail.points, strict=True))
    return cmath.phase(turn) if fits else None


def _of(letters: Iterable[LetterShape], trail: Trail, unit: float, near: float) -> Iterator[Reading]:
    own = tuple(letters)
    for stance in STANCES:
        turn = stance.turn * unit
        for letter in own:
            first = _leaning(letter.points[0], stance)
            if all(
                abs(turn * (_leaning(point, stance) - first) - seen) <= near
                for point, seen in zip(reversed(letter.points), reversed(trail.points), strict=True)
            ):
                yield Reading(letter.letter, stance, -turn * first, letter.width * unit)


def _leaning(point: complex, stance: Stance) -> complex:
    return point + LEAN * point.imag if stance.slanted else point
