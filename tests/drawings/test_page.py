"""The page: formats by both standards, margins, folds, frames; form 1, ISO 7200; lettering that keeps to its graphs."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drawings.commands.cli import main
from drawings.lettering.lettering import bounds, lettered
from drawings.page.frame import FOLDS
from drawings.page.page import Page, page_of
from drawings.paper.strokes import Group, Leaf, Line, Polyline, SheetError
from drawings.pens.svg import svg
from plans.scene.scene import parse_scene
from tests.drawings.pages import (
    ENTRIES,
    apart,
    around,
    bare,
    every_page,
    flat,
    inked,
    inside,
    lines,
    named,
    said,
    texts,
)
from tests.parts import examples
from tests.plans.scenes import scene


@every_page
def test_every_page_is_written_and_nothing_of_it_lies_beyond_the_paper(page: Page) -> None:
    group = bare(page)
    assert inside(bounds(group), (0, 0, *page.size))
    assert all(inside(inked(text), (0, 0, *page.size)) for text in texts(group))
    frame, corners, block = group.strokes
    assert isinstance(frame, Group) and isinstance(corners, Group) and isinstance(block, Group)
    written = svg(lettered(Leaf(*page.size, (frame, corners, block))))
    assert f'width="{page.size[0]:g}mm"'.encode() in written


@every_page
def test_the_control_bar_is_a_hundred_millimetres_long_in_the_file(page: Page) -> None:
    written = svg(lettered(Leaf(*page.size, (page.frame(),)))).decode()
    bar = re.search(r'<g data-length="100" id="control-bar">(.*?)</g>', written, re.DOTALL)
    assert bar is not None
    foot = re.search(r'<line [^>]*x1="([\d.]+)" x2="([\d.]+)" y1="([\d.]+)" y2="([\d.]+)"', bar[1])
    assert foot is not None
    x1, x2, y1, y2 = (float(number) for number in foot.groups())
    assert x1 == x2 and y1 - y2 == 100
    assert ("100 мм" if page.language == "ru" else "100 mm") in said(page.frame())


words = st.text(alphabet="АЁЙЩруфцщghjpyQÅ1,.;:()/ ", min_size=1, max_size=60).map(str.strip).filter(bool)


@pytest.mark.parametrize("standard", ["GOST", "ISO"])
@examples(8, 40)
@given(st.dictionaries(st.sampled_from(sorted(set(ENTRIES["ru"]) - {"sheet", "sheets"})), words), st.integers(1, 99))
def test_whatever_is_filled_in_keeps_to_its_graph(standard: str, entries: dict[str, str], sheets: int) -> None:
    page = Page("A1", standard=standard, language="ru")
    block = page.title_block(entries | {"sheet": str(sheets), "sheets": str(sheets)}, "ru")
    held_to_its_graphs(block)


FREE = 0.15  # mm of paper between letters and any line, so that no pen joins them


def held_to_its_graphs(block: Group) -> None:
    walls = [around((complex(*wall[:2]), complex(*wall[2:])), FREE) for wall, _ in lines(block)]
    boxes = [inked(text) for text in texts(block)]
    assert all(apart(box, wall) for box, wall in itertools.product(boxes, walls))
    assert all(apart(a, b) for a, b in itertools.combinations(boxes, 2))


@every_page
@pytest.mark.parametrize("title", ["Поперечно-строгальный станок", "Механизм долбёжного станка с качающейся кулисой"])
@pytest.mark.parametrize(
    "subtitle", ["Кинематическое исследование механизма", "Force analysis of the mechanism", "Синтез кулачка «ABC»"]
)
def test_a_title_and_its_subtitle_stand_whole_and_large_enough(page: Page, title: str, subtitle: str) -> None:
    block = page.title_block(ENTRIES["ru"] | {"title": title, "subtitle": subtitle}, "ru")
    held_to_its_graphs(block)
    assert {*title.split(), *subtitle.split()} <= {*" ".join(text.plain for text in texts(block)).split()}
    (size,) = {text.size for text in texts(block) if text.plain in subtitle and len(text.plain) > 4}
    assert size >= 3.5
    walls = [(wall[0] - 1, wall[1], wall[2] + 1, wall[3]) for wall, _ in lines(block) if wall[2] - wall[0] < 1]
    named = (inked(text) for text in texts(block) if text.plain in (title, subtitle))
    assert all(apart(box, wall) for box in named for wall in walls)


# ---- formats, frames and folds

FIELDS = [  # inside the frame: width and height, mm
    ("A4", "portrait", "GOST", 185, 287), ("A3", "landscape", "GOST", 395, 287), ("A2", "landscape", "GOST", 569, 410),
    ("A1", "landscape", "GOST", 816, 584), ("A1", "portrait", "GOST", 569, 831), ("A4", "portrait", "ISO", 180, 277),
    ("A3", "landscape", "ISO", 390, 277), ("A2", "landscape", "ISO", 564, 400), ("A1", "landscape", "ISO", 811, 574),
]  # fmt: skip


@pytest.mark.parametrize(("name", "orientation", "standard", "width", "height"), FIELDS)
def test_the_drawing_space_is_the_standard_s(
    name: str, orientation: str, standard: str, width: float, height: float
) -> None:
    page = Page(name, orientation, standard)
    assert (page.field.width, page.field.height) == (width, height)
    assert page.field.left == 20
    frames = [bounds(one) for one in flat(page.frame()) if isinstance(one, Polyline)]
    assert tuple(page.field) in frames


@pytest.mark.parametrize(
    ("name", "orientation", "standard", "advice"),
    [
        ("A4", "landscape", "GOST", "take A3"),
        ("A4", "landscape", "ISO", "take A3"),
        ("A3", "portrait", "ISO", 'write standard = "GOST"'),
        ("A1", "portrait", "ISO", 'write standard = "GOST"'),
    ],
)
def test_an_orientation_that_the_standard_lacks_is_refused_with_advice(
    name: str, orientation: str, standard: str, advice: str
) -> None:
    with pytest.raises(SheetError, match=re.escape(advice)):
        Page(name, orientation, standard)


SCENE = scene(
    frame="O = [0, 0]; C = [0.35, 0]", links="OA AB CB", lengths="OA = 0.1; AB = 0.4; CB = 0.3",
    sketch="B = [0.39, 0.30]", drive="link = 1; speed = 10",
)  # fmt: skip


def test_the_scene_s_sheet_table_makes_the_page() -> None:
    table = '[sheet]\nformat = "A3"\nstandard = "ISO"\nlanguage = "ru"\ndesignation = "ТММ.01"\n'
    page = page_of(parse_scene(SCENE + table))
    assert page == Page("A3", "landscape", "ISO", "ru", "ТММ.01")
    assert page_of(parse_scene(SCENE + '[sheet]\nformat = "A4"\n')).orientation == "portrait"


def test_a_scene_that_asks_for_an_a4_lying_down_is_told_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    crank = tmp_path / "crank.toml"
    crank.write_text(SCENE + '[sheet]\nformat = "A4"\norientation = "landscape"\n')
    assert main(["draw", str(crank), "-o", str(tmp_path / "out")]) == 3
    told = capsys.readouterr().err
    assert "crank.toml:19:1: sheet.orientation = landscape: expected portrait" in told and "Fix: " in told
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("width", "panels"),
    [
        (841, [210, 125.5, 125.5, 190, 190]), (594, [210, 192, 192]), (420, [125, 105, 190]),
        (297, [63.5, 43.5, 190]), (210, [210]),
    ],
)  # fmt: skip
def test_sheets_are_folded_to_a4_as_din_824_form_a_folds_them(width: float, panels: list[float]) -> None:
    ends = [0.0, *FOLDS[width], width]
    assert [b - a for a, b in itertools.pairwise(ends)] == panels


@pytest.mark.parametrize(
    ("page", "across", "up"),
    [
        (Page("A1"), {210, 335.5, 461, 651}, {297}), (Page("A1", "portrait"), {210, 402}, {297, 594}),
        (Page("A2"), {210, 402}, {297}), (Page("A3"), {125, 230}, set()),
        (Page("A3", "portrait"), {63.5, 107}, {297}), (Page("A2", standard="ISO"), {210, 402}, {297}),
    ],
)  # fmt: skip
def test_folding_marks_stand_at_the_edges_where_the_folds_are(page: Page, across: set[float], up: set[float]) -> None:
    marks = [one for one in flat(named(page.frame(), "folding-marks")) if isinstance(one, Line)]
    assert {mark.start.real for mark in marks if mark.start.real == mark.end.real} == across
    assert {mark.start.imag for mark in marks if mark.start.imag == mark.end.imag} == up


@pytest.mark.parametrize(("name", "long", "short"), [("A1", 16, 12), ("A2", 12, 8), ("A3", 8, 6), ("A4", 6, 4)])
def test_the_grid_of_iso_5457_has_the_standard_s_number_of_fields_of_50_mm(name: str, long: int, short: int) -> None:
    page = Page(name, standard="ISO")
    columns, rows = (short, long) if name == "A4" else (long, short)
    plain = said(named(page.frame(), "borders"))
    sides = 1 if name == "A4" else 2  # A4 has letters on the right and numerals at the top only
    numerals, letters = [p for p in plain if p.isdigit()], [p for p in plain if len(p) == 1 and p.isalpha()]
    assert sorted(map(int, numerals)) == sorted(sides * list(range(1, columns + 1)))
    assert sorted(letters) == sorted(sides * "ABCDEFGHJKLM"[:rows])
    ticks = sorted(
        {one.start.real for one in flat(named(page.frame(), "borders")) if isinstance(one, Line) and _top(one, page)}
    )
    assert len(ticks) == columns - 1
    assert {b - a for a, b in itertools.pairwise(ticks)} == {50} and ticks[columns // 2 - 1] == page.size[0] / 2


def _top(line: Line, page: Page) -> bool:
    return line.style.width == 0.35 and line.start.real == line.end.real and line.start.imag == page.field.top


def crossings(block: Group, page: Page, at: float, upright: bool) -> list[tuple[float, float]]:
    """Where lines of the block cross a level (or an upright) through it, from its left (or its foot); their widths."""
    found = set()
    for one in flat(block):
        if isinstance(one, Line):
            start, end = (p - complex(page.block.left, page.block.bottom) for p in (one.start, one.end))
            if not upright:
                start, end = (complex(p.imag, p.real) for p in (start, end))
            if start.real == end.real and min(start.imag, end.imag) < at < max(start.imag, end.imag):
                found.add((start.real, one.style.width))
    return sorted(found)


def steps(places: list[tuple[float, float]], end: float) -> list[float]:
    ends = [*(place for place, _ in places), end]
    return [b - a for a, b in itertools.pairwise(ends)]


@pytest.mark.parametrize(
    ("level", "widths"),
    [  # from the foot of the block: the widths of its graphs from the left, GOST 2.104 form 1
        (52, [7, 10, 23, 15, 10, 120]),
        (38, [7, 10, 23, 15, 10, 70, 15, 17, 18]),
        (32, [7, 10, 23, 15, 10, 70, 5, 5, 5, 17, 18]),
        (22, [17, 23, 15, 10, 70, 5, 5, 5, 17, 18]),
        (17, [17, 23, 15, 10, 70, 20, 30]),
        (7, [17, 23, 15, 10, 70, 50]),
    ],
)
def test_the_graphs_of_form_1_are_as_wide_as_the_standard_has_them(level: float, widths: list[float]) -> None:
    page = Page("A3")
    block = page.title_block({}, "ru")
    assert steps(crossings(block, page, level, True), 185) == widths
    assert sum(widths) == 185


@pytest.mark.parametrize(
    ("across", "heights"), [(30, [5] * 11), (100, [15, 25, 15]), (137, [15, 5, 15, 5, 15]), (160, [15, 5, 15, 5, 15])]
)
def test_the_graphs_of_form_1_are_as_high_as_the_standard_has_them(across: float, heights: list[float]) -> None:
    page = Page("A3")
    places = crossings(page.title_block({}, "ru"), page, across, False)
    assert steps([(0.0, 0.5), *places], 55.0)[: len(heights)] == heights  # the foot is the frame's own line
    assert sum(heights) == 55


def test_a_date_is_written_as_gost_writes_it_and_by_iso_as_it_is_given() -> None:
    assert "21.11.26" in said(Page("A1").title_block({"date": "2026-11-21"}, "ru"))
    assert "2026-11-21" in said(Page("A1", standard="ISO").title_block({"date": "2026-11-21"}, "en"))
