"""The involute pair: profiles, line of action, generation by a rack, what is measured (эвольвентная передача)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.study import Made, Study


class InvoluteTechnique(Technique):
    """The geometry of an involute pair."""

    tables = ("involute",)
    plans = ("involute", "generation")
    sheets = {"involute": ("involute", "generation")}
    scales = {"mesh": ("", "Of teeth in mesh."), "generation": ("", "Of a tooth as the rack cuts it.")}

    form = late("reading:InvoluteForm")
    survey = late("reading:survey_of")
    notes = late("reading:notes_of")
    comparison = late("quantities:compare_pair", "involute.study:InvoluteStudy")
    marks = late("quantities:marks")

    def study(self, study: Study) -> Made:
        from plans.involute.reading import pair_of
        from plans.involute.study import InvoluteStudy

        return InvoluteStudy(pair_of(study.scene))


TECHNIQUE = InvoluteTechnique()
