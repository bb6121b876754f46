"""The study of an involute pair: line of action, flanks, sizes as they are drawn, generation (исследование)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property

from geometry.board import Board
from plans.involute.action import MESH, LineOfAction, apart
from plans.involute.flanks import Flanks
from plans.involute.generation import GENERATION, Generated, generated, ring
from plans.model.involute import InvolutePair, PairSizes, WheelSizes
from plans.model.motion import Complexes

CONSTRUCTION = "construction"
POINTS = 41  # of a flank, and of the fillet below it


class InvoluteStudy:
    """A pair drawn."""

    def __init__(self, pair: InvolutePair) -> None:
        self.pair, self.made = pair, set[str]()

    def construct(self, plans: Collection[str]) -> None:
        """Draw what is asked for."""
        _ = self.sizes
        if GENERATION in plans:
            _ = self.generated

    @cached_property
    def action(self) -> LineOfAction:
        """The line of action."""
        self.made.add(MESH)
        return LineOfAction(self.pair)

    @cached_property
    def flanks(self) -> tuple[Flanks, Flanks]:
        """The flanks of both wheels that touch in P."""
        first, second = (Flanks(self.action, wheel) for wheel in self.pair.wheels)
        return first, second

    @cached_property
    def generated(self) -> dict[int, Generated]:
        """The spaces of the outer wheels as the rack cuts them, by the numbers of the wheels."""
        self.made.add(GENERATION)
        outer = (flanks for flanks in self.flanks if not flanks.wheel.internal)
        return {one.wheel.number: generated(one.wheel, one.tip, POINTS, Board(GENERATION)) for one in outer}

    def profile(self, flanks: Flanks) -> Complexes:
        """Give the right side of a space of a wheel, its middle above the centre, from the root to the tip, m."""
        if flanks.wheel.number in self.generated:
            return self.generated[flanks.wheel.number].points
        return ring(flanks.wheel, flanks.half, (flanks.tip, flanks.root), POINTS)

    @cached_property
    def sizes(self) -> PairSizes:
        """All sizes as they are measured."""
        action, ratio = self.action, self.action.length / self.pair.rack.base_pitch
        wheels = self._wheel(self.flanks[0]), self._wheel(self.flanks[1])
        return PairSizes(CONSTRUCTION, action.angle, apart(*action.centres), action.length, ratio, wheels)

    def _wheel(self, flanks: Flanks) -> WheelSizes:
        wheel, number, nothing = flanks.wheel, flanks.wheel.number, float("nan")
        chord = (apart(*flanks.chord), flanks.chord_height) if flanks.has_chord else (nothing, nothing)
        return WheelSizes(
            flanks.operating, flanks.tip, flanks.root, flanks.tooth(f"S_{number}", wheel.radius),
            flanks.tooth(f"S_w{number}", flanks.operating), flanks.tooth(f"S_a{number}", flanks.tip), *chord,
            apart(*flanks.span), flanks.pin, flanks.over, self.action.sliding[number - 1],
        )  # fmt: skip
