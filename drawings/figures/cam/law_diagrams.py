"""The diagrams of a cam's law one under another over its turn: S'', S' by a pole, S by another (диаграммы движения)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from drawings.figures.cam.law_frame import LEVEL, LawFrame, LawPlate, LawRow
from drawings.figures.cam.law_graph import graph_part, numbered_edges
from drawings.figures.cam.law_pole import POLES, pole_part
from drawings.figures.graphs.part import Part, caption, wide
from drawings.layout.labels import Labels
from drawings.layout.picture import Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import Slot, joined, telling
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.report.cam_letters import ACCELERATION, VELOCITY, letters
from drawings.report.phase_letters import phase_letter
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.dimension import Dimension
from drawings.symbols.trimming import around, trim
from plans.cam.diagrams import LawDiagrams, Strips

CLEAR = 1.5  # mm around a caption
ABOVE = 1.0  # mm from a dimension line to its letters
APART = 1.6  # sizes of a text from the title's line to the one under it
PER_CENT = 2  # digits of an error
ROUNDED = 1e-9  # of the largest value: chords that are exact but for the roundings of their steps


@dataclass(frozen=True)
class LawFigure:
    """The diagrams placed on paper: their parts, the bounds of the phases and the dimensions of these."""

    parts: tuple[Part, ...]
    joining: Group
    phases: tuple[Dimension, ...]
    plate: LawPlate

    @cached_property
    def _sizes(self) -> tuple[Stroke, ...]:
        return tuple(line for one in self.phases for line in one.draw(self.plate.hand))

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        return self.joining, *self._sizes, *(line for part in self.parts for line in part.lines)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give all the parts, lettered."""
        size = self.plate.hand.number
        name, letters = (
            self.plate.named("phases"),
            (labels.along(*one.lines[0], one.letter, size, ABOVE, 1.5) for one in self.phases),
        )
        phases = Group((*self._sizes, *(telling(name, one) for one in letters)), name)
        return self.joining, phases, *(part.group(labels) for part in self.parts)


def measure(shown: LawDiagrams, drafting: Drafting) -> Picture:
    """Measure the room of the diagrams."""
    plate = LawPlate(shown, drafting)
    return plate.room(max(_wide(row, plate) for row in plate.rows))


def draw(shown: LawDiagrams, room: Picture, spot: Spot, drafting: Drafting) -> LawFigure:
    """Draw the diagrams in their spot."""
    return _Drawing(LawFrame(LawPlate(shown, drafting), spot)).figure


@dataclass(frozen=True)
class _Drawing:
    """Diagrams at their scale, to be drawn."""

    frame: LawFrame

    @property
    def plate(self) -> LawPlate:
        return self.frame.plate

    @property
    def figure(self) -> LawFigure:
        graphs = [self._graph(row) for row in self.plate.rows]
        masks = [around(part.lines[0], CLEAR) for part in graphs]
        joining = Group(tuple(fit_dashes(trim(self._bounds(), masks))), self.plate.named("bounds"))
        return LawFigure((*graphs, *self._poles()), joining, tuple(self._phases()), self.plate)

    @cached_property
    def _numbered(self) -> tuple[int, ...]:
        return numbered_edges(self.plate.shown.strips, self.frame.length, self.plate.hand.number)

    def _graph(self, row: LawRow) -> Part:
        """Draw a row with its title over it, and its shocks told."""
        plate = self.plate
        part = graph_part(row, plate, self.frame.axes(row), self._numbered)
        field = self.frame.fields[row.key]
        over = field._replace(top=field.top + plate.over)
        head = caption(_title(row, plate), joined(";  ", self._scales(row)), over, plate.hand)
        low = complex(over.centre.real, over.top - plate.hand.title - APART * plate.hand.text)
        said = (Text(low, text, plate.hand.text, "middle", True) for text in _said(row, plate))
        above, under = (tuple(telling(part.name, one) for one in own) for own in (head.strokes, said))
        return part._replace(lines=(Group((Group(above), *under)), *part.lines))

    def _scales(self, row: LawRow) -> Iterator[str]:
        """Write the scale of a row, with that of the turn or with the pole distance that it comes from."""
        drafting, distance = self.plate.drafting, self.frame.distance(row)
        if not row.flat:
            yield drafting.scale(self.frame.scales[row.key])
        if row.key == ACCELERATION:
            yield drafting.scale(self.frame.spot.scale)
        elif distance is not None:
            letter = POLES[row.key == VELOCITY][1]
            yield joined("", (f"{letter} = ", drafting.slot(Slot("H", distance)), f" {drafting.word('mm')}"))

    def _poles(self) -> Iterator[Part]:
        for row in self.plate.rows:
            distance = self.frame.pole(row)
            if distance is not None:
                yield pole_part(row, self.plate, self.frame.axes(row), distance)

    def _bounds(self) -> Iterator[Line]:
        """Draw the bounds of the phases through all the rows."""
        first, last = self.plate.rows[0], self.plate.rows[-1]
        for phase in self.plate.cam.phases[1:]:
            top, low = (self.frame.axes(row).on(phase.start).real for row in (first, last))
            fields = self.frame.fields
            yield Line(complex(top, fields[first.key].top), complex(low, fields[last.key].bottom), self.plate.hand.axis)

    def _phases(self) -> Iterator[Dimension]:
        """Dimension the phases under the last row."""
        plate, axes = self.plate, self.frame.axes(self.plate.rows[-1])
        level = -1j * LEVEL * plate.hand.number
        for number, phase in enumerate(plate.cam.phases):
            if phase.angle > 0:
                text = phase_letter(plate.cam, number, plate.drafting)
                said = Statement(Kind.LENGTH, plate.named("phases"), f"φ_{number}", scale=axes.across.mu)
                yield Dimension(text, axes.on(phase.start), axes.on(phase.end), level, said)


def _wide(row: LawRow, plate: LawPlate) -> float:
    """Give the width that a row needs for its caption, mm, with scales as long as they may be."""
    drafting, (_, turn) = plate.drafting, letters(plate.cam)
    own = (Scale(0.0025, f"{{{row.letter}}}", row.unit), Scale(0.025, turn, "m" if plate.cam.translates else "rad"))
    long = wide(_title(row, plate), ";  ".join(map(drafting.scale, own)), plate.hand)
    told = (text_width(Text(0j, text, plate.hand.text)) for text in _said(row, plate))
    return plate.proportions.left * plate.hand.letter + max(long, *told, 0.0)


def _title(row: LawRow, plate: LawPlate) -> str:
    return f"{plate.drafting.word(f'law {row.key}')} {row.letter}"


def _said(row: LawRow, plate: LawPlate) -> Iterator[str]:
    """Tell under the title where there are shocks, or by how much the chords are off."""
    if row.key != ACCELERATION:
        yield plate.drafting.phrase("chords off", off=Slot("off", 100 * _noted(row.error), PER_CENT))
        return
    strips = plate.shown.strips
    soft = [k for k in strips.jumps if k not in strips.hard]
    kinds = (("hard shocks", strips.hard), ("soft shocks", soft))
    told = [plate.drafting.word(key, places=_places(strips, edges)) for key, edges in kinds if edges]
    if told:
        yield ";  ".join(told)


def _places(strips: Strips, edges: Iterable[int]) -> str:
    """Name edges; the end of a turn is its beginning."""
    return ", ".join(dict.fromkeys(strips.names[k] for k in edges))


def _noted(error: float) -> float:
    """Give an error without the roundings of the construction's steps."""
    return error if error > ROUNDED else 0.0
