"""The table of a cam's sizes, extremes and shocks read back: every row, every cell to its last digit (таблица)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks import reading
from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_units import BARE
from drawings.checks.documents_old import ruled
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.linkage import by_hand
from drawings.checks.precise import KNOWN
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, within
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups
from geometry import draughtsman, hand_error
from plans.checks.comparison import Finding
from plans.checks.hand.cam import cam_by_hand, readings
from plans.model.cam import RETURN, RISE, Cam
from plans.model.cam_motion import BEND, SLOPE, CamFound, Shock

NAME = "sizes"
DIGITS = 5  # of a value
MM = 1000.0
LAST = 1e-12  # of a size: what is less is written as 0


class Row(NamedTuple):
    """A row of the table: its letter and unit, its value, whether the scene gives it, the word for a place."""

    letter: str
    unit: str
    true: float
    given: bool = False
    place: str = ""

    def title(self, drafting: Drafting) -> str:
        """Write its first cell as it is read."""
        letter = drafting.letter(self.letter)
        name = drafting.word(self.place, letter=letter) if self.place else letter
        return read(f"{name}, {drafting.word(self.unit)}" if self.unit else name)


def results(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table back: on the sheet that bears it all its rows and no other."""
    parts = [one for one in groups(leaf.groups) if one.name.removeprefix(f"{NAME}-").isdigit()]
    if not parts:
        if leaf.metadata["of"] == 1:
            yield within("missing_from", NAME, name="R_0")
        return
    due = {one.title(drafting): one for one in rows(expected)}
    told = _told(leaf, expected) if any(readings(expected.drawing)) else None
    heads = [read(drafting.word(key)) for key in (by_hand.HEADS if told else by_hand.HEADS[:-1])]
    for part in parts:
        yield from ruled.faults(part, NAME, heads)
    seen: list[str] = []
    for cells in ([text.plain for text in row] for part in parts for row in _rows(part)):
        if cells == heads:
            continue
        name, *values = cells
        seen.append(name)
        if name not in due:
            yield within("stranger_in", NAME, text=name)
        else:
            yield from _cells(due[name], name, values[:2], drafting)
            if not _is_hand(due[name], values, told):
                yield within("cell", NAME, name=name, text=values[-1])
    if seen != [name for name in due if name in seen]:
        yield within("row", NAME, name=seen[0])
    yield from (within("missing_from", NAME, name=name) for name in due if name not in seen)


def _told(leaf: Leaf, expected: Expected) -> by_hand.Told:
    """Give what a hand may be out in the sizes at the scale of their diagram."""
    scales = leaf.metadata["scales"]
    return by_hand.Told(
        *(cam_by_hand(expected.drawing, scales, one) for one in (hand_error.slopes, draughtsman.slopes))
    )


def _is_hand(row: Row, values: Sequence[str], told: by_hand.Told | None) -> bool:
    """Tell whether the third cell says what a hand may be out, or nothing of what is given or is a place."""
    if told is None:
        return len(values) == 2
    largest = abs(row.true) or 1.0
    value = np.array([row.true])
    finding = Finding(NAME, row.letter, row.unit, value, value, 0 * value, 0 * value, largest)
    error = math.nan if row.given or row.place else told.of(finding, 0)
    return len(values) == 3 and by_hand.holds(values[2], error, largest)


def _rows(part: Group) -> list[list[Text]]:
    return list(reading.rows(part))


def _cells(row: Row, name: str, values: list[str], drafting: Drafting) -> Iterator[Wrong]:
    """Hold by plan and by analysis, or that it is given."""
    numbers = values[:1] if row.given else values[:2]
    if len(values) != 2 or (row.given and values[1] != drafting.word("cam given")):
        yield within("row", NAME, name=name)
        return
    for text in numbers:
        if not (text == "—" and math.isnan(row.true)) and not _holds(text, row.true):
            yield within("cell", NAME, name=name, text=text)


def _holds(text: str, true: float) -> bool:
    """Tell whether a cell says a value to its five digits; what is nothing beside 1 is 0."""
    value = reading.value(text)
    if value == 0.0:
        return abs(true) <= LAST
    return reads(text, true, KNOWN * abs(true), DIGITS)


def rows(expected: Expected) -> Iterator[Row]:
    """Give the rows that there must be, in their order."""
    found = expected.found
    yield from _sizes(found)
    yield from _extremes(found)
    yield from _motion(found)
    for k, one in enumerate(found.shocks, 1):
        yield from _shock(found.cam, one, k)


def _sizes(found: CamFound) -> Iterator[Row]:
    cam, own = found.cam, found.sizes
    if not cam.translates:
        yield Row("R_0", "mm", MM * own.base, cam.given.base is not None)
    if not (cam.translates or cam.rocks or cam.flat):
        yield Row("e", "mm", MM * own.offset, cam.given.offset is not None)
        yield Row("S_0", "mm", MM * math.sqrt((own.base - own.offset) * (own.base + own.offset)))
    if cam.rocks:
        yield Row("L", "mm", MM * own.centre, cam.given.centre is not None)
        yield Row("ψ_0", "°", math.degrees(own.initial))
    if found.roller:
        yield Row("r_{rol}", "mm", MM * found.roller, cam.roller is not None)
    yield Row("Ψ", "°", math.degrees(cam.lift), True) if cam.rocks else Row("H", "mm", MM * cam.lift, True)


def _extremes(found: CamFound) -> Iterator[Row]:
    cam = found.cam
    radii = [("ρ_{min}", found.sharpest), ("ρ_{hol}", found.hollow)]
    for letter, one in radii:
        if one is not None:
            yield Row(letter, "mm", MM * one.value)
            yield _place(cam, letter, one.turned)
    if cam.flat:
        yield from (Row(f"b_{k}", "mm", MM * abs(far)) for k, far in enumerate(found.face, 1))
    for kind in (RISE, RETURN):
        if kind in found.pressure and (cam.rocks or not cam.flat):
            yield Row(f"α_{{{kind}}}", "°", math.degrees(found.pressure[kind].value))
            yield _place(cam, f"α_{{{kind}}}", found.pressure[kind].turned)


def _place(cam: Cam, letter: str, turned: float) -> Row:
    if cam.translates:
        return Row(letter, "mm", MM * turned, place="cam travel at")
    return Row(letter, "°", math.degrees(turned), place="cam angle at")


def _motion(found: CamFound) -> Iterator[Row]:
    """Give the largest velocity and acceleration; at a hard shock the acceleration has no largest value."""
    cam = found.cam
    if cam.speed is None:
        return
    velocity, acceleration = (("ω", "rad/s"), ("ε", "rad/s2")) if cam.rocks else (("v", "m/s"), ("a", "m/s2"))
    yield Row(f"{velocity[0]}_{{max}}", velocity[1], abs(found.peaks[SLOPE].value) * cam.speed)
    if all(one.order != 1 for one in found.shocks):
        yield Row(f"{acceleration[0]}_{{max}}", acceleration[1], abs(found.peaks[BEND].value) * cam.speed**2)


def _shock(cam: Cam, one: Shock, k: int) -> Iterator[Row]:
    way, units = (("ω", "ε"), ("rad/s", "rad/s2")) if cam.rocks else (("v", "a"), ("m/s", "m/s2"))
    if cam.speed is None:
        way, units = ("ψ'", "ψ''") if cam.rocks else ("S'", "S''"), BARE[cam.rocks, cam.translates]
    letter = f"Δ{way[one.order - 1]}_{{{k}}}"
    yield Row(letter, units[one.order - 1], one.jump * (cam.speed or 1.0) ** one.order)
    yield _place(cam, letter, one.turned)
