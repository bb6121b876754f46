"""GroupDivision into structural groups: for each primary link, from the fewest links on (деление на группы Ассура)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import combinations

from plans.model.dyad import NUMBERS
from plans.model.mechanism import FRAME
from plans.model.structure import CONTACT, PLANAR, SLIDING, AssurGroup, GroupDivision, Joint, Structure, no_division


def divisions(structure: Structure, mobility: int, among: Collection[int]) -> tuple[GroupDivision, ...]:
    """Divide a mechanism for every choice of its primary links among some."""
    able = (link for link in structure.primaries if link in among)
    return tuple(divide(structure, chosen) for chosen in combinations(able, mobility))


def divide(structure: Structure, primaries: Sequence[int]) -> GroupDivision:
    """Divide a mechanism from its primary links on: of the groups that can be attached always the smallest first."""
    known, left, groups = [FRAME, *primaries], [n for n in structure.links if n not in primaries], list[AssurGroup]()
    while left:
        links = next(_groups(structure, known, left), ())
        if not links:
            raise no_division(left)
        groups.append(_group(structure, known, links))
        known += links
        left = [link for link in left if link not in links]
    return GroupDivision(tuple(primaries), tuple(groups))


def _groups(structure: Structure, known: Collection[int], left: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """Find sets of links that known ones hold without mobility, the smallest first."""
    sizes = (count for count in range(1, len(left) + 1))
    chosen = (links for count in sizes for links in combinations(left, count))
    return (links for links in chosen if _held(structure, known, links))


def _held(structure: Structure, known: Collection[int], links: tuple[int, ...]) -> bool:
    """Tell whether some links have W = 3n - 2 p_1 - p_2 = 0 on known ones; links that are held twice are refused."""
    taken = sum((1 if joint.nature == CONTACT else 2) * joint.within(links, known) for joint in structure.joints)
    slides = [joint for joint in structure.joints if joint.nature == SLIDING and joint.within(links, known)]
    if taken > PLANAR * len(links) or _turned_twice(slides, known):
        raise no_division(links)
    return taken == PLANAR * len(links)


def _turned_twice(slides: Sequence[Joint], known: Collection[int]) -> bool:
    """Tell whether slides alone form a closed contour, which holds the turning of its links twice."""
    turning = dict.fromkeys(known, FRAME)  # each link with the least of those that turn as it does
    for slide in slides:
        first, other = (turning.setdefault(link, link) for link in slide.links)
        if first == other:
            return True
        turning = {link: first if one == other else one for link, one in turning.items()}
    return False


def _group(structure: Structure, known: Collection[int], links: tuple[int, ...]) -> AssurGroup:
    joints = tuple(joint for joint in structure.joints if joint.within(links, known))
    outer = [joint for joint in joints if not set(joint.links).isdisjoint(known)]
    inner = [joint for joint in joints if len(set(joint.links).intersection(links)) > 1]
    number = _number(links, outer, inner) if len(links) == 2 else 0
    return AssurGroup(links, joints, _rank(links, inner), len(outer), number)


def _number(links: tuple[int, ...], outer: Sequence[Joint], inner: Sequence[Joint]) -> int:
    """Number a two-lead group by its pairs, outer, inner, outer, as the textbook's figure 6.12 does."""
    ends = sorted(joint.nature for joint in outer)
    first, last = reversed(ends)
    return NUMBERS[f"{first}{inner[0].nature}{last}"]


def _rank(links: tuple[int, ...], inner: Sequence[Joint]) -> int:
    """Give a group's class: how many inner pairs its most complex contour has, a rigid link or a movable chain."""
    own = {link: [joint for joint in inner if link in joint.links] for link in links}
    beside = {link: {one for joint in own[link] for one in joint.links if one in own and one != link} for link in links}
    return max([2, *map(len, own.values()), *_contours(beside)])


def _contours(beside: Mapping[int, set[int]]) -> Iterator[int]:
    """Give how many links each closed chain has that no pair within it cuts short; of three it would be rigid."""
    waiting: list[tuple[int, ...]] = [(link,) for link in beside]
    while waiting:
        path = waiting.pop()
        for step in beside[path[-1]] - {*path}:
            met = [link for link in path[:-1] if link in beside[step]]
            if met == [path[0]] and len(path) > 2:
                yield len(path) + 1
            elif not met:
                waiting.append((*path, step))


def lowest(found: Sequence[GroupDivision]) -> GroupDivision:
    """Give the division of the lowest class, of several the first."""
    return min(found, key=lambda division: division.rank)
