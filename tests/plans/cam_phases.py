"""Phases of cams one after another, for the tests."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeAlias

from plans.model.cam import DWELL, RETURN, RISE, TURN, Law, Phase

WAYS = {RISE: 1, DWELL: 0, RETURN: -1}  # of the follower
Listed: TypeAlias = tuple[str, float, Law | None]  # kind, angle in degrees, law


def phases(listed: Iterable[Listed], lift: float, whole: float = TURN) -> tuple[Phase, ...]:
    """Give phases that go up and down by the whole lift; 360 degrees are the whole turn, or travel."""
    return parted(((kind, degrees, WAYS[kind] * lift, law) for kind, degrees, law in listed), whole)


def parted(listed: Iterable[tuple[str, float, float, Law | None]], whole: float = TURN) -> tuple[Phase, ...]:
    """Give phases each by its kind, angle in degrees, change of S, law."""
    found: list[Phase] = []
    start = level = 0.0
    for kind, degrees, change, law in listed:
        found.append(Phase(kind, degrees / 360 * whole, start, level, change, law))
        start, level = found[-1].end, level + change
    return tuple(found)
