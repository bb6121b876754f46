"""Columns of figures: kept together, standard scales, nothing on anything else, following sheets, in little time."""

import itertools
import time
from functools import cache

import pytest

from drawings.layout.block import TextBlock
from drawings.layout.columns import Column, Zone, fill
from drawings.layout.composer import compose
from drawings.layout.contents import Composition, Contents, Item, Panel
from drawings.layout.footing import Notes
from drawings.layout.grid import GAP
from drawings.layout.picture import Ladder, Margins, Picture, Rung, picture
from drawings.layout.table import RuledTable, TableRow
from drawings.page.page import Field, Page
from drawings.page.scale import MANTISSAS
from drawings.paper.strokes import SheetError

LEAST = 60.0


def figure(
    name: str, wide: float, high: float, subject: tuple[str, str] = ("F", "N"), heading: float = 70.0
) -> Picture:
    return picture(name, [0j, complex(wide, high)], subject, Margins(12.0, 10.0, 30.0), heading, LEAST)


def group(name: str, scheme: tuple[float, float], polygon: tuple[float, float]) -> tuple[Item, ...]:
    equations = TextBlock(f"equations-{name}", ((70.0, 36.5), (100.0, 24.0)))
    return figure(f"scheme-{name}", *scheme, ("l", "m")), equations, figure(f"polygon-{name}", *polygon)


def table(rows: int) -> RuledTable:
    return RuledTable(tuple(TableRow(f"R_{k}", ("1.0",) * 3) for k in range(rows)), (2,), 3.5, 25.0, 22.0)


def contents(
    columns: tuple[tuple[Item, ...], ...],
    loose: tuple[Picture, ...] = (),
    values: RuledTable | None = None,
    notes: Notes | None = None,
) -> Contents:
    panels = (Panel(item, together=f"column {k}") for k, column in enumerate(columns) for item in column)
    return Contents((*panels, *map(Panel, loose)), () if values is None else (values,), notes)


PRIMARY = (figure("scheme-1", 0.36, 0.36, ("l", "m")), figure("polygon-1", 3800, 1500))
LOOSE = (figure("lever", 1.5, 1.2, ("v", "m/s")), figure("graph", 360, 225, ("φ", "°")))
SAID = Notes((150.0, 60.0, 90.0), 6.3)
COLUMNS = (group("4-5", (0.35, 0.05), (1640, 140)), group("2-3", (0.3, 0.7), (2500, 900)), PRIMARY)
SHAPER = contents(COLUMNS, LOOSE, table(8), SAID)
CRANK = contents((group("2-3", (0.2, 0.06), (1640, 340)), PRIMARY), LOOSE, table(5), SAID)
CHAIN = contents(tuple(group(f"{k}", (0.3, 0.2), (1000, 500 + 10 * k)) for k in range(29)), LOOSE, table(40), SAID)
PAGES = [
    Page("A1"), Page("A1", "portrait"), Page("A2"), Page("A3"), Page("A3", "portrait"), Page("A4"),
    Page("A1", standard="ISO"), Page("A3", standard="ISO"), Page("A4", standard="ISO"),
]  # fmt: skip
every_page = pytest.mark.parametrize("page", PAGES, ids=lambda page: f"{page.name}-{page.orientation}-{page.standard}")
every_set = pytest.mark.parametrize("content", [SHAPER, CRANK, CHAIN], ids=["shaper", "crank", "chain"])


def boxes(one: Composition, page: Page) -> list[Field]:
    found = [*(spot.box for spot in one.spots.values()), *one.blocks.values(), *page.taken]
    for own, corner, setting in one.tables:
        wide, high = own.size(setting)
        found.append(Field(corner.real, corner.imag - high, corner.real + wide, corner.imag))
    return found if one.notes is None else [*found, one.notes]


def apart(one: Field, other: Field) -> bool:
    slack = 1e-6
    return (
        one.right <= other.left + slack
        or other.right <= one.left + slack
        or one.top <= other.bottom + slack
        or other.top <= one.bottom + slack
    )


def inside(box: Field, room: Field) -> bool:
    slack = 1e-6
    return room.left <= box.left + slack and room.bottom <= box.bottom + slack and (
        box.right <= room.right + slack and box.top <= room.top + slack
    )  # fmt: skip


@cache
def composed(content: Contents, page: Page) -> list[Composition]:
    return compose(content, page)


@every_page
@every_set
def test_nothing_stands_on_anything_else_or_beyond_the_frame(content: Contents, page: Page) -> None:
    for one in composed(content, page):
        assert all(inside(box, page.field) for box in boxes(one, page))
        for first, second in itertools.combinations(boxes(one, page), 2):
            assert apart(first, second), (first, second)


@every_page
@every_set
def test_everything_is_shown_once_in_its_order(content: Contents, page: Page) -> None:
    sheets = composed(content, page)
    figures = [panel.item.name for panel in content.panels if isinstance(panel.item, Picture)]
    assert [name for one in sheets for name in one.spots] == figures
    assert [name for one in sheets for name in one.blocks] == [
        panel.item.name for panel in content.panels if isinstance(panel.item, TextBlock)
    ]
    rows = [line for one in sheets for own in one.tables for line in own.table.lines]
    assert content.table is not None and rows == list(content.table.lines)
    assert [one.notes is not None for one in sheets] == [k == 0 for k in range(len(sheets))]


def box_of(one: Composition, name: str) -> Field | None:
    return one.spots[name].box if name in one.spots else one.blocks.get(name)


@every_page
@every_set
def test_a_column_stays_together_from_top_to_bottom(content: Contents, page: Page) -> None:
    for one in composed(content, page):
        for column in (own for own in content.groups if len(own) > 1):
            names = [panel.item.name for panel in column]
            places = [box for name in names if (box := box_of(one, name)) is not None]
            assert len(places) in (0, len(names))  # all on one sheet
            if not places:
                continue
            assert all(upper.bottom >= lower.top - 1e-6 for upper, lower in itertools.pairwise(places))
            assert max(box.left for box in places) < min(box.right for box in places)


@every_page
def test_scales_are_standard_ones_and_every_figure_can_be_read(page: Page) -> None:
    pictures = {one.item.name: one.item for one in SHAPER.panels if isinstance(one.item, Picture)}
    for one in compose(SHAPER, page):
        for name, spot in one.spots.items():
            size = pictures[name].extent(spot.scale)
            assert size >= LEAST or len(one.spots) <= len(COLUMNS[0])
            if spot.scale.letter == "F":
                mantissa = float(f"{spot.scale.mu:e}".split("e")[0])
                assert mantissa in MANTISSAS[page.standard]


def test_the_shaper_goes_on_one_a1_sheet_and_fills_it() -> None:
    page = Page("A1")
    (only,) = compose(SHAPER, page)
    field = page.field
    assert sum(box.width * box.height for box in boxes(only, page)) > 0.45 * field.width * field.height
    for side in ("left", "right"):
        edge = getattr(field, side)
        assert min(abs(getattr(box, side) - edge) for box in boxes(only, page)) < 20.0


def test_headings_of_the_columns_are_level() -> None:
    (only,) = compose(SHAPER, Page("A1"))
    tops = [only.spots[column[0].name].box.top for column in COLUMNS]
    assert max(tops) - min(tops) < 1e-6


def test_lettering_stands_close_under_its_scheme() -> None:
    (only,) = compose(SHAPER, Page("A1"))
    for name in ("4-5", "2-3"):
        gap = only.spots[f"scheme-{name}"].box.bottom - only.blocks[f"equations-{name}"].top
        assert 0 <= gap <= 12.0


def test_lettering_is_broken_no_more_than_its_column_needs() -> None:
    block = TextBlock("equations", ((60.0, 40.0), (90.0, 25.0), (200.0, 10.0)))
    (one,) = compose(contents(((figure("scheme", 0.7, 0.3, ("l", "m")), block),)), Page("A3"))
    assert one.blocks["equations"].width == 200.0 and one.blocks["equations"].height == 10.0


def test_lettering_is_no_wider_than_the_column_over_it() -> None:
    block = TextBlock("equations", ((60.0, 40.0), (90.0, 25.0), (600.0, 10.0)))
    (one,) = compose(contents(((figure("scheme", 0.1, 0.9, ("l", "m")), block), PRIMARY)), Page("A2"))
    assert one.spots["scheme"].box.width == 70.0 and one.blocks["equations"].width == 60.0


def test_no_picture_could_be_drawn_larger_by_itself() -> None:
    width, height = 800.0, 570.0
    columns = tuple(
        tuple(item.ladder(width, height) if isinstance(item, Picture) else item for item in column)
        for column in COLUMNS
    )
    found = fill((Zone(columns, 0.0, height),), width)
    assert found is not None
    rungs = [list(own) for own in found.rungs[0]]
    assert _fits(columns, rungs, width, height)
    for c, column in enumerate(columns):
        for i, part in enumerate(column):
            kept = rungs[c][i]
            if isinstance(part, Ladder) and kept is not None and part.rungs.index(kept):
                rungs[c][i] = part.rungs[part.rungs.index(kept) - 1]
                assert not _fits(columns, rungs, width, height)
                rungs[c][i] = kept


def _fits(columns: tuple[Column, ...], rungs: list[list[Rung | None]], width: float, height: float) -> bool:
    wide = [max(rung.wide for rung in own if rung) for own in rungs]
    high = [
        sum(part.size(across)[1] if isinstance(part, TextBlock) else rung.high if rung else 0.0
            for part, rung in zip(column, own, strict=True)) + GAP * (len(column) - 1)
        for column, own, across in zip(columns, rungs, wide, strict=True)
    ]  # fmt: skip
    return sum(wide) + GAP * (len(wide) - 1) <= width and max(high) <= height


def test_a_chain_of_many_groups_goes_on_sheets_that_are_filled_alike() -> None:
    counts = [
        sum(group[0].item.name in one.spots for group in CHAIN.groups)
        for one in compose(CHAIN, Page("A1"))
        if one.spots
    ]
    assert sum(counts) == 31 and max(counts) - min(counts) <= 1


def test_a_table_longer_than_a_sheet_is_continued_on_the_next() -> None:
    long = Contents(CRANK.panels, (table(400),), SAID)
    rows = [len(own.table.lines) for one in compose(long, Page("A3")) for own in one.tables]
    assert sum(rows) == 400 and len(rows) > 1


def test_a_heading_wider_than_the_paper_is_told() -> None:
    with pytest.raises(SheetError, match="take a larger format"):
        compose(contents(((figure("scheme", 1.0, 1.0, heading=300.0),),)), Page("A4"))


def test_composing_takes_little_time() -> None:
    times = []
    for _ in range(5):
        start = time.process_time()
        compose(SHAPER, Page("A1"))
        times.append(time.process_time() - start)
    assert min(times) < 0.2  # 0.035 s on a quiet machine
