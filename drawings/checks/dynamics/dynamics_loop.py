"""The self-check of the loop: its points, its curve, tangents, what they cut off, the equations (проверка петли)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.dynamics.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics.dynamics_graphs import edge_names, has
from drawings.checks.dynamics.loop_strokes import LoopStrokes
from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics.strips import MARKED
from drawings.lettering.words import number
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Group, Leaf, Polyline
from drawings.paper.walk import group_named, walk
from plans.model.dynamics import Flywheel
from plans.model.motion import Complexes
from plans.words.words import message

LOOP = "loop"
ORIGIN = "o1"
TANGENTS = ("ψmin", "ψmax")
SEGMENTS = ("o1l", "o1k")
SHORT = 1.0  # mm: a segment that is shorter may have no dimension


def loop(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the loop that a sheet must show."""
    group = group_named(leaf.groups, LOOP)
    if group is None:
        yield message("wrong.missing", name=LOOP)
        return
    shown = _Loop(group, measured, expected)
    yield from shown.faults(drafting.language)
    if np.isfinite(shown.scales).all() and not np.isnan(shown.origin):
        tangents, names = [one for one in measured.vectors if one.plan == LOOP], edge_names(expected)
        yield from LoopStrokes(
            group, shown.origin, shown.scales, shown.places, expected, names, tangents, shown.near + FLUSH, drafting
        ).faults()


def loop_on(measured: Measured, leaf: Leaf, expected: Expected) -> Complexes | None:
    """Give where the edges lie on the loop, on paper, mm (n + 1,); None where its scales or its origin are lost."""
    group = group_named(leaf.groups, LOOP)
    if group is None:
        return None
    shown = _Loop(group, measured, expected)
    found = np.asarray(shown.origin + shown.places)
    return found if np.isfinite(found).all() else None


@dataclass(frozen=True)
class _Loop:
    """The loop on a sheet: its marks are in mm of paper, its scales are written over it."""

    group: Group
    measured: Measured
    expected: Expected

    @cached_property
    def scales(self) -> tuple[float, float]:
        """The scales of inertia and energy, as they are written."""
        found = written_scales(self.group)
        return found.get("J", np.nan), found.get("T", np.nan)

    @cached_property
    def places(self) -> np.ndarray[tuple[int, ...], np.dtype[np.complex128]]:
        """Where each edge must be, mm from the origin of the loop."""
        inertia, energy = self.scales
        return np.asarray(self.expected.cycle.varying / inertia + 1j * self.expected.cycle.surplus / energy)

    @property
    def near(self) -> float:
        """How far a place may be off on paper, mm."""
        return 3 * self.measured.quantum + KNOWN * float(np.abs(self.places).max(initial=0.0))

    @property
    def origin(self) -> complex:
        """The origin of the loop on paper, mm, by its pole."""
        poles = (one for one in walk((self.group,)) if isinstance(one, Group) and one.data.get("kind") == "pole")
        first = next((one.strokes[0] for one in poles), None)
        return first.centre if isinstance(first, Circle) else complex(np.nan)

    def faults(self, language: str) -> Iterator[Wrong]:
        if not np.isfinite(self.scales).all() or np.isnan(self.origin):
            yield message("wrong.scale", text="μ_J, μ_T")
            return
        yield from self._points()
        yield from self._curve()
        wheel = self.expected.wheel
        if wheel is not None:
            yield from self._tangents(wheel)
            yield from self._segments(wheel, language)

    def _points(self) -> Iterator[Wrong]:
        """Hold the numbered points, each by its name too; those that tangents touch must be there."""
        seen, names = {one.position: one for one in self.measured.points if one.plan == LOOP}, edge_names(self.expected)
        for k, one in seen.items():
            if k is None or not 0 <= k < len(names) or one.name != names[k]:
                yield on("stranger_on", LOOP, name=one.name)
            elif not abs(one.value - self.places[k]) <= self.near:
                yield on("differs_on", LOOP, name=one.name)
        for k in self.touched:
            if k not in seen and not any(abs(self.places[k] - one.value) <= self.near for one in seen.values()):
                yield on("missing_on", LOOP, name=names[k])

    @property
    def touched(self) -> frozenset[int]:
        """The edges that the tangents touch."""
        touches = self.expected.wheel.touches if self.expected.wheel else ()
        return frozenset(int(np.abs(self.expected.cycle.turned - one.turned).argmin()) for one in touches)

    def _curve(self) -> Iterator[Wrong]:
        """See that a point stands at each edge that is marked, and that the curve goes through all of them."""
        dots = np.array([one.centre for one in walk((self.group,)) if isinstance(one, Circle)])
        chains = [one.points for one in walk((self.group,)) if isinstance(one, Polyline)]  # its axes are no part of it
        curve, names = np.array([spot for chain in chains for spot in chain]), edge_names(self.expected)
        marked = {one.position for one in self.measured.points if one.plan == LOOP}
        for k, place in enumerate(self.places[:-1]):
            spot = self.origin + place
            bare = len(names) > MARKED + 1 and k not in marked
            if not ((bare or has(dots, spot, self.near)) and has(curve, spot, self.near)):
                yield on("edge", LOOP, name=names[k])

    def _tangents(self, wheel: Flywheel) -> Iterator[Wrong]:
        """Hold both tangents: their direction, and that they start on the axis where they must, and touch."""
        inertia, energy = self.scales
        seen = {one.name: one for one in self.measured.vectors if one.plan == LOOP}
        for name, slope, cut, touch in zip(TANGENTS, wheel.slopes, wheel.cuts, wheel.touches, strict=True):
            one = seen.get(name)
            if one is None:
                yield on("missing_on", LOOP, name=name)
                continue
            along = complex(1.0, slope * inertia / energy)
            if not abs((one.value * along.conjugate()).imag) <= self.near * abs(along):
                yield on("direction", LOOP, name=name)
            if not abs(one.start - self.origin - 1j * cut / energy) <= self.near:
                yield on("differs_on", LOOP, name=name)
            spot = complex(touch.varying / inertia, touch.surplus / energy) - (one.start - self.origin)
            if not abs((spot * one.value.conjugate()).imag) <= 2 * self.near * abs(one.value):
                yield on("touch", LOOP, name=name)

    def _segments(self, wheel: Flywheel, language: str) -> Iterator[Wrong]:
        _, energy = self.scales
        seen = {one.name: one for one in self.measured.vectors if one.plan == LOOP}
        for name, cut in zip(SEGMENTS, wheel.cuts, strict=True):
            one = seen.get(name)
            if one is None:
                yield from [on("missing_on", LOOP, name=name)] if abs(cut) > SHORT * energy else []
            elif not abs(one.value - 1j * cut) <= self.near * energy:
                yield on("differs_on", LOOP, name=name)
            elif number(one.scale, language) != number(energy, language):
                yield message("wrong.scale", text="μ_T")
