"""The usual engines as banks: cranks and guides in degrees, places in pitches of the shaft (схемы двигателей).

An engine stands about the middle of its shaft, and the reference guide is the middle of its V. Two rods of a V share a
place along the shaft: their offset along the crank pin is left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from plans.model.balance.bank import Member

HALF = Fraction(1, 2)


class Engine(NamedTuple):
    """An engine: its key among the words, and its mechanisms at a pitch of 1."""

    key: str
    members: tuple[Member, ...]


def _in_line(key: str, *cranks: int) -> Engine:
    """Set cylinders in line, a pitch apart."""
    return Engine(key, _named([(crank, place, 0) for crank, place in zip(cranks, _places(len(cranks)), strict=True)]))


def _vee(key: str, angle: int, *pins: int, split: int = 0) -> Engine:
    """Set two rows at an angle, two rods on every crank pin, or on two pins that are split by an angle."""
    half, throws = Fraction(angle, 2), zip(pins, _places(len(pins)), strict=True)
    return Engine(key, _named([row for pin, z in throws for row in ((pin, z, half), (pin + split, z, -half))]))


def _boxer(key: str, *pins: int) -> Engine:
    """Set cylinders against each other in turn, each with a crank pin of its own, half a pitch apart."""
    places = (place * HALF for place in _places(len(pins)))
    rows = zip(pins, places, strict=True)
    return Engine(key, _named([(pin, place, 180 * (k % 2)) for k, (pin, place) in enumerate(rows)]))


def _places(count: int) -> list[Fraction]:
    """Give places a pitch apart about the middle."""
    return [k - Fraction(count - 1, 2) for k in range(count)]


def _named(rows: Sequence[tuple[Fraction | int, Fraction, Fraction | int]]) -> tuple[Member, ...]:
    return tuple(
        Member(str(number), Fraction(crank), place, Fraction(axis))
        for number, (crank, place, axis) in enumerate(rows, 1)
    )


ENGINES = (
    _in_line("one", 0),
    _in_line("two_together", 0, 0),
    _in_line("two", 0, 180),
    _in_line("three", 0, 120, 240),
    _in_line("four", 0, 180, 180, 0),
    _in_line("five", 0, 144, 216, 288, 72),
    _in_line("six", 0, 120, 240, 240, 120, 0),
    _vee("vee_two", 90, 0),
    _vee("vee_four", 90, 0, 180),
    _vee("vee_six_90", 90, 0, 120, 240),
    _vee("vee_six_60", 60, 0, 120, 240, split=60),
    _vee("vee_eight_flat", 90, 0, 180, 180, 0),
    _vee("vee_eight", 90, 0, 90, 270, 180),
    _boxer("boxer_two", 0, 180),
    _boxer("boxer_four", 0, 180, 180, 0),
    _boxer("boxer_six", 0, 180, 120, 300, 240, 60),
)
