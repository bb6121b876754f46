"""What is due and not there is missing; what is not read is never right; what is there twice is not graded."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

from drawings.form.form import form_of
from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.curves.form_figure import places_filled
from drawings.grading.graded import FAIL, PASS, UNREAD, Graded, SheetTask, grade
from drawings.grading.verdict import Marking, Verdict, points_of
from drawings.paper.strokes import Group, Text
from drawings.pens.svg import svg
from drawings.pytest_plugin.assertions import assert_close_to_analysis
from drawings.pytest_plugin.assignment import Assignment
from drawings.pytest_plugin.handed_sheet import HandedSheet
from drawings.reading.alphabet import folded
from drawings.reading.sheet import see
from drawings.sheets.kind import table_of
from tests.drawings.cell_students import key_of, tables_of, written
from tests.drawings.form_students import form_leaf, position_on_form
from tests.drawings.students import task
from tests.drawings.test_curve_grading import on_form

HAND = Allowances()


def test_a_table_that_was_taken_off_a_sheet_of_ours_is_missing() -> None:
    own = task("shaper")
    sheet = own.originals.sheets[0]
    leaf = tables_of(sheet)
    kept = tuple(one for one in leaf.groups if table_of(sheet.kind, one.name) != "output")
    assert len(kept) < len(leaf.groups)
    graded = grade(svg(leaf._replace(groups=kept)), SheetTask(tables=own.tables), HAND)
    assert graded.outcome == FAIL
    assert {(one.plan, one.kind) for one in graded.wrong} == {("table output", "missing")}
    won, most = points_of(graded.verdicts, Marking())
    assert most - won == 0.25 * len(own.table("output").cells)


def test_a_table_whose_lines_are_lost_is_not_read_and_not_missing() -> None:
    own = task("shaper")
    sheet = own.originals.sheets[0]
    leaf = tables_of(sheet)
    groups = (unruled(one) if table_of(sheet.kind, one.name) == "output" else one for one in leaf.groups)
    graded = grade(svg(leaf._replace(groups=tuple(groups))), SheetTask(tables=own.tables), HAND)
    assert (graded.outcome, [one.kind for one in graded.unseen]) == (UNREAD, ["untabled"])


def test_of_a_form_all_of_whose_letters_are_outlines_no_table_is_missing() -> None:
    own, leaf = task("shaper"), form_leaf("shaper")
    bare = leaf._replace(groups=tuple(map(wordless, leaf.groups)))
    plan = next(plan for plan in own.plans if plan.plan == "positions")
    source = re.sub(rb"<text.*?</text>", b"", position_on_form(bare, plan))
    graded = grade(source, SheetTask((plan,), tables=own.tables), HAND)
    assert {one.kind for one in graded.verdicts if one.plan.startswith("table")} == {"untabled"}


def wordless(group: Group) -> Group:
    """Give a table without its words."""
    inside = (wordless(one) if isinstance(one, Group) else one for one in group.strokes)
    return group._replace(strokes=tuple(one for one in inside if not isinstance(one, Text)))


def unruled(group: Group) -> Group:
    """Give a table without its lines."""
    inside = (unruled(one) if isinstance(one, Group) else one for one in group.strokes)
    return group._replace(strokes=tuple(one for one in inside if isinstance(one, Group | Text)))


def test_a_row_that_was_taken_off_a_form_is_missing() -> None:
    own = task("shaper")
    table, sheet = own.table("values"), own.originals.sheets[0]
    leaf = tables_of(sheet._replace(leaf=form_of(own.originals.study)["kinematics"][0]))
    less = leaf._replace(groups=tuple(unnamed(one, "atA,") for one in leaf.groups))
    source = written(less, table, {key_of(table, "vB", "by plan", 2): "1.517"})
    graded = grade(source, SheetTask(tables=own.tables), HAND)
    kinds = Counter(one.kind for one in graded.verdicts)
    assert kinds == {"right": 1, "missing": sum(len(one.cells) for one in own.tables) - 1}


def unnamed(group: Group, row: str) -> Group:
    """Give a table without the name of a row."""
    inside = (unnamed(one, row) if isinstance(one, Group) else one for one in group.strokes)
    kept = (one for one in inside if not (isinstance(one, Text) and folded(one.plain).startswith(row)))
    return group._replace(strokes=tuple(kept))


def test_one_of_two_copies_of_a_table_is_to_be_left() -> None:
    own = task("shaper")
    table, leaf = own.table("values"), tables_of(own.originals.sheets[0])
    same, other = (
        beside(svg(leaf), written(leaf, table, {key_of(table, "vB", "by plan", 2): text})) for text in ("", "9.99")
    )
    assert grade(same, SheetTask(tables=own.tables), HAND).outcome == PASS  # what stands in one of them alone
    graded = grade(other, SheetTask(tables=own.tables), HAND)
    assert (graded.outcome, [(one.name, one.kind) for one in graded.unseen]) == (UNREAD, [("v_B (by plan)", "doubled")])


def beside(source: bytes, other: bytes) -> bytes:
    """Lay what stands on another sheet on one, to the left of it."""
    copy = re.sub(rb' id="[^"]*"', b"", other[other.index(b"<g ") : other.rindex(b"</svg>")])
    return source.replace(b"</svg>", b'<g transform="translate(-330 0)">' + copy + b"</g></svg>")


def test_one_of_two_curves_on_a_pair_of_axes_is_to_be_left() -> None:
    own = task("slider-crank")
    source, other = on_form(own, {"velocity": 1.0}), on_form(own, {"velocity": 1.3})
    begun = other.index(b'<path style="fill:none;stroke:#00f')
    path = other[begun : other.index(b"<text x=", begun)]
    graded = grade(source.replace(b"</svg>", path + b"</svg>"), SheetTask(curves=own.figures), HAND)
    assert ("diagrams-velocity", "doubled") in [(one.plan, one.kind) for one in graded.unseen]
    assert {plan for plan, filled in places_filled(see(source)).items() if filled} == {"diagrams-velocity"}


@pytest.mark.parametrize("kind", verdict.UNSEEN)
def test_what_is_not_read_fails_a_test(kind: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    own = task("shaper").originals
    graded = Graded(UNREAD, (Verdict("table values", None, "", kind),))
    monkeypatch.setattr(Assignment, "graded", lambda *_: graded)
    sheet = HandedSheet(tmp_path / "ann.svg", Assignment(own))
    with pytest.raises(AssertionError, match="not graded"):
        assert_close_to_analysis(sheet)
