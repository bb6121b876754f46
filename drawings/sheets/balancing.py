"""Sheet 5, a mechanism balanced: schemes, static moments, hodographs, what it costs (уравновешивание, лист 5)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

from drawings.figures.balance import (
    balance_scheme,
    balance_table,
    moment_graph,
    shaking_hodograph,
    share_graph,
    static_polygon,
)
from drawings.figures.balance.scheme import AFTER, BEFORE, BalanceScheme, placed_weight
from drawings.figures.graphs import curve_graph
from drawings.figures.linkage.skeleton import Skeletons
from drawings.layout.contents import Panel
from drawings.layout.picture import Picture
from drawings.layout.table import RuledTable
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.leaves import Caption, Draft, Exhibit, lay_out
from drawings.symbols.polygon import ShownVector
from plans.model.balance.linkage import FORCE, Balance, State
from plans.model.kinetostatics import NOTHING
from plans.scene.scene import Scene

SCHEMES = "schemes"  # the schemes are drawn at one scale
TOLD = "told"  # what stands in one column: static moments and tables
FOREMOST = 1.5  # the schemes are larger than what belongs to them
LARGEST = 1.8  # times the least size at which it is legible: no polygon or graph is drawn larger than the schemes


@dataclass(frozen=True)
class Balanced:
    """What a balanced mechanism's sheets are drawn from: its links, main points by state, static moments, result."""

    bones: Skeletons
    chains: Mapping[str, tuple[ShownVector, ...]]
    moments: Mapping[str, complex]  # kg*m, by letters
    balance: Balance
    notes: tuple[str, ...]

    @property
    def states(self) -> dict[str, State]:
        """The states by their names."""
        found = {BEFORE: self.balance.before}
        return found if self.balance.after is None else found | {AFTER: self.balance.after}


def sheets(scene: Scene, shown: Balanced) -> tuple[Leaf, ...]:
    """Lay out the sheets of a mechanism whose balancing is found."""
    return lay_out(scene, [_BalancingSheet(scene, shown).draft])


@dataclass(frozen=True)
class _BalancingSheet:
    """What the sheets are drawn from."""

    scene: Scene
    shown: Balanced

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.scene)

    @property
    def balance(self) -> Balance:
        return self.shown.balance

    @property
    def draft(self) -> Draft:
        """Title, figures, tables and notes of the sheets."""
        title = self.drafting.word("balancing sheet title")
        shows: tuple[Exhibit | Caption, ...] = (
            *self._schemes(),
            *self._polygon(),
            *self._tables(),
            *self._shaking(),
            *self._rocking(),
            *self._shares(),
        )
        first = balance_scheme.measure(self._scheme(BEFORE), self.drafting).name
        return Draft("balancing", title, shows, (), self.shown.notes, _facts, first)

    def _schemes(self) -> Iterator[Exhibit]:
        for state in self.shown.states:
            shown = self._scheme(state)
            room = balance_scheme.measure(shown, self.drafting)
            draw = partial(balance_scheme.draw, shown, room, drafting=self.drafting)
            yield Exhibit(Panel(room, FOREMOST, scale=SCHEMES), draw)

    def _scheme(self, state: str) -> BalanceScheme:
        """Show the links before or after; what stands still has no path."""
        bones, states = self.shown.bones, self.shown.states
        kept = [name for name in (BEFORE, AFTER) if name in states and (name == BEFORE or state == AFTER)]
        paths = {name: states[name].around.r for name in kept if states[name].around.path > NOTHING * bones.reach}
        weights = [one for one in self.balance.counterweights if one.needed] if state == AFTER else []
        placed = tuple(placed_weight(one, bones) for one in weights)
        return BalanceScheme(state, bones, self.shown.chains[state], paths, placed)

    def _polygon(self) -> Iterator[Exhibit]:
        moments = self.shown.moments
        least = NOTHING * sum(map(abs, moments.values()))
        shown = static_polygon.polygon(self.shown.bones.shown, moments, least)
        yield self._exhibit(static_polygon, shown, TOLD)

    def _shaking(self) -> Iterator[Exhibit]:
        """Show the hodographs of the main vector, if there is any."""
        states = {name: (one.around, one.centre) for name, one in self.shown.states.items()}
        nothing = NOTHING * self.balance.before.shaking
        shown = shaking_hodograph.hodograph(states, self.shown.bones.shown, nothing)
        if shown.vectors:
            yield self._exhibit(shaking_hodograph, shown)

    def _rocking(self) -> Iterator[Exhibit]:
        """Show the main moment, if there is any."""
        sense = self.shown.bones.study.sense
        curve = moment_graph.curve(self.balance.before, self.balance.after, sense, self.drafting)
        if curve is not None:
            room = _bounded(curve_graph.measure(curve, moment_graph.NAME, self.drafting))
            yield Exhibit(Panel(room), partial(curve_graph.draw, curve, room, drafting=self.drafting))

    def _shares(self) -> Iterator[Exhibit]:
        """Show the choice of the share, where there is one."""
        shares, task = self.balance.shares, self.balance.task
        if shares is not None:
            best = shares.least_force if task.least == FORCE else shares.least_reaction
            taken = best.share if task.share is None else task.share
            letter = share_graph.reaction_letter(self.shown.bones.mechanism.drive.link, self.drafting)
            yield self._exhibit(share_graph, share_graph.ShareGraph(shares, taken, letter))

    def _exhibit(self, figure: Any, shown: Any, together: str = "") -> Exhibit:
        room = _bounded(figure.measure(shown, self.drafting))
        return Exhibit(Panel(room, together=together), partial(figure.draw, shown, room, drafting=self.drafting))

    def _tables(self) -> Iterator[Caption]:
        """Tell the counterweights, and what they change."""
        if self.balance.counterweights:
            yield self._caption(balance_table.counterweights(self.balance.counterweights, self.drafting))
        yield self._caption(balance_table.costs(self.balance, self.drafting, self.shown.bones.reach))

    def _caption(self, table: RuledTable) -> Caption:
        write: Callable[..., Any] = partial(table.write, drafting=self.drafting)
        return Caption(Panel(table.block(table.name), together=TOLD), write)


def _bounded(room: Picture) -> Picture:
    return room._replace(most=LARGEST * room.least)


def _facts(names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which figures it shows."""
    return {"figures": list(names)}
