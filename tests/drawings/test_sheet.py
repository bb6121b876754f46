"""The kinematics sheet: complete, within its frame, readable, the same each time, and true when measured."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from drawings.lettering.extent import bounds
from drawings.lettering.lettering import UnknownLetter, lettered
from drawings.lettering.specimen import specimen
from drawings.linkage.kinematics import leaves, sheet, sheets
from drawings.page.page import Page, page_of
from drawings.paper.strokes import Group, Leaf, Line, Text
from drawings.paper.walk import flat
from drawings.pens.svg import svg
from drawings.sheets import leaves as laid
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.collisions import collisions
from tests.drawings.mechanisms import TOGGLE_PRESS
from tests.parts import first

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"

FOUR_BAR = """
title = "Crank-rocker"
[mechanism.frame]
O = [0, 0]
C = [0.35, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "CB"
[mechanism.lengths]
OA = {crank}
AB = {rod}
CB = {rocker}
[mechanism.sketch]
B = [0.39, 0.30]
[drive]
link = 1
speed = {speed}
start = {start}
"""


@cache
def drawn(text: str) -> tuple[LinkageStudy, Leaf]:
    study = LinkageStudy(parse_scene(text))
    return study, sheet(study, compare(study))


def four_bar(**changes: object) -> str:
    data: dict[str, object] = {"crank": 0.1, "rod": 0.4, "rocker": 0.3, "speed": 10, "start": 0}
    return FOUR_BAR.format(**(data | changes))


def texts(leaf: Leaf) -> list[Text]:
    return [stroke for stroke in flat(leaf.groups) if isinstance(stroke, Text)]


def test_lettering_across_a_line_is_found() -> None:
    across = Group((Text(10 + 10j, "A", 5.0), Line(8 + 12j, 20 + 12j)))
    assert len(collisions(Leaf(100, 100, (across,)))) == 1


def test_the_sheet_names_its_scales_as_the_textbook_does() -> None:
    _, leaf = drawn(four_bar())
    said = [text.plain for text in texts(leaf)]
    assert "μl = 0.001 m/mm (1:1)" in said
    assert any(re.fullmatch(r"μv = [\d.]+ \(m/s\)/mm", text) for text in said)
    assert any(re.fullmatch(r"μa = [\d.]+ \(m/s²\)/mm", text) for text in said)


def test_the_sheet_shows_structure_swing_and_time_ratio() -> None:
    _, leaf = drawn(four_bar())
    said = " ".join(text.plain for text in texts(leaf)).replace("\N{NO-BREAK SPACE}", " ")
    assert "W = 3·3 − 2·4 = 1" in said and "I(0,1) → II1(2,3)" in said
    assert "ψ = 45.97°" in said and "θ = 18.13°" in said and "K = 1.224" in said


def test_a_russian_sheet_has_russian_words_and_decimal_commas() -> None:
    _, leaf = drawn(four_bar() + '[sheet]\nlanguage = "ru"\n')
    said = [text.plain for text in texts(leaf)]
    assert "План положений механизма" in said and "по плану" in said
    assert "μl = 0,001 м/мм (1:1)" in said
    assert not any(re.search(r"\d\.\d", text) for text in said)


def test_a_mechanism_that_reaches_no_position_gets_a_sheet_that_explains_why() -> None:
    _, leaf = drawn(four_bar(rod=0.05, rocker=0.05))
    said = " ".join(text.plain for text in texts(leaf))
    assert "Gaps: 0–11: out of reach at B" in said and "reach from" in said
    assert "Velocity plan" not in said


@pytest.mark.rest
@pytest.mark.parametrize("format_", first(["A1", "A4"]))
def test_arcs_that_miss_each_other_stay_within_the_frame(format_: str) -> None:
    """A rod far too long draws no circle over the title block or off the paper."""
    study, leaf = drawn(four_bar(rod=40, rocker=0.3) + f'[sheet]\nformat = "{format_}"\n')
    assert study.lost.all()
    field = page_of(study.scene).field
    left, bottom, right, top = bounds(next(group for group in leaf.groups if group.name == "positions"))
    assert field.left <= left and right <= field.right and field.bottom <= bottom and top <= field.top


def test_the_lengths_of_the_scene_stand_on_the_sheet_in_millimetres() -> None:
    _, leaf = drawn(four_bar())
    said = " ".join(text.plain for text in texts(leaf)).replace("\N{NO-BREAK SPACE}", " ")
    assert "lOA = 100, lAB = 400, lCB = 300" in " ".join(said.split())


def test_gaps_are_crossed_out_on_the_crank_circle_and_named() -> None:
    study, leaf = drawn(four_bar(crank=0.3, rod=0.2, rocker=0.25, start=20))
    assert study.lost.any() and not study.lost.all()
    said = " ".join(text.plain for text in texts(leaf))
    assert "Gaps:" in said and "out of reach at B" in said


def test_a_crank_at_rest_is_said_to_be_at_rest() -> None:
    _, leaf = drawn(four_bar(speed=0))
    assert sum("at rest" in text.plain for text in texts(leaf)) == 4


def test_a_position_that_is_a_gap_is_not_drawn_as_the_shown_one() -> None:
    study = LinkageStudy(parse_scene(four_bar(crank=0.3, rod=0.2, rocker=0.25, start=20) + "[sheet]\nposition = 6\n"))
    with pytest.raises(ValueError, match="position = 6"):
        sheet(study, compare(study))


def test_the_scene_fills_the_title_block() -> None:
    _, leaf = drawn(four_bar() + '[sheet]\ndesignation = "ТММ.01.00"\ndrawn = "Ivanov_A"\ngroup = "M-301"\n')
    said = [text.plain for text in texts(leaf)]
    assert {"ТММ.01.00", "Ivanov_A", "M-301", "Crank-rocker"} <= set(said)


@pytest.mark.rest
@pytest.mark.parametrize("size", first([1e-6, 1e-3, 1.0, 1e4]))
def test_a_mechanism_of_any_size_fits_its_sheet(size: float) -> None:
    text = four_bar(crank=0.1 * size, rod=0.4 * size, rocker=0.3 * size)
    text = text.replace("C = [0.35, 0]", f"C = [{0.35 * size!r}, 0]").replace(
        "B = [0.39, 0.30]", f"B = [{0.39 * size!r}, {0.3 * size!r}]"
    )
    study, leaf = drawn(text)
    field = Page(study.scene.sheet.format).field
    left, bottom, right, top = bounds(next(group for group in leaf.groups if group.name == "positions"))
    assert field.left <= left and right <= field.right and field.bottom <= bottom and top <= field.top
    assert right - left > 150  # it takes the place that it deserves


def test_the_alphabet_s_specimen_is_drawn_again_as_it_was() -> None:
    assert svg(lettered(specimen())) == (GALLERY / "alphabet.svg").read_bytes()


def test_a_title_in_letters_that_the_alphabet_lacks_is_refused_before_drawing() -> None:
    with pytest.raises(UnknownLetter, match="机"):
        drawn(four_bar() + '[sheet]\ngroup = "机构"\n')


@pytest.mark.rest
def test_plans_that_one_sheet_cannot_show_legibly_go_on_following_sheets() -> None:
    study = LinkageStudy(parse_scene(four_bar() + '[sheet]\nformat = "A2"\nplans = [0, 1, 2, 3, 5, 7, 8, 9]\n'))
    leaves = sheets(study, compare(study))
    assert len(leaves) > 1
    assert [k for leaf in leaves for k in leaf.metadata["plans"]] == [0, 1, 2, 3, 5, 7, 8, 9]
    assert [leaf.metadata["number"] for leaf in leaves] == list(range(1, len(leaves) + 1))
    assert [leaf.metadata["shown"] for leaf in leaves] == [0] + [None] * (len(leaves) - 1)
    values = [group.data["positions"] for leaf in leaves for group in leaf.groups if "positions" in group.data]
    assert {int(k) for text in values for k in text.split()} == {0, 1, 2, 3, 5, 7, 8, 9}


TOGGLE = TOGGLE_PRESS.partition("positions")[0]


@pytest.mark.rest
def test_an_output_that_reverses_four_times_in_a_turn_has_no_time_ratio() -> None:
    """The toggle of a press passes its straight line twice: the ram comes to its lowest place two times in a turn."""
    study, leaf = drawn(TOGGLE)
    assert study.extreme_positions is not None
    assert np.degrees(study.extreme_positions.rests) == pytest.approx([1.0, 86.0, 181.3, 274.0], abs=0.1)
    said = " ".join(text.plain for text in texts(leaf))
    assert "reverses 4 times in a turn" in said and "K =" not in said


@pytest.mark.parametrize(("tight", "counts"), [(laid.TIGHT, [1]), (1.0, [1, 2])])
def test_remarks_that_can_be_read_where_the_notes_stand_are_no_reason_for_a_further_sheet(
    tight: float, counts: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    compose, sets = laid.compose, list[int]()
    monkeypatch.setattr(laid, "TIGHT", tight)
    monkeypatch.setattr(laid, "compose", lambda *asked: sets.append(len(own := compose(*asked))) or own)
    assert len(leaves(Study(read_scene(GALLERY / "crank-rocker.toml")))) == 1
    assert sets == counts
