"""A structure by both roads: formulas and search of groups against ranks of Jacobians and matching (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plans.analytic import grouping
from plans.analytic.structure import Ranks, in_place, perturbed
from plans.model.motion import Gap
from plans.model.structure import GroupDivision, Structure
from plans.quantity import Comparison, Quantity
from plans.structure.study import STRUCTURE, StructureStudy

UNLIKE = -1.0  # the class of a division whose groups the other road finds otherwise


class StructureRoad(NamedTuple):
    """What a road found; a structure has no gaps."""

    by: str
    unanswered: tuple[Gap, ...] = ()


def compare_structure(study: StructureStudy) -> Comparison:
    """Find mobility, redundant constraints and classes by both roads."""
    found = (*_mobilities(study), *_classes(study), *_freed(study))
    return Comparison(StructureRoad("construction"), StructureRoad("analysis"), found)


def _mobilities(study: StructureStudy) -> Iterator[Quantity]:
    """Compare the mobility that is left, that of the formula for space, and what they differ by."""
    structure, freedom = study.structure, study.freedom
    true = in_place(structure)
    yield _quantity("W", freedom.mobility, true.mobility)
    yield _quantity("W_s", structure.spatial, _freely(structure))
    yield _quantity("q", freedom.redundant, true.redundant)


def _classes(study: StructureStudy) -> Iterator[Quantity]:
    """Compare the class of each division."""
    for division in study.divisions:
        yield _quantity(division.letters, division.rank, _class(study.plain, division))


def _class(structure: Structure, division: GroupDivision) -> float:
    groups = grouping.groups(structure, division.primaries)
    if {frozenset(group.links) for group in division.groups} != {*groups}:
        return UNLIKE
    return max((grouping.rank_of(structure, links) for links in groups), default=1)


def _freed(study: StructureStudy) -> Iterator[Quantity]:
    """Compare the mechanism freed, and how many of the ways to it the analysis takes for one."""
    if not study.replacements:
        return
    freed = study.freed
    true, space = in_place(freed), _freely(freed)
    yield _quantity("W'", study.freedom.mobility, true.mobility)
    yield _quantity("W'_s", freed.spatial, space)
    yield _quantity("q'", study.freedom.within, true.redundant)
    ways = (study.structure.altered(dict(way.kinds)) for way in study.replacements)
    yield _quantity("N", len(study.replacements), sum(_sound(way, study.freedom.within) for way in ways))


def _sound(structure: Structure, within: int) -> bool:
    """Tell whether no constraint across the plane is redundant in place, and none at all where nothing is parallel."""
    place, space = in_place(structure), perturbed(structure)
    return place.redundant == within and min(space.mobility, space.redundant) == 0


def _freely(structure: Structure) -> float:
    """Give the mobility where nothing is exactly parallel: motions that are left, less constraints that hold twice."""
    found: Ranks = perturbed(structure)
    return found.mobility - found.redundant


def _quantity(name: str, ours: float, theirs: float) -> Quantity:
    return Quantity.of((STRUCTURE, name, ""), (float(ours), float(theirs)), 0.0)
