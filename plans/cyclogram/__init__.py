"""The cyclogram: the plan of characteristic positions, phase and setting angles (циклограмма; book 5.9.2)."""

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


class CyclogramTechnique(Technique):
    """The cyclogram."""

    tables = ("cyclogram",)
    plans = ("cyclogram",)
    sheets = {"cyclogram": ("extremes", "positions", "cyclogram")}
    needs = ("linkage",)

    def form(self) -> type[TechniqueForm]:
        from plans.cyclogram.reading import CyclogramForm

        return CyclogramForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.cyclogram.reading import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.cyclogram.reading import notes_of

        return notes_of(scene)

    def asks(self, scene: Scene) -> Iterable[str]:
        from plans.cyclogram.reading import asked_of

        return asked_of(scene)

    def study(self, study: Study) -> Made:
        from plans.cyclogram.study import CyclogramStudy
        from plans.linkage.study import LinkageStudy

        return CyclogramStudy(study.scene, study.of(LinkageStudy))

    def comparison(self, study: Study) -> Comparison:
        from plans.cyclogram.quantities import compare_cyclogram
        from plans.cyclogram.study import CyclogramStudy

        return compare_cyclogram(study.of(CyclogramStudy))

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.cyclogram.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.cyclogram.marks import marks

        return marks(study, position, name)


TECHNIQUE = CyclogramTechnique()
