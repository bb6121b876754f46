"""Structure: a mechanism broken into its crank and Assur groups, in solving order (структурный анализ; 6.4.4)."""

from __future__ import annotations

from collections.abc import Sequence

from plans.model.dyad import dyads
from plans.model.group import Group
from plans.model.mechanism import FRAME, Mechanism, StructureError
from plans.words.words import Message, message

CLASSES = ("I", "II", "III", "IV")  # of groups and mechanisms, the simplest first
SEARCHES = (dyads,)  # for groups that hang on solved links, those of the fewest links first


def decompose(mechanism: Mechanism) -> tuple[Group, ...]:
    """Break a mechanism into groups in the order of their attachment, whatever the order of the scene's tables.

    Raises StructureError where links are left that form no group.
    """
    solved = {FRAME, mechanism.drive.link}
    groups: list[Group] = []
    while left := sorted(set(mechanism.links) - solved):
        group = next((group for search in SEARCHES for group in search(mechanism, solved, left)), None)
        if group is None:
            raise StructureError(_no_group(mechanism, left), tuple(left))
        groups.append(group)
        solved.update(group.links)
    return tuple(groups)


def formula(mechanism: Mechanism, groups: Sequence[Group]) -> str:
    """Write the formula of structure (формула строения), such as I(0,1) -> II3(2,3) -> II2(4,5)."""
    return " -> ".join([f"I(0,{mechanism.drive.link})", *(group.label for group in groups)])


def mechanism_class(groups: Sequence[Group]) -> str:
    """Give the class of the mechanism: the highest class of its groups (класс механизма)."""
    return max([CLASSES[0], *(group.order for group in groups)], key=CLASSES.index)


def _no_group(mechanism: Mechanism, left: list[int]) -> Message:
    names = ", ".join(str(link) for link in left)
    pairs = sum(len([o for o in owners if o in left]) for owners in mechanism.hinges.values())
    return message("structure.triad" if len(left) >= 4 and pairs else "structure.leads", links=names)
