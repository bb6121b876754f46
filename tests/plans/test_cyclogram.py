"""Characteristic positions: the textbook's shaper to all printed digits, both roads on every linkage, relations."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.cyclogram import rows as r
from plans.cyclogram.marks import marks
from plans.cyclogram.quantities import compare_cyclogram
from plans.cyclogram.rows import row_of_feed, rows_of_cams, rows_of_machine
from plans.cyclogram.study import NoCyclogram
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.model import cyclogram as c
from plans.model.cyclogram import TURN, Cyclogram, Period, Window, pieces
from plans.scene.faults import SceneError
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import some
from tests.plans.cyclograms import cyclogram_of, scene_text, study_of

NAMES = some(
    [
        "shaper", "crank-rocker", "press", "walking-leg", "conveyor", "jaw-crusher", "oscillating-cylinder",
        "scotch-yoke", "slider-crank", "toggle-press", "whitworth", "squeezer", "v-engine", "compressor",
    ],
    7,
)  # fmt: skip


def degrees(found: Cyclogram, role: str) -> list[float]:
    return [math.degrees(one.turned) for one in found.of(role)]


@pytest.fixture(scope="module")
def shaper() -> tuple[Cyclogram, Cyclogram]:
    comparison = compare_cyclogram(cyclogram_of("shaper", "overrun = 0.1\nbreaks = [0.6, 0.75]\n"))
    return comparison.construction, comparison.analysis


def test_textbook_shaper(shaper) -> None:
    """Book 5.9.2, figures 5.42 and 5.43: methods M2.1, all printed digits, by either road."""
    for found in shaper:
        assert f"{found.stroke:.10f}" == "0.4800000000"
        assert [f"{one:.7f}" for one in degrees(found, c.ENTRY)] == ["21.4590389"]
        assert [f"{one:.7f}" for one in degrees(found, c.EXIT)] == ["159.5541014"]
        assert [f"{one:.7f}" for one in degrees(found, c.LEAVE)] == ["306.8819915"]
        assert math.isclose(math.degrees(found.window.angle), 74.57704741, abs_tol=5e-9)
        assert math.isclose(math.degrees(found.window.rest), 285.4229526, abs_tol=5e-8)


@pytest.mark.parametrize("name", NAMES)
def test_both_roads_agree_on_every_linkage(name: str) -> None:
    comparison = compare_cyclogram(cyclogram_of(name))
    assert [one.name for one in comparison.findings if one.excess.max() > 1] == []
    assert comparison.agrees


@pytest.mark.parametrize("name", some(["slider-crank", "shaper"], 2))
def test_a_condition_is_how_much_the_turn_moves_with_the_stroke(name: str) -> None:
    """By differences: a millionth of the stroke further, the turn is further by so many millionths of a turn."""
    step = 1e-6
    here = compare_cyclogram(cyclogram_of(name, "overrun = 0.1\n"))
    there = cyclogram_of(name, f"overrun = {0.1 + step:.7f}\n").cyclogram
    for role in (c.ENTRY, c.EXIT, c.LEAVE):
        ours, theirs, further = (road.of(role)[0] for road in (here.construction, here.analysis, there))
        apart = abs(math.remainder(further.turned - ours.turned, TURN)) / TURN
        assert [apart / step] * 2 == pytest.approx([ours.condition, theirs.condition], rel=1e-4)


def test_a_length_is_as_good_as_a_share() -> None:
    for told in ('overrun = "48 mm"\nbreaks = ["288 mm"]\n', 'overrun = "10 %"\nbreaks = ["60 %"]\n'):
        found = cyclogram_of("shaper", told).cyclogram
        assert math.isclose(degrees(found, c.ENTRY)[0], 21.4590389, abs_tol=1e-7)
        assert math.isclose(found.of(c.BREAK)[0].share, 0.6)


def test_without_overrun_at_the_beginning_the_window_is_at_the_end() -> None:
    comparison = compare_cyclogram(cyclogram_of("shaper", "overrun = [0, 0.1]\n"))
    assert comparison.agrees
    found = comparison.construction
    assert found.of(c.ENTRY) == found.of(c.LEAVE) == ()
    (out,), (back,) = found.of(c.EXIT), found.of(c.BACK)
    assert found.window == Window(out.turned, back.turned)
    assert out.turned < found.of(c.END)[0].turned < back.turned
    kinds = [span.kind for span in rows_of_machine(found)[1].spans]
    assert kinds == [r.CUT, r.OVERRUN, r.OVERRUN, r.BACK_OVER]


def test_a_span_is_cut_where_the_turn_begins() -> None:
    cut = list(pieces(Period(6.0, 7.0, "rise"), 0.5))
    assert [(one.start, one.end) for one in cut] == [(5.5, TURN), (0.0, 6.5 - TURN)]
    assert len(list(pieces(Period(6.0, 7.0, "rise"), 5.5))) == 1


CAM = """
[[cam]]
name = "K1"
setting = "cyclogram"
limits = { rise = 30 }
follower = { motion = "translating", end = "roller", lift = "20 mm" }
phases = [
  { kind = "rise", angle = "cyclogram", law = "sine" },
  { kind = "dwell", angle = 60 },
  { kind = "return", angle = 90, law = "sine" },
  { kind = "dwell", angle = "rest" },
]
"""


def test_a_cam_takes_its_rise_and_its_setting_from_the_window() -> None:
    study = Study(parse_scene(scene_text("shaper", f"overrun = 0.1\n{CAM}")))["cyclogram"]
    (row,) = rows_of_cams(study.cams)
    window = study.window
    assert row.setting == pytest.approx(window.start)
    assert [one.kind for one in row.spans] == ["rise", "dwell", "return", r.REST]
    assert row.spans[0].end == pytest.approx(window.end)
    assert sum(one.end - one.start for one in row.spans) == pytest.approx(TURN)


@pytest.mark.parametrize(
    ("told", "wanted"),
    [
        ("", "overrun of the tool"),
        ("overrun = 0\n", "an overrun at one end"),
        ("overrun = [0.5, 0.5]\n", "leave a part of the stroke"),
        ("overrun = 1.5\n", "from 0 to less than 1"),
        ('overrun = "-3 mm"\n', "not to be negative"),
        ("overrun = 0.1\nbreaks = [0.5, 0.5]\n", "0.5"),
        ('overrun = 0.1\npoint = "Z"\n', "Z"),
        ('overrun = 0.1\npoint = "O"\n', "O"),
        ("overrun = 0.1\npiont = 3\n", "piont"),
    ],
)
def test_what_is_wrong_is_told_at_its_line(told: str, wanted: str) -> None:
    with pytest.raises(SceneError) as refused:
        _ = study_of("shaper", told)["linkage"].mechanism
    (fault,) = refused.value.faults
    assert fault.path[0] == "cyclogram" and wanted in str(fault)
    assert fault.worded("ru") != str(fault)


@pytest.mark.parametrize(
    ("name", "told", "wanted"),
    [
        ("shaper", 'overrun = "500 mm"\n', "500 mm lie beyond the stroke of 480 mm"),
        ("shaper", 'overrun = ["240 mm", 0.5]\n', "nothing is left for the work"),
        ("crank-rocker", 'overrun = "10 mm"\n', "its stroke is an angle"),
        ("tangent", "overrun = 0.1\n", "no two extreme positions"),
    ],
)
def test_what_the_stroke_does_not_allow_is_refused(name: str, told: str, wanted: str) -> None:
    with pytest.raises(NoCyclogram) as refused:
        _ = cyclogram_of(name, told).cyclogram
    assert wanted in str(refused.value) and "cyclogram" in str(refused.value)


def test_breaks_come_from_the_load_where_the_scene_gives_none() -> None:
    load = "\n[[loads.forces]]\non = 5\npoint = 'D'\nagainst = 'motion'\n"
    diagram = "diagram = { travel = [0, 0.3, 0.3, 1], force = [0, 0, 900, 900] }\n"
    found = cyclogram_of("shaper", f"overrun = 0.1\n{load}{diagram}").cyclogram
    assert [one.share for one in found.of(c.BREAK)] == [0.3]


def test_a_change_of_the_load_in_the_overrun_is_noted() -> None:
    notes = notes_of(study_of("shaper", "overrun = 0.1\nbreaks = [0.05, 0.5, 0.95]\n").scene)
    assert [one.path for one in notes if one.kind == "break_in_overrun"] == [
        ("cyclogram", "breaks", 0),
        ("cyclogram", "breaks", 2),
    ]


def test_explain_gives_the_notches_from_the_tool_to_the_crank() -> None:
    study = study_of("shaper")
    told = marks(study, 0, "phi_1")
    assert isinstance(told, Explanation)
    assert [mark.name for mark in told.steps if mark.step.op == "meet"] == ["B", "A"]
    assert told.steps[-1].name == "OA"
    arm = complex(np.ravel(told.steps[-1].point)[0])
    assert math.isclose(math.atan2(arm.imag, arm.real), study["cyclogram"].cyclogram.positions[1].turned)
    pressure = marks(study, 0, "φ_2")
    assert isinstance(pressure, Explanation) and any(mark.step.op == "square" for mark in pressure.steps)
    listed = marks(study, 0, "v_B")
    assert isinstance(listed, NoMark) and "phi_1" in listed.names and "phi_0" not in listed.names
    for name in ("phi_0", "phi_99"):
        with pytest.raises(UnknownMark):
            marks(study, 0, name)


def test_rows_cover_the_turn_once() -> None:
    found = cyclogram_of("shaper").cyclogram
    for row in (*rows_of_machine(found), row_of_feed(found)):
        assert math.isclose(sum(one.end - one.start for one in row.spans), TURN)
        for one, other in zip(row.spans, (*row.spans[1:], row.spans[0]), strict=True):
            assert math.isclose(math.remainder(one.end - other.start, TURN), 0.0, abs_tol=1e-12)
