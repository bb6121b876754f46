"""Studies of mechanisms that no scene file describes: the drive's positions are given beside the mechanism."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal
from types import SimpleNamespace
from typing import Any, cast

import numpy as np

from plans.linkage.plan import Plan
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Mechanism
from plans.scene.scene import Scene

Angle = int | float | str | Decimal  # degrees, exactly as they are given


def study_of(mechanism: Mechanism, first: Angle | None = 0, positions: int | Sequence[Angle] = 12) -> LinkageStudy:
    """LinkageStudy a mechanism from a first crank angle, degrees; None starts it at its output's extreme position."""
    start = None if first is None else Decimal(first)
    wanted: int | tuple[Decimal, ...] = positions if isinstance(positions, int) else tuple(map(Decimal, positions))
    if isinstance(wanted, tuple):
        start = wanted[0]
    drive = SimpleNamespace(first=start, positions=wanted)
    table = SimpleNamespace(sketch=mechanism.sketch)
    form = SimpleNamespace(drive=drive, mechanism=table)
    scene = SimpleNamespace(file="by hand", sheets=(), of=lambda kind: form, place=lambda path: (1, 1))
    study = LinkageStudy(cast(Scene, scene))
    study.__dict__["mechanism"] = mechanism
    return study


def plans_at(mechanism: Mechanism, degrees: Angle) -> tuple[Plan, Plan, Plan]:
    """Draw positions, velocities and accelerations at one crank angle."""
    drafts = study_of(mechanism, degrees, 1).drafts()
    return drafts.positions, drafts.velocities, drafts.accelerations


def shown(plan: Plan, name: str) -> complex:
    """Read a mark by its name, at the first position."""
    return value(plan.board[name].point)


def value(number: Any) -> complex:
    """Give the one value, or the first of many."""
    return complex(np.ravel(number)[0])


def driven(mechanism: Mechanism, omega: float, epsilon: float) -> Mechanism:
    """Give a mechanism another drive."""
    return replace(mechanism, drive=mechanism.drive._replace(omega=omega, epsilon=epsilon))
