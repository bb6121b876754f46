"""Sheet 3, motion of the machine: graphs, Wittenbauer's loop, flywheel, speeds, tables (динамика, лист 3)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, NamedTuple

from drawings.figures.dynamics import (
    dynamics_table,
    flywheel_sketch,
    load_diagram,
    plate,
    plate_figure,
    quantities,
    tachogram,
)
from drawings.figures.dynamics.load_course import LoadCourse, courses
from drawings.figures.dynamics.plate import Content, bare_speeds
from drawings.figures.graphs import curve_graph
from drawings.figures.workings import loop_working
from drawings.layout.contents import Panel
from drawings.layout.picture import SMALLER
from drawings.layout.room import room_of
from drawings.layout.slicing import GAP
from drawings.layout.table import RuledTable
from drawings.page.drafting import Drafting, drafting_of
from drawings.page.page import Page, page_of
from drawings.paper.strokes import Leaf
from drawings.report.dynamics_report import notes_of
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, captions
from plans.model.account import Account
from plans.model.dynamics import Task
from plans.model.flywheel_methods import Methods
from plans.model.flywheel_rim import Wheel
from plans.scene.scene import Scene
from plans.study import Study

TOLD = (dynamics_table.MOST, 12, 8)  # positions that the table of values tells at most, as the paper takes them
LARGEST = 2.0  # times the least size at which it is legible: a load is not drawn larger than the graphs


class Machine(NamedTuple):
    """What is asked of a machine's motion, and what was found of it: by construction, exactly, by other methods."""

    task: Task
    own: Account
    exact: Account
    methods: Methods | None = None
    loads: tuple[LoadCourse, ...] = ()
    rim: Wheel | None = None
    notes: tuple[str, ...] = ()


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of the motion of a scene's machine (row of the table of sheets)."""
    found, statics, said = study.comparison("dynamics"), study["forces"], notes_of(study)
    loads = tuple(courses(statics.machine, statics.strokes))
    own = Machine(said.task, found.construction, found.exact, found.methods, loads, said.rim, said.all)
    return sheets(study.scene, own)


def sheets(scene: Scene, machine: Machine) -> tuple[Leaf, ...]:
    """Lay out the sheets of a machine whose motion is found."""
    return lay_out(scene, [_DynamicsSheet(scene, machine).draft])


class Way(NamedTuple):
    """A way to show it: graphs and loop in line or not, how many positions the table tells at most, how many plates."""

    whole: bool
    most: int
    apart: bool = False  # whether the graphs stand on two plates

    @property
    def plates(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """The plates of the graphs, each with what it shows."""
        if self.apart:
            return (plate.UPPER, plate.OVER_TURN[:2]), (plate.LOWER, plate.OVER_TURN[2:])
        return ((plate.GRAPHS, plate.OVER_TURN),)


@dataclass(frozen=True)
class _DynamicsSheet:
    """What the sheets are drawn from."""

    scene: Scene
    machine: Machine

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.scene)

    @cached_property
    def page(self) -> Page:
        return page_of(self.scene)

    @property
    def draft(self) -> Draft:
        """The draft that tells most, and those that need less room."""
        first, *further = (self._drafted(way) for way in self._ways())
        return first._replace(instead=tuple(further))

    def _ways(self) -> tuple[Way, ...]:
        """List the ways: in line wherever the paper takes that."""
        whole = self.machine.own.cycle is not None and self._least is not None
        ways = tuple(Way(whole, most) for most in TOLD)
        return ways if whole else (*ways, Way(False, TOLD[-1], True))

    def _drafted(self, way: Way) -> Draft:
        title, shows = self.drafting.word("dynamics sheet title"), tuple(self._shows(way))
        return Draft("dynamics", title, shows, (), self.machine.notes, partial(_facts, way.most))

    def _shows(self, way: Way) -> Iterator[Exhibit | Caption]:
        """Show the graphs with what they rest on, the loop, what follows from both."""
        plates = tuple(self._plates(way))
        yield from plates[:1]
        yield from self._loads()
        yield self._caption(self._values(way.most))
        yield from plates[1:]
        if self.machine.own.cycle is not None and not (way.whole and self._whole.told):
            yield self._caption(self._results())
        yield from self._wheel()
        yield from self._bare()
        yield from self._run()
        yield from captions(loop_working.working(one, self.drafting) for one in self._contents(way))

    def _contents(self, way: Way) -> Iterator[Content]:
        """Give what stands on the plates: on none of a machine whose crank cannot turn fully."""
        if self.machine.own.cycle is None:
            return
        if way.whole:
            yield self._whole
            return
        yield from (self._plate(name, graphs) for name, graphs in way.plates)
        yield self._plate(plate.ENERGY, (), loop=True)

    def _plates(self, way: Way) -> Iterator[Exhibit]:
        """Give the plates."""
        yield from (self._exhibit(one, self._least if way.whole else None) for one in self._contents(way))

    @cached_property
    def _whole(self) -> Content:
        """Graphs and loop in line, the results under the loop if they have room there."""
        bare = self._plate(plate.WHOLE, plate.OVER_TURN, loop=True)
        largest = self._largest(bare)
        return (
            bare
            if largest is None
            else replace(bare, told=plate.told(self._results(), plate.plate_of(bare, self.drafting), largest))
        )

    @cached_property
    def _least(self) -> float | None:
        """The size mm of graphs and loop in line as large as they stand beside the title block; None: not legible."""
        return self._largest(self._whole)

    def _largest(self, shown: Content) -> float | None:
        room, picture = room_of(self.page), plate_figure.measure(shown, self.drafting)
        width = room.width - self.page.block.width - GAP
        extents = [rung.extent for rung in picture.ladder(width, room.height, self.page.standard).rungs]
        return extents[0] if extents and extents[0] >= picture.least else None

    def _loads(self) -> Iterator[Exhibit]:
        """Show each load that changes over a stroke."""
        for course in self.machine.loads:
            room = load_diagram.measure(course, self.drafting)
            room = room._replace(most=LARGEST * room.least)
            draw = partial(load_diagram.draw, course, room, drafting=self.drafting)
            yield Exhibit(Panel(room), draw)

    def _wheel(self) -> Iterator[Exhibit]:
        """Show the flywheel, if there is one whose sizes are known."""
        rim = self.machine.rim
        if rim is not None and rim.fits:
            room = flywheel_sketch.measure(rim, self.drafting)
            draw = partial(flywheel_sketch.draw, rim, room, drafting=self.drafting)
            yield Exhibit(Panel(room), draw)

    def _bare(self) -> Iterator[Exhibit]:
        """Show the speeds without the flywheel, where they swing too far to stand among the others."""
        machine = self.machine
        curve = bare_speeds(machine.task, machine.own, self.drafting)
        if curve is not None:
            room = curve_graph.measure(curve, quantities.BEFORE, self.drafting)
            room = room._replace(most=LARGEST * room.least)
            draw = partial(curve_graph.draw, curve, room, drafting=self.drafting)
            yield Exhibit(Panel(room), draw)

    def _run(self) -> Iterator[Exhibit]:
        """Show the run from rest to rest, where there is a motor."""
        run = self.machine.own.run
        if run is not None and len(run.t) > 1:
            room = tachogram.measure(run, self.drafting)
            draw = partial(tachogram.draw, run, room, drafting=self.drafting)
            yield Exhibit(Panel(room), draw)

    def _values(self, most: int) -> RuledTable:
        """Tell the values at the edges of the strips, or of the reduction alone at the positions."""
        own = self.machine.own
        if own.cycle is None:
            return dynamics_table.reduction(own.reduced, self.drafting)
        return dynamics_table.positions(self.machine.task, own, self.drafting, most)

    def _results(self) -> RuledTable:
        """Tell what both roads found."""
        machine = self.machine
        return dynamics_table.results(machine.own, machine.exact, machine.methods, self.drafting)

    def _caption(self, table: RuledTable) -> Caption:
        return Caption(Panel(table.block(table.name)), partial(table.write, drafting=self.drafting))

    def _plate(self, name: str, graphs: tuple[str, ...], loop: bool = False) -> Content:
        return Content(name, self.machine.task, self.machine.own, graphs, loop)

    def _exhibit(self, shown: Content, least: float | None = None) -> Exhibit:
        room = plate_figure.measure(shown, self.drafting)
        room = room if least is None else room._replace(least=least * SMALLER)
        return Exhibit(Panel(room), partial(plate_figure.draw, shown, drafting=self.drafting))


def _facts(most: int, names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which figures it shows, and how many positions its table tells at most."""
    return {"figures": list(names), "positions": most}
