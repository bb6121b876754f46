"""The composer: nothing on anything else, order and groups kept, all readable, one scale where it is asked for."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable
from itertools import combinations
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as some

from drawings.layout.composer import compose
from drawings.layout.contents import Composition, Contents, Panel
from drawings.layout.picture import Margins, Notes, Picture, TextBlock, picture
from drawings.layout.table import RuledTable, TableRow
from drawings.page.page import Field, Page
from drawings.paper.strokes import SheetError
from tests.drawings.test_slicing import apart, inside
from tests.parts import examples
from tests.parts import some as rows

ROOT = Path(__file__).parent.parent.parent
FIGURES = [
    path.relative_to(ROOT).with_suffix("").as_posix().replace("/", ".")
    for path in sorted((ROOT / "drawings").rglob("*.py"))
    if "MARGINS" in path.read_text("utf-8")
]
LEAST = 40.0
MARGINS = Margins(12.0, 10.0, 26.0)
PAGES = [
    Page("A1"), Page("A1", "portrait"), Page("A2"), Page("A3"), Page("A3", "portrait"), Page("A4"),
    Page("A1", standard="ISO"), Page("A3", standard="ISO"), Page("A4", standard="ISO"),
]  # fmt: skip
SAID = Notes((150.0, 60.0, 90.0), 6.3)


def figure(name: str, wide: float, high: float, heading: float = 70.0) -> Picture:
    return picture(name, [0j, complex(wide, high)], ("l", "m"), MARGINS, heading, LEAST)


def table(rows: int, positions: int = 2, name: str = "values") -> RuledTable:
    lines = tuple(TableRow(f"v_{k}", ("1.0",) * 3 * positions) for k in range(rows))
    return RuledTable(lines, tuple(range(positions)), 3.5, 20.0, 20.0, name=name)


def group(k: int, wide: float, high: float) -> list[Panel]:
    equations = TextBlock(f"equations-{k}", ((70.0, 36.5), (100.0, 24.0)))
    items = figure(f"scheme-{k}", wide, high), equations, figure(f"polygon-{k}", high, wide)
    return [Panel(item, together=f"group {k}") for item in items]


sides = some.floats(0.05, 1.5)
pairs = some.lists(some.tuples(sides, sides), min_size=1, max_size=4)


@some.composite
def anything(draw: some.DrawFn) -> Contents:
    """A foremost figure or none, groups, single figures of one scale, tables, notes."""
    panels = [Panel(figure("main", *size), 1.5) for size in draw(some.lists(some.tuples(sides, sides), max_size=1))]
    panels += [panel for k, size in enumerate(draw(pairs)) for panel in group(k, *size)]
    scale = draw(some.sampled_from(["", "v"]))
    panels += [Panel(figure(f"plan-{k}", *size), scale=scale) for k, size in enumerate(draw(pairs))]
    rows = draw(some.lists(some.integers(1, 30), max_size=2))
    tables = tuple(table(count, draw(some.integers(1, 4)), f"table-{k}") for k, count in enumerate(rows))
    return Contents(tuple(panels), tables, draw(some.sampled_from([None, SAID])))


def boxes(one: Composition, page: Page) -> list[Field]:
    found = [*(spot.box for spot in one.spots.values()), *one.blocks.values(), page.block]
    for own, corner, setting in one.tables:
        wide, high = own.size(setting)
        found.append(Field(corner.real, corner.imag - high, corner.real + wide, corner.imag))
    return found if one.notes is None else [*found, one.notes]


def lines(content: Contents, one: Composition) -> list[Field]:
    """The boxes of headings, and of what stands under them."""
    found = [*one.blocks.values(), *([] if one.notes is None else [one.notes])]
    for panel in content.panels:
        if isinstance(panel.item, Picture) and panel.item.name in one.spots:
            box, half = one.spots[panel.item.name].box, panel.item.heading / 2
            found.append(box._replace(top=box.top - MARGINS.above))
            found.append(Field(box.centre.real - half, box.top - MARGINS.above, box.centre.real + half, box.top))
    return found


@given(anything(), some.sampled_from(PAGES))
@examples(1, 40)
def test_all_is_shown_once_in_order_inside_the_frame_and_on_nothing_else(content: Contents, page: Page) -> None:
    sheets = compose(content, page)
    for one in sheets:
        assert all(inside(box, page.field) for box in boxes(one, page))
        assert all(apart(*pair) for pair in combinations(boxes(one, page), 2))
        assert all(apart(inked, place) for inked in lines(content, one) for place in page.taken)
    figures = [panel.item.name for panel in content.panels if isinstance(panel.item, Picture)]
    assert [name for one in sheets for name in one.spots] == figures
    rows = {own.name: list(own.lines) for own in content.tables}
    assert {name: [line for one in sheets for own in one.tables if own.table.name == name for line in own.table.lines]
            for name in rows} == rows  # fmt: skip
    assert sum(one.notes is not None for one in sheets) == (content.notes is not None)
    assert compose(content, page) == sheets


@given(anything(), some.sampled_from(PAGES))
@examples(2, 40)
def test_all_can_be_read_and_those_of_one_scale_share_it_if_they_can(content: Contents, page: Page) -> None:
    spots = {name: spot for one in compose(content, page) for name, spot in one.spots.items()}
    pictures = {panel.item.name: panel for panel in content.panels if isinstance(panel.item, Picture)}
    for name, panel in pictures.items():
        assert isinstance(panel.item, Picture)
        assert panel.item.extent(spots[name].scale) >= LEAST * (1 - 1e-9)
    keyed = [spots[name].scale.mu for name, panel in pictures.items() if panel.scale]
    for name, panel in pictures.items():
        if panel.scale and isinstance(panel.item, Picture) and spots[name].scale.mu != max(keyed):
            assert max(panel.item.wide, panel.item.high) / max(keyed) < LEAST  # not to be read at the common one


def test_a_scale_of_its_own_enlarges_a_figure_as_far_as_the_others_and_no_further() -> None:
    """A twentieth as large, it can be read at no scale at which the other fits; it need not be as small as it may."""
    large, small = (
        figure(*one)._replace(letter="v", unit="m/s") for one in (("large", 1.0, 0.5), ("small", 0.05, 0.03))
    )
    (one,) = compose(Contents(tuple(Panel(item, scale="a") for item in (large, small))), Page("A1"))
    assert 2 * LEAST < small.extent(one.spots["small"].scale) <= large.extent(one.spots["large"].scale)


@pytest.mark.parametrize("page", rows(PAGES, 8), ids=lambda page: f"{page.name}-{page.orientation}-{page.standard}")
def test_what_belongs_together_is_not_mixed_with_what_does_not(page: Page) -> None:
    panels = [panel for k in range(3) for panel in group(k, 0.3 + 0.1 * k, 0.2)]
    for one in compose(Contents(tuple(panels), (table(8),), SAID), page):
        places = {**{name: spot.box for name, spot in one.spots.items()}, **one.blocks}
        for k in range(3):
            own = [box for name, box in places.items() if name.endswith(f"-{k}")]
            others = [box for name, box in places.items() if not name.endswith(f"-{k}")]
            around = Field(min(box.left for box in own), min(box.bottom for box in own),
                           max(box.right for box in own), max(box.top for box in own)) if own else None  # fmt: skip
            assert around is None or len(own) < 3 or all(apart(around, other) for other in others)


@pytest.mark.parametrize("page", rows([Page("A1"), Page("A2"), Page("A3")], 3), ids=lambda page: page.name)
@pytest.mark.parametrize("size", rows([(0.5, 0.3), (1.5, 0.4), (0.3, 0.9)], 3))
def test_the_foremost_figure_takes_a_third_of_its_sheet_or_the_next_scale_is_too_large(
    page: Page, size: tuple[float, float]
) -> None:
    main = figure("main", *size)
    plans = [Panel(figure(f"plan-{k}", 1.0 + 0.2 * k, 0.7)) for k in range(4)]
    first = compose(Contents((Panel(main, 1.5, share=1 / 3), *plans), (table(8),), SAID), page)[0]
    (box, scale), field, block = first.spots["main"], page.field, page.block
    free = Field(field.left + 6.0, field.bottom + 6.0, field.right - 6.0, page.taken[-1].bottom - 6.0)
    beside, above = (block.left - free.left, free.height), (free.width, free.top - block.top)
    larger = {rung.scale.mu for room in (beside, above) for rung in main.rungs(*room, page.standard)}
    assert box.width * box.height >= field.width * field.height / 3 or scale.mu <= sorted(larger)[1]


@pytest.mark.parametrize("count", rows([2, 3, 5], 3))
def test_a_table_longer_than_a_sheet_is_continued_on_the_next(count: int) -> None:
    sheets = compose(Contents((Panel(figure("a", 1.0, 1.0)),), (table(150 * count),)), Page("A3"))
    rows = [len(own.table.lines) for one in sheets for own in one.tables]
    assert sum(rows) == 150 * count and len(rows) > 1


def test_a_heading_wider_than_the_paper_is_told() -> None:
    with pytest.raises(SheetError, match=r"A4 has no room for the figure scheme.*take a larger format"):
        compose(Contents((Panel(figure("scheme", 1.0, 1.0, heading=300.0)),)), Page("A4"))


def test_every_file_of_a_figure_measures_and_draws_it_alike() -> None:
    for name in FIGURES:
        module = importlib.import_module(name)
        draw = getattr(module, "draw", None)
        if draw is not None and draw.__module__ == name:
            assert _asked(draw)[-2:] == ["spot", "drafting"], name
            assert _asked(module.measure)[-1] == "drafting", name
            assert {"lines", "letter"} <= {*dir(_returned(draw)), *_returned(draw).__annotations__}, name


def _asked(act: Callable[..., object]) -> list[str]:
    """List what must be given to draw a figure."""
    every = inspect.signature(act).parameters.values()
    return [one.name for one in every if one.default is inspect.Parameter.empty]


def _returned(draw: object) -> type:
    return inspect.get_annotations(draw, eval_str=True)["return"]  # type: ignore[arg-type, no-any-return]
