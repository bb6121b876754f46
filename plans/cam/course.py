"""The course of a follower over the whole turn: S, S', S'' at any turn of the cam, its shocks (движение толкателя)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.cam.laws import law_of
from plans.model.cam import Cam, Phase
from plans.model.cam_motion import Shock, Travel
from plans.model.motion import Floats

ROUNDED = 1e-12  # of the largest value of its order: less is the rounding of a law's coefficients, and no shock


@dataclass(frozen=True)
class Course:
    """The motion of a cam's follower, phase by phase."""

    cam: Cam

    @cached_property
    def _starts(self) -> Floats:
        return np.array([one.start for one in self.cam.phases])

    def at(self, turned: Floats, before: bool = False) -> Travel:
        """Give S, S', S'' at turns of the cam from 0 to a whole one, (N,); at a joint after it, or before it."""
        phi = np.asarray(turned, dtype=float)
        own = np.searchsorted(self._starts, phi, side="left" if before else "right") - 1
        found = [np.empty_like(phi) for _ in range(3)]
        for number, phase in enumerate(self.cam.phases):
            here = np.clip(own, 0, None) == number
            for order, values in enumerate(found):
                values[here] = along(phase, phi[here], order, before)
        return Travel(*found)

    @cached_property
    def joints(self) -> tuple[float, ...]:
        """Where a phase or a piece of a law begins or ends, rad, rising from 0 to the whole turn."""
        inner = (
            phase.start + phase.angle * share
            for phase in self.cam.moving()
            for share in (law_of(phase.law).starts if phase.law else ())
        )
        return tuple(sorted({0.0, *inner, *(one.start for one in self.cam.phases), self.cam.turn}))

    @cached_property
    def shocks(self) -> tuple[Shock, ...]:
        """Where S' jumps (жёсткий удар), or S'' with S' whole (мягкий удар)."""
        return tuple(self._shocks())

    def _shocks(self) -> Iterator[Shock]:
        joints = np.array(self.joints[:-1] if not self.cam.translates else self.joints)
        after, before = self.at(joints), self.at(joints, before=True)
        if self.cam.translates:
            before = Travel(*(np.where(joints == 0.0, 0.0, one) for one in before))
            after = Travel(*(np.where(joints == joints[-1], 0.0, one) for one in after))
        else:
            last = self.at(np.array([self.cam.turn]), before=True)
            before = Travel(*(np.concatenate([own, one[1:]]) for own, one in zip(last, before, strict=True)))
        for k, turned in enumerate(joints.tolist()):
            jumps = [float(after[order][k] - before[order][k]) for order in (1, 2)]
            real = [order for order in (1, 2) if abs(jumps[order - 1]) > ROUNDED * self._largest(order)]
            yield from (Shock(turned, order, jumps[order - 1]) for order in real[:1])

    def _largest(self, order: int) -> float:
        """Give the size of S' or S'' over the turn: lift over the angle of a phase, the largest."""
        return max((abs(one.change) / one.angle**order for one in self.cam.moving()), default=0.0)


def along(phase: Phase, turned: Floats, order: int, before: bool = False) -> Floats:
    """Give S or a derivative of it by the cam's turn within one phase, (N,)."""
    if phase.law is None:
        return np.full_like(turned, phase.level if order == 0 else 0.0)
    share = np.clip((turned - phase.start) / phase.angle, 0.0, 1.0)
    value = law_of(phase.law).at(share, order, before)
    return np.asarray((phase.level if order == 0 else 0.0) + phase.change / phase.angle**order * value)


def positions(cam: Cam) -> Floats:
    """Give the turns of the numbered positions, rad: each phase that moves in equal parts, a dwell by its ends."""
    edges = [np.linspace(one.start, one.end, cam.divisions + 1)[:-1] for one in cam.moving()]
    edges += [np.array([one.start]) for one in cam.phases if one.law is None]
    return np.unique(np.concatenate([*edges, *([np.array([cam.turn])] if cam.translates else [])]))
