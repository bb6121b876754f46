"""What the vectors of the force plans must be by analysis alone: the other road's word on every force (ожидаемые)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping

from plans.forces.cut import indices
from plans.forces.primary import DRIVING
from plans.model.kinetostatics import Kinetostatics, Loading, pair
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion
from plans.model.structure import Dyad, Joint


class ExpectedForces:
    """The forces of one position, from motion and reactions by analysis: weights, inertia, loads, and the parts."""

    def __init__(
        self, mechanism: Mechanism, machine: Machine, motion: Motion, loading: Loading, found: Kinetostatics, k: int
    ) -> None:
        self.mechanism, self.machine, self.motion, self.loading = mechanism, machine, motion, loading
        self.found, self.k = found, k

    def polygon(self, groups: tuple[Dyad, ...], group: Dyad | None) -> dict[str, complex]:
        """Give every force that the polygon of a group must show; None is the primary link."""
        links = (self.mechanism.drive.link,) if group is None else group.links
        told = {name: force for link in links for name, force in self._acting(link)}
        outer: list[tuple[int, int, Joint]]
        if group is None:
            outer = [(FRAME, links[0], self.mechanism.drive.pivot)]
            if self.found.balancing.force is not None:
                told[DRIVING] = complex(self.found.balancing.force[self.k])
        else:
            outer = list(zip(group.hosts, group.links, group.outer, strict=True))
            outer.append((*group.links[::-1], group.inner))
        outer += self._handed(groups, links)
        return told | {f"R_{indices(giver, taker)}": self.reaction(giver, taker, j) for giver, taker, j in outer}

    def parts(self, group: Dyad | None) -> dict[str, complex]:
        """Give the parts of a group's outer reactions, which its polygon shows where a link has moments.

        Of a hinge they are along the lead and square to it; of a stone's hinge along the slot and square to it.
        """
        if group is None:
            return {}
        return {name: part for end in (0, 1) for name, part in self._parts(group, end)}

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

    def _handed(self, groups: tuple[Dyad, ...], links: tuple[int, ...]) -> Iterator[tuple[int, int, Joint]]:
        """Give the reactions of groups that hang on some links."""
        for group in groups:
            for host, link, joint in zip(group.hosts, group.links, group.outer, strict=True):
                if host in links:
                    yield link, host, joint

    def acceleration(self, body: Body) -> complex:
        """Give the acceleration of a link's mass centre: that of a point of the link, and the turning about it."""
        name, place = next(iter(self.mechanism.links[body.link].points.items()))
        turning = self.motion.links[body.link]
        spin = complex(-(float(turning.omega[self.k]) ** 2), float(turning.epsilon[self.k]))
        turned = spin * cmath.rect(1.0, float(turning.angle[self.k]))
        return complex(self.motion.points[name].a[self.k]) + turned * (body.centre - place)

    def _parts(self, group: Dyad, end: int) -> Iterator[tuple[str, complex]]:
        joint = group.outer[end]
        if not isinstance(joint, str):
            return
        along, letters = self._lead(group, end)
        if along is None:
            return
        host, link = group.hosts[end], group.links[end]
        force, index = self.reaction(host, link, joint), indices(host, link)
        part = along * (along.conjugate() * force).real
        yield f"R^{letters[0]}_{index}", part
        yield f"R^{letters[1]}_{index}", force - part

    def _lead(self, group: Dyad, end: int) -> tuple[complex | None, str]:
        """Give the unit direction that a hinge's reaction is taken apart by, and the letters of its parts."""
        if isinstance(group.inner, str):
            start, tip = (complex(self.motion.points[name].r[self.k]) for name in (group.hinge(end), group.inner))
            return (tip - start) / abs(tip - start), "nt"
        if end == 1:  # the pivot of a slotted link closes the polygon whole
            return None, ""
        slide = self.found.reactions[pair(*group.links, group.inner).key]
        assert slide.along is not None  # a sliding pair has a direction
        return complex(slide.along[self.k]), "un"


def missed(
    seen: Mapping[str, complex],
    expected: Mapping[str, complex],
    parts: Mapping[str, complex],
    allowed: float,
    least: float,
) -> Iterator[str]:
    """Name the forces that a polygon lacks, or shows otherwise than expected, or that nothing is known of.

    `allowed` N is what a force may differ by; one below `least` N may be missing.
    """
    known = {**parts, **expected}
    for name, value in seen.items():
        if name not in known:
            yield f"{name} is no force of this group"
        elif not abs(value - known[name]) <= allowed:
            yield f"{name} (against the analysis)"
    for name, value in expected.items():
        if name not in seen and not abs(value) <= least:
            yield f"{name} is missing"
