"""The transfer functions by construction: the motion of a crank that turns by 1 rad/s evenly (передаточные функции)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property

import numpy as np

from plans.linkage.drafts import Drafts
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import at_angles
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Floats, Motion, Rates
from plans.transfer.turned import TURNED, TurnedPlan, turned

TRANSFER = TURNED
STEPS = 720  # of a graph over a turn: half a degree, less than the width of a line on any sheet


def evenly(phi: Floats) -> Rates:
    """Turn a crank by 1 rad/s in every position, whose velocities are then transfer functions."""
    return Rates(np.ones_like(phi), np.zeros_like(phi))


def turning(mechanism: Mechanism) -> list[int]:
    """List the links whose ratio is told: of those that turn as one, the one that is hinged to the frame."""
    fixed, least = mechanism.links[FRAME].points, mechanism.turning_with
    alike: dict[int, list[int]] = {}
    for link in sorted(least):
        alike.setdefault(least[link], []).append(link)
    others = (links for first, links in alike.items() if first not in (FRAME, least[mechanism.drive.link]))
    return sorted(next((n for n in links if mechanism.links[n].points.keys() & fixed), links[0]) for links in others)


def sliding(mechanism: Mechanism) -> list[Slide]:
    """List the slides on the frame, whose points have transfer functions S', S''."""
    return [slide for slide in mechanism.slides if FRAME in (slide.owner, slide.slider)]


class TransferStudy:
    """The transfer functions of a linkage by construction."""

    def __init__(self, linkage: LinkageStudy) -> None:
        self.linkage, self.unit = linkage, linkage.paced(evenly)
        self.made: dict[str, None] = {}

    def construct(self, plans: Collection[str]) -> None:
        """Draw the turned plan, if it is asked for."""
        if TRANSFER in plans:
            _ = self.turned

    @cached_property
    def turned(self) -> TurnedPlan:
        """The turned velocity plan in all positions."""
        self.made.setdefault(TRANSFER)
        return turned(self.unit.drafts().velocities)

    @property
    def angles(self) -> Floats:
        """What the crank has turned in the course of the graphs, rad: a whole turn from position 0 on."""
        return np.arange(STEPS + 1) * 2 * np.pi / STEPS

    def around(self) -> Motion:
        """Read the course of all points and links over the turn off their plans; NaN where the crank cannot come."""
        study = self.unit
        turn = at_angles(study.turn.phi[0] + study.sense * self.angles).paced(evenly)
        drafts = Drafts(study, turn)
        found = drafts.motion(2).own()
        gone = drafts.lost | drafts.unborne
        for row in found.rows():
            row[gone] = np.nan
        return found
