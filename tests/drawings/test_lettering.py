"""Lettering: widths and heights of the standard, slant and levels exact, lacking letters told before drawing."""

import json
import math
import unicodedata
from pathlib import Path

import pytest

from drawings.lettering import alphabet
from drawings.lettering.alphabet import SLANT, glyph
from drawings.lettering.lettering import SIZES, UnknownLetter, bounds, demand, index_size, lacking, outline, text_width
from drawings.paper.strokes import LineStyle, Run, SheetError, Text
from plans.words.words import languages, words
from tests import parts
from tests.rows import over

FILE = Path(alphabet.__file__).with_name("alphabet.json")
RUSSIAN, DIGITS = "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ", "0123456789"
LATIN, GREEK = "ABCDEFGHIJKLMNOPQRSTUVWXYZ", "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ"
# Widths in d, type B.
TABLE = {
    5: "ГЕСгбвдеийклнопрухчьэя" + "023567" + "9" + "βγδεζνορυ",
    6: "БВИЙКЛНОПРТУЧЬЭЯ" + "амцъыю" + "4" + "ημσΣ",
    7: "АДМХЦЫЮ" + "жтфш" + "πφψΔΩ",
    8: "ЖФШЪ" + "щ" + "ω",
    9: "Щ",
    4: "с",
    4.5: "з",
    6.5: "ακτ",
    5.3: "З",
    5.6: "8",
    3: "1",
}
FALLING, RISING, HANGING = "gjpqyруф", "bdfhklбвд", "ДЦЩцщ"


def every_letter() -> list[str]:
    return [letter for letter in json.loads(FILE.read_text("utf-8")) if letter]


def points(letter: str) -> list[complex]:
    return [point for chain in glyph(letter).strokes for point in chain.points]


def drawn(*texts: Text) -> list[complex]:
    return [point for text in texts for stroke in outline(text) for point in stroke.points]


def on_sheets(language: str) -> list[str]:
    """Give the phrases that stand on sheets."""
    groups = ("sheet.", "unit.", "reason.", "index.")
    found = [phrase for key, phrase in words(language).items() if key.startswith(groups)]
    forms = [form for phrase in found for form in ([phrase] if isinstance(phrase, str) else phrase)]
    return [line for form in forms for line in form.split("\n")]


@over("language", languages())
def test_every_phrase_of_a_sheet_can_be_written(language: str) -> None:
    for phrase in on_sheets(language):
        assert lacking(phrase) == (), phrase


@over("cell, letters", TABLE.items())
def test_widths_are_those_of_the_standard(cell: float, letters: str) -> None:
    for letter in letters:
        assert glyph(letter).width == cell, letter


@over("letter", RUSSIAN + LATIN + GREEK + DIGITS)
def test_capitals_and_digits_are_ten_d_high(letter: str) -> None:
    body = unicodedata.normalize("NFD", letter)[0]
    heights = [point.imag for point in points(body)]
    assert max(heights) == pytest.approx(9.5, abs=0.01)
    assert min(heights) == pytest.approx(-1 if letter in HANGING else 0.5, abs=0.01)


@over("letter", RUSSIAN.lower() + LATIN.lower())
def test_small_letters_are_seven_d_high_with_tails_of_three(letter: str) -> None:
    body = unicodedata.normalize("NFD", letter)[0]
    heights = [point.imag for point in points(body)]
    if letter in RISING:
        assert max(heights) == pytest.approx(9.5, abs=0.01)
    elif letter not in "tijф":
        assert max(heights) == pytest.approx(6.5, abs=0.01)
    lowest = -2.5 if letter in FALLING else -1 if letter in HANGING else 0.5
    assert min(heights) == pytest.approx(lowest, abs=0.01)


@over("letter", every_letter() + list("ЁЙёйїўéŻ") + ["φ̇"])
def test_no_stroke_leaves_its_cell(letter: str) -> None:
    across, up = [point.real for point in points(letter)], [point.imag for point in points(letter)]
    assert min(across, default=0.5) > 0.4
    assert max(across, default=-1) < glyph(letter).width - 0.4
    assert min(up, default=0) >= -2.51
    assert max(up, default=0) < 13


@pytest.mark.parametrize("size", [2.5, 3.5, 5, 7, 10])
def test_the_pen_is_a_tenth_of_the_size_and_takes_the_colour_of_the_ink(size: float) -> None:
    ink = LineStyle(width=0, colour="none", fill="#123456")
    for stroke in outline(Text(0j, "Жя", size, style=ink)):
        assert (stroke.style.width, stroke.style.colour, stroke.style.fill) == (size / 10, "#123456", "none")


def test_slanted_letters_lean_by_fifteen_degrees_about_the_line_of_writing() -> None:
    at, text = 20 + 30j, "Щуp_2^3"
    upright, slanted = drawn(Text(at, text, 7.0)), drawn(Text(at, text, 7.0, slanted=True))
    assert math.degrees(math.atan(SLANT)) == pytest.approx(15)
    for plain, leaning in zip(upright, slanted, strict=True):
        assert leaning == pytest.approx(plain + math.tan(math.radians(15)) * (plain.imag - at.imag))


@pytest.mark.parametrize("size", SIZES[1:8])
def test_indices_are_one_size_smaller(size: float) -> None:
    smaller = SIZES[SIZES.index(size) - 1]
    assert index_size(size) == smaller
    for level in "_^":
        stroke = outline(Text(0j, "v" + level + "Н", size))[1]
        assert stroke.style.width == smaller / 10
        left, bottom, right, top = bounds(stroke)
        assert (right - left, top - bottom) == pytest.approx((0, smaller * 0.9))


@pytest.mark.part
@over("phrase", [phrase for language in languages() for phrase in on_sheets(language)][:: 1 if parts.whole else 7])
@over("size", [3.5, 10.0])
def test_the_width_is_what_is_drawn(phrase: str, size: float) -> None:
    text = Text(0j, (Run(phrase),), size)
    reach = [point.real for point in drawn(text)]
    assert min(reach) - size / 20 == pytest.approx(0, abs=size / 10)
    assert max(reach) + size / 20 == pytest.approx(text_width(text), abs=size / 10)


def test_lacking_letters_are_told_before_drawing() -> None:
    text = Text(0j, "снег 雪 и 雨, 雪", 5.0)
    assert lacking(text) == ("雪", "雨")
    with pytest.raises(UnknownLetter, match=r"lacks '雪' \(U\+96EA\), '雨' \(U\+96E8\)") as told:
        demand([Text(0j, "лёд"), text])
    assert (told.value.text, told.value.lacks) == (text.plain, ("雪", "雨"))
    assert isinstance(told.value, SheetError)
    for use in (text_width, outline):
        with pytest.raises(UnknownLetter):
            use(text)


def test_accents_are_written_over_letters_in_either_coding() -> None:
    assert lacking("Müller Łódź Škoda čŻőñÅç φ̇ ẍ") == ()
    assert drawn(Text(0j, "й")) == drawn(Text(0j, "и\u0306"))
    assert glyph("é").strokes[: len(glyph("e").strokes)] == glyph("e").strokes
    assert max(point.imag for point in points("É")) > max(point.imag for point in points("é")) + 2.5
    assert max(point.imag for point in glyph("ї").strokes[0].points) == 6.5  # the dots replace the dot
    assert text_width(Text(0j, "oE" + 9 * "\u0301" + "o", 10.0)) == 5 + 2 + 5 + 2 + 5  # a tower of accents
    assert lacking("x\u0332") == ("x\u0332",)
