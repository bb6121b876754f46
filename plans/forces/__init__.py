"""Forces: loads, force plans group after group, the lever, friction (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plans.techniques import MOTION, Technique
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study


class ForcesTechnique(Technique):
    """Forces."""

    tables = ("masses", "loads", "friction")
    shares = {"drive": ("balancing", "gear"), "sheet": ("forces", "reactions", "hodographs")}
    plans = ("forces", "friction")
    sheets = {"forces": (*MOTION, "forces", "friction")}
    needs = ("linkage",)
    scales = {
        "scheme": ("", "Of loading schemes, and of schemes of a balanced machine."),
        "force": ("N", "Of force plans, and of the hodograph of shaking forces."),
        "lever": ("m/s", "Of Zhukovsky's lever."),
        "moment": ("N*m", "Of the graph of the balancing moment, and of the moments of a bank of cylinders."),
        "way": ("m", "Of the way of load diagrams; of a link that swings, degrees a mm."),
    }

    def form(self) -> type[TechniqueForm]:
        from plans.forces.reading.form import ForceForm

        return ForceForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.forces.reading.references import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.forces.reading.references import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.forces.statics import Statics
        from plans.linkage.study import LinkageStudy

        return Statics(study.of(LinkageStudy))

    def comparison(self, study: Study) -> Comparison:
        from plans.forces.quantities import compare_forces
        from plans.forces.statics import Statics
        from plans.linkage.quantities import MotionComparison

        return compare_forces(study.of(Statics), study.of(MotionComparison))

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.forces.quantities import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.forces.marks import marks

        return marks(study, position, name)

    def idle(self, scene: Scene) -> Iterable[Message]:
        given = scene.has(("masses",)) or scene.has(("loads",))
        return [message("report.idle_loads" if given else "report.no_loads")]


TECHNIQUE = ForcesTechnique()
