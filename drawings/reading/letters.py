"""Letters recognised from their strokes: each shape of a size is looked up once (распознавание букв)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache, lru_cache
from typing import NamedTuple

from drawings.paper.strokes import LEAN
from drawings.reading.alphabet import LetterShape, Signature, accented, shapes

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


class LetterReading(NamedTuple):
    """What letter a shape may be, from its first point the corner of its cell along its line, mm, and its width, mm."""

    letter: str
    stance: Stance
    corner: complex
    width: float


class Trail(NamedTuple):
    """What a pen went through in one letter: the kinds of its strokes, its points from the first one (mm, y up)."""

    signature: Signature
    points: tuple[complex, ...]


@lru_cache(maxsize=16384)
def readings(trail: Trail, unit: float, near: float = NEAR) -> Mapping[Stance, Sequence[LetterReading]]:
    """Give by stances what letters a trail may be that a pen of a width in mm has drawn; nothing if it is none."""
    fit = tuple(_of(trail, unit, near, False)) or tuple(_of(trail, unit, near, True))
    return {stance: [way for way in fit if way.stance is stance] for stance in dict.fromkeys(way.stance for way in fit)}


def angles(trails: Sequence[tuple[Trail, float]]) -> Iterator[float]:
    """Give the angles (rad) at which the largest of some trails, with its pen, is a letter; readable ones first."""
    trail, unit = max(trails, key=lambda pair: max(map(abs, pair[0].points)))
    stood = (*_stood(trail.signature, False), *_stood(trail.signature, True))
    found = (_angle(points, trail, unit) for letter, points in stood if letter.stance in STANCES[:2])
    yield from sorted(dict.fromkeys(angle for angle in found if angle is not None), key=abs)


def _angle(corners: Sequence[complex], trail: Trail, unit: float) -> float | None:
    """Give the angle at which a trail is a letter of some points, if it is: that of its farthest one."""
    far = max(range(len(corners)), key=lambda k: abs(corners[k]))
    if corners[far] == 0 or trail.points[far] == 0:
        return None
    turn = trail.points[far] / corners[far]
    turn *= unit / abs(turn)
    fits = all(abs(turn * point - spot) <= 2 * NEAR for point, spot in zip(corners, trail.points, strict=True))
    return cmath.phase(turn) if fits else None


def _of(trail: Trail, unit: float, near: float, accents: bool) -> Iterator[LetterReading]:
    last, off = trail.points[-1] / unit if unit and trail.points else 0j, near / unit if unit else 0.0
    for found, points in _stood(trail.signature, accents):
        if abs(points[-1] - last) <= off and all(
            abs(point * unit - spot) <= near for point, spot in zip(points, trail.points, strict=True)
        ):
            yield found._replace(corner=found.corner * unit, width=found.width * unit)


@cache
def _stood(signature: Signature, accents: bool) -> tuple[tuple[LetterReading, tuple[complex, ...]], ...]:
    """Give the letters of a signature in all stances, d: what each is, and its points from the first one."""
    letters = accented(signature) if accents else shapes().get(signature, ())
    return tuple(_standing(letter, stance) for stance in STANCES for letter in letters)


def _standing(letter: LetterShape, stance: Stance) -> tuple[LetterReading, tuple[complex, ...]]:
    points = [_leaning(point, stance) for point in letter.points]
    found = LetterReading(letter.letter, stance, -points[0], letter.width)
    return found, tuple(stance.turn * (point - points[0]) for point in points)


def _leaning(point: complex, stance: Stance) -> complex:
    return point + LEAN * point.imag if stance.slanted else point
