"""The frame of the kinematic diagrams: rows one under another over the crank angle, the scale of time (разметка)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from drawings.figures.diagrams.rows import DiagramRow, rows_of
from drawings.figures.graphs.row_frame import LONG, Proportions, RowFrame, RowPlate
from drawings.layout.picture import Margins, Picture, Spot
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Axis

NAME = "diagrams"
# Twelve coarser scales differ by five hundred times and more.
PROPORTIONS = Proportions(high=0.9, left=10.4, right=1.8, pole=(2.8, 8.0), coarser=12, rises=False)
# Graphs of a part of a turn, all three as high as one another, want a pole half the axis away: what goes forth alone
# has a course three times as long for its speed as what comes back too.
FORTH = PROPORTIONS._replace(left=22.4, pole=(2.8, 20.0))
TALLER = 2.2  # times the height that the rows may have where there is room


@dataclass(frozen=True)
class DiagramsPlate(RowPlate[DiagramRow]):
    """Diagrams to be drafted: their rows and the paper about them."""

    own: DiagramsStudy
    drafting: Drafting

    @property
    def proportions(self) -> Proportions:
        """How the figure is laid out."""
        return PROPORTIONS if self.axis.closed else FORTH

    @property
    def axis(self) -> Axis:
        """The axis of all rows."""
        return self.own.axis

    @property
    def omega(self) -> float:
        """How fast the crank turns, rad/s."""
        return self.own.course.omega

    @cached_property
    def rows(self) -> tuple[DiagramRow, ...]:
        """The rows from the top."""
        return rows_of(self.own)

    @property
    def length(self) -> float:
        """How far the axis goes, rad."""
        return float(self.axis.turned[-1])

    @staticmethod
    def named(key: str) -> str:
        """Name a part of the figure."""
        return f"{NAME}-{key}"

    @property
    def above(self) -> float:
        """Paper over the first row, mm: the heading of the figure."""
        return 3 * self.hand.title

    def room(self, heading: float) -> Picture:
        """Give the room of the figure; its scale is that of the crank angle."""
        high = self.length * self.proportions.high
        margins = Margins(self.beside, 0.0, self.top)
        middle, least = complex(self.length, high) / 2, LONG * self.hand.letter
        return Picture(NAME, self.length, high, middle, "φ", "rad", margins, heading, least, taller=TALLER)


@dataclass(frozen=True)
class DiagramsFrame(RowFrame[DiagramRow]):
    """The diagrams at their scale: the fields of their rows, their axes, their pole distances."""

    plate: DiagramsPlate
    spot: Spot

    @property
    def argument(self) -> Scale:
        """The scale of time along the axis of the crank angle."""
        return Scale(self.spot.scale.mu / self.plate.omega, "t", "s")
