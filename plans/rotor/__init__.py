"""Balancing of rotors by vector polygons: moments first, then forces (уравновешивание роторов)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
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

    def form(self) -> type[TechniqueForm]:
        from plans.rotor.reading import RotorForm

        return RotorForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.rotor.reading import RotorForm, RotorSurvey, rotor_of

        return RotorSurvey(rotor_of(meaning.scene.of(RotorForm).rotor), [])

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.rotor.reading import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.rotor.reading import RotorSurvey
        from plans.rotor.study import RotorStudy

        return RotorStudy(study.scene.meaning.of(RotorSurvey).rotor)

    def comparison(self, study: Study) -> Comparison:
        from plans.rotor.quantities import compare_rotor
        from plans.rotor.study import RotorStudy

        return compare_rotor(study.of(RotorStudy))

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.rotor.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.rotor.marks import marks

        return marks(study, position, name)


TECHNIQUE = RotorTechnique()
