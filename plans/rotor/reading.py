"""The form of a rotor, and the rotor made from the scene with its faults and its notes (ротор по исходным данным)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from plans.model.rotor import GRADES, Plane, Rotor, Unbalance, letters, nearest_grade
from plans.rotor.balancing import balancing
from plans.scene import fields as f
from plans.scene import units
from plans.scene.faults import Fault, Path, Wrong, wrong
from plans.scene.forms import Form
from plans.scene.notes import HUNDREDS, odd_lengths
from plans.scene.readers import Check, FieldReader, many
from plans.scene.scene import Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.scene.units import WORKING
from plans.words.words import ALONE, message

MOMENT, HEAVY = f.not_negative(units.STATIC_MOMENT), f.positive(units.MASS)
PLANES_LIMIT = 2  # a rotor needs no more
BEARINGS = "[A, B]"
# A line that would do for an unbalanced mass.
EXAMPLE = '[[rotor.masses]] with mass = "0.8 kg", radius = "120 mm", angle = 20, place = "100 mm"'


class UnbalanceTable(Table):
    """An unbalanced mass: mass kg and radius m, or static moment kg*m; angle in degrees, place along the shaft m."""

    mass: Decimal | None = key(f.MASS, None, meaning="Mass, kg.", missing=Missing("mass", 'mass = "0.8 kg"'))
    radius: Decimal | None = key(
        f.LENGTH, None, meaning="Distance of the mass from the axis, m.", missing=Missing("radius", 'radius = "120 mm"')
    )
    moment: Decimal | None = key(
        MOMENT, None, meaning='Static moment m·D instead of mass and radius, kg*m or text as "96 g*m".'
    )
    angle: Decimal = key(
        f.ANGLE,
        meaning="Where the mass is, degrees counter-clockwise from any line of the rotor.",
        missing=Missing("angle", "angle = 20"),
        also=("phase", "phi", "φ"),
    )
    place: Decimal = key(
        f.COORDINATE,
        Decimal(0),
        meaning="Place along the shaft, m; required beside two planes.",
        missing=Missing("place along the shaft", 'place = "100 mm"'),
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that the static moment is given in one way, and wholly."""
        for name in ("mass", "radius"):
            if "moment" not in value and name not in value:
                yield wrong("missing", at=(name,))
            if "moment" in value and name in value:
                yield wrong("one_of_two", first=name, second="moment", found="both", at=(name,))

    @classmethod
    def rules(cls) -> Form:
        """Say that the static moment is given in one way, and wholly."""
        neither = {"not": {"anyOf": [{"required": ["mass"]}, {"required": ["radius"]}]}}
        return {"oneOf": [{"required": ["moment"], **neither}, {"required": ["mass", "radius"]}]}


class PlaneTable(Table):
    """A plane of correction: its place along the shaft m, and the radius m or the mass kg of what is put there."""

    place: Decimal = key(
        f.COORDINATE,
        Decimal(0),
        meaning="Place along the shaft, m; required of two planes.",
        missing=Missing("place along the shaft", 'place = "500 mm"'),
    )
    radius: Decimal | None = key(f.LENGTH, None, meaning="Radius of the counterweight, m; its mass is found.")
    mass: Decimal | None = key(HEAVY, None, meaning="Mass of the counterweight, kg; its radius is found.")

    def check(self) -> None:
        """See that one of radius and mass is left to be found."""
        if {"radius", "mass"} <= self.given:
            raise wrong("one_of_two", first="radius", second="mass", found="both", at=("mass",))

    @classmethod
    def rules(cls) -> Form:
        """Say that one of radius and mass is left to be found."""
        return {"not": {"required": ["radius", "mass"]}}


def _check_planes(planes: tuple[PlaneTable, ...]) -> None:
    """See that there are no more planes than a rotor needs, and that they are apart."""
    if len(planes) > PLANES_LIMIT:
        raise wrong("planes", found=len(planes), at=(PLANES_LIMIT,))
    if len(planes) == PLANES_LIMIT and planes[0].place == planes[1].place:
        raise wrong("one_place", place=f"{planes[0].place:f}", at=(1, "place"))


def _check_apart(places: tuple[Decimal, ...]) -> None:
    if places[0] == places[1]:
        raise wrong("one_place", place=f"{places[0]:f}", at=(1,))


def _bearings() -> FieldReader:
    two = Check(partial(f.check_pair, what=BEARINGS), least=2, most=2)
    return many(f.COORDINATE, Check(_check_apart, unique=True), first=two)._replace(shown=f"{BEARINGS} m")


def _likely_grade(value: object) -> str:
    """Give the grade that a text or a number is likely to mean: that of the same digits, else the nearest."""
    found = re.search(r"\d+(?:[.,]\d+)?", str(value))
    if not found or isinstance(value, bool):
        return ""
    same = (grade for grade in map(letters, GRADES) if re.sub(r"\D", "", grade) == re.sub(r"\D", "", found[0]))
    return next(same, letters(nearest_grade(float(found[0].replace(",", ".")))))


def _entries(value: Mapping[str, Any], name: str) -> list[Any]:
    found = value.get(name)
    return found if isinstance(found, list) else []


def _unplaced(value: Mapping[str, Any], name: str) -> Iterator[int]:
    """Give the numbers of the tables in a list that have no place."""
    return (at for at, entry in enumerate(_entries(value, name)) if isinstance(entry, dict) and "place" not in entry)


class RotorTable(Table):
    """A rotor: its unbalanced masses, where it may be corrected, its bearings, speed, mass, and the grade asked."""

    masses: tuple[UnbalanceTable, ...] = key(
        many(table(UnbalanceTable), f.NOT_EMPTY, first=f.FEW),
        meaning="Unbalanced masses (неуравновешенные массы), any number of them.",
        missing=Missing("list of unbalanced masses", EXAMPLE, [{"moment": 0, "angle": 0, "place": 0}]),
    )
    planes: tuple[PlaneTable, ...] = key(
        many(table(PlaneTable), Check(_check_planes, most=PLANES_LIMIT), first=f.FEW),
        (),
        meaning="Planes of correction (плоскости коррекции): I and II, or one for static balancing alone.",
    )
    bearings: tuple[Decimal, ...] = key(
        _bearings(), (), meaning="Places of two bearings along the shaft, m; with a speed their reactions are found."
    )
    speed: Decimal | None = key(
        f.ANGULAR_SPEED,
        None,
        meaning='Angular speed, rad/s or "3000 rpm"; negative is clockwise.',
        missing=Missing("angular speed", 'speed = "3000 rpm"'),
        also=("rpm", "n", "omega", "ω"),
    )
    mass: Decimal | None = key(
        HEAVY, None, meaning="Mass of the whole rotor, kg.", missing=Missing("mass", 'mass = "20 kg"')
    )
    grade: str | None = key(
        f.words(*map(letters, GRADES), likely=_likely_grade),
        None,
        meaning="Balance quality grade asked, ISO 21940-11; needs speed and mass.",
    )

    def check(self) -> None:
        """See that it turns."""
        if self.speed == 0:
            raise wrong("zero", kind="angular speed", at=("speed",))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that a grade has what it needs, and that with two planes each thing has its place."""
        if "grade" in value:
            lacking = (name for name in ("speed", "mass") if name not in value)
            yield from (wrong("missing", at=(name,), why=message("why.grade")) for name in lacking)
        if len(_entries(value, "planes")) == PLANES_LIMIT:
            unplaced = ((name, place) for name in ("masses", "planes") for place in _unplaced(value, name))
            yield from (wrong("missing", at=(*at, "place"), why=message("why.planes")) for at in unplaced)

    @classmethod
    def rules(cls) -> Form:
        """Say that it turns, that a grade needs speed and mass, and that with two planes each thing has its place."""
        placed = {"items": {"required": ["place"]}}
        return {
            "dependentRequired": {"grade": ["speed", "mass"]},
            "not": {"properties": {"speed": {"const": 0}}, "required": ["speed"]},
            "if": {"properties": {"planes": {"minItems": PLANES_LIMIT}}, "required": ["planes"]},
            "then": {"properties": {"masses": placed, "planes": placed}},
        }


class RotorForm(TechniqueForm):
    """What a scene says of balancing a rotor."""

    rotor: RotorTable = key(
        table(RotorTable),
        meaning="A rotor to be balanced (ротор): masses, planes of correction, bearings, speed.",
        missing=Missing("table", EXAMPLE, {}),
    )


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's rotor."""
    rotor = scene.of(RotorForm).rotor
    yield from odd_lengths(scene, dict(_lengths(rotor)))
    for notes in (_planes, _mass, _unused):
        yield from notes(scene, rotor)


def _lengths(rotor: RotorTable) -> Iterator[tuple[Path, Decimal]]:
    """Give the lengths m that a scene states: radii and places; a zero is one in any unit."""
    given: list[tuple[Path, UnbalanceTable | PlaneTable]] = []
    given += [(("rotor", "masses", index), mass) for index, mass in enumerate(rotor.masses)]
    given += [(("rotor", "planes", index), plane) for index, plane in enumerate(rotor.planes)]
    stated = [((*path, name), size) for path, p in given for name, size in (("radius", p.radius), ("place", p.place))]
    stated += [(("rotor", "bearings", index), place) for index, place in enumerate(rotor.bearings)]
    return ((path, abs(size)) for path, size in stated if size)


def _planes(scene: Scene, rotor: RotorTable) -> Iterator[Fault]:
    """Find that one plane leaves a couple, and two so near each other that the counterweights are many times a mass."""
    path: Path = ("rotor", "planes") if rotor.planes else ("rotor",)
    if len(rotor.planes) < PLANES_LIMIT:
        if not balancing(rotor_of(rotor)).moments.closed:
            yield scene.fault(path, "static_only")
        return
    first, last = (plane.place for plane in rotor.planes)
    apart, far = abs(first - last), max(abs(mass.place - last) for mass in rotor.masses)
    if far > HUNDREDS * apart:
        yield scene.fault(path, "near_planes", apart=f"{apart:.4g}", ratio=f"{far / apart:.3g}")


def _mass(scene: Scene, rotor: RotorTable) -> Iterator[Fault]:
    """Find a rotor that is lighter than the masses on it."""
    masses = sum((mass.mass for mass in rotor.masses if mass.mass), Decimal(0))
    if rotor.mass is not None and rotor.mass < masses:
        yield scene.fault(("rotor", "mass"), "light_rotor", masses=f"{masses:.4g}")


def _unused(scene: Scene, rotor: RotorTable) -> Iterator[Fault]:
    """Find what nothing is found from: a speed alone, or bearings or a mass without a speed."""
    if rotor.speed is None:
        yield from (scene.fault(("rotor", n), f"still_{n}") for n in ("bearings", "mass") if n in rotor.given)
    elif not rotor.bearings and rotor.mass is None:
        yield scene.fault(("rotor", "speed"), "spare_speed")


NUMERALS = ("I", "II")  # the names of two planes


def rotor_of(form: RotorTable) -> Rotor:
    """Make the rotor that a scene gives; without a plane of correction the origin is one."""
    planes = form.planes or (PlaneTable(),)
    names = (ALONE,) if len(planes) == 1 else NUMERALS
    return Rotor(
        masses=tuple(_unbalance(number, mass) for number, mass in enumerate(form.masses, 1)),
        planes=tuple(
            Plane(name, Fraction(plane.place), _float(plane.radius), _float(plane.mass))
            for name, plane in zip(names, planes, strict=True)
        ),
        bearings=tuple(map(Fraction, form.bearings)),
        speed=_float(form.speed),
        mass=_float(form.mass),
        grade=None if form.grade is None else float(form.grade[1:]),
    )


def _unbalance(number: int, mass: UnbalanceTable) -> Unbalance:
    angle, place = Fraction(mass.angle), Fraction(mass.place)
    return Unbalance(str(number), float(_moment(mass)), angle, place, _float(mass.mass), _float(mass.radius))


def _moment(mass: UnbalanceTable) -> Decimal:
    if mass.moment is not None:
        return mass.moment
    assert mass.mass is not None and mass.radius is not None  # the form has asked for both
    return WORKING.multiply(mass.mass, mass.radius)


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


class RotorSurvey(NamedTuple):
    """What the examination of a scene's rotor found: the rotor itself; its form has told all faults."""

    rotor: Rotor
    faults: list[Fault]
