"""Scales of a set: common to the plans of an order, or stated by the scene; a wrong one is refused, or withheld."""

from __future__ import annotations

import math
from collections.abc import Iterable
from copy import copy
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from drawings.checks.readers import Sheets, scale_faults
from drawings.linkage import sheet
from drawings.paper.strokes import SheetError
from drawings.pens.svg import svg
from drawings.reading.marks import MeasuredVector
from drawings.reading.measure import Measured, measure_file
from drawings.sheets.documents import of_scales
from drawings.sheets.kind import sheet_kind
from drawings.sheets.stated_scales import Exhibit
from plans.linkage.reading.form import LinkageForm
from plans.linkage.study import LinkageStudy
from plans.scene.faults import SceneError
from plans.scene.forms import SHEETS
from plans.scene.scene import Scene, parse_scene
from plans.scene.sheet import ScaleTable
from plans.study import Study

GALLERY = Path(__file__).parents[2] / "drawings/gallery"
LOADED = (GALLERY / "slider-crank.toml").read_text("utf-8")
BASE = LOADED.replace(', "forces"]', "]").replace("forces = [2]", "")
KEYS = sheet_kind("kinematics").scales


def scene_of(more: str = "") -> Scene:
    return parse_scene(f"{BASE}\n{more}")


@cache
def made() -> Study:
    study = Study(scene_of())
    study.comparison("linkage")
    return study


def linkage_of(scene: Scene) -> LinkageStudy:
    linkage = copy(made()["linkage"])
    vars(linkage).update(scene=scene, form=scene.of(LinkageForm))
    return linkage


def measured(scene: Scene, folder: Path) -> list[Measured]:
    """Lay out and measure the sheets of a scene, whose mechanism is the same for all."""
    found = []
    for k, leaf in enumerate(sheet.sheets(linkage_of(scene), made().comparison("linkage"))):
        (path := folder / f"{k}.svg").write_bytes(svg(leaf))
        found.append(measure_file(path))
    return found


def wrong(sheets: Sheets, scene: Scene) -> list[str]:
    return [str(one) for one in scale_faults(sheets, scene.sheet)]


def scales(sheets: Iterable[Measured], plan: str) -> set[float]:
    return {mark.scale for one in sheets for mark in (*one.vectors, *one.points) if mark.plan == plan}


def keys(scene: Scene) -> set[str]:
    """What figures of a scene's sheets share a scale by."""
    draft = sheet._KinematicsSheet(linkage_of(scene), made().comparison("linkage"), None).draft
    return {shown.panel.scale for shown in draft.shows if isinstance(shown, Exhibit)}


def test_a_figure_has_the_scale_that_the_scene_states(tmp_path: Path) -> None:
    scene = scene_of('[sheet.scale]\nlength = "2:3"\nvelocity = 0.07\nacceleration = 25\n')
    sheets = measured(scene, tmp_path)
    assert [scales(sheets, plan) for plan in ("positions", "velocities", "accelerations")] == [{0.0015}, {0.07}, {25.0}]
    assert wrong([(KEYS, one) for one in sheets], scene) == []
    for key in ("length", "velocity", "acceleration"):
        other = scene.changed(sheet=scene.sheet.changed(scale=scene.sheet.scale.changed(**{key: 1})))
        (told, *_) = wrong([(KEYS, one) for one in sheets], other)
        assert "which the scene states otherwise" in told


def test_a_scale_at_which_a_figure_does_not_fit_is_refused_with_its_size_its_room_and_scales_that_fit() -> None:
    with pytest.raises(SheetError) as refused:
        sheet.leaves(Study(scene_of('[sheet.scale]\nlength = "5:1"\n')))
    line = len(BASE.splitlines()) + 3
    said = str(refused.value)
    assert said.startswith(f'scene.toml:{line}:1: sheet.scale.length = "5:1": ')
    # The cylinder is 165 mm above the crank's circle of 90: five times 0.25 m is more than the 584 mm of A1.
    assert float(said.split(" × ")[1].split(maxsplit=1)[0]) > 5 * 250 > 584
    fitting = said.partition("Fix: choose ")[2].partition(",")[0].split(" or ")
    assert len(fitting) == 3
    assert '"1:1"' in fitting


def test_a_scale_at_which_the_largest_plan_cannot_be_lettered_is_refused() -> None:
    with pytest.raises(SheetError, match=r"sheet.scale.velocity = 3: .* is \d mm large, and its letters need"):
        sheet.leaves(Study(scene_of("[sheet.scale]\nvelocity = 3\n")))
    with pytest.raises(SheetError, match=r'sheet.scale.length = "1:\d+": .* is 0 mm large, .* choose "1:'):
        sheet.leaves(Study(scene_of("[sheet.scale]\nlength = 1000\n")))


def test_the_way_of_a_load_diagram_has_the_scale_that_is_stated_and_its_ordinates_their_own() -> None:
    keys, scene = sheet_kind("dynamics").scales, scene_of("[sheet.scale]\nway = 0.005\n")
    way, load = (
        MeasuredVector("load_diagram-F_us", quantity, name, None, 1.0, 1.0, unit, scale, 0j, 1.0 + 0j)
        for quantity, name, unit, scale in (("S", "H", "m", 0.005), ("F", "a", "N", 20.0))
    )
    assert wrong([(keys, Measured((way, load), ()))], scene) == []
    (told,) = wrong([(keys, Measured((replace(way, scale=0.004), load), ()))], scene)
    assert told == "the scale of load diagram of F_us, which the scene states otherwise"


def test_a_scale_of_figures_that_no_sheet_has_is_refused_and_those_are_listed_that_some_has() -> None:
    with pytest.raises(
        SheetError, match=r"sheet.scale.cam: .* choose from length or velocity or acceleration or angle$"
    ):
        of_scales(scene_of("[sheet.scale]\ncam = 0.001\n"))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ('length = "1:0"', "a ratio of two numbers above 0"),
        ('length = "half"', "a ratio of two numbers above 0"),
        ("velocity = 0", "this scale factor to be greater than 0"),
        ("length = -1", "this scale factor to be greater than 0"),
        ("speed = 1", "expected a key of [sheet.scale]"),
        ('velocity = "1:2"', "a number without a unit"),
    ],
)
def test_a_wrong_scale_is_refused_at_its_line(text: str, says: str) -> None:
    with pytest.raises(SceneError) as refused:
        scene_of(f"[sheet.scale]\n{text}\n")
    (fault,) = refused.value.faults
    assert fault.line == len(BASE.splitlines()) + 3
    assert says in str(refused.value)


def test_a_ratio_is_metres_a_millimetre() -> None:
    found = dict(scene_of('[sheet.scale]\nlength = "1:2.5"\nscheme = "3:2"\ncam = 0.004\n').sheet.scale.stated)
    assert found == {"length": 0.0025, "scheme": pytest.approx(0.001 * 2 / 3), "cam": 0.004}
    assert all(math.isfinite(mu) for mu in found.values())


def test_every_key_governs_figures_of_some_sheet() -> None:
    governed = {key for sheet in SHEETS for key in sheet_kind(sheet).scales.values()}
    assert governed == set(ScaleTable.keys)
