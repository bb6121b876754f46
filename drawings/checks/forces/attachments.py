"""The self-check of what hangs on loading schemes: springs, friction circles, a coupling (проверка схем нагружения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.forces.attachments import SEEN
from drawings.paper.hand import Hand
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Circle, Group, Leaf, Polyline, Stroke
from drawings.paper.walk import groups
from drawings.symbols.symbols import HINGE
from plans.checks.force_expected import ExpectedForces
from plans.model.machine import COUPLING
from plans.model.mechanism import FRAME

ASKEW = 1e-3  # rad: a spring's line is drawn with the coordinates of paper
COUPLED, SPRING, FRICTION = "coupling", "spring", "friction"


class Schemes(NamedTuple):
    """The loading schemes of a sheet, with what the analysis knows of their links."""

    leaf: Leaf
    expected: ExpectedForces
    hand: Hand

    def faults(self) -> Iterator[Wrong]:
        """Hold each scheme of the sheet by the links that its name tells."""
        for group in self.leaf.groups:
            if group.name.startswith("scheme-"):
                links = {int(link) for link in group.name.split("-")[1:-1]}
                yield from self._springs(group, links)
                yield from self._friction(group, links)
                if self._coupled(links) != (COUPLED in _kinds(group)):
                    yield on("missing_on", group.name, name=COUPLED)

    def _coupled(self, links: set[int]) -> bool:
        drive, how = self.expected.mechanism.drive.link, self.expected.machine.transmission.kind
        return links == {drive} and how == COUPLING

    def _springs(self, group: Group, links: set[int]) -> Iterator[Wrong]:
        """Hold each spring: on the line of its ends by analysis, away from the link that it pulls."""
        seen = {one.data["name"].rstrip("′"): one for one in groups((group,)) if one.data.get("kind") == SPRING}
        points, k = self.expected.motion.points, self.expected.k
        for spring in self.expected.machine.springs:
            moving = [end for end in (0, 1) if spring.links[end] in links and spring.links[end] != FRAME]
            one = seen.get(spring.name)
            if one is None:
                yield from [on("missing_on", group.name, name=spring.name)] if moving else []
                continue
            ends = [complex(points[name].r[k]) for name in spring.points]
            if not any(_along(one, ends[1 - end] - ends[end]) for end in moving):
                yield on("direction", group.name, name=spring.name)

    def _friction(self, group: Group, links: set[int]) -> Iterator[Wrong]:
        """Hold each friction circle by its radius f*r at the scale that is written, and that none is missing."""
        mu = written_scales(group).get("l", math.nan)
        told = (one for one in groups((group,)) if one.data.get("kind") == FRICTION)
        seen = [(one.data["name"], one.strokes[0]) for one in told]
        least = HINGE * self.hand.symbol + SEEN
        for name, radius in dict.fromkeys(self._radii(links)):
            fits = [one for one in seen if one[0] == name and _as_wide(one[1], radius / mu)]
            if fits:
                seen.remove(fits[0])
            elif radius / mu > least + QUANTUM and name not in (one for one, _ in seen):
                yield on("missing_on", group.name, name=f"ρ_{name}")
        yield from (on("differs_on", group.name, name=f"ρ_{name}") for name, _ in seen)

    def _radii(self, links: set[int]) -> Iterator[tuple[str, float]]:
        for key, one in self.expected.machine.friction.items():
            own = [self.expected.mechanism.links[int(link)].points for link in key.split("-")]
            if one.radius and links & {int(link) for link in key.split("-")}:
                shared = (name for name in own[0] if name in own[1] and name in self.expected.mechanism.hinges)
                yield from ((name, one.coefficient * one.radius) for name in shared)


def _as_wide(stroke: Stroke, radius: float) -> bool:
    return isinstance(stroke, Circle) and abs(stroke.radius - radius) <= QUANTUM


def _kinds(group: Group) -> set[str]:
    return {one.data.get("kind", "") for one in groups((group,))}


def _along(one: Group, way: complex) -> bool:
    """Tell whether a spring's zigzag begins and ends on a line of some direction."""
    chain = one.strokes[0]
    if not isinstance(chain, Polyline):
        return False
    run = chain.points[-1] - chain.points[0]
    return abs(cmath.phase(run / way)) <= ASKEW
