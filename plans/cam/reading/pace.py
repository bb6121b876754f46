"""The speed of a cam and its sense: its own, or those of the drive whose shaft it sits on (скорость кулачка)."""

from __future__ import annotations

from decimal import Decimal
from typing import Protocol, cast

from plans.cam.reading.entry import Entry
from plans.scene import units


class Drive(Protocol):
    """A drive, whatever technique states it."""

    omega: Decimal


class Driven(Protocol):
    """What a scene says of a mechanism with a drive."""

    drive: Drive


def pace_of(entry: Entry) -> tuple[int, float | None]:
    """Give the sense of a cam, +1 counter-clockwise, and its speed, rad/s (m/s of one that translates), or none."""
    kind = units.VELOCITY if entry.translates else units.SPEED
    speed = entry.quantity(entry.form.speed, kind, "speed")
    if speed == 0:
        entry.fault(("speed",), "zero", kind=kind.name)
    if entry.form.speed is None and not entry.translates:
        speed = _of_drive(entry)
    return -1 if speed is not None and speed < 0 else 1, abs(float(speed)) if speed else None


def _of_drive(entry: Entry) -> Decimal | None:
    """Give the speed of the drive, where the scene has one."""
    linkage = entry.scene.part("linkage")
    return cast("Driven", linkage).drive.omega if linkage is not None else None
