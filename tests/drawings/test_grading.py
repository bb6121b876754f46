"""Grading: a scene's own sheet is right, a mistake is found and named, and what follows from it loses nothing."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping
from functools import partial
from typing import Any

import pytest

from drawings.checks.expected import Expected
from drawings.grading.allowance import Allowance, Allowances
from drawings.grading.asked import PlanAsked, plans_asked
from drawings.grading.graded import FAIL, PASS, UNREAD, SheetTask, grade
from drawings.grading.judgement import turned_over
from drawings.paper.strokes import Group, Key, Kind, Line, Stroke, Text
from drawings.redrawn import Original, Originals
from tests.drawings.students import ASIDE, Task, drawn, gone_on, lettered, marks_of, task, true_places
from tests.mistakes import mistakes
from tests.parts import first

HAND = Allowances()
MISTAKES = mistakes("student_mistakes")


def made(own: Task, row: dict[str, Any], without: tuple[str, ...] = ASIDE) -> bytes:
    """Draw the sheet with a mistake of the table, and without some of its parts."""
    plan = own.plan(*row["plan"])
    sheet, places = own.sheet(plan.sheet), true_places(plan)
    draw = partial(drawn, sheet, plan, aside=without)
    start, _, end = row.get("vector", " ").partition(" ")
    vector = places.get(end, 0j) - places.get(start, 0j)
    by = row.get("by", 0)
    one = {
        "back": lambda: -vector,
        "times": lambda: by * vector,
        "turned": lambda: vector * cmath.rect(1, math.radians(by)),
    }
    every = {
        "mirrored": lambda place: place.conjugate(),
        "plan turned": lambda place: place * cmath.rect(1, math.radians(by)),
        "plan times": lambda place: place * by,
    }
    if row["how"] in one:
        return draw(gone_on(plan, {start: places[start], end: places[start] + one[row["how"]]()}))
    if row["how"] in every:
        return draw({letter: every[row["how"]](place) for letter, place in places.items()})
    if row["how"] == "branch":
        other = turned_over(marks_of(plan)[end])
        assert other is not None
        return draw(gone_on(plan, {end: other}))
    if row["how"] == "moved":
        aside = places[end] * (1 + by * plan.scales[plan.plan] / abs(places[end]))
        return draw({**places, end: aside})
    return draw(places, lambda stroke: kept(stroke, plan, row))


def kept(stroke: Stroke, plan: PlanAsked, row: dict[str, Any]) -> Stroke | None:
    """Give a stroke as a mistake of drawing leaves it."""
    start, _, end = row.get("vector", " ").partition(" ")
    if isinstance(stroke, Group):
        data = stroke.data
        if (data.get("plan"), data.get("position"), data.get("name")) == (
            plan.plan,
            str(plan.position),
            row.get("vector"),
        ):
            line = next(one for one in stroke.strokes if isinstance(one, Line))
            if row["how"] == "missing":
                return None
            if row["how"] == "swapped ends":
                return stroke._replace(strokes=(line._replace(start=line.end, end=line.start),))
            if row["how"] == "alone":
                return stroke._replace(strokes=(line._replace(end=line.end + row["by"]),))
        parts = (kept(one, plan, row) for one in stroke.strokes)
        return stroke._replace(strokes=tuple(one for one in parts if one is not None))
    if isinstance(stroke, Text):
        if row["how"] == "unscaled" and stroke.plain.startswith("μ"):
            return None
        if row["how"] == "unlettered" and stroke.plain == lettered(end):
            return None
        if row["how"] == "letters swapped" and stroke.plain in (lettered(start), lettered(end)):
            return stroke._replace(content=lettered(end if stroke.plain == lettered(start) else start))
    return stroke


def said(own: Task, source: bytes) -> list[str]:
    return sorted(f"{one.name} {one.kind}" for one in grade(source, SheetTask(own.plans), HAND).wrong)


@pytest.mark.parametrize(
    "source", [b"", b"<html/>", b"%PDF-1.7", b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>']
)
def test_what_is_no_sheet_is_rejected(source: bytes) -> None:
    graded = grade(source, SheetTask(task("slider-crank").plans), HAND)
    assert graded.outcome == UNREAD
    assert graded.reason is not None


def test_a_tolerance_is_a_share_of_the_largest() -> None:
    own, row = (
        task("shaper"),
        {"scene": "shaper", "plan": ["velocities", 9], "vector": "p a", "how": "times", "by": 1.01},
    )
    source = made(own, row)
    assert grade(source, SheetTask(own.plans), Allowances(Allowance(share=0.02))).outcome == PASS
    assert grade(source, SheetTask(own.plans), Allowances(Allowance(share=0.002))).outcome == FAIL


def test_a_vector_is_held_to_what_is_due(monkeypatch: pytest.MonkeyPatch) -> None:
    own = task("slider-crank")
    plan = own.plan("velocities", 2)
    real, key = Originals.expected, (Kind.VECTOR, "velocities", "p b", 2)

    def due(originals: Originals, sheet: Original) -> Mapping[Key, Expected]:
        rows = real(originals, sheet)
        return {**rows, key: rows[key]._replace(value=2 * rows[key].vector)} if key in rows else rows

    monkeypatch.setattr(Originals, "expected", due)
    asked = next(one for one in plans_asked(own.originals) if one.place == plan.place)
    told = [(one.name, one.true / two.true) for one, two in zip(asked.vectors, plan.vectors, strict=True)]
    assert [(name, round(abs(times), 6)) for name, times in told if abs(times - 1) > 1e-6] == [("v_B", 2.0)]


def bare(source: bytes) -> bytes:
    """Give a sheet without the data of its marks, as an editor leaves it that knows none."""
    text = re.sub(r' data-(?!text)[a-z]+="[^"]*"', "", source.decode())
    return re.sub(r"<metadata.*?</metadata>", "", text, flags=re.DOTALL).encode()


@pytest.mark.parametrize("language", first(["ru", "en"]))
def test_a_sheet_without_any_marks_is_rejected_with_what_to_do(language: str) -> None:
    own = task("shaper")
    graded = grade(bare(own.originals.drawn(own.originals.sheets[0])), SheetTask(own.plans), HAND)
    assert graded.outcome == UNREAD
    assert graded.reason is not None and graded.reason.key == "grade.bare"
    assert "plandraft form" in graded.reason.worded(language)


def test_an_arrow_drawn_anew_in_a_plan_of_ours_is_found() -> None:
    own = task("shaper")
    source = own.originals.drawn(own.originals.sheets[0]).decode()
    data = re.search(r' data-kind="vector" data-name="b d"[^>]*?data-value="[^"]*"', source)
    assert data is not None
    assert said(own, source.replace(data[0], "", 1).encode()) == []


def laid(source: bytes, how: str) -> bytes:
    """Lay all that is on a sheet elsewhere, as one group."""
    text = source.decode()
    start, end = text.index("<g "), text.rindex("</svg>")
    return f'{text[:start]}<g transform="{how}">{text[start:end]}</g>{text[end:]}'.encode()


@pytest.mark.parametrize("how", first(["translate(30 20) scale(0.8)", "rotate(90 300 300) scale(0.6)"]))
def test_a_sheet_that_was_moved_as_a_whole_is_laid_back(how: str) -> None:
    own = task("shaper")
    assert said(own, laid(own.originals.drawn(own.originals.sheets[0]), how)) == []
    assert said(own, laid(made(own, MISTAKES[0]), how)) == MISTAKES[0]["says"]


@pytest.mark.parametrize("how", first(["scale(0.9 0.8)", "translate(600 0) scale(-1 1)"]))
def test_a_stretched_or_mirrored_sheet_is_rejected(how: str) -> None:
    own = task("shaper")
    assert grade(laid(own.originals.drawn(own.originals.sheets[0]), how), SheetTask(own.plans), HAND).outcome == UNREAD
