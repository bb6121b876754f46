"""The kinematics sheet: complete, within its frame, readable, the same each time, and true when measured."""

from __future__ import annotations

from functools import cache

import pytest

from drawings.lettering.lettering import UnknownLetter
from drawings.linkage import sheet as kinematics
from drawings.linkage.sheet import leaves, sheets
from drawings.paper.strokes import Group, Leaf, Line, Text
from drawings.paper.walk import flat
from drawings.sheets import leaves as laid
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.collisions import collisions
from tests.gallery import GALLERY
from tests.plans.scenes import scene

FOUR_BAR = scene(
    'title = "Crank-rocker"', frame="O = [0, 0]; C = [0.35, 0]", links="OA AB CB",
    lengths="OA = {crank}; AB = {rod}; CB = {rocker}", sketch="B = [0.39, 0.30]",
    drive="link = 1; speed = {speed}; start = {start}",
)  # fmt: skip


@cache
def drawn(text: str) -> tuple[LinkageStudy, Leaf]:
    study = LinkageStudy(parse_scene(text))
    return study, sheets(study, compare(study))[0]


def four_bar(**changes: object) -> str:
    data: dict[str, object] = {"crank": 0.1, "rod": 0.4, "rocker": 0.3, "speed": 10, "start": 0}
    return FOUR_BAR.format(**(data | changes))


def texts(leaf: Leaf) -> list[Text]:
    return [stroke for stroke in flat(leaf.groups) if isinstance(stroke, Text)]


def test_lettering_across_a_line_is_found() -> None:
    across = Group((Text(10 + 10j, "A", 5.0), Line(8 + 12j, 20 + 12j)))
    assert len(collisions(Leaf(100, 100, (across,)))) == 1


def test_a_mechanism_that_reaches_no_position_gets_a_sheet_that_explains_why() -> None:
    _, leaf = drawn(four_bar(rod=0.05, rocker=0.05))
    said = " ".join(text.plain for text in texts(leaf)).replace("\N{NO-BREAK SPACE}", " ")
    assert "Gaps: 0–11: out of reach at B" in said and "reach from" in said
    assert "Velocity plan" not in said


def test_a_position_that_is_a_gap_is_not_drawn_as_the_shown_one() -> None:
    study = LinkageStudy(parse_scene(four_bar(crank=0.3, rod=0.2, rocker=0.25, start=20) + "[sheet]\nposition = 6\n"))
    with pytest.raises(ValueError, match="position = 6"):
        sheets(study, compare(study))
    assert drawn(four_bar() + "[sheet]\nposition = 11\n")[1].metadata["plans"][0] == 11  # its plans stand beside it


def test_a_title_in_letters_that_the_alphabet_lacks_is_refused_before_drawing() -> None:
    with pytest.raises(UnknownLetter, match="机"):
        drawn(four_bar() + '[sheet]\ngroup = "机构"\n')


@pytest.mark.parametrize(("tight", "counts"), [(laid.TIGHT, [1]), (1.0, [1, 2])])
def test_remarks_that_can_be_read_where_the_notes_stand_are_no_reason_for_a_further_sheet(
    tight: float, counts: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    compose, sets, notes = laid.compose, list[int](), kinematics.notes
    monkeypatch.setattr(kinematics, "notes", lambda *asked: [*notes(*asked), "as long as a line of notes is " * 24])
    monkeypatch.setattr(laid, "TIGHT", tight)
    monkeypatch.setattr(laid, "compose", lambda *asked: sets.append(len(own := compose(*asked))) or own)
    assert len(leaves(Study(read_scene(GALLERY / "crank-rocker.toml")))) == 1
    assert sets == counts
