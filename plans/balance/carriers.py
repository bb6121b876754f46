"""The links that may carry a counterweight (звенья с противовесами), by the structure of the mechanism alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plans.model.balance.linkage import FULL
from plans.model.dyad import Dyad
from plans.model.group import Group
from plans.model.mechanism import FRAME, Mechanism, StructureError
from plans.model.structure import decompose
from plans.words.words import Message, message


def carriers(mechanism: Mechanism, aim: str) -> list[int]:
    """Give the links that would do for an aim: the crank, and one of each group that needs one."""
    return [mechanism.drive.link, *(link for group in _groups(mechanism) or () for link in _of_group(group, aim))]


def reciprocating(mechanism: Mechanism) -> bool:
    """Tell whether a slider on the frame has its rod on the crank, so that the crank can balance a share of it.

    Of links that form no groups nothing is told against it: what studies the linkage says so.
    """
    groups, hosts = _groups(mechanism), (mechanism.drive.link, FRAME)
    return groups is None or any(isinstance(one, Dyad) and (one.kind, one.hosts) == ("RRP", hosts) for one in groups)


def guided(mechanism: Mechanism) -> bool:
    """Tell whether a link slides on the frame: its mass is what a partial balancing leaves."""
    return any(slide.owner == FRAME for slide in mechanism.slides)


def told(links: Sequence[int]) -> Message:
    """Say which links would do; of a mechanism that is not known yet, which of any."""
    written = tuple(f"on = {link}" for link in links)
    return message("advice.carriers", links=written) if links else message("advice.any_carriers")


def _groups(mechanism: Mechanism) -> tuple[Group, ...] | None:
    """Give the groups; None of links that form none."""
    try:
        return decompose(mechanism) if mechanism.mobility == 1 else None
    except StructureError:
        return None


def _of_group(group: Group, aim: str) -> Iterator[int]:
    """Give the link of a group that would do: of two that could the one hinged to the frame."""
    if group.kind in ("RRR", "RPR"):
        ends = [pair.taker for pair in group.outer_pairs if pair.giver == FRAME]
        yield (ends or [group.links[-1 if group.kind == "RPR" else 0]])[0]
    elif group.kind == "RRP" and (aim == FULL or group.outer_pairs[1].giver != FRAME):
        yield group.links[0]
