"""Data of paths as untrusted input: lines, arcs and curves read off one text (данные путей)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable, Iterator
from functools import cache, lru_cache
from typing import NamedTuple, TypeAlias

from drawings.paper.limits import NUMERAL_LENGTH, PATH_COMMANDS, REACH, SheetRefused
from geometry.curve import CubicPiece, Piece, RoundPiece

# The four points of a cubic, or three points of an arc: any map of the plane can be made of points.
Spots: TypeAlias = tuple[complex, ...]
_CUBIC = 4

# Editors write about six digits of a radius: an arc with more between its two is of an ellipse.
_CURVE_ROUNDNESS = 1e-5


def curve(path: str) -> list[Spots]:
    """Read path data as pieces that go on from each other: cubics by four points, arcs by three.

    >>> curve("M0 0C1 0 2 1 2 2h3")[0]
    (0j, (1+0j), (2+1j), (2+2j))
    """
    found: list[Spots] = []
    for count, step in enumerate(steps(path)):
        if step.letter in "Mm" and count > 0:
            raise SheetRefused("pieces")
        found += _spots(step, found)
    if not found:
        raise SheetRefused("no_length")
    return found


def pieces(points: Iterable[Spots]) -> Iterator[Piece]:
    """Make pieces of their points; an arc whose three points are on one line is that line."""
    for spots in points:
        yield CubicPiece(*spots) if len(spots) == _CUBIC else _round(*spots)


def _spots(step: PathStep, before: list[Spots]) -> list[Spots]:
    """Give the points of one command; a line is a cubic gone through evenly."""
    start, end, values = step.start, step.end, step.values
    match step.letter.upper():
        case "M":
            return []
        case "Z" if start == end:
            return []
        case "A":
            return [_arc(start, end, values)]
        case "C":
            return [(start, *handles(step), end)]
        case "S":
            return [(start, _mirrored(before, start), *handles(step), end)]
        case "Q":
            (near,) = handles(step)
            return [(start, start + 2 / 3 * (near - start), end + 2 / 3 * (near - end), end)]
        case "T":
            raise SheetRefused("smooth_quadratic")
    return [(start, start + (end - start) / 3, end - (end - start) / 3, end)]


def handles(step: PathStep) -> list[complex]:
    """Give the points that a cubic is drawn by beside its ends."""
    origin = step.start if step.letter.islower() else 0j
    return [origin + complex(*step.values[k : k + 2]) for k in range(0, len(step.values) - 2, 2)]


def _mirrored(before: list[Spots], start: complex) -> complex:
    """Give the handle that goes on from that of a cubic before; without one there is none."""
    return 2 * start - before[-1][2] if before and len(before[-1]) == _CUBIC else start


def _arc(start: complex, end: complex, values: list[float]) -> Spots:
    """Give the ends and the middle of an arc; a radius that is too short to reach both ends is half their distance."""
    across, up, _, large, positive = values[:5]
    if not abs(abs(across) - abs(up)) <= _CURVE_ROUNDNESS * abs(across) or not 0 < abs(across) <= REACH:
        raise SheetRefused("ellipse")
    half = math.hypot((end - start).real, (end - start).imag) / 2
    if not 0 < half <= REACH:
        raise SheetRefused("arc_ends")
    centre, sweep = centred(start, end, abs(across), bool(large), bool(positive))
    return start, centre + (start - centre) * cmath.exp(0.5j * sweep), end


def centred(start: complex, end: complex, radius: float, large: bool, positive: bool) -> tuple[complex, float]:
    """Give the centre and the sweep of an arc; a radius that is too short is half of the way."""
    half = abs(end - start) / 2
    radius = max(radius, half)
    aside = math.sqrt((radius - half) * (radius + half)) * (1 if large != positive else -1)
    turn = 2 * math.asin(min(half / radius, 1.0))
    sweep = (math.tau - turn if large else turn) * (1 if positive else -1)
    return (start + end) / 2 + 1j * (end - start) / (2 * half) * aside, sweep


def _round(start: complex, middle: complex, end: complex) -> Piece:
    """Give the arc through three points, in that order."""
    u, v = middle - start, end - start
    doubled_area = 2 * (u.conjugate() * v).imag
    if doubled_area == 0:
        return CubicPiece(start, start + v / 3, end - v / 3, end)
    centre = start + 1j * (v * abs(u) ** 2 - u * abs(v) ** 2) / -doubled_area
    half = cmath.phase((middle - centre) / (start - centre)), cmath.phase((end - centre) / (middle - centre))
    return RoundPiece(start, centre, sum(half))


SPACE = " \t\r\n\f"
GAP = re.compile(rf"[{SPACE}]*(?:,[{SPACE}]*)?")
NUMERAL = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")

_ARGUMENTS = {"M": 2, "L": 2, "T": 2, "H": 1, "V": 1, "S": 4, "Q": 4, "C": 6, "A": 7, "Z": 0}
_NUMBER = rf"((?>{NUMERAL.pattern}))(?>{GAP.pattern})"
_LETTERS = frozenset("MLTHVSQCAZmlthvsqcaz")
_STRAIGHT = "MLHVZ"
# Among the seven arguments of an arc two are flags of one digit, which may stand without a gap.
_FLAGS = (3, 4)
# Editors place the ends of a circle's arcs to about six digits.
_ROUNDNESS = 1e-4
_SAID = 20  # letters of what is no number that are told


class PathTrace(NamedTuple):
    """The points that a path goes through, and whether it is straight from each to the next and in one piece."""

    points: tuple[complex, ...]
    straight: bool


class PathStep(NamedTuple):
    """One command of a path: its letter, its numbers, where it begins and ends."""

    letter: str
    values: list[float]
    start: complex
    end: complex


@lru_cache(maxsize=4096)  # the ends of a mark are read as a mark and as a line
def number(text: str) -> float:
    """Read one number.

    >>> number(" -.5e1 ")
    -5.0
    """
    text = text.strip(SPACE)
    match = NUMERAL.fullmatch(text) if len(text) <= NUMERAL_LENGTH else None
    if match is None:
        raise SheetRefused("number", text=repr(text[:_SAID]))
    return _finite(match[0])


def numbers(text: str) -> list[float]:
    """Read numbers set apart by spaces and commas.

    >>> numbers("1,2 3-4")
    [1.0, 2.0, 3.0, -4.0]
    """
    found: list[float] = []
    text = text.strip(SPACE)
    place = 0
    while place < len(text):
        value, place = _numeral(text, place)
        found.append(value)
        place = _past_gap(text, place)
    return found


def pair(text: str) -> complex:
    """Read two numbers as a point or vector.

    >>> pair("3 -4")
    (3-4j)
    """
    values = numbers(text)
    if len(values) != 2:
        raise SheetRefused("pair", text=repr(text[: 2 * _SAID]))
    return complex(*values)


def trace(path: str) -> PathTrace:
    """Follow path data through its points; curves count with their ends.

    >>> trace("m 1,1 h 2 V 5").points
    ((1+1j), (3+1j), (3+5j))
    """
    points: list[complex] = []
    straight = True
    for count, step in enumerate(steps(path)):
        straight = straight and step.letter.upper() in _STRAIGHT and (step.letter not in "Mm" or count == 0)
        if step.letter not in "Zz":
            points.append(step.end)
    return PathTrace(tuple(points), straight)


def steps(path: str) -> Iterator[PathStep]:
    """Follow path data command by command."""
    commands, place = 0, len(path) - len(path.lstrip(SPACE))
    here = start = 0j
    letter = ""
    while place < len(path):
        letter, place = _command(path, place, letter)
        commands += 1
        if commands > PATH_COMMANDS or (commands == 1 and letter not in "Mm"):
            raise SheetRefused("commands" if commands > 1 else "beginning")
        values, place = _arguments(path, place, letter)
        end = _reached(letter, values, here, start)
        yield PathStep(letter, values, here, end)
        here, start = end, end if letter in "Mm" else start
        letter = {"M": "L", "m": "l"}.get(letter, letter)


def centre(traced: PathTrace) -> complex | None:
    """Give the centre of a circle drawn as a path of two or more equal arcs; None if it is not one."""
    points = list(traced.points)
    if len(points) > 1 and abs(points[-1] - points[0]) <= _ROUNDNESS * max(abs(p - points[0]) for p in points):
        points.pop()
    if traced.straight or len(points) < 2:
        return None
    middle = sum(points) / len(points)
    radii = [abs(point - middle) for point in points]
    return middle if max(radii) - min(radii) <= _ROUNDNESS * max(radii) else None


def _finite(numeral: str) -> float:
    value = float(numeral)
    if not math.isfinite(value):
        raise SheetRefused("large", text=repr(numeral[:_SAID]))
    return value


def _numeral(text: str, place: int) -> tuple[float, int]:
    match = NUMERAL.match(text, place)
    if match is None or match.end() - place > NUMERAL_LENGTH:
        raise SheetRefused("number", text=repr(text[place : place + _SAID]))
    return _finite(match[0]), match.end()


def _past_gap(text: str, place: int) -> int:
    match = GAP.match(text, place)
    return match.end() if match else place


def _command(path: str, place: int, letter: str) -> tuple[str, int]:
    if path[place] in _LETTERS:
        return path[place], _past_gap(path, place + 1)
    if letter == "" or letter in "Zz":
        raise SheetRefused("command", text=repr(path[place : place + _SAID]))
    return letter, place


@cache
def _together(letter: str) -> re.Pattern[str]:
    """Find all numbers of a command at once, each as long as it may be."""
    return re.compile(_NUMBER * _ARGUMENTS[letter.upper()])


def _arguments(path: str, place: int, letter: str) -> tuple[list[float], int]:
    found = None if letter in "AaZz" else _together(letter).match(path, place)
    if found is not None and found.end() - place <= NUMERAL_LENGTH:
        return [_finite(text) for text in found.groups()], found.end()
    values: list[float] = []
    for index in range(_ARGUMENTS[letter.upper()]):
        if letter in "Aa" and index in _FLAGS:
            if path[place : place + 1] not in ("0", "1"):
                raise SheetRefused("flag", text=repr(path[place : place + _SAID]))
            value, place = float(path[place]), place + 1
        else:
            value, place = _numeral(path, place)
        values.append(value)
        place = _past_gap(path, place)
    return values, place


def _reached(letter: str, values: list[float], here: complex, start: complex) -> complex:
    """The point after a command, from the point before it and the start of its piece."""
    origin = here if letter.islower() else 0j
    match letter.upper():
        case "Z":
            return start
        case "H":
            return complex(origin.real + values[0], here.imag)
        case "V":
            return complex(here.real, origin.imag + values[0])
    return origin + complex(values[-2], values[-1])
