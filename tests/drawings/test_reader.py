"""Reading a stranger's sheet: hostile ones are refused in time and in words, honest ones in other dress are read."""

import cmath
import gzip
import re
import sys
import time
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drawings.paper import limits
from drawings.paper.limits import SheetRefused
from drawings.reading import pathdata
from drawings.reading.measure import check, measure
from drawings.reading.transform import Affine, about, matrix, transform
from tests.drawings.test_measure import DATA, HEAD, LINE, LOOK, bare
from tests.parts import first

places = st.builds(complex, st.floats(-500, 500), st.floats(-500, 500))


@pytest.mark.parametrize(
    "bad",
    [
        "nan", "inf", "-inf", "1e999", "1_000", "١٢", "１２", "1,5", "5mm", "calc(1+1)", "--1", "", "0x1", "1 2",
        "1" * 400,
    ],
)  # fmt: skip
def test_numbers_of_no_svg_are_refused(bad: str) -> None:
    with pytest.raises(SheetRefused, match=r"vector v B \(v\)"):
        measure(bare(LINE.replace('x1="10"', f'x1="{bad}"')))


@pytest.mark.parametrize(
    "bad",
    [
        "matrix(nan 0 0 1 0 0)", "rotate(1e999)", "translate(1e300)", "skewX(90)", "scale(1,2,3)", "matrix(1 0 0 1 0)",
        "spin(3)", "rotate(3", "rotate 3", "translate(1,,2)", ")", "rotate(1)" * 65,
    ],
)  # fmt: skip
def test_transforms_of_no_sense_are_refused(bad: str) -> None:
    with pytest.raises(SheetRefused):
        measure(bare(f'<g transform="{bad}">{LINE}</g>'))


@pytest.mark.parametrize(
    "path",
    [
        "", "L 1 2 3 4", "M 1 2", "M 1 2 L 3", "M 1 2 L 3 4 5 6", "M 1 2 C 1 2 3 4 5 6", "M1 2M3 4", "M 1 2 X 3 4",
        "M1 2A1 1 0 2 0 3 4", "M1 2 3 4 ſ",
    ],
)  # fmt: skip
def test_paths_of_no_vector_are_refused(path: str) -> None:
    with pytest.raises(SheetRefused):
        measure(bare(f'<path {DATA} {LOOK} d="{path}"/>'))


@pytest.mark.parametrize(
    "size",
    [
        'viewBox="0 0 0 0"', 'viewBox="0 0 -1 1"', 'viewBox="0 0 nan 1"', 'viewBox="0 0 1"', "",
        'width="1e9mm" height="1mm"', 'width="-1mm" height="1mm"', 'width="1furlong" height="1mm"',
    ],
)  # fmt: skip
def test_pages_of_no_size_are_refused(size: str) -> None:
    with pytest.raises(SheetRefused):
        measure(bare(LINE, head=f'<svg xmlns="http://www.w3.org/2000/svg" {size}>'))


TENFOLD = {k: f"&l{k - 1};" * 10 for k in range(1, 10)}
LAUGHS = "".join(f"<!ENTITY l{k} '{text}'>" for k, text in TENFOLD.items())
MANY = "".join(f"<!ENTITY e{k} 'e'>" for k in range(65))
HOSTILE = {
    "laughs": f'<!DOCTYPE svg [<!ENTITY l0 "ha">{LAUGHS}]>{HEAD}&l9;</svg>',
    "quadratic": f'<!DOCTYPE svg [<!ENTITY a "{"a" * 50_000}">]>{HEAD}{"&a;" * 50_000}</svg>',
    "many short ones": f'<!DOCTYPE svg [<!ENTITY a "{"a" * 200}">]>{HEAD}<g class="{"&a;" * 100_000}"/></svg>',
    "65 entities": f"<!DOCTYPE svg [{MANY}]>{HEAD}</svg>",
    "external": f'<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]>{HEAD}<text>&x;</text></svg>',
    "unused external": f'<!DOCTYPE svg [<!ENTITY x SYSTEM "http://localhost/x">]>{HEAD}{LINE}</svg>',
    "parameter": f"<!DOCTYPE svg [<!ENTITY % p \"<!ENTITY x SYSTEM 'file:///etc/passwd'>\"> %p;]>{HEAD}</svg>",
    "unparsed": f'<!DOCTYPE svg [<!NOTATION n SYSTEM "n"><!ENTITY x SYSTEM "x" NDATA n>]>{HEAD}</svg>',
    "unknown": f'<!DOCTYPE svg SYSTEM "http://localhost/svg.dtd">{HEAD}<text>&x;</text></svg>',
    "style sheet": f'<?xml-stylesheet href="file:///etc/passwd"?>{HEAD}{LINE}</svg>',
    "hiding style": f"{HEAD}<style>*{{display:none}}</style>{LINE}</svg>",
    "late style": f"{HEAD}{LINE}<defs><style><![CDATA[ line{{ X1 : 3px}} ]]></style></defs></svg>",
    "style under cover": f'{HEAD}<style>*{{opacity:0}}<metadata id="sheet"/></style>{LINE}</svg>',
    "style in a description": f'{HEAD}<metadata id="sheet"><style>*{{opacity:0}}</style></metadata>{LINE}</svg>',
    "foreign style": f'{HEAD}<foreignObject><style xmlns="http://www.w3.org/1999/xhtml">line{{opacity:0}}</style></foreignObject></svg>',
    "imported style": f"{HEAD}<style>@import url(http://localhost/x)</style></svg>",
    "moved by style": f'{HEAD}<g style="translate: 3px">{LINE}</g></svg>',
    "escaped style": HEAD + LINE.replace("<line", r'<line style="\64isplay:none"') + "</svg>",
    "animation": f'{HEAD}<g>{LINE}<animateTransform attributeName="transform" to="3"/></g></svg>',
    "nested drawing": f'{HEAD}<svg viewBox="0 0 1 2">{LINE}</svg></svg>',
    "deep": HEAD + "<g>" * 200_000,
    "attributes": HEAD + "<g " + " ".join(f'a{k}=""' for k in range(100_000)) + "/></svg>",
    "elements": HEAD + "<g/>" * 1_000_000 + "</svg>",
    "long path": f'{HEAD}<path {DATA} {LOOK} d="M0 0{"L1 1" * 1_000_000}"/></svg>',
    "truncated": f"{HEAD}<g>{LINE}",
    "cut in a tag": (HEAD + LINE)[:-20],
    "two roots": f"{HEAD}</svg>{HEAD}</svg>",
    "no namespace": f'<svg width="1mm" height="1mm">{LINE}</svg>',
    "unbound prefix": f"{HEAD}<x:g/></svg>",
    "html": "<!DOCTYPE html><html><body>log in</body></html>",
    "broken html": "<!DOCTYPE html><html><br><p>log in</html>",
    "text": "a vector",
    "nothing": "",
    "spaces": " \n ",
    "NUL": f"{HEAD}&#0;</svg>",
    "utf-7": f'<?xml version="1.0" encoding="utf-7"?>{HEAD}</svg>',
    "far encoding": f'<?xml version="1{"0" * 200}" encoding="utf-7"?>{HEAD}</svg>',
    "rot13": f'<?xml version="1.0" encoding="rot13"?>{HEAD}</svg>',
    "utf-16 in name only": f'<?xml version="1.0" encoding="utf-16"?>{HEAD}</svg>',
    "other format": f'{HEAD}<metadata id="sheet">{{"format": 2}}</metadata></svg>',
    "strange format": f'{HEAD}<metadata id="sheet">{{"format": "1"}}</metadata></svg>',
    "long style": f"{HEAD}<style>{'a{}' * 30_000}</style></svg>",
    "long description": f'{HEAD}<metadata id="sheet">{"1" * 3_000_000}</metadata></svg>',
    "big": HEAD + " " * limits.SHEET_BYTES + "</svg>",
    "off paper": bare(f'<g transform="translate(9e8)">{LINE}</g>').decode(),
    "off by nesting": HEAD + '<g transform="scale(1e12)">' * 200 + LINE + "</g>" * 200 + "</svg>",
    "a rectangle for a vector": HEAD + LINE.replace("<line", "<rect") + "</svg>",
    "a group for a vector": HEAD + LINE.replace("<line", "<g") + "</svg>",
    "root transform": HEAD.replace("<svg", '<svg transform="scale(2)"') + "</svg>",
}


@pytest.mark.parametrize("name", first(HOSTILE))
def test_hostile_sheets_are_refused_quickly(name: str) -> None:
    source = HOSTILE[name].encode()
    before = time.process_time()
    with pytest.raises(SheetRefused) as caught:
        measure(source)
    assert time.process_time() - before < 2
    assert 0 < len(str(caught.value.reason)) < 300
    assert re.search("[а-я]{3}", caught.value.reason.worded("ru"))


@pytest.mark.parametrize(
    "start", [b"%PDF-1.7", b"PK\x03\x04", b"\x89PNG\r\n", b"\xff\xd8\xff", b"\x00\x01", b"\xff\xfe", b"\xef\xbb\xbf"]
)
def test_other_files_are_refused(start: bytes) -> None:
    with pytest.raises(SheetRefused):
        measure(start + b"....")


def test_packed_sheets_are_read_within_the_limit() -> None:
    packed = gzip.compress(bare(LINE))
    assert check(measure(packed)) == []
    bomb = gzip.compress(HEAD.encode() + b"<g/>" * 12_500_000 + b"</svg>")
    assert len(bomb) < 100_000
    for bad in (bomb, packed[:-30], gzip.compress(packed), b"\x1f\x8b\x08garbage"):
        with pytest.raises(SheetRefused):
            measure(bad)


@pytest.mark.parametrize(
    "encode",
    [
        lambda text: b"\xef\xbb\xbf" + text.encode(),
        lambda text: text.encode("utf-16"),
        lambda text: b'<?xml version="1.0" encoding="windows-1251"?>' + text.encode("cp1251"),
        lambda text: b'<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://localhost/svg11.dtd">' + text.encode(),
        lambda text: (
            b'<!DOCTYPE svg [<!ENTITY ns_extend "http://ns.adobe.com/x/1.0/">]>'
            + text.replace("<svg", '<svg xmlns:x="&ns_extend;"').encode()
        ),
        lambda text: b"<!-- a <comment> -->\r\n<?editor 1?>" + text.encode(),
    ],
)
def test_honest_files_of_other_dress_are_read(encode: Callable[[str], bytes]) -> None:
    text = bare(LINE.replace('data-name="B"', 'data-name="Б"')).decode()
    assert [mark.name for mark in measure(encode(text)).vectors] == ["Б"]


@pytest.mark.parametrize("text", ["[" * 100_000, '{"a": ' + "1" * 5000 + "}", "not json", "[1]", '{"format": 1'])
def test_a_damaged_description_costs_only_a_note(text: str) -> None:
    measured = measure(bare(f'<metadata id="sheet">{text}</metadata>', LINE))
    assert measured.metadata == {}
    assert "description" in str(measured.notes[0])
    assert len(measured.vectors) == 1


def test_an_editor_may_add_to_the_description_and_keep_harmless_styles() -> None:
    added = '<r:RDF xmlns:r="urn:rdf"><r:Work>text</r:Work></r:RDF>'
    measured = measure(
        bare(f'<metadata id="sheet">{{"a": 1}}\n{added}</metadata><style>.a{{font-size:3px}}</style>', LINE)
    )
    assert measured.metadata == {"a": 1}
    assert measured.notes == ()
    assert check(measured) == []


def test_nothing_is_opened_while_reading() -> None:
    measure(bare(LINE))  # imports everything first
    seen: list[str] = []
    watching = [True]

    def watch(event: str, args: tuple[object, ...]) -> None:
        if watching and (event.startswith("socket.") or event in ("open", "subprocess.Popen", "import")):
            seen.append(f"{event} {args[:1]}")

    sys.addaudithook(watch)
    try:
        for name in ("external", "unused external", "parameter", "unknown", "style sheet", "imported style"):
            with pytest.raises(SheetRefused):
                measure(HOSTILE[name].encode())
    finally:
        watching.clear()  # a hook cannot be taken back
    assert seen == []


@pytest.mark.parametrize(
    "text",
    [
        "1" * 1_000_000, "M" + "1" * 200_000 + "!", " " * 200_000 + "!", "-" * 200_000, "M 1" + " " * 200_000,
        "a" * 200_000, "rotate" + " " * 200_000, "rotate(" * 30_000,
    ],
)  # fmt: skip
def test_long_nonsense_is_refused_in_linear_time(text: str) -> None:
    before = time.process_time()
    for read in (pathdata.number, pathdata.numbers, pathdata.trace, transform):
        with pytest.raises(SheetRefused):
            read(text)
    assert time.process_time() - before < 0.5


@given(st.text("MLHVCSQTAZmlhvz0123456789.,-+eE ", max_size=40))
def test_any_path_is_followed_or_refused(path: str) -> None:
    try:
        traced = pathdata.trace(path)
    except SheetRefused:
        return
    assert all(cmath.isfinite(point) for point in traced.points)
    pathdata.centre(traced)


@given(st.binary(max_size=60), st.integers(0, 2000), st.integers(0, 60))
def test_a_damaged_sheet_is_measured_or_refused(noise: bytes, place: int, cut: int) -> None:
    source = bare(f'<g transform="translate(1 2)" style="fill:none">{LINE}</g>')
    try:
        measure(source[:place] + noise + source[place + cut :])
    except SheetRefused as refused:
        assert refused.reason.worded("ru")


@given(places, st.lists(st.floats(-5, 5), min_size=6, max_size=6))
def test_maps_follow_svg(z: complex, entries: list[float]) -> None:
    a, b, c, d, e, f = entries
    expected = complex(a * z.real + c * z.imag + e, b * z.real + d * z.imag + f)
    assert cmath.isclose(matrix(*entries)(z), expected, abs_tol=1e-9)
    assert cmath.isclose(
        about(3 + 4j, matrix(*entries)).after(Affine(t=1j))(z), about(3 + 4j, matrix(*entries))(z + 1j), abs_tol=1e-9
    )
