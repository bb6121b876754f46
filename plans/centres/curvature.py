"""Inflection circle of a link and the centre of curvature of a point's path, by Bobillier (круг перегибов, Бобилье).

Of two pins of the link the centres of curvature are known: hinges of the frame, or at infinity square to a guide. The
common tangent of the centrodes makes with one ray the angle that the collineation axis of both makes with the other.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from geometry.board import Mark, at
from geometry.meet import cross
from plans.centres.kennedy import InstantCentre, Kennedy
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Complexes
from plans.words.words import because

ROUND = 720  # places of a circle
ALONG = 1e-6  # sine: rays nearer to one line than this tell no axis


class Pin(NamedTuple):
    """A pin of a link whose path has a known centre: the centre of the frame and of the other link of the pin."""

    point: str
    other: int


class Ray(NamedTuple):
    """A ray from the pole to a pin, and the centre of curvature of the pin's path."""

    pin: Mark
    ray: Mark
    centre: InstantCentre

    @property
    def way(self) -> complex:
        """Its unit direction."""
        vector = at(self.ray.point, 0)
        return vector / abs(vector)


def general(mechanism: Mechanism, point: str) -> int | None:
    """Give the link of a point, that with most pins, if none of its links turns about the frame or slides on it."""
    links = [link for link in mechanism.links if point in mechanism.links[link].points]
    held = [link for link in links if link == FRAME or _centred(mechanism, link)]
    return None if held or not links else max(links, key=lambda link: len(pins(mechanism, link)))


def _centred(mechanism: Mechanism, link: int) -> bool:
    """Tell whether the points of a link have a known centre of curvature: it turns about the frame or slides on it."""
    hinged = any({FRAME, link} <= {*links} for links in mechanism.hinges.values())
    return hinged or any({slide.slider, slide.owner} == {FRAME, link} for slide in mechanism.slides)


def pins(mechanism: Mechanism, link: int) -> tuple[Pin, ...]:
    """Give the pins of a link whose paths have known centres of curvature."""
    found: dict[str, Pin] = {}
    for point in mechanism.links[link].points:
        for other in mechanism.hinges.get(point, ()):
            if other not in (FRAME, link) and _centred(mechanism, other):
                found.setdefault(point, Pin(point, other))
    return tuple(found.values())


class Curvature(NamedTuple):
    """The centre of curvature of a point's path, the radius to it from the point, the lines of the construction."""

    centre: Mark
    radius: Mark
    lines: tuple[tuple[Mark, Mark], ...]


def curvature_plan(point: str) -> str:
    """Name what marks of the curvature of a point's path belong to."""
    return f"curvature-{point}"


def circle_of(pole: complex, end: complex) -> Complexes:
    """Give an inflection circle by places close to each other, from the pole over the inflection pole."""
    return np.asarray(pole + (end - pole) / 2 * (1 - np.exp(1j * np.linspace(0, 2 * np.pi, ROUND + 1))))


class Inflection:
    """The inflection circle of a link in a position: pole, common tangent of the centrodes, inflection pole."""

    def __init__(self, found: Kennedy, link: int, pole: Mark) -> None:
        self.found, self.board, self.pole, self.link = found, found.board, pole, link
        self.lines: list[tuple[Mark, Mark]] = []
        one, two = self.rays = tuple(self._ray(pin) for pin in pins(found.plan.mechanism, link)[:2])
        self.axis = self._axis(one, two)
        self.tangent = self.board.similar(f"t_{link}", one.ray, self.axis, two.ray, why=because("bobillier_tangent"))
        self.inflection = self._pole(self._across(at(self.tangent.point, 0)))
        self.lines += [(pole, self.inflection), *((pole, ray.pin) for ray in self.rays)]
        self.diameter = self.board.join(f"δ_{link}", pole, self.inflection)

    @classmethod
    def of(cls, found: Kennedy, link: int) -> Inflection | None:
        """Draw it, if the link has a pole in the position that neither is a pin of it nor in one line with both."""
        pole = found.of(FRAME, link)
        if pole is None or pole.infinite:
            return None
        ways = [at(found.plan.point(pin.point).point, 0) - pole.place for pin in pins(found.plan.mechanism, link)[:2]]
        least = ALONG * found.size
        blunt = any(abs(way) < least for way in ways) or abs(float(cross(*ways))) < ALONG * abs(ways[0] * ways[1])
        return None if blunt else cls(found, link, pole.mark)

    def _ray(self, pin: Pin) -> Ray:
        mark, centre = self.found.plan.point(pin.point), self.found.of(FRAME, pin.other)
        assert centre is not None  # a hinge or a slide of the frame
        return Ray(mark, self.board.join(f"{self.pole.name}{pin.point}", self.pole, mark), centre)

    def _axis(self, one: Ray, two: Ray) -> Mark:
        """Draw the collineation axis: from the pole to where the line of the pins meets that of their centres."""
        pinned = self.board.join(f"{one.pin.name}{two.pin.name}", one.pin, two.pin)
        first, second = sorted((one.centre, two.centre), key=lambda centre: centre.infinite)
        if first.infinite:
            return pinned
        name = f"{first.mark.name}{second.mark.name}"
        along = second.mark if second.infinite else self.board.join(name, first.mark, second.mark)
        through = self.board.parallel(name, first.mark, along)
        met = self.board.meet("Q", self._line(one.pin, pinned), through, why=because("collineation"))
        self.lines += [(self.pole, met), (one.pin, met), (first.mark, met)]
        return self.board.join(f"{self.pole.name}Q", self.pole, met)

    def _line(self, start: Mark, along: Mark) -> Mark:
        return self.board.parallel(along.name, start, along)

    def _across(self, way: complex) -> Ray:
        """Choose the ray that is most square to a direction."""
        return max(self.rays, key=lambda ray: abs(float(cross(ray.way, way))))

    def _pole(self, ray: Ray) -> Mark:
        """Draw the inflection pole: on the normal of the centrodes, and square to a ray in its inflection point."""
        point = ray.pin
        if not ray.centre.infinite:
            name = f"J_{ray.pin.name}"
            back = self.board.join(f"{ray.pin.name}{self.pole.name}", ray.pin, self.pole)
            radius = self.board.join(f"{ray.pin.name}{ray.centre.mark.name}", ray.pin, ray.centre.mark)
            way = self.board.similar(f"{ray.pin.name}{name}", back, radius, back, why=because("euler_savary"))
            point = self.board.lay_off(name, ray.pin, way, because("inflection_point", point=ray.pin.name))
        normal = self.board.square("n", self.pole, self.tangent, because("inflection_normal"))
        across = self.board.square(f"⊥{point.name}", point, ray.ray, because("inflection_angle"))
        end = self.board.meet(f"W_{self.link}", normal, across, why=because("inflection_pole", link=self.link))
        self.lines += [(point, end), *([] if point is ray.pin else [(ray.pin, point)])]
        return end

    def centre(self, name: str) -> Curvature | None:
        """Draw the centre of curvature of a point's path, and the radius to it from the point."""
        point = self.found.plan.point(name)
        ray = self.board.join(f"{self.pole.name}{name}", self.pole, point)
        way = at(ray.point, 0)
        if abs(way) < ALONG * self.found.size:
            return None
        by = self._across(way / abs(way))
        axis = self.board.similar(f"q_{name}", by.ray, self.tangent, ray, why=because("bobillier_axis", point=name))
        joined = self._line(by.pin, self.board.join(f"{by.pin.name}{name}", by.pin, point))
        met = self.board.meet(f"Q_{name}", self._line(self.pole, axis), joined, why=because("collineation"))
        far, centre = by.centre.infinite, by.centre.mark
        start = met if far else centre
        along = centre if far else self.board.join(f"{start.name}{met.name}", start, met)
        why = because("curvature", point=name)
        found = self.board.meet(f"O_{name}", self._line(self.pole, ray), self._line(start, along), why=why)
        lines = (self.pole, met), (by.pin, met), (point, met), (self.pole, found), (start, found)
        return Curvature(found, self.board.join(f"ρ_{name}", point, found), lines)
