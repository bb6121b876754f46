"""Gear trains by triangles of speeds and by Willis: ratios, planetary trains, boxes (зубчатые механизмы)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plans.scene.scene import Scene
    from plans.study import Made, Study


class GearsTechnique(Technique):
    """Gear trains: plan of linear and angular speeds by Kutzbach, ratios by Willis."""

    tables = ("gears",)
    shares = {"drive": ("train",)}
    paces = True
    plans = ("linear", "angular")
    sheets = {"gears": ("linear", "angular")}
    scales = {
        "gears": ("", "Of the scheme of a gear train."),
        "speeds": ("rad/s", "Of its plan of angular velocities."),
    }

    form = late("form:GearsForm")
    completed = late("reading:with_speed")
    survey = late("reading:survey_of")
    comparison = late("quantities:compare_gears", "gears.study:GearsStudy")
    numbers = late("quantities:numbers")
    marks = late("quantities:marks")

    def asks(self, scene: Scene) -> Iterable[str]:
        from plans.gears.form import geared

        return ["dynamics"] if geared(scene) else []

    def study(self, study: Study) -> Made:
        from plans.gears.study import GearsStudy

        return GearsStudy(study)


TECHNIQUE = GearsTechnique()
