"""The self-check of workings on force sheets: forces of masses, lengths laid off, velocities read off the lever."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.workings.due_line import DueLine, Quantity, faults, scaled
from drawings.checks.workings.linkage_workings import lengths
from drawings.checks.wrong import Wrong
from drawings.figures.forces.lever_layout import PLAN
from drawings.figures.linkage.vector_plan import LEAST
from drawings.figures.workings.working import LENGTHS, MASSES, READING, SEGMENTS
from drawings.lettering.indices import with_index
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from plans.checks.force_expected import ExpectedForces
from plans.linkage.letters import POLES
from plans.model.mechanism import FRAME
from plans.model.order import VELOCITIES

POLYGON = "forces-"  # before a cut's links: the name of its force plan


@dataclass(frozen=True)
class ForceWorkings:
    """The workings of a force sheet; `images` are the letters of points on the lever, `speed` m/s is its slack.

    Of the workings beside `polygons` the lines are given, by their names.
    """

    leaf: Leaf
    expected: ExpectedForces
    floor: Floor
    images: Mapping[str, str]
    speed: float
    drafting: Drafting
    polygons: Mapping[str, Sequence[DueLine]]

    def faults(self) -> Iterator[Wrong]:
        """Hold each by the figure that it stands beside."""
        for group in self.leaf.groups:
            kind, _, figure = group.name.partition("-")
            if figure.startswith(POLYGON) and kind in (SEGMENTS, READING):
                yield from faults(group, self.polygons.get(group.name, ()), figure, self.drafting)
            elif kind in (LENGTHS, MASSES, READING):
                due = self._due(kind, figure, self.leaf.metadata["scales"].get(figure, 0.0))
                yield from faults(group, due, figure, self.drafting)

    def _due(self, kind: str, figure: str, mu: float) -> list[DueLine]:
        mechanism = self.expected.mechanism
        links = list(mechanism.links) if figure == PLAN else [int(one) for one in figure.split("-")[1:]]
        if kind == LENGTHS:
            return lengths(mechanism, links, mu, self.drafting)
        return list(self._masses(links) if kind == MASSES else self._speeds(mu))

    def _masses(self, links: Sequence[int]) -> Iterator[DueLine]:
        """Give how weights, inertia forces and inertia couples are found."""
        machine, found = self.expected.machine, self.expected.motion
        for body in (machine.bodies[link] for link in links if link in machine.bodies):
            k = body.link
            if body.mass:
                rate = Quantity(abs(self.expected.acceleration(body)), self.floor.force / body.mass)
                yield self._product(
                    f"G_{k}", (f"m{k}", "g"), body.mass, Quantity(abs(machine.gravity)), self.floor.force
                )
                yield self._product(f"Φ_{k}", (f"m{k}", f"aS{k}"), body.mass, rate, self.floor.force)
            if body.inertia and k in found.links:
                turning = Quantity(
                    abs(float(found.links[k].epsilon[self.expected.k])), self.floor.moment / body.inertia
                )
                letters = f"JS{k}", f"ε{k}"
                yield self._product(f"M^Φ_{k}", letters, body.inertia, turning, self.floor.moment, "N*m")

    def _product(
        self, name: str, letters: tuple[str, str], size: float, by: Quantity, slack: float, unit: str = "N"
    ) -> DueLine:
        result = Quantity(size * by.true, slack, unit)
        return DueLine(read(self.floor.letter(name)), "·".join(letters), (Quantity(size), by), result, slack)

    def _speeds(self, mu: float) -> Iterator[DueLine]:
        """Give how the velocities of points are read off the lever."""
        symbol, unit = VELOCITIES.point.symbol, VELOCITIES.point.unit
        fixed = self.expected.mechanism.links[FRAME].points
        for point, image in self.images.items():
            if point not in fixed:
                speed = Quantity(abs(complex(self.expected.motion.points[point].v[self.expected.k])), self.speed, unit)
                segment = POLES[VELOCITIES.plan] + read(with_index(image))
                due = scaled(read(f"{symbol}_{{{point}}}"), segment, symbol, speed, mu, self.drafting)
                yield due._replace(none=LEAST * mu)
