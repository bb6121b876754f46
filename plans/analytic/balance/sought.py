"""What is sought of a balance: the links whose counterweights are unknown, and the points that may keep a mass."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from plans.model.balance.linkage import FULL, PARTIAL, Counterweight, Place, Task
from plans.model.group import Group, Pair
from plans.model.mechanism import FRAME, Mechanism


class Sought(NamedTuple):
    """Counterweights without static moments, in the scene's order; the links that need one; points that keep a mass."""

    blanks: tuple[Counterweight, ...]
    links: frozenset[int]
    left: tuple[str, ...]


def sought(mechanism: Mechanism, groups: Sequence[Group], task: Task) -> Sought:
    """Tell what a task seeks: one counterweight of the crank and of each group, or the mass at a guide of the frame."""
    drive = mechanism.drive
    links, left = {drive.link} if task.place(drive.link) else set(), []
    rod = _rod(mechanism, groups, task)
    for group in groups:
        carrier = _carrier(group, task)
        if rod is not None and carrier != rod and _on_crank(mechanism, group):
            carrier = None  # one rod is enough
        if carrier is not None:
            links.add(carrier)
        if task.aim != FULL and (carrier is None or carrier == rod):
            left += _left(mechanism, group)
    blanks = tuple(_blank(mechanism, groups, place) for place in task.places)
    return Sought(blanks, frozenset(links), tuple(left))


def _rod(mechanism: Mechanism, groups: Sequence[Group], task: Task) -> int | None:
    """Give the first rod on the crank that may carry where the crank may not: it balances the crank in part."""
    if task.aim != PARTIAL or task.place(mechanism.drive.link):
        return None
    rods = (group.links[0] for group in groups if _on_crank(mechanism, group))
    return next((link for link in rods if task.place(link)), None)


def _on_crank(mechanism: Mechanism, group: Group) -> bool:
    """Tell whether a group is a rod on the crank with its slider on the frame."""
    return group.kind == "RRP" and [pair.giver for pair in group.outer_pairs] == [mechanism.drive.link, FRAME]


def _carrier(group: Group, task: Task) -> int | None:
    """Choose the link of a group that carries: of two that may the one hinged to the frame, else the first."""
    hinged = [pair for pair in group.outer_pairs if isinstance(pair.joint, str) and task.place(pair.taker)]
    if group.kind == "RPP" or not hinged:  # all of that group slides: nothing on it turns
        return None
    return next((pair for pair in hinged if pair.giver == FRAME), hinged[0]).taker


def _left(mechanism: Mechanism, group: Group) -> list[str]:
    """Give the point of a group that goes along a guide of the frame with the mass that is left."""
    guided = [pair for pair in group.outer_pairs if not isinstance(pair.joint, str) and pair.giver == FRAME]
    (inner,) = (pair.joint for pair in group.inner_pairs)
    if not guided:
        return []
    return [inner if isinstance(inner, str) else _point(mechanism, guided[0])]


def _point(mechanism: Mechanism, pair: Pair) -> str:
    """Give a point of a guided link: the one that slides, or of a link that bears its guide the first."""
    on = mechanism.links[pair.taker].points
    return pair.point if pair.point in on else next(iter(on))


def _blank(mechanism: Mechanism, groups: Sequence[Group], place: Place) -> Counterweight:
    """Give a counterweight that has yet to be found, counted from the hinge of its link toward the frame."""
    begin = mechanism.drive.pivot
    if place.link != mechanism.drive.link:
        ends = {pair.taker: pair.joint for group in groups for pair in group.outer_pairs}
        joint = ends[place.link]
        if not isinstance(joint, str):
            raise ValueError(place)  # a link that is guided and not hinged is refused before
        begin = joint
    return Counterweight(place, begin, mechanism.links[place.link].points[begin], 0j, 0.0)
