"""The self-check of the headings of a force sheet: each figure's title, position and scale (проверка заголовков)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.scale_line import scale_text
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.lettering.words import word
from drawings.paper.strokes import Group, Leaf
from plans.forces.cut import indices
from plans.model.mechanism import Drive

RATIO = re.compile(r"\(([\d.,]+):([\d.,]+)\)")
CLOSE = 1e-9  # of a ratio: both of its numbers are those of the scale
TITLES = {"scheme": ("loading scheme", "primary scheme"), "forces": ("force plan", "primary force plan")}
# The letter and the unit of the scale of a figure; of a graph those of its abscissas.
SCALES = {
    "scheme": ("l", "m"),
    "forces": ("F", "N"),
    "detail": ("F", "N"),
    "lever": ("v", "m/s"),
    "hodograph": ("F", "N"),
}


class Headings(NamedTuple):
    """The headings of a sheet of one position: what they must say."""

    leaf: Leaf
    position: int
    drive: Drive
    floor: Floor
    notation: str

    def faults(self) -> Iterator[Wrong]:
        """Hold the heading of each figure of the sheet."""
        scales: Mapping[str, float] = self.leaf.metadata["scales"]
        figures = {one.name: one for one in self.leaf.groups}
        for name, mu in scales.items():
            group = figures.get(f"{name}-{self.position}", figures.get(name))
            if group is not None:
                yield from self._heading(name, mu, group)

    def _heading(self, name: str, mu: float, group: Group) -> Iterator[Wrong]:
        strokes = FigureStrokes(group)
        titles = self._titles(name)
        if titles and not any(read(title) in strokes.texts for title in titles):
            yield on("title", name, text=titles[0])
        kind = name.partition("-")[0]
        if kind in SCALES and self._loaded(strokes):
            yield from self._scale(name, mu, strokes)

    def _loaded(self, strokes: FigureStrokes) -> bool:
        """Tell whether a figure shows anything: an unloaded group has a polygon without sides."""
        return word(self.floor.language, "unloaded") not in strokes.texts

    def _titles(self, name: str) -> tuple[str, ...]:
        """Give the titles of which a figure must have one; none of a graph that another check holds."""
        language, (kind, _, which) = self.floor.language, name.partition("-")
        where = word(language, "position", position=self.position)
        if kind in TITLES:
            key = TITLES[kind][which == str(self.drive.link)]
            return (f"{word(language, key, group=which)}, {where}",)
        if kind == "detail":
            return (word(language, "detail", letter=which.rpartition("-")[2]),)
        if kind == "lever":
            return (f"{word(language, 'lever')}, {where}",)
        if kind == "hodograph":
            giver, taker = (int(link) for link in which.split("-"))
            return (word(language, "hodograph", letter=self.floor.letter(f"R_{indices(giver, taker)}")),)
        keys = ("balancing graph", "balancing swing") if self.drive.turns else ("balancing stroke",)
        return tuple(word(language, key) for key in keys) if kind == "balancing" else ()

    def _scale(self, name: str, mu: float, strokes: FigureStrokes) -> Iterator[Wrong]:
        """Hold that a figure states its scale, with its letter, its unit and its ratio."""
        letter, unit = SCALES[name.partition("-")[0]]
        written = [text for text in strokes.texts if text.startswith(scale_text(mu, letter, unit, self._how))]
        if not written:
            yield on("scale_missing", name, text=scale_text(mu, letter, unit, self._how))
        for text in written:
            told = RATIO.search(text)
            if told is None and letter == "l" and self.notation != "K":
                yield on("scale_missing", name, text="1:")
            elif told is not None and not _ratio(told[1], told[2], mu):
                yield on("scale_missing", name, text=text)

    @property
    def _how(self) -> tuple[str, str]:
        return self.floor.language, self.notation


def _ratio(one: str, other: str, mu: float) -> bool:
    """Tell whether a ratio a:b is a scale of lengths, m/mm."""
    paper, true = (float(text.replace(",", ".")) for text in (one, other))
    return reads(other, 1000 * mu * paper, CLOSE * true, 4) or reads(one, true / (1000 * mu), CLOSE * paper, 4)
