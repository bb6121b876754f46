"""The composer: where on which sheets the contents stand, at which scales (компоновка листов).

Figures stand in their order; several orders of tables and notes among them are tried. The fewest sheets on which all
can be read and the foremost figure has its share of one are taken, on them all figures at the highest level that fits;
of what fits so the composition is chosen whose figures are large and that leaves the least paper bare.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from heapq import nlargest
from itertools import chain
from typing import NamedTuple

from drawings.layout.arrangement import Growth, State, rungs_of
from drawings.layout.contents import Composition, Contents
from drawings.layout.filling import Stood, size_of
from drawings.layout.picture import Picture, Rung
from drawings.layout.request import Request, SheetRun, fewest, partings, request
from drawings.layout.room import Order, Shape, corner_of, ends_of, head_of, nested, size_of_room
from drawings.layout.slicing import Cuts, Slicing, Tree, pieces
from drawings.page.page import Page
from drawings.paper.strokes import SheetError
from drawings.paper.walk import tied
from plans.words.words import message

LOOKS = 5  # levels at which compositions are looked at: the highest and those below it
POINTS = 8  # sizes of a sheet that are looked at
LATE = 0.5  # what notes count that do not stand on the first sheet, against the logarithm of the figures' sizes
EVEN = 2.0  # what a share of the room counts that the emptiest sheet has less than the sheets have on average, likewise
SETTLED = 4  # sets, the best as they are cut, that are looked at when all on them is moved
PARTINGS = 6  # ways to part a set into sheets that are looked at


def compose(contents: Contents, page: Page, cuts: Cuts | None = None) -> tuple[Composition, ...]:
    """Compose contents on as many sheets as keep every figure readable, the largest figures that fit.

    What is known of the `cuts` of a page's room serves whatever else is composed there.
    """
    return _Composer(request(contents, page, cuts or Cuts(size_of_room(page))), page).composed()


def fits(contents: Contents, page: Page, cuts: Cuts, count: int) -> bool:
    """Tell whether so many sheets keep every figure of contents readable."""
    asked = request(contents, page, cuts)
    every = asked._replace(orders=(*asked.orders, *asked.further))
    return _Composer(every, page).fits(asked.floors, count)


class _Cutting(NamedTuple):
    """All runs of units in one order, at the scales of a state."""

    slicing: Slicing
    shapes: list[list[Shape]]
    opening: list[list[Shape]]

    def fits(self, i: int, j: int) -> bool:
        return self.slicing.sheet(i, j).shapes.number > 0

    def number(self, most: int) -> int:
        """Count the sheets that it takes; 0 if one of its units fits none."""
        count = len(self.shapes)
        if most == 1:
            return int(self.fits(0, count - 1))
        return fewest(count, self.fits)

    def trees(self, i: int, j: int) -> Iterator[Tree]:
        """Give the ways to cut a sheet, evenly chosen among them."""
        count = self.slicing.sheet(i, j).shapes.number
        step = max(count / POINTS, 1.0)
        for k in sorted({int(step * n) for n in range(POINTS) if step * n < count}):
            yield nested(self.slicing.sheet(i, j).tree(k), self.shapes, self.opening)

    @property
    def areas(self) -> list[float]:
        return [min(shape.size[0] * shape.size[1] for shape in group) for group in self.shapes]


@dataclass(frozen=True, eq=False, repr=False)
class _Set:
    """A composed set of sheets, and how good it is at most: what is bare of it, dear to find, counts against it."""

    sheets: tuple[Stood, ...]
    most: float

    @cached_property
    def score(self) -> float:
        return tied(self.most - sum(sheet.fault for sheet in self.sheets))

    @cached_property
    def settled(self) -> float:
        """How good it is when all is moved to where it leaves less bare: no less than its score."""
        return tied(self.most - sum(sheet.left for sheet in self.sheets))


class _Composer:
    """The search for the composition of one set of sheets."""

    def __init__(self, asked: Request, page: Page) -> None:
        self.asked, self.page, self.orders = asked, page, asked.orders
        self.known: dict[tuple[Order, State], _Cutting] = {}
        self.chosen: dict[tuple[Order, State, SheetRun, bool], Tree] = {}
        self.sheets: dict[tuple[Tree, tuple[Rung, ...], bool], Stood] = {}

    def composed(self) -> tuple[Composition, ...]:
        """Find the best set."""
        count = self._fewest(self.asked.orders)
        if not count:
            raise SheetError(message("refused.figure", format=self.page.name))
        best = self._among(count)
        if any(sheet.parted for sheet in best.sheets):
            whole = _Composer(self.asked.whole, self.page)
            if whole._fewest(whole.orders) == count:
                found = whole._among(count)
                best = max(best, found, key=lambda candidate: (-len(candidate.sheets), candidate.settled))
        return tuple(sheet.composition() for sheet in best.sheets)

    def _among(self, count: int) -> _Set:
        """Find the best set: in the further orders where they need fewer sheets, or leave less of them bare."""
        further = self.asked.further if count > 1 else ()
        fewer = self._fewest(further) if further else count
        if fewer < count:
            self.orders = further
            return self._found(fewer)
        best = self._found(count)
        if not further or fewer > count or not any(sheet.left for sheet in best.sheets):
            return best
        self.orders = further
        return max(best, self._found(count), key=lambda candidate: candidate.settled)

    def _fewest(self, orders: Sequence[Order]) -> int:
        """Count the sheets that are needed at the least scales."""
        cuttings = [self._cutting(order, self.asked.floors) for order in orders]
        if any(cutting.number(1) for cutting in cuttings):
            return 1
        counts = []
        for cutting in cuttings:
            counts.append(cutting.number(0))
            if counts[-1] <= 2:
                break
        return min(counts)

    def _found(self, count: int) -> _Set:
        """Find the best set of so many sheets."""
        sets = (candidate for state in self._states(self.asked.floors, count) for candidate in self._sets(state, count))
        best = next(sets)
        looked_at = [best]
        for candidate in sets:
            if candidate.most > best.score:
                looked_at.append(candidate)
                best = max(best, candidate, key=lambda candidate: candidate.score)
        return _settled(nlargest(SETTLED, looked_at, key=lambda candidate: candidate.score))

    def _cutting(self, order: Order, state: State) -> _Cutting:
        if (order, state) not in self.known:
            rungs, stock = rungs_of(self.asked.steps, state), self.asked.stock
            shapes = [stock.shapes(unit, rungs) for unit in order]
            opening = [stock.opening(group, head_of(self.page)) for group in shapes]
            sizes, opened = ([[shape.size for shape in group] for group in every] for every in (shapes, opening))
            slicing = Slicing(sizes, stock.cuts, corner_of(self.page), opened)
            self.known[order, state] = _Cutting(slicing, shapes, opening)
        return self.known[order, state]

    def fits(self, state: State, count: int) -> bool:
        """Tell whether all stands on so many sheets."""
        numbers = (self._cutting(order, state).number(count) for order in self.orders)
        return any(0 < number <= count for number in numbers)

    def _states(self, floors: State, count: int) -> Iterator[State]:
        """Give the scales at the highest level that fits on so many sheets, and those below it."""
        levels = sorted({size for step in self.asked.steps for size in step.sizes if size < math.inf})
        states = list(dict.fromkeys([floors, *(self._state(level, floors) for level in levels)]))
        low, high = 0, len(states)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.fits(states[middle], count) else (low, middle)
        yield from states[max(low - LOOKS + 1, 0) : low + 1]

    def _state(self, level: float, floors: State) -> State:
        return tuple(max(step.at(level), floor) for step, floor in zip(self.asked.steps, floors, strict=True))

    def _sets(self, state: State, count: int) -> Iterator[_Set]:
        """Compose the sets that fit at some scales."""
        for order in self.orders:
            cutting = self._cutting(order, state)
            if count == 1:
                if cutting.fits(0, len(cutting.shapes) - 1):
                    for tree in cutting.trees(0, len(cutting.shapes) - 1):
                        yield self._grown([tree], state)
                continue
            for parting in partings(len(cutting.shapes), count, cutting.fits, cutting.areas)[:PARTINGS]:
                trees = [self._best(order, state, run, self._ends(run is parting[-1])) for run in parting]
                yield self._grown(trees, state)

    def _best(self, order: Order, state: State, run: SheetRun, last: bool) -> Tree:
        """Choose the best of the ways to cut one sheet of a set."""
        key = order, state, run, last
        if key not in self.chosen:
            self.chosen[key] = self._chosen(self._cutting(order, state), run, state, last)
        return self.chosen[key]

    def _chosen(self, cutting: _Cutting, run: SheetRun, state: State, last: bool) -> Tree:
        def fault(tree: Tree) -> float:
            grown = self._growth([tree]).grown(state, only=True)
            stood = self._stood(tree, rungs_of(self.asked.steps, grown), last)
            return stood.fault + stood.torn

        return _least(cutting.trees(*run), fault)

    def _stood(self, tree: Tree, rungs: Mapping[str, Rung], last: bool) -> Stood:
        """Stand a sheet, once for all sets that it is one of."""
        shown = (self.asked.stock.shown[piece.unit] for piece in pieces(tree) if piece.unit >= 0)
        key = tree, tuple(rungs[item.name] for item in shown if isinstance(item, Picture)), last
        if key not in self.sheets:
            self.sheets[key] = Stood(self.asked.stock, self.page, tree, rungs, last)
        return self.sheets[key]

    def _ends(self, last: bool) -> bool:
        """Tell whether no sheet follows one that ends these: a sheet of its own alone is no last one."""
        return last and not self.asked.followed

    def _growth(self, trees: Sequence[Tree]) -> Growth:
        return Growth(self.asked.stock, ends_of(self.page), self.asked.steps, trees)

    def _grown(self, trees: Sequence[Tree], state: State) -> _Set:
        grown = self._growth(trees).grown(state)
        rungs, steps = rungs_of(self.asked.steps, grown), self.asked.steps
        last = len(trees) - 1
        sheets = tuple(self._stood(tree, rungs, self._ends(0 < k == last)) for k, tree in enumerate(trees))
        size = size_of([step.sizes[k] for step, k in zip(steps, grown, strict=True) for _ in step.rungs[k]])
        late = LATE * any(sheet.notes for sheet in sheets[1:])
        torn, full = math.fsum(sheet.torn for sheet in sheets), [sheet.full for sheet in sheets]
        uneven = EVEN * (math.fsum(full) / len(full) - min(full))
        return _Set(sheets, tied(math.log(size) - late - torn - uneven))


def _settled(sets: Sequence[_Set]) -> _Set:
    """Give the best of some sets when all is moved; what one is at most tells whether it need be looked at."""
    best = sets[0]
    for candidate in sets[1:]:
        if candidate.most > best.settled and candidate.settled > best.settled:
            best = candidate
    return best


def _least(trees: Iterator[Tree], fault: Callable[[Tree], float]) -> Tree:
    """Give the first tree of the least fault; behind one without any none is looked at."""
    best, least = next(trees), math.inf
    for tree in chain([best], trees):
        if (loss := fault(tree)) < least:
            best, least = tree, loss
        if not least:
            break
    return best
