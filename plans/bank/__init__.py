"""Mutual balancing of equal mechanisms on one shaft (взаимоуравновешивание; book 8.2.3)."""

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


class BankTechnique(Technique):
    """Mutual balancing of equal mechanisms on one shaft (взаимоуравновешивание; book 8.2.3).."""

    tables = ("bank",)
    plans = ("harmonics", "compensators")
    sheets = {"bank": ("harmonics", "compensators")}

    def form(self) -> type[TechniqueForm]:
        from plans.bank.reading import BankForm

        return BankForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.bank.reading import BankSurvey, faults_of, task_of

        return BankSurvey(task_of(meaning.scene), [*faults_of(meaning)])

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.bank.reading import notes_of

        return notes_of(scene)

    def asks(self, scene: Scene) -> Iterable[str]:
        from plans.bank.reading import asked_of

        return asked_of(scene)

    def study(self, study: Study) -> Made:
        from plans.bank.study import study_of

        return study_of(study)

    def comparison(self, study: Study) -> Comparison:
        from plans.bank.quantities import compare_bank, mechanism_of
        from plans.bank.study import BankStudy

        bank = study.of(BankStudy)
        return compare_bank(bank, mechanism_of(study, bank))

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.bank.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.bank.marks import marks

        return marks(study, position, name)


TECHNIQUE = BankTechnique()
