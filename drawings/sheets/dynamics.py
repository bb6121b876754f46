"""Sheet 3, motion of the machine: graphs, Wittenbauer's loop, flywheel, speeds, tables (динамика, лист 3)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, NamedTuple

from drawings.figures.dynamics import dynamics_table, flywheel_sketch, load_diagram, plate, plate_figure
from drawings.figures.dynamics.load_course import LoadCourse, courses
from drawings.figures.dynamics.plate import Plate
from drawings.layout.contents import Panel
from drawings.layout.footing import PAD
from drawings.layout.table import RuledTable
from drawings.layout.trials import room_of
from drawings.page.drafting import Drafting, drafting_of
from drawings.page.page import Page, page_of
from drawings.paper.strokes import Leaf
from drawings.report.dynamics_report import notes_of
from drawings.sheets.leaves import Caption, Draft, Exhibit, lay_out
from plans.model.account import Account
from plans.model.dynamics import Task
from plans.model.flywheel_methods import Methods
from plans.model.flywheel_rim import Wheel
from plans.scene.scene import Scene
from plans.study import Study


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of the motion of a scene's machine (row of the table of sheets)."""
    own, comparison = study["dynamics"], study.comparison("dynamics")
    loads = tuple(courses(own.statics.machine, own.statics.strokes))
    notes = notes_of(study)
    machine = Machine(
        own.task, comparison.construction, comparison.exact, comparison.methods, loads, notes.rim, notes.all
    )
    return sheets(study.scene, machine)


def sheets(scene: Scene, machine: Machine) -> tuple[Leaf, ...]:
    """Lay out the sheets of a machine whose motion is found."""
    return lay_out(scene, [_DynamicsSheet(scene, machine).draft])


class Machine(NamedTuple):
    """What is asked of a machine's motion, what the roads found of it, its loads, the flywheel's rim, what is said."""

    task: Task
    own: Account
    exact: Account
    methods: Methods | None = None
    loads: tuple[LoadCourse, ...] = ()
    rim: Wheel | None = None
    notes: tuple[str, ...] = ()


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
        title = self.drafting.word("dynamics sheet title")
        return Draft("dynamics", title, tuple(self._shows()), (), self.machine.notes, _facts)

    def _shows(self) -> Iterator[Exhibit | Caption]:
        """Show graphs and loop in line where the paper takes them so, or else apart."""
        whole = self._plate(plate.WHOLE, graphs=True, loop=True)
        if self._takes(whole):
            yield self._exhibit(whole)
            yield self._positions()
        else:
            yield self._exhibit(self._plate(plate.GRAPHS, graphs=True))
            yield self._positions()
            yield self._exhibit(self._plate(plate.ENERGY, loop=True))
        yield self._results()
        yield from self._beside()

    def _beside(self) -> Iterator[Exhibit]:
        """Show the loads over their strokes, and the flywheel where a rim of its diameter can be made."""
        for load in self.machine.loads:
            room = load_diagram.measure(load, self.drafting)
            yield Exhibit(Panel(room), partial(load_diagram.draw, load, room, drafting=self.drafting))
        rim = self.machine.rim
        if rim is not None and rim.fits:
            room = flywheel_sketch.measure(rim, self.drafting)
            yield Exhibit(Panel(room), partial(flywheel_sketch.draw, rim, room, drafting=self.drafting))

    def _positions(self) -> Caption:
        """Tell the values at the edges of the strips."""
        table = dynamics_table.positions(self.machine.task, self.machine.own, self.drafting)
        return self._caption(table)

    def _results(self) -> Caption:
        """Tell what both roads found."""
        machine = self.machine
        return self._caption(dynamics_table.results(machine.own, machine.exact, machine.methods, self.drafting))

    def _caption(self, table: RuledTable) -> Caption:
        return Caption(Panel(table.block(table.name)), partial(table.write, drafting=self.drafting))

    def _plate(self, name: str, graphs: bool = False, loop: bool = False) -> Plate:
        return Plate(name, self.machine.task, self.machine.own, graphs, loop, self.drafting)

    def _exhibit(self, shown: Plate) -> Exhibit:
        return Exhibit(Panel(plate.measure(shown)), partial(plate_figure.draw, shown))

    def _takes(self, shown: Plate) -> bool:
        """Tell whether the paper has room for a plate beside or over the title block, large enough to be read."""
        room, block, picture = room_of(self.page), self.page.block, plate.measure(shown)
        rooms = (room.width - block.width - PAD, room.height), (room.width, room.height - block.height - PAD)
        ladders = (picture.ladder(*size, self.page.standard) for size in rooms)
        return any(rung.extent >= picture.least for ladder in ladders for rung in ladder.rungs)


def _facts(names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which figures it shows."""
    return {"figures": list(names)}
