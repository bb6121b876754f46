"""The self-check of what stands beside the curves of shares: the share taken, the reaction without counterweights."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance import share_graph
from drawings.lettering.balance_letters import FORCE
from drawings.lettering.indices import with_index
from drawings.paper.strokes import Group, Leaf, Line, Text
from drawings.paper.walk import group_named
from plans.forces.cut import indices
from plans.model.balance.linkage import FORCE as LEAST_FORCE
from plans.model.mechanism import FRAME

NAME = f"{share_graph.NAME}-{share_graph.BARE}"


def level(leaf: Leaf, part: Group, expected: Expected, zero: complex, scales: tuple[float, float]) -> Iterator[Wrong]:
    """Hold the level line from share 0 to share 1, and its letter over the middle."""
    across, up = scales
    start = zero + 1j * bare(expected) / up
    end, near = start + 1 / across, 2 * expected.near + KNOWN * bare(expected) / up
    lines = marks.lines(group_named(leaf.groups, NAME))
    if len(lines) != 1 or abs(lines[0][0] - start) > near or abs(lines[0][-1] - end) > near + KNOWN / across:
        yield on("line", share_graph.NAME)
    letter = curve_letter(expected, share_graph.REACTIONS)
    text = Text(0j, expected.drafting.word("bare level", letter=letter)).plain
    if distance(labels_of((part,)).get(text, ()), [(start + end) / 2]) > NEAREST:
        yield on("letter", share_graph.NAME, name=text)


def curve_letter(expected: Expected, kind: str) -> str:
    """Letter a curve: the largest shaking force, or the largest reaction of the crank's shaft."""
    if kind == share_graph.FORCES:
        return f"{FORCE}_{{max}}"
    by, pair = expected.drafting, indices(FRAME, expected.mechanism.drive.link)
    return f"{by.letter(with_index(f'{by.reactions}_{pair}'))} _{{max}}"


def bare(expected: Expected) -> float:
    """Give the largest reaction of the crank's shaft before balancing, N."""
    before, pair = expected.balance.before, (FRAME, expected.mechanism.drive.link)
    return next(before.reactions[key] for key, one in before.forces.reactions.items() if (one.giver, one.taker) == pair)


def taken(leaf: Leaf, expected: Expected, zero: complex, across: float) -> Iterator[Wrong]:
    """Hold the line of the share that is taken."""
    name, task, found = share_graph.NAME, expected.balance.task, expected.balance.shares
    assert found is not None  # asked before
    best = found.least_force if task.least == LEAST_FORCE else found.least_reaction
    share = best.share if task.share is None else task.share
    part = group_named(leaf.groups, f"{name}-{share_graph.TAKEN}")
    lines = [one for one in (part.strokes if part is not None else ()) if isinstance(one, Line)]
    spot = zero.real + share / across
    if not lines or any(abs(end.real - spot) > 2 * expected.near for one in lines for end in (one.start, one.end)):
        yield on("line", name)
