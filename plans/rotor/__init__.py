"""Balancing of rotors by vector polygons: moments first, then forces (уравновешивание роторов)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.scene.scene import Meaning, Survey
    from plans.study import Made, Study


class RotorTechnique(Technique):
    """Balancing of rotors by vector polygons."""

    tables = ("rotor",)
    plans = ("couples", "unbalances", "reactions")
    sheets = {"rotor": ("couples", "unbalances", "reactions")}
    scales = {
        "couple": ("kg*m2", "Of the polygon of a rotor's moments of unbalance."),
        "rotor": ("", "Of the views of a rotor."),
    }
    form = late("reading:RotorForm")
    notes = late("reading:notes_of")
    comparison = late("quantities:compare_rotor", "rotor.study:RotorStudy")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def survey(self, meaning: Meaning) -> Survey:
        from plans.rotor.reading import RotorForm, RotorSurvey, rotor_of

        return RotorSurvey(rotor_of(meaning.scene.of(RotorForm).rotor), [])

    def study(self, study: Study) -> Made:
        from plans.rotor.reading import RotorSurvey
        from plans.rotor.study import RotorStudy

        return RotorStudy(study.scene.meaning.of(RotorSurvey).rotor)


TECHNIQUE = RotorTechnique()
