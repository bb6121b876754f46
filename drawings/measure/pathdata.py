"""Numbers, lengths and path data as SVG writes them, read strictly and in linear time.

Python's own float() is too kind for a stranger's file: it takes "nan", "1_000" and the digits of every script.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from drawings.paper.limits import NUMERAL_LENGTH, PATH_COMMANDS, SheetRefused

SPACE = " \t\r\n\f"
GAP = re.compile(rf"[{SPACE}]*(?:,[{SPACE}]*)?")
NUMERAL = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")

_ARGUMENTS = {"M": 2, "L": 2, "T": 2, "H": 1, "V": 1, "S": 4, "Q": 4, "C": 6, "A": 7, "Z": 0}
# All numbers of a command at once, each as long as it may be.
_NUMBER = rf"((?>{NUMERAL.pattern}))(?>{GAP.pattern})"
_TOGETHER = {letter: re.compile(_NUMBER * count) for letter, count in _ARGUMENTS.items() if letter not in "AZ"}
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
    """Read the next command's letter; one that is left out repeats the last."""
    if path[place] in _LETTERS:
        return path[place], _past_gap(path, place + 1)
    if letter == "" or letter in "Zz":
        raise SheetRefused("command", text=repr(path[place : place + _SAID]))
    return letter, place


def _arguments(path: str, place: int, letter: str) -> tuple[list[float], int]:
    together = _TOGETHER.get(letter.upper())
    found = together.match(path, place) if together else None
    if found is not None and found.end() - place <= NUMERAL_LENGTH:
        return [_finite(one) for one in found.groups()], found.end()
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
