"""The hand of a sheet: widths, dashes and letters within what each standard allows."""

from __future__ import annotations

import itertools

import pytest

from drawings.lettering.lettering import SIZES
from drawings.paper.hand import hand_of

FORMATS = ("A1", "A2", "A3", "A4")


@pytest.mark.parametrize("name", FORMATS)
def test_the_lines_of_gost_2_303_keep_to_its_ranges(name: str) -> None:
    hand = hand_of(name, "GOST")
    assert 0.5 <= hand.main <= 1.4
    for thin in (hand.thin, hand.construction):
        assert hand.main / 3 <= thin <= hand.main / 2
    dash, gap = hand.path.dash
    assert 2 <= dash <= 8 and 1 <= gap <= 2
    dash, *space = hand.axis.dash
    assert 5 <= dash <= 30 and 3 <= sum(space) <= 5
    dash, *space = hand.extreme.dash
    assert 5 <= dash <= 30 and 4 <= sum(space) <= 6 and len(space) == 5


@pytest.mark.parametrize(("name", "wide"), [("A1", 0.7), ("A2", 0.5), ("A3", 0.5), ("A4", 0.5)])
def test_the_lines_of_iso_128_are_a_group_of_two_widths_with_dashes_by_their_own_width(name: str, wide: float) -> None:
    hand = hand_of(name, "ISO")
    d = wide / 2
    assert (hand.main, hand.thin, hand.construction) == (wide, d, d)
    assert hand.path.dash == pytest.approx((12 * d, 3 * d))
    assert hand.axis.dash == pytest.approx((24 * d, 3 * d, 0.5 * d, 3 * d))
    assert hand.extreme.dash == pytest.approx((24 * d, 3 * d, 0.5 * d, 3 * d, 0.5 * d, 3 * d))
    for line in (hand.path, hand.axis, hand.extreme):
        assert line.width == d
    assert hand.main > hand.relative.width > hand.thin


@pytest.mark.parametrize(("name", "standard"), list(itertools.product(FORMATS, ("GOST", "ISO"))))
def test_letters_are_of_standard_sizes_and_large_enough_to_be_read(name: str, standard: str) -> None:
    hand = hand_of(name, standard)
    sizes = (hand.heading, hand.title, hand.letter, hand.number, hand.text)
    assert set(sizes) <= set(SIZES)
    assert min(sizes) >= (3.5 if name == "A1" else 2.5)
    assert hand.heading > hand.title >= hand.letter > hand.number >= hand.text
