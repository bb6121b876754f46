"""Sheet 3, the motion of a machine: graphs, loop, flywheel, run, table of results (динамика, лист 3)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Final, NamedTuple

import numpy as np

from drawings.dynamics import flywheel_sketch, plate, tachogram
from drawings.dynamics.due import expected
from drawings.dynamics.graphs import DrawnStrips, strips
from drawings.dynamics.plate import Plate, bare_speeds
from drawings.dynamics.plate_frame import PlateFrame, working
from drawings.dynamics.reduction import curves, turned
from drawings.dynamics.report import notes_of
from drawings.dynamics.report_tables import without_rounding
from drawings.forces import load_diagram
from drawings.forces.load_diagram import LoadCourse, courses
from drawings.forces.notes import given, loads_given
from drawings.kinds import curve_graph
from drawings.kinds.curve_graph import GraphCurve
from drawings.layout.contents import Panel
from drawings.layout.picture import SMALLER
from drawings.layout.room import room_of
from drawings.layout.slicing import GAP
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import fixed
from drawings.linkage.positions import of_linkage
from drawings.page.page import Drafting, Page, drafting_of, page_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import GRAPH, SheetKind
from drawings.sheets.leaves import EQUATION, lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, captions, exhibit, figures_facts
from plans.dynamics.numbers import SEGMENTS
from plans.dynamics.numbers import results as quantities
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.study import DynamicsStudy
from plans.forces.statics import Statics
from plans.model.dynamics import Cycle, Methods, Reduced, Speeds, Task, Wheel
from plans.model.motion import Floats
from plans.model.run import Account
from plans.quantity import Quantity
from plans.scene.scene import Scene
from plans.study import Study

RESULTS, POSITIONS = "results", "positions"
COLUMNS = ("by plan", "by analysis", "true error")  # strips and chords are out by what the exact curve is not
QUANTITIES = (
    ("Δφ", "°"), ("M_{{{}}}", "N*m"), ("A_{{{}}}", "J"), ("ΔT", "J"),
    ("ΔJ", "kg*m2"), ("ω", "rad/s"), ("ε", "rad/s2"),
)  # fmt: skip
REDUCED = (("Δφ", "°"), ("M_{red}", "N*m"), ("J_{red}", "kg*m2"), ("dJ/dφ", "kg*m2"))
MOST = 36  # positions that are told
DIGITS = 5
NOTHING = "—"


def positions(task: Task, account: Account, drafting: Drafting, most: int = MOST) -> RuledTable:
    """Tell the values at so many positions at most and at jumps, at these the moment before and behind.

    ε is that in the middle of the strip that begins there.
    """
    cycle = account.cycle
    assert cycle is not None  # else nothing is told of a turn
    named = strips(cycle, task.divisions)
    chosen = named.numbered(named.every(task.divisions / most))
    columns = _columns(cycle, account.speeds)
    lines = [row for k in chosen for row in _edge(named, columns, k, drafting)]
    told = QUANTITIES[: len(columns.rows)]
    heads = tuple(f"{drafting.letter(letter.format(cycle.indices[0]))}, {drafting.word(unit)}" for letter, unit in told)
    return table(lines, "i", heads, drafting.hand.text)._replace(name=POSITIONS)


def reduction(reduced: Reduced, turned: Floats, drafting: Drafting) -> RuledTable:
    """Tell the reduced moment and inertia at the positions, turned by degrees, where there is no steady turn."""
    heads = tuple(f"{drafting.letter(letter)}, {drafting.word(unit)}" for letter, unit in REDUCED)
    rows = zip(
        *(_even(without_rounding(row)) for row in (turned, reduced.moment, reduced.inertia, reduced.slope)), strict=True
    )
    lines = [TableRow(str(k), tuple(_cell(value, drafting) for value in row)) for k, row in enumerate(rows)]
    return table(lines, "i", heads, drafting.hand.text)._replace(name=POSITIONS)


class _Columns(NamedTuple):
    """What the table tells at the edges, in its order, and the moment before each."""

    rows: Floats  # (7, n + 1), or (5, n + 1) where no speed is asked for
    before: Floats  # likewise: the moment and the acceleration alone


def _columns(cycle: Cycle, speeds: Speeds | None) -> _Columns:
    nothing, angles = np.full(len(cycle.turned), np.nan), np.degrees(cycle.turned)
    after, before = np.append(cycle.moments[:, 0], cycle.moments[-1, 1]), np.append(np.nan, cycle.moments[:, 1])
    rows = [angles, cycle.way * after, cycle.way * cycle.work, cycle.surplus, cycle.varying]
    sides = [angles, cycle.way * before, nothing, nothing, nothing]
    if speeds is not None:
        rows += [speeds.omega, np.append(speeds.epsilon[:, 0], speeds.epsilon[-1, 1])]
        sides += [nothing, np.append(np.nan, speeds.epsilon[:, 1])]
    both = np.concatenate([rows, sides], axis=1)
    evened = np.array([_even(without_rounding(row)) for row in both])
    return _Columns(*np.split(evened, 2, axis=1))


def _even(row: Floats) -> Floats:
    """Round a column to the digits of its largest value: no cell is told finer than another, nor is wider."""
    largest = float(np.nanmax(np.abs(row), initial=0.0))
    return np.round(row, DIGITS - 1 - math.floor(math.log10(largest))) if largest else row


def _edge(named: DrawnStrips, columns: _Columns, k: int, drafting: Drafting) -> Iterator[TableRow]:
    """Give the row of an edge, two of one at which a load jumps."""
    name, jumps = named.names[k], k in named.jumps
    after = columns.rows[:, k].tolist()
    if jumps:
        before = columns.before[:, k].tolist()
        yield TableRow(f"{name}−0", tuple(_cell(value, drafting) for value in before))
    yield TableRow(f"{name}+0" if jumps else name, tuple(_cell(value, drafting) for value in after))


def _cell(value: float, drafting: Drafting) -> str:
    return NOTHING if not np.isfinite(value) else drafting.number(float(value) + 0.0, DIGITS)


def results(drawn: Account, exact: Account, methods: Methods | None, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, and by how much the strips are out; then the inertia by other methods."""
    lines = [_compared(quantity, drafting) for quantity in quantities(drawn, exact)]
    lines += _others(exact, methods, drafting)
    heads = tuple(drafting.word(head) for head in COLUMNS)
    foot = tuple(drafting.word("error base").split("\n")) if drawn.flywheel is not None else ()
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text, foot=foot)._replace(name=RESULTS)


def _compared(quantity: Quantity, drafting: Drafting) -> TableRow:
    letter = drafting.true(quantity.name, "T") if quantity.name in SEGMENTS else quantity.name
    named = drafting.letter(letter) + (f", {drafting.word(quantity.unit)}" if quantity.unit else "")
    drawn, exact = float(quantity.construction[0]), float(quantity.analysis[0])
    numbers = (drafting.number(value, DIGITS + 1) for value in (drawn, exact))
    return TableRow(named, (*numbers, _share(drawn, exact, quantity.largest, drafting)))


def _share(drawn: float, exact: float, whole: float, drafting: Drafting) -> str:
    """Write a difference in per cent of the exact value, or of what it is a part of."""
    return fixed(100 * (drawn - exact) / whole, drafting.language, 3) if whole else NOTHING


def _others(exact: Account, methods: Methods | None, drafting: Drafting) -> Sequence[TableRow]:
    """Give the rows of other methods, each with its difference from the exact value."""
    if methods is None or exact.flywheel is None:
        return ()
    named = {"by Mertsalov": methods.mertsalov, "by Gutyar": methods.gutyar, "without δ²": methods.book}
    whole = exact.flywheel.whole
    cells = (
        (key, ("", drafting.number(value, DIGITS + 1), _share(value, whole, abs(whole), drafting)))
        for key, value in named.items()
    )
    return tuple(TableRow(f"J_0 {drafting.word(key)}", row) for key, row in cells)


TOLD = (MOST, 12, 8)  # positions that the table of values tells at most, as the paper takes them
SIZES = 2  # of graphs and loop in line that are tried: the largest, and the next where all then takes fewer sheets
LARGEST = 2.0  # times the least size at which it is legible: a load is not drawn larger than the graphs


class MachineMotion(NamedTuple):
    """What is asked of a machine's motion, and what was found of it: by construction, exactly, by other methods."""

    task: Task
    drawn: Account
    exact: Account
    methods: Methods | None = None
    loads: tuple[LoadCourse, ...] = ()
    rim: Wheel | None = None
    notes: tuple[str, ...] = ()
    falling: bool = False  # whether the moment of its motor falls with the speed
    turned: Floats = np.zeros(0)  # degrees, of the positions of the reduction alone
    reduced: tuple[GraphCurve, ...] = ()  # its graphs


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of the motion of a scene's machine."""
    found, statics, said = study.of(DynamicsComparison), study.of(Statics), notes_of(study)
    made, drafting = study.of(DynamicsStudy), drafting_of(study.scene)
    alone = found.construction.cycle is None
    level = () if alone else courses(*statics.level())
    loads = (*courses(statics.machine, statics.strokes), *level)
    links = () if "forces" in study.techniques else given(statics, drafting.language)
    notes = (*links, *loads_given(statics.machine.loads, statics, drafting.language), *said.all)
    machine = MachineMotion(said.task, found.construction, found.exact, found.methods, loads, said.rim, notes)
    if alone:
        reduced = tuple(curves(made.reduction, drafting))
        return sheets(study.scene, machine._replace(turned=turned(made.reduction), reduced=reduced))
    return sheets(study.scene, machine._replace(falling=made.motor is not None and made.motor.steepness > 0))


def sheets(scene: Scene, machine: MachineMotion) -> tuple[Leaf, ...]:
    """Lay out the sheets of a machine whose motion is found."""
    return lay_out(scene, [_DynamicsSheet(scene, machine).draft])


@dataclass(frozen=True)
class _DynamicsSheet:
    """What the sheets are drawn from."""

    scene: Scene
    machine: MachineMotion
    smaller: int = 0  # steps by which graphs and loop in line are smaller than the largest

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.scene)

    @cached_property
    def page(self) -> Page:
        return page_of(self.scene)

    @property
    def draft(self) -> Draft:
        """The draft of the largest graphs that tells most positions, and those that need less room."""
        sizes = [replace(self, smaller=k) for k in range(SIZES)]
        drawn = [size for size in sizes if size._in_line or not size.smaller]
        first, *further = (size._drafted(most) for size in drawn for most in TOLD)
        return first._replace(instead=tuple(further))

    @cached_property
    def _in_line(self) -> bool:
        """Whether graphs and loop stand in line on one plate: wherever the paper takes that."""
        return self.machine.drawn.cycle is not None and self._least is not None

    def _drafted(self, most: int) -> Draft:
        title, facts = self.drafting.word("dynamics sheet title"), partial(figures_facts, positions=most)
        shows, narrow = tuple(self._shows(most)), EQUATION if self.machine.drawn.cycle else 0.0
        return Draft("dynamics", title, shows, (), self.machine.notes, facts, narrow=narrow)

    def _shows(self, most: int) -> Iterator[Exhibit | Caption]:
        """Show the graphs with what they rest on, the loop, what follows from both."""
        plates = tuple(self._plates())
        exhibits = [self._exhibit(shown, self._least if self._in_line else None) for shown in plates]
        yield from exhibits[:1]
        yield from (exhibit(curve_graph, curve, self.drafting) for curve in self.machine.reduced)
        yield from (exhibit(load_diagram, course, self.drafting, LARGEST) for course in self.machine.loads)
        yield from exhibits[1:]
        if self.machine.drawn.cycle is not None and not (self._in_line and self._whole.told):
            yield self._caption(self._results())
        yield self._caption(self._values(most))
        yield from self._wheel()
        yield from self._bare()
        yield from self._run()
        yield from captions(map(working, plates))

    def _plates(self) -> Iterator[Plate]:
        """Give the plates: none of a machine whose crank cannot turn fully."""
        if self.machine.drawn.cycle is None:
            return
        if self._in_line:
            yield self._whole
        else:
            yield self._plate(plate.UPPER, plate.INTEGRATED)
            yield self._plate(plate.LOWER, plate.ROUND_LOOP, loop=True)

    @cached_property
    def _whole(self) -> Plate:
        """Graphs and loop in line, the results under the loop if they have room there."""
        bare = self._plate(plate.WHOLE, plate.OVER_TURN, loop=True)
        largest = self._largest(bare)
        return bare if largest is None else replace(bare, told=plate.set_table(self._results(), bare, largest))

    @cached_property
    def _least(self) -> float | None:
        """The size mm at which graphs and loop in line stand clear of the title block; None: not legible."""
        return self._largest(self._whole)

    def _largest(self, shown: Plate) -> float | None:
        room, picture, block = room_of(self.page), plate.measure(shown), self.page.block
        beside, above = (room.width - block.width - GAP, room.height), (room.width, room.height - block.height - GAP)
        rungs = (rung for free in (beside, above) for rung in picture.rungs(*free, self.page.standard))
        sizes = sorted({rung.extent for rung in rungs if rung.extent >= picture.least}, reverse=True)
        return sizes[self.smaller] if self.smaller < len(sizes) else None

    def _wheel(self) -> Iterator[Exhibit]:
        """Show the flywheel, if there is one whose sizes are known."""
        rim = self.machine.rim
        if rim is not None and rim.fits:
            yield exhibit(flywheel_sketch, rim, self.drafting)

    def _bare(self) -> Iterator[Exhibit]:
        """Show the speeds without the flywheel, where they swing too far to stand among the others."""
        machine = self.machine
        curve = bare_speeds(machine.task, machine.drawn, self.drafting, machine.falling)
        if curve is not None:
            yield exhibit(curve_graph, curve, self.drafting, LARGEST)

    def _run(self) -> Iterator[Exhibit]:
        """Show the run from rest to rest, where there is a motor."""
        run = self.machine.drawn.run
        if run is not None and len(run.t) > 1:
            yield exhibit(tachogram, run, self.drafting)

    def _values(self, most: int) -> RuledTable:
        """Tell the values at the edges of the strips, or of the reduction alone at the positions."""
        account = self.machine.drawn
        if account.cycle is None:
            return reduction(account.reduced, self.machine.turned, self.drafting)
        return positions(self.machine.task, account, self.drafting, most)

    def _results(self) -> RuledTable:
        """Tell what both roads found."""
        machine = self.machine
        return results(machine.drawn, machine.exact, machine.methods, self.drafting)

    def _caption(self, table: RuledTable) -> Caption:
        return Caption(Panel(table.block(table.name)), partial(table.write, drafting=self.drafting))

    def _plate(self, name: str, graphs: tuple[str, ...], loop: bool = False) -> Plate:
        return Plate(name, self.machine.task, self.machine.drawn, graphs, loop, self.drafting)

    def _exhibit(self, shown: Plate, least: float | None = None) -> Exhibit:
        room = plate.measure(shown)
        room = room if least is None else room._replace(least=least * SMALLER)
        return Exhibit(Panel(room), lambda spot: PlateFrame(shown, spot).figure)


SCALES: Final = {"flywheel_sketch": "wheel", "load_diagram-": "way"}
GRAPHS = ("moments", "works", "surplus", "speeds", "inertia", "loop", "before", "tachogram", "load_diagram-")
FORM: Final = dict.fromkeys(GRAPHS, GRAPH)
TABLES = ("positions", "reduction", "results")
SHEETS: Final = {"dynamics": SheetKind(leaves, expected, SCALES, of_linkage, figures=FORM, tables=TABLES)}
