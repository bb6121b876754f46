"""Decomposition: a mechanism broken into its structural groups in solving order (группы Ассура, 6.4.4)."""

from __future__ import annotations

from plans.model.dyad import Assur, dyads
from plans.model.mechanism import FRAME, Mechanism, StructureError
from plans.model.triad import triads
from plans.words.words import Message, message

SEARCHES = (dyads, triads)  # for groups that hang on solved links, those of the fewest links first


def decompose(mechanism: Mechanism) -> tuple[Assur, ...]:
    """Break a mechanism into groups in the order of their attachment, whatever the order of the scene's tables.

    Raises StructureError where links are left that form no group.
    """
    solved = {FRAME, mechanism.drive.link}
    groups: list[Assur] = []
    while left := sorted(set(mechanism.links) - solved):
        group = next((group for search in SEARCHES for group in search(mechanism, solved, left)), None)
        if group is None:
            raise StructureError(_no_group(mechanism, left), tuple(left))
        groups.append(group)
        solved.update(group.links)
    return tuple(groups)


def _no_group(mechanism: Mechanism, left: list[int]) -> Message:
    names = ", ".join(str(link) for link in left)
    pairs = sum(len([o for o in owners if o in left]) for owners in mechanism.hinges.values())
    return message("structure.higher" if len(left) >= 4 and pairs else "structure.leads", links=names)
