"""The equations in blocks: which links they give together, and in what order (блочно-треугольная форма).

Nothing is known here of structural groups: every equation is given to one of the links it moves, three to each link; a
link rests on those whose poses its equations use; links that rest on each other are one block (A. L. Dulmage, N. S.
Mendelsohn, Coverings of bipartite graphs, 1958; the blocks are strong components after R. Tarjan, 1972).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from plans.analytic.points import Constraints, Indices
from plans.model.mechanism import StructureError
from plans.model.motion import Floats
from plans.words.words import message

FREEDOM = 3  # unknowns of a link


class Block(NamedTuple):
    """Links whose poses are found together: their own equations, and where these stand among all equations."""

    equations: Constraints
    rows: Indices  # places of the equations among those of the whole mechanism
    columns: Indices  # places of the unknowns in the Jacobian of the whole mechanism

    @property
    def links(self) -> Indices:
        """Places of the links."""
        return self.equations.sought

    def of(self, jacobian: Floats) -> Floats:
        """Cut the block's own Jacobian out of that of the whole mechanism, (N, k, k)."""
        return np.asarray(jacobian[:, self.rows[:, None], self.columns])

    @property
    def linear(self) -> bool:
        """Whether slides give all its links their directions: then it can be assembled in one way only."""
        return len(self.equations.slide_ways[0]) == len(self.links)

    def of_own(self, poses: Floats) -> Floats:
        """Differentiate the block's own equations at poses (links, 3), (k, k)."""
        return np.asarray(self.equations.jacobian(self.equations.place(poses[None]))[0])


def triangular(constraints: Constraints) -> tuple[Block, ...]:
    """Break the equations of a mechanism into blocks in solving order.

    Raises StructureError where some links have more equations than unknowns.
    """
    keepers = _keepers(constraints)
    rests: dict[int, set[int]] = {place: set() for place in range(1, len(constraints.numbers))}
    for (_, links), keeper in zip(_equations(constraints), keepers, strict=True):
        rests[keeper] |= set(links) - {0, keeper}
    return tuple(_block(constraints, links, keepers) for links in _components(rests))


def _equations(constraints: Constraints) -> list[tuple[int, tuple[int, ...]]]:
    """List all equations in the order of rows: their joint (the drive counts as one more) and the links they move."""
    joints = [(int(a), int(b)) for a, b in constraints.links.T]
    hinged, slid = joints[: constraints.hinges], joints[constraints.hinges :]
    rows = [*enumerate(hinged)] * 2 + [*enumerate(slid, constraints.hinges)] * 2
    return [*rows, (len(joints), constraints.drive.moved)]


def _keepers(constraints: Constraints) -> list[int]:
    """Give every equation to a link, three to each, by augmenting paths."""
    links = [[place for place in moved if place] for _, moved in _equations(constraints)]
    kept: dict[int, list[int]] = {place: [] for place in range(1, len(constraints.numbers))}

    def give(row: int, seen: set[int]) -> bool:
        for place in links[row]:
            if place in seen:
                continue
            seen.add(place)
            if len(kept[place]) < FREEDOM:
                kept[place].append(row)
                return True
            for other in kept[place]:
                if give(other, seen):
                    kept[place][kept[place].index(other)] = row
                    return True
        return False

    for row in range(len(links)):
        if not give(row, set()):
            raise StructureError(message("structure.truss"))
    keepers = {row: place for place, rows in kept.items() for row in rows}
    return [keepers[row] for row in range(len(links))]


def _components(rests: dict[int, set[int]]) -> list[list[int]]:
    """Give the strong components of what rests on what, each after all that it rests on."""
    order: dict[int, int] = {}
    low: dict[int, int] = {}
    stack: list[int] = []
    found: list[list[int]] = []

    def visit(place: int) -> None:
        order[place] = low[place] = len(order)
        stack.append(place)
        for other in sorted(rests[place]):
            if other not in order:
                visit(other)
            if other in stack:
                low[place] = min(low[place], low[other])
        if low[place] == order[place]:
            cut = stack.index(place)
            found.append(sorted(stack[cut:]))
            del stack[cut:]

    for place in rests:
        if place not in order:
            visit(place)
    return found


def _block(constraints: Constraints, links: list[int], keepers: list[int]) -> Block:
    joints = constraints.links.shape[1]
    rows = [row for row, keeper in enumerate(keepers) if keeper in links]
    own = {joint for row, (joint, _) in enumerate(_equations(constraints)) if keepers[row] in links}
    equations = constraints.part(links, sorted(own - {joints}), joints in own)
    return Block(equations, np.array(rows, dtype=np.intp), equations.columns - FREEDOM)
