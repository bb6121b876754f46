"""Tracks: what a path goes through, piece by piece, in its own units (следы пера)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple, TypeAlias

from drawings.measure.pathdata import PathStep, steps
from drawings.measure.transform import Affine
from drawings.paper.limits import SheetRefused

# The end of a straight piece, three points of a cubic; of an arc its middle and its end.
Piece: TypeAlias = tuple[complex] | tuple[complex, complex, complex] | tuple[complex, complex]

# Straight chains and arcs as a plain pen writes them; all else is for the strict reader.
_PLAIN = re.compile(r"[MLAZ][-\d. ]*")
_NUMERAL = re.compile(r"-?(?:\d+(?:\.\d+)?|\.\d+)")
_ROUND = 1e-5  # Editors write about six digits of a radius: an arc with more between its two is of an ellipse.


class Track(NamedTuple):
    """What a pen goes through without being lifted: from its start by pieces, and whether it is closed."""

    start: complex
    pieces: tuple[Piece, ...]
    closed: bool = False

    @property
    def points(self) -> tuple[complex, ...]:
        """All its points, handles and middles too."""
        return (self.start, *(point for piece in self.pieces for point in piece))

    def mapped(self, place: Affine) -> Track:
        """Give it on paper: an affine map takes each point where it belongs, but of arcs when it stretches."""
        pieces = tuple(tuple(place(point) for point in piece) for piece in self.pieces)
        return Track(place(self.start), pieces, self.closed)  # type: ignore[arg-type]


def tracks(path: str) -> list[Track]:
    """Read path data; a move that nothing follows leaves no track.

    >>> tracks("m1 1h2v2z")
    [Track(start=(1+1j), pieces=(((3+1j),), ((3+3j),)), closed=True)]
    """
    plain = _plain(path)
    return _tracks(steps(path) if plain is None else plain)


def _tracks(commands: Iterable[PathStep]) -> list[Track]:
    found: list[Track] = []
    start, pieces, closed = 0j, list[Piece](), False
    for step in commands:
        letter = step.letter.upper()
        if (letter == "M" or closed) and pieces:
            found.append(Track(start, tuple(pieces), closed))
            pieces = []
        if letter == "M" or closed:
            start = step.end if letter == "M" else step.start
        closed = letter == "Z"
        if letter not in "MZ":
            pieces += _pieces(step, pieces)
    return [*found, Track(start, tuple(pieces), closed)] if pieces else found


def _plain(path: str) -> list[PathStep] | None:
    """Take apart what a plain pen writes, fast; None of all else."""
    found: list[PathStep] = []
    here = start = 0j
    place = 0
    for match in _PLAIN.finditer(path):
        words = match[0][1:].split()
        if match.start() != place or not all(map(_NUMERAL.fullmatch, words)):
            return None
        place, letter, values = match.end(), match[0][0], [float(word) for word in words]
        if letter == "Z":
            found.append(PathStep(letter, [], here, start))
            here = start
            continue
        if len(values) != (7 if letter == "A" else 2) or (letter == "A" and not {*words[3:5]} <= {"0", "1"}):
            return None
        end = complex(values[-2], values[-1])
        found.append(PathStep(letter, values, here, end))
        here, start = end, end if letter == "M" else start
    return found if place == len(path) and path[:1] == "M" else None


def _pieces(step: PathStep, before: list[Piece]) -> list[Piece]:
    """Give the pieces of one command."""
    start, end = step.start, step.end
    match step.letter.upper():
        case "A":
            return list(_arc(start, end, step.values))
        case "C":
            first, second = _handles(step)
            return [(first, second, end)]
        case "S":
            (second,) = _handles(step)
            mirrored = 2 * start - before[-1][1] if before and len(before[-1]) == 3 else start
            return [(mirrored, second, end)]
        case "T":
            raise SheetRefused("smooth_quadratic")
        case "Q":
            (near,) = _handles(step)
            return [(start + 2 / 3 * (near - start), end + 2 / 3 * (near - end), end)]
    return [(end,)]


def _handles(step: PathStep) -> list[complex]:
    origin = step.start if step.letter.islower() else 0j
    return [origin + complex(*step.values[k : k + 2]) for k in range(0, len(step.values) - 2, 2)]


def _arc(start: complex, end: complex, values: list[float]) -> Iterator[Piece]:
    """Give an arc by its middle and end, that of an ellipse by cubics; one without a radius is straight."""
    across, up, tilt, large, positive = values[:5]
    across, up = abs(across), abs(up)
    if start == end:
        return
    if not (across and up):
        yield (end,)
    elif abs(across - up) <= _ROUND * max(across, up):
        centre, sweep = _centred(start, end, across, bool(large), bool(positive))
        yield centre + (start - centre) * cmath.exp(0.5j * sweep), end
    else:
        yield from _ellipse(start, end, complex(across, up), tilt, (bool(large), bool(positive)))


def _centred(start: complex, end: complex, radius: float, large: bool, positive: bool) -> tuple[complex, float]:
    """Give the centre and the sweep of an arc; a radius that is too short is half of the way."""
    half = abs(end - start) / 2
    radius = max(radius, half)
    aside = math.sqrt((radius - half) * (radius + half)) * (1 if large != positive else -1)
    turn = 2 * math.asin(min(half / radius, 1.0))
    sweep = (math.tau - turn if large else turn) * (1 if positive else -1)
    return (start + end) / 2 + 1j * (end - start) / (2 * half) * aside, sweep


def _ellipse(start: complex, end: complex, radii: complex, tilt: float, flags: tuple[bool, bool]) -> Iterator[Piece]:
    """Go along an arc of an ellipse as along that of a circle, which is stretched then."""
    turn = cmath.rect(1, math.radians(tilt))

    def pressed(point: complex) -> complex:
        own = point / turn
        return complex(own.real / radii.real, own.imag / radii.imag)

    def stretched(point: complex) -> complex:
        return turn * complex(point.real * radii.real, point.imag * radii.imag)

    first = pressed(start)
    centre, sweep = _centred(first, pressed(end), 1.0, *flags)
    count = max(1, math.ceil(abs(sweep) / (math.pi / 2) - 1e-9))
    handle, step = 4 / 3 * math.tan(sweep / count / 4), cmath.exp(1j * sweep / count)
    a = first - centre
    for _ in range(count):
        b = a * step
        yield stretched(centre + a + handle * 1j * a), stretched(centre + b - handle * 1j * b), stretched(centre + b)
        a = b
