"""The self-check of the lines of both views of a bank: cranks, guides, places, sense of rotation (линии видов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from drawings.checks.bank.bank_expected import LINE, Expected
from drawings.checks.graphs.figure_strokes import NEAR, FigureStrokes, figure
from drawings.checks.letters import distance, labels_of
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank import shaft, star
from drawings.layout.ink import CELL, CLEAR
from drawings.layout.labels import NEAR as NEAR_BY
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Fill, Group, Leaf, Line, Polyline, Text
from drawings.paper.walk import groups

DIGITS = 4  # of a dimension
BESIDE = star.BESIDE + NEAR_BY[-1] + CLEAR + CELL  # mm: so near to a guide's end stands its letter, or its leader


def faults(leaf: Leaf, expected: Expected, drafting: Drafting, figures: frozenset[str]) -> Iterator[Wrong]:
    """Hold both views, where a sheet bears them."""
    cranks, along = figure(leaf, star.NAME), figure(leaf, shaft.NAME)
    if star.NAME in figures and cranks is not None:
        yield from _Star(cranks, expected, drafting).faults()
    if shaft.NAME in figures and along is not None:
        yield from _Shaft(along, expected, drafting).faults()


def origin(strokes: FigureStrokes) -> tuple[complex, float]:
    """Give where the zero of a figure lies on paper, mm, and its scale."""
    for one in groups((strokes.group,)):
        if one.data.get("kind") == "pole" and isinstance(one.strokes[0], Circle):
            return one.strokes[0].centre, float(one.data["scale"])
    return 0j, 1.0


@dataclass(frozen=True)
class View:
    """A view of a bank with what it must show."""

    strokes: FigureStrokes
    expected: Expected
    drafting: Drafting

    @cached_property
    def zero(self) -> complex:
        """The shaft, or its place 0, on paper."""
        return origin(self.strokes)[0]

    @cached_property
    def mu(self) -> float:
        """Its scale, m/mm."""
        return origin(self.strokes)[1]


class _Star(View):
    """The star of cranks."""

    @property
    def radius(self) -> float:
        """The length of the cranks on paper: of those without a scale that of the circle of the pins."""
        if self.expected.crank is not None:
            return self.expected.crank / self.mu
        return max((one.radius for one in self.strokes.circles if abs(one.centre - self.zero) <= NEAR), default=0.0)

    def faults(self) -> Iterator[Wrong]:
        spots = {one.name: self.zero + self.radius * self.expected.crank_at(one) for one in self.expected.members}
        if not self.strokes.circled(self.zero, self.radius):
            yield on("circle", star.NAME, name="r")
        for name, spot in spots.items():
            if not self.strokes.joins(self.zero, spot):
                yield on("crank", star.NAME, name=name)
            elif not self.strokes.lettered(name, [spot]):
                yield on("letter", star.NAME, name=name)
        yield from self._strangers(list(spots.values()))
        yield from self._guides()
        sense = 1 if self.expected.task.speed > 0 else -1
        arrows = [one for one in self.strokes.turnings if abs(one.centre - self.zero) <= NEAR]
        if [one.sense for one in arrows] != [sense] or not self.strokes.lettered("ω", [arrows[0].middle]):
            yield on("sense", star.NAME, name="ω")

    def _strangers(self, spots: Sequence[complex]) -> Iterator[Wrong]:
        """See that no main line leads elsewhere than to a crank pin."""
        for one in self.strokes.lines:
            thick = one.style.width >= self.drafting.hand.main
            if thick and min(abs(one.end - spot) for spot in spots) > NEAR:
                yield on("crank", star.NAME, name="?")

    def _guides(self) -> Iterator[Wrong]:
        """Hold the axes of the guides: each goes out beyond the pins; of several each is lettered at its own end."""
        ways = self.expected.ways()
        for name, way in ways.items():
            lines = self.strokes.through(self.zero, way)
            ends = [end for one in lines if one.style.dash for end in (one.start, one.end)]
            if not any(((end - self.zero) * way.conjugate()).real > self.radius for end in ends):
                yield on("guide", star.NAME, name=name)
        if any(abs(one - other) > LINE for one in ways.values() for other in ways.values()):
            yield from self._letters(ways)

    def _letters(self, ways: Mapping[str, complex]) -> Iterator[Wrong]:
        for way in ways.values():
            own = ", ".join(name for name, other in ways.items() if abs(other - way) <= LINE)
            text = self.drafting.word("guide of", names=own)
            told = labels_of((self.strokes.group,)).values()
            found = [label for labels in told for label in labels if label.text.plain == text]
            if not distance(found, [self._end(way)]) <= BESIDE:
                yield on("letter", star.NAME, name=text)

    def _end(self, way: complex) -> complex:
        """Give where the axis of a guide ends outward."""
        ends = [end for one in self.strokes.through(self.zero, way) for end in (one.start, one.end)]
        return max(ends, key=lambda end: ((end - self.zero) * way.conjugate()).real, default=self.zero)


class _Shaft(View):
    """The view across the shaft."""

    def faults(self) -> Iterator[Wrong]:
        symbol = self.drafting.hand.symbol
        for one in self.expected.members:
            spot = self.zero + float(one.place) / self.mu
            high = shaft.THROW * symbol * (self.expected.crank_at(one) * self.expected.turn.conjugate()).real
            if not self._thrown(spot, high):
                yield on("crank", shaft.NAME, name=one.name)
            up = (self.expected.ways()[one.name] * self.expected.turn.conjugate()).real
            far = (shaft.THROW + shaft.GUIDE) * symbol * (-1 if up < -LINE else 1)
            if not self.strokes.joins(spot, spot + 1j * far):
                yield on("guide", shaft.NAME, name=one.name)
        yield from self._dimensions()

    def _thrown(self, spot: complex, high: float) -> bool:
        """Tell whether a crank is drawn: its webs and its pin, or a circle where it points to the eye."""
        if abs(high) <= LINE * shaft.THROW:
            radius = shaft.PIN * self.drafting.hand.symbol
            return self.strokes.circled(spot, radius)
        half = shaft.WEB * self.drafting.hand.symbol
        corners = (spot - half, spot - half + 1j * high, spot + half + 1j * high, spot + half)
        chains = (one.points for one in self.strokes.chains if len(one.points) == len(corners))
        return any(max(abs(p - q) for p, q in zip(chain, corners, strict=True)) <= NEAR for chain in chains)

    def _dimensions(self) -> Iterator[Wrong]:
        """Hold the dimensions of the places: what each says, and between which places its arrows stand."""
        places: dict[float, list[str]] = {}
        for one in self.expected.members:
            if one.place:
                places.setdefault(float(one.place), []).append(one.name)
        starts = {place: f"h{', '.join(names)} = " for place, names in places.items()}
        some = any(text.startswith("h") for text in self.strokes.texts)  # where one has no room there is none
        for place, start in starts.items() if some else ():
            if not any(self._holds(one, start, place) for one in groups((self.strokes.group,))):
                yield on("size", shaft.NAME, name=start.removesuffix(" = "))

    def _holds(self, group: Group, start: str, place: float) -> bool:
        """Tell whether a group of strokes is the dimension of a place."""
        texts = [one.plain for one in group.strokes if isinstance(one, Text) and one.plain.startswith(start)]
        tips = [one.points[0] for one in group.strokes if isinstance(one, Fill)]
        lines = [one for one in group.strokes if isinstance(one, Line | Polyline)]
        ends = sorted((self.zero.real, (self.zero + place / self.mu).real))
        pairs = zip(sorted(tip.real for tip in tips), ends, strict=False)
        right = len(tips) == len(ends) and all(abs(tip - end) <= NEAR for tip, end in pairs)
        return bool(lines) and right and any(reads(text[len(start) :], 1000 * place, 0.0, DIGITS) for text in texts)
