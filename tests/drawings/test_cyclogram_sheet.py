"""The sheet of a cyclogram: measured back against the analysis; a careless draughtsman's faults withhold it."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from drawings.checks.cyclogram.verify_cyclogram import faults
from drawings.checks.verify import SelfCheckFailed, verify
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured
from drawings.paper.strokes import Arc, Group, Leaf, Stroke
from drawings.pens.svg import svg
from drawings.report import cyclogram_report
from drawings.sheets.cyclogram import leaves
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.collisions import collisions
from tests.drawings.slips import (
    Change,
    changed,
    dropped,
    note,
    reworded,
    row_dropped,
    shifted,
    stretched,
    without,
)
from tests.parts import first
from tests.plans.cyclograms import scene_text

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
TOLD = "overrun = 0.1\nbreaks = [0.6, 0.75]\n"


def drawn(name: str, told: str = TOLD, language: str = "en") -> tuple[Study, tuple[Leaf, ...]]:
    """Lay out the sheets of a gallery's linkage with a cyclogram."""
    text = re.sub(r"^\[sheet\]", f'[sheet]\nlanguage = "{language}"', scene_text(name, told), flags=re.MULTILINE)
    text = re.sub(r'^language = "(\w+)"\n(?=(?:.*\n)*?language)', "", text, flags=re.MULTILINE)
    study = Study(parse_scene(text))
    return study, leaves(study)


def seen(study: Study, leaf: Leaf, folder: Path) -> Measured:
    """Write a sheet, and check it as it is read back."""
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    return verify(path, leaf, partial(faults, study=study)).measured


@pytest.fixture(scope="module")
def shaper() -> tuple[Study, Leaf]:
    study, (leaf,) = drawn("shaper", TOLD + CAM)
    return study, leaf


def test_every_angle_is_measured_back(shaper, tmp_path: Path) -> None:
    """Eight crank pins beside the one in full lines, and a line for every span, two for the one that is cut."""
    measured = seen(*shaper, tmp_path)
    pins = {one.name for one in measured.points if one.plan == "characteristic"}
    assert pins == {f"A_{k}" for k in range(9) if k != 1}
    bars = {one.name for one in measured.vectors if one.plan == "bars"}
    assert bars == {"1.1", "1.2", *(f"2.{k}" for k in range(1, 6)), *(f"3.{k}" for k in range(1, 6)), "set.1"}


@pytest.mark.rest
@pytest.mark.parametrize(
    "name", first(["crank-rocker", "walking-leg", "press", "jaw-crusher", "scotch-yoke", "oscillating-cylinder"])
)
def test_other_linkages_are_drawn_too(name: str, tmp_path: Path) -> None:
    """A rocker, a tool that no notches lead back from, a clockwise shaft, a small sheet of several leaves."""
    study = Study(parse_scene(scene_text(name)))
    for leaf in leaves(study):
        seen(study, leaf, tmp_path)
        assert collisions(leaf) == []


def turned_ring(name: str, by: float) -> Change:
    """Draw the arcs of a ring somewhat turned."""

    def change(stroke: Stroke) -> Stroke:
        if not isinstance(stroke, Group) or stroke.name != name:
            return stroke
        moved = tuple(
            one._replace(start_angle=one.start_angle + by, end_angle=one.end_angle + by)
            if isinstance(one, Arc)
            else one
            for one in stroke.strokes
        )
        return replace(stroke, strokes=moved)

    return change


@pytest.mark.parametrize(
    "slip",
    first(
        [
            (shifted("A_8", "characteristic", 0.001), "A_8 on characteristic (against the analysis)"),
            (dropped("A_5", "characteristic"), "A_5 on characteristic is missing"),
            (shifted("D", "positions", 0.001j), "D on characteristic (against the analysis)"),
            (stretched("1.1", "bars", 1.0001), "1.1 on bars (against the analysis)"),
            (dropped("3.2", "bars"), "3.2 on bars is missing"),
            (stretched("set.1", "bars", 0.999), "set.1 on bars (against the analysis)"),
            (turned_ring("ring-2", 0.001), "ring-2 on circle (against the analysis)"),
            (without("ring-1"), "ring-1 on circle is missing"),
            (reworded("Cam K1", "Cam K2"), "Cam K1 on circle is missing"),
            (reworded("21.45904", "21.45914"), "21.45914 in the row 1"),
            (reworded("48.000", "47.000"), "47.000 in the row 1"),
            (reworded("0.415", "0.514"), "0.514 in the row 8"),
            (reworded("∞", "1"), "1 in the row 0"),
            (row_dropped("6  working stroke ends"), "the row 6  working stroke ends is missing"),
            (note("306.882", "306.982"), "the notes"),
            (note("285.423", "74.577"), "the notes"),
            (without("notes"), "the notes"),
            (reworded("220.1°", "200.1°"), "200.1°"),
            (reworded("48", "46"), "46 (against the analysis)"),
            (reworded("H = 480", "H = 400"), "400 (against the analysis)"),
        ]
    ),
)
def test_a_planted_fault_is_seen(shaper, slip: tuple[Change, str], tmp_path: Path) -> None:
    (study, leaf), (change, wrong) = shaper, slip
    spoilt = changed(leaf, change)
    assert spoilt != leaf
    with pytest.raises(SelfCheckFailed) as told:
        seen(study, spoilt, tmp_path)
    assert wrong in str(told.value)
    unquoted = re.sub("«[^»]*»", "", said(told.value, "ru")).replace("working stroke ends", "")
    assert not re.search(r"\b(the|is|on|in|for|against)\b", unquoted)


@pytest.mark.rest
def test_the_letters_of_phases_are_those_of_the_language() -> None:
    _, (leaf,) = drawn("shaper", TOLD + CAM, "ru")
    assert "φ_{у} = 74,57705°,  φ_{д.в} = 60°,  φ_{в} = 90°,  φ_{б.в} = 135,423°" in leaf.description


def test_a_report_tells_the_positions_by_both_roads(shaper) -> None:
    study, leaf = shaper
    told = "\n".join(cyclogram_report.chapters(study, {"cyclogram": (leaf,)}).values)
    assert "## Cyclogram" in told
    assert (
        "position 8, overrun begins, at 0.1 of the stroke: φ = 306.8819915° by plan, 306.8819915° by analysis" in told
    )
    assert "φ_rise = 360° − (φ_2 − φ_1) = 74.57704742°" in cyclogram_report.headline(study)
    assert cyclogram_report.remarks(study) == []
