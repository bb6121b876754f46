"""Mutual balancing of equal mechanisms on one shaft (взаимоуравновешивание; book 8.2.3)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.quantity import Comparison
    from plans.scene.scene import Meaning, Survey
    from plans.study import Study


class BankTechnique(Technique):
    """Mutual balancing of equal mechanisms on one shaft (взаимоуравновешивание; book 8.2.3).."""

    tables = ("bank",)
    plans = ("harmonics", "compensators")
    sheets = {"bank": ("harmonics", "compensators")}
    form = late("reading:BankForm")
    notes = late("reading:notes_of")
    asks = late("reading:asked_of")
    study = late("study:study_of")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def survey(self, meaning: Meaning) -> Survey:
        from plans.bank.reading import BankSurvey, faults_of, task_of

        return BankSurvey(task_of(meaning.scene), [*faults_of(meaning)])

    def comparison(self, study: Study) -> Comparison:
        from plans.bank.quantities import compare_bank, mechanism_of
        from plans.bank.study import BankStudy

        bank = study.of(BankStudy)
        return compare_bank(bank, mechanism_of(study, bank))


TECHNIQUE = BankTechnique()
