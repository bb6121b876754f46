"""Gear trains by triangles of speeds and by Willis: ratios, planetary trains, boxes (зубчатые механизмы)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.quantity import Comparison, Stated
    from plans.scene.scene import Meaning, Survey, TechniqueForm
    from plans.study import Made, Study


class GearsTechnique(Technique):
    """Gear trains: plan of linear and angular speeds by Kutzbach, ratios by Willis."""

    tables = ("gears",)
    plans = ("linear", "angular")
    sheets = {"gears": ("linear", "angular")}
    scales = {
        "gears": ("", "Of the scheme of a gear train."),
        "speeds": ("rad/s", "Of its plan of angular velocities."),
    }

    def form(self) -> type[TechniqueForm]:
        from plans.gears.form import GearsForm

        return GearsForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.gears.reading import survey_of

        return survey_of(meaning.scene)

    def study(self, study: Study) -> Made:
        from plans.gears.study import GearsStudy

        return GearsStudy(study)

    def comparison(self, study: Study) -> Comparison:
        from plans.gears.quantities import compare_gears
        from plans.gears.study import GearsStudy

        return compare_gears(study.of(GearsStudy))

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.gears.quantities import numbers

        return numbers(study, by)


TECHNIQUE = GearsTechnique()
