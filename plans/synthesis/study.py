"""The study of a task of synthesis: its constructions, each made once, and the mechanisms that they give."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property

from geometry.board import Board
from plans.model.synthesis.design import CONSTRUCTION, Synthesis, SynthesisTask, TaskReading
from plans.model.synthesis.region import Region
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import DrawnReading
from plans.synthesis.families import FAMILIES, SynthesisFamily


class SynthesisStudy:
    """A task of a family, and what is drawn of it."""

    def __init__(self, key: str, task: SynthesisTask) -> None:
        self.key, self.task = key, task
        self.family: SynthesisFamily = FAMILIES[key]
        self.made: set[str] = set()

    def construct(self, plans: Collection[str]) -> None:
        """Draw the task, if it is asked for."""
        if SYNTHESIS in plans:
            _ = self.drawn

    @cached_property
    def drawn(self) -> tuple[DrawnReading, ...]:
        """The constructions: one for each reading, or for each circle that a pivot may lie on."""
        self.made.add(SYNTHESIS)
        return self.family.drawn(self.task)

    @property
    def boards(self) -> tuple[Board, ...]:
        """The boards in the order of drawing."""
        return tuple(one.board for one in self.drawn)

    @cached_property
    def synthesis(self) -> Synthesis:
        """What the constructions give."""
        readings = (TaskReading(one.kept, tuple(made.design for made in one.found)) for one in self.drawn)
        return Synthesis(CONSTRUCTION, tuple(readings))

    @cached_property
    def region(self) -> Region | None:
        """What the free parameter of the task makes of the mechanism that is taken, if there is one."""
        return self.family.region(self.task, self.synthesis.chosen)
