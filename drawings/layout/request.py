"""What the composer is asked for, made to fit the paper: units in their orders, scales that can be read (задание)."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple, TypeAlias

from drawings.layout.arrangement import State, Steps, rungs_of, steps_of
from drawings.layout.contents import Contents
from drawings.layout.picture import Picture, Rung
from drawings.layout.room import Order, Shape, Stock, Unit, corner_of, further, groups, head_of, orders, size_of_room
from drawings.layout.slicing import Cuts, Piece, Slicing
from drawings.layout.table import RuledTable
from drawings.page.page import Page
from drawings.paper.strokes import SheetError
from drawings.paper.walk import tied
from plans.words.words import Message, message

SheetRun: TypeAlias = tuple[int, int]  # the first and the last unit of a sheet
Fits: TypeAlias = Callable[[int, int], bool]

MOST = 400  # ways to part a set that are compared at most


def fewest(count: int, fits: Fits) -> int:
    """Give the least number of sheets for some units, 0 if one of them fits none.

    >>> fewest(5, lambda i, j: j - i < 2)
    3
    """
    if count and fits(0, count - 1):
        return 1
    least = [0]
    for j in range(count):
        ways = [least[i] for i in _starts(j, fits) if least[i] or i == 0]
        least.append(min(ways) + 1 if ways else 0)
    return least[count]


def _starts(j: int, fits: Fits) -> Iterator[int]:
    """Give the first units of the sheets that may end with a unit: a longer run fits no better."""
    for i in range(j, -1, -1):
        if not fits(i, j):
            return
        yield i


def partings(count: int, sheets: int, fits: Fits, areas: Sequence[float]) -> list[tuple[SheetRun, ...]]:
    """List the ways to part units into sheets, those first whose sheets are filled most evenly.

    >>> partings(3, 2, lambda i, j: True, [1.0, 1.0, 2.0])
    [((0, 1), (2, 2)), ((0, 0), (1, 2))]
    """
    ways: list[tuple[SheetRun, ...]] = []
    for way in _ways(0, count, sheets, fits):
        ways.append(way)
        if len(ways) == MOST:
            break
    return sorted(ways, key=lambda way: tied(max(sum(areas[i : j + 1]) for i, j in way)))


def _ways(start: int, count: int, sheets: int, fits: Fits) -> Iterator[tuple[SheetRun, ...]]:
    if sheets == 1:
        if start < count and fits(start, count - 1):
            yield ((start, count - 1),)
        return
    for end in range(start, count - sheets + 1):
        if not fits(start, end):
            return
        for rest in _ways(end + 1, count, sheets - 1, fits):
            yield (start, end), *rest


FEW = 8  # figures of a set: among more of them tables and notes have places enough


class Request(NamedTuple):
    """Units in their reading orders, the steps of their scales, the least steps.

    The `further` orders are for sets of some sheets, where one of them would stay bare. Behind a set that is `followed`
    stand other sheets: none of its own is the last.
    """

    stock: Stock
    orders: tuple[Order, ...]
    steps: tuple[Steps, ...]
    floors: State
    further: tuple[Order, ...] = ()
    followed: bool = False

    @property
    def whole(self) -> "Request":
        """What is asked for with all tables in as few pieces as a sheet holds."""
        return self._replace(stock=replace(self.stock, whole=True))


def request(contents: Contents, page: Page, cuts: Cuts) -> Request:
    """Make contents fit a page: what is too large for a sheet is drawn smaller, taken apart, or goes on on the next."""
    return _Fitting(contents, page, cuts).request()


class _Fitting:
    def __init__(self, contents: Contents, page: Page, cuts: Cuts) -> None:
        self.contents, self.page, self.cuts = contents, page, cuts
        self.room = size_of_room(page)
        self.names = {panel.item.name: k for k, panel in enumerate(contents.panels)}
        notes = () if contents.notes is None else (contents.notes,)
        self.shown = [*(panel.item for panel in contents.panels), *contents.tables, *notes]

    def request(self) -> Request:
        pairs = [self._readable(*pair) for pair in steps_of(self.contents.panels, self.room, self.page.standard)]
        steps = tuple(step for step, _ in pairs)
        floors = self._raised(steps, tuple(floor for _, floor in pairs))
        rungs = rungs_of(steps, floors)
        first = len(self.contents.panels)
        figures = [part for unit in groups(self.contents) for part in self._apart(unit, rungs)]
        tables = [piece for k in range(len(self.contents.tables)) for piece in self._pieces(first + k)]
        notes = [first + len(self.contents.tables)] if self.contents.notes is not None else []
        many = further(figures, tables, notes) if len(figures) <= FEW else []
        arranged = tuple(orders(figures, tables, notes))
        return Request(self._stock, arranged, steps, floors, tuple(many), self.contents.followed)

    @property
    def _stock(self) -> Stock:
        return Stock(tuple(self.shown), self.room, self.cuts)

    def _readable(self, read: Steps, every: Steps) -> tuple[Steps, int]:
        """Give the steps at which figures can be read, or else all, from the largest on at which each fits a sheet."""
        for ladder in (read, every):
            fitting = [k for k, step in enumerate(ladder.rungs) if all(self._alone(*entry) for entry in step.items())]
            if fitting:
                return ladder, 0 if ladder is read else fitting[-1]
        raise SheetError(self._refused(every))

    def _refused(self, every: Steps) -> Message:
        """Say which figure has no room even at its least scale, and how much room there is, mm."""
        wide, high = self.room
        pictures = [panel.item for panel in self.contents.panels if isinstance(panel.item, Picture)]
        large = (picture.name for picture in pictures if not picture.rungs(wide, high, self.page.standard))
        least = every.rungs[0] if every.rungs else {}
        name = next((wanted for wanted, rung in least.items() if not self._alone(wanted, rung)), None) or next(large)
        field = {"width": f"{wide:.0f}", "height": f"{high:.0f}"}
        return message("refused.alone", format=self.page.name, figure=name, **field)

    def _alone(self, name: str, rung: Rung) -> bool:
        """Tell whether a picture stands on a sheet with nothing but the title block."""
        return self._stands([Shape((rung.wide, rung.high), Piece(self.names[name], 0))])

    def _stands(self, shapes: Sequence[Shape]) -> bool:
        """Tell whether a unit stands on a sheet with nothing but the title block."""
        opening = [shape.size for shape in self._stock.opening(shapes, head_of(self.page))]
        return len(Slicing([opening], self.cuts, corner_of(self.page)).sheet(0, 0).sizes) > 0

    def _apart(self, unit: Unit, rungs: Mapping[str, Rung]) -> Iterator[Unit]:
        """Take what should stand together apart where no sheet holds it."""
        if isinstance(unit, int) or self._stands(self._stock.shapes(unit, rungs)):
            yield unit
        else:
            for part in unit:
                yield from self._apart(part, rungs)

    def _pieces(self, k: int) -> Iterator[int]:
        """Part a table that no sheet holds by its rows; its parts are shown as tables of their own."""
        table = self.shown[k]
        assert isinstance(table, RuledTable)
        first = True
        while table.lines or first:
            part = table.part(slice(0, self._rows(table, k)))
            if first:
                self.shown[k] = part
                yield k
            else:
                self.shown.append(part)
                yield len(self.shown) - 1
            table, first = table.part(slice(len(part.lines), None)), False

    def _rows(self, table: RuledTable, k: int) -> int:
        """Count the rows of a table that stand on a sheet."""
        for rows in range(len(table.lines), 0, -1):
            part = table.part(slice(0, rows))
            if self._stands([Shape(part.size(setting), Piece(k, 0)) for setting in part.settings()]):
                return rows
        if table.lines:
            raise SheetError(message("refused.table", format=self.page.name))
        return 0

    def _raised(self, steps: Sequence[Steps], floors: State) -> State:
        """Draw figures on their shares of a sheet, or at the largest scale that fits one."""
        found, field = list(floors), self.page.field
        for panel in self.contents.panels:
            if panel.share and isinstance(panel.item, Picture):
                name = panel.item.name
                v = next(v for v, step in enumerate(steps) if name in step.rungs[0])
                rungs = [step[name] for step in steps[v].rungs]
                area = panel.share * field.width * field.height
                large = [k for k, rung in enumerate(rungs) if tied(rung.wide * rung.high - area) >= 0]
                fitting = [k for k, rung in enumerate(rungs) if self._alone(name, rung)]
                found[v] = max(min(large[:1] + fitting[-1:]), floors[v])
        return tuple(found)
