"""The table of a cam's main sizes, extremes and shocks: what both roads found (таблица размеров кулачка)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import BY_HAND, row_by_hand
from drawings.page.drafting import Drafting
from drawings.report.cam_letters import ACCELERATION, VELOCITY, letters, units
from plans.cam.dimensions import RATIO
from plans.checks.comparison import Finding
from plans.model.cam import RETURN, RISE, Cam
from plans.model.cam_motion import CamFound, Shock

NAME = "sizes"
MM = 1000.0  # of a metre
NOTHING = "—"


class Quantity(NamedTuple):
    """A row of the table by one road: its letters, its unit, its value in that unit; whether the scene gives it."""

    letter: str
    unit: str
    value: float
    given: bool = False
    where: str = ""  # the word for the place of a value, of one that is a place


def quantities(found: CamFound) -> tuple[Quantity, ...]:
    """List what one road found."""
    return (*_sizes(found), *_curvature(found), *_pressure(found), *_motion(found), *_shocks(found))


def sizes(own: tuple[Quantity, ...], exact: tuple[Quantity, ...], by_hand: bool, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, and what a hand may be out; of what is given that it is.

    Without `by_hand` nothing is read off a construction in which a hand might err.
    """
    heads = tuple(drafting.word(key) for key in (BY_HAND if by_hand else BY_HAND[:-1]))
    lines = [_line(one, other, drafting) for one, other in zip(own, exact, strict=True)]
    lines = [line._replace(cells=line.cells[: len(heads)]) for line in lines]
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=NAME)


def title(one: Quantity, drafting: Drafting) -> str:
    """Write the name of a row."""
    letter = drafting.letter(one.letter)
    named = drafting.word(one.where, letter=letter) if one.where else letter
    return f"{named}, {drafting.word(one.unit)}" if one.unit else named


def _line(own: Quantity, exact: Quantity, drafting: Drafting) -> TableRow:
    name = title(own, drafting)
    values = np.array([own.value]), np.array([exact.value])
    largest = float(np.abs(values[1]).max()) or 1.0
    finding = Finding(NAME, own.letter, own.unit, *values, abs(values[0] - values[1]), np.zeros(1), largest)
    line = row_by_hand(finding, name, (0,), drafting.language)
    if own.given:
        return TableRow(name, (line.cells[0], drafting.word("cam given"), NOTHING))
    return line._replace(cells=(*line.cells[:-1], NOTHING)) if own.where else line


def _sizes(found: CamFound) -> Iterator[Quantity]:
    cam, own = found.cam, found.sizes
    if not cam.translates:
        yield Quantity("R_0", "mm", MM * own.base, cam.given.base is not None)
    if not (cam.rocks or cam.flat or cam.translates):
        yield Quantity("e", "mm", MM * own.offset, cam.given.offset is not None)
        yield Quantity("S_0", "mm", MM * math.sqrt(own.base**2 - own.offset**2))
    if cam.rocks:
        yield Quantity("L", "mm", MM * own.centre, cam.given.centre is not None)
        yield Quantity("ψ_0", "°", math.degrees(own.initial))
    if found.roller:
        yield Quantity("r_{rol}", "mm", MM * found.roller, cam.roller is not None)
    yield Quantity("Ψ", "°", math.degrees(cam.lift), True) if cam.rocks else Quantity("H", "mm", MM * cam.lift, True)


def _curvature(found: CamFound) -> Iterator[Quantity]:
    """Give the least radii of curvature of the pitch curve, convex and hollow; the breadth of a face."""
    for letter, one in (("ρ_{min}", found.sharpest), ("ρ_{hol}", found.hollow)):
        if one is not None:
            yield Quantity(letter, "mm", MM * one.value)
            yield _where(found.cam, letter, one.turned)
    if found.cam.flat:
        yield from (Quantity(f"b_{side + 1}", "mm", MM * abs(far)) for side, far in enumerate(found.face))


def _pressure(found: CamFound) -> Iterator[Quantity]:
    """Give the largest pressure angles; under a flat face that does not rock there is none."""
    for kind in () if found.cam.flat and not found.cam.rocks else (RISE, RETURN):
        if kind in found.pressure:
            letter = f"α_{{{kind}}}"
            yield Quantity(letter, "°", math.degrees(found.pressure[kind].value))
            yield _where(found.cam, letter, found.pressure[kind].turned)


def _where(cam: Cam, letter: str, turned: float) -> Quantity:
    """Give the place of a value: the cam's turn in degrees, or its travel in millimetres."""
    if cam.translates:
        return Quantity(letter, "mm", MM * turned, where="cam travel at")
    return Quantity(letter, "°", math.degrees(turned), where="cam angle at")


def _motion(found: CamFound) -> Iterator[Quantity]:
    """Give the follower's largest velocity and acceleration; at a hard shock the acceleration has no largest value."""
    if found.cam.speed is not None:
        letters = ("ω_{max}", "ε_{max}") if found.cam.rocks else ("v_{max}", "a_{max}")
        for order, peak in enumerate(found.peaks.values(), 1):
            yield Quantity(letters[order - 1], _units(found.cam)[order - 1], abs(peak.value) * found.cam.speed**order)


def _shocks(found: CamFound) -> Iterator[Quantity]:
    """Give the shocks, each by its jump: of the velocity a hard one, of the acceleration a soft one."""
    for number, one in enumerate(found.shocks):
        letter = f"Δ{_jumps(found.cam, one)}_{{{number + 1}}}"
        yield Quantity(letter, _unit(found.cam, one), one.jump * (found.cam.speed or 1.0) ** one.order)
        yield _where(found.cam, letter, one.turned)


def _jumps(cam: Cam, shock: Shock) -> str:
    """Name what jumps."""
    if cam.speed is None:
        return letters(cam)[0] + "'" * shock.order
    return ("ωε" if cam.rocks else "va")[shock.order - 1]


def _unit(cam: Cam, shock: Shock) -> str:
    if cam.speed is None:
        bare = units(cam)[VELOCITY if shock.order == 1 else ACCELERATION]
        return "" if bare == RATIO else bare
    return _units(cam)[shock.order - 1]


def _units(cam: Cam) -> tuple[str, str]:
    """Give the units of velocity and acceleration."""
    return ("rad/s", "rad/s2") if cam.rocks else ("m/s", "m/s2")
