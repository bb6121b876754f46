"""Kinematic diagrams of the output (кинематические диаграммы)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison, Stated
    from plans.scene.scene import TechniqueForm
    from plans.study import Made, Study


class DiagramsTechnique(Technique):
    """Kinematic diagrams of the output (кинематические диаграммы).."""

    shares = {"sheet": ("diagrams",)}
    plans = ("diagrams",)
    needs = ("linkage",)
    scales = {"angle": ("rad", "Of the crank angle of kinematic diagrams; the larger it is, the smaller these are.")}

    def form(self) -> type[TechniqueForm]:
        from plans.diagrams.study import DiagramsForm

        return DiagramsForm

    def study(self, study: Study) -> Made:
        from plans.diagrams.study import DiagramsForm, DiagramsStudy
        from plans.linkage.study import LinkageStudy

        return DiagramsStudy(study.of(LinkageStudy), study.scene.of(DiagramsForm).sheet.diagrams)

    def comparison(self, study: Study) -> Comparison:
        from plans.diagrams.quantities import comparison_of

        return comparison_of(study)

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.diagrams.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.diagrams.marks import marks

        return marks(study, position, name)


TECHNIQUE = DiagramsTechnique()
