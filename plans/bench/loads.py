"""The true loads: what of the loads follows the motion, reckoned in 50 digits from the true one (нагрузки эталона).

Which stroke it is, where its ends are and whether a load acts at all are taken as the construction tells them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from plans.forces.stroke import Stroke
from plans.model.kinetostatics import Loading
from plans.model.machine import Force, Machine, Spring, Track
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Floats


@dataclass(frozen=True)
class TrueLoads:
    """The loads of a machine at some positions as the construction has them, to be reckoned again in `mp`'s digits."""

    machine: Machine
    mechanism: Mechanism
    strokes: Mapping[Track, Stroke]
    loading: Loading
    phi: Floats

    def at(self, mp: Any, column: int, true: Mapping[tuple[str, str], Any]) -> list[Any]:
        """Give all forces, then all moments, of one position whose true motion is known."""
        constructed = iter([complex(load.force[column]) for load in self.loading.forces])
        found = [end for force in self.machine.forces for end in self._acting(mp, column, true, force, constructed)]
        found += [end for spring in self.machine.springs for end in self._ends(mp, true, spring)]
        return [*found, *(mp.mpf(float(twist.moment[column])) for twist in self.loading.moments)]

    def _acting(
        self, mp: Any, column: int, true: Mapping[tuple[str, str], Any], force: Force, constructed: Iterator[complex]
    ) -> Iterator[Any]:
        """Give a force at its point, and at the other end where that moves."""
        value = self._force(mp, column, true, force, next(constructed))
        yield value
        if force.other is not None and force.other.link != FRAME:
            next(constructed)
            yield -value

    def _force(self, mp: Any, column: int, true: Mapping[tuple[str, str], Any], force: Force, given: complex) -> Any:
        if given == 0:  # it rests, or is none
            return mp.mpc(0)
        size = mp.mpf(force.size)
        if force.diagram is not None:
            travel, there, back, _ = force.diagram
            stroke = self.strokes[force.stroke]
            table = there if stroke.working(self.phi[column]) else back or there
            size *= _between(self._share(mp, true, stroke), travel, table)
        if force.direction is not None:
            return size * mp.mpc(force.direction)
        ways = [size * way for way in self._ways(mp, true, force)]
        return min(ways, key=lambda way: abs(way - given))

    def _ways(self, mp: Any, true: Mapping[tuple[str, str], Any], force: Force) -> list[Any]:
        """Give the unit directions that a force without a fixed one may have."""
        if force.line is not None:
            start, end = (self._place(mp, true, point) for point in force.line)
            along = (end - start) / abs(end - start)
            return [-along, along] if force.resists else [along]
        # Against the velocity; from a rest, where that has no direction, against the acceleration.
        return [-true[kind, force.point] / abs(true[kind, force.point]) for kind in ("v", "a")]

    def _share(self, mp: Any, true: Mapping[tuple[str, str], Any], stroke: Stroke) -> Any:
        """Give the share of its stroke that an output has gone."""
        low, high = map(mp.mpf, stroke.reach)
        if stroke.parting is not None:
            start, end = (self._place(mp, true, name) for name in stroke.parting.line)
            away = self._place(mp, true, stroke.point) - self._place(mp, true, stroke.parting.other)
            beyond = (mp.conj(end - start) * away).real / abs(end - start) - (low + high) / 2
        elif stroke.way is None:
            beyond = true["angle", str(stroke.link)] - (low + high) / 2
            beyond -= 2 * mp.pi * mp.nint(beyond / (2 * mp.pi))
        else:
            way = mp.mpc(stroke.way.direction)
            beyond = (mp.conj(way) * (true["r", stroke.point] - mp.mpc(stroke.way.through))).real - (low + high) / 2
        return min(max(beyond / (high - low) + mp.mpf(0.5), mp.mpf(0)), mp.mpf(1))

    def _place(self, mp: Any, true: Mapping[tuple[str, str], Any], point: str) -> Any:
        """Give the place of a point, m."""
        fixed = self.mechanism.links[FRAME].points
        return mp.mpc(fixed[point]) if point in fixed else true["r", point]

    def _ends(self, mp: Any, true: Mapping[tuple[str, str], Any], spring: Spring) -> Iterator[Any]:
        """Give the pull at each end of a spring that moves."""
        first, second = (self._place(mp, true, name) for name in spring.points)
        apart = second - first
        pull = mp.mpf(spring.stiffness) * apart * (1 - mp.mpf(spring.free) / abs(apart) if spring.free else 1)
        yield from (way for way, link in zip((pull, -pull), spring.links, strict=True) if link != FRAME)


def _between(share: Any, travel: tuple[float, ...], table: tuple[float, ...]) -> Any:
    """Read a diagram between its points, level before the first and after the last.

    >>> _between(0.25, (0.0, 0.5, 1.0), (0.0, 8.0, 8.0)), _between(2.0, (0.0, 1.0), (3.0, 4.0))
    (4.0, 4.0)
    """
    if share <= travel[0]:
        return table[0]
    steps = zip(travel, travel[1:], table, table[1:], strict=False)
    found = ((low, high, start, end) for low, high, start, end in steps if share <= high)
    low, high, start, end = next(found, (0.0, 1.0, table[-1], table[-1]))
    return start + (share - low) / (high - low) * (end - start)
