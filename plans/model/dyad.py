"""Structure: Assur groups with their pairs, and the dyads among them, groups of class II (6.4.4)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import NamedTuple, Protocol, TypeAlias

from geometry.meet import EPS, TANGENCY
from plans.model.mechanism import FRAME, Mechanism, Slide, StructureError
from plans.words.words import message

# The five kinds of two-lead groups, numbered as the textbook does (figure 6.12): outer, inner, outer pair.
NUMBERS = {"RRR": 1, "RRP": 2, "RPR": 3, "PRP": 4, "RPP": 5}


class Dyad(NamedTuple):
    """A two-lead group of class II (двухповодковая группа): its two links, their hosts, and its three pairs."""

    kind: str
    links: tuple[int, int]
    hosts: tuple[int, int]
    outer: tuple[Joint, Joint]
    inner: Joint

    @property
    def order(self) -> str:
        """Its class."""
        return "II"

    @property
    def label(self) -> str:
        """The group as the formula of structure writes it: class, kind, links."""
        return f"{self.order}{NUMBERS[self.kind]}({self.links[0]},{self.links[1]})"

    @property
    def outer_pairs(self) -> tuple[Pair, ...]:
        """The two pairs by which it hangs on its hosts."""
        return tuple(Pair(*outer) for outer in zip(self.hosts, self.links, self.outer, strict=True))

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pair between its links."""
        return (Pair(*self.links, self.inner),)

    def hinge(self, end: int) -> str:
        """Give the point of an outer hinge."""
        joint = self.outer[end]
        if not isinstance(joint, str):
            raise TypeError(f"{self.label} has no hinge there")
        return joint

    def slide(self, end: int | None = None) -> Slide:
        """Give the slide of an outer pair, or of the inner pair."""
        joint = self.inner if end is None else self.outer[end]
        if isinstance(joint, str):
            raise TypeError(f"{self.label} has no slide there")
        return joint

    @property
    def pin(self) -> str:
        """The point of the inner hinge."""
        if not isinstance(self.inner, str):
            raise TypeError(f"{self.label} has no inner hinge")
        return self.inner


def dyads(mechanism: Mechanism, solved: set[int], left: list[int]) -> Iterator[Dyad]:
    """Yield the dyads that hang on solved links, lowest link numbers first."""
    for first, second in combinations(left, 2):
        inner = joints(mechanism, first, {second}, solved)
        ends = [joints(mechanism, link, solved, set()) for link in (first, second)]
        if len(inner) == 1 and len(ends[0]) == len(ends[1]) == 1:
            (host, joint), (other_host, other) = ends[0][0], ends[1][0]
            yield _named((first, second), (host, other_host), (joint, other), inner[0][1])


def joints(mechanism: Mechanism, link: int, others: set[int], solved: set[int]) -> list[tuple[int, Joint]]:
    """Give the joints of a link with some others; a hinge at a solved point is no joint between unknowns."""
    found: list[tuple[int, Joint]] = []
    for point, owners in mechanism.hinges.items():
        partners = [owner for owner in owners if owner in others]
        if link in owners and partners and not (solved & set(owners)):
            found.append((_bearing(mechanism, partners), point))
    for slide in mechanism.slides:
        if link == slide.slider and slide.owner in others:
            found.append((slide.owner, slide))
        elif link == slide.owner and slide.slider in others:
            found.append((slide.slider, slide))
    return found


def _bearing(mechanism: Mechanism, partners: list[int]) -> int:
    """Choose on which of the links that share a pin a group hangs: one borne by the frame, as crank or rocker are.

    Positions are the same on any of them; reactions are told as the textbook does, of the rocker on the rod.
    """
    fixed = mechanism.links[FRAME].points
    borne = {slide.slider for slide in mechanism.slides if slide.owner == FRAME}
    grounded = [link for link in partners if link in borne or fixed.keys() & mechanism.links[link].points.keys()]
    return min(grounded or partners)


def _named(links: tuple[int, int], hosts: tuple[int, int], outer: tuple[Joint, Joint], inner: Joint) -> Dyad:
    letters = [("R" if isinstance(joint, str) else "P") for joint in (outer[0], inner, outer[1])]
    if letters[0] == "P" and letters[2] == "R":  # the hinge's lead comes first
        links, hosts, outer = links[::-1], hosts[::-1], outer[::-1]
        letters.reverse()
    kind = "".join(letters)
    if kind not in NUMBERS:
        raise StructureError(message("structure.three_slides", first=links[0], second=links[1]), links)
    dyad = Dyad(kind, links, hosts, outer, inner)
    if isinstance(inner, Slide) and isinstance(outer[1], Slide):
        slot, guided = (slide.way(links[1]).direction for slide in (inner, outer[1]))
        if abs((slot.conjugate() * guided).imag) <= TANGENCY * EPS:
            raise StructureError(message("structure.slot", link=links[1], first=links[0], second=links[1]), links)
    return dyad


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


class Assur(Protocol):
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


def pair(first: int, other: int, joint: Joint) -> Pair:
    """Name a pair: the reaction of its lower-numbered link on the other."""
    return Pair(min(first, other), max(first, other), joint)


def pairs(mechanism: Mechanism, groups: Sequence[Assur]) -> tuple[Pair, ...]:
    """Give all lower pairs in solving order; a hinge of several links is told as the groups hang on it."""
    found = [pair(FRAME, mechanism.drive.link, mechanism.drive.guide or mechanism.drive.pivot)]
    for group in groups:
        found += [pair(*links) for links in (*group.outer_pairs, *group.inner_pairs)]
    return tuple(found)


CLASSES = ("I", "II", "III", "IV")  # of groups and mechanisms, the simplest first


def formula(mechanism: Mechanism, groups: Sequence[Assur]) -> str:
    """Write the formula of structure (формула строения), such as I(0,1) -> II3(2,3) -> II2(4,5)."""
    return " -> ".join([f"I(0,{mechanism.drive.link})", *(group.label for group in groups)])


def mechanism_class(groups: Sequence[Assur]) -> str:
    """Give the class of the mechanism: the highest class of its groups (класс механизма)."""
    return max([CLASSES[0], *(group.order for group in groups)], key=CLASSES.index)
