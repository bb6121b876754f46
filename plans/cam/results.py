"""What one road found of a cam as its table tells it: sizes, radii, angles, peaks, shocks (результаты)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from plans.cam.sizing import RATIO, dimensions
from plans.model.cam import MM, RETURN, RISE, Cam
from plans.model.cam_motion import CamFound, Shock


class Result(NamedTuple):
    """A row of the table by one road: its letters, its unit, its value in that unit; whether the scene gives it."""

    letter: str
    unit: str
    value: float
    given: bool = False
    where: str = ""  # the word for the place of a value, of one that is a place


def results(found: CamFound) -> tuple[Result, ...]:
    """List what one road found."""
    return (*_sizes(found), *_curvature(found), *_pressure(found), *_motion(found), *_shocks(found))


def _sizes(found: CamFound) -> Iterator[Result]:
    cam, own = found.cam, found.sizes
    if not cam.translates:
        yield Result("R_0", "mm", MM * own.base, cam.given.base is not None)
    if not (cam.rocks or cam.flat or cam.translates):
        yield Result("e", "mm", MM * own.offset, cam.given.offset is not None)
        yield Result("S_0", "mm", MM * math.sqrt(own.base**2 - own.offset**2))
    if cam.rocks:
        yield Result("L", "mm", MM * own.centre, cam.given.centre is not None)
        yield Result("ψ_0", "°", math.degrees(own.initial))
    if found.roller:
        yield Result("r_{rol}", "mm", MM * found.roller, cam.roller is not None)
    yield Result("Ψ", "°", math.degrees(cam.lift), True) if cam.rocks else Result("H", "mm", MM * cam.lift, True)


def _curvature(found: CamFound) -> Iterator[Result]:
    """Give the least radii of curvature of the pitch curve, convex and hollow; the breadth of a face."""
    for letter, one in (("ρ_{min}", found.sharpest), ("ρ_{hol}", found.hollow)):
        if one is not None:
            yield Result(letter, "mm", MM * one.value)
            yield _where(found.cam, letter, one.turned)
    if found.cam.flat:
        yield from (Result(f"b_{side + 1}", "mm", MM * abs(far)) for side, far in enumerate(found.face))


def _pressure(found: CamFound) -> Iterator[Result]:
    """Give the largest pressure angles; under a flat face that does not rock there is none."""
    for kind in () if found.cam.flat and not found.cam.rocks else (RISE, RETURN):
        if kind in found.pressure:
            letter = f"α_{{{kind}}}"
            yield Result(letter, "°", math.degrees(found.pressure[kind].value))
            yield _where(found.cam, letter, found.pressure[kind].turned)


def _where(cam: Cam, letter: str, turned: float) -> Result:
    """Give the place of a value: the cam's turn in degrees, or its travel in millimetres."""
    if cam.translates:
        return Result(letter, "mm", MM * turned, where="cam travel at")
    return Result(letter, "°", math.degrees(turned), where="cam angle at")


def _motion(found: CamFound) -> Iterator[Result]:
    """Give the follower's largest velocity and acceleration; at a hard shock the acceleration has no largest value."""
    if found.cam.speed is not None:
        letters = ("ω_{max}", "ε_{max}") if found.cam.rocks else ("v_{max}", "a_{max}")
        for order, peak in enumerate(found.peaks.values(), 1):
            yield Result(letters[order - 1], _units(found.cam)[order - 1], abs(peak.value) * found.cam.speed**order)


def _shocks(found: CamFound) -> Iterator[Result]:
    """Give the shocks, each by its jump: of the velocity a hard one, of the acceleration a soft one."""
    for number, one in enumerate(found.shocks):
        letter = f"Δ{_jumps(found.cam, one)}_{{{number + 1}}}"
        yield Result(letter, _unit(found.cam, one), one.jump * (found.cam.speed or 1.0) ** one.order)
        yield _where(found.cam, letter, one.turned)


def _jumps(cam: Cam, shock: Shock) -> str:
    """Name what jumps."""
    if cam.speed is None:
        return ("ψ" if cam.rocks else "S") + "'" * shock.order
    return ("ωε" if cam.rocks else "va")[shock.order - 1]


def _unit(cam: Cam, shock: Shock) -> str:
    if cam.speed is None:
        bare = dimensions(cam)[shock.order]
        return "" if bare == RATIO else bare
    return _units(cam)[shock.order - 1]


def _units(cam: Cam) -> tuple[str, str]:
    """Give the units of velocity and acceleration."""
    return ("rad/s", "rad/s2") if cam.rocks else ("m/s", "m/s2")
