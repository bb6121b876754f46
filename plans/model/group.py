"""A structural group: what every one of them has, however many links it is of (группа Ассура)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol, TypeAlias

from plans.model.mechanism import FRAME, Mechanism, Slide

Joint: TypeAlias = str | Slide  # a hinge by its point, or a sliding pair


class Pair(NamedTuple):
    """A lower pair as forces see it: the link that gives its reaction, the one that takes it, and their joint.

    `point` is the hinge, or the slider's point that the scene names: there the reaction is told.
    """

    giver: int
    taker: int
    joint: Joint

    @property
    def key(self) -> str:
        """The pair as it is named: "3-4"."""
        return f"{self.giver}-{self.taker}"

    @property
    def point(self) -> str:
        """The letter of the point at which the reaction is told."""
        return self.joint if isinstance(self.joint, str) else self.joint.point


class Group(Protocol):
    """A structural group: links that have one place, or one of a few, as soon as their hosts have theirs."""

    @property
    def kind(self) -> str:
        """Its kind, by which its constructions are found: "RRP"."""

    @property
    def order(self) -> str:
        """Its class by Assur and Artobolevsky: "II" (класс группы)."""

    @property
    def label(self) -> str:
        """The group as the formula of structure writes it: class, kind, links."""

    @property
    def links(self) -> tuple[int, ...]:
        """Its links."""

    @property
    def outer_pairs(self) -> tuple[Pair, ...]:
        """The pairs by which it hangs on its hosts: each is of a host with a link of the group."""

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs of its links with each other."""


def pair(one: int, other: int, joint: Joint) -> Pair:
    """Name a pair: the reaction of its lower-numbered link on the other."""
    return Pair(min(one, other), max(one, other), joint)


def pairs(mechanism: Mechanism, groups: Sequence[Group]) -> tuple[Pair, ...]:
    """Give all lower pairs in solving order; a hinge of several links is told as the groups hang on it."""
    found = [pair(FRAME, mechanism.drive.link, mechanism.drive.guide or mechanism.drive.pivot)]
    for group in groups:
        found += [pair(*told) for told in (*group.outer_pairs, *group.inner_pairs)]
    return tuple(found)
