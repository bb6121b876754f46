"""The task made from a scene, and why no mechanism meets it (задание)."""

from __future__ import annotations

from typing import NamedTuple

from plans.model.synthesis.design import SynthesisTask
from plans.scene.faults import Fault
from plans.scene.scene import Meaning
from plans.synthesis.families import FAMILIES
from plans.synthesis.tables import SynthesisForm


class SynthesisSurvey(NamedTuple):
    """What the examination of a task found: its family's key, the task with its free parameter, its faults."""

    key: str
    task: SynthesisTask
    faults: list[Fault]


def survey_of(meaning: Meaning) -> SynthesisSurvey:
    """Make the task of a scene, and see that some mechanism meets it."""
    scene, form = meaning.scene, meaning.scene.of(SynthesisForm).synthesis
    key, table = next((key, table) for key in FAMILIES if (table := getattr(form, key)) is not None)
    task = FAMILIES[key].task(table)
    return SynthesisSurvey(key, task, [*FAMILIES[key].faults(scene, task)])
