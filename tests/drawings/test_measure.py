"""Measuring: what a pen wrote is read back; what an editor moved is put right; what a stranger forged is refused."""

import cmath
import math
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drawings.commands.measure import lines
from drawings.paper.limits import QUANTUM, SheetRefused
from drawings.paper.strokes import Circle, Fill, Group, Leaf, Line, numeral, stated
from drawings.pens.svg import BEARERS, numbers, svg
from drawings.reading import pathdata
from drawings.reading.marks import KINDS, MarkKey
from drawings.reading.measure import check, measure, measure_file
from drawings.reading.transform import Affine, transform
from tests.parts import examples

WIDTH, HEIGHT = 420, 297
HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="420mm" height="297mm" viewBox="0 0 420 297">'
LOOK = 'stroke="#000" fill="none"'
DATA = (
    'data-kind="vector" data-plan="v" data-quantity="v" data-name="B" data-value="3 4" data-scale="1" data-unit="m/s"'
)
LINE = f'<line {DATA} {LOOK} x1="10" y1="20" x2="13" y2="16"/>'
CORNERS = (5 + 5j, 415 + 5j, 5 + 292j)

places = st.builds(complex, st.floats(5, 415), st.floats(5, 292))
scales = st.floats(-3, 3).map(lambda power: 10.0**power)


def vector(start: complex, end: complex, scale: float, name: str = "B", value: complex | None = None) -> Group:
    true = (end - start) * scale if value is None else value
    data = {"kind": "vector", "plan": "v", "quantity": "v", "name": name, "position": "3"}
    data |= {"value": stated(true), "unit": "m/s", "scale": numeral(scale)}
    return Group((Line(start, end), Fill((end, end + 1, end + 1j))), data=data)


def point(at: complex, pole: complex, scale: float, name: str = "A", kind: str = "point") -> Group:
    data = {"kind": kind, "plan": "p", "quantity": "r", "name": name, "unit": "m"}
    data |= {"value": stated((at - pole) * scale + 1 - 2j), "scale": numeral(scale)}
    return Group((Circle(at, 0.7),), data=data)


def corners() -> tuple[Group, ...]:
    return tuple(Group((Circle(at, 0.5),), data={"kind": "corner", "value": stated(at)}) for at in CORNERS)


def sheet(*parts: Group) -> bytes:
    return svg(Leaf(WIDTH, HEIGHT, (Group(parts, "figure"), Group(corners(), "corners")), metadata={"sheet": "v"}))


def bare(*parts: str, head: str = HEAD) -> bytes:
    return f"{head}{''.join(parts)}</svg>".encode()


def wrapped(source: bytes, attributes: str) -> bytes:
    """Put the whole drawing into one group, as an editor does when everything is selected and moved."""
    text = source.decode()
    start, end = text.index("</metadata>") + len("</metadata>"), text.index('<metadata id="seal"')
    return f"{text[:start]}<g {attributes}>{text[start:end]}</g>{text[end:]}".encode()


# Round trips


@examples(13, 200)
@given(st.lists(st.tuples(places, places), min_size=1, max_size=6), scales)
def test_vectors_and_points_are_read_back(ends: list[tuple[complex, complex]], scale: float) -> None:
    parts = [vector(a, b, scale, f"B{k}") for k, (a, b) in enumerate(ends)]
    parts += [point(a, 7 + 9j, scale, f"A{k}") for k, (a, _) in enumerate(ends)]
    measured = measure(sheet(*parts, point(7 + 9j, 7 + 9j, scale, "p", "pole")))
    assert check(measured) == []
    assert [mark.name for mark in measured.vectors] == [f"B{k}" for k in range(len(ends))]
    assert measured.vectors[0].position == 3
    assert measured.points[0].position is None
    assert measured.metadata == {"format": 1, "sheet": "v"}
    for mark, (a, b) in zip(measured.vectors, ends, strict=True):
        assert abs(mark.start - a) <= QUANTUM / 2 + 1e-12
        assert abs(mark.value - (b - a) * scale) <= QUANTUM * scale * (1 + 1e-6)


def similarity(draw: st.DrawFn) -> tuple[str, Affine]:
    kind = draw(st.sampled_from(["translate", "rotate", "rotate about", "scale", "matrix"]))
    x, y, angle = (round(draw(st.floats(-300, 300)), 3) for _ in range(3))
    size = round(draw(st.floats(0.5, 2)), 6)
    turn = cmath.rect(size, math.radians(angle))
    match kind:
        case "translate":
            text = f"translate({x},{y})"
        case "rotate":
            text = f"rotate({angle})"
        case "rotate about":
            text = f"rotate({angle} {x} {y})"
        case "scale":
            text = f"scale({size})"
        case _:
            text = f"matrix({turn.real!r} {turn.imag!r} {-turn.imag!r} {turn.real!r} {x} {y})"
    return text, transform(text)


@st.composite
def moves(draw: st.DrawFn) -> list[tuple[str, Affine]]:
    return [similarity(draw) for _ in range(draw(st.integers(1, 6)))]


@examples(6)
@given(places, places, moves())
def test_a_sheet_moved_as_a_whole_keeps_its_values(a: complex, b: complex, moved: list[tuple[str, Affine]]) -> None:
    source = sheet(vector(a, b, 0.01), point(a, b, 0.01), point(b, b, 0.01, "p", "pole"))
    for text, _ in moved:
        source = wrapped(source, f'transform="{text}"')
    measured = measure(source)
    assert check(measured) == []
    assert abs(measured.vectors[0].start - a) < measured.quantum
    assert measured.vectors[0].name == "B"


@examples(6)
@given(places, places, moves())
def test_a_group_moved_there_and_back_keeps_its_values(a: complex, b: complex, moved: list[tuple[str, Affine]]) -> None:
    there = " ".join(text for text, _ in moved)
    total = transform(there)
    p = 1 / total.p
    t = -total.t / total.p
    back = f"matrix({p.real!r} {p.imag!r} {-p.imag!r} {p.real!r} {t.real!r} {t.imag!r})"
    measured = measure(wrapped(sheet(vector(a, b, 0.01)), f'transform="{there} {back}"'))
    assert check(measured) == []


def test_a_turned_sheet_is_turned_back() -> None:
    measured = measure(wrapped(sheet(vector(10 + 10j, 20 + 10j, 1)), 'transform="rotate(90)"'))
    assert measured.vectors[0].value == pytest.approx(10 + 0j)
    assert measured.quantum == pytest.approx(4 * QUANTUM)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("scale(-1,1)", "mirrored"),
        ("scale(1,0.97)", "stretched"),
        ("matrix(1 0 0.01 1 0 0)", "stretched"),
        ("skewX(3)", "stretched"),
        ("scale(1.0001 1)", "stretched"),
    ],
)
def test_a_stretched_or_mirrored_sheet_is_refused(text: str, reason: str) -> None:
    with pytest.raises(SheetRefused, match=reason):
        measure(wrapped(sheet(vector(10 + 10j, 20 + 30j, 1)), f'transform="{text}"'))


def test_a_lost_corner_is_refused() -> None:
    source = sheet(vector(10 + 10j, 20 + 30j, 1))
    with pytest.raises(SheetRefused, match="2 of the 3 corner"):
        measure(re.sub(rb'<circle[^>]*data-value="5 5"[^>]*/>', b"", source))


# Editors


@pytest.mark.parametrize(
    "drawn",
    [
        f'<path {DATA} {LOOK} d="M 10,20 L 13,16"/>',
        f'<path {DATA} {LOOK} d="m10 20 3-4"/>',
        f'<path {DATA} {LOOK} d="m 10,20 3,-4 z"/>',
        f'<path {DATA} {LOOK} d="M10 20l3-4"/>',
        f'<polyline {DATA} {LOOK} points="10,20 13 16"/>',
        f'<line {DATA} style="stroke:#000000;stroke-width:.5" x1="10" y1="20" x2="13" y2="16"/>',
        f'<line {DATA} {LOOK} x1="1e1" y1="+20." x2="13" y2=" 16 "/>',
        f'<g style="transform:translate(10px, 20px)"><line {DATA} {LOOK} x2="3" y2="-4"/></g>',
        f'<g transform="rotate(180)" transform-origin="10px 20px"><line {DATA} {LOOK} x1="10" y1="20" x2="7" y2="24"/>'
        "</g>",
        f'<g visibility="hidden"><line {DATA} {LOOK} visibility="visible" x1="10" y1="20" x2="13" y2="16"/></g>',
        f"<switch><g><a>{LINE}</a></g></switch>",
    ],
)
def test_forms_that_editors_write(drawn: str) -> None:
    measured = measure(bare(drawn))
    assert measured.vectors[0].value == pytest.approx(3 + 4j)
    assert measured.vectors[0].start == pytest.approx(10 + 277j)


def test_horizontal_and_vertical_paths() -> None:
    data = DATA.replace("3 4", "3 0")
    assert measure(bare(f'<path {data} {LOOK} d="M1 2h3"/>')).vectors[0].value == 3
    assert measure(bare(f'<path {data} {LOOK} d="M1 2H4"/>')).vectors[0].value == 3
    assert measure(bare(f'<path {data} {LOOK} d="M1 2v3"/>')).vectors[0].value == -3j
    assert measure(bare(f'<path {data} {LOOK} d="M1 2V5z"/>')).vectors[0].value == -3j


@pytest.mark.parametrize(
    ("size", "factor"),
    [
        ('width="210mm" height="148.5mm"', 0.5),
        ('width="42cm" height="29.7cm"', 1),
        ('width="42in" height="29.7in"', 2.54),
        ('width="420pt" height="297pt"', 25.4 / 72),
        ('width="420pc" height="297pc"', 25.4 / 6),
        ('width="420px" height="297px"', 25.4 / 96),
        ('width="420" height="297"', 25.4 / 96),
        ('width="100%" height="100%"', 25.4 / 96),
        ("", 25.4 / 96),
        ('width="420mm" height="400mm"', 1),
    ],
)
def test_units_and_view_box(size: str, factor: float) -> None:
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 420 297">'
    assert measure(bare(LINE, head=head)).vectors[0].value == pytest.approx((3 + 4j) * factor)


def test_a_page_fitted_in_one_direction_is_refused() -> None:
    source = sheet(vector(10 + 10j, 20 + 30j, 1))
    fitted = source.replace(b'width="420mm"', b'width="400mm" preserveAspectRatio="none"')
    with pytest.raises(SheetRefused, match="stretched"):
        measure(fitted)
    assert check(measure(source.replace(b'width="420mm"', b'width="400mm"'))) == []


def test_another_prefix_and_foreign_elements() -> None:
    text = (
        '<s:svg xmlns:s="http://www.w3.org/2000/svg" xmlns:i="urn:editor" width="420mm" height="297mm" '
        'viewBox="0 0 420 297" i:version="1"><i:view><i:grid/></i:view><s:g i:label="v" i:groupmode="layer">'
        + LINE.replace("<line", "<s:line")
        + "</s:g></s:svg>"
    )
    assert check(measure(text.encode())) == []


@pytest.mark.parametrize(
    "drawn",
    [
        '<circle {} cx="10" cy="20" r="1"/>',
        '<ellipse {} cx="10" cy="20" rx="1" ry="2"/>',
        '<path {} d="M 11,20 a 1,1 0 0 1 -1,1 1,1 0 0 1 -1,-1 1,1 0 0 1 1,-1 1,1 0 0 1 1,1 z"/>',
        '<path {} d="m11 20a1 1 0 11-2 0 1 1 0 112 0z"/>',
        '<path {} d="M11 20C11 20.5523 10.5523 21 10 21 9.4477 21 9 20.5523 9 20'
        ' 9 19.4477 9.4477 19 10 19 10.5523 19 11 19.4477 11 20Z"/>',
    ],
)
def test_points_however_the_circle_is_written(drawn: str) -> None:
    data = 'data-plan="p" data-quantity="r" data-name="A" data-scale="2" stroke="#000"'
    pole = f'<circle {data} data-kind="pole" data-value="1 1" cx="8" cy="20" r="1"/>'
    measured = measure(bare(pole, drawn.format(f'{data} data-kind="point" data-value="5 1"')))
    assert measured.points[0].value == pytest.approx(5 + 1j)
    assert check(measured) == []


@pytest.mark.parametrize(
    "drawn",
    [
        f"<defs>{LINE}</defs>",
        f'<symbol id="s">{LINE}</symbol><use href="#s"/>',
        f'<g display="none">{LINE}</g>',
        f'<g style="display : none">{LINE}</g>',
        f'<g style="display:none !important">{LINE}</g>',
        f'<g visibility="hidden">{LINE}</g>',
        f'<g opacity="0">{LINE}</g>',
        f'<g opacity="0.0%">{LINE}</g>',
        f'<g clip-path="url(#c)">{LINE}</g>',
        f'<g transform="scale(0)">{LINE}</g>',
        f'<g transform="scale(1 0)">{LINE}</g>',
        LINE.replace('stroke="#000"', 'stroke="none"'),
        LINE.replace('stroke="#000"', ""),
        LINE.replace('stroke="#000"', 'stroke="#00000000"'),
        LINE.replace('stroke="#000"', 'stroke="#000" stroke-width="0"'),
        LINE.replace('stroke="#000"', 'stroke="#000" stroke-opacity="0"'),
        LINE.replace('stroke="#000"', 'stroke="#000" style="stroke:transparent"'),
        f'<x:g xmlns:x="urn:other">{LINE}</x:g>',
        LINE.replace("<line", '<line xmlns="urn:other"'),
    ],
)
def test_what_cannot_be_seen_is_not_counted(drawn: str) -> None:
    measured = measure(bare(drawn))
    assert measured.vectors == ()
    assert measured.notes != () or "urn:other" in drawn
    assert [wrong.measured for wrong in check(measured, expected=[MarkKey("v", "v", "B")])] == [None]


# Seeded faults


def test_an_end_three_quanta_off_is_a_mismatch() -> None:
    for turn in range(16):
        start, end = 10.00005 + 20.00005j, 110.4321987 + 77.7654321j
        shift = cmath.rect(3 * QUANTUM, turn * math.pi / 8)
        source = sheet(vector(start, end + shift, 0.02, value=(end - start) * 0.02))
        assert [wrong.key for wrong in check(measure(source))] == [MarkKey("v", "v", "B", 3)]


def test_a_swapped_sign_a_wrong_scale_and_a_lost_vector_are_mismatches() -> None:
    a, b = 10 + 20j, 110 + 77j
    assert check(measure(sheet(vector(a, b, 1, value=a - b))))
    assert check(measure(sheet(vector(a, b, 1, value=(b - a).conjugate()))))
    assert check(measure(sheet(vector(a, b, 1, value=2 * (b - a)))))
    assert check(measure(sheet(vector(b, a, 1, value=b - a))))
    measured = measure(sheet(vector(a, b, 1)))
    assert check(measured, expected=[MarkKey("v", "v", "B", 3)]) == []
    assert check(measured, expected=[MarkKey("v", "v", "C", 3)]) != []
    assert check(measured, tolerance=math.nan) != []


def test_a_point_off_its_place_is_a_mismatch() -> None:
    pole = point(7 + 9j, 7 + 9j, 0.5, "p", "pole")
    good = point(50 + 60j, 7 + 9j, 0.5)
    assert check(measure(sheet(good, pole))) == []
    [wrong] = check(measure(sheet(Group((Circle(50 + 60j + 3 * QUANTUM, 1),), data=good.data), pole)))
    assert wrong.key == MarkKey("p", "r", "A")


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        (' data-name="B"', "", "no data-name"),
        ('data-name="B"', 'data-name=""', "no data-name"),
        (' data-plan="v"', "", "no data-plan"),
        ('data-value="3 4"', 'data-value="3"', "not a pair"),
        ('data-value="3 4"', 'data-value="nan 4"', "not a number"),
        ('data-scale="1"', 'data-scale="0"', "scale"),
        ('data-scale="1"', 'data-scale="-1"', "scale"),
        ('data-scale="1"', "", "scale"),
        ("<line", '<line data-position="1.5"', "position"),
        ("<line", '<line data-position="١"', "position"),
    ],
)
def test_a_vector_without_its_data_is_refused(old: str, new: str, reason: str) -> None:
    assert old in LINE
    with pytest.raises(SheetRefused, match=reason):
        measure(bare(LINE.replace(old, new)))


def test_one_name_twice_is_refused() -> None:
    with pytest.raises(SheetRefused, match="twice"):
        measure(bare(LINE, LINE.replace('x1="10"', 'x1="11"')))
    with pytest.raises(SheetRefused, match="twice"):
        measure(bare('<g id="a"/><g id="a"/>'))
    double = [LINE.replace("<line", f'<line data-position="{text}"') for text in ("0", "00")]
    with pytest.raises(SheetRefused, match="twice"):
        measure(bare(*double))


def test_a_point_without_a_pole_is_refused() -> None:
    with pytest.raises(SheetRefused, match="no pole"):
        measure(sheet(point(1 + 1j, 0j, 1)))


# Files


def test_files(tmp_path: Path) -> None:
    path = tmp_path / "sheet.svg"
    path.write_bytes(sheet(vector(10 + 10j, 20 + 30j, 1)))
    assert check(measure_file(path)) == []
    for bad in (tmp_path, tmp_path / "missing", Path("/dev/zero"), Path("nul\0")):
        with pytest.raises(OSError) as caught:  # the system's fault, and not the sheet's
            measure_file(bad)
        assert caught.value.filename == str(bad)


def test_the_pen_writes_what_the_reader_reads() -> None:
    assert tuple(BEARERS) == KINDS
    assert pathdata.numbers(numbers("%s %s", (1e-7, -123.4567))) == [0, -123.4567]


def test_the_table_is_in_the_words_of_the_scene() -> None:
    drawn = vector(10 + 20j, 13 + 24j, 0.5)
    far = drawn._replace(data=drawn.data | {"value": "9 9"})
    measured = measure(sheet(far._replace(data=far.data | {"plan": "velocities", "unit": "m/s"})))
    off = {miss.key for miss in check(measured)}
    assert list(lines(measured, off, "ru")) == [
        "план скоростей    3  B          (1,5; 2)                   м/с    ОТЛИЧАЕТСЯ от заявленного"
    ]
    assert list(lines(measured, (), "en")) == ["velocities        3  B          (1.5, 2)                   m/s"]
