"""Motion of the machine: work, reduction, energy-mass diagram, flywheel, run-up (динамика машины)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plans.techniques import Technique, late
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.scene.scene import Scene


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
    form = late("form:DynamicsForm")
    completed = late("reading:with_train")
    survey = late("reading:survey_of")
    notes = late("reading:notes_of")
    study = late("study:study_of")
    comparison = late("quantities:comparison_of")
    quantities = late("numbers:quantities_of")
    numbers = late("numbers:numbers")
    marks = late("marks:marks")
    pace = late("numbers:pace_of")
    driving = late("study:driving_of")

    def idle(self, scene: Scene) -> Iterable[Message]:
        return [message("report.idle_dynamics")] if scene.has(("dynamics",)) else []


TECHNIQUE = Dynamics()
