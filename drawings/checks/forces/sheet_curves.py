"""The self-check of the curves of one force sheet: what balances the drive, hodographs (кривые силового листа)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from drawings.checks.forces.balancing_graph import PLAN as BALANCING
from drawings.checks.forces.balancing_graph import ordinates
from drawings.checks.forces.curves_between import BESIDE, ForcesBetween
from drawings.checks.forces.force_curves import ReactionHodograph, TurnGraph
from drawings.checks.forces.laid_scheme import FINE
from drawings.checks.forces.polygon_chain import heads
from drawings.checks.graphs.figure_strokes import FigureStrokes, figure
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.forces.force_letters import force_letter
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.symbols.force_arrow import plain_name
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import indices
from plans.forces.primary import balancing_quantity
from plans.forces.statics import Statics
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Floats, Motion

TURN = 360.0  # degrees


@dataclass(frozen=True)
class SheetCurves:
    """One force sheet, and the forces by both roads; `slack` N is what these may differ by."""

    measured: Measured
    leaf: Leaf
    comparison: ForceComparison
    statics: Statics
    slack: float

    @property
    def position(self) -> int:
        """The position of the sheet."""
        return int(self.leaf.metadata["position"])

    def faults(self) -> Iterator[Wrong]:
        """Hold the ordinates of the balancing moment and the ends of hodographs over the positions."""
        told = self.comparison.analysis
        name, _, share = balancing_quantity(self.statics.study.mechanism.drive)
        strokes = self.statics.over(self.comparison.motion.road.extremes)
        sizes = told.counted(self.statics.given(told, self.comparison.motion.analysis, strokes))
        moments = {str(k): complex(0, value) for k, value in enumerate(sizes)}
        bounds = [told.counted(one.allowed) for one in self.comparison.of("forces") if one.name.startswith(name)]
        slack = 2 * float(max(map(np.nanmax, bounds))) + share * told.nothing[1]
        yield from self._held(BALANCING, moments, slack)
        yield from ordinates(self.measured, self.leaf, sizes, slack)
        yield from self._graph(sizes, slack)
        language, sheet = self.statics.study.scene.sheet.language, self.statics.form.sheet
        for key in sheet.hodographs:
            one = told.reactions[key]
            ends = {str(k): complex(value) for k, value in enumerate(one.force)}
            shown = force_letter(f"R_{indices(one.giver, one.taker)}", language, sheet.reactions)
            ends[plain_name(shown)] = complex(one.force[self.position])
            yield from self._held(f"hodograph-{key}", ends, self.slack)
            yield from self._hodograph(key, shown)

    @cached_property
    def _between(self) -> ForcesBetween:
        return ForcesBetween(self.statics, self.comparison)

    def _fewest(self, held: Callable[[ForcesBetween], Iterable[Wrong]]) -> list[Wrong]:
        """Hold a curve between the positions: one that is wrong is so at other angles too."""
        first = list(held(self._between))
        return min(first, list(held(replace(self._between, apart=BESIDE))), key=len) if first else first

    def _graph(self, sizes: Floats, slack: float) -> Iterator[Wrong]:
        """Hold the graph of what balances the drive, with the curve between its positions where it is over a turn."""
        study, group = self.statics.study, figure(self.leaf, BALANCING)
        if group is None:
            return
        drive, scales = study.mechanism.drive, written_scales(group.group)
        told = balancing_quantity(drive)
        symbol = force_letter(told.name, study.language).split("_")[0]
        none = np.zeros(0)
        turn = self._whole(group)
        quantity = force_letter(told.name, study.language), told.unit
        axis = ("φ", "°") if drive.turns else ("s", "m")

        def held(own: ForcesBetween) -> Iterator[Wrong]:
            dense = (own.turned, own.balancing) if turn else (none, none)
            return TurnGraph(
                group, self.leaf.metadata["scales"][BALANCING], scales.get(symbol, math.nan), axis, quantity,
                self._stations(group), sizes, *dense, slack, self.position,
                (study.language, study.scene.sheet.notation),
            ).faults()  # fmt: skip

        yield from self._fewest(held)

    def _stations(self, group: FigureStrokes) -> Floats:
        """Give the abscissas of the positions: of a swing from where it begins, which the first ordinate tells."""
        study, motion, mu = self.statics.study, self.comparison.motion.analysis, self.leaf.metadata["scales"][BALANCING]
        if not study.mechanism.drive.turns:
            return _ways(study.mechanism, motion)
        turned = np.degrees(study.sense * (motion.phi - motion.phi[0])) % 360.0
        if self._whole(group):
            return np.asarray(turned)
        one = next((one for one in self.measured.vectors if one.plan == BALANCING and one.position is not None), None)
        axis = next((one.start for one in group.pointings if abs((one.tip - one.start).imag) <= FINE), 0j)
        begin = (
            turned[one.position] - (one.start - axis).real * mu if one is not None and one.position is not None else 0.0
        )
        return np.asarray((turned - begin + FINE) % 360.0 - FINE)

    def _whole(self, group: FigureStrokes) -> bool:
        """Tell whether a graph is drawn over a whole turn: there its axis bears a tick."""
        axis = next((one.start for one in group.pointings if abs((one.tip - one.start).imag) <= FINE), None)
        if axis is None or not self.statics.study.mechanism.drive.turns:
            return False
        end = axis + TURN / self.leaf.metadata["scales"][BALANCING]
        return bool(group.through(end, 1j, FINE))

    def _hodograph(self, key: str, letter: str) -> Iterator[Wrong]:
        """Hold one hodograph, with its curve between the positions."""
        plan, one = f"hodograph-{key}", self.comparison.analysis.reactions[key]
        group = figure(self.leaf, plan)
        pole = next((mark for mark in self.measured.points if mark.plan == plan), None)
        if group is None or pole is None:
            return
        vectors = [mark for mark in self.measured.vectors if mark.plan == plan]
        yield from heads(group, vectors)
        at, turns = pole.at - pole.value / pole.scale, self.statics.study.mechanism.drive.turns

        def held(own: ForcesBetween) -> Iterator[Wrong]:
            between = own.found.reactions[key].force if turns else one.force
            return ReactionHodograph(
                plan, group, at, pole.scale, one.force, between, self.slack, self.position, letter
            ).faults()

        yield from self._fewest(held)

    def _held(self, plan: str, expected: Mapping[str, complex], slack: float) -> Iterator[Wrong]:
        told = [(one.plan, one.name, one.value, one.scale) for one in self.measured.vectors]
        told += [(one.plan, one.name, one.value, one.scale) for one in self.measured.points]
        for own, name, value, scale in told:
            allowed = slack + 2 * self.measured.quantum * scale
            if own == plan and name in expected and not abs(value - expected[name]) <= allowed:
                yield on("differs_on", plan, name=name)


def _ways(mechanism: Mechanism, motion: Motion) -> Floats:
    """Give how far a drive over a stroke has gone: a slider on the frame, a cylinder by the distance of its ends."""
    ram = mechanism.drive.ram
    if ram is None:
        way = motion.points[mechanism.drive.end].r
        return np.asarray(np.abs(way - way[0]))
    fixed = mechanism.links[FRAME].points
    foot = fixed[ram.foot] if ram.foot in fixed else motion.points[ram.foot].r
    length = np.abs(motion.points[ram.point].r - foot)
    return np.asarray(np.abs(length - length[0]))
