"""The page by both standards: their own numbers, every format, and lettering that keeps to its graphs."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from drawings.blocks.iso7200 import CELLS, MANDATORY
from drawings.cli import main
from drawings.frame import FOLDS
from drawings.lettering import SIZES, lettered, outline
from drawings.page import Field, Page, page_of
from drawings.pens.svg import svg
from drawings.strokes import Arc, Box, Circle, Fill, Group, Leaf, Line, Polyline, SheetError, Stroke, Text, bounds
from drawings.words import word
from plans.scene import parse_scene

# Which way each standard lays a format: A4 upright only, and by ISO 5457 all others along the long side only.
LAID = [
    (name, orientation, standard)
    for name, orientation, standard in itertools.product(
        ("A1", "A2", "A3", "A4"), ("landscape", "portrait"), ("GOST", "ISO")
    )
    if (orientation == "portrait" if name == "A4" else standard == "GOST" or orientation == "landscape")
]
PAGES = [
    Page(name, orientation, standard, language, "ТММ.07.03.000")
    for (name, orientation, standard), language in itertools.product(LAID, ("en", "ru"))
]
ENTRIES = {
    "en": {
        "title": "Crank shaper", "subtitle": "Kinematics of the mechanism", "designation": "TMM.07.03.000",
        "drawn": "Ivanov A. A.", "checked": "Preobrazhensky", "approved": "Smith", "date": "2026-11-21",
        "group": "M-301", "organisation": "Technical University, Department of Mechanisms", "scale": "1:2.5",
        "sheet": "2", "sheets": "14",
    },
    "ru": {
        "title": "Поперечно-строгальный станок", "subtitle": "Кинематическое исследование механизма",
        "designation": "ТММ.07.03.000", "drawn": "Щукин Й. Ё.", "checked": "Преображенский", "approved": "Утёсов",
        "date": "21.11.2026", "group": "Группа РК5-51", "organisation": "МГТУ им. Н.Э. Баумана, кафедра ТММ",
        "scale": "1:2,5", "sheet": "1", "sheets": "1",
    },
}  # fmt: skip
every_page = pytest.mark.parametrize("page", PAGES, ids=lambda p: f"{p.name}-{p.orientation}-{p.standard}-{p.language}")


def bare(page: Page, **entries: str) -> Group:
    """Draw a page without figures."""
    block = page.title_block(ENTRIES[page.language] | entries, page.language)
    return Group((page.frame(), page.corners(), block))


def flat(stroke: Stroke) -> Iterator[Stroke]:
    if isinstance(stroke, Group):
        for inner in stroke.strokes:
            yield from flat(inner)
    else:
        yield stroke


def texts(stroke: Stroke) -> list[Text]:
    return [one for one in flat(stroke) if isinstance(one, Text)]


def said(stroke: Stroke) -> list[str]:
    return [text.plain for text in texts(stroke)]


def named(stroke: Stroke, name: str) -> Group:
    def find(group: Group) -> Iterator[Group]:
        if group.name == name:
            yield group
        for inner in group.strokes:
            if isinstance(inner, Group):
                yield from find(inner)

    assert isinstance(stroke, Group)
    return next(find(stroke))


def around(points: Iterable[complex], by: float) -> Box:
    points = list(points)
    across, up = [p.real for p in points], [p.imag for p in points]
    return min(across) - by, min(up) - by, max(across) + by, max(up) + by


def inked(text: Text) -> Box:
    """The box of the letters themselves, with tails, accents and the pen."""
    return around((point for chain in outline(text) for point in chain.points), text.size / 20)


def lines(stroke: Stroke) -> Iterator[tuple[Box, float]]:
    """Every straight piece of line with its width in its box; all of a page's lines are upright or level."""
    for one in flat(stroke):
        match one:
            case Line():
                ends = [(one.start, one.end)]
            case Polyline():
                ends = list(itertools.pairwise((*one.points, one.points[0])))
            case _:
                continue
        for start, end in ends:
            yield around((start, end), one.style.width / 2), one.style.width


def apart(a: Box, b: Box) -> bool:
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def inside(inner: Box, outer: Box) -> bool:
    return inner[0] >= outer[0] and inner[1] >= outer[1] and inner[2] <= outer[2] and inner[3] <= outer[3]


# ---- every page


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
@settings(max_examples=40)
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


def test_gost_s_borders_are_20_and_5_and_iso_s_20_and_10() -> None:
    assert Page("A1").field == Field(20, 5, 836, 589)
    assert Page("A1", standard="ISO").field == Field(20, 10, 831, 584)


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


SCENE = """
[mechanism.frame]
O = [0, 0]
C = [0.35, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "CB"
[mechanism.lengths]
OA = 0.1
AB = 0.4
CB = 0.3
[mechanism.sketch]
B = [0.39, 0.30]
[drive]
link = 1
speed = 10
"""


def test_the_scene_s_sheet_table_makes_the_page() -> None:
    table = '[sheet]\nformat = "A3"\nstandard = "ISO"\nlanguage = "ru"\ndesignation = "ТММ.01"\n'
    page = page_of(parse_scene(SCENE + table))
    assert page == Page("A3", "landscape", "ISO", "ru", "ТММ.01")
    assert page_of(parse_scene(SCENE + '[sheet]\nformat = "A4"\n')).orientation == "portrait"


def test_a_scene_that_asks_for_an_a4_lying_down_is_told_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "crank.toml"
    scene.write_text(SCENE + '[sheet]\nformat = "A4"\norientation = "landscape"\n')
    assert main(["draw", str(scene), "-o", str(tmp_path / "out")]) == 3
    told = capsys.readouterr().err
    assert "crank.toml:20:1: sheet.orientation = landscape: expected portrait" in told and "Fix: " in told
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


@every_page
def test_the_title_block_is_on_the_cover_of_the_folded_sheet(page: Page) -> None:
    last = max(FOLDS[page.size[0]], default=0.0)
    assert last <= page.block.left and page.size[0] - last <= 210


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


# ---- GOST 2.104, form 1


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
    ("across", "heights"),
    [(30, [5] * 11), (100, [15, 25, 15]), (137, [15, 5, 15, 5, 15]), (160, [15, 5, 15, 5, 15])],
)
def test_the_graphs_of_form_1_are_as_high_as_the_standard_has_them(across: float, heights: list[float]) -> None:
    page = Page("A3")
    places = crossings(page.title_block({}, "ru"), page, across, False)
    assert steps([(0.0, 0.5), *places], 55.0)[: len(heights)] == heights  # the foot is the frame's own line
    assert sum(heights) == 55


def test_thin_in_form_1_are_the_rows_and_the_cells_of_the_letter() -> None:
    page = Page("A3")
    block = page.title_block({}, "ru")
    main_line = page.hand.main
    rows = {place for place, width in crossings(block, page, 30, False) if width == main_line}
    assert rows == {30, 35, 55}
    letter = {place for place, width in crossings(block, page, 32, True) if width != main_line}
    assert letter == {140, 145}


def test_graph_7_is_empty_on_a_single_sheet_and_graph_8_on_the_following_ones() -> None:
    page = Page("A1")

    def numbers(sheet: str, sheets: str) -> list[str]:
        block = page.title_block({"sheet": sheet, "sheets": sheets}, "ru")
        return [plain for plain in said(block) if plain.isdigit()]

    assert numbers("1", "1") == ["1"]
    assert numbers("1", "4") == ["1", "4"]
    assert numbers("3", "4") == ["3"]


def place_of(group: Group, page: Page, plain: str) -> complex:
    """Where a text's middle is, from the block's lower left corner."""
    left, bottom, right, top = inked(next(text for text in texts(group) if text.plain == plain))
    return complex(left + right, bottom + top) / 2 - complex(page.block.left, page.block.bottom)


def test_names_stand_in_graph_11_beside_their_roles_in_graph_10() -> None:
    page = Page("A1", language="ru")
    block = page.title_block({"drawn": "Иванов", "checked": "Петров", "approved": "Сидоров", "date": "1.12"}, "ru")
    for role, name, row in (("Разраб.", "Иванов", 25), ("Пров.", "Петров", 20), ("Утв.", "Сидоров", 0)):
        assert 0 < place_of(block, page, role).real < 17 and 17 < place_of(block, page, name).real < 40
        assert all(row < place_of(block, page, plain).imag < row + 5 for plain in (role, name))
    assert {"Т.контр.", "Н.контр."} <= set(said(block))
    date = place_of(block, page, "1.12")
    assert 55 < date.real < 65 and 25 < date.imag < 30


def test_a_date_is_written_as_gost_writes_it_and_by_iso_as_it_is_given() -> None:
    assert "21.11.26" in said(Page("A1").title_block({"date": "2026-11-21"}, "ru"))
    assert "2026-11-21" in said(Page("A1", standard="ISO").title_block({"date": "2026-11-21"}, "en"))


@pytest.mark.parametrize(
    ("page", "left", "top", "turn"),
    [
        (Page("A1", designation="X.1"), 20, 589, 180), (Page("A4", designation="X.1"), 20, 292, 180),
        (Page("A3", "portrait", designation="X.1"), 297 - 5 - 14, 415, -90),
    ],
)  # fmt: skip
def test_graph_26_repeats_the_designation_in_the_upper_corner_turned(
    page: Page, left: float, top: float, turn: float
) -> None:
    place = page.taken[1]
    assert {place.width, place.height} == {70, 14} and (place.left, place.top) == (left, top)
    again = next(text for text in texts(page.frame()) if text.plain == "X.1")
    assert again.rotation == turn and inside(inked(again), place)


@every_page
def test_the_extra_graphs_are_gost_s_and_say_format_and_copied(page: Page) -> None:
    plain = set(said(page.frame()))
    mine = {word(page.language, "copied"), word(page.language, "format", format=page.name)}
    strip = {word(page.language, key) for key in ("original", "signed", "replaces", "duplicate")}
    assert (mine | strip <= plain) if page.standard == "GOST" else not ((mine | strip) & plain)
    if page.standard == "GOST":
        words_of_strip = [text for text in texts(page.frame()) if text.plain in strip]
        assert len(words_of_strip) == 5 and {text.rotation for text in words_of_strip} == {90}
        assert all(inked(text)[0] > 8 and inked(text)[2] < 13 for text in words_of_strip)
        assert all(inked(text)[3] < 5 + 145 for text in words_of_strip)


# ---- ISO 7200 and ISO 5457


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_fields_of_iso_7200_fill_the_block_and_have_their_captions(language: str) -> None:
    assert sum(cell.width * cell.height for cell in CELLS.values()) == 180 * 48
    fields = [(c.left, c.bottom, c.left + c.width, c.bottom + c.height) for c in CELLS.values()]
    assert all(apart(a, b) for a, b in itertools.combinations(fields, 2))
    assert all(inside(field, (0, 0, 180, 48)) for field in fields)
    page = Page("A3", standard="ISO", language=language)
    block = page.title_block(ENTRIES[language], language)
    corner = complex(page.block.left, page.block.bottom)
    for key, (left, bottom, right, top) in zip(CELLS, fields, strict=True):
        caption = word(language, f"{key} field")
        assert caption != f"{key} field"
        box = inked(next(text for text in texts(block) if text.plain == caption))
        own = (left + corner.real, bottom + corner.imag, right + corner.real, top + corner.imag)
        assert inside(box, own), caption


def test_every_mandatory_field_of_iso_7200_is_filled() -> None:
    page = Page("A3", standard="ISO")
    given = {
        "organisation": "Owner", "designation": "ID-7", "date": "2026-11-21", "sheet": "2", "sheets": "4",
        "title": "Name", "approved": "Boss", "drawn": "Maker", "type": "Diagram",
    }  # fmt: skip
    block = page.title_block(given, "en")
    shown = {
        "owner": "Owner", "number": "ID-7", "issued": "2026-11-21", "sheet": "2/4", "title": "Name",
        "approval": "Boss", "creator": "Maker", "type": "Diagram",
    }  # fmt: skip
    assert set(shown) == set(MANDATORY)
    for key, plain in shown.items():
        cell, at = CELLS[key], place_of(block, page, plain)
        assert cell.left < at.real < cell.left + cell.width and cell.bottom < at.imag < cell.bottom + cell.height


def test_a_single_sheet_is_sheet_1_of_1_by_iso_and_has_a_document_type() -> None:
    plain = said(Page("A4", standard="ISO").title_block({}, "en"))
    assert {"1/1", "Graphical analysis", "en"} <= set(plain)


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


def test_letters_of_the_grid_go_down_and_numerals_to_the_right() -> None:
    page = Page("A2", standard="ISO")
    signs = texts(named(page.frame(), "borders"))
    places = {text.plain: inked(text) for text in signs}
    assert places["A"][1] > places["B"][1] > places["H"][1] and places["1"][0] < places["2"][0] < places["12"][0]
    assert {text.size for text in signs} == {3.5}


@pytest.mark.parametrize("name", ["A1", "A2", "A3", "A4"])
def test_centring_marks_are_four_on_the_axes_and_reach_5_mm_into_the_drawing_space(name: str) -> None:
    page = Page(name, standard="ISO")
    field, (width, height) = page.field, page.size
    marks = [one for one in flat(named(page.frame(), "borders")) if isinstance(one, Line) and one.style.width == 0.7]
    assert len(marks) == 4
    upright = sorted((m for m in marks if m.start.real == m.end.real), key=lambda m: m.start.imag)
    level = sorted((m for m in marks if m.start.imag == m.end.imag), key=lambda m: m.start.real)
    assert {m.start.real for m in upright} == {width / 2} and {m.start.imag for m in level} == {height / 2}
    assert [m.end.real for m in level] == [field.left + 5, field.right - 5]
    foot = field.bottom + (0 if name == "A4" else 5)  # the block of an A4 stands there
    assert [m.end.imag for m in upright] == [foot, field.top - 5]


def test_trimming_marks_are_two_rectangles_of_10_by_5_in_each_corner() -> None:
    page = Page("A3", standard="ISO")
    fills = [bounds(one) for one in flat(page.frame()) if isinstance(one, Fill)]
    assert {(a, b, c, d) for a, b, c, d in fills if a == 0 and b == 0} == {(0, 0, 10, 5), (0, 0, 5, 10)}
    assert len(fills) == 8 and all({c - a, d - b} == {10, 5} for a, b, c, d in fills)


def test_the_frame_of_iso_5457_is_drawn_with_0_7_on_every_format() -> None:
    for name in ("A1", "A2", "A3", "A4"):
        page = Page(name, standard="ISO")
        frame = [one for one in flat(page.frame()) if isinstance(one, Polyline) and bounds(one) == page.field]
        assert [one.style.width for one in frame] == [0.7]
