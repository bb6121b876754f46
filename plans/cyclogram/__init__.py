"""The cyclogram: the plan of characteristic positions, phase and setting angles (циклограмма; book 5.9.2)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.quantity import Comparison
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
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def study(self, study: Study) -> Made:
        from plans.cyclogram.study import CyclogramStudy
        from plans.linkage.study import LinkageStudy

        return CyclogramStudy(study.scene, study.of(LinkageStudy))

    def comparison(self, study: Study) -> Comparison:
        from plans.cyclogram.quantities import compare_cyclogram
        from plans.cyclogram.study import CyclogramStudy

        return compare_cyclogram(study.of(CyclogramStudy))


TECHNIQUE = CyclogramTechnique()
