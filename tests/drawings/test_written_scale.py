"""Scales as students write them: any power of ten, any prefix, mu or K; a ratio of lengths."""

from __future__ import annotations

import math

import pytest

from drawings.grading.allowance import Allowances
from drawings.grading.graded import SheetTask, grade
from drawings.grading.written_number import stated_scales
from drawings.paper.strokes import Group, Stroke, Text
from tests.drawings.students import drawn, task, true_places
from tests.drawings.test_curve_grading import on_form, said
from tests.rows import over

HAND = Allowances()
SPEED, MOMENT = {"v": "m/s"}, {"M": "N*m", "φ": ""}
STATED = [
    ("μ_{v} = 0,01 (м/с)/мм", SPEED, {"v": 0.01}),
    ("μ_v = 10 (mm/s)/mm", SPEED, {"v": 0.01}),
    ("μv=1·10⁻² (m/s)/mm", SPEED, {"v": 0.01}),
    ("mu_v = 1e-2 m/s/mm", SPEED, {"v": 0.01}),
    ("Scale μv = .01 (m/s)/mm, drawn by hand", SPEED, {"v": 0.01}),
    ("μv = 0.01 m/(s·mm)", SPEED, {"v": 0.01}),
    ("μv = 0.01 to a mm", SPEED, {"v": 0.01}),
    ("μv = 1 cm/s to 1 mm", SPEED, {"v": 0.01}),
    ("μ_v = 1/100 (m/s)/mm", SPEED, {"v": 0.01}),
    ("μφ = 0.02 rad to a mm", MOMENT, {"φ": 0.02}),
    ("μv = 0 m/s/mm", SPEED, {}),
    ("Kv = 100 mm/(m/s)", SPEED, {"v": 0.01}),
    ("K_v = 0,1 мм/(мм/с)", SPEED, {"v": 0.01}),
    ("μM=4 N·m/mm", MOMENT, {"M": 4.0}),
    ("μM = 4", MOMENT, {"M": 4.0}),
    ("μ_M = 4·10^{2} Н·м/мм", MOMENT, {"M": 400.0}),
    ("μM = 0.4 kN·m/mm;  μφ = 1 °/mm", MOMENT, {"M": 400.0, "φ": math.pi / 180}),
    ("M 1:2,5", {"l": "m"}, {"l": 0.0025}),
    ("μl = 2 mm/mm (1:2)", {"l": "m"}, {"l": 0.002}),
    ("at 12:30", {"l": "m"}, {}),
    ("v = 0.01 m/s", SPEED, {}),
]


@over("row", STATED)
def test_a_scale_is_read_however_it_is_written(row: tuple[str, dict[str, str], dict[str, float]]) -> None:
    text, due, scales = row
    found = stated_scales([Text(0j, text)], due)
    assert found.keys() == scales.keys()
    assert all(math.isclose(found[letter], mu, rel_tol=1e-12) for letter, mu in scales.items())


def rescaled(stroke: Stroke, text: str) -> Stroke:
    """Give a stroke with the scale of velocities written otherwise."""
    if isinstance(stroke, Group):
        return stroke._replace(strokes=tuple(rescaled(one, text) for one in stroke.strokes))
    return stroke._replace(content=text) if isinstance(stroke, Text) and stroke.plain.startswith("μv") else stroke


@over("row", [("μ_v = 10 (mm/s)/mm", []), ("K_v=1 mm/(cm/s)", []), ("μ_v = 2·10^{-2} m/s/mm", ["scale"])])
def test_a_plan_is_measured_by_its_scale_however_written(row: tuple[str, list[str]]) -> None:
    own, (text, kinds) = task("shaper"), row
    plan = own.plan("velocities", 2)
    source = drawn(own.sheet(plan.sheet), plan, true_places(plan), lambda one: rescaled(one, text))
    wrong = [
        one for one in grade(source, SheetTask(own.plans), HAND).wrong if one.plan == plan.plan and one.position == 2
    ]
    assert [one.kind for one in wrong] == kinds


@pytest.mark.rest
def test_a_graph_on_a_form_is_read_by_its_scale_however_written() -> None:
    own = task("slider-crank")
    source = on_form(own, {"velocity": 1.0})
    figure = own.figure("velocity")
    letter = next(iter(figure.scales))
    ours = f"μ{letter} = {figure.scale:g} u/mm".encode()
    other = f"μ_{letter}={1000 * figure.scale:g} (mm/s)/mm".encode()
    assert ours in source
    wrong = said(own, source.replace(ours, other))
    assert not [one for one in wrong if "missing" not in one]
