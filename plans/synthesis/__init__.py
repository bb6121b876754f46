"""Synthesis by construction: from what a mechanism must do to its lengths (кинематический синтез)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.study import Made, Study


class SynthesisTechnique(Technique):
    """Synthesis of linkages from what they must do."""

    tables = ("synthesis",)
    plans = ("synthesis",)
    sheets = {"synthesis": ("synthesis",)}
    scales = {"synthesis": ("", "Of the construction of a task of synthesis.")}
    form = late("tables:SynthesisForm")
    survey = late("reading:survey_of")
    comparison = late("quantities:compare_synthesis", "synthesis.study:SynthesisStudy")
    numbers = late("quantities:numbers")
    marks = late("quantities:marks")

    def study(self, study: Study) -> Made:
        from plans.scene.faults import SceneError
        from plans.synthesis.reading import SynthesisSurvey
        from plans.synthesis.study import SynthesisStudy

        if faults := study.scene.meaning.faults:
            raise SceneError(faults)
        survey = study.scene.meaning.of(SynthesisSurvey)
        return SynthesisStudy(survey.key, survey.task)


TECHNIQUE = SynthesisTechnique()
