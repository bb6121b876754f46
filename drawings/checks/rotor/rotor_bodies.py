"""The bodies of a rotor as its views must show them, by the analysis alone (массы и противовесы на видах)."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.lettering.rotor_letters import lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle
from drawings.paper.walk import groups
from plans.model.rotor import Balance, Correction, Rotor

ACROSS, ALONG = "across", "along"  # the names of the views
FEW, MOST = 9, 40  # of more masses each has its number alone; of more still none has a letter
THICK, NOMINAL = 0.2, 0.8  # of the rotor's length, of the largest radius: where a mass of no known radius stands
DOUBTED = 4.0  # times what rounding can move: one road may find a counterweight there, and the other none


class BodyAtRest(NamedTuple):
    """A mass or a counterweight: centre and place m, arm m; whether its radius is known and it bears a letter."""

    name: str
    centre: complex
    place: float
    arm: float
    added: bool
    known: bool
    distinct: bool
    sure: bool = True  # whether it is more than what rounding may hide

    @property
    def mark(self) -> str:
        """Its letters."""
        return f"m_{self.name}"


def bodies(rotor: Rotor, balance: Balance) -> tuple[BodyAtRest, ...]:
    """Give the masses of a rotor and the counterweights that do not vanish."""
    added = [one for one in balance.corrections if one.moment.angle is not None]
    many = len(rotor.masses) + len(added) > MOST
    radii = [one for one in (*(m.radius for m in rotor.masses), *(c.radius for c in added)) if one]
    nominal = NOMINAL * max(radii, default=THICK * _length(rotor))
    found = []
    for one in rotor.masses:
        centre = cmath.rect(one.radius or nominal, math.radians(float(one.angle)))
        known, arm = bool(one.radius), rotor.arm(one.place)
        found.append(BodyAtRest(one.name, centre, float(one.place), arm, False, known, not many))
    slack = max(one.moment.slack for one in balance.corrections)
    return *found, *(_added(rotor, one, nominal, slack) for one in added)


def _added(rotor: Rotor, one: Correction, nominal: float, slack: float) -> BodyAtRest:
    plane, angle, radius = one.plane, math.radians(one.moment.angle or 0.0), one.radius
    centre, arm = cmath.rect(radius or nominal, angle), rotor.arm(plane.place)
    sure = abs(one.moment.value) > DOUBTED * slack
    return BodyAtRest(plane.name, centre, float(plane.place), arm, True, bool(radius), True, sure)


def _length(rotor: Rotor) -> float:
    """Give how far along the shaft a rotor reaches, m; 1 of a thin disc."""
    places = [*(one.place for one in rotor.masses), *(one.place for one in rotor.planes), *rotor.bearings]
    return float(max(places) - min(places)) or 1.0


def letter(name: str, count: int, drafting: Drafting) -> str:
    """Give the letters of one of so many as they are read: of many the number of its mass alone."""
    own = name.split("_")[1].removesuffix("D")
    return own if count > FEW and own.isdigit() else read(lowered(name, drafting.language))


def origin(strokes: FigureStrokes) -> tuple[float, complex]:
    """Give the scale of a figure, m/mm, and where its pole lies on paper, mm."""
    for one in groups((strokes.group,)):
        if one.data.get("kind") == "pole" and isinstance(one.strokes[0], Circle):
            return float(one.data["scale"]), one.strokes[0].centre
    return 1.0, complex("nan")
