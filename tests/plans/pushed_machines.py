"""Machines whose drive goes over a stroke, written as scenes: turned, mirrored, enlarged, driven back (ход привода).

A slider whose named point lies off its guide, and a cylinder that turns a crank by a point beside its line.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from math import degrees

from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.scenes import scene

STEPS = 5


@dataclass(frozen=True)
class Picture:
    """How a machine is drawn: turned by rad, mirrored in x before that, every length so many times as large."""

    turn: float = 0.0
    mirrored: bool = False
    size: float = 1.0

    @property
    def sense(self) -> float:
        """The sign of what turns."""
        return -1.0 if self.mirrored else 1.0

    def vector(self, one: complex) -> complex:
        """Give where a vector lies."""
        return self.size * self.unit(one)

    def unit(self, one: complex) -> complex:
        """Give a vector that is no length."""
        return (one.conjugate() if self.mirrored else one) * cmath.rect(1.0, self.turn)

    def place(self, one: complex) -> str:
        """Write a place."""
        x, y = self.vector(one).real, self.vector(one).imag
        return f"[{x!r}, {y!r}]"

    def angle(self, one: complex) -> str:
        """Write the direction of a vector, degrees."""
        return repr(degrees(cmath.phase(self.unit(one))))

    def lean(self, angle: float) -> str:
        """Write an angle from a line, degrees."""
        return repr(self.sense * angle)

    def length(self, one: float, sense: float = 1.0) -> str:
        """Write a length, or a way to the left of a line."""
        return repr(sense * self.size * one)


PLAIN = Picture()


@dataclass(frozen=True)
class Stroke:
    """A stroke: its ends m, its speed and acceleration or its speeds; gone back in time it has the same plans."""

    begin: float
    end: float
    speed: float = 0.3
    acceleration: float = 0.4
    speeds: tuple[float, ...] = ()
    times: float = 1.0  # as fast

    @property
    def back(self) -> Stroke:
        """The same stroke gone back."""
        return Stroke(self.end, self.begin, self.speed, -self.acceleration, self.speeds[::-1], self.times)

    def text(self, picture: Picture) -> str:
        """Write it."""
        ends = f"from = {picture.length(self.begin)}\nto = {picture.length(self.end)}\n"
        if self.speeds:
            return f"{ends}speeds = [{', '.join(picture.length(self.times * one) for one in self.speeds)}]"
        rates = picture.length(self.times * self.speed), picture.length(self.times**2 * self.acceleration)
        return f"{ends}speed = {rates[0]}\nacceleration = {rates[1]}"


GUIDE = cmath.rect(1.0, 0.2)  # the direction of the slider's guide
THROUGH = 0.1 + 0.25j
OFFSET, LEAN = 0.04, 215.0  # m, degrees: of the slider's point and axis from the guide
FOOT = THROUGH + 1j * OFFSET * GUIDE  # of the ways of that point
PUSH = Stroke(0.3, 0.42)
HINGE_OF_CRANK = 0.2 - 0.05j

# A slider HB pushes by the rod HA a crank OA that is braked, and a slider D behind it; masses lie midway between two
# points of their links.
SLIDER = scene(
    frame="O = {O}", links="HB HA OA AD D", lengths="AD = {AD}; HB = {HB}; HA = {HA}; OA = {OA}",
    slides=[
        "link = 5; along = {{ through = {O}, angle = {back} }}",
        'link = 1; point = "B"; along = {{ through = {through}, angle = {guide} }}; offset = {offset}; angle = {lean}',
    ],
    sketch="A = {A}; B = {B}; H = {H}; D = {D}",
)  # fmt: skip
LOADS = scene(
    loads="gravity = {gravity!r}", forces=['on = {on}; point = "{at}"; direction = {direction}; value = {force!r}'],
    moments=['on = {turned}; name = "M_T"; value = {moment!r}'],
)  # fmt: skip
FORCE, MOMENT = 60.0, 7.0  # N, N*m
PULL = cmath.rect(1.0, -2.0)  # the direction of the force


def masses(picture: Picture, *told: tuple[int, float, float]) -> str:
    """Write masses kg and inertias kg*m2 of links, each of a mass midway between its two points."""
    rows = (
        f'{link} = {{ mass = {mass}, inertia = {inertia * picture.size**2!r}, centre = "middle" }}'
        for link, mass, inertia in told
    )
    return "\n".join(["[masses]", *rows])


def loads(picture: Picture, on: int, at: str, turned: int, gravity: float, times: float) -> str:
    """Write the loads: a force, and a moment; `times` as large, as inertia forces are."""
    size = picture.size * times**2
    return LOADS.format(
        gravity=gravity,
        on=on,
        at=at,
        turned=turned,
        direction=picture.angle(PULL),
        force=size * FORCE,
        moment=picture.sense * picture.size * size * MOMENT,
    )


SLIDER_MASSES = ((1, 6.0, 0.02), (2, 4.0, 0.2), (3, 3.0, 0.05))


def slider(picture: Picture = PLAIN, stroke: Stroke = PUSH, gravity: float = 0.0) -> Study:
    """Study the slider that pushes a crank."""
    start = FOOT + stroke.begin * GUIDE
    axis = GUIDE * cmath.rect(1.0, LEAN * cmath.pi / 180)
    text = SLIDER.format(
        **{name: picture.place(at) for name, at in (("O", HINGE_OF_CRANK), ("through", THROUGH), ("B", start))},
        **{
            name: picture.place(at)
            for name, at in (("A", 0.15 + 0.17j), ("D", -0.3 - 0.05j), ("H", start - 0.1 * axis))
        },
        **{name: picture.length(size) for name, size in (("HB", 0.1), ("HA", 0.45), ("AD", 0.5), ("OA", 0.22))},
        guide=picture.angle(GUIDE),
        back=picture.angle(-1.0 + 0j),
        offset=picture.length(OFFSET, picture.sense),
        lean=picture.lean(LEAN),
    )
    rest = (masses(picture, *SLIDER_MASSES), loads(picture, 3, "A", 3, gravity, stroke.times))
    return _study(text, *rest, f"[drive]\nlink = 1\npositions = {STEPS}\n[drive.stroke]\n{stroke.text(picture)}")


# A boom OH that the cylinder EF lifts by a point F beside its line; the cylinder EG moves in the rod FG, or is bare.
BOOM = scene(
    frame="O = {O}; E = {E}", links='1 = ["H", "O", "F"]; {links}',
    lengths="OH = {OH}; OF = {OF}; HF = {HF}; {lengths}", sketch="H = {H}; F = {F}; {sketch}",
)  # fmt: skip
HINGE, FIXED = 0.05 + 0.1j, 0.35 + 0.05j
LIFT = Stroke(0.45, 0.55)
BOOM_MASSES, ROD = (1, 20.0, 0.5), (2, 4.0, 0.1)


def cylinder(picture: Picture = PLAIN, stroke: Stroke = LIFT, gravity: float = 0.0, bare: bool = False) -> Study:
    """Study the boom that a cylinder lifts."""
    rod = picture.length(0.3)
    told = ("", "", "") if bare else ('2 = "FG"\n3 = "E"', f"FG = {rod}", f"G = {picture.place(0.15 + 0.25j)}")
    text = BOOM.format(
        **{name: picture.place(at) for name, at in (("O", HINGE), ("E", FIXED))},
        **{name: picture.place(at) for name, at in (("H", 0.2 + 0.7j), ("F", 0.05 + 0.45j))},
        **{name: picture.length(size) for name, size in (("OH", 0.7), ("OF", 0.4), ("HF", 0.35))},
        **dict(zip(("links", "lengths", "sketch"), told, strict=True)),
    )
    slide = "" if bare else '[[mechanism.slides]]\nlink = 3\nalong = "FG"\n'
    bodies = (BOOM_MASSES,) if bare else (BOOM_MASSES, ROD)
    rest = (slide, masses(picture, *bodies), loads(picture, 1, "H", 1 if bare else 2, gravity, stroke.times))
    drive = f'[drive]\nlink = 1\npositions = {STEPS}\n[drive.stroke]\nbetween = "EF"\n{stroke.text(picture)}'
    return _study(text, *rest, drive)


def _study(*tables: str) -> Study:
    return Study(parse_scene("\n".join(['sheets = ["forces"]', *tables])))
