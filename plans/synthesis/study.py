"""The study of a task of synthesis: its constructions, each made once, and the mechanisms that they give."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property

from geometry.board import Board
from plans.model.synthesis import (
    CONSTRUCTION,
    CrankRocker,
    Reading,
    RockerTask,
    SliderCrank,
    SliderTask,
    Synthesis,
    readings_of,
)
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.rocker import DrawnRocker, rockers
from plans.synthesis.slider import DrawnSlider, drawn_slider

KEPT = ("rocker", "swing", "overlap")  # of a crank-rocker: all of its demands


class SynthesisStudy:
    """A task, and what is drawn of it; the free parameter of a crank-rocker is given, by the scene or as the best."""

    def __init__(self, task: RockerTask | SliderTask, sought: bool = False) -> None:
        self.task = task
        self.sought = sought  # the free parameter: that with the largest least transmission angle
        self.made: set[str] = set()

    def construct(self, plans: Collection[str]) -> None:
        """Draw the task, if it is asked for."""
        if SYNTHESIS in plans:
            _ = self.drawn

    @cached_property
    def drawn(self) -> tuple[DrawnRocker | DrawnSlider, ...]:
        """The constructions: of a crank-rocker one for each circle, of a slider-crank one for each reading."""
        self.made.add(SYNTHESIS)
        if isinstance(self.task, RockerTask):
            return rockers(self.task)
        return tuple(drawn_slider(one) for one in readings_of(self.task))

    @property
    def boards(self) -> tuple[Board, ...]:
        """The boards in the order of drawing."""
        return tuple(one.board for one in self.drawn)

    @cached_property
    def synthesis(self) -> Synthesis:
        """What the constructions give."""
        return Synthesis(CONSTRUCTION, tuple(self._readings()))

    def _readings(self) -> Iterator[Reading]:
        if isinstance(self.task, RockerTask):
            yield Reading(KEPT, tuple(made for one in self.drawn for _, made in one.found))
            return
        for one in self.drawn:
            yield Reading(one.task.demands, tuple(made for _, made in one.found))  # type: ignore[union-attr]

    @property
    def chosen(self) -> CrankRocker | SliderCrank:
        """The mechanism that is taken: the first of the first reading that has one, of crank-rockers the best."""
        found = next(reading.found for reading in self.synthesis.readings if reading.found)
        rockers = [one for one in found if isinstance(one, CrankRocker)]
        return max(rockers, key=lambda one: one.transmission) if rockers else found[0]
