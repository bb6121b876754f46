"""Standard scales and numbers of a sheet."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drawings.lettering.words import fixed, number, numerals, word
from drawings.page.page import Scale, fitting
from drawings.paper.strokes import SheetError
from tests.parts import examples

SERIES = (1, 2, 2.5, 4, 5)  # of scale factors, by both standards: ISO 5455 speaks of lengths alone
# GOST 2.302-68 and ISO 5455: a of the enlargements a:1, b of the reductions 1:b.
GOST_LENGTHS = [f"{a}:1" for a in (100, 50, 40, 20, 10, 5, 4, 2.5, 2, 1)] + [f"1:{b}" for b in (
    2, 2.5, 4, 5, 10, 15, 20, 25, 40, 50, 75, 100, 200, 400, 500, 800, 1000, 2000, 5000, 10000, 20000, 25000, 50000,
)]  # fmt: skip
ISO_LENGTHS = [f"{a}:1" for a in (50, 20, 10, 5, 2, 1)] + [
    f"1:{b}" for b in (2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
]


@examples(6)
@given(st.floats(1e-8, 1e8), st.floats(20, 800), st.sampled_from(["v", "a", "F"]), st.sampled_from(["GOST", "ISO"]))
def test_the_chosen_scale_is_standard_fits_and_is_the_largest_that_does(
    extent: float, room: float, letter: str, standard: str
) -> None:
    mu = fitting(extent, room, letter, "m/s", standard).mu
    mantissa = mu / 10 ** math.floor(math.log10(mu) + 1e-9)
    assert any(abs(mantissa - m) < 1e-6 for m in SERIES)
    assert extent / mu <= room * (1 + 1e-9)
    assert extent / mu > room / 2 * (1 - 1e-9)  # the next larger picture is at most twice as large


@pytest.mark.parametrize(("standard", "series"), [("GOST", GOST_LENGTHS), ("ISO", ISO_LENGTHS)])
def test_a_length_that_fits_a_scale_of_the_standard_exactly_takes_it(standard: str, series: list[str]) -> None:
    for ratio in series:
        drawn, true = (float(part) for part in ratio.split(":"))
        extent = 0.3 * true / drawn  # m, on 300 mm of paper
        assert fitting(extent, 300.0, "l", "m", standard).ratio("en") == ratio


@examples(6)
@given(st.floats(1e-4, 4e4), st.floats(20, 800), st.sampled_from(["GOST", "ISO"]))
def test_a_picture_of_lengths_takes_the_first_scale_of_the_table_in_which_it_fits(
    extent: float, room: float, standard: str
) -> None:
    scale = fitting(extent, room, "l", "m", standard)
    series = {"GOST": GOST_LENGTHS, "ISO": ISO_LENGTHS}[standard]
    factors = [0.001 * float(r.split(":")[1]) / float(r.split(":")[0]) for r in series]
    if factors[0] < extent / room <= factors[-1]:
        least = min(mu for mu in factors if extent / mu <= room * (1 + 1e-9))
        assert scale.mu == pytest.approx(least, rel=1e-12)


@pytest.mark.parametrize(
    ("extent", "ratio"), [(0.0007, "400:1"), (0.0011, "200:1"), (0.00012, "2000:1"), (20000.0, "1:100000")]
)
def test_beyond_the_table_a_picture_is_enlarged_a_whole_number_of_hundreds(extent: float, ratio: str) -> None:
    """GOST 2.302: (100n):1 with n whole; no 250:1."""
    assert fitting(extent, 300.0, "l", "m").ratio("en") == ratio


@pytest.mark.parametrize(
    ("extent", "ratio"), [(0.3, "1:1"), (0.31, "1:2"), (0.7, "1:2.5"), (0.1, "2.5:1"), (3.0, "1:10")]
)
def test_lengths_take_the_scales_of_the_standard(extent: float, ratio: str) -> None:
    assert fitting(extent, 300.0, "l", "m").ratio("en") == ratio


@pytest.mark.parametrize(
    ("scale", "language", "notation", "written"),
    [
        (Scale(0.02, "v", "m/s"), "ru", "mu", "μ_v = 0,02 (м/с)/мм"),
        (Scale(0.002, "l", "m"), "en", "mu", "μ_l = 0.002 m/mm (1:2)"),
        (Scale(0.0025, "l", "m"), "ru", "mu", "μ_l = 0,0025 м/мм (1:2,5)"),
        (Scale(0.002, "l", "m"), "en", "K", "K_l = 500 mm/m"),
        (Scale(0.015, "l", "m"), "ru", "K", "K_l = 66,67 мм/м"),
        (Scale(0.4, "a", "m/s2"), "en", "K", "K_a = 2.5 mm/(m/s²)"),
        (Scale(50.0, "F", "N"), "ru", "mu", "μ_F = 50 Н/мм"),
        (Scale(0.5, "A", "J"), "ru", "K", "K_A = 2 мм/Дж"),
    ],
)
def test_a_scale_is_written_as_the_textbook_writes_it(scale: Scale, language: str, notation: str, written: str) -> None:
    assert scale.written(language, notation) == written


@given(st.floats(-1e12, 1e12, allow_nan=False))
def test_a_number_is_read_back_to_its_digits(value: float) -> None:
    text = numerals(number(value))
    assert text != "-0"
    assert abs(float(text) - value) <= 5.1e-4 * abs(value)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_gap_is_never_written_as_a_number(value: float) -> None:
    with pytest.raises(SheetError):
        number(value)


def test_a_rounded_zero_has_no_sign() -> None:
    assert fixed(-0.0001) == "0.00" and number(-0.0) == "0"


def test_both_languages_have_words_for_the_same_things() -> None:
    assert word("en", "out of reach") == "out of reach" and word("ru", "out of reach") == "не собирается"
    with pytest.raises(StopIteration):
        word("en", "no word")
