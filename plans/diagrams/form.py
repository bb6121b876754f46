"""What a scene says of kinematic diagrams: whether its sheet shows them (кинематические диаграммы)."""

from __future__ import annotations

from collections.abc import Iterator

from plans.scene import fields as f
from plans.scene.faults import Fault
from plans.scene.scene import Meaning, Scene, TechniqueForm
from plans.scene.tables import Table, key, table


class DiagramsTable(Table):
    """Of the sheet whether it shows the diagrams."""

    diagrams: bool = key(
        f.FLAG,
        True,
        meaning=(
            "Whether the kinematics sheet shows S(φ), v(φ), a(φ) of the output (кинематические диаграммы) and the "
            "table of them."
        ),
    )


class DiagramsForm(TechniqueForm):
    """What a scene says of the diagrams."""

    sheet: DiagramsTable = key(table(DiagramsTable), DiagramsTable(), meaning="What of the output's course is shown.")


class DiagramsSurvey:
    """What the examination of the key found: nothing, its form has told all faults."""

    def __init__(self, meaning: Meaning) -> None:
        self.faults: list[Fault] = []


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give no notes: there is nothing odd in wanting the diagrams or not."""
    yield from ()
