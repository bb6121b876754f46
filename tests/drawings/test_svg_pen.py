"""The SVG pen: the right geometry, y turned once, and the same clean bytes on every run."""

import hashlib
import io
import math
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
import svgwrite
from hypothesis import given
from hypothesis import strategies as st

from drawings.lettering.lettering import bounds, lettered
from drawings.paper import strokes
from drawings.paper.limits import DECIMALS
from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, LineStyle, Polyline, SheetError, Stroke, Text
from drawings.pens import svg as pen
from drawings.reading.seal import sealed
from tests.parts import examples
from tests.rows import over

NS = "{http://www.w3.org/2000/svg}"
THIN = LineStyle(width=0.25)
VECTOR = {"kind": "vector", "plan": "v", "quantity": "v", "name": "v_B", "value": "1 1", "unit": "m/s", "scale": "0.1"}

places = st.floats(-1e4, 1e4)
points = st.builds(complex, places, places)


def leaf(*parts: Stroke, **kwargs: object) -> Leaf:
    return Leaf(210, 297, (Group(parts, "figure"),), **kwargs)  # type: ignore[arg-type]


def drawn(*parts: Stroke) -> list[ElementTree.Element]:
    root = ElementTree.fromstring(pen.svg(leaf(*parts)))
    figure = root.find(f"{NS}g")
    assert figure is not None
    return list(figure)


def everything() -> Leaf:
    vector = Group((Line(10 + 10j, 20 + 20j), Fill((20 + 20j, 19 + 18j, 18 + 19j))), "v_B", VECTOR, "speed of B")
    parts = (
        vector,
        Arc(100 + 100j, 20, 0, 5, THIN),
        Line(-1e-9 + 0j, 1e-7 - 1e-9j),
        Text(50 + 50j, "a^n_{BA}=2<3", rotation=30, slanted=True, anchor="middle"),
        Circle(9j, 3),
        Polyline((0j, 1 + 1j, 2 + 0j), closed=True, style=LineStyle(0.25, (4, 1.5))),
    )
    return leaf(*parts, title="План", description="& < >", metadata={"b": [1.5, "ω</x>"], "a": None})


def test_strokes_that_hide_are_not_merged() -> None:
    white = LineStyle(fill="#ffffff")
    square = Polyline((0j, 1 + 0j, 1 + 1j), closed=True, style=white)
    assert len(drawn(square, square)) == 2


def test_an_arc_may_pass_zero() -> None:
    assert Arc(0j, 1, 1.5 * math.pi, 0.5 * math.pi).sweep == pytest.approx(math.pi)
    assert Arc(0j, 1, 0, math.tau).sweep == math.tau


def written(*texts: Text) -> list[ElementTree.Element]:
    root = ElementTree.fromstring(pen.svg(lettered(leaf(*texts))))
    figure = root.find(f"{NS}g")
    assert figure is not None
    return list(figure)


def test_a_letter_off_the_paper_or_missing_is_refused() -> None:
    with pytest.raises(SheetError):
        written(Text(complex(math.nan, 0), "x"))
    for lettering in ("strokes", "text"):
        with pytest.raises(SheetError, match=r"lacks '雪' \(U\+96EA\)"):
            lettered(leaf(Group((Text(0j, "x雪"),))), lettering)


LATE = """
import sys
from drawings.pens import svg
assert not {"urllib.request", "svgwrite.data.svgparser"} & set(sys.modules)
import svgwrite
drawing = svgwrite.Drawing(debug=True)
drawing.add(drawing.path(d="M0 0L1 1", transform="rotate(30)"))
try:
    drawing.path(d="M0 0L1 1", transform="nonsense")
except (TypeError, ValueError):
    assert "svgwrite.data.svgparser" in sys.modules
    import urllib.request
    assert urllib.request.urlopen.__module__ == "urllib.request"
else:
    raise AssertionError("nonsense is taken for a transform")
"""


def test_what_svgwrite_imports_late_is_there_when_it_is_called() -> None:
    root = Path(pen.__file__).parents[2]
    subprocess.run([sys.executable, "-c", LATE], cwd=root, check=True)


@pytest.mark.parametrize("markup", ["a_", "a^", "{a}", "a}", "a_{b", "a\\"])
def test_unfinished_markup_is_refused(markup: str) -> None:
    with pytest.raises(SheetError, match="lettering"):
        strokes.runs(markup)


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=8))
def test_numbers_read_back_within_half_a_digit(values: list[float]) -> None:
    written = pen.numbers(" ".join(["%s"] * len(values)), values)
    assert re.fullmatch(r"-?\d+(\.\d*[1-9])?( -?\d+(\.\d*[1-9])?)*", written)
    assert not re.search(r"-0(?![\d.])", written)
    for text, value in zip(written.split(), values, strict=True):
        assert float(text) == round(value, DECIMALS)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_stated_numbers_keep_twelve_digits(value: float) -> None:
    text = strokes.numeral(value)
    assert "e" not in text.lower()
    assert text != "-0"
    assert float(text) == pytest.approx(value, rel=1e-11, abs=0)


@over("bad", [math.nan, math.inf, -math.inf, 1e22])
def test_no_place_on_paper_is_refused(bad: float) -> None:
    for stroke in (
        Line(complex(bad, 0), 1j),
        Circle(0j, bad),
        Polyline((0j, complex(0, bad))),
        Text(0j, "x", size=bad),
    ):
        with pytest.raises(SheetError):
            drawn(stroke)
    with pytest.raises(SheetError):
        drawn(Line(0j, 1, LineStyle(width=bad)))
    with pytest.raises(SheetError):
        pen.svg(Leaf(bad, 297, ()))
    with pytest.raises(SheetError):
        pen.svg(leaf(metadata={"x": math.nan}))


@pytest.mark.parametrize("bad", ["\0", "\x1b[31m", "\ud800", "\ufffe", "\r"])
def test_characters_that_xml_cannot_carry_are_refused(bad: str) -> None:
    for sheet in (
        leaf(Text(0j, f"v{bad}")),
        leaf(title=bad),
        leaf(metadata={"x": "ok"}, description=bad),
        leaf(Group((Line(0j, 1),), data={"name": bad})),
        leaf(Group((), title=bad)),
    ):
        with pytest.raises(SheetError):
            pen.svg(sheet)


@pytest.mark.parametrize("name", ["seal", "sheet", "figure", "1", "a b", 'a"b', "<", "-"])
def test_ids_are_ours_and_once(name: str) -> None:
    with pytest.raises(SheetError):
        pen.svg(leaf(Group((), name)))


def test_the_seal_counts_and_hashes() -> None:
    source = pen.svg(everything())
    root = ElementTree.fromstring(source)
    assert root[-1].get("id") == "seal"
    assert f'"elements": {sum(1 for _ in root.iter()) - 1},' in (root[-1].text or "")
    body = source[: source.rindex(b'<metadata id="seal">')]
    assert hashlib.sha256(body).hexdigest() in (root[-1].text or "")
    assert sealed(source)
    assert not sealed(source.replace(b"277", b"278", 1))
    assert not sealed(source[:-20])


def test_newlines_stand_only_between_groups() -> None:
    source = pen.svg(everything())
    assert b"\r" not in source
    assert source.endswith(b"</svg>\n")
    begun = (b"<?xml", b"<svg", b"<title", b"<desc", b"<metadata", b"<g ", b"</svg")
    assert all(line.startswith(begun) for line in source.splitlines())


def test_svgwrite_itself_finds_no_fault() -> None:
    """What we pass unchecked is valid by svgwrite's own tables, data- attributes apart."""
    [path] = drawn(Line(0j, 1), Arc(0j, 2, 0, 5))
    checked = svgwrite.Drawing(debug=True)
    shape = checked.path(d=path.get("d"))
    shape.update({key: value for key, value in path.attrib.items() if key != "d"})
    checked.add(shape)
    checked.write(io.StringIO())


@examples(6)
@given(points, st.floats(0.1, 100), st.floats(-10, 10), st.floats(0, math.tau))
def test_the_box_of_an_arc_is_tight(centre: complex, radius: float, start: float, sweep: float) -> None:
    arc = Arc(centre, radius, start, start + sweep)
    samples = [arc.at(k / 720) for k in range(721)]
    left, bottom, right, top = bounds(arc)
    slack = radius * 1e-4 + 1e-9
    assert left - 1e-9 <= min(p.real for p in samples) <= left + slack
    assert right - slack <= max(p.real for p in samples) <= right + 1e-9
    assert bottom - 1e-9 <= min(p.imag for p in samples) <= bottom + slack
    assert top - slack <= max(p.imag for p in samples) <= top + 1e-9


def test_the_box_of_lettering_follows_anchor_and_rotation() -> None:
    left, bottom, right, top = bounds(Text(10 + 10j, "abc", size=10, anchor="end", rotation=90))
    assert (left, right) == pytest.approx((0, 10))
    assert (bottom, top) == pytest.approx((10 - 19, 10))  # three letters of 5d, two gaps of 2d
    with pytest.raises(SheetError):
        bounds(Group(()))
