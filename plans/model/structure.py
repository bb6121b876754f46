"""Structure: links and kinematic pairs without sizes, mobility by the formulas of structure (структура; book 6.4.4).

Every pair of a planar mechanism turns, slides, or is a contact in its plane, whatever it allows across that: a
spherical pair turns as a turning one does. A pair is counted by its mobility: of p_1 one motion is left, of p_5 five.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Final, NamedTuple

from plans.model.mechanism import FRAME, StructureError
from plans.words.words import message

TURNING, SLIDING, CONTACT = "R", "P", "K"  # what a pair is in its plane
CYLINDRICAL, SPHERICAL, LINE, POINT = "C", "S", "L", CONTACT  # a contact in a point is one in space too
# How many of six motions in space each kind of pair allows: T is spherical with a finger, E plane, B a ball in a tube.
MOBILITIES: Final[Mapping[str, int]] = {"R": 1, "P": 1, "C": 2, "T": 2, "S": 3, "E": 3, "B": 4, "L": 4, "K": 5}
SPACE, PLANAR = 6, 3  # motions of a free body
# What makes a pair freer without a change in its plane, the least change first.
FREER: Final[Mapping[str, str]] = {TURNING: CYLINDRICAL + SPHERICAL, SLIDING: CYLINDRICAL, LINE: POINT}


class CurvatureCentre(NamedTuple):
    """A centre of curvature of a contact: a point of one of its links, by its letter, and its place m."""

    name: str
    link: int
    at: complex


class Joint(NamedTuple):
    """A joint: a kinematic pair (кинематическая пара) of two links, or a hinge of several; what it is in the plane.

    `at` is its place m in one position; `along` the direction of a slide, or the normal of a contact, which has its
    centres of curvature but at a flat side. No two joints share a name, though their letters may be the same.
    """

    name: str
    links: tuple[int, ...]
    nature: str
    kind: str
    at: complex = 0j
    along: complex = 1 + 0j
    centres: tuple[CurvatureCentre, ...] = ()

    @property
    def letter(self) -> str:
        """Its letter."""
        return self.name.partition(" ")[0]

    @property
    def key(self) -> str:
        """Its links as a scene names them.

        >>> Joint("A", (1, 2), TURNING, TURNING).key, Joint("A", (1, 12), TURNING, TURNING).mark
        ('1-2', 'A_1,12')
        """
        return "-".join(map(str, self.links))

    @property
    def mark(self) -> str:
        """Its letter with its links: A_12."""
        return f"{self.letter}_{self.key.replace('-', ',' if max(self.links) > 9 else '')}"

    @property
    def mobility(self) -> int:
        """How many motions it allows (подвижность пары)."""
        return MOBILITIES[self.kind]

    @property
    def constraints(self) -> int:
        """How many it takes: its class by Artobolevsky (класс пары)."""
        return SPACE - self.mobility

    @property
    def pairs(self) -> tuple[Joint, ...]:
        """Its pairs: a hinge of k links counts k - 1 times, each time with the link of the lowest number."""
        first, *others = sorted(self.links)
        return tuple(self._replace(name=f"{self.letter} {first}-{one}", links=(first, one)) for one in others)

    def altered(self, kinds: Mapping[str, str]) -> tuple[Joint, ...]:
        """Give it with other kinds of its pairs, each by itself if there are any."""
        if not any(pair.key in kinds for pair in self.pairs):
            return (self,)
        return tuple(pair._replace(kind=kinds.get(pair.key, pair.kind)) for pair in self.pairs)

    def within(self, links: Iterable[int], known: Iterable[int] = ()) -> int:
        """Count its pairs among some links, and of these with links whose places are known."""
        own = len(set(self.links).intersection(links))
        return own - 1 + (not set(self.links).isdisjoint(known)) if own else 0


class Structure(NamedTuple):
    """The moving links of a mechanism and all its joints; link 0 is the frame."""

    links: tuple[int, ...]
    joints: tuple[Joint, ...]

    @property
    def pairs(self) -> tuple[Joint, ...]:
        """All kinematic pairs, in the order of their links."""
        return tuple(sorted((pair for joint in self.joints for pair in joint.pairs), key=lambda pair: pair.links))

    @property
    def lower(self) -> int:
        """Number p_1 of the planar formula: pairs that turn or slide."""
        return sum(pair.nature != CONTACT for pair in self.pairs)

    @property
    def higher(self) -> int:
        """Number p_2 of the planar formula: contacts."""
        return sum(pair.nature == CONTACT for pair in self.pairs)

    @property
    def planar(self) -> int:
        """Mobility by Chebyshev: W = 3n - 2 p_1 - p_2."""
        return PLANAR * len(self.links) - 2 * self.lower - self.higher

    @property
    def counts(self) -> tuple[int, ...]:
        """Numbers p_1 to p_5 of pairs by their mobility in space."""
        found = Counter(pair.mobility for pair in self.pairs)
        return tuple(found[mobility] for mobility in range(1, SPACE))

    @property
    def spatial(self) -> int:
        """Mobility by Somov and Malyshev: W = 6n - 5 p_1 - 4 p_2 - 3 p_3 - 2 p_4 - p_5."""
        return SPACE * len(self.links) - sum(pair.constraints for pair in self.pairs)

    @property
    def primaries(self) -> tuple[int, ...]:
        """The links that a pair of one mobility joins to the frame: each may be the primary link (начальное звено)."""
        framed = {
            link for joint in self.joints if FRAME in joint.links and joint.nature != CONTACT for link in joint.links
        }
        return tuple(sorted(framed - {FRAME}))

    def altered(self, kinds: Mapping[str, str]) -> Structure:
        """Give it with other kinds of some pairs, by their links; a hinge of several links is parted for that."""
        return self._replace(joints=tuple(part for joint in self.joints for part in joint.altered(kinds)))

    def lowered(self) -> Structure:
        """Replace each contact by a link with two lower pairs at its centres of curvature (замена высших пар)."""
        links, joints = list(self.links), {joint.name: joint for joint in self.joints if joint.nature != CONTACT}
        for contact in (joint for joint in self.joints if joint.nature == CONTACT):
            links.append(max(links) + 1)
            for centre in contact.centres:
                hinge = joints.get(centre.name) or Joint(centre.name, (centre.link,), TURNING, TURNING, centre.at)
                joints[centre.name] = hinge._replace(links=(*hinge.links, links[-1]))
            for flat in set(contact.links) - {centre.link for centre in contact.centres}:
                name = f"{contact.letter} {flat}-{links[-1]}"
                joints[name] = Joint(name, (flat, links[-1]), SLIDING, SLIDING, contact.at, 1j * contact.along)
        return Structure(tuple(links), tuple(joints.values()))


class AssurGroup(NamedTuple):
    """A structural group of no mobility (группа Ассура): its links, the joints that it brings, its class.

    `number` is the kind of a two-lead group, 1 to 5; `order` is how many pairs it hangs by (порядок).
    """

    links: tuple[int, ...]
    joints: tuple[Joint, ...]
    rank: int
    order: int
    number: int = 0

    @property
    def roman(self) -> str:
        """Its class in the figures of Rome."""
        return ROMAN[self.rank]

    @property
    def label(self) -> str:
        """The group as the formula of structure writes it: class, kind, links."""
        return f"{self.roman}{self.number or ''}({','.join(map(str, self.links))})"


ROMAN = ("0", "I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X", "XI", "XII")


class GroupDivision(NamedTuple):
    """A mechanism divided into its primary links and groups in the order of their attachment (деление на группы)."""

    primaries: tuple[int, ...]
    groups: tuple[AssurGroup, ...]

    @property
    def rank(self) -> int:
        """The class of the mechanism: the highest of its groups (класс механизма)."""
        return max((group.rank for group in self.groups), default=1)

    @property
    def letters(self) -> str:
        """The letters of its class.

        >>> GroupDivision((1,), ()).letters, GroupDivision((1, 5), ()).letters
        ('k_1', 'k_1,5')
        """
        return f"k_{','.join(map(str, self.primaries))}"

    @property
    def name(self) -> str:
        """The primary link as the formula writes it; of several all of them."""
        return " + ".join(f"I(0,{link})" for link in self.primaries)

    @property
    def formula(self) -> str:
        """The formula of structure (формула строения)."""
        return " -> ".join([self.name, *(group.label for group in self.groups)])


class NoMechanism(StructureError):  # noqa: N818  (the exception tree's own word)
    """Links and pairs that do not move, or do not divide into groups."""


def no_division(links: Iterable[int]) -> NoMechanism:
    """Refuse links that are no groups: slides alone hold their turning twice."""
    left = tuple(links)
    return NoMechanism(message("structure.no_groups", links=", ".join(map(str, left))), left)
