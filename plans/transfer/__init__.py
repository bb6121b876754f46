"""Transfer functions of a linkage, read off the velocity plan turned by a quarter (передаточные функции)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison
    from plans.scene.scene import Meaning, Survey, TechniqueForm
    from plans.study import Made, Study


class TransferTechnique(Technique):
    """Transfer functions, and the turned velocity plan (повёрнутый план скоростей)."""

    tables = ("transfer",)
    plans = ("transfer",)
    sheets = {"transfer": ("positions", "transfer")}
    needs = ("linkage",)

    def form(self) -> type[TechniqueForm]:
        from plans.transfer.study import TransferForm

        return TransferForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.transfer.study import survey_of

        return survey_of(meaning)

    def study(self, study: Study) -> Made:
        from plans.linkage.study import LinkageStudy
        from plans.transfer.study import TransferStudy

        return TransferStudy(study.of(LinkageStudy))

    def comparison(self, study: Study) -> Comparison:
        from plans.transfer.quantities import compare_transfer
        from plans.transfer.study import TransferStudy

        return compare_transfer(study.of(TransferStudy))

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.transfer.quantities import marks

        return marks(study, position, name)


TECHNIQUE = TransferTechnique()
