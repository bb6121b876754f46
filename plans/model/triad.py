"""Triads: groups of class III, a basis link on three leads (трёхповодковые группы, базисное звено; figure 6.13)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import NamedTuple

from geometry.three_leads import GUIDE, ROD, SLOT
from plans.model.dyad import Joint, Pair, joints
from plans.model.mechanism import Mechanism, Slide, StructureError
from plans.words.words import message

KINDS = ROD, GUIDE, SLOT  # of leads, in the order in which a triad has them


class TriadLead(NamedTuple):
    """A lead (поводок): its link, the host that it hangs on, its outer pair and its inner one with the basis link."""

    link: int
    host: int
    outer: Joint
    inner: Joint

    @property
    def kind(self) -> str:
        """Its pairs, the outer one first: RR, PR or RP."""
        return "".join("R" if isinstance(joint, str) else "P" for joint in (self.outer, self.inner))

    @property
    def slide(self) -> Slide:
        """Its sliding pair."""
        joint = self.outer if isinstance(self.outer, Slide) else self.inner
        assert isinstance(joint, Slide)  # asked of leads that have one
        return joint

    @property
    def pin(self) -> str:
        """The point of its hinge with the basis link, or of the outer one where it has no other."""
        joint = self.inner if isinstance(self.inner, str) else self.outer
        assert isinstance(joint, str)  # no lead slides at both ends
        return joint

    @property
    def hinge(self) -> str:
        """The point of its outer hinge."""
        assert isinstance(self.outer, str)  # asked of leads that have one
        return self.outer


class Triad(NamedTuple):
    """A group of class III: a basis link that three leads hold, which hang on three hosts."""

    basis: int
    leads: tuple[TriadLead, TriadLead, TriadLead]
    kind: str = "triad"
    order: str = "III"

    @property
    def links(self) -> tuple[int, ...]:
        """Its links, the basis link last."""
        return (*(lead.link for lead in self.leads), self.basis)

    @property
    def label(self) -> str:
        """The group as the formula of structure writes it: class and links."""
        return f"{self.order}({','.join(map(str, sorted(self.links)))})"

    @property
    def outer_pairs(self) -> tuple[Pair, ...]:
        """The three pairs by which it hangs on its hosts."""
        return tuple(Pair(lead.host, lead.link, lead.outer) for lead in self.leads)

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The three pairs of its basis link."""
        return tuple(Pair(lead.link, self.basis, lead.inner) for lead in self.leads)


def triads(mechanism: Mechanism, solved: set[int], left: list[int]) -> Iterator[Triad]:
    """Yield the triads that hang on solved links, lowest basis link first."""
    for basis in left:
        if joints(mechanism, basis, solved, set()):
            continue
        inner = joints(mechanism, basis, set(left) - {basis}, solved)
        leads = [TriadLead(link, *outer, joint) for link, joint in inner for outer in _held(mechanism, link, solved)]
        for three in combinations(leads, 3):
            if len({lead.link for lead in three}) == 3:
                yield _sorted(basis, three)


def _held(mechanism: Mechanism, link: int, solved: set[int]) -> list[tuple[int, Joint]]:
    """Give the one joint by which a lead hangs on solved links."""
    found = joints(mechanism, link, solved, set())
    return found if len(found) == 1 else []


def _sorted(basis: int, leads: tuple[TriadLead, ...]) -> Triad:
    for lead in leads:
        if lead.kind not in KINDS:
            raise StructureError(message("structure.sliding_lead", link=lead.link, basis=basis), (lead.link,))
    first, second, third = sorted(leads, key=lambda lead: (KINDS.index(lead.kind), lead.link))
    return Triad(basis, (first, second, third))
