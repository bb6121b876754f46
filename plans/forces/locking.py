"""Self-locking: where no force of the driving link, however large, overcomes the friction it causes (самоторможение).

A group brings a force to the link by which it hangs on the frame along one line, its ray of transmission: whatever else
acts on the group keeps its size, and only the part along the ray grows until the mechanism moves. Let that part be a
force X along the ray at the angle beta to the guide of a slide on the frame. It drives with X cos beta and presses with
X sin beta, more where the ray passes the contact's edge. For a load Q along the guide and all other pressure N0

    X cos beta = Q + f (X sin beta + N0),  so  X = (Q + f N0) / (cos beta (1 - f tan beta)):

it grows over all bounds as the ratio f tan beta comes to 1, as the friction angle arctan f comes to 90 degrees - beta,
and beyond it no X answers. So a slide jams where f (sum of the normal reactions to X) >= its part along the guide. Of a
rocker that turns about a hinge of the frame, f r >= the arm of the ray about the hinge: the ray cuts the friction
circle. Either is efficiency <= 0: all of the driving force's work lost in the pair that it drives (Artobolevsky, Theory
of Mechanisms and Machines, on efficiency and self-locking); the edges are those of the textbook's figure 7.3. Weights,
inertia and loads have no say in the ratio, only in whether the link is driven at the moment.

The ray joins two hinges, or is square to the slide: RRR and RRP along the rod, RPR and RPP square to the slot through
the driving hinge, PRP square to the driving guide through the inner hinge. Each pair is taken by itself: friction in
the driving pairs would turn the ray by an angle of the order f. Groups between moving links, those of more leads than
two, and a slider that drives the crank are not looked at.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from geometry.meet import cross, dot
from plans.forces.rubbing import lost, pressing
from plans.model.group import Group, pair
from plans.model.kinetostatics import Reaction
from plans.model.losses import CENTRAL, SLANTED, TILTED, Jam
from plans.model.machine import Rubbing
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats
from plans.words.words import Message


class Driven(NamedTuple):
    """A link that a group drives over the frame: the reaction of its pair there, that of the inner pair, and the ray.

    The ray goes through `through` in the direction of `ray`, a vector of any length.
    """

    outer: Reaction
    inner: Reaction
    through: Complexes
    ray: Complexes

    @property
    def effect(self) -> Floats:
        """What a force equal to `ray` drives with: its part along the guide, or its moment about the hinge."""
        if self.outer.along is None:
            return np.asarray(cross(self.through - self.outer.r, self.ray))
        return np.asarray(dot(self.outer.along, self.ray))

    @property
    def brought(self) -> Floats:
        """What the inner reaction drives with: N along the guide, or N*m about the hinge."""
        sign = 1.0 if self.inner.taker == self.outer.taker else -1.0
        if self.outer.along is not None:
            return np.asarray(sign * dot(self.outer.along, self.inner.force))
        turning = cross(self.inner.r - self.outer.r, self.inner.force)
        return np.asarray(sign * (turning if self.inner.moment is None else turning + self.inner.moment))

    @property
    def rest(self) -> Reaction:
        """The reaction of the driven pair without what answers the force along the ray."""
        grown = self.brought / self.effect
        moment = self.outer.moment
        if moment is not None:
            moment = moment + grown * cross(self.through - self.outer.r, self.ray)
        return self.outer._replace(force=self.outer.force + grown * self.ray, moment=moment)

    def ratio(self, rubbing: Rubbing) -> Floats:
        """Give the friction that a force along the ray causes, over what it drives with; 1 and more jams."""
        if self.outer.along is None:
            caused = rubbing.radius * np.abs(self.ray)
        else:
            moment = np.asarray(cross(self.through - self.outer.r, self.ray))
            caused = pressing(np.asarray(cross(self.outer.along, self.ray)), moment, rubbing.length)
        return np.asarray(rubbing.coefficient * caused / np.abs(self.effect))

    def power(self, rubbing: Rubbing, rate: Floats) -> Floats:
        """Give the power W that the group brings to the link, and that friction would take without it.

        Where it is above zero the group moves the link; elsewhere the link stands, or drives the group.
        """
        return np.asarray(self.brought * rate + lost(rubbing, self.rest, rate))

    def advice(self, rubbing: Rubbing, position: int) -> Message:
        """Say what would free the pair."""
        if self.outer.along is None:
            return CENTRAL
        ray = complex(self.ray[position] / self.outer.along[position])
        return SLANTED if rubbing.coefficient * abs(ray.imag) >= abs(ray.real) else TILTED


def drives(groups: Sequence[Group], reactions: Mapping[str, Reaction]) -> Iterator[tuple[str, Driven]]:
    """Find the pairs of the frame whose links are driven by a group that hangs on a moving link."""
    for group in groups:
        fixed, moving = ([one for one in group.outer_pairs if (one.giver == FRAME) == still] for still in (True, False))
        if not len(fixed) == len(moving) == len(group.inner_pairs) == 1:
            continue
        driven, driving, inner = (reactions[pair(*one).key] for one in (*fixed, *moving, *group.inner_pairs))
        if driving.along is not None and inner.along is not None:
            continue  # two slides bring a couple alone, which presses nothing
        found = f"{driven.giver}-{driven.taker}"
        if inner.along is not None:
            yield found, Driven(driven, inner, driving.r, 1j * inner.along)
        else:
            ray = inner.r - driving.r if driving.along is None else 1j * driving.along
            yield found, Driven(driven, inner, inner.r, ray)


def jams(driven: Driven, rubbing: Rubbing, rate: Floats, phi: Floats) -> list[Jam]:
    """Find the positions in which a driven link jams; `rate` is its own over the frame."""
    key, ratio = f"{driven.outer.giver}-{driven.outer.taker}", driven.ratio(rubbing)
    jammed = np.flatnonzero((driven.power(rubbing, rate) > 0) & (ratio >= 1)).tolist()
    return [Jam(key, k, float(phi[k]), float(ratio[k]), driven.advice(rubbing, k)) for k in jammed]
