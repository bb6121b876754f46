"""The rotor made from the scene: exact places and angles, static moments rounded once (ротор по исходным данным)."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

from plans.model.rotor import Plane, Rotor, Unbalance
from plans.rotor.form import PlaneTable, RotorForm, RotorTable, UnbalanceTable
from plans.rotor.letters import ALONE
from plans.scene.faults import Fault
from plans.scene.scene import Meaning
from plans.scene.units import WORKING

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
