"""Groups by the analytic road: equations matched to unknowns (разложение Далмеджа-Мендельсона).

Each link has three unknowns, each hinge the two of its place; a link at a hinge makes two equations, a slide two, a
contact one. Where the primary links are known, every unknown is matched to an equation that finds it; unknowns that
depend on each other in a circle are found together: they are a structural group, whatever order it was sought in.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import combinations
from typing import TypeAlias, TypeVar

from plans.model.mechanism import FRAME
from plans.model.structure import SLIDING, TURNING, Joint, Structure, no_division

Unknown: TypeAlias = tuple[str, str]  # of a link by its number, or of a hinge by its letter: x, y, turn
Equation: TypeAlias = frozenset[Unknown]
One = TypeVar("One", int, tuple[str, str])  # of what needs others


def groups(structure: Structure, primaries: Sequence[int]) -> tuple[frozenset[int], ...]:
    """Give the links of each structural group, those that others rest on first."""
    known = {FRAME, *primaries}
    equations = [one for joint in structure.joints for one in _equations(joint, known)]
    unknowns = {one for equation in equations for one in equation}
    wanted = {(str(link), part) for link in structure.links if link not in known for part in "xyt"}
    matched = _matched(equations)
    if not wanted <= unknowns or len(matched) < len(unknowns) or len(equations) > len(unknowns):
        raise no_division(link for link in structure.links if link not in known)
    needs = {one: equations[row] - {one} for one, row in matched.items()}
    whole = {one: needs[one] | _together(one, unknowns) for one in unknowns}  # a body is placed as a whole
    found = (frozenset(int(name) for name, _ in part if name.isdigit()) for part in circles(whole))
    return tuple(links for links in found if links)


def _together(one: Unknown, unknowns: set[Unknown]) -> set[Unknown]:
    return {(one[0], part) for part in "xyt"} & unknowns - {one}


def _equations(joint: Joint, known: set[int]) -> Iterator[Equation]:
    """Give the equations of a joint, each with the unknowns in it."""
    if joint.nature == TURNING:
        fixed = not known.isdisjoint(joint.links)
        for link in (link for link in joint.links if link not in known):
            for part in "xy":
                place = set() if fixed else {(joint.name + "@", part)}
                yield frozenset({(str(link), part), (str(link), "t"), *place})
        return
    moving = [str(link) for link in joint.links if link not in known]
    if moving:
        yield frozenset((link, part) for link in moving for part in "xyt")
    if moving and joint.nature == SLIDING:
        yield frozenset((link, "t") for link in moving)


def _matched(equations: Sequence[Equation]) -> dict[Unknown, int]:
    """Match each equation to an unknown of its own, as many as can be (паросочетание по Куну)."""
    found: dict[Unknown, int] = {}

    def match(row: int, tried: set[Unknown]) -> bool:
        for one in sorted(equations[row] - tried):
            tried.add(one)
            if one not in found or match(found[one], tried):
                found[one] = row
                return True
        return False

    for row in range(len(equations)):
        match(row, set())
    return found


def circles(needs: Mapping[One, Set[One]]) -> list[list[One]]:
    """Give what is needed in a circle, what others need first (компоненты сильной связности по Тарьяну)."""
    number: dict[One, int] = {}
    low: dict[One, int] = {}
    stack: list[One] = []
    found: list[list[One]] = []

    def visit(one: One) -> None:
        number[one] = low[one] = len(number)
        stack.append(one)
        for other in sorted(needs[one]):
            if other not in number:
                visit(other)
            if other in stack:
                low[one] = min(low[one], low[other])
        if low[one] == number[one]:
            cut = stack.index(one)
            found.append(sorted(stack[cut:]))
            del stack[cut:]

    for one in sorted(needs):
        if one not in number:
            visit(one)
    return found


def rank_of(structure: Structure, links: frozenset[int]) -> int:
    """Give a group's class: the most inner pairs that are of one link, or that form one contour by themselves."""
    inner = [set(joint.links) & links for joint in structure.joints if len(set(joint.links) & links) > 1]
    rigid = [sum(link in ends for ends in inner) for link in links]
    sets = (frozenset(some) for count in range(4, len(links) + 1) for some in combinations(links, count))
    return max([2, *rigid, *(len(some) for some in sets if _ring(some, inner))])


def _ring(links: frozenset[int], joints: Sequence[set[int]]) -> bool:
    """Tell whether the pairs among some links join them to one closed contour: each to two others."""
    ends = [pair for joint in joints if len(pair := joint & links) > 1]
    if any(len(pair) > 2 for pair in ends) or any(sum(link in pair for pair in ends) != 2 for link in links):
        return False
    reached = {min(links)}
    while more := set().union(*(pair for pair in ends if pair & reached)) - reached:
        reached |= more
    return reached == links
