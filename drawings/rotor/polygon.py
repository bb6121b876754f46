"""A rotor as it is seen, and its polygons of static moments or of their moments (ротор и его многоугольники)."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from drawings.kinds.polygon import RESULT, SIDE, Letters, Polygon, ShownVector, Sizes
from drawings.lettering.rotor_letters import INDEX, lowered
from drawings.page.page import Drafting
from plans.model.rotor import Rotor, RotorBalance
from plans.rotor.balancing import COUPLES
from plans.rotor.balancing import VectorPolygon as Construction

CROWD = 40  # masses: of more the table alone tells them apart


def letters_of(drafting: Drafting) -> Letters:
    """Letter vectors and masses; of many each has the number of its mass alone."""
    return Letters(partial(lowered, language=drafting.language), _number)


def _number(name: str) -> str:
    found = INDEX.search(name)
    return found[1] if found is not None and found[1].isdigit() else ""


SLIM = 5  # times as long as it is thick: a rotor of which no radius is known
NOMINAL = 0.8  # of the largest known radius: where a mass without one is drawn


class ShownBody(NamedTuple):
    """A mass or a counterweight: its name, its centre in a plane across the shaft m, its place along it m.

    One whose radius nothing gives stands at its angle alone; a counterweight is `added`.
    """

    name: str
    centre: complex
    place: float
    arm: float  # m, from the last plane of correction
    added: bool
    known: bool

    @property
    def mark(self) -> str:
        """Its letters: m_1."""
        return f"m_{self.name}"


class RotorView(NamedTuple):
    """A rotor to be seen: its bodies, the planes of correction, the bearings; metres."""

    bodies: tuple[ShownBody, ...]
    planes: tuple[tuple[str, float], ...]  # name and place
    bearings: tuple[float, ...]
    turning: float  # the sense in which it turns: 1, -1, or 0 where it is not given

    @property
    def reach(self) -> float:
        """The largest distance of a centre from the axis, m; 1 where no radius is known."""
        return max((abs(mass.centre) for mass in self.bodies), default=0.0) or 1.0

    @property
    def scaled(self) -> bool:
        """Whether some radius is known, so that the view has a scale."""
        return any(mass.known for mass in self.bodies)

    @property
    def many(self) -> bool:
        """Whether there are too many masses to letter each."""
        return len(self.bodies) > CROWD

    @property
    def distinct(self) -> tuple[ShownBody, ...]:
        """The bodies that are lettered and measured: of too many masses the counterweights alone."""
        return tuple(mass for mass in self.bodies if mass.added or not self.many)

    @property
    def places(self) -> list[float]:
        """All places along the shaft, m."""
        return [*(mass.place for mass in self.bodies), *(place for _, place in self.planes), *self.bearings]


def rotor_view(rotor: Rotor, balance: RotorBalance) -> RotorView:
    """Put masses and counterweights where they are; one that vanishes is left out."""
    radii = [part.radius for parts in (rotor.masses, balance.corrections) for part in parts if part.radius]
    # How far along the shaft the rotor reaches, m; 1 of a thin disc
    places = [*(mass.place for mass in rotor.masses), *(plane.place for plane in rotor.planes), *rotor.bearings]
    nominal = NOMINAL * max(radii, default=(float(max(places) - min(places)) or 1.0) / SLIM)
    bodies = [_body(rotor, mass.name, float(mass.angle), mass.place, mass.radius, nominal) for mass in rotor.masses]
    for weight in balance.corrections:
        if weight.moment.angle is not None:
            name, place = weight.plane.name, weight.plane.place
            bodies.append(_body(rotor, name, weight.moment.angle, place, weight.radius, nominal)._replace(added=True))
    planes = tuple((plane.name, float(plane.place)) for plane in rotor.planes)
    turning = 0.0 if rotor.speed is None else math.copysign(1.0, rotor.speed)
    return RotorView(tuple(bodies), planes, tuple(map(float, rotor.bearings)), turning)


def _body(rotor: Rotor, name: str, angle: float, place: Fraction, radius: float | None, nominal: float) -> ShownBody:
    centre = cmath.rect(radius or nominal, math.radians(angle))
    return ShownBody(name, centre, float(place), rotor.arm(place), False, bool(radius))


SCALES = {COUPLES: ("{mDh}", "kg*m2")}  # letter and unit of the scale
SCALE = ("{mD}", "kg*m")
SIZES = Sizes(14.0, 1.8, 4.7)
SUM = "Σ"  # before the letters of all vectors together, that stand for more than can be told apart


def polygon(construction: Construction, names: frozenset[str], drafting: Drafting) -> Polygon:
    """Read a polygon from its record; `names` are vectors in it that are results themselves."""
    vectors = [
        ShownVector(mark.name, RESULT if mark.name in names else SIDE, complex(start.point), complex(mark.point))
        for mark, start in ((side.vector, side.start) for side in construction.sides)
    ]
    plan = construction.board.subject
    if len(vectors) > CROWD:
        results = [vector for vector in vectors if vector.kind == RESULT]
        end = results[0].at if results else vectors[-1].end
        vectors = [ShownVector(SUM + SCALES.get(plan, SCALE)[0].strip("{}"), SIDE, 0j, end), *results]
    if not construction.closed:
        start = vectors[-1].end if vectors else 0j
        vectors.append(ShownVector(construction.closing.name, RESULT, start, complex(construction.closing.point)))
    title = drafting.word("polygon of moments" if plan == COUPLES else "polygon of static moments")
    scale = SCALES.get(plan, SCALE)
    return Polygon(plan, title, scale, tuple(vectors), construction.closed, letters_of(drafting), SIZES)
