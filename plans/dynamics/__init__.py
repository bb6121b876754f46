"""Motion of the machine: work, reduction, energy-mass diagram, flywheel, run-up (динамика машины)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from plans.techniques import Technique
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.model.motion import Pace
    from plans.quantity import Comparison, Quantity, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study


class Dynamics(Technique):
    """Motion of the machine."""

    tables = ("dynamics",)
    shares = {"drive": ("speed_from",)}
    plans = ("reduction", "works", "flywheel", "speeds", "run")
    sheets = {"dynamics": ("positions", "velocities", "reduction", "works", "flywheel", "speeds", "run")}
    needs = ("linkage",)
    borrows = ("forces",)
    paces = True
    scales = {"wheel": ("", "Of the sketch of the flywheel.")}

    def form(self) -> type[TechniqueForm]:
        from plans.dynamics.form import DynamicsForm

        return DynamicsForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.dynamics.reading import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.dynamics.reading import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.dynamics.study import study_of

        return study_of(study)

    def comparison(self, study: Study) -> Comparison:
        from plans.dynamics.quantities import comparison_of

        return comparison_of(study)

    def quantities(self, study: Study) -> Sequence[Quantity]:
        from plans.dynamics.numbers import quantities_of

        return quantities_of(study)

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.dynamics.numbers import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.dynamics.marks import marks

        return marks(study, position, name)

    def idle(self, scene: Scene) -> Iterable[Message]:
        return [message("report.idle_dynamics")] if scene.has(("dynamics",)) else []

    def pace(self, study: Study) -> Pace | None:
        from plans.dynamics.numbers import pace_of

        return pace_of(study)


TECHNIQUE = Dynamics()
