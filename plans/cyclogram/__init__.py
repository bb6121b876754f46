"""The cyclogram: the plan of characteristic positions, phase and setting angles (циклограмма; book 5.9.2)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.study import Made, Study


class CyclogramTechnique(Technique):
    """The cyclogram."""

    tables = ("cyclogram",)
    plans = ("cyclogram",)
    sheets = {"cyclogram": ("extremes", "positions", "cyclogram")}
    needs = ("linkage",)
    form = late("reading:CyclogramForm")
    survey = late("reading:survey_of")
    notes = late("reading:notes_of")
    asks = late("reading:asked_of")
    comparison = late("quantities:compare_cyclogram", "cyclogram.study:CyclogramStudy")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def study(self, study: Study) -> Made:
        from plans.cyclogram.study import CyclogramStudy
        from plans.linkage.study import LinkageStudy

        return CyclogramStudy(study.scene, study.of(LinkageStudy))


TECHNIQUE = CyclogramTechnique()
