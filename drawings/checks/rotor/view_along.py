"""The self-check of the view of a rotor along the shaft: centre, masses, radii, axes, sense (вид вдоль вала)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.graphs.figure_strokes import FLUSH, figure
from drawings.checks.rotor.rotor_seen import RotorSeen
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Line
from plans.model.rotor import Balance, Rotor


def along(leaf: Leaf, name: str, rotor: Rotor, balance: Balance, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the view along the shaft."""
    strokes = figure(leaf, name)
    if strokes is not None:
        yield from _Along(name, strokes, rotor, balance, drafting).faults()


class _Along(RotorSeen):
    """The view along the shaft."""

    def faults(self) -> Iterator[Wrong]:
        own, plan = self.inventory, self.plan
        self.headed("view along", self.known)
        own.circle(self.zero, on("missing_on", plan, name="O"))
        own.letter("O", [self.zero], on("letter", plan, name="O"))
        self.masses()
        for one in (one for one in self.bodies if one.distinct):
            self.radius(one, self.zero, not one.known)
        reach = max((abs(self.spot(one) - self.zero) for one in self.bodies), default=0.0)
        ends = [self._axis(way, reach) for way in (1 + 0j, 1j)]
        own.letter("φ = 0", [ends[0]], on("letter", plan, name="φ = 0"))
        if self.rotor.speed is not None:
            wrong = on("sense", plan, name="ω")
            middle = own.turning(self.zero, self.rotor.speed, wrong)
            own.letter("ω", [] if middle is None else [middle], wrong)
        return own.faults()

    def _axis(self, way: complex, reach: float) -> complex:
        """Hold an axis through the centre beyond the outermost mass on both sides; give its end."""

        def holds(one: Line) -> bool:
            ends = [(end - self.zero) / way for end in (one.start, one.end)]
            level = all(abs(end.imag) <= FLUSH for end in ends)
            return level and abs(sum(ends)) <= FLUSH and abs(ends[0]) >= reach and bool(one.style.dash or reach == 0)

        line = self.inventory.take(Line, holds, on("axis_line", self.plan))
        return self.zero if line is None else max(line.start, line.end, key=lambda end: (end / way).real)
