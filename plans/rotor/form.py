"""The rotor as the scene gives it (данные ротора): unbalanced masses, planes of correction, bearings, speed."""

from __future__ import annotations

from decimal import Decimal
from functools import partial

from plans.model.balance_quality import GRADES, letters
from plans.scene import fields as f
from plans.scene import units
from plans.scene.faults import wrong
from plans.scene.tables import Table, key, many, one, table

STATIC_MOMENT = units.Kind(
    "static moment",
    "kg*m",
    {
        unit: Decimal(size)
        for size, names in {
            "1": ("kg*m", "кг*м"),
            "0.01": ("kg*cm", "кг*см"),
            "0.001": ("kg*mm", "g*m", "кг*мм", "г*м"),
            "0.00001": ("g*cm", "г*см"),
            "0.000001": ("g*mm", "г*мм"),
        }.items()
        for unit in names
    },
    Decimal("1e-21"),
    Decimal("1e21"),
)
MOMENT = one(units.not_negative, kind=STATIC_MOMENT)
HEAVY = one(units.positive, kind=units.MASS)
PLANES_LIMIT = 2


class UnbalanceTable(Table):
    """An unbalanced mass: mass kg and radius m, or static moment kg*m; angle in degrees, place along the shaft m."""

    mass: Decimal | None = key(f.MASS, None)
    radius: Decimal | None = key(f.LENGTH, None)
    moment: Decimal | None = key(MOMENT, None)
    angle: Decimal = key(f.ANGLE)
    place: Decimal = key(f.COORDINATE, Decimal(0))

    def check(self) -> None:
        """See that the static moment is given in one way, and wholly."""
        if self.moment is None and self.radius is None:
            raise wrong("missing", thing="radius", example='radius = "120 mm"', at=("radius",))
        if self.moment is None and self.mass is None:
            raise wrong("missing", thing="mass", example='mass = "3 kg"', at=("mass",))
        for name in ("mass", "radius"):
            if self.moment is not None and name in self.given:
                raise wrong("one_of_two", first=name, second="moment", found="both", at=(name,))


class PlaneTable(Table):
    """A plane of correction: its place along the shaft m, and the radius m or the mass kg of what is put there."""

    place: Decimal = key(f.COORDINATE, Decimal(0))
    radius: Decimal | None = key(f.LENGTH, None)
    mass: Decimal | None = key(HEAVY, None)

    def check(self) -> None:
        """See that one of radius and mass is left to be found."""
        if {"radius", "mass"} <= self.given:
            raise wrong("one_of_two", first="radius", second="mass", found="both", at=("mass",))


def _check_planes(planes: tuple[PlaneTable, ...]) -> None:
    """See that there are no more planes than a rotor needs, and that they are apart."""
    if len(planes) > PLANES_LIMIT:
        raise wrong("planes", found=len(planes), at=(PLANES_LIMIT,))
    if len(planes) == PLANES_LIMIT:
        _check_apart((planes[0].place, planes[1].place), (1, "place"))


def _check_apart(places: tuple[Decimal, ...], at: tuple[str | int, ...] = (1,)) -> None:
    if places[0] == places[1]:
        raise wrong("one_place", place=f"{places[0]:f}", at=at)


class RotorTable(Table):
    """A rotor: its unbalanced masses, where it may be corrected, its bearings, speed, mass, and the grade asked."""

    masses: tuple[UnbalanceTable, ...] = key(many(table(UnbalanceTable), f.not_empty, first=f.FEW))
    planes: tuple[PlaneTable, ...] = key(many(table(PlaneTable), _check_planes, first=f.FEW), ())
    bearings: tuple[Decimal, ...] = key(
        many(f.COORDINATE, _check_apart, first=partial(f.check_pair, what="[A, B]")), ()
    )
    speed: Decimal | None = key(f.ANGULAR_SPEED, None)
    mass: Decimal | None = key(HEAVY, None)
    grade: str | None = key(one(f.choice, choices=tuple(map(letters, GRADES))), None)

    def check(self) -> None:
        """See that it turns, that a grade has what it needs, and that with two planes each thing has its place."""
        if self.speed == 0:
            raise wrong("not_positive", kind="angular speed", at=("speed",))
        if self.grade is not None and self.speed is None:
            raise wrong("missing", thing="angular speed", example='speed = "3000 rpm"', at=("speed",))
        if self.grade is not None and self.mass is None:
            raise wrong("missing", thing="mass", example='mass = "20 kg"', at=("mass",))
        if len(self.planes) == PLANES_LIMIT:
            self._check_places()

    def _check_places(self) -> None:
        for name in ("masses", "planes"):
            for index, entry in enumerate(getattr(self, name)):
                if "place" not in entry.given:
                    raise wrong("missing", thing="place", example='place = "250 mm"', at=(name, index, "place"))


class RotorForm(Table):
    """What a scene says of balancing a rotor."""

    rotor: RotorTable = key(table(RotorTable))
