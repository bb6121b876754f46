"""The frame of a law's diagrams: rows one under another over the cam's turn, their pole distances (разметка)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import ClassVar

from drawings.figures.cam.law_rows import LawRow, rows
from drawings.figures.graphs.row_frame import LONG, Proportions, RowFrame, RowPlate
from drawings.layout.picture import Margins, Picture, Spot
from drawings.page.drafting import Drafting
from drawings.report.cam_letters import letters
from plans.cam.diagrams import LawDiagrams
from plans.model.cam import Cam

NAME = "law"
# Four coarser scales differ by ten times.
PROPORTIONS = Proportions(high=0.78, left=8.6, right=1.8, pole=(2.8, 6.2), coarser=4, rises=True)
TALLER = 1.6  # times the height that the rows may have where there is room
LEVEL = 3.4  # sizes of a number from the lowest row to the dimensions of the phases
BELOW = 2.0  # and from these to the end


def name_of(cam: Cam) -> str:
    """Give the name of the figure of a cam's law."""
    return f"{NAME}-{cam.name}"


@dataclass(frozen=True)
class LawPlate(RowPlate[LawRow]):
    """Diagrams of a law to be drafted: their rows and the paper about them."""

    shown: LawDiagrams
    drafting: Drafting
    proportions: ClassVar[Proportions] = PROPORTIONS

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.shown.strips.course.cam

    @cached_property
    def rows(self) -> tuple[LawRow, ...]:
        """The rows from the top."""
        return rows(self.shown)

    @property
    def length(self) -> float:
        """How far the cam turns, rad, or travels, m."""
        return self.cam.turn

    def named(self, key: str) -> str:
        """Name a part of the figure."""
        return f"{name_of(self.cam)}-{key}"

    @property
    def below(self) -> float:
        """Paper under the last row, mm: the dimensions of the phases."""
        return (LEVEL + BELOW) * self.hand.number

    def room(self, heading: float) -> Picture:
        """Give the room of the figure; its scale is that of the cam's turn."""
        high = self.length * self.proportions.high
        margins = Margins(self.beside, self.below, self.top)
        letter, unit = letters(self.cam)[1], "m" if self.cam.translates else "rad"
        middle, least = complex(self.length, high) / 2, LONG * self.hand.letter
        room = Picture(name_of(self.cam), self.length, high, middle, letter, unit, margins, heading, least)
        return room._replace(open=False, taller=TALLER)


@dataclass(frozen=True)
class LawFrame(RowFrame[LawRow]):
    """The diagrams at their scale: the fields of their rows, their axes."""

    plate: LawPlate
    spot: Spot

    def pole(self, row: LawRow) -> float | None:
        """Give the distance, mm, of the pole from which the row under this one is drawn; None: there is none."""
        own = self.plate.rows
        below = next((other for one, other in pairwise(own) if one.key == row.key), None)
        return None if below is None else self.distance(below)
