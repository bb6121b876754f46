"""The page: every format by both standards, its margins, folds and frames; lettering that keeps to its graphs."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drawings.commands.cli import main
from drawings.lettering.extent import bounds
from drawings.lettering.lettering import SIZES, lettered
from drawings.page.frame import FOLDS
from drawings.page.page import Page, page_of
from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, Polyline, SheetError
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
def test_no_letter_of_a_page_touches_a_line_or_another_text(page: Page) -> None:
    group = bare(page)
    boxes = [(text.plain, inked(text)) for text in texts(group)]
    for (plain, box), (line, _) in itertools.product(boxes, lines(group)):
        assert apart(box, line), f"{plain!r} touches a line at {line}"
    for (one, a), (other, b) in itertools.combinations(boxes, 2):
        assert apart(a, b), f"{one!r} lies on {other!r}"


@every_page
def test_nothing_is_cut_and_no_letter_is_too_small(page: Page) -> None:
    for text in texts(bare(page)):
        assert "…" not in text.plain
        small = text.plain in ("21.11.26", "Preobrazhensky", "Преображенский") and page.standard == "GOST"
        assert text.size in SIZES and text.size >= (1.8 if small else 2.5)


@every_page
def test_margins_are_clear_the_control_bar_and_the_folding_marks_stand_alone(page: Page) -> None:
    group = bare(page)
    bar = named(group, "control-bar")
    own = bounds(bar)
    assert own[0] > 4 and own[2] < page.field.left  # a printer leaves 4 mm white
    others = [box for box, _ in lines(Group(tuple(s for s in flat(group) if s not in set(flat(bar)))))]
    edge = {around((a, b), page.hand.construction / 2) for a, b in _edges(page)}
    marks = {box for box, _ in lines(named(group, "folding-marks"))} if page.name != "A4" else set()
    for box in set(others) - edge:
        grown = (own[0] - 0.4, own[1] - 0.4, own[2] + 0.4, own[3] + 0.4)
        assert apart(grown, box) or inside(grown, box)
    fills = [bounds(one) for one in flat(group) if isinstance(one, Fill | Circle | Arc)]
    for mark in marks:
        rest = [box for box in others if box not in marks and box not in edge]
        assert all(apart(mark, box) for box in (*rest, *fills, own, *(inked(text) for text in texts(group))))
        assert mark[0] < 0.5 or mark[1] < 0.5 or mark[2] > page.size[0] - 0.5 or mark[3] > page.size[1] - 0.5


def _edges(page: Page) -> Iterator[tuple[complex, complex]]:
    width, height = page.size
    corners = (0j, complex(width, 0), complex(width, height), complex(0, height))
    yield from itertools.pairwise((*corners, corners[0]))


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


@every_page
def test_the_block_stands_in_the_lower_right_corner_of_the_frame(page: Page) -> None:
    block = bounds(page.title_block(ENTRIES[page.language], page.language))
    assert block == page.block
    assert (page.block.right, page.block.bottom) == (page.field.right, page.field.bottom)
    assert all(inside(place, page.field) for place in page.taken)
    assert page.block.width == {"GOST": 185, "ISO": 180}[page.standard]


words = st.text(alphabet="АЁЙЩруфцщghjpyQÅ1,.;:()/ ", min_size=1, max_size=60).map(str.strip).filter(bool)


@pytest.mark.parametrize("standard", ["GOST", "ISO"])
@examples(8, 40)
@given(
    st.dictionaries(st.sampled_from(sorted(set(ENTRIES["ru"]) - {"sheet", "sheets"})), words),
    st.integers(1, 99),
)
def test_whatever_is_filled_in_keeps_to_its_graph(standard: str, entries: dict[str, str], sheets: int) -> None:
    page = Page("A1", standard=standard, language="ru")
    block = page.title_block(entries | {"sheet": str(sheets), "sheets": str(sheets)}, "ru")
    walls = [line for line, _ in lines(block)]
    boxes = [inked(text) for text in texts(block)]
    assert all(apart(box, wall) for box, wall in itertools.product(boxes, walls))
    assert all(apart(a, b) for a, b in itertools.combinations(boxes, 2))


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
    frame="O = [0, 0]; C = [0.35, 0]",
    links="OA AB CB",
    lengths="OA = 0.1; AB = 0.4; CB = 0.3",
    sketch="B = [0.39, 0.30]",
    drive="link = 1; speed = 10",
)


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
