"""How the units of a sheet stand in their cells: spare paper is shared, headings are level (размещение)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.layout.slicing import GAP, SAME, Cut, Piece, Size, Tree, pieces
from drawings.page.page import Field
from drawings.paper.walk import MARGIN, PLACES, tied
from plans.model.motion import Floats

CELLS = 72  # across the longer side of a sheet

Edges: TypeAlias = Sequence[int]
Inked: TypeAlias = npt.NDArray[np.bool_]


class Area(NamedTuple):
    """Cells of a grid: the first, and the first that is beyond, of its columns and of its rows from below."""

    left: int
    bottom: int
    right: int
    top: int

    def meets(self, other: Area) -> bool:
        """Tell whether a cell is in both."""
        across = self.left < other.right and other.left < self.right
        return across and self.bottom < other.top and other.bottom < self.top

    @property
    def size(self) -> int:
        """How many cells it has."""
        return (self.right - self.left) * (self.top - self.bottom)


class Grid:
    """The cells of a field."""

    def __init__(self, field: Field) -> None:
        self.field = field

    @cached_property
    def cell(self) -> float:
        """The side of a cell, mm."""
        return max(self.field.width, self.field.height) / CELLS

    @cached_property
    def whole(self) -> Area:
        """All its cells."""
        high, wide = (max(round(side / self.cell), 1) for side in (self.field.height, self.field.width))
        return Area(0, 0, wide, high)

    def cells(self, boxes: Floats) -> npt.NDArray[np.intp]:
        """Give the cells that boxes (..., 4) mm cover."""
        low = np.array([self.field.left, self.field.bottom] * 2)
        ends = ((boxes - low) / self.cell).round(PLACES).round().astype(int)
        return np.asarray(np.clip(ends, 0, np.array(self.whole[2:] * 2)))

    def area(self, box: Field) -> Area:
        """Give the cells that a box covers."""
        (left, low, *_), cell, (_, _, wide, high) = self.field, self.cell, self.whole
        first, beyond = (min(max(round(tied((side - left) / cell)), 0), wide) for side in (box.left, box.right))
        lowest, above = (min(max(round(tied((side - low) / cell)), 0), high) for side in (box.bottom, box.top))
        return Area(first, lowest, beyond, above)

    def barest(self, areas: Sequence[Area]) -> Area:
        """Give the largest rectangle that none of some areas covers."""
        return _largest((self.whole, *areas))

    def share(self, area: Area) -> float:
        """Give what share of all cells an area takes."""
        return area.size / self.whole.size


def bareness(boxes: Iterable[Field], field: Field) -> float:
    """Give the largest rectangle of a field that no box covers, as a share of the field.

    >>> round(bareness([Field(0.0, 0.0, 50.0, 100.0)], Field(0.0, 0.0, 100.0, 100.0)), 2)
    0.5
    """
    grid = Grid(field)
    return grid.share(grid.barest([grid.area(box) for box in boxes]))


def barest(inked: Inked) -> Area:
    """Find the largest bare rectangle of a grid, of which it is known, row by row from below, what cells are inked.

    >>> barest(np.array([[False, False, True], [False, False, False]]))
    Area(left=0, bottom=0, right=2, top=2)
    """
    high, wide = inked.shape
    return _rectangle(inked, range(wide + 1), range(high + 1))


def _largest(areas: Sequence[Area]) -> Area:
    """Find the largest bare rectangle of a grid, of which areas behind the first, the whole, are taken."""
    ys = sorted({edge for area in areas for edge in (area.bottom, area.top)})
    xs = sorted({edge for area in areas for edge in (area.left, area.right)})
    row, column = ({edge: k for k, edge in enumerate(edges)} for edges in (ys, xs))
    taken = np.zeros((len(ys) - 1, len(xs) - 1), dtype=bool)
    for left, bottom, right, top in areas[1:]:
        taken[row[bottom] : row[top], column[left] : column[right]] = True
    return _rectangle(taken, xs, ys)


def _rectangle(taken: Inked, xs: Edges, ys: Edges) -> Area:
    """Find the largest bare rectangle between edges; heights of bare columns grow from one edge to the next."""
    starts, tops, best = np.array(xs[:-1]), np.array(ys[1:]), Area(0, 0, 0, 0)
    heights = tops[:, None] - np.maximum.accumulate(np.where(taken, tops[:, None], ys[0]))
    closing = np.append((taken[1:] > taken[:-1]).any(-1), True)  # what is bare below another bare row goes on in it
    stepped = np.ones(taken.shape, dtype=bool)  # columns as high as the one before are one with it
    stepped[:, 1:] = heights[:, 1:] != heights[:, :-1]
    for k in np.flatnonzero(closing).tolist():
        tall, edges = heights[k, stepped[k]].tolist(), [*starts[stepped[k]].tolist(), xs[-1]]
        best = max(best, _under(tall, edges, ys[k + 1]), key=lambda area: area.size)
    return best


def _under(heights: Sequence[int], edges: Edges, top: int) -> Area:
    """Give the largest rectangle that hangs from a row under heights between edges; each ends where its column does."""
    best, count, starts = Area(0, top, 0, top), 0, list[tuple[int, int]]()  # left side and height of those still open
    for x, high in zip(edges, [*heights, 0], strict=True):
        left = x
        while starts and starts[-1][1] >= high:
            left, tall = starts.pop()
            if tall * (x - left) > count:
                best, count = Area(left, top - tall, x, top), tall * (x - left)
        if high:
            starts.append((left, high))
    return best


EDGE = 2.0  # spare paper beside the frame is shared with nothing, that between two figures by both: times as much
LEVEL = 25.0  # mm: headings that differ by no more are made level


class Occupant(NamedTuple):
    """What stands in a cell: a figure, with spare paper around it, or lettering, which stands at an edge."""

    size: Size
    figure: bool
    wider: float = 0.0  # mm that it may be wider, where its cell is: notes and tables
    taller: float = 0.0  # mm that it may be higher: graphs


class Stand(NamedTuple):
    """A run of units that stand close in a cell: its box there."""

    tree: Tree
    cell: Field
    box: Field

    def lifted(self, up: float) -> Stand:
        """Lift the run by some millimetres, if that is little and leaves it in its cell."""
        low, high = self.box.bottom + up, self.box.top + up
        if abs(up) > LEVEL + MARGIN or low < self.cell.bottom - SAME or high > self.cell.top + SAME:
            return self
        return self._replace(box=self.box._replace(bottom=low, top=high))


def natural(tree: Tree, sizes: Mapping[int, Size]) -> Size:
    """Give the size of a tree, mm."""
    if isinstance(tree, Piece):
        return sizes[tree.unit]
    (wide, high), (own_wide, own_high) = natural(tree.first, sizes), natural(tree.second, sizes)
    if tree.beside:
        return wide + own_wide + GAP, max(high, own_high)
    return max(wide, own_wide), high + own_high + GAP


class Standing:
    """The units of one sheet, by their numbers, in a room."""

    def __init__(self, units: Mapping[int, Occupant], room: Field) -> None:
        self.units, self.room = units, room
        self.sizes = {k: unit.size for k, unit in units.items()}

    def boxes(self, tree: Tree) -> dict[int, Field]:
        """Give the box of every unit."""
        stands = self._level(list(self._stands(tree, self.room)))
        return {k: box for stand in stands for k, box in self._split(stand.tree, stand.box)}

    def _stands(self, tree: Tree, cell: Field) -> Iterator[Stand]:
        """Share a cell among what stands in it."""
        if isinstance(tree, Piece) or tree.tied:
            yield Stand(tree, cell, self._box(tree, cell))
            return
        first, second = self._cells(tree, cell)
        yield from self._stands(tree.first, first)
        yield from self._stands(tree.second, second)

    def _cells(self, tree: Cut, cell: Field) -> tuple[Field, Field]:
        """Cut a cell: each part has what it needs, and of what is spare as its figures ask."""
        axis = 0 if tree.beside else 1
        taken, other = natural(tree.first, self.sizes)[axis], natural(tree.second, self.sizes)[axis]
        asks = self._asks(tree.first, axis), self._asks(tree.second, axis)
        spare = (cell.width, cell.height)[axis] - taken - other - GAP
        first = taken + spare * (asks[0] / sum(asks) if sum(asks) else 0.0)
        if tree.beside:
            return cell._replace(right=cell.left + first), cell._replace(left=cell.left + first + GAP)
        return cell._replace(bottom=cell.top - first), cell._replace(top=cell.top - first - GAP)

    def _asks(self, tree: Tree, axis: int) -> float:
        """Count the figures that stand in a row along an axis."""
        if isinstance(tree, Piece):
            return float(self.units[tree.unit].figure)
        if tree.tied:
            return 1.0
        asks = self._asks(tree.first, axis), self._asks(tree.second, axis)
        return sum(asks) if tree.beside == (axis == 0) else max(asks)

    def _box(self, tree: Tree, cell: Field) -> Field:
        """Stand a unit in its cell: a figure amid spare paper, lettering at the nearest edge of the sheet."""
        wide, high = natural(tree, self.sizes)
        unit = self.units[next(pieces(tree)).unit]
        sides = self._edges(cell)
        if isinstance(tree, Piece):
            wide, high = min(wide + unit.wider, cell.width), min(high + unit.taller, cell.height)
        if unit.figure:
            left = _share(cell.width - wide, sides[0], sides[2])
            up = _share(cell.height - high, sides[3], sides[1])
        else:
            left = cell.width - wide if sides[2] and not sides[0] else 0.0
            up = cell.height - high if sides[1] and not sides[3] else 0.0
        return Field(cell.left + left, cell.top - up - high, cell.left + left + wide, cell.top - up)

    def _edges(self, cell: Field) -> tuple[bool, bool, bool, bool]:
        """Tell on which sides a cell ends at the room's: left, bottom, right, top."""
        left, bottom, right, top = (abs(side - edge) <= SAME * 100 for side, edge in zip(cell, self.room, strict=True))
        return left, bottom, right, top

    def _level(self, stands: Sequence[Stand]) -> list[Stand]:
        """Make headings level of figures whose cells begin at one height, or nearly so."""
        heads = [k for k, stand in enumerate(stands) if self.units[next(pieces(stand.tree)).unit].figure]
        rows: list[list[int]] = []
        for k in sorted(heads, key=lambda k: -tied(stands[k].cell.top)):
            if rows and stands[rows[-1][0]].cell.top - stands[k].cell.top <= LEVEL + MARGIN:
                rows[-1].append(k)
            else:
                rows.append([k])
        found = dict(enumerate(stands))
        for row in rows:
            aim = min(max(stands[k].box.top for k in row), *(stands[k].cell.top for k in row))
            found |= {k: stands[k].lifted(aim - stands[k].box.top) for k in row}
        return [found[k] for k in range(len(stands))]

    def _split(self, tree: Tree, box: Field) -> Iterator[tuple[int, Field]]:
        """Stand what is tied, each in the middle of the others."""
        if isinstance(tree, Piece):
            yield tree.unit, box
            return
        first, other = natural(tree.first, self.sizes), natural(tree.second, self.sizes)
        yield from self._split(tree.first, _middle(first[0], box._replace(bottom=box.top - first[1])))
        yield from self._split(tree.second, _middle(other[0], box._replace(top=box.bottom + other[1])))


def _share(spare: float, near: bool, far: bool) -> float:
    """Give the spare paper on the near side, mm: beside the frame more than between two figures."""
    here, other = (EDGE if edge else 1.0 for edge in (near, far))
    return spare * here / (here + other)


def _middle(wide: float, box: Field) -> Field:
    middle = box.centre.real
    return box._replace(left=middle - wide / 2, right=middle + wide / 2)
