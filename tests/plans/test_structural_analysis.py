"""Structural analysis by both roads: mobility, groups, redundant constraints of handbooks and of chance (структура)."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from plans.analytic import grouping
from plans.analytic.structure import SpatialPair, in_place, perturbed, ranks
from plans.model.structure import (
    CONTACT,
    CYLINDRICAL,
    LINE,
    SLIDING,
    SPHERICAL,
    TURNING,
    CurvatureCentre,
    Joint,
    NoMechanism,
    Structure,
)
from plans.structure.constraints import freedom, replacements
from plans.structure.groups import divide, divisions
from tests.rows import over

CASES = tomllib.loads((Path(__file__).parents[1] / "cases" / "structures.toml").read_text("utf-8"))


class Printed(NamedTuple):
    """A mechanism of a handbook: its pairs, how their axes lie, W and q as printed, and where."""

    name: str
    pairs: str
    axes: str
    mobility: int
    redundant: int
    source: str


PRINTED = [Printed(name, *row) for name, row in CASES["mechanisms"].items()]
PLANAR = [row for row in PRINTED if row.axes == "plane"]


def spelt(pairs: str) -> list[tuple[str, bool, tuple[int, int]]]:
    """Read pairs: their kinds, whether a cylindrical one slides in the plane, and their links."""
    found = []
    for word in pairs.split():
        first, other = sorted(int(sign, 36) for sign in word[-2:])
        found.append((word[0], "*" in word, (first, other)))
    return found


def planar(pairs: str, seed: int = 1) -> Structure:
    """Put pairs at random places in a plane: their ranks are those of almost all mechanisms that they make."""
    chance = np.random.default_rng(seed)
    joints = []
    for kind, slides, links in spelt(pairs):
        at, along = complex(*chance.standard_normal(2)), np.exp(1j * chance.uniform(0, 6))
        nature = CONTACT if kind in (LINE, CONTACT) else SLIDING if kind == SLIDING or slides else TURNING
        joints.append(Joint(f"J {links[0]}-{links[1]}", links, nature, kind, at, complex(along)))
    if "L13" in pairs and "R23" in pairs and "R02" in pairs and len(joints) == 4:  # the normal goes through the roller
        roller, follower = joints[-1], joints[-2]
        joints[-1] = roller._replace(along=(follower.at - roller.at) / abs(follower.at - roller.at))
    return Structure(tuple(sorted({link for joint in joints for link in joint.links} - {0})), tuple(joints))


def spatial(row: Printed, seed: int = 2) -> list[SpatialPair]:
    """Put pairs in space as their axes lie."""
    chance = np.random.default_rng(seed)
    made = []
    for number, (kind, _, links) in enumerate(spelt(row.pairs)):
        at, axis, other = AXES[row.axes](number, chance)
        made.append(SpatialPair(links, kind, at, axis / np.linalg.norm(axis), other))
    return made


def regulus(number: int, chance: np.random.Generator) -> tuple[np.ndarray, ...]:
    """Give a generator of the hyperboloid x² + y² - z² = 1."""
    turn = 0.3 + 1.4 * number
    at = np.array([np.cos(turn), np.sin(turn), 0.0])
    return at, np.array([-np.sin(turn), np.cos(turn), 1.0]), chance.standard_normal(3)


AXES: Mapping[str, Callable[[int, np.random.Generator], tuple[np.ndarray, ...]]] = {
    "any": lambda number, chance: tuple(chance.standard_normal((3, 3))),
    "point": lambda number, chance: (np.zeros(3), *chance.standard_normal((2, 3))),
    "regulus": regulus,
    "sarrus": lambda number, chance: (chance.standard_normal(3), np.eye(3)[number // 3], chance.standard_normal(3)),
}


@over("row", PRINTED)
def test_mobility_and_redundant_constraints_are_those_of_the_handbooks(row: Printed) -> None:
    assert row.source in CASES["sources"] and len(PRINTED) > 40
    if row.axes == "plane":
        structure = planar(row.pairs)
        ours, theirs = freedom(structure), in_place(structure)
        assert (ours.mobility, ours.redundant) == (row.mobility, row.redundant)
        assert structure.spatial == row.mobility - row.redundant
    else:
        pairs = spatial(row)
        theirs = ranks(sorted({link for pair in pairs for link in pair.links} - {0}), pairs)
    assert (theirs.mobility, theirs.redundant) == (row.mobility, row.redundant)


@over("row", [row for row in PLANAR if row.redundant])
def test_each_replacement_leaves_no_constraint_redundant_and_adds_no_motion(row: Printed) -> None:
    structure = planar(row.pairs)
    found, within = freedom(structure), freedom(structure).within
    ways = replacements(structure)
    assert ways or "three cylindrical" in row.name or "wedge" in row.name
    assert len({len(way.kinds) for way in ways}) <= 1
    for way in ways:
        freed = structure.altered(dict(way.kinds))
        ours, place, space = freedom(freed), in_place(freed), perturbed(freed)
        assert (ours.mobility, ours.redundant) == (place.mobility, place.redundant) == (found.mobility, within)
        assert space.mobility - space.redundant == freed.spatial == found.mobility - within
        assert min(space.mobility, space.redundant) == 0


def test_the_four_bar_is_freed_by_a_spherical_and_a_cylindrical_pair_wherever_they_are() -> None:
    ways = replacements(planar("R01 R12 R23 R03"))
    pairs = ("0-1", "0-3", "1-2", "2-3")
    wanted = {(one, other) for one in pairs for other in pairs if one != other}
    assert {(*way.of(SPHERICAL), *way.of(CYLINDRICAL)) for way in ways} == wanted
    assert dict(ways[0].kinds) == {"1-2": CYLINDRICAL, "2-3": SPHERICAL}


def test_what_only_lets_a_link_spin_frees_nothing() -> None:
    """The crank's bearing and the rod's head lie on the guide: spherical there, they spin."""
    places = {"0-1": 0j, "1-2": 0.1 + 0.2j, "2-3": 0.6 + 0j, "0-3": 0.6 + 0j}
    whole = planar("R01 R12 R23 P03")
    joints = tuple(one._replace(at=places[one.pairs[0].key], along=1 + 0j) for one in whole.joints)
    ways = replacements(whole._replace(joints=joints))
    sliders = {next(iter(way.of(SPHERICAL))) for way in ways if "0-3" in way.of(CYLINDRICAL)}
    assert len(ways) == 7 and sliders == {"1-2"}
    spun = freedom(whole._replace(joints=joints).altered({"0-3": CYLINDRICAL, "2-3": SPHERICAL}))
    assert spun.spinning == (3,) and spun.redundant == 1


# M3.11: p pairs of n links, their W in the plane and in space.
@pytest.mark.parametrize(
    ("pairs", "plane", "space"),
    [
        ("R01 R12 P23 R03 R34 R45 P05", 1, -5),  # the six-link of figure 6.10
        ("R01 R12 R23 R03", 1, -2),
        ("R01 S12 C23 R03", 1, 1),
        ("R01 R02 L12", 1, 0),
        ("R01 R12 R02", 0, -3),  # groups: of two links, of four, of one with a contact
        ("R01 R02 R03 R14 R24 R34", 0, -6),
        ("R01 L01", 0, -1),
    ],
)
def test_the_formulas_of_structure(pairs: str, plane: int, space: int) -> None:
    structure = planar(pairs)
    assert (structure.planar, structure.spatial) == (plane, space)


# Groups by their links, 1 and on, and what they hang on, 0: pairs, class, order, kind of a dyad.
GROUPS = (
    ("R01 R12 R02", 2, 2, 1),
    ("R01 R12 P02", 2, 2, 2),
    ("R01 P12 R02", 2, 2, 3),
    ("P01 R12 P02", 2, 2, 4),
    ("R01 P12 P02", 2, 2, 5),
    ("R01 R02 R03 R14 R24 R34", 3, 3, 0),
    ("R01 P02 R03 R14 R24 P34", 3, 3, 0),
    ("R01 R12 R23 R34 R14 R03", 4, 2, 0),
    ("R01 R02 R13 R23 R34 R45 R46 R05 R06", 3, 4, 0),
    ("R01 R12 R23 R34 R45 R56 R16 R25 R04", 4, 2, 0),  # two contours of four links with a common pair
)


class Composed(NamedTuple):
    """A mechanism put together of a crank and groups, and what these are."""

    structure: Structure
    primary: int
    groups: Mapping[frozenset[int], tuple[int, int, int]]


def composed(chance: np.random.Generator) -> Composed:
    """Hang groups at random on each other, and number their links at random; some hinges are of several links."""
    chosen = [GROUPS[k] for k in chance.integers(len(GROUPS), size=chance.integers(1, 4))]
    names = [0, *(1 + chance.permutation(1 + sum(_size(pairs) for pairs, *_ in chosen))).tolist()]
    joints, known, count, groups = (
        [_joint(0, "R", (0, names[1]))],
        [0, names[1]],
        2,
        dict[frozenset[int], tuple[int, int, int]](),
    )
    for pairs, *kind in chosen:
        own = dict(enumerate(names[count : count + _size(pairs)], 1))
        for letter, _, (first, other) in spelt(pairs):
            host = own.get(first) or known[chance.integers(len(known))]
            shared = [k for k, joint in enumerate(joints) if joint.nature == TURNING and host in joint.links]
            if not first and letter == "R" and shared and chance.random() < 0.3:
                at = shared[chance.integers(len(shared))]
                if not {*own.values()} & {*joints[at].links}:  # two links of one group on one pin would be a truss
                    joints[at] = joints[at]._replace(links=(*joints[at].links, own[other]))
                    continue
            joints.append(_joint(len(joints), letter, (host, own[other])))
        groups[frozenset(own.values())] = (kind[0], kind[1], kind[2])
        count, known = count + len(own), [*known, *own.values()]
    return Composed(Structure(tuple(sorted(names[1:])), tuple(joints)), names[1], groups)


def _size(pairs: str) -> int:
    return max(max(links) for _, _, links in spelt(pairs))


def _joint(number: int, letter: str, links: tuple[int, int]) -> Joint:
    return Joint(f"J{number}", tuple(sorted(links)), letter, letter)


@over("seed", range(150))
def test_groups_that_are_put_together_come_apart_again(seed: int) -> None:
    made = composed(np.random.default_rng(seed))
    division = divide(made.structure, [made.primary])
    assert made.structure.planar == 1
    assert {frozenset(one.links): (one.rank, one.order, one.number) for one in division.groups} == made.groups
    assert {*grouping.groups(made.structure, [made.primary])} == {*made.groups}
    for links, (rank, _, _) in made.groups.items():
        assert grouping.rank_of(made.structure, links) == rank


def test_the_class_depends_on_the_primary_link() -> None:
    triad = planar("R01 R12 R23 R34 R04 R35 R05")
    found = divisions(triad, 1, triad.primaries)
    assert [(one.name, one.rank) for one in found] == [("I(0,1)", 3), ("I(0,4)", 2), ("I(0,5)", 2)]


def test_slides_alone_are_no_group() -> None:
    wedge = planar("R01 P12 P23 P13 R04 R41 R34")
    for divided in (lambda: divide(wedge, [1]), lambda: grouping.groups(wedge, [1])):
        with pytest.raises(NoMechanism, match="no structural groups"):
            divided()


def test_a_third_rocker_of_a_parallelogram_is_passive() -> None:
    feet: Sequence[complex] = (0j, 1 + 0j, 0.4 + 0.1j)
    joints = [_placed("O", (0, 1), feet[0]), _placed("C", (0, 3), feet[1]), _placed("E", (0, 4), feet[2])]
    joints += [_placed(name, (2, k), foot + 0.3 + 0.5j) for name, k, foot in zip("ABD", (1, 3, 4), feet, strict=True)]
    structure = Structure((1, 2, 3, 4), tuple(joints))
    found = freedom(structure)
    assert (structure.planar, found.mobility, found.within, found.redundant) == (0, 1, 1, 7)
    assert found.passive == (1, 3, 4)
    assert (in_place(structure).mobility, in_place(structure).redundant) == (1, 7)


def _placed(name: str, links: tuple[int, int], at: complex) -> Joint:
    return Joint(name, tuple(sorted(links)), TURNING, TURNING, at)


def test_three_satellites_hold_in_their_plane_twice_too_much() -> None:
    """Sun 1, carrier 2, satellites 3, 4, 5 about it, wheel 0: W = 3·5 - 2·5 - 6 = -1, and yet it turns (Reshetov)."""
    sun, satellite = 0.3, 0.2
    joints = [_placed("O", (0, 1), 0j), _placed("H", (0, 2), 0j)]
    for k in (3, 4, 5):
        way = complex(np.exp(2j * np.pi * k / 3))
        joints.append(_placed(f"S{k}", (2, k), (sun + satellite) * way))
        flanks = ((1, sun, 1), (0, sun + 2 * satellite, -1))
        joints += [
            Joint(f"K{k}{host}", tuple(sorted((host, k))), CONTACT, LINE, far * way, side * 1j * way * np.exp(0.35j))
            for host, far, side in flanks
        ]
    structure = Structure((1, 2, 3, 4, 5), tuple(joints))
    found, theirs = freedom(structure), in_place(structure)
    assert (structure.planar, found.mobility, found.within, found.redundant) == (-1, 1, 2, 8)
    assert (theirs.mobility, theirs.redundant) == (1, 8)


def test_a_contact_is_replaced_by_a_link_or_at_a_flat_side_by_a_stone() -> None:
    bearings = Joint("O", (0, 1), TURNING, TURNING), Joint("C", (0, 2), TURNING, TURNING, 1 + 0j)
    centres = CurvatureCentre("A", 1, 0.1j), CurvatureCentre("B", 2, 0.9j)
    for kept, formula in ((2, "I(0,1) -> II1(2,3)"), (1, "I(0,1) -> II3(2,3)")):
        cam = Joint("K 1-2", (1, 2), CONTACT, LINE, 0.5j, 1j, centres[:kept])
        lowered = Structure((1, 2), (*bearings, cam)).lowered()
        assert lowered.planar == 1 and divide(lowered, [1]).formula == formula
