"""The plate of the graphs: one under another over one angle, beside them the loop in line with them (диаграммы).

Moments, works, surplus energy and speeds share the axis of angles; the loop stands beside the surplus energy in its
scale, and under the inertia, turned by 90 degrees, in that one's.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.dynamics import graphs as quantities
from drawings.dynamics import loop as equations
from drawings.dynamics.graphs import Dense, DrawnStrips, dense, strips
from drawings.dynamics.loop import TAIL, ShownLoop
from drawings.kinds.axes import BEYOND, wide
from drawings.kinds.curve_graph import GraphCurve
from drawings.layout.picture import Margins, Picture
from drawings.layout.table import RuledTable, Setting
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from plans.model.dynamics import TURN, Cycle, Task
from plans.model.run import Account

NUMBERED = 36  # positions: of more the curve alone is drawn


def bare_speeds(task: Task, account: Account, drafting: Drafting, level: bool = False) -> GraphCurve | None:
    """Give the curve of the speeds without the flywheel; None where there is none, or it stands beside the others.

    `level` says below its title that the moment of the drive is constant, as that of the motor is not.
    """
    cycle, before, after = account.cycle, account.before, account.speeds
    if cycle is None or before is None:
        return None
    if after is not None and (after.inertia == before.inertia or quantities.beside(after, before)):
        return None
    shown = dense(cycle)
    steps = strips(cycle, task.divisions).steps[:-1]
    numbered = np.flatnonzero(~np.isnan(steps) & (task.divisions <= NUMBERED))
    omega = quantities.omega(cycle, shown, before)
    stations, ordinates = np.degrees(cycle.turned[numbered]), before.omega[numbered]
    course, title = (np.degrees(shown.turned), omega, stations, ordinates), drafting.word("speed without flywheel")
    under = (f"{drafting.letter(f'M_{{{cycle.indices[1]}}}')} = const",) if level else ()
    curve = GraphCurve("ω_0", "rad/s", *course, title, task.divisions, name=quantities.BEFORE, states="ω_0")
    return curve._replace(under=under)


MOMENTS, WORKS, SURPLUS, SPEEDS = 0.30, 0.40, 0.76, 0.36  # heights of the rows, in lengths of the axis of angles
INERTIA, LOWEST = 0.5, 0.62  # likewise, of the inertia over a loop and of the surplus energy, on the lower plate
WIDE = 0.86  # width of the loop, likewise
LONG = 24.0  # sizes of a letter that the axis of angles has at least: its positions are numbered
LEFT, MIDDLE, RIGHT = 8.8, 8.0, 5.4  # paper beside the graphs, between them and the loop, beside it, likewise
GRAPHED = "reduced moments", "works", "surplus energy"  # titles
TITLE = 4.5  # sizes of a letter from the axis of the loop to its title at least: the axis has a letter itself
TALLER = 1.5  # times as high as that its rows may be where there is room
WHOLE, UPPER, LOWER = "machine", "moments-works", "energy-speeds"  # names of the plates: of all, or of two
OVER_TURN = (quantities.MOMENTS, quantities.WORKS, quantities.SURPLUS, quantities.SPEEDS)
INTEGRATED, ROUND_LOOP = OVER_TURN[:2], (quantities.SPEEDS, quantities.SURPLUS)  # what two plates show


class PlateRow(NamedTuple):
    """A row of a plate: what it shows, and its height in lengths of the axis of angles."""

    name: str
    high: float


class SetTable(NamedTuple):
    """A table that stands under the loop, and how it is set."""

    table: RuledTable
    setting: Setting

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        return self.table.size(self.setting)


@dataclass(frozen=True)
class Plate:
    """A plate to be drafted: graphs, or graphs and the loop in line with the surplus energy; what is told under it."""

    name: str
    task: Task
    account: Account
    graphs: tuple[str, ...]  # by their quantities, from the top
    loop: bool
    drafting: Drafting
    told: SetTable | None = None

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand

    @property
    def cycle(self) -> Cycle:
        """The account of the steady turn."""
        assert self.account.cycle is not None  # without one there is nothing to draw over the turn
        return self.account.cycle

    @cached_property
    def dense(self) -> Dense:
        """The turn followed densely."""
        return dense(self.cycle)

    @cached_property
    def strips(self) -> DrawnStrips:
        """The strips of the turn."""
        return strips(self.cycle, self.task.divisions)

    @cached_property
    def shown(self) -> ShownLoop:
        """The loop."""
        return ShownLoop(self.cycle, self.dense, self.strips, self.account.flywheel)

    @property
    def rows(self) -> tuple[PlateRow, ...]:
        """The rows from the top."""
        heights = dict(zip(OVER_TURN, (MOMENTS, WORKS, SURPLUS, SPEEDS), strict=True))
        shown = [name for name in self.graphs if name != quantities.SPEEDS or self.account.speeds]
        if self.graphs != ROUND_LOOP:
            return tuple(PlateRow(name, heights[name]) for name in shown)
        over = shown[0] if len(shown) > 1 else quantities.INERTIA
        return PlateRow(over, INERTIA), PlateRow(quantities.SURPLUS, LOWEST)

    @property
    def over(self) -> float:
        """Paper over the lines of a row, mm: the end of an axis, its title."""
        return BEYOND + self.hand.title + 0.4 * self.hand.letter

    @property
    def under(self) -> float:
        """Paper under the lines of a row, mm: numbers."""
        return 2 * self.hand.number

    @property
    def below(self) -> float:
        """Paper under the last row, mm: for what is told under the loop, where it does not stand beside a row."""
        return 0.0 if self.rows[-1].name == quantities.SPEEDS else self.telling

    @property
    def telling(self) -> float:
        """The height of what is told under the loop, mm: its equations, the results."""
        written = equations.height(self.drafting) if self.loop and self.account.flywheel else 0.0
        return written + (self.told.size[1] + self.under if self.told else 0.0)

    @property
    def beside(self) -> tuple[float, float, float]:
        """Paper on the left of the graphs, between them and the loop, on its right, mm."""
        size = self.hand.letter
        middle = BEYOND + (2 + MIDDLE if self.loop else 2) * size
        return LEFT * size, middle, RIGHT * size + BEYOND if self.loop else 0.0

    @property
    def wide(self) -> float:
        """Width without the paper beside, in lengths of the axis of angles."""
        return 1.0 + (WIDE if self.loop else 0.0)

    @property
    def high(self) -> float:
        """Height without the paper between, likewise."""
        return sum(row.high for row in self.rows)


def set_table(table: RuledTable, shown: Plate, extent: float) -> SetTable | None:
    """Set a table to stand under the loop of a plate drawn so large, mm; None where it is too wide or too high."""
    length = extent / max(shown.wide, shown.high)
    ways = [SetTable(table, setting) for setting in table.settings()]
    tail = TAIL * shown.hand.letter
    width, height = WIDE * length + shown.beside[2] + tail, shown.over + SPEEDS * length + 2 * shown.under
    fitting = (way for way in ways if way.size[0] <= width and replace(shown, told=way).telling <= height)
    return min(fitting, key=lambda way: way.setting.parts, default=None)


def measure(plate: Plate) -> Picture:
    """Give the room of a plate; its scale is that of the angle, to which all its sizes go."""
    wide, high = TURN * plate.wide, TURN * plate.high
    between = len(plate.rows) * (plate.over + plate.under)
    margins = Margins(sum(plate.beside) / 2, plate.below, between)
    least = max(LONG * plate.hand.letter, longest(plate)) * max(plate.wide, plate.high)
    room = Picture(plate.name, wide, high, complex(wide, high) / 2, "φ", "rad", margins, 0.0, least, open=False)
    return room._replace(taller=TALLER)


def longest(plate: Plate) -> float:
    """Give the length of the axis of angles beside whose end the captions of the graphs have room, mm."""
    drafting = plate.drafting
    scales = drafting.scale(Scale(0.0025, "J", "kg*m2"), Scale(0.025, "φ", "rad"))
    longest = max(wide(drafting.word(title), scales, plate.hand) for title in GRAPHED)
    return longest - (plate.beside[1] if plate.loop else BEYOND + 2 * plate.hand.letter)
