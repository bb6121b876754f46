"""What the vectors of the force plans must be by analysis alone: the other road's word on every force (ожидаемые)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence

from plans.forces.cut import indices
from plans.forces.dyads import GROUP_FORCES, Split
from plans.forces.primary import DRIVING
from plans.model.group import Group, Joint, Pair
from plans.model.kinetostatics import Kinetostatics, Loading, pair
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion
from plans.words.words import Message, message


class ExpectedForces:
    """The forces of one position, from motion and reactions by analysis: weights, inertia, loads, and the parts."""

    def __init__(
        self, mechanism: Mechanism, machine: Machine, motion: Motion, loading: Loading, found: Kinetostatics, k: int
    ) -> None:
        self.mechanism, self.machine, self.motion, self.loading = mechanism, machine, motion, loading
        self.found, self.k = found, k

    def polygon(self, groups: Sequence[Group], group: Group | None) -> dict[str, complex]:
        """Give every force that the polygon of a group must show; None is the primary link."""
        links = (self.mechanism.drive.link,) if group is None else group.links
        told = {name: force for link in links for name, force in self._acting(link)}
        if group is None:
            outer = [Pair(FRAME, links[0], self.mechanism.drive.guide or self.mechanism.drive.pivot)]
            if self.found.balancing.force is not None:
                told[DRIVING] = complex(self.found.balancing.force[self.k])
        else:
            outer = [*group.outer_pairs, *(Pair(taker, giver, joint) for giver, taker, joint in group.inner_pairs)]
        outer += self._handed(groups, links)
        return told | {f"R_{indices(giver, taker)}": self.reaction(giver, taker, j) for giver, taker, j in outer}

    def parts(self, group: Group | None) -> dict[str, complex]:
        """Give the parts of a group's outer reactions, which its polygon shows where a link has moments.

        Of a hinge they are along the lead and square to it; of a stone's hinge along the slot and square to it.
        """
        if group is None:
            return {}
        return dict(part for split in GROUP_FORCES[group.kind].splits(group) for part in self._parts(split))

    def reaction(self, giver: int, taker: int, joint: Joint) -> complex:
        """Give the force of one link on another, N."""
        one = self.found.reactions[pair(giver, taker, joint).key]
        force = complex(one.force[self.k])
        return force if one.giver == giver else -force

    def image(self, name: str) -> complex:
        """Give the place of a named point's image on Zhukovsky's lever: its velocity, turned by a quarter."""
        return -1j * complex(self.motion.points[name].v[self.k])

    def _acting(self, link: int) -> Iterator[tuple[str, complex]]:
        """Give the weight, the inertia force and the loads of a link."""
        body = self.machine.bodies.get(link)
        if body is not None:
            yield f"G_{link}", body.mass * self.machine.gravity
            yield f"Φ_{link}", -body.mass * self.acceleration(body)
        for load in self.loading.forces:
            if load.link == link:
                yield load.name, complex(load.force[self.k])

    def _handed(self, groups: Sequence[Group], links: Sequence[int]) -> Iterator[Pair]:
        """Give the reactions of groups that hang on some links."""
        for group in groups:
            for host, link, joint in group.outer_pairs:
                if host in links:
                    yield Pair(link, host, joint)

    def acceleration(self, body: Body) -> complex:
        """Give the acceleration of a link's mass centre: that of a point of the link, and the turning about it."""
        name, place = next(iter(self.mechanism.links[body.link].points.items()))
        turning = self.motion.links[body.link]
        spin = complex(-(float(turning.omega[self.k]) ** 2), float(turning.epsilon[self.k]))
        turned = spin * cmath.rect(1.0, float(turning.angle[self.k]))
        return complex(self.motion.points[name].a[self.k]) + turned * (body.centre - place)

    def _parts(self, split: Split) -> Iterator[tuple[str, complex]]:
        host, link, joint = split.pair
        along, index = self._direction(split), indices(host, link)
        force = self.reaction(host, link, joint)
        part = along * (along.conjugate() * force).real
        yield f"R^{split.letters[0]}_{index}", part
        yield f"R^{split.letters[1]}_{index}", force - part

    def _direction(self, split: Split) -> complex:
        """Give the unit direction that a hinge's reaction is taken apart by."""
        if isinstance(split.along, Pair):
            slide = self.found.reactions[pair(*split.along).key]
            assert slide.along is not None  # a sliding pair has a direction
            return complex(slide.along[self.k])
        start, tip = (complex(self.motion.points[name].r[self.k]) for name in split.along)
        return (tip - start) / abs(tip - start)


def missed(
    seen: Mapping[str, complex],
    expected: Mapping[str, complex],
    parts: Mapping[str, complex],
    allowed: float,
    least: float,
) -> Iterator[Message]:
    """Name the forces that a polygon lacks, or shows otherwise than expected, or that nothing is known of.

    `allowed` N is what a force may differ by; one below `least` N may be missing.
    """
    known = {**parts, **expected}
    for name, value in seen.items():
        if name not in known:
            yield message("wrong.stranger", name=name)
        elif not abs(value - known[name]) <= allowed:
            yield message("wrong.differs", name=name)
    for name, value in expected.items():
        if name not in seen and not abs(value) <= least:
            yield message("wrong.missing", name=name)
