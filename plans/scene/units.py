"""Quantities (величины): what the scene writes as a number or as "110 mm", in exact decimal SI; angles in degrees."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Context, Decimal, InvalidOperation
from fractions import Fraction
from typing import NamedTuple

from plans.scene.faults import wrong

PI = Decimal("3.141592653589793238462643383279502884197")  # 40 digits, enough for a check in 38-digit arithmetic
# Longer literals are rounded to DIGITS; within the two magnitudes every sum of coordinates is exact in EXACT.
DIGITS = 100
SMALLEST, LARGEST = Decimal("1e-300"), Decimal("1e300")
EXACT = Context(prec=1000)
WORKING = Context(prec=50)

LENGTH_LIMIT = Decimal("1e9")  # m: beyond it, or below LENGTH_LEAST, squares and their differences lose their meaning
LENGTH_LEAST = Decimal("1e-9")  # m
ANGLE_LIMIT = Decimal("1e9")  # degrees
RATE_LIMIT = Decimal("1e9")  # rad/s, rad/s2: no machine turns a thousandth as fast
RATE_LEAST = Decimal("1e-9")  # above zero: a turn in two centuries
COEFFICIENT_LIMIT = Decimal(3)  # rubber on a dry road has 1, and the groove of a V-belt makes it three times as much
PRESSURE_LIMIT = Decimal(45)  # degrees: beyond it the teeth of a gear press the shafts apart more than they turn them

# An ASCII number with digits on both sides of the point, then whatever stands for a unit.
QUANTITY = re.compile(r"\s*([+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?)\s*([^\W\d_].*|°.*)?", re.DOTALL)
ALIKE = 0.8  # of the letters of a unit: bars is bar, but kN*m is not kN
DECIMAL_COMMA = re.compile(r"\s*([+-]?[0-9]+),([0-9]+)\b")


class UnitKind(NamedTuple):
    """A kind of quantity: its name, its unit in SI, and the other units with what one of them is in that unit.

    Its sizes in SI are zero, or lie between `least` and `most`: no machine has others.
    """

    name: str
    si: str
    units: Mapping[str, Decimal]
    least: Decimal = SMALLEST
    most: Decimal = LARGEST

    @property
    def allowed(self) -> str:
        """Name the allowed units; Russian spellings are accepted but not listed."""
        return ", ".join(unit for unit in self.units if unit.isascii()) or "none"


def _kind(name: str, si: str, *sizes: str, **russian_or_other: str) -> UnitKind:
    units = {si: Decimal(1), **{unit: Decimal(size) for unit, size in russian_or_other.items()}}
    return UnitKind(name, si, units, *map(Decimal, sizes))


LENGTH = _kind("length", "m", dm="0.1", cm="0.01", mm="0.001", м="1", дм="0.1", см="0.01", мм="0.001")
_DEGREES = WORKING.divide(Decimal(180), PI)
_RADIANS = WORKING.divide(PI, Decimal(180))
_RPM = WORKING.divide(PI, Decimal(30))
_ONE = Decimal(1)
ANGLE = UnitKind("angle", "deg", {"deg": _ONE, "rad": _DEGREES, "°": _ONE, "рад": _DEGREES, "град": _ONE})
SPEED = UnitKind(
    "angular speed",
    "rad/s",
    {"rad/s": _ONE, "rpm": _RPM, "deg/s": _RADIANS, "рад/с": _ONE, "об/мин": _RPM, "°/s": _RADIANS},
)
ANGULAR_ACCELERATION = UnitKind(
    "angular acceleration",
    "rad/s2",
    {"rad/s2": _ONE, "deg/s2": _RADIANS, "рад/с2": _ONE, "°/s2": _RADIANS},
)
ACCELERATION = _kind(
    "acceleration", "m/s2", "1e-9", "1e9", **{"cm/s2": "0.01", "mm/s2": "0.001", "м/с2": "1", "мм/с2": "0.001"}
)
VELOCITY = _kind(
    "velocity", "m/s", "1e-9", "1e9", **{"cm/s": "0.01", "mm/s": "0.001", "м/с": "1", "см/с": "0.01", "мм/с": "0.001"}
)
MASS = _kind("mass", "kg", "1e-12", "1e12", g="0.001", t="1000", кг="1", г="0.001", т="1000")
INERTIA = _kind(
    "moment of inertia", "kg*m2", "1e-24", "1e18", **{"kg*cm2": "0.0001", "kg*mm2": "0.000001", "кг*м2": "1"}
)
FORCE = _kind("force", "N", "1e-12", "1e12", kN="1000", Н="1", кН="1000")
PRESSURE = _kind(
    "pressure",
    "Pa",
    *("1e-9", "1e15"),
    **{"kPa": "1000", "MPa": "1000000", "bar": "100000"},
    **{"Па": "1", "кПа": "1000", "МПа": "1000000", "бар": "100000"},
)
MOMENT = _kind(
    "moment",
    "N*m",
    *("1e-15", "1e15"),
    **{"kN*m": "1000", "N*mm": "0.001", "Nm": "1", "Nmm": "0.001"},
    **{"Н*м": "1", "кН*м": "1000", "Н*мм": "0.001", "Нм": "1", "Нмм": "0.001"},
)
STIFFNESS = _kind(
    "stiffness", "N/m", "1e-9", "1e15", **{"kN/m": "1000", "N/cm": "100", "N/mm": "1000", "Н/м": "1", "Н/мм": "1000"}
)
DENSITY = _kind("density", "kg/m3", "1e-3", "1e6", **{"g/cm3": "1000", "кг/м3": "1", "г/см3": "1000"})
NUMBER = UnitKind("number", "", {})


def decimal(literal: str) -> Decimal:
    """Give a number literal exactly; one whose exponent no Decimal can hold is infinite."""
    try:
        return Decimal(literal)
    except InvalidOperation:
        return Decimal("Infinity")


def quantity(value: object, kind: UnitKind) -> Decimal:
    """Give a number of the file, or a string with a unit, in SI (degrees for angles), exactly.

    >>> quantity("110 mm", LENGTH), quantity(Decimal("0.11"), LENGTH)
    (Decimal('0.110'), Decimal('0.11'))
    """
    if isinstance(value, bool):
        raise wrong("not_a_number", kind=kind.name, found="true or false")
    if isinstance(value, int | Decimal):
        return _ranged(_finite(Decimal(value), kind), kind)
    if isinstance(value, str):
        return _ranged(_written(value, kind), kind)
    raise wrong("not_a_number", kind=kind.name, found=type_name(value))


def coordinate(value: object) -> Decimal:
    """Give a coordinate in metres, of magnitude at most LENGTH_LIMIT."""
    result = quantity(value, LENGTH)
    if abs(result) > LENGTH_LIMIT:
        raise wrong("out_of_range", kind="coordinate", least=f"-{LENGTH_LIMIT}", most=str(LENGTH_LIMIT), unit="m")
    return result


def length(value: object) -> Decimal:
    """Give a length in metres, between LENGTH_LEAST and LENGTH_LIMIT."""
    result = quantity(value, LENGTH)
    if result <= 0:
        raise wrong("not_positive", kind="length")
    if not LENGTH_LEAST <= result <= LENGTH_LIMIT:
        raise wrong("out_of_range", kind="length", least=str(LENGTH_LEAST), most=str(LENGTH_LIMIT), unit="m")
    return result


def angle(value: object) -> Decimal:
    """Give an angle in degrees, not reduced."""
    result = quantity(value, ANGLE)
    if abs(result) > ANGLE_LIMIT:
        raise wrong("out_of_range", kind="angle", least=f"-{ANGLE_LIMIT}", most=str(ANGLE_LIMIT), unit="deg")
    return result


def pressure_angle(value: object) -> Decimal:
    """Give the pressure angle of a gear in degrees."""
    result = quantity(value, ANGLE)
    if not 0 <= result <= PRESSURE_LIMIT:
        raise wrong("out_of_range", kind="angle", least="0", most=str(PRESSURE_LIMIT), unit="deg")
    return result


def rate(value: object, kind: UnitKind) -> Decimal:
    """Give an angular velocity or acceleration: zero, or of a size between RATE_LEAST and RATE_LIMIT."""
    result = quantity(value, kind)
    if result and not RATE_LEAST <= abs(result) <= RATE_LIMIT:
        raise wrong("out_of_range", kind=kind.name, least=f"±{RATE_LEAST}", most=f"±{RATE_LIMIT}", unit=kind.si)
    return result


def positive(value: object, kind: UnitKind) -> Decimal:
    """Give a quantity above zero: a stiffness."""
    result = quantity(value, kind)
    if result <= 0:
        raise wrong("not_positive", kind=kind.name)
    return result


def free_length(value: object) -> Decimal:
    """Give the free length of a spring in metres: zero, or a length."""
    return length(value) if quantity(value, LENGTH) else Decimal(0)


def friction(value: object) -> Decimal:
    """Give a coefficient of friction, at most COEFFICIENT_LIMIT."""
    result = not_negative(value, NUMBER)
    if result > COEFFICIENT_LIMIT:
        raise wrong("coefficient", most=str(COEFFICIENT_LIMIT))
    return result


def not_negative(value: object, kind: UnitKind) -> Decimal:
    """Give a quantity of zero or above: a mass, a moment of inertia, a coefficient of friction."""
    result = quantity(value, kind)
    if result < 0:
        raise wrong("negative", kind=kind.name)
    return result


def type_name(value: object) -> str:
    """Name what the file holds in the words of the file format."""
    names: tuple[tuple[type | tuple[type, ...], str], ...] = (
        (bool, "true or false"),
        ((int, Decimal), "a number"),
        (str, "text"),
        ((list, tuple), "a list"),
        (dict, "a table"),
    )
    return next((name for kinds, name in names if isinstance(value, kinds)), "a date or time")


def _written(text: str, kind: UnitKind) -> Decimal:
    match = QUANTITY.fullmatch(text)
    comma = DECIMAL_COMMA.match(text)
    if comma:
        raise wrong("decimal_comma", kind=kind.name, written=f"{comma[1]}.{comma[2]}")
    if not any(kind.units) and (not match or match[2]):
        raise wrong("not_bare", kind=kind.name)
    if not match:
        raise wrong("not_a_quantity", kind=kind.name, units=kind.allowed, example=_example(kind))
    number = _finite(decimal(match[1]), kind)
    unit = _unit(match[2] or "")
    if not unit:
        raise wrong("text_number", kind=kind.name, units=kind.allowed, number=match[1])
    if unit not in kind.units:
        raise wrong("wrong_unit", kind=kind.name, units=kind.allowed, unit=unit, example=_example(kind, match[1], unit))
    return WORKING.multiply(number, kind.units[unit]) if kind.units[unit] != 1 else number


def _ranged(number: Decimal, kind: UnitKind) -> Decimal:
    if number and not kind.least <= abs(number) <= kind.most:
        raise wrong("out_of_range", kind=kind.name, least=f"±{kind.least}", most=f"±{kind.most}", unit=kind.si)
    return number


def _example(kind: UnitKind, number: str = "1", unit: str = "") -> str:
    """Give an example: the number as written with the unit that is nearly what is written, or one of the SI unit."""
    from difflib import get_close_matches  # noqa: PLC0415  (only a wrong unit needs it)

    meant = get_close_matches(unit, kind.units, 1, ALIKE)
    if meant:
        return f'"{number} {meant[0]}"'
    return f'"1 {kind.si}"' if kind.si else "a bare number"


def _unit(text: str) -> str:
    """Give one spelling to a unit: kg·m², kg*m^2 and kg m2 are one."""
    text = text.strip().replace("²", "2").replace("**2", "2").replace("^2", "2").replace("·", "*").replace("⋅", "*")
    return re.sub(r"\s*([*/])\s*|\s+", lambda match: match[1] or "*", text)


def _finite(number: Decimal, kind: UnitKind) -> Decimal:
    if not number.is_finite():
        raise wrong("not_finite", kind=kind.name)
    if number == 0:
        return Decimal(0)  # also -0.0 and 0e-500
    if not SMALLEST <= abs(number) <= LARGEST:
        raise wrong("out_of_range", kind=kind.name, least=str(SMALLEST), most=str(LARGEST), unit=kind.si)
    return number if len(number.as_tuple().digits) <= DIGITS else Context(prec=DIGITS).plus(number)


def within(angle: Fraction) -> Fraction:
    """Take whole turns off an angle in degrees, exactly: as a float it would lose a digit with every ten of them.

    >>> within(Fraction(100_000)), within(Fraction(-725))
    (Fraction(280, 1), Fraction(-5, 1))
    """
    return angle - 360 * int(angle / 360)
