"""The diagrams of a cam's law on a sheet held to the analysis: ordinates, curves, phases, shocks (диаграммы закона)."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.cam.cam_expected import Expected, phase_name
from drawings.checks.cam.cam_law_rows import Course, ExpectedRow, expected_rows
from drawings.checks.graphs.figure_strokes import FLUSH, NEAR, FigureStrokes, figure, read
from drawings.checks.graphs.graph import Graph
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.law_graph import LEAST, MARKED
from drawings.lettering.words import number
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Line, Polyline
from plans.model.cam import Cam
from plans.model.motion import Floats
from plans.words.words import message


def named(cam: Cam, key: str = "") -> str:
    """Name the figure of a cam's law, or a part of it."""
    return f"law-{cam.name}-{key}" if key else f"law-{cam.name}"


@dataclass(frozen=True)
class LawGraph(Graph):
    """A row of the diagrams as it is laid out, with what it must show."""

    row: ExpectedRow
    strokes: FigureStrokes
    measured: Measured
    expected: Expected
    along: float  # scale of the cam's turn, rad or m to a mm
    drafting: Drafting

    @property
    def name(self) -> str:
        """The name of the part."""
        return named(self.expected.cam, self.row.key)

    @cached_property
    def mu(self) -> float:
        """The scale of the ordinates."""
        stated = (one.scale for one in self.marks.values())
        return next(stated, written_scales(self.strokes.group).get(self.row.letter, 1.0))

    @property
    def slack(self) -> float:
        """How far a value may be off: the sheet's resolution, and what both roads may differ by."""
        return 2 * self.measured.quantum * self.mu + KNOWN * self.row.most

    def faults(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """Hold the whole row; `shared` are the edges that any row numbers."""
        yield from self._ordinates(shared)
        yield from self._numbers(shared)
        yield from self._scales()
        yield from self._dots()
        yield from self._chains()
        yield from self._impulses()
        yield from self._caption()

    def _ordinates(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """Hold the ordinates and their feet; one that is no point must be there."""
        after, edges = self.row.after, self.expected.edges
        for k, one in self.marks.items():
            if not (0 <= k < len(after) and abs(one.value - 1j * after[k]) <= self.slack):
                yield on("differs_at", self.name, name=one.name, position=k)
            elif one.name != self.expected.names[k] or not abs(one.start - self.on(edges[k])) <= FLUSH:
                yield on("foot", self.name, name=one.name)
        for k in sorted(shared - self.marks.keys()):
            if abs(after[k]) > LEAST * self.mu + self.slack:
                yield on("missing_at", self.name, name=self.expected.names[k], position=k)

    @cached_property
    def numbered(self) -> frozenset[int]:
        """The edges whose names stand beside their feet."""
        names, edges = self.expected.names, self.expected.edges
        return frozenset(k for k, name in enumerate(names) if self.strokes.lettered(name, [self.on(edges[k])]))

    def _numbers(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """See that all rows number the same edges, and that each number is that of an edge beside it."""
        yield from (on("letter", self.name, name=self.expected.names[k]) for k in sorted(shared - self.numbered))
        names = self.expected.names
        for text, count in Counter(self.strokes.texts).items():
            if text.rstrip("'").isdigit() and count > sum(names[k] == text for k in self.numbered):
                yield on("letter", self.name, name=text)

    def _scales(self) -> Iterator[Wrong]:
        """Hold the written scale against that of the ordinates."""
        written = written_scales(self.strokes.group).get(self.row.letter, 0.0)
        if self.marks and number(written) != number(self.mu):
            yield message("wrong.scale", text=f"μ_{self.row.letter}")

    def _dots(self) -> Iterator[Wrong]:
        """See that a point stands at each edge, at a jump two."""
        dots = np.array([one.centre for one in self.strokes.circles])
        count = len(self.expected.edges)
        for k in range(count) if count <= MARKED + 1 else self.numbered:
            spots = [self.on(self.expected.edges[k], float(side[k])) for side in (self.row.after, self.row.before)]
            if not all(dots.size and np.abs(dots - spot).min() <= FLUSH for spot in spots):
                yield on("edge", self.name, name=self.expected.names[k])

    def _chains(self) -> Iterator[Wrong]:
        """See that the curve goes over the whole turn as it must, and that what is drawn thin is chords or exact."""
        thick = self.drafting.hand.main
        results = [one for one in self.strokes.chains if one.style.width >= thick]
        ends = self.on(0.0).real, self.on(self.expected.cam.turn).real
        if not results or not _spans(results, ends):
            yield on("curve", self.name)
        for one in results:
            if not self._near(one, self.row.curve):
                yield on("curve", self.name)
        thin = [one for one in self.strokes.chains if one.style.width < thick]
        chords = [one for one in thin if self._near(one, self.row.chords)]
        if self.row.chorded and not (chords and _spans(chords, ends)):
            yield on("line", self.name)
        for one in thin:
            if one not in chords and not self._near(one, self.row.exact):
                yield on("curve", self.name)

    def _near(self, chain: Polyline, curve: Course) -> bool:
        """Tell whether all corners of a chain are on a curve."""
        spots = np.array(chain.points) - self.zero
        values = curve(self._turned(spots.real * self.along))
        off = np.min([np.abs(one - spots.imag * self.mu) for one in values], axis=0)
        return bool((off <= FLUSH * self.mu + self.slack).all())

    def _turned(self, turned: Floats) -> Floats:
        """Put turns that are those of edges but for roundings on them."""
        edges = self.expected.edges
        near = edges[np.abs(turned[:, None] - edges).argmin(axis=1)]
        return np.where(np.abs(turned - near) <= NEAR * self.along, near, turned)

    def _impulses(self) -> Iterator[Wrong]:
        """Hold the arrows of infinite accelerations, up or down with their letter: one at each hard shock."""
        if self.row.key != "acceleration":
            return
        arrows = [one for one in self.strokes.pointings if abs((one.tip - one.start).real) <= NEAR]
        arrows = [one for one in arrows if self.strokes.lettered("∞", [one.tip])]
        due = [(self.on(turned), up) for turned, up in self.row.impulses]
        for foot, up in due:
            if not any(abs(one.start - foot) <= FLUSH and (one.tip - one.start).imag * up > 0 for one in arrows):
                yield on("missing_on", self.name, name="∞")
        feet = [self.zero, *(foot for foot, _ in due)]  # the axis of ordinates points upward from the first of them
        if any(min(abs(one.start.real - foot.real) for foot in feet) > FLUSH for one in arrows):
            yield on("stranger_on", self.name, name="∞")

    def _caption(self) -> Iterator[Wrong]:
        """Hold the title, and what is told under it: shocks with their places, or how far the chords are off."""
        title = f"{self.drafting.word(f'law {self.row.key}')} {self.row.letter}"
        if read(title) not in self.strokes.texts:
            yield message("wrong.missing", name=title)
        due = self.row.said(self.drafting)
        seen = [text for text in self.strokes.texts if self.tells(text)]
        yield from self.told(seen, due)

    def tells(self, text: str) -> bool:
        """Tell whether a text tells of shocks or chords."""
        heads = (
            read(self.drafting.word(key, places="", off="")) for key in ("hard shocks", "soft shocks", "chords off")
        )
        return any(text.startswith(head.split(" ")[0]) for head in heads)


def diagrams(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the diagrams of a cam's law: each row, the phases under them; the poles have a file of their own."""
    found = graphs(measured, leaf, expected, drafting)
    if len(found) < len(expected_rows(expected)):
        yield message("wrong.missing", name=named(expected.cam))
        return
    if math.isnan(found[0].along):  # nothing says where a turn of the cam lies
        yield message("wrong.scale", text="μ_x" if expected.cam.translates else "μ_φ")
        return
    shared = frozenset(k for one in found for k in (*one.marks, *one.numbered))
    for one in found:
        yield from one.faults(shared)
    yield from _phases(leaf, found[-1], expected, drafting)


def graphs(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> tuple[LawGraph, ...]:
    """Give the rows that are laid out, from the top."""
    rows = [(one, figure(leaf, named(expected.cam, one.key))) for one in expected_rows(expected)]
    turn = "x" if expected.cam.translates else "φ"
    stated = (written_scales(own.group) for _, own in rows if own is not None)
    along = next((own[turn] for own in stated if turn in own), float("nan"))
    return tuple(
        LawGraph(row, strokes, measured, expected, along, drafting) for row, strokes in rows if strokes is not None
    )


def _phases(leaf: Leaf, last: LawGraph, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the dimensions of the phases under the last row, and their bounds through all rows."""
    plan, cam = named(expected.cam), expected.cam
    sizes, bounds = (figure(leaf, named(cam, key)) for key in ("phases", "bounds"))
    for k, phase in enumerate(cam.phases):
        ends = [last.on(turned).real for turned in (phase.start, phase.end)]
        letter = phase_name(cam, k, drafting)
        lines = [] if sizes is None else [one for one in sizes.lines if _level(one, ends)]
        if sizes is None or not any(sizes.lettered(letter, [(one.start + one.end) / 2]) for one in lines):
            yield on("phase", plan, name=letter)
        upright = [] if bounds is None else [one for one in bounds.lines if abs(one.start.real - ends[0]) <= FLUSH]
        if k and not upright:
            yield on("phase", plan, name=letter)
    starts = [last.on(phase.start).real for phase in cam.phases]
    for one in () if bounds is None else bounds.lines:
        if min(abs(one.start.real - start) for start in starts) > FLUSH:
            yield on("phase", plan, name="φ")


def _level(line: Line, ends: list[float]) -> bool:
    xs = sorted((line.start.real, line.end.real))
    level = abs((line.end - line.start).imag) <= NEAR
    return level and max(abs(one - other) for one, other in zip(xs, ends, strict=True)) <= FLUSH


def _spans(chains: list[Polyline], ends: tuple[float, float]) -> bool:
    """Tell whether chains go from one end to the other together."""
    runs = sorted((min(p.real for p in one.points), max(p.real for p in one.points)) for one in chains)
    reached = runs[0][0]
    for start, end in runs:
        if start > reached + FLUSH:
            return False
        reached = max(reached, end)
    return abs(runs[0][0] - ends[0]) <= FLUSH and abs(reached - ends[1]) <= FLUSH
