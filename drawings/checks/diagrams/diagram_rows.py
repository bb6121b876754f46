"""A row of the kinematic diagrams on a sheet held to the analysis: ordinates, points, curves, numbers, scales."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.diagrams.expected_rows import ExpectedRow
from drawings.checks.graphs.figure_strokes import FLUSH, NEAR, FigureStrokes, figure, read
from drawings.checks.graphs.graph import Graph
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.diagrams.frame import NAME
from drawings.figures.diagrams.row_graph import LEAST, MARKED
from drawings.lettering.words import number
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Polyline
from plans.model.motion import Floats
from plans.words.words import message


def named(key: str) -> str:
    """Name a part of the figure."""
    return f"{NAME}-{key}"


@dataclass(frozen=True)
class RowGraph(Graph):
    """A row as it is laid out, with what it must show."""

    row: ExpectedRow
    strokes: FigureStrokes
    measured: Measured
    along: float  # scale of the crank angle, rad a mm
    drafting: Drafting

    @property
    def name(self) -> str:
        """The name of the part."""
        return named(self.row.key)

    @cached_property
    def mu(self) -> float:
        """The scale of the ordinates: that which is written."""
        return written_scales(self.strokes.group).get(self.row.letter, 1.0)

    @property
    def slack(self) -> float:
        """How far a value may be off: the sheet's resolution, and what both roads may differ by."""
        most = float(np.nanmax(np.abs(self.row.at), initial=0.0))
        return 2 * self.measured.quantum * self.mu + KNOWN * most + self.row.allowed

    @property
    def places(self) -> dict[int, float]:
        """The angles of the positions by their numbers; of position 0 of a turn the first."""
        pairs = zip(self.row.axis.numbers, self.row.axis.turned.tolist(), strict=True)
        return dict(reversed(list(pairs)))

    def faults(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """Hold the whole row; `shared` are the positions that any row numbers."""
        yield from self.axes()
        yield from self._ordinates(shared)
        yield from self._ticks()
        yield from self._numbers(shared)
        yield from self._scales()
        if not self.row.flat:
            yield from self._points()
            yield from self._chains()
        yield from self._caption()

    def _ordinates(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """Hold the ordinates and their feet; one that is no point must be there."""
        values = dict(zip(self.row.axis.numbers, self.row.at.tolist(), strict=True))
        for k, one in self.marks.items():
            if not abs(one.value - 1j * values.get(k, np.nan)) <= self.slack:
                yield on("differs_at", self.name, name=one.name, position=k)
            elif one.name != str(k) or not abs(one.start - self.on(self.places[k])) <= FLUSH:
                yield on("foot", self.name, name=one.name)
        for k in sorted(shared - self.marks.keys()):
            if abs(values[k]) > LEAST * self.mu + self.slack and not self.row.flat:
                yield on("missing_at", self.name, name=str(k), position=k)

    def _ticks(self) -> Iterator[Wrong]:
        """See that each position whose value stands on the row is marked on the axis by a tick."""
        upright = (one for one in self.strokes.lines if abs((one.end - one.start).real) <= NEAR)
        middles = np.array([(one.start + one.end) / 2 for one in upright])
        for k, turned in self.places.items():
            few = len(self.row.axis.turned) <= MARKED + 1
            if (few or k in self.marks) and not np.abs(middles - self.on(turned)).min(initial=np.inf) <= FLUSH:
                yield on("foot", self.name, name=str(k))

    @cached_property
    def numbered(self) -> frozenset[int]:
        """The positions whose numbers stand beside their feet."""
        places = self.places.items()
        return frozenset(k for k, turned in places if self.strokes.lettered(str(k), [self.on(turned)]))

    def _numbers(self, shared: frozenset[int]) -> Iterator[Wrong]:
        """See that all rows number the same positions, and that each number is that of a position beside it."""
        yield from (on("letter", self.name, name=str(k)) for k in sorted(shared - self.numbered))
        feet: dict[str, list[complex]] = {}
        for k, turned in zip(self.row.axis.numbers, self.row.axis.turned.tolist(), strict=True):
            feet.setdefault(str(k), []).append(self.on(turned))
        for text in {text for text in self.strokes.texts if text.isdigit()}:
            if not self.strokes.lettered(text, feet.get(text, ())):
                yield on("letter", self.name, name=text)
        for letter in (f"{self.row.letter}, {self.drafting.word(self.row.unit)}", "φ"):
            if read(letter) not in self.strokes.texts:
                yield on("letter", self.name, name=letter)

    def _scales(self) -> Iterator[Wrong]:
        """Hold the written scale against that of the ordinates."""
        stated = {one.scale for one in self.marks.values()}
        if any(number(self.mu) != number(one) for one in stated):
            yield message("wrong.scale", text=f"μ_{self.row.letter}")

    def _points(self) -> Iterator[Wrong]:
        """See that a point stands at each value by the plans, and at each by chords."""
        dots = np.array([one.centre for one in self.strokes.circles])
        few = len(self.row.axis.turned) <= MARKED + 1
        whole = zip(self.row.axis.numbers, self.row.axis.turned.tolist(), self.row.at.tolist(), strict=True)
        due = [(str(k), x, y) for k, x, y in whole if (few or k in self.marks) and not np.isnan(y)]
        if few:
            chords = zip(self.row.places.tolist(), self.row.values.tolist(), strict=True)
            due += [(f"{self.row.letter}(φ)", x, y) for x, y in chords]
        for name, x, y in due:
            if not dots.size or np.abs(dots - self.on(x, y)).min() > FLUSH + self.slack / self.mu:
                yield on("edge", self.name, name=name)

    def _chains(self) -> Iterator[Wrong]:
        """See that the curves go as they must: by chords thick, the exact one thin, of the first row its chords."""
        thick = self.drafting.hand.main
        results = [one for one in self.strokes.chains if one.style.width >= thick]
        thin = [one for one in self.strokes.chains if one.style.width < thick]
        beside = self.row.exact if self.row.chorded else self._chords
        if not self._spans(results, self.row.runs) or not all(self._near(one, self.row.result) for one in results):
            yield on("curve", self.name)
        axis = self.row.axis
        whole = [(float(axis.turned[run.start]), float(axis.turned[run.stop - 1])) for run in axis.runs]
        if not all(self._near(one, beside) for one in thin) or not self._covers(thin, whole):
            yield on("line", self.name)

    def _chords(self, turned: Floats) -> Floats:
        return np.asarray(np.interp(turned, self.row.axis.turned, self.row.at))

    def _near(self, chain: Polyline, curve: Callable[[Floats], Floats]) -> bool:
        """Tell whether all corners of a chain are on a curve."""
        spots = np.array(chain.points) - self.zero
        off = np.abs(curve(spots.real * self.along) - spots.imag * self.mu)
        return bool((off <= FLUSH * self.mu + self.slack).all())

    def _spans(self, chains: list[Polyline], due: tuple[tuple[float, float], ...]) -> bool:
        """Tell whether chains go from where to where they must, one for each run."""
        runs = sorted((min(p.real for p in one.points), max(p.real for p in one.points)) for one in chains)
        ends = sorted((self.on(low).real, self.on(high).real) for low, high in due)
        return len(runs) == len(ends) and bool(np.abs(np.array(runs) - np.array(ends)).max(initial=0.0) <= FLUSH)

    def _covers(self, chains: list[Polyline], due: list[tuple[float, float]]) -> bool:
        """Tell whether chains cover all the runs, but for where there is no value; chords go from end to end."""
        if not self.row.chorded and not self._spans(chains, tuple(due)):
            return False
        spots = np.sort(np.array([p.real for one in chains for p in one.points]))
        for low, high in due:
            own = np.linspace(low, high, 2 * len(self.row.axis.turned))[1:-1]
            there = own[np.isfinite(self.row.exact(own))]
            apart = np.array([np.abs(spots - self.on(x).real).min() if spots.size else np.inf for x in there])
            if (apart > self._step).any():
                return False
        return True

    @property
    def _step(self) -> float:
        """How far a corner of a chain is from another at the most, mm: the chords of the first row have long ones."""
        if not self.row.chorded:
            return float(np.diff(self.row.axis.turned).max()) / self.along
        return float(np.diff(self.row.axis.turned).max()) / self.along / 2

    def _caption(self) -> Iterator[Wrong]:
        """Hold the caption, and what is told under it: how far the chords are off."""
        if f"{self.row.letter}(φ)" not in self.strokes.texts:
            yield message("wrong.missing", name=f"{self.row.letter}(φ)")
        due = self.row.said(self.drafting)
        seen = [text for text in self.strokes.texts if self._said(text)]
        yield from self.told(seen, due)

    def _said(self, text: str) -> bool:
        heads = (read(self.drafting.word(key, off="")).split(" ")[0] for key in ("chords off", "diagram flat"))
        return any(text.startswith(head) for head in heads)


def graphs(
    measured: Measured, leaf: Leaf, rows: tuple[ExpectedRow, ...], drafting: Drafting, along: float
) -> tuple[RowGraph, ...]:
    """Give the rows that are laid out, from the top."""
    found = [(row, figure(leaf, named(row.key))) for row in rows]
    return tuple(RowGraph(row, own, measured, along, drafting) for row, own in found if own is not None)
