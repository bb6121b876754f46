"""Lettered paths: the data of a path as letters, each piece of it looked up once (надписи линиями)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from drawings.eye.letters import NEAR, Reading, Trail, readings
from drawings.eye.tracks import Track, tracks
from drawings.eye.writing import SeenLetter
from drawings.measure.transform import Affine
from drawings.paper.strokes import LineStyle

# Letters as a plain pen writes them: where each begins, and from there by steps.
_NUMBER = r"(-?[0-9]{1,7}(?:\.[0-9]{1,12})?)"
_LETTERS = re.compile(rf"M{_NUMBER} {_NUMBER}([lcm][^M]*)")
_MOST = 6  # strokes of a letter with its accents


def plain_letters(path: str, place: Affine, style: LineStyle) -> list[SeenLetter]:
    """Read path data that is written letter by letter; nothing, if it is not."""
    found = _LETTERS.findall(path)
    if sum(len(across) + len(down) + len(rest) + 2 for across, down, rest in found) != len(path):
        return []
    linear = (place.p, place.q, style.width)
    return [
        SeenLetter(place(complex(float(across), float(down))), style.width, *_looked_up(rest, *linear))
        for across, down, rest in found
    ]


def any_letters(path: str, place: Affine, style: LineStyle) -> list[SeenLetter]:
    """Read path data as an editor may have rewritten it: as many strokes as make a letter are one."""
    left = [track.mapped(place) for track in tracks(path)]
    found = []
    while left:
        own = _longest(left, style.width)
        found.append(own)
        left = left[len(own.trail.signature) :]
    return found


def pen_of_letters(style: LineStyle) -> bool:
    """Tell whether a line may be that of a letter: round at its ends, without gaps, not filled."""
    return style.cap == "round" and not style.dash and style.fill == "none" and style.colour != "none"


@lru_cache(maxsize=16384)
def _looked_up(steps: str, p: complex, q: complex, unit: float) -> tuple[Trail, tuple[Reading, ...]]:
    """Look up a letter by its steps from its first point."""
    linear = Affine(p, q)
    trail = _trail([track.mapped(linear) for track in tracks(f"M0 0{steps}")])
    return trail, readings(trail, unit)


def _longest(left: Sequence[Track], unit: float) -> SeenLetter:
    """Find the letter of the most strokes that a row of tracks begins with; an editor rounds it once more."""
    trails = [_trail(left[:count]) for count in range(min(_MOST, len(left)), 0, -1)]
    looked_up = ((trail, readings(trail, unit, 2 * NEAR)) for trail in trails)
    trail, found = next((one for one in looked_up if one[1]), (trails[-1], ()))
    return SeenLetter(left[0].start, unit, trail, found)


def _trail(own: Sequence[Track]) -> Trail:
    """Give tracks on paper as one trail from their first point."""
    first = own[0].start if own else 0j
    signature = tuple("".join(map(_kind, track.pieces)) + "z" * track.closed for track in own)
    return Trail(signature, tuple(point - first for track in own for point in track.points))


def _kind(piece: Sequence[complex]) -> str:
    return {1: "l", 2: "a", 3: "c"}[len(piece)]
