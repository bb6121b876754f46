"""Constraints of a planar mechanism in its plane and across it: which hold twice, and how they are freed.

Of small motions those in the plane and those across it do not know each other. In the plane a link has two shifts and
a turn. Across it the link moves as a lamina that is lifted and tilted: its lift is c + a x + b y. A hinge gives two
laminae one lift and one tilt at its place, a spherical pair one lift, a cylindrical one one tilt. Constraints that
depend on others are redundant (избыточные связи); motions that all constraints leave are local (местные подвижности).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations, islice, product
from math import comb
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from plans.model.mechanism import FRAME
from plans.model.motion import Floats
from plans.model.structure import CONTACT, CYLINDRICAL, FREER, MOBILITIES, PLANAR, SLIDING, TURNING, Joint, Structure

LOST = 1e-9  # of the largest: an independence so small is rounding, of places that scenes give with nine sound digits
MOST = 300_000  # choices of one number of changes that are looked at: of eleven moving links there are fewer
BATCH = 2048  # choices whose constraints are looked at together
Rows: TypeAlias = list[list[float]]


class Freedom(NamedTuple):
    """What the constraints of a mechanism leave and hold: mobility and redundant constraints in its plane and across.

    `passive` are links each of which may be left out; `local` are links that move in the plane though no other does,
    `spinning` those that move across it.
    """

    plane: int
    free: int
    within: int
    across: int
    passive: tuple[int, ...] = ()
    local: tuple[int, ...] = ()
    spinning: tuple[int, ...] = ()

    @property
    def mobility(self) -> int:
        """Mobility W, local ones among it."""
        return self.plane + self.free

    @property
    def redundant(self) -> int:
        """Number q of redundant constraints."""
        return self.within + self.across

    @property
    def main(self) -> int:
        """Mobility without local ones."""
        return self.plane - len(self.local)


def freedom(structure: Structure) -> Freedom:
    """Count the motions that a mechanism's constraints leave, and the constraints that depend on others."""
    plane, lift = matrix(structure, in_plane), matrix(structure, across)
    ranks, free = (_rank(plane), _rank(lift)), PLANAR * len(structure.links)
    twice = len(plane) - ranks[0]
    left = free - ranks[0], free - ranks[1]
    passive = tuple(_passive(structure, left[0])) if twice else ()
    spinning = _moving(structure, lift) if left[1] else ()
    return Freedom(*left, twice, len(lift) - ranks[1], passive, _local(structure, plane), spinning)


def in_plane(pair: Joint) -> Rows:
    """Give what a pair makes equal of the plane motions of its links: shifts of the origin, turn."""
    x, y = pair.at.real, pair.at.imag
    if pair.nature == TURNING:
        return [[1, 0, -y], [0, 1, x]]
    normal = pair.along if pair.nature == CONTACT else 1j * pair.along
    shift = [normal.real, normal.imag, normal.imag * x - normal.real * y]
    return [shift] if pair.nature == CONTACT else [shift, [0, 0, 1]]


# What is equal across the plane: lift, tilts along x and y, tilt along the pair's own direction or square to that.
ACROSS: Final[Mapping[str, str]] = {"R": "lxy", "P": "lxy", "S": "l", "T": "la", "L": "a", "E": "s", "K": "", "B": ""}
CYLINDERS: Final[Mapping[str, str]] = {TURNING: "xy", SLIDING: "la"}  # of a cylindrical pair by what it is in the plane


def across(pair: Joint) -> Rows:
    """Give what a pair makes equal of the motions across the plane: lift of the origin, tilts along x and y."""
    lift, tilts = [1.0, pair.at.real, pair.at.imag], {"x": 1 + 0j, "y": 1j, "a": pair.along, "s": 1j * pair.along}
    held = CYLINDERS[pair.nature] if pair.kind == CYLINDRICAL else ACROSS[pair.kind]
    return [lift if one == "l" else [0.0, tilts[one].real, tilts[one].imag] for one in held]


def matrix(structure: Structure, rows_of: Callable[[Joint], Rows]) -> Floats:
    """Put the constraints of all pairs in rows, three columns a link."""
    place = _placed(structure)
    rows = [_spread(row, pair, structure.links) for pair in place for row in rows_of(pair)]
    return np.array(rows or np.zeros((0, PLANAR * len(structure.links))))


def _placed(structure: Structure) -> list[Joint]:
    """Measure the places of pairs from their middle, in shares of how far they lie apart: no unit decides a rank."""
    pairs = structure.pairs
    middle = sum(pair.at for pair in pairs) / len(pairs)
    size = max((abs(pair.at - middle) for pair in pairs), default=0.0) or 1.0
    return [pair._replace(at=(pair.at - middle) / size) for pair in pairs]


def _spread(row: Sequence[float], pair: Joint, links: Sequence[int]) -> Floats:
    full = np.zeros(PLANAR * len(links))
    for link, sign in zip(pair.links, (-1, 1), strict=True):
        if link != FRAME:
            start = PLANAR * links.index(link)
            full[start : start + PLANAR] = sign * np.array(row)
    return full


def _rank(rows: Floats) -> int:
    return int(np.linalg.matrix_rank(rows, tol=LOST * np.abs(rows).max())) if rows.size else 0


def _passive(structure: Structure, mobility: int) -> Iterator[int]:
    """Find links that may be left out with their pairs: the others move as before, with fewer redundant constraints.

    None is a link that slides alone hold: it has no other to guide it.
    """
    turned = {link for joint in structure.joints if joint.nature != SLIDING for link in joint.links}
    for link in sorted(turned.intersection(structure.links)):
        rest = without(structure, link)
        plane = matrix(rest, in_plane)
        if PLANAR * len(rest.links) - _rank(plane) == mobility and len(plane) < len(matrix(structure, in_plane)) - 3:
            yield link


def without(structure: Structure, link: int) -> Structure:
    """Leave a link out, with the pairs that it has."""
    joints = (j._replace(links=tuple(one for one in j.links if one != link)) for j in structure.joints)
    return Structure(tuple(one for one in structure.links if one != link), tuple(j for j in joints if len(j.links) > 1))


def _local(structure: Structure, rows: Floats) -> tuple[int, ...]:
    """Find the links that move in the plane while all others rest: a roller on its pin."""
    columns = {link: rows[:, PLANAR * k : PLANAR * (k + 1)] for k, link in enumerate(structure.links)}
    others = [link for link in structure.links if link not in structure.primaries]
    return tuple(link for link in others if _rank(columns[link]) < PLANAR)


def _moving(structure: Structure, rows: Floats) -> tuple[int, ...]:
    """Find the links that move across the plane."""
    turns = np.linalg.svd(rows)[2][_rank(rows) :]
    sizes = np.abs(turns).max(axis=0).reshape(-1, PLANAR).max(axis=1)
    return tuple(link for link, size in zip(structure.links, sizes, strict=True) if size > LOST)


class Replacement(NamedTuple):
    """Other kinds of some pairs, by their links, with which no constraint across the plane is redundant."""

    kinds: tuple[tuple[str, str], ...]

    def of(self, kind: str) -> frozenset[str]:
        """Give the pairs that are made of a kind."""
        return frozenset(key for key, other in self.kinds if other == kind)


def replacements(structure: Structure) -> tuple[Replacement, ...]:
    """Find all ways of fewest changes to a mechanism without redundant constraints across its plane, the best first.

    The constraints that are left are as many as the motions across the plane, and independent: none of the freed pairs
    only adds a local mobility. Of more links than can be looked through there are none. Of equally many changes those
    are better that leave as they are hinges of several links, then the bearings of the frame, then guides.
    """
    found: list[Replacement] = []
    surplus = freedom(structure).across
    for count in range((surplus + 1) // 2, len(structure.pairs) + 1 if surplus else 0):
        if comb(len(structure.pairs), count) * comb(count, min(surplus - count, count // 2)) > MOST:
            break
        found = list(_sound(structure, _choices(structure, count, surplus)))
        if found:
            break
    joints = {pair.key: joint for joint in structure.joints for pair in joint.pairs}
    return tuple(sorted(found, key=lambda way: _worth(way, joints)))


def _worth(way: Replacement, joints: Mapping[str, Joint]) -> tuple[int, int, int, tuple[tuple[str, str], ...]]:
    changed = [joints[key] for key, _ in way.kinds]
    crowded, slides = sum(len(one.links) > 2 for one in changed), sum(one.nature == SLIDING for one in changed)
    return crowded, sum("0" in key.split("-") for key, _ in way.kinds), slides, way.kinds


def _choices(structure: Structure, count: int, surplus: int) -> Iterator[Replacement]:
    """Give the choices of so many pairs that free as many constraints as are redundant."""
    able = [pair for pair in structure.pairs if pair.kind in FREER]
    for pairs in combinations(able, count):
        for kinds in product(*(FREER[pair.kind] for pair in pairs)):
            freed = sum(MOBILITIES[kind] - pair.mobility for kind, pair in zip(kinds, pairs, strict=True))
            if freed == surplus:
                yield Replacement(tuple((pair.key, kind) for kind, pair in zip(kinds, pairs, strict=True)))


def _sound(structure: Structure, choices: Iterator[Replacement]) -> Iterator[Replacement]:
    """Keep the choices whose constraints are independent."""
    placed = _placed(structure)
    ways = ((pair, kind) for pair in placed for kind in pair.kind + FREER.get(pair.kind, ""))
    rows = {
        (pair.key, kind): np.array([_spread(row, pair, structure.links) for row in across(pair._replace(kind=kind))])
        for pair, kind in ways
    }
    while batch := list(islice(choices, BATCH)):
        kinds = [{pair.key: pair.kind for pair in placed} | dict(way.kinds) for way in batch]
        whole = np.array(
            [np.concatenate([rows[item] for item in chosen.items() if rows[item].size]) for chosen in kinds]
        )
        sizes = np.linalg.svd(whole, compute_uv=False)
        yield from (way for way, row in zip(batch, sizes, strict=True) if row[-1] > LOST * row[0])
