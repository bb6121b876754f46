"""Vectors that the plans of a group have: told by what they come from, not by how they are drawn (векторы планов)."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias


class Turning(NamedTuple):
    """A link's tip turns about its start: a velocity, a normal and a tangential part of an acceleration."""

    link: int
    start: str
    tip: str


class Slotted(NamedTuple):
    """A pin in the slot of a link that turns about a pivot: the link's point under it, slip, Coriolis, normal part."""

    link: int
    pivot: str
    pin: str


class Sliding(NamedTuple):
    """A pin that slides along a guide of a link that moves: its slip, Coriolis and relative part over that link.

    `pair` names the sliding pair by its two links; a `held` pin is that of the stone, and its host's point slips.
    """

    pair: tuple[int, int]
    host: int
    pin: str
    held: bool = False


Vector: TypeAlias = Turning | Slotted | Sliding
