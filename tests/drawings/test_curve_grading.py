"""Grading of curves: our own graphs are right, a mistake is found and named, what follows from it loses nothing."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from drawings.forces.due_acting import Branch, branches
from drawings.form.blank_file import blank_file
from drawings.form.form import form_of
from drawings.grading.allowance import EXACT, Allowance, Allowances
from drawings.grading.curves.figure_judge import allowed_of
from drawings.grading.curves.form_figure import every_axes
from drawings.grading.feedback import lines
from drawings.grading.graded import PASS, UNREAD, SheetTask, grade
from drawings.grading.verdict import Marking
from drawings.paper.strokes import Circle, Leaf
from drawings.paper.walk import groups
from drawings.reading.sheet import see
from drawings.redrawn import Originals
from plans.model.motion import Complexes
from tests.drawings.curve_students import made
from tests.drawings.students import Task, task
from tests.mistakes import mistakes

HAND = Allowances()
SHARE = Allowances(Allowance(share=0.02))
CASES = Path(__file__).parents[1] / "cases"
MISTAKES = mistakes("curve_mistakes")


def said(own: Task, source: bytes) -> list[str]:
    wrong = grade(source, SheetTask(curves=own.figures), HAND).wrong
    out = [(one.off, one.allowed) for one in wrong if one.kind == "wrong" and one.off and one.allowed]
    assert all(off > allowed for off, allowed in out)
    return sorted(" ".join(filter(None, (one.plan, one.name, one.kind))) for one in wrong)


def ours_are_right(own: Task, ways: tuple[Allowances, ...] = (HAND, Allowances(EXACT), SHARE)) -> None:
    for sheet in own.originals.sheets:
        due = [one for one in own.figures if one.sheet == sheet.name]
        for by in ways if due else ():
            graded = grade(own.originals.drawn(sheet), SheetTask(curves=own.figures), by)
            assert (graded.outcome, graded.wrong) == (PASS, ()), sheet.name
            assert len(graded.verdicts) == sum(len(one.items) for one in due)


@pytest.mark.rest
def test_a_curve_may_end_before_a_dead_centre() -> None:
    originals = Originals(CASES / "alarms" / "curve-short-of-a-dead-centre.toml")
    ours_are_right(Task(originals))


def test_a_share_is_of_the_largest_value_that_is_known() -> None:
    figure = task("slider-crank").figures[0]
    known = replace(figure, true=np.where(np.arange(len(figure.true)) == 0, np.nan, figure.true))
    allowed = allowed_of(known, SHARE, 0.0)
    assert (allowed >= 0.02 * np.abs(figure.true[1:]).max()).all()


def found(row: dict[str, Any]) -> None:
    own = task(row["scene"])
    assert said(own, made(own, row)) == sorted(row["says"]), row["name"]


def on_form(own: Task, heights: dict[str, float], scaled: bool = True) -> bytes:
    """Draw graphs on a form as an editor does: each a line through its values, times a factor, and its scale."""
    figures = [own.figure(key) for key in heights]
    leaf = blank_leaf(own.originals.path.stem, figures[0].plan)
    source = blank_file(leaf)
    seen, parts = see(source), []
    for one, times in zip(figures, heights.values(), strict=True):
        blank = every_axes(seen)[one.plan]
        assert blank is not None and one.paper is not None
        step = (blank.ticks[-1] - blank.ticks[0]) / (len(blank.ticks) - 1)
        across = blank.origin.real + one.paper.along / (2 * np.pi) * len(blank.ticks) * step
        up = leaf.height - blank.origin.imag - times * (one.true / one.way).real / one.scale
        points = " ".join(f"{x:.3f},{y:.3f}" for x, y in zip(across, up, strict=True))
        parts.append(f'<path style="fill:none;stroke:#00f;stroke-width:0.5" d="M {points}"/>')
        if scaled:
            text = f"μ{next(iter(one.scales))} = {one.scale:g} u/mm"
            parts.append(f'<text x="{blank.origin.real + 20}" y="{leaf.height - blank.top - 2}">{text}</text>')
    return source.replace(b"</svg>", "".join(parts).encode() + b"</svg>")


@cache
def forms(scene: str) -> tuple[Leaf, ...]:
    return tuple(leaf for leaves in form_of(task(scene).originals.study).values() for leaf in leaves)


def blank_leaf(scene: str, plan: str) -> Leaf:
    return next(leaf for leaf in forms(scene) if any(one.data.get("plan") == plan for one in leaf.groups))


def test_a_graph_on_the_axes_of_a_form_is_read() -> None:
    own = task("slider-crank")
    due = dict.fromkeys(("travel", "velocity", "acceleration"), 1.0)
    assert said(own, on_form(own, {**due, "acceleration": -1.0})) == ["diagrams-acceleration inverted"]
    assert said(own, on_form(own, due, scaled=False)) == [f"diagrams-{key} unscaled" for key in sorted(due)]
    lost = grade(on_form(own, {"travel": 1.0}), SheetTask(curves=own.figures), HAND).wrong
    assert {one.kind for one in lost} == {"missing"}


def line_on_form(own: Task, key: str, values: Complexes) -> bytes:
    """Draw a line through the values of a figure in its place on a form, as an editor does."""
    asked = own.figure(key)
    leaf = blank_leaf(own.originals.path.stem, asked.plan)
    places = (one for one in groups(leaf.groups) if one.data.get("kind") == "place")
    place = next(one for one in places if one.data["plan"] == asked.plan)
    pole = next(one for one in groups((place,)) if one.data.get("kind") == "pole").strokes[0]
    assert isinstance(pole, Circle)
    spots = pole.centre + values[list(asked.curved)] / float(place.data["scale"])
    points = " ".join(f"{spot.real:.3f},{leaf.height - spot.imag:.3f}" for spot in spots.tolist())
    return blank_file(leaf).replace(b"</svg>", f'<path style="fill:none;stroke:#00f" d="M {points} Z"/></svg>'.encode())


def of(plan: str, told: list[str]) -> list[str]:
    """Give what is said of one figure: all others are missing on the form."""
    return [one for one in told if one.startswith(f"{plan} ")]


@pytest.mark.rest
def test_a_profile_in_its_place_on_a_form_is_read() -> None:
    own = task("valve-cam")
    asked = own.figure("profile points")
    for values, due in ((asked.true, []), (-asked.true.conj(), ["profile backwards"])):
        told = said(own, line_on_form(own, asked.key, np.asarray(values)))
        assert of("profile", told) == due
        assert {one.rpartition(" ")[2] for one in of("pressure", told)} == {"missing"}  # no curve of another figure


@pytest.mark.rest
def test_the_least_radius_of_a_line_is_found_as_far_as_it_lies_out() -> None:
    own = task("feed-cam")
    base = next(one for one in own.figure("profile points").mistakes if one.kind == "base")
    assert base.along is not None
    values = np.asarray(base.values + 6 * own.figure("profile points").scale * base.along)
    assert of("profile", said(own, line_on_form(own, "profile points", values))) == ["profile base"]


@pytest.mark.rest
def test_a_diagram_of_sizes_on_a_form_is_read() -> None:
    own = task("feed-cam")
    sizes = own.figure("sizes").true
    for times, due in ((1.0, []), (1.2, ["sizes factor"])):
        assert of("sizes", said(own, line_on_form(own, "sizes", times * sizes))) == due


def test_a_load_on_its_axes_on_a_form_is_read_on_either_branch() -> None:
    own = task("slider-crank")
    plan = "load_diagram-F_g"
    for way, due in ((1.0, []), (-1.0, [f"{plan} inverted"])):
        assert of(plan, said(own, load_on_form(own, way))) == due


def load_on_form(own: Task, way: float) -> bytes:
    """Draw the load diagram on its axes on a form, both branches by their corners, 60 mm long and 40 mm high."""
    asked, leaf = own.figure("load_diagram-F_g"), blank_leaf("slider-crank", "load_diagram-F_g")
    source = blank_file(leaf)
    blank = every_axes(see(source))[asked.plan]
    assert blank is not None and asked.paper is not None
    across, up = 60 / asked.paper.along.max(), 40 / np.abs(asked.true).max()
    x, y = blank.origin.real, leaf.height - blank.origin.imag
    paths = []
    for one in law(own):
        corners = zip(one.shares * asked.paper.along.max(), one.sizes, strict=True)
        points = " ".join(f"{x + across * s:.3f},{y - way * up * f:.3f}" for s, f in corners)
        paths.append(f'<path style="fill:none;stroke:#00f" d="M {points}"/>')
    scales = (
        f'<text x="{x + 20}" y="{leaf.height - blank.top - 2}">μS = {1 / across:g} u/mm; μF = {1 / up:g} u/mm</text>'
    )
    return source.replace(b"</svg>", ("".join(paths) + scales).encode() + b"</svg>")


def law(own: Task) -> list[Branch]:
    """Give the branches of the load of a scene, as its own check reads them."""
    machine = own.originals.study["forces"].machine
    return [branch for load in machine.forces if load.name == "F_g" for branch in branches(load)]


@pytest.mark.rest
def test_a_loop_on_its_axes_on_a_form_is_read() -> None:
    own = task("planer")
    loop = own.figure("loop").true
    for values, due in ((loop, []), (np.asarray(1j * loop.conj()), ["loop axes"])):
        assert of("loop", said(own, loop_on_form(own, values))) == due


def loop_on_form(own: Task, values: Complexes, reduced: float = 0.25) -> bytes:
    """Draw a loop on its axes on a form, so much smaller than on our own sheet, with its scales."""
    asked, leaf = own.figure("loop"), blank_leaf(own.originals.path.stem, "loop")
    source = blank_file(leaf)
    blank = every_axes(see(source))["loop"]
    assert blank is not None
    spots = (blank.origin + reduced * values).tolist()
    points = " ".join(f"{spot.real:.3f},{leaf.height - spot.imag:.3f}" for spot in spots)
    text = "; ".join(f"μ{letter} = {mu / reduced:g} u/mm" for letter, mu in asked.scales.items())
    line = f'<path style="fill:none;stroke:#00f" d="M {points} Z"/>'
    written = f'<text x="{blank.origin.real + 20}" y="{leaf.height - blank.top - 2}">{text}</text>'
    return source.replace(b"</svg>", (line + written).encode() + b"</svg>")


def test_curves_without_marks_and_axes_are_not_read() -> None:
    own = task("slider-crank")
    text = own.originals.drawn(own.originals.sheets[0]).decode()
    bare = re.sub(r"<metadata.*?</metadata>", "", re.sub(r' data-(?!text)[a-z]+="[^"]*"', "", text), flags=re.DOTALL)
    graded = grade(bare.encode(), SheetTask(curves=own.figures), HAND)
    assert graded.outcome == UNREAD
    assert graded.reason is not None and "plandraft form" in str(graded.reason)


def test_what_follows_is_told_by_its_name_alone() -> None:
    own = task("slider-crank")
    row = next(row for row in MISTAKES if row["scene"] == "slider-crank" and row["how"] == "times")
    graded = grade(made(own, row), SheetTask(curves=own.figures), HAND)
    told = list(lines(Path("ann.svg"), graded, Marking(), {}, "en"))
    assert "v_1, v_2" in told[-1]
    assert "None" not in " ".join(told)
