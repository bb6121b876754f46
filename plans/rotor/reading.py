"""The rotor made from the scene, exact places and angles; its notes (ротор по исходным данным)."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

from plans.model.rotor import Plane, Rotor, Unbalance
from plans.rotor.balancing import ALONE, balancing
from plans.rotor.form import PLANES_LIMIT, PlaneTable, RotorForm, RotorTable, UnbalanceTable
from plans.scene.faults import Fault, Path
from plans.scene.notes import HUNDREDS, odd_lengths
from plans.scene.scene import Meaning, Scene
from plans.scene.units import WORKING


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's rotor (row of the table of techniques)."""
    rotor = scene.of(RotorForm).rotor
    yield from odd_lengths(scene, dict(_lengths(rotor)))
    for notes in (_planes, _mass, _unused):
        yield from notes(scene, rotor)


def _lengths(rotor: RotorTable) -> Iterator[tuple[Path, Decimal]]:
    """Give the lengths m that a scene states: radii and places; a zero is one in any unit."""
    own: list[tuple[Path, UnbalanceTable | PlaneTable]] = []
    own += [(("rotor", "masses", index), one) for index, one in enumerate(rotor.masses)]
    own += [(("rotor", "planes", index), one) for index, one in enumerate(rotor.planes)]
    stated = [
        ((*path, name), size) for path, one in own for name, size in (("radius", one.radius), ("place", one.place))
    ]
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
    apart, far = abs(first - last), max(abs(one.place - last) for one in rotor.masses)
    if far > HUNDREDS * apart:
        yield scene.fault(path, "near_planes", apart=f"{apart:.4g}", ratio=f"{far / apart:.3g}")


def _mass(scene: Scene, rotor: RotorTable) -> Iterator[Fault]:
    """Find a rotor that is lighter than the masses on it."""
    masses = sum((one.mass for one in rotor.masses if one.mass), Decimal(0))
    if rotor.mass is not None and rotor.mass < masses:
        yield scene.fault(("rotor", "mass"), "light_rotor", masses=f"{masses:.4g}")


def _unused(scene: Scene, rotor: RotorTable) -> Iterator[Fault]:
    """Find what nothing is found from: a speed alone, or bearings or a mass without a speed."""
    if rotor.speed is None:
        yield from (
            scene.fault(("rotor", name), f"still_{name}") for name in ("bearings", "mass") if name in rotor.given
        )
    elif not rotor.bearings and rotor.mass is None:
        yield scene.fault(("rotor", "speed"), "spare_speed")


NUMERALS = ("I", "II")  # the names of two planes


def rotor_of(form: RotorTable) -> Rotor:
    """Make the rotor that a scene gives; without a plane of correction the origin is one."""
    planes = form.planes or (PlaneTable(),)
    names = (ALONE,) if len(planes) == 1 else NUMERALS
    return Rotor(
        masses=tuple(_unbalance(number, one) for number, one in enumerate(form.masses, 1)),
        planes=tuple(
            Plane(name, Fraction(one.place), _float(one.radius), _float(one.mass))
            for name, one in zip(names, planes, strict=True)
        ),
        bearings=tuple(map(Fraction, form.bearings)),
        speed=_float(form.speed),
        mass=_float(form.mass),
        grade=None if form.grade is None else float(form.grade[1:]),
    )


def _unbalance(number: int, one: UnbalanceTable) -> Unbalance:
    angle, place = Fraction(one.angle), Fraction(one.place)
    return Unbalance(str(number), float(_moment(one)), angle, place, _float(one.mass), _float(one.radius))


def _moment(one: UnbalanceTable) -> Decimal:
    if one.moment is not None:
        return one.moment
    assert one.mass is not None and one.radius is not None  # the form has asked for both
    return WORKING.multiply(one.mass, one.radius)


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


class RotorSurvey(NamedTuple):
    """What the examination of a scene's rotor found: the rotor itself; its form has told all faults."""

    rotor: Rotor
    faults: list[Fault]


def survey_of(meaning: Meaning) -> RotorSurvey:
    """Examine a scene's rotor (row of the table of techniques)."""
    return RotorSurvey(rotor_of(meaning.scene.of(RotorForm).rotor), [])
