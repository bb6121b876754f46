"""The kinematic diagrams: S, v, a of the output one under another, v and a from poles (кинематические диаграммы)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from drawings.figures.diagrams.frame import NAME, DiagramRow, DiagramsFrame, DiagramsPlate
from drawings.figures.diagrams.row_graph import graph_part, letters_of, numbered_positions, pole_part
from drawings.figures.graphs.part import Part, caption, wide
from drawings.layout.labels import Labels
from drawings.layout.picture import Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from drawings.paper.strokes import Group, Stroke, Text
from drawings.symbols.figure import heading
from plans.diagrams.study import DiagramsStudy

APART = 1.6  # sizes of a text from a row's caption to the line under it
PER_CENT = 2  # digits of an error


class DiagramsFigure(NamedTuple):
    """The diagrams placed on paper: the figure's heading and its parts."""

    head: Group
    parts: tuple[Part, ...]

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        return self.head, *(line for part in self.parts for line in part.lines)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give all the parts, lettered."""
        return self.head, *(part.group(labels) for part in self.parts)


def measure(own: DiagramsStudy, drafting: Drafting) -> Picture:
    """Measure the room of the diagrams."""
    plate = DiagramsPlate(own, drafting)
    head = text_width(Text(0j, title(own, drafting), drafting.hand.title))
    return plate.room(max(head, *(_wide(row, plate) for row in plate.rows)))


def draw(own: DiagramsStudy, spot: Spot, drafting: Drafting) -> DiagramsFigure:
    """Draw the diagrams in their spot."""
    return _Drawing(DiagramsFrame(DiagramsPlate(own, drafting), spot)).figure


def title(own: DiagramsStudy, drafting: Drafting) -> str:
    """Head the figure with the output: a point of what slides, a link that turns."""
    travel, out = own.course.travel, own.linkage.output
    point = (out.point or (travel.slide.point if travel.slide else "")) if travel.sliding else ""
    return drafting.word("diagrams of point" if point else "diagrams of link", link=out.link, point=point)


@dataclass(frozen=True)
class _Drawing:
    """Diagrams at their scale, to be drawn."""

    frame: DiagramsFrame

    @property
    def plate(self) -> DiagramsPlate:
        return self.frame.plate

    @property
    def figure(self) -> DiagramsFigure:
        graphs = tuple(self._graph(row) for row in self.plate.rows)
        return DiagramsFigure(self._head(), (*graphs, *self._poles()))

    def _head(self) -> Group:
        """Write the heading of the figure, and the scales along its axis."""
        drafting, spot = self.plate.drafting, self.frame.spot
        scales = ";  ".join(map(drafting.scale, (spot.scale, self.frame.argument)))
        return Group((heading(spot.box, title(self.plate.own, drafting), scales, self.plate.hand),), NAME)

    @cached_property
    def _numbered(self) -> tuple[int, ...]:
        return numbered_positions(self.plate, self.frame.length)

    def _graph(self, row: DiagramRow) -> Part:
        """Draw a row with its title over it, and by how much the chords are off."""
        plate = self.plate
        part = graph_part(row, plate, self.frame.axes(row), self._numbered)
        field = self.frame.fields[row.key]
        over = field._replace(top=field.top + plate.over)
        head = caption(caption_of(row, plate), ";  ".join(self._scales(row)), over, plate.hand)
        low = complex(over.centre.real, over.top - plate.hand.title - APART * plate.hand.text)
        told = (Text(low, text, plate.hand.text, "middle", True) for text in said(row, plate))
        return part._replace(lines=(Group((head, *told)), *part.lines))

    def _scales(self, row: DiagramRow) -> Iterator[str]:
        """Write the scale of a row, with the pole distance that it comes from."""
        drafting, distance = self.plate.drafting, self.frame.distance(row)
        if not row.flat:
            yield drafting.scale(self.frame.scales[row.key])
        if distance is not None:
            yield f"{letters_of(row)[1]} = {drafting.number(distance)} {drafting.word('mm')}"

    def _poles(self) -> Iterator[Part]:
        for row in self.plate.rows:
            distance = self.frame.distance(row)
            if distance is not None:
                yield pole_part(row, self.plate, self.frame.axes(row), distance)


def caption_of(row: DiagramRow, plate: DiagramsPlate) -> str:
    """Give the caption of a row: its letter over the crank angle."""
    return f"{row.letter}(φ)"


def said(row: DiagramRow, plate: DiagramsPlate) -> Iterator[str]:
    """Tell under the caption by how much the chords are off, or that the row shows nothing."""
    if row.flat:
        yield plate.drafting.word("diagram flat")
    elif row.off is not None:
        yield plate.drafting.word("chords off", off=plate.drafting.number(100 * row.off.share, PER_CENT))


def _wide(row: DiagramRow, plate: DiagramsPlate) -> float:
    """Give the width that a row needs for its caption, mm, with scales as long as they may be."""
    drafting = plate.drafting
    scale = drafting.scale(Scale(0.0025, f"{{{row.letter}}}", row.unit))
    long = wide(caption_of(row, plate), f"{scale};  H_1 = 55.55 {drafting.word('mm')}", plate.hand)
    told = (text_width(Text(0j, text, plate.hand.text)) for text in said(row, plate))
    return plate.proportions.left * plate.hand.letter + max(long, *told, 0.0)
