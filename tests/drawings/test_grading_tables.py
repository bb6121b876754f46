"""Grading of tables: a scene's own are right, what a student writes in a cell is read, a mistake is named."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

from drawings.form.form import form_of
from drawings.grading.allowance import Allowances
from drawings.grading.feedback import feedback
from drawings.grading.graded import FAIL, UNREAD, SheetTask, grade
from drawings.grading.verdict import points_of, read_marking
from drawings.pens.svg import svg
from tests.drawings.cell_students import both, cells_of, key_of, made, tables_of, written
from tests.drawings.students import Task, gone_on, task, true_places
from tests.drawings.test_grading import laid
from tests.mistakes import mistakes
from tests.rows import over

DRAWN = ("positions", "velocities", "accelerations", "diagrams", "notes")  # figures, which take long to read
HAND = Allowances()
MISTAKES = mistakes("table_mistakes")


def said(own: Task, source: bytes) -> list[str]:
    wrong = grade(source, SheetTask(tables=own.tables), HAND).wrong
    return sorted(" ".join(filter(None, (one.name, one.kind, one.of))) for one in wrong)


@pytest.mark.rest
def test_of_a_blank_form_all_cells_are_missing() -> None:
    own = task("shaper")
    leaf = form_of(own.originals.study)["kinematics"][0]
    asked = SheetTask(task("shaper").plans, tables=own.tables)
    graded = grade(svg(leaf), asked, HAND)
    assert graded.outcome == FAIL
    assert {one.kind for one in graded.verdicts if one.plan.startswith("table")} == {"missing"}
    alone = grade(svg(tables_of(own.originals.sheets[0]._replace(leaf=leaf))), asked, HAND)
    assert alone.outcome == UNREAD  # with its plans lost it is not marked down


def test_the_tables_of_a_form_are_filled_in_cell_by_cell() -> None:
    """A form has each table in one piece, and stands otherwise on the sheet than ours."""
    own = task("shaper")
    form = own.originals.sheets[0]._replace(leaf=form_of(own.originals.study)["kinematics"][0])
    table, leaf = own.table("values"), tables_of(form)
    right = {key_of(table, "vB", "by plan", 2): "1.517", key_of(table, "ω4", "by plan", 9): "-2.587"}
    wrong = {key_of(table, "vD", "by plan", 2): "0.7"}
    graded = grade(written(leaf, table, right | wrong), SheetTask(tables=own.tables), HAND)
    kinds = Counter(one.kind for one in graded.verdicts)
    assert kinds == {"right": 2, "wrong": 1, "missing": 2 * 2 * 22 + 12 * 4 - 3}
    assert [" ".join((one.name, one.kind)) for one in graded.wrong if one.kind != "missing"] == ["v_D (by plan) wrong"]


@pytest.mark.rest
@over("how", ["translate(30 20) scale(0.8)", "rotate(90 300 300) scale(0.6)"])
def test_tables_are_found_on_a_sheet_that_was_moved_as_a_whole(how: str) -> None:
    own = task("shaper")
    row = next(one for one in MISTAKES if one["says"] == ["v_B (by plan) wrong"])
    corners = tuple(one for one in own.originals.sheets[0].leaf.groups if not one.name.startswith(DRAWN))
    leaf = own.originals.sheets[0].leaf._replace(groups=corners)
    assert said(own, laid(svg(leaf), how)) == []
    table = own.table("values")
    source = written(leaf, table, {key_of(table, "vB", "by plan", 2): "3.02"})
    assert said(own, laid(source, how)) == row["says"]


def test_a_number_read_off_a_wrong_plan_follows() -> None:
    """The vector of B is too long: its size, and the rate of the connecting rod read off from there, lose nothing."""
    own = task("shaper")
    plan = own.plan("velocities", 2)
    moved = gone_on(plan, {"b": 1.3 * true_places(plan)["b"]})
    table, sheet = own.table("values"), own.originals.sheets[0]
    size, rate = abs(moved["b"]), 1.3 * 1.598
    texts = {key_of(table, "vB", "by plan", 2): f"{size:.3f}", key_of(table, "ω4", "by plan", 2): f"{-rate:.3f}"}
    source = both(sheet, plan, moved, table, texts)
    verdicts = grade(source, SheetTask(own.plans, tables=own.tables), HAND).verdicts
    kinds = {one.name: one.kind for one in verdicts if one.plan == "table values" and one.position == 2}
    assert (kinds["v_B (by plan)"], kinds["ω_4 (by plan)"]) == ("follows", "follows")
    alone = grade(written(tables_of(sheet), table, texts), SheetTask(tables=own.tables), HAND)
    assert sorted(one.name for one in alone.wrong) == ["v_B (by plan)", "ω_4 (by plan)"]


def test_points_of_a_cell_are_told_apart_from_those_of_its_vector(tmp_path: Path) -> None:
    own, marks = task("shaper"), tmp_path / "marks.toml"
    marks.write_text('[points]\ndefault = 1\nv_B = 5\ntable = 0.25\n"table v_B" = 2\n[keeps]\nsign = 0.5\n', "utf-8")
    table = own.table("values")
    wrong = {key_of(table, "vB", "by plan", 2): "", key_of(table, "ω4", "by plan", 2): "1.6"}
    graded = grade(written(tables_of(own.originals.sheets[0]), table, wrong), SheetTask(tables=own.tables), HAND)
    won, most = points_of(graded.verdicts, read_marking(marks))
    assert (most, most - won) == (0.25 * (21 * 2 + 12 * 4) + 2 * 2, 2 + 0.125)  # of two roads one cell


def test_feedback_frames_a_table_that_is_empty() -> None:
    own = task("shaper")
    table, leaf = own.table("output"), tables_of(own.originals.sheets[0])
    source = written(leaf, table, dict.fromkeys(table.cells, ""))
    graded = grade(source, SheetTask(tables=own.tables), HAND)
    text = feedback(Path("ann.svg"), source, graded, {}, "en").decode()
    frames = re.findall(r'<polygon points="([^"]*)"', text)
    spots = [complex(*map(float, spot.split(","))) for frame in frames for spot in frame.split()]
    boxes = [cell.box for key, cell in cells_of(leaf, table).items() if key in table.cells]
    assert min(spot.real for spot in spots) == pytest.approx(min(box.left for box in boxes), abs=1e-3)
    assert max(spot.real for spot in spots) == pytest.approx(max(box.right for box in boxes), abs=1e-3)
    assert leaf.height - min(spot.imag for spot in spots) == pytest.approx(max(box.high for box in boxes), abs=1e-3)
    assert leaf.height - max(spot.imag for spot in spots) == pytest.approx(min(box.low for box in boxes), abs=1e-3)


def test_feedback_marks_the_cell_and_tells_no_value() -> None:
    own = task("shaper")
    source = made(own, next(one for one in MISTAKES if one["says"] == ["ω_4 (by plan) sign"]))
    graded = grade(source, SheetTask(tables=own.tables), HAND)
    text = feedback(Path("ann.svg"), source, graded, {}, "en").decode()
    notes = " ".join(re.findall(r"<text[^>]*>([^<]*)</text>", text))
    assert "the sign is wrong" in " ".join(notes.split())
    assert not re.search(r"\d[.,]\d", notes)
    assert text.count('id="wrong-') == 1


def test_what_an_editor_draws_in_a_cell_is_not_marked_down() -> None:
    """A number written by hand or turned into a path is told to the teacher, and neither right nor wrong."""
    own = task("shaper")
    table, leaf = own.table("values"), tables_of(own.originals.sheets[0])
    key = key_of(table, "vB", "by plan", 2)
    box = cells_of(leaf, table)[key].box
    path = (
        f'<path d="M{box.left + 2} {leaf.height - box.low - 4}l3 -1l1 3" fill="none" stroke="#000" stroke-width="0.3"/>'
    )
    source = written(leaf, table, {key: ""}).replace(b"</svg>", path.encode() + b"</svg>")
    graded = grade(source, SheetTask(tables=own.tables), HAND)
    assert [(one.name, one.kind) for one in graded.verdicts if not one.good] == [("v_B (by plan)", "illegible")]
    assert graded.outcome == UNREAD


def test_the_zero_of_a_whole_column_of_varying_inertia_is_a_choice() -> None:
    own, table = task("press"), task("press").table("positions")
    new = {key: f"{cell.true + 0.03:.4f}" for key, cell in table.cells.items() if cell.quantity == "ΔJ"}
    assert not said(own, written(tables_of(own.sheet(table.sheets[0])), table, new))
    new.popitem()
    assert said(own, written(tables_of(own.sheet(table.sheets[0])), table, new)) == ["ΔJ level"]
