"""Grading of free vectors: polygons of forces, of rotors, of mechanisms and of banks; arms; the lever."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from drawings.grading.allowance import Allowances
from drawings.grading.asked import Found, PlanAsked, VectorAsked
from drawings.grading.drawn_plan import Arrow, DrawnPlan, open_sides
from drawings.grading.graded import SheetTask, grade
from drawings.grading.verdict import UNGROUPED
from drawings.paper.strokes import Arc, Fill, Group, Line, Stroke, Text
from geometry.board import Board, Mark, Span
from geometry.replay import redraw
from tests.draughtsman import Draughtsman, copies
from tests.drawings.students import Task, lettered, task
from tests.drawings.test_grading import laid as as_a_whole
from tests.drawings.vector_students import Laid, beside, free, laid, mark_of, sheet_of, turned
from tests.mistakes import mistakes

HAND = Allowances()
MISTAKES = mistakes("student_vector_mistakes")


def made(own: Task, row: dict[str, Any]) -> bytes:
    """Draw the sheet with a mistake of the table."""
    name, position = row["plan"]
    plans = beside(own, (name, position if position >= 0 else None))
    plan = next(one for one in plans if one.plan == name)
    how, vector = row["how"], row.get("vector", "")
    now = laid(plans, moved(plans, row))
    if how in ("alone times", "alone back", "alone turned", "slant"):
        now[name, vector] = Laid(drawn_otherwise(plan, row, now[name, vector].value), now[name, vector].start)
    if how == "plan times":
        now |= {key: Laid(one.value * row["by"], one.start * row["by"]) for key, one in now.items() if key[0] == name}
    if how == "plan turned":
        own_ = {key: one for key, one in now.items() if key[0] == name}
        now |= {key: Laid(turned(one.value, row["by"]), turned(one.start, row["by"])) for key, one in own_.items()}
    if how == "mirrored":
        own_ = {key: one for key, one in now.items() if key[0] == name}
        now |= {key: Laid(one.value.conjugate(), one.start.conjugate()) for key, one in own_.items()}
    return sheet_of(own, plans, now, lambda stroke: kept(stroke, plan, row))


def drawn_otherwise(plan: PlanAsked, row: dict[str, Any], value: complex) -> complex:
    """Draw one vector otherwise and nothing else."""
    if row["how"] == "slant":
        found = next(one.found for one in plan.vectors if one.name == row["vector"])
        assert found is not None
        return found.slips[0].value
    by = row.get("by", 0)
    return {"alone times": value * by, "alone back": -value, "alone turned": turned(value, by)}[row["how"]]


def moved(plans: tuple[PlanAsked, ...], row: dict[str, Any]) -> dict[Mark, complex]:
    """Give the vector that is drawn otherwise, from which all goes on."""
    how, by = row["how"], row.get("by", 0)
    one = {
        "back": lambda value: -value,
        "times": lambda value: by * value,
        "turned": lambda value: turned(value, by),
        "left out": lambda value: 0j,
    }
    if how in one:
        mark = mark_of(plans, row["vector"])
        return {mark: one[how](complex(np.ravel(mark.point)[0]))}
    if how.startswith("moment"):  # a term of an equation of moments turned round, or forgotten
        force = mark_of(plans, row["vector"])
        term = next(one for one in force.step.inputs[2:] if row["of"] in (one.name, *(a.name for a in one.step.inputs)))
        value = 0.0 if how == "moment left out" else -float(np.ravel(term.point)[0].real)
        return {force: complex(np.ravel(redraw([force], {term: value})[force].point)[0])}
    return {}


def shown_back(arrow: Group) -> Group:
    """Turn an arrow that is not to scale the other way about where it begins."""
    line, *heads = arrow.strokes
    assert isinstance(line, Line)
    again = [
        one._replace(points=tuple(2 * line.start - at for at in one.points)) for one in heads if isinstance(one, Fill)
    ]
    return arrow._replace(strokes=(line._replace(end=2 * line.start - line.end), *again))


def turned_back(couple: Group) -> Group:
    """Draw the arc of a couple with its head at its other end."""
    arc, head = couple.strokes
    assert isinstance(arc, Arc) and isinstance(head, Fill)
    way = (arc.at(0.5) - arc.centre) / arc.radius
    points = tuple(arc.centre + way**2 * (spot - arc.centre).conjugate() for spot in head.points)
    return couple._replace(strokes=(arc, head._replace(points=points)))


def _is_arrow(group: Group, name: str) -> bool:
    return (group.data.get("kind"), group.data.get("name")) == ("force", name)


def kept(stroke: Stroke, plan: PlanAsked, row: dict[str, Any]) -> Stroke | None:
    """Give a stroke as a mistake of drawing leaves it."""
    names = row.get("vector", "").split(" ")
    letters = {one.name: lettered(one.letter) for one in plan.vectors}
    if isinstance(stroke, Group) and row.get("arrow") and _is_arrow(stroke, names[0]):
        return shown_back(stroke)
    if isinstance(stroke, Group) and (stroke.data.get("kind"), stroke.data.get("name")) == ("couple", row.get("arc")):
        return None if row["how"] == "not shown" else turned_back(stroke)
    if isinstance(stroke, Group) and (stroke.data.get("plan"), stroke.data.get("name")) == (plan.plan, names[0]):
        if row["how"] in ("missing", "left out"):
            return None
        if row["how"] == "swapped ends":
            line, *_ = stroke.strokes
            assert isinstance(line, Line)
            return stroke._replace(strokes=(line._replace(start=line.end, end=line.start),))
        if row["how"] == "end aside":
            line, *heads = stroke.strokes
            assert isinstance(line, Line)
            return stroke._replace(strokes=(line._replace(end=line.end + complex(*row["by"])), *heads))
    if isinstance(stroke, Text):
        if row["how"] == "unscaled" and stroke.plain.startswith("μ"):
            return None
        if row["how"] == "unlettered" and stroke.plain == letters[names[0]]:
            return None
        if row["how"] == "letters swapped" and stroke.plain in (letters[names[0]], letters[names[1]]):
            other = names[stroke.plain == letters[names[0]]]
            return stroke._replace(content=next(one.letter for one in plan.vectors if one.name == other))
    return stroke


def said(own: Task, source: bytes) -> list[str]:
    graded = grade(source, SheetTask(own.plans), HAND)
    assert graded.reason is None, graded.reason.worded("en")
    return sorted(" ".join(filter(None, (one.name, one.kind, one.of))) or one.kind for one in graded.wrong)


def passed(scene: str, place: tuple[str, int | None], slip: float, count: int) -> int:
    """Tell how many of some chance drawings have no vector that is refused."""
    own = task(scene)
    plans = beside(own, place)
    keys, rng = free(plans), np.random.default_rng(7)
    scales = {name: np.array([mu]) for plan in plans for name, mu in plan.scales.items()}
    spans = {key: (*one.found.span, *(one.found.side or ())) for key, one in keys.items() if one.found}
    spots = copies(Draughtsman(slip, scales, count, rng), *(mark for span in spans.values() for mark in span))
    good = 0
    for k in range(count):
        now = {}
        for key, span in spans.items():
            at = [complex(np.broadcast_to(spots[mark], (count, 1))[k, 0]) for mark in span]
            ends = slip * scales[key[0]][0] * (rng.uniform(-1, 1, 2) + 1j * rng.uniform(-1, 1, 2))
            now[key] = Laid(
                at[1] - at[0] + complex(ends[1] - ends[0]), (at[2] if len(at) > 2 else 0j) + complex(ends[0])
            )
        graded = grade(sheet_of(own, plans, now, lambda stroke: stroke), SheetTask(own.plans), HAND)
        good += not [one for one in graded.wrong if one.letters != ("", "")]
    return good


def test_a_fair_hand_is_accepted_and_a_poor_one_refused() -> None:
    assert passed("fan", ("couples", None), 0.2, 2) == 2
    assert passed("fan", ("couples", None), 2.0, 2) == 0


def test_a_turned_sheet_is_not_told_that_its_scales_are_missing() -> None:
    own = task("fan")
    source = as_a_whole(own.originals.drawn(own.originals.sheets[0]), "translate(297 0) rotate(90) scale(0.7)")
    assert said(own, source) == []


@pytest.mark.rest
def test_the_arrows_of_a_scheme_that_was_taken_apart_are_not_graded() -> None:
    own = task("shaper-loaded")
    sheet = own.originals.sheets[0]
    graded = grade(re.sub(rb' id="(scheme|lever)-[^"]*"', b"", own.originals.drawn(sheet)), SheetTask(own.plans), HAND)
    figures = {(one.plan, one.position) for one in own.plans if one.sheet == sheet.name and one.ways}
    assert graded.wrong == ()
    assert {(one.plan, one.position) for one in graded.verdicts if one.kind == UNGROUPED} == figures


CORNERS = {"A": 0j, "B": 80 + 10j, "C": 50 + 70j, "D": 20 + 120j}  # mm


@pytest.mark.parametrize(("drawn", "is_open"), [("BC AB CA", False), ("BC AB CA CD", True), ("BC AB CA DC", True)])
def test_a_polygon_in_another_order_is_closed_where_no_end_is_left_over(drawn: str, is_open: bool) -> None:
    names, board = drawn.split(), Board("forces")
    marks = [board.given(name, 0j) for name in names]
    sides = [Span(*ends) for ends in zip(marks, (*marks[1:], marks[0]), strict=True)]
    own = tuple(VectorAsked(name, "", name, 0j, Found(name, one, one)) for name, one in zip(names, sides, strict=True))
    arrows = {one.letters: Arrow(*(CORNERS[end] for end in one.end)) for one in own}
    plan = DrawnPlan(PlanAsked("forces-2-3", 2, "forces", "N", own, {}), arrows, 1.0, {})
    assert bool([*open_sides(plan, 0.5)]) == is_open
