"""A table on paper: a column of names, bands of cells beside it, set in bands and parts as room allows (таблица)."""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

from drawings.layout.picture import TextBlock
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting, Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Kind, Line, LineStyle, Statement, Stroke, Text
from drawings.paper.walk import stating

# In sizes of the letters: a row, how far a text stands above its row's line, and the least cell.
ROW, UNDER, CELL = 2.0, 0.65, 4.0
APART = 6.0  # mm between two bands or two parts of the table
MOST_PARTS = 4  # side by side: more are wider than an A1 sheet


class Later(NamedTuple):
    """A cell that is written when the sheets are composed: what it tells of, in which position, as wide as it may be.

    It has no more than `places` decimals, and tells nothing beyond `most`.
    """

    name: str
    position: int
    widest: str
    places: int
    most: float


Cell: TypeAlias = str | Later


class TableRow(NamedTuple):
    """A line of the table: its name, and its cells."""

    name: str
    cells: tuple[Cell, ...]


class Setting(NamedTuple):
    """How a table is set: bands across, and parts of its rows side by side."""

    across: int
    parts: int


class RuledTable(NamedTuple):
    """A table in its natural size: cells as wide as their widest text, all of them alike.

    Its bands are of positions, each with its title over the headings of its columns; a table of no position has one
    band without a title.
    """

    lines: tuple[TableRow, ...]
    positions: tuple[int, ...]
    text: float  # size of the letters, mm
    names: float  # width of the column of names, mm
    cell: float  # width of a cell, mm
    first: str = ""  # the heading of the names
    heads: tuple[str, ...] = ("", "", "")  # of the columns of a band
    name: str = "values"  # what its bands are named by, and numbered
    start: int = 0  # the number of its first row in the whole table
    least: int = 1  # rows of each of its parts: it is not torn in smaller ones
    foot: tuple[str, ...] = ()  # lines under it: of what its numbers are

    @property
    def row(self) -> float:
        """Height of a row, mm."""
        return ROW * self.text

    @property
    def rows(self) -> tuple[int, int]:
        """Where its rows begin and end in the whole table."""
        return self.start, self.start + len(self.lines)

    @property
    def bands(self) -> int:
        """How many bands there are."""
        return max(len(self.positions), 1)

    @property
    def over(self) -> int:
        """How many rows of headings there are."""
        return 2 if self.positions else 1

    def width(self, across: int) -> float:
        """Give the width of some bands beside the names, mm."""
        return self.names + len(self.heads) * self.cell * min(across, self.bands)

    def part(self, rows: slice) -> "RuledTable":
        """Give the table of some of its rows."""
        return self._replace(lines=self.lines[rows], start=self.start + (rows.start or 0))

    def of(self, chosen: slice) -> "RuledTable":
        """Give the table of some of its bands."""
        count = len(self.heads)
        cells = slice(count * chosen.start, count * chosen.stop)
        lines = tuple(TableRow(line.name, line.cells[cells]) for line in self.lines)
        return self._replace(lines=lines, positions=self.positions[chosen])

    @property
    def plain(self) -> list[list[str]]:
        """Its rows in plain text, the headings first, without what a hand may be out, which the sheet alone tells."""
        kept = [k for k in range(len(self.heads)) if not any(isinstance(line.cells[k], Later) for line in self.lines)]
        rows = [(self.first, self.heads), *self.lines]
        return [[Text(0j, str(text)).plain for text in (name, *(cells[k] for k in kept))] for name, cells in rows]

    def filled(self, write: Callable[[Later], str]) -> "RuledTable":
        """Give the table with all its cells written; it keeps its size."""
        lines = (TableRow(name, tuple(_written(cell, write) for cell in cells)) for name, cells in self.lines)
        return self._replace(lines=tuple(lines))

    def size(self, setting: Setting) -> tuple[float, float]:
        """Give width and height on paper, mm."""
        bands = math.ceil(self.bands / setting.across)
        width, rows = self.width(setting.across), math.ceil(len(self.lines) / setting.parts) + self.over
        high = bands * rows * self.row + (bands - 1) * APART + len(self.foot) * self.row
        return setting.parts * width + (setting.parts - 1) * APART, high

    def pieces(self, setting: Setting) -> int:
        """Count the pieces into which it is torn: bands one above another, parts side by side."""
        return math.ceil(self.bands / setting.across) * setting.parts

    def widened(self, setting: Setting, width: float) -> "RuledTable":
        """Give the table set as wide as a box, mm: its columns alike."""
        more = (width - (setting.parts - 1) * APART) / (setting.parts * self.width(setting.across))
        return self._replace(names=self.names * more, cell=self.cell * more)

    def settings(self) -> list[Setting]:
        """List the ways to set the table, in bands or in parts side by side, that no other beats both ways."""
        across = sorted({math.ceil(self.bands / bands) for bands in range(1, self.bands + 1)}, reverse=True)
        most = max(min(MOST_PARTS, len(self.lines) // self.least), 1)
        ways = [Setting(wide, parts) for parts in range(1, most + 1) for wide in across]
        sizes = [self.size(way) for way in ways]
        larger = [any(w <= wide and h <= high and (w, h) != (wide, high) for w, h in sizes) for wide, high in sizes]
        return [way for way, worse in zip(ways, larger, strict=True) if not worse]

    def block(self, name: str) -> TextBlock:
        """Give the sizes that it may have where it stands among figures."""
        ways = sorted((self.size(setting), self.pieces(setting)) for setting in self.settings())
        return TextBlock(name, tuple(size for size, _ in ways), tuple(pieces for _, pieces in ways))

    def setting(self, box: Field) -> Setting:
        """Give the way to set it whose size a box has."""

        def off(setting: Setting) -> float:
            wide, high = self.size(setting)
            return abs(wide - box.width) + abs(high - box.height)

        return min(self.settings(), key=off)

    def as_high(self, box: Field) -> Setting:
        """Give the way to set it that is as high as a box, which may be wider."""
        return min(self.settings(), key=lambda setting: abs(self.size(setting)[1] - box.height))

    def write(self, box: Field, drafting: Drafting) -> Group:
        """Draw it in its box among figures."""
        return Group(tuple(self.draw(complex(box.left, box.top), self.setting(box), drafting)))

    def draw(self, corner: complex, setting: Setting, drafting: Drafting, before: int = 0) -> list[Group]:
        """Draw the table from its upper left corner, bands and parts as groups, counted on from `before`."""
        per_part = max(1, math.ceil(len(self.lines) / setting.parts))  # where no force acts at all there are no lines
        width, height = self.width(setting.across) + APART, (per_part + self.over) * self.row + APART
        groups: list[Group] = []
        for band in range(0, self.bands, setting.across):
            for k in range(0, len(self.lines), per_part):
                at = corner + complex(k / per_part * width, -band / setting.across * height)
                piece = self.of(slice(band, band + setting.across)).part(slice(k, k + per_part))
                groups.append(piece.group(at, before + len(groups) + 1, drafting))
        return [*groups, *([self._footed(corner, setting)] if self.foot else [])]

    def _footed(self, corner: complex, setting: Setting) -> Group:
        """Write the lines under it, from its left edge."""
        low = corner - 1j * (self.size(setting)[1] - UNDER * self.text)
        feet = (low + 1j * k * self.row for k in reversed(range(len(self.foot))))
        return Group(tuple(Text(at, line, self.text, "start", True) for at, line in zip(feet, self.foot, strict=True)))

    def group(self, corner: complex, number: int, drafting: Drafting) -> Group:
        """Draw one band or part of the table: its lines, its headings, and its rows."""
        strokes = (*_rules(self, corner, drafting.hand), *_headings(self, corner, drafting), *_cells(self, corner))
        data = {"positions": " ".join(str(position) for position in self.positions)} if self.positions else {}
        return Group((Group(strokes),), f"{self.name}-{number}", data)


def table(
    lines: Sequence[TableRow],
    first: str,
    heads: tuple[str, ...],
    text: float,
    positions: tuple[int, ...] = (),
    foot: tuple[str, ...] = (),
) -> RuledTable:
    """Measure a table; it is as wide as the lines at its foot."""
    cells = (_written(cell, _widest) for line in lines for cell in line.cells)
    cell = max(text_width(Text(0j, entry, text)) for entry in (*heads, *cells))
    names = max(text_width(Text(0j, name, text)) for name in (first, *(line.name for line in lines)))
    cell = max(cell, CELL * text) + text
    below = max((text_width(Text(0j, line, text)) for line in foot), default=0.0)
    names = max(names + text, below - len(heads) * cell)
    return RuledTable(tuple(lines), positions, text, names, cell, first, heads, foot=foot)


def _written(cell: Cell, write: Callable[[Later], str]) -> str:
    return write(cell) if isinstance(cell, Later) else cell


def _widest(cell: Later) -> str:
    return cell.widest


def _columns(piece: RuledTable, corner: complex) -> list[float]:
    """Give the places of the upright lines."""
    cells = range(len(piece.heads) * piece.bands + 1)
    return [corner.real, *(corner.real + piece.names + piece.cell * k for k in cells)]


def _rules(piece: RuledTable, corner: complex, hand: Hand) -> list[Stroke]:
    main, thin = LineStyle(hand.main), LineStyle(hand.construction)
    columns, top, strokes = _columns(piece, corner), corner.imag, list[Stroke]()
    rows = len(piece.lines) + piece.over
    for k, x in enumerate(columns):
        heavy = k in (0, 1) or (k - 1) % len(piece.heads) == 0
        high = top if heavy else top - piece.row * (piece.over - 1)
        strokes.append(Line(complex(x, top - rows * piece.row), complex(x, high), main if heavy else thin))
    for k in range(rows + 1):
        y = top - piece.row * k
        left = columns[1] if 0 < k < piece.over else columns[0]
        style = main if k in (0, piece.over, rows) else thin
        strokes.append(Line(complex(left, y), complex(columns[-1], y), style))
    return strokes


def _headings(piece: RuledTable, corner: complex, drafting: Drafting) -> list[Stroke]:
    size, row, columns = piece.text, piece.row, _columns(piece, corner)
    low = corner.imag - piece.over * row + UNDER * size
    middle = corner.imag - piece.over * row / 2 - size / 2 if piece.positions else low
    strokes: list[Stroke] = [Text(complex((columns[0] + columns[1]) / 2, middle), piece.first, size, "middle", True)]
    count, high = len(piece.heads), corner.imag - row + UNDER * size
    for band in range(piece.bands):
        edges = columns[1 + count * band : 2 + count * (band + 1)]
        if piece.positions:
            title = drafting.word("position", position=piece.positions[band])
            strokes.append(Text(complex((edges[0] + edges[-1]) / 2, high), title, size, "middle", True))
        for head, left, right in zip(piece.heads, edges, edges[1:], strict=False):
            strokes.append(Text(complex((left + right) / 2, low), head, size, "middle", True))
    return strokes


def _cells(piece: RuledTable, corner: complex) -> list[Stroke]:
    columns, strokes = _columns(piece, corner), list[Stroke]()
    for k, line in enumerate(piece.lines):
        y = corner.imag - piece.row * (k + piece.over + 1) + UNDER * piece.text
        strokes.append(Text(complex(columns[0] + piece.text / 2, y), line.name, piece.text, "start", True))
        for column, x in enumerate(columns[1 : 1 + len(line.cells)]):
            strokes.append(_cell(piece, line, column, complex(x + piece.cell / 2, y)))
    return strokes


def _cell(piece: RuledTable, line: TableRow, column: int, at: complex) -> Stroke:
    """Write a cell as what it states: the number of a row in a column of a position."""
    band, place = divmod(column, len(piece.heads))
    position = piece.positions[band] if piece.positions else None
    text = Text(at, _written(line.cells[column], _widest), piece.text, "middle", True)
    return stating(Statement(Kind.NUMBER, piece.name, cell_name(line.name, place), position), text)


def cell_name(row: str, column: int) -> str:
    """Name a cell by its row, as that is lettered, and its column within a band.

    >>> cell_name("v_{B}, m/s", 1)
    'v_{B}, m/s [1]'
    """
    return f"{row} [{column}]"
