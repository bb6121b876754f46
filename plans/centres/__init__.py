"""Instant centres of a linkage by Aronhold and Kennedy, and the rates that follow (мгновенные центры)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison
    from plans.scene.scene import Meaning, Survey, TechniqueForm
    from plans.study import Made, Study


class CentresTechnique(Technique):
    """Instant centres, and angular velocities from them (мгновенные центры скоростей)."""

    tables = ("centres",)
    plans = ("centres",)
    sheets = {"centres": ("positions", "velocities", "centres")}
    needs = ("linkage",)

    def form(self) -> type[TechniqueForm]:
        from plans.centres.study import CentresForm

        return CentresForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.centres.study import survey_of

        return survey_of(meaning)

    def study(self, study: Study) -> Made:
        from plans.centres.study import CentresStudy
        from plans.linkage.study import LinkageStudy

        return CentresStudy(study.of(LinkageStudy))

    def comparison(self, study: Study) -> Comparison:
        from plans.centres.quantities import compare_centres
        from plans.centres.study import CentresStudy

        return compare_centres(study.of(CentresStudy))

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.centres.quantities import marks

        return marks(study, position, name)


TECHNIQUE = CentresTechnique()
