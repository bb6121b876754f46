"""Linkages: positions, velocities, accelerations by construction, and how far they reach (рычажный механизм)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from plans.techniques import MOTION, Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison, Quantity, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study


class LinkageTechnique(Technique):
    """Linkages."""

    tables = ("mechanism", "drive", "output")
    shares = {"sheet": ("plans", "position")}
    plans = MOTION
    sheets = {"kinematics": (*MOTION, "diagrams"), "positions": ("positions",)}
    scales = {
        "length": ("", "Of the plan of positions."),
        "velocity": ("m/s", "Of all velocity plans."),
        "acceleration": ("m/s2", "Of all acceleration plans."),
    }

    def form(self) -> type[TechniqueForm]:
        from plans.linkage.reading.form import LinkageForm

        return LinkageForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.linkage.reading.linkage import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.linkage.reading.survey import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.linkage.study import LinkageStudy

        return LinkageStudy(study.scene, study.plans, study.pace)

    def comparison(self, study: Study) -> Comparison:
        from plans.linkage.quantities import comparison_of

        return comparison_of(study)

    def quantities(self, study: Study) -> Sequence[Quantity]:
        from plans.linkage.parts import quantities_of

        return quantities_of(study)

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.linkage.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.linkage.marks import marks

        return marks(study, position, name)


TECHNIQUE = LinkageTechnique()
