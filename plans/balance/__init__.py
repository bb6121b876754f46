"""Balancing of mechanisms by main points and counterweights (уравновешивание механизмов; book 8.2.2)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import MOTION, Technique, late

if TYPE_CHECKING:
    from plans.study import Made, Study


class BalanceTechnique(Technique):
    """Balancing of mechanisms by main points and counterweights (уравновешивание механизмов; book 8.2.2).."""

    tables = ("balance",)
    plans = ("centre", "counterweights", "costs")
    sheets = {"balancing": (*MOTION, "centre", "counterweights", "costs")}
    needs = ("linkage",)
    borrows = ("forces",)
    scales = {"unbalance": ("kg*m", "Of polygons of static moments.")}
    form = late("form:BalanceForm")
    survey = late("reading:survey_of")
    notes = late("reading:notes_of")
    comparison = late("quantities:comparison_of")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def study(self, study: Study) -> Made:
        from plans.balance.reading import BalanceSurvey
        from plans.balance.study import BalanceStudy
        from plans.forces.statics import Statics
        from plans.linkage.study import LinkageStudy

        task = study.scene.meaning.of(BalanceSurvey).task
        return BalanceStudy(study.of(LinkageStudy), study.of(Statics), task)


TECHNIQUE = BalanceTechnique()
