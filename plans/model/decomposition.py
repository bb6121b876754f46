"""Decomposition: a mechanism broken into its structural groups in solving order (группы Ассура, 6.4.4)."""

from __future__ import annotations

from plans.model.dyad import Assur, dyads, mechanism_class
from plans.model.mechanism import FRAME, Mechanism, StructureError
from plans.model.triad import triads
from plans.words.words import Message, message

SEARCHES = (dyads, triads)  # for groups that hang on solved links, those of the fewest links first


def decompose(mechanism: Mechanism) -> tuple[Assur, ...]:
    """Break a mechanism into groups in the order of their attachment, whatever the order of the scene's tables.

    Raises StructureError where links are left that form no group.
    """
    groups, left = _groups_from(mechanism, mechanism.drive.link)
    if left:
        raise StructureError(_no_group(mechanism, left), tuple(left))
    return groups


def _groups_from(mechanism: Mechanism, primary: int) -> tuple[tuple[Assur, ...], list[int]]:
    """Give the groups that hang on a primary link and on each other, and the links that form none."""
    solved, groups = {FRAME, primary}, list[Assur]()
    while left := sorted(set(mechanism.links) - solved):
        group = next((group for search in SEARCHES for group in search(mechanism, solved, left)), None)
        if group is None:
            break
        groups.append(group)
        solved.update(group.links)
    return tuple(groups), left


def _no_group(mechanism: Mechanism, left: list[int]) -> Message:
    names = ", ".join(str(link) for link in left)
    pairs = sum(len([o for o in owners if o in left]) for owners in mechanism.hinges.values())
    if len(left) < 4 or not pairs:
        return message("structure.leads", links=names)
    for link in sorted({link for owners in mechanism.hinges.values() if FRAME in owners for link in owners} - {FRAME}):
        groups, beside = _groups_from(mechanism, link)
        if not beside:
            return message("structure.higher_driven", links=names, link=link, rank=mechanism_class(groups))
    return message("structure.higher", links=names)
