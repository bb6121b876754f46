"""The self-check of enlarged details: what a force plan cannot letter is there, as it is by analysis (проверка)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.checks.forces.drawn_lines import DrawnLines
from drawings.checks.forces.laid_scheme import FINE
from drawings.checks.forces.written_equations import WrittenEquations
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.wrong import Wrong, on
from drawings.figures.forces.force_polygon import DETAIL
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Circle, Group, Leaf
from drawings.paper.walk import groups, texts
from plans.words.words import message

Sheets: TypeAlias = Sequence[tuple[Measured, Leaf]]


class Details(NamedTuple):
    """The details of one force plan, on any sheet of its position, with its forces and their parts by analysis, N."""

    measured: Measured  # the sheet of the plan itself
    sheets: Sheets  # all of its position
    label: str
    known: Mapping[str, complex]
    letters: Mapping[str, str]  # as the sheet reads the forces
    names: Mapping[str, str]  # of all forces and parts by their letters in equations
    slack: float

    def faults(self) -> Iterator[Wrong]:
        """Hold each vector of a detail, each small force of the plan, and the circle around what is enlarged."""
        plan = f"forces-{self.label}"
        whole = {one.name: one for one in self.measured.vectors if one.plan == plan}
        every = (one for measured, _ in self.sheets for one in measured.vectors)
        enlarged = [one for one in every if self._details(one)]
        for one in enlarged:
            near = self.slack + 2 * self.measured.quantum * one.scale
            if one.name not in self.known or not abs(one.value - self.known[one.name]) <= near:
                yield on("differs_on", one.plan, name=one.name)
        if whole:
            yield from self._small(plan, whole, {one.name for one in enlarged})
            yield from self._circles(plan, whole, enlarged)
            for name in dict.fromkeys(one.plan for one in enlarged):
                yield from self._lines(name, [one for one in enlarged if one.plan == name], whole.keys())

    def _lines(self, name: str, own: Sequence[MeasuredVector], sides: Collection[str]) -> Iterator[Wrong]:
        """Hold that a detail follows the sides before and after it a little, and has no line beside these."""
        for figure in self._figures(name):
            drawn = DrawnLines(FigureStrokes(figure))
            carried = [line for one in own for line in self._carriers(drawn, one)]
            corners = {spot for one in own for spot in (one.start, one.end)} | {end for one in carried for end in one}
            others = [self.known[one] for one in self._beside({one.name for one in own}, sides)]
            stubs = [drawn.along(spot, way) for spot in corners for way in others if abs(way) > 0]
            followed = np.any([drawn.none, *stubs], axis=0)
            lanes = [drawn.along(start, end - start) for start, end in carried]
            if others and not followed.any():
                yield on("line", name)
            yield from drawn.strays(name, np.asarray(np.any([followed, *lanes], axis=0)))

    def _beside(self, own: Set[str], sides: Collection[str]) -> Collection[str]:
        """Name the sides before and after those of a detail, by the equation of forces; without it all others."""
        found = (WrittenEquations(one) for one in self._figures_named(f"equations-{self.label}"))
        order = [self.names[one.letter] for told in found for one in told.forces if one.letter in self.names]
        if not own <= set(order):
            return [one for one in sides if one not in own]
        due = set[str]()
        for turned in (order, order[::-1]):
            run = [*turned, *turned]
            for k in (k for k, name in enumerate(turned) if name in own and run[k + 1] not in own):
                ahead = (j for j in range(k + 1, len(run)) if run[j] in sides and run[j] not in own)
                last = next((j for j in ahead if abs(self.known[run[j]]) > self.slack), k)
                due |= {*run[k + 1 : last + 1]}
        return due - own

    def _carriers(self, drawn: DrawnLines, one: MeasuredVector) -> Iterator[tuple[complex, complex]]:
        """Give the lines that carry the ends of a vector over to its lane: square to it, from its own place."""
        way = 1j * (one.end - one.start)
        for spot in (one.start, one.end) if way else ():
            yield from ((line.start, line.end) for line in drawn.strokes.through(spot, way, FINE))

    def _small(self, plan: str, whole: Mapping[str, MeasuredVector], enlarged: set[str]) -> Iterator[Wrong]:
        """Name the outer forces that are not to be seen, neither in a detail nor told of beside a scale."""
        scale = next(iter(whole.values())).scale
        figures = [plan, *{one.plan for sheet, _ in self.sheets for one in sheet.vectors if self._details(one)}]
        lines = (text.plain for name in figures for group in self._figures(name) for text in texts((group,)))
        told = {word.rstrip(",") for line in lines for word in line.split()}  # a letter may have a comma inside: R10,11
        for name, letter in self.letters.items():
            small = self.slack < abs(self.known[name]) < SEEN * scale - self.slack
            if small and name not in enlarged and letter not in told:
                yield on("missing_on", plan, name=name)

    def _circles(
        self, plan: str, whole: Mapping[str, MeasuredVector], enlarged: Sequence[MeasuredVector]
    ) -> Iterator[Wrong]:
        """Hold that a circle with the letter of each detail stands around what the detail shows."""
        marks = {
            one.data["name"]: one.strokes[0]
            for figure in self._figures(plan)
            for one in groups((figure,))
            if one.data.get("kind") == "detail"
        }
        labels = [text for figure in self._figures(plan) for text in texts((figure,))]
        for name in {one.plan.rpartition("-")[2] for one in enlarged} | marks.keys():
            circle, own = marks.get(name), [one.name for one in enlarged if one.plan.endswith(f"-{name}")]
            ends = [end for one in own if one in whole for end in (whole[one].start, whole[one].end)]
            if (
                not own
                or not isinstance(circle, Circle)
                or not _around(circle, ends)
                or not any(text.plain == name for text in labels)
            ):
                yield on("missing_on", plan, name=name)
            titles = (text for one in self._figures(f"{DETAIL}{self.label}-{name}") for text in texts((one,)))
            if not any(name in text.plain.split() for text in titles):
                yield message("wrong.missing", name=name)

    def _details(self, one: MeasuredVector) -> bool:
        return one.plan.startswith(f"{DETAIL}{self.label}-")

    def _figures(self, plan: str) -> list[Group]:
        return [one for _, leaf in self.sheets for one in leaf.groups if one.name.rpartition("-")[0] == plan]

    def _figures_named(self, name: str) -> list[Group]:
        return [one for _, leaf in self.sheets for one in leaf.groups if one.name == name][:1]


def _around(circle: Circle, ends: Sequence[complex]) -> bool:
    """Tell whether a circle stands around some places, no further from their middle than they are from one another."""
    if not ends:
        return True  # too small to be drawn at all
    spread = max(abs(one - other) for one in ends for other in ends)
    near = abs(circle.centre - sum(ends) / len(ends)) <= max(spread, SEEN)
    return near and all(abs(end - circle.centre) <= circle.radius for end in ends)
