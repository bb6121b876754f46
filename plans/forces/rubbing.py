"""What rubs in a pair: how fast its links move over each other, how hard they press, and what that costs (M6.1).

The reactions are those without friction. What follows from them is the first order of the theory: an error of the order
f^2 is left in every power lost (book, chapter 7).
"""

from __future__ import annotations

import numpy as np

from geometry.meet import cross, dot
from plans.model.kinetostatics import Loading, Reaction
from plans.model.machine import Rubbing
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Complexes, Floats, Motion, PointMotion


def rate(mechanism: Mechanism, motion: Motion, reaction: Reaction) -> Floats:
    """Give how fast the taker moves over the giver: rad/s in a hinge, m/s along the line of a slide (относительная)."""
    giver, taker = reaction.giver, reaction.taker
    if reaction.along is None:
        return _omega(motion, taker) - _omega(motion, giver)
    slip = _velocity(mechanism, motion, taker, reaction.r) - _velocity(mechanism, motion, giver, reaction.r)
    return np.asarray(dot(reaction.along, slip))


def lost(rubbing: Rubbing, reaction: Reaction, rate: Floats) -> Floats:
    """Give the power W lost in a pair: f |R| r |omega| in a hinge, f (sum of normal reactions) |v| in a slide."""
    if reaction.along is None:
        return np.asarray(rubbing.coefficient * rubbing.radius * np.abs(reaction.force) * np.abs(rate))
    across = np.asarray(cross(reaction.along, reaction.force))
    moment = np.zeros_like(across) if reaction.moment is None else reaction.moment
    return rubbing.coefficient * pressing(across, moment, rubbing.length) * np.abs(rate)


def edges(across: Floats, moment: Floats, length: float) -> tuple[Floats, Floats]:
    """Share a slide's reaction N and its moment N*m about the middle out to the two edges of the contact (figure 7.3).

    With the line of action x = moment/across from the middle they are P(1/2 + x/a) and P(1/2 - x/a): on one side while
    it stays within the contact, on opposite sides beyond. Without a length the contact is as long as it has to be, and
    bears a couple, too, without pressing.

    >>> [float(edge) for edge in edges(np.float64(800), np.float64(800 * 0.09), 0.12)]
    [1000.0, -200.0]
    """
    couple = moment / length if length else np.zeros_like(moment)
    return across / 2 + couple, across / 2 - couple


def pressing(across: Floats, moment: Floats, length: float) -> Floats:
    """Give the sum N of the normal reactions of a slide: |P|, or of two edges on opposite sides 2 |P| |x|/a."""
    near, far = edges(across, moment, length)
    return np.asarray(np.abs(near) + np.abs(far))


def useful(mechanism: Mechanism, motion: Motion, loading: Loading) -> Floats:
    """Give the power W that the useful loads take; 0 where together they drive, or do no work (холостой ход)."""
    given = np.zeros(len(motion.phi))
    for load in loading.forces:
        if load.useful and load.link != FRAME:
            own, point = _first(mechanism, motion, load.link)
            arm = (load.at - own) * np.exp(1j * motion.links[load.link].angle)
            given += dot(load.force, _velocity(mechanism, motion, load.link, point.r + arm))
    for twist in loading.moments:
        if twist.useful:
            given += twist.moment * _omega(motion, twist.link)
    return np.maximum(0.0, -given)


def _velocity(mechanism: Mechanism, motion: Motion, link: int, r: Complexes) -> Complexes:
    """Give the velocity m/s of that point of a link which is at r."""
    _, point = _first(mechanism, motion, link)
    return np.asarray(point.v + 1j * _omega(motion, link) * (r - point.r))


def _first(mechanism: Mechanism, motion: Motion, link: int) -> tuple[complex, PointMotion]:
    """Give the first named point of a link: its place in the link, and its motion."""
    name, own = next(iter(mechanism.links[link].points.items()))
    return own, motion.points[name]


def _omega(motion: Motion, link: int) -> Floats:
    if link == FRAME:
        return np.zeros(len(motion.phi))
    return motion.links[link].omega
