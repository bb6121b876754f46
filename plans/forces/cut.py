"""A group cut out of the mechanism, with all forces on it and its force polygon (схема нагружения, план сил группы)."""

from __future__ import annotations

from typing import NamedTuple

from geometry.board import Mark
from plans.model.group import Group
from plans.model.mechanism import Slide

WEIGHT, INERTIA, LOAD, REACTION = "weight", "inertia", "load", "reaction"
KNOWN, PART, CLOSING = "known", "part", "closing"


class Load(NamedTuple):
    """A known force on a link: its letters, its point on the plan of positions, its vector on the plan of forces."""

    name: str
    link: int
    at: Mark
    force: Mark
    kind: str  # weight, inertia, load, or the reaction of a group that was cut off before
    point: str = ""  # of a load the letter of its point


class Couple(NamedTuple):
    """A known moment on a link."""

    name: str
    link: int
    moment: Mark
    kind: str


class Support(NamedTuple):
    """A reaction as it was found: the force of one link on another, its parts, and of a sliding pair its moment.

    `at` is the hinge, or the slider's named point, about which the moment is told; no moment: it is zero.
    """

    giver: int
    taker: int
    at: Mark
    force: Mark
    parts: tuple[Mark, ...]  # tangential and normal to the lead, or along and square to the slot
    slide: Slide | None
    moment: Mark | None
    point: str  # the letter of the hinge, or of the slider's point


class Side(NamedTuple):
    """A side of a force polygon: a known force, a part found by moments, or one that closes the polygon."""

    name: str
    start: Mark
    end: Mark
    kind: str


class Equation(NamedTuple):
    """An equation of moments about a point: loads and couples in it, and the force along a line that it gives."""

    about: Mark
    loads: tuple[Load, ...]
    couples: tuple[Couple, ...]
    line: Mark | None  # None: the moment itself is found
    found: Mark


class Cut(NamedTuple):
    """A group, or the primary link, with its known forces, its reactions, its equations and its polygon in order."""

    group: Group | None
    links: tuple[int, ...]
    loads: tuple[Load, ...]
    couples: tuple[Couple, ...]
    supports: tuple[Support, ...]  # outer reactions on the group's links
    inner: Support | None
    equations: tuple[Equation, ...]
    sides: tuple[Side, ...]

    @property
    def reactions(self) -> tuple[Support, ...]:
        """All reactions that the cut gives: the outer ones and the inner one."""
        return self.supports if self.inner is None else (*self.supports, self.inner)

    @property
    def label(self) -> str:
        """The links of the group: "4-5"."""
        return "-".join(map(str, self.links))


def indices(giver: int, taker: int) -> str:
    """Write the two links of a reaction as its index.

    >>> indices(3, 4), indices(9, 10)
    ('34', '9,10')
    """
    return f"{giver},{taker}" if max(giver, taker) > 9 else f"{giver}{taker}"
