"""Balancing of mechanisms by main points and counterweights (уравновешивание механизмов; book 8.2.2)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plans.techniques import MOTION, Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study


class BalanceTechnique(Technique):
    """Balancing of mechanisms by main points and counterweights (уравновешивание механизмов; book 8.2.2).."""

    tables = ("balance",)
    plans = ("centre", "counterweights", "costs")
    sheets = {"balancing": (*MOTION, "centre", "counterweights", "costs")}
    needs = ("linkage",)
    borrows = ("forces",)
    scales = {"unbalance": ("kg*m", "Of polygons of static moments.")}

    def form(self) -> type[TechniqueForm]:
        from plans.balance.form import BalanceForm

        return BalanceForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.balance.reading import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.balance.reading import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.balance.reading import BalanceSurvey
        from plans.balance.study import BalanceStudy
        from plans.forces.statics import Statics
        from plans.linkage.study import LinkageStudy

        task = study.scene.meaning.of(BalanceSurvey).task
        return BalanceStudy(study.of(LinkageStudy), study.of(Statics), task)

    def comparison(self, study: Study) -> Comparison:
        from plans.balance.quantities import comparison_of

        return comparison_of(study)

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.balance.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.balance.marks import marks

        return marks(study, position, name)


TECHNIQUE = BalanceTechnique()
