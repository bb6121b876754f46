"""The eye: letters are read from their strokes alone, lines as a stranger writes them; what cannot be seen is told."""

from __future__ import annotations

import re
import unicodedata

import pytest

from drawings.lettering.alphabet import glyph
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import INK, Circle, Curve, Group, Leaf, Line, LineStyle, Polyline, Run, Text
from drawings.paper.walk import flat
from drawings.paper.walk import texts as texts_of
from drawings.pens.svg import svg
from drawings.reading import alphabet
from drawings.reading.alphabet import NEAR, STANCES, UNREAD, Trail, angles, notations, readings, shape, shapes
from drawings.reading.lettered import PathLetters, PenTrack, SeenGlyph, any_letters, tracks, written
from drawings.reading.sheet import SeenSheet, see
from drawings.reading.transform import MIRROR

RAISED = "".join(one for one, notation in notations().items() if notation[0] in "^_")
LETTERS = "".join(one for one in notations() if one.strip() and not unicodedata.combining(one) and one not in RAISED)
ROWS = [f"x{RAISED}"] + [LETTERS[place : place + 40] for place in range(0, len(LETTERS), 40)]
SHEET = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">{}</svg>'
PEN = 'fill="none" stroke="#000" stroke-width="0.5"'


def seen(*texts: Text) -> SeenSheet:
    return see(svg(lettered(Leaf(420.0, 297.0, (Group(texts, "words"),)))))


def looked(inside: str) -> SeenSheet:
    return see(SHEET.format(inside).encode())


SHARP = LineStyle(0.5, join="miter")  # corners of a file that says nothing of them


@pytest.mark.parametrize("slanted", [False, True])
@pytest.mark.parametrize("size", [1.8, 3.5])
def test_every_letter_of_the_alphabet_is_read_from_its_strokes(size: float, slanted: bool) -> None:
    laid = [Text(10 + 10j * (k + 1), (Run(row),), size, slanted=slanted) for k, row in enumerate(ROWS)]
    source = svg(lettered(Leaf(420.0, 297.0, (Group(tuple(laid), "words"),)))).decode()
    source = re.sub(r'data-text="[^"]*"', 'data-text=""', source)  # nothing is told of the texts
    read = list(texts_of(see(source.encode()).written.groups))
    assert [alphabet.folded(text.plain) for text in read] == [alphabet.folded(row) for row in ROWS]
    assert {(text.slanted, round(text.size, 6)) for text in read} == {(slanted, size)}
    assert all(abs(text.at - own.at) < 2e-3 for text, own in zip(read, laid, strict=True))


def test_no_two_letters_that_differ_may_be_taken_for_each_other() -> None:
    """At the smallest size a letter's trail is one letter in its stance, or one that stands elsewhere on its line."""
    low = {"·": ".", "_": "–"}
    for own in shapes().values():
        for letter in own:
            trail = written_trail(letter.letter)
            found = {low.get(one.letter, one.letter) for one in readings(trail, 0.18)[STANCES[0]]}
            assert found == {low.get(letter.letter, letter.letter)}


def written_trail(letter: str) -> Trail:
    points = [0.18 * (point - shape(letter).points[0]) for point in shape(letter).points]
    return Trail(shape(letter).signature, tuple(complex(round(p.real, 2), round(p.imag, 2)) for p in points))


def test_the_eye_s_own_shapes_are_as_wide_as_the_pen_s() -> None:
    assert all(shape(letter).width == glyph(letter).width for letter in shapes_of_one())


def shapes_of_one() -> list[str]:
    return [one.letter for own in shapes().values() for one in own]


@pytest.mark.parametrize("angle", [12.5, -40.0, 90.0, 133.0])
def test_a_text_is_read_in_any_direction(angle: float) -> None:
    (text,) = texts_of(seen(Text(100 + 100j, "v_{BA} = 3,86 м/с", 3.5, slanted=True, rotation=angle)).leaf.groups)
    assert (text.plain, text.slanted) == ("vBA = 3,86 м/с", True)
    assert abs((text.rotation - angle + 180) % 360 - 180) < 0.1
    assert abs(text.at - (100 + 100j)) < 0.01


@pytest.mark.parametrize("idle", ["marker:none;stroke-dashoffset:0;paint-order:normal", "-webkit-filter:none"])
def test_what_editors_write_without_effect_is_none(idle: str) -> None:
    line, layer = f'<path d="M1 1L9 9" {PEN} style="{idle}"/>', '<g id="layer1"><g id="a"><g id="b">{}</g></g></g>'
    assert not looked(line).unseen
    assert [group.name for group in looked(layer.format(line)).leaf.groups] == ["b"]


def test_a_rectangle_with_round_corners_is_a_closed_curve() -> None:
    (found,) = flat(looked(f'<rect x="1" y="2" width="30" height="10" rx="9" {PEN}/>').leaf.groups)
    assert isinstance(found, Curve) and found.closed
    ends = [piece.end for piece in found.pieces]
    assert min(one.real for one in ends) == 1 and max(one.imag for one in ends) == 98


def test_what_a_file_says_of_a_text_picks_among_letters_alike_and_nothing_else() -> None:
    source = svg(lettered(Leaf(100.0, 50.0, (Group((Text(10 + 10j, "TOM 3"),), "words"),)))).decode()
    for said, read in (("ТОМ 3", "ТОМ 3"), ("TOM 8", "TOM 3"), ("", "TOM 3")):
        (text,) = texts_of(see(source.replace('data-text="TOM 3"', f'data-text="{said}"').encode()).leaf.groups)
        assert text.plain == read


def test_letters_that_an_editor_has_written_anew_are_read() -> None:
    laid = Text(10 + 10j, "Öй iЁ %…", 5.0)
    path = svg(lettered(Leaf(100.0, 50.0, (Group((laid,), "words"),)))).decode().split(' d="')[1].split('"')[0]
    anew = "".join(absolute(track) for track in tracks(path))
    letters = any_letters(anew, MIRROR, LineStyle(0.5, cap="round"))
    assert letters is not None
    assert written([letters], "", INK).plain.replace(" ", "") == alphabet.folded("Öйi Ё%…").replace("\u2009", "")


def absolute(track: PenTrack) -> str:
    steps = [f"M{track.start.real:.3f},{track.start.imag:.3f}"]
    for piece in track.pieces:
        numbers = " ".join(f"{point.real:.3f},{point.imag:.3f}" for point in piece)
        steps.append(("L" if len(piece) == 1 else "C") + numbers)
    return "".join(steps) + "Z" * track.closed


@pytest.mark.parametrize(
    ("spaces", "plain"), [(1000, "5" + 500 * " " + "5"), (10**6, f"5{UNREAD}"), (10**25, f"5{UNREAD}")]
)
def test_letters_farther_apart_than_paper_reaches_are_no_line_of_writing(spaces: int, plain: str) -> None:
    trail, apart = written_trail("5"), 0.18 * (shape("5").width + 2 * (spaces + 1))
    letters = PathLetters((0j, apart + 0j), 0.18, 2 * (SeenGlyph(trail, readings(trail, 0.18)),))
    assert written([letters], "", INK).plain == plain


def test_a_stroke_lost_is_no_letter() -> None:
    source = svg(lettered(Leaf(100.0, 50.0, (Group((Text(10 + 10j, "aHa", 5.0),), "words"),)))).decode()
    cut = source.replace("m-", "M-", 1) if "m-" in source else source
    assert cut != source
    assert UNREAD in "".join(text.plain for text in texts_of(see(cut.encode()).written.groups))


@pytest.mark.parametrize(
    ("inside", "reason"),
    [
        (f'<path d="M1 1L9 9" {PEN} display="none"/>', "hidden"),
        (f'<g opacity="0.2"><path d="M1 1L9 9" {PEN}/></g>', "pale"),
        ('<path d="M1 1L9 9" fill="none" stroke="#fefefe"/>', "pale"),
        ('<path d="M1 1L9 9" style="fill:none;stroke:rgb(0,0,0);stroke-width:0.05"/>', "thin"),
        (f'<g clip-path="url(#a)"><path d="M1 1L9 9" {PEN}/></g>', "clipped"),
        (f'<defs><path d="M1 1L9 9" {PEN}/></defs>', "hidden"),
        ('<use href="#a"/>', "unread"),
        (f'<path d="M95 5L120 5" {PEN}/>', "outside"),
    ],
)
def test_what_cannot_be_seen_does_not_count(inside: str, reason: str) -> None:
    sheet = looked(inside)
    assert [one.reason for one in sheet.unseen] == [reason]
    assert list(flat(sheet.leaf.groups)) == []


@pytest.mark.parametrize(
    ("over", "reasons"),
    [
        ('<rect width="20" height="20" fill="#fff"/>', ["pale", "covered"]),
        ('<circle cx="11" cy="11" r="10.5" fill="#fff" stroke="#000" stroke-width="0.5"/>', ["covered"]),
        ('<path d="M0 6H20" fill="none" stroke="#fff" stroke-width="10"/>', ["pale", "covered"]),
        ('<rect width="20" height="20" fill="#fff" fill-opacity="0.2"/>', ["pale"]),
        ('<rect width="6" height="6" fill="#fff"/>', ["pale"]),
        ('<rect width="20" height="20" fill="#fff" display="none"/>', ["hidden"]),
    ],
)
def test_what_is_covered_later_is_not_seen(over: str, reasons: list[str]) -> None:
    under = f'<path d="M5 5L8 8" {PEN}/>'
    assert [one.reason for one in looked(under + over).unseen] == reasons
    assert "covered" not in [one.reason for one in looked(over + under).unseen]


@pytest.mark.parametrize(
    ("inside", "stroke"),
    [
        (f'<path d="m10 10h10" {PEN}/>', Line(10 + 90j, 20 + 90j, LineStyle(0.5))),
        (f'<g transform="translate(5 5) scale(2)"><line x1="1" y1="1" x2="3" y2="1" {PEN}/></g>',
         Line(7 + 93j, 11 + 93j, LineStyle(1.0))),
        (f'<rect x="1" y="2" width="3" height="4" {PEN}/>',
         Polyline((1 + 98j, 4 + 98j, 4 + 94j, 1 + 94j), closed=True, style=SHARP)),
        (f'<circle cx="5" cy="-6" r="2" transform="rotate(90)" {PEN}/>', Circle(6 + 95j, 2.0, LineStyle(0.5))),
        (f'<polyline points="0,0 1,1 2,0" {PEN}/>', Polyline((100j, 1 + 99j, 2 + 100j), style=SHARP)),
    ],
)  # fmt: skip
def test_a_stranger_s_elements_are_seen_as_strokes(inside: str, stroke: object) -> None:
    (found,) = flat(looked(inside).leaf.groups)
    assert found == stroke


def test_an_angle_is_found_by_the_farthest_point() -> None:
    trail = written_trail("F")
    assert min(map(abs, angles([(trail, 0.18)]))) <= 2 * NEAR
