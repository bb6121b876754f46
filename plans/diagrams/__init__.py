"""Kinematic diagrams of the output (кинематические диаграммы)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.study import Made, Study


class DiagramsTechnique(Technique):
    """Kinematic diagrams of the output (кинематические диаграммы).."""

    shares = {"sheet": ("diagrams",)}
    plans = ("diagrams",)
    needs = ("linkage",)
    scales = {"angle": ("rad", "Of the crank angle of kinematic diagrams; the larger it is, the smaller these are.")}
    form = late("study:DiagramsForm")
    comparison = late("quantities:comparison_of")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def study(self, study: Study) -> Made:
        from plans.diagrams.study import DiagramsForm, DiagramsStudy
        from plans.linkage.study import LinkageStudy

        return DiagramsStudy(study.of(LinkageStudy), study.scene.of(DiagramsForm).sheet.diagrams)


TECHNIQUE = DiagramsTechnique()
