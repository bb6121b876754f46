"""Standard scales and numbers of a sheet."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drawings.scale import MANTISSAS, fitting
from drawings.strokes import SheetError
from drawings.words import WORDS, fixed, number, word


@given(st.floats(1e-8, 1e8), st.floats(20, 800), st.sampled_from(["v", "a", "F"]))
def test_the_chosen_scale_is_standard_fits_and_is_the_largest_that_does(
    extent: float, room: float, letter: str
) -> None:
    mu = fitting(extent, room, letter, "m/s").mu
    mantissa = mu / 10 ** math.floor(math.log10(mu) + 1e-9)
    assert any(abs(mantissa - m) < 1e-6 for m in MANTISSAS)
    assert extent / mu <= room * (1 + 1e-9)
    assert extent / mu > room / 2 * (1 - 1e-9)  # the next larger picture is at most twice as large


@pytest.mark.parametrize(
    ("extent", "ratio"), [(0.3, "1:1"), (0.31, "1:2"), (0.7, "1:2.5"), (0.1, "2.5:1"), (3.0, "1:10")]
)
def test_lengths_take_the_scales_of_the_standard(extent: float, ratio: str) -> None:
    assert fitting(extent, 300.0, "l", "m").ratio("en") == ratio


def test_a_scale_is_written_as_the_textbook_writes_it() -> None:
    assert fitting(3.6, 180.0, "v", "m/s").written("ru") == "μ_v = 0,02 (м/с)/мм"


@given(st.floats(-1e12, 1e12, allow_nan=False))
def test_a_number_is_read_back_to_its_digits_without_exponent(value: float) -> None:
    text = number(value).replace("−", "-")
    assert "e" not in text and text != "-0"
    assert abs(float(text) - value) <= 5.1e-4 * abs(value)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_gap_is_never_written_as_a_number(value: float) -> None:
    with pytest.raises(SheetError):
        number(value)


def test_a_rounded_zero_has_no_sign() -> None:
    assert fixed(-0.0001) == "0.00" and number(-0.0) == "0"


def test_both_languages_have_words_for_the_same_things() -> None:
    own = {"out of reach", "dead centre", "change point", "beyond a change point", "not reachable"}
    own |= {"velocities plan", "accelerations plan"}  # in English these keys are the words themselves
    assert set(WORDS["ru"]) - own == set(WORDS["en"])
    assert word("en", "out of reach") == "out of reach"
