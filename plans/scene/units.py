"""Quantities (величины): what the scene writes as a number or as "110 mm", in exact decimal SI; angles in degrees."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from decimal import Context, Decimal, InvalidOperation
from fractions import Fraction
from functools import cache
from itertools import product
from typing import NamedTuple

from plans.scene.faults import wrong
from plans.words.words import ENGLISH, Message, message

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

# An ASCII number with digits on both sides of the mark, then whatever stands for a unit.
WRITTEN = r"[+-]?[0-9]+(?:[.,][0-9]+)?(?:[eE][+-]?[0-9]+)?"
COMMA = r"[+-]?[0-9]+,[0-9]+(?:[eE][+-]?[0-9]+)?"
QUANTITY = re.compile(rf"\s*({WRITTEN})(?:\s*((?:[^\W\d_]|°).*)|\s+(1\s*/.*))?\s*", re.DOTALL)
PER_CENT = re.compile(r"^\s*([+-]?[0-9]+(?:[.,][0-9]+)?)\s*%\s*$")
THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}")  # a thousand for some, for others one and a part
ALIKE = 0.8  # of the letters of a unit: bars is bar, but kN*m is not kN

# The units, by groups: what one is in SI by definition, angles in radians; its spelling in English, in Russian, others.
# The kilogram-force is 9.80665 N, the technical atmosphere 1 kgf/cm2, the millimetre of mercury 13.5951 kgf/m2.
SYMBOLS: Mapping[str, tuple[str, ...]] = {
    "length": ("1 m м", "0.1 dm дм", "0.01 cm см", "0.001 mm мм", "1000 km км"),
    "mass": ("1 kg кг", "0.001 g г гр", "1000 t т"),
    "time": ("1 s с sec сек", "0.001 ms мс", "60 min мин", "3600 h ч"),
    "force": (
        *("1 N Н", "0.001 mN мН", "10 daN даН", "1000 kN кН", "1000000 MN МН"),
        *("9.80665 kgf кгс kp", "0.00980665 gf гс", "9806.65 tf тс", "0.00001 dyn дин"),
    ),
    "pressure": (
        *("1 Pa Па", "1000 kPa кПа", "1000000 MPa МПа", "100000 bar бар", "98066.5 at ат", "101325 atm атм"),
        "133.322387415 mmHg мм*рт*ст mm*Hg",
    ),
    "angle": ("1 rad рад", f"{WORKING.divide(PI, 180)} deg град °", f"{WORKING.multiply(PI, 2)} rev об r"),
    "speed": ("1 1/s 1/с s-1 с-1 1/сек", f"{WORKING.divide(PI, 30)} rpm об/мин 1/min 1/мин min-1 мин-1"),
    "spin": ("1 1/s2 1/с2 s-2 с-2 1/сек2",),
}
FACTOR = re.compile(r"([*/]?)([a-z]+)([0-9]?)")  # of a product of groups
# Letters of the two alphabets that look alike, small or large.
TWINS = str.maketrans("авекмнорстух", "abekmhopctyx")
GRAM = re.compile("[gг]", re.IGNORECASE)
MEGA, MILLI = "MМ", "mм"  # the one prefix that a small letter makes another of


class UnitKind(NamedTuple):
    """A kind of quantity: its name, its unit in SI, all its units as products of groups, and those that are listed.

    Its sizes in SI are at most `most`: no machine has larger ones. One under `least` no machine feels: it is none.
    """

    name: str
    si: str
    forms: tuple[str, ...] = ()
    listed: tuple[str, ...] = ()
    least: Decimal = SMALLEST
    most: Decimal = LARGEST

    @property
    def units(self) -> Mapping[str, Fraction]:
        """What one of each of its units is in SI."""
        return _units(self.forms, self.si)


@dataclass(frozen=True, repr=False)
class Spelt:
    """Units to be named in the spelling of a language, in quotes behind a number where the file would have it."""

    units: tuple[str, ...]
    number: str = ""

    def worded(self, language: str) -> str:
        """Name them."""
        units = [unit if language == ENGLISH else _in_russian(unit) for unit in self.units]
        if self.number:
            return ", ".join(f'"{self.number} {unit}"' for unit in units)
        return ", ".join(units).replace("*", "·").translate({0x32: "²", 0x33: "³"})

    def __str__(self) -> str:
        return self.worded(ENGLISH)


@cache
def _in_russian(unit: str) -> str:
    rows = (row.split() for group in SYMBOLS.values() for row in group)
    russian = {english: russian for _, english, russian, *_ in rows}
    return re.sub(r"[A-Za-z]+", lambda symbol: russian.get(symbol[0], symbol[0]), unit)


def _kind(name: str, si: str, forms: str, listed: str, *sizes: str) -> UnitKind:
    return UnitKind(name, si, tuple(forms.split()), tuple(listed.split()), *map(Decimal, sizes))


SLIGHT = "1e-30"  # in SI: what is left of a zero by whatever wrote the scene is more, what a machine has is far more
LENGTH = _kind("length", "m", "length", "m dm cm mm")
MILLIMETRES = _kind("length", "mm", "length", "mm cm m")  # of gears, whose modules are told so everywhere
ANGLE = _kind("angle", "deg", "angle", "deg rad")
SPEED = _kind("angular speed", "rad/s", "angle/time speed", "rad/s 1/s rpm deg/s")
ANGULAR_ACCELERATION = _kind("angular acceleration", "rad/s2", "angle/time2 spin", "rad/s2 1/s2 deg/s2")
ACCELERATION = _kind("acceleration", "m/s2", "length/time2", "m/s2 cm/s2 mm/s2", SLIGHT, "1e9")
VELOCITY = _kind("velocity", "m/s", "length/time", "m/s m/min cm/s mm/s", SLIGHT, "1e9")
MASS = _kind("mass", "kg", "mass force*time2/length", "kg g t", SLIGHT, "1e12")
_INERTIA = "mass*length2 force*length*time2"
INERTIA = _kind("moment of inertia", "kg*m2", _INERTIA, "kg*m2 kg*cm2 kg*mm2 kgf*m*s2", SLIGHT, "1e18")
STATIC_MOMENT = _kind("static moment", "kg*m", "mass*length", "kg*m kg*mm g*m g*mm", SLIGHT, "1e21")
FORCE = _kind("force", "N", "force", "N kN kgf tf", SLIGHT, "1e12")
_PRESSURES = "Pa kPa MPa bar at atm kgf/cm2 N/mm2"
PRESSURE = _kind("pressure", "Pa", "pressure force/length2", _PRESSURES, SLIGHT, "1e15")
FORCE_OR_PRESSURE = _kind("force or pressure", "N", "force pressure force/length2", "N kN kgf Pa kPa MPa bar at")
MOMENT = _kind("moment", "N*m", "force*length", "N*m kN*m N*cm N*mm kgf*m kgf*cm", SLIGHT, "1e15")
STIFFNESS = _kind("stiffness", "N/m", "force/length", "N/m kN/m N/cm N/mm kgf/cm", SLIGHT, "1e15")
_TURNING = "force*length/angle force*length"
TURNING_STIFFNESS = _kind("stiffness in turning", "N*m/rad", _TURNING, "N*m/rad N*mm/rad kgf*m/rad", SLIGHT, "1e15")
DENSITY = _kind("density", "kg/m3", "mass/length3", "kg/m3 g/cm3 t/m3", "1e-3", "1e6")
TIME = _kind("time", "s", "time", "s ms min", "1e-9", "1e6")
NUMBER = UnitKind("number", "")
# The flywheel moment GD2 of old books (маховой момент).
GYRATION = _kind("moment of inertia", "N*m2", "force*length2", "")
STANDARD_GRAVITY = Decimal("9.80665")  # m/s2


@cache
def _units(forms: tuple[str, ...], si: str) -> Mapping[str, Fraction]:
    """Give what the products of some groups are in a unit of theirs, each spelt in one alphabet."""
    found: dict[str, Fraction] = {}
    for form, pattern in product(forms, (r"[A-Za-z°/\d*-]+", r"[А-Яа-я°/\d*-]+")):
        factors = FACTOR.findall(form)
        spelt = [[pair for pair in _spellings(group) if re.fullmatch(pattern, pair[0])] for _, group, _ in factors]
        for chosen in product(*spelt):
            size, unit = Fraction(1), ""
            for (sign, _, power), (symbol, one) in zip(factors, chosen, strict=True):
                size *= one ** (-int(power or 1) if sign == "/" else int(power or 1))
                unit += f"{sign}{symbol}{power}"
            found.setdefault(unit, size)
    return {unit: size / found[si] for unit, size in found.items()}


def _spellings(group: str) -> Iterator[tuple[str, Fraction]]:
    for size, *symbols in map(str.split, SYMBOLS[group]):
        yield from ((symbol, Fraction(size)) for symbol in symbols)


def folded(unit: str) -> str:
    """Give what is left of a unit where small letters and large ones and both alphabets are alike."""
    return unit.casefold().translate(TWINS)


def _alike(unit: str, kind: UnitKind) -> list[str]:
    """Give the units that a unit is but for its letters; of newtons the sign of the product may lack too: Nm."""
    joined = str.maketrans("", "", "" if "*" in unit or GRAM.search(unit) else "*")
    return [spelt for spelt in kind.units if folded(spelt).translate(joined) == folded(unit)]


def _meant(unit: str, kind: UnitKind) -> list[str]:
    """Give the units that a unit may be, none where a letter speaks against it: what is small is no mega."""
    alike = [unit] if unit in kind.units else _alike(unit, kind)
    if len({kind.units[spelt] for spelt in alike}) != 1:
        return alike
    pairs = zip(alike[0].replace("*", ""), unit.replace("*", ""), strict=True)
    return [] if any(a in MEGA and b in MILLI for a, b in pairs) else alike[:1]


def decimal(literal: str) -> Decimal:
    """Give a number literal exactly; one whose exponent no Decimal can hold is infinite."""
    try:
        return Decimal(literal)
    except InvalidOperation:
        return Decimal("Infinity")


def quantity(value: object, kind: UnitKind) -> Decimal:
    """Give a number of the file, or a string with a unit, in SI (degrees for angles), exactly.

    >>> quantity("110 mm", LENGTH), quantity(Decimal("0.11"), LENGTH)
    (Decimal('0.11'), Decimal('0.11'))
    """
    if isinstance(value, bool):
        raise wrong("not_a_number", kind=kind.name, found="true or false")
    if isinstance(value, int | Decimal):
        return _ranged(_finite(Decimal(value), kind), kind)
    if isinstance(value, str):
        return _ranged(_written(value, kind), kind)
    raise wrong("not_a_number", kind=kind.name, found=type_name(value))


def _between(found: Decimal, kind: UnitKind, least: Decimal, most: Decimal, name: str = "") -> Decimal:
    if not least <= found <= most:
        unit = Spelt((kind.si,))
        raise wrong("out_of_range", kind=name or kind.name, least=str(least), most=str(most), unit=unit)
    return found


def coordinate(value: object) -> Decimal:
    """Give a coordinate in metres, of magnitude at most LENGTH_LIMIT."""
    return _between(quantity(value, LENGTH), LENGTH, -LENGTH_LIMIT, LENGTH_LIMIT, "coordinate")


def length(value: object) -> Decimal:
    """Give a length in metres, between LENGTH_LEAST and LENGTH_LIMIT."""
    return _between(positive(value, LENGTH), LENGTH, LENGTH_LEAST, LENGTH_LIMIT)


def millimetres(value: object) -> Decimal:
    """Give a length of gears in metres: a bare number is in millimetres."""
    return _between(positive(value, MILLIMETRES).scaleb(-3), LENGTH, LENGTH_LEAST, LENGTH_LIMIT)


def angle(value: object) -> Decimal:
    """Give an angle in degrees, not reduced."""
    return _between(quantity(value, ANGLE), ANGLE, -ANGLE_LIMIT, ANGLE_LIMIT)


def pressure_angle(value: object) -> Decimal:
    """Give the pressure angle of a gear in degrees."""
    return _between(quantity(value, ANGLE), ANGLE, Decimal(0), PRESSURE_LIMIT)


def rate(value: object, kind: UnitKind) -> Decimal:
    """Give an angular velocity or acceleration: zero, or of a size between RATE_LEAST and RATE_LIMIT."""
    if result := quantity(value, kind):
        _between(abs(result), kind, RATE_LEAST, RATE_LIMIT)
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


def part(value: object) -> Decimal:
    """Read a part of one, or text in per cent."""
    found = per_cent(value)
    return quantity(value, NUMBER) if found is None else found.scaleb(-2)


def per_cent(value: object) -> Decimal | None:
    """Read a part in per cent as it is written; nothing where it is not.

    >>> per_cent("12,5 %"), per_cent(Decimal("0.125"))
    (Decimal('12.5'), None)
    """
    found = PER_CENT.fullmatch(value) if isinstance(value, str) else None
    return quantity(Decimal(found[1].replace(",", ".")), NUMBER) if found else None


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
    unit = _unit(match[2] or match[3] or "") if match else ""
    if not kind.forms and (not match or unit or "," not in match[1]):
        raise wrong("not_bare", kind=kind.name)
    if not match:
        raise wrong("not_a_quantity", kind=kind.name, units=Spelt(kind.listed), example=Spelt((kind.si,), "12.5"))
    if not unit and "," not in match[1]:  # a comma needs the quotes, a point does not: what it counts is not said
        raise wrong("text_number", kind=kind.name, units=Spelt(kind.listed), number=match[1])
    written = match[1].replace(",", ".")
    if THOUSANDS.fullmatch(match[1]) and unit.isascii():
        raise wrong("decimal_comma", kind=kind.name, part=written, whole=written.replace(".", ""))
    number = _finite(decimal(written), kind)
    sizes = {kind.units[spelt] for spelt in _meant(unit, kind)} if unit else {Fraction(1)}
    if len(sizes) != 1:
        shown = {"kind": kind.name, "units": Spelt(kind.listed), "unit": (match[2] or match[3]).strip()}
        raise wrong("wrong_unit", **shown, advice=_cure(kind, written, unit))
    return _sized(number, sizes.pop())


def _sized(number: Decimal, size: Fraction) -> Decimal:
    whole = Fraction(number) * size
    return number if size == 1 else WORKING.divide(Decimal(whole.numerator), Decimal(whole.denominator))


def _ranged(number: Decimal, kind: UnitKind) -> Decimal:
    if abs(number) > kind.most:
        raise wrong("too_large", kind=kind.name, most=f"±{kind.most}", unit=Spelt((kind.si,)))
    return number if abs(number) >= kind.least else Decimal(0)


def _cure(kind: UnitKind, written: str, unit: str) -> Message:
    """Name what a wrong unit may stand for, with the number as written; else the unit to convert to."""
    from difflib import get_close_matches  # noqa: PLC0415  (only a wrong unit needs it)

    if kind == INERTIA and (wheel := _meant(unit, GYRATION)):
        inertia = _sized(Decimal(written), GYRATION.units[wheel[0]]) / (4 * STANDARD_GRAVITY)
        return message("advice.gyration", unit=unit, inertia=Spelt((kind.si,), f"{inertia:.7g}"))
    weight = re.sub(r"^([kк][gг])(?![fс])", r"\1f" if unit.isascii() else r"\1с", unit, flags=re.IGNORECASE)
    if weight != unit and (force := _meant(weight, kind)):
        si = Spelt((kind.si,), f"{_sized(Decimal(written), kind.units[force[0]]):.7g}")
        return message("advice.weight", force=Spelt(tuple(force[:1]), written), si=si)
    both = [spelt for unit in kind.listed for spelt in (unit, _in_russian(unit))]
    known = {spelt.casefold(): spelt for spelt in both}
    near = get_close_matches(unit.casefold(), known, 1, ALIKE)
    meant = _alike(unit, kind) or [known[spelt] for spelt in near]
    if meant:
        return message("advice.meant", names=tuple(f'"{written} {spelt}"' for spelt in meant))
    return message("advice.convert", unit=Spelt((kind.si,)))


def _unit(text: str) -> str:
    """Give one spelling to a unit: kg·m², kg*m^2 and kg m2 are one, rad·s⁻¹ and rad/s another."""
    text = unicodedata.normalize("NFKC", text).translate({ord("−"): "-", ord("–"): "-", ord("^"): None}).strip()
    text = re.sub(r"(?<=[^\W\d_])\.(?=[^\W\d_])|[·⋅•∙×]", "*", text.replace("**", "")).replace(".", "")
    text = re.sub(r"\s*([*/])\s*|\s+", lambda match: match[1] or "*", text)
    return re.sub(r"\*([^\W\d_]+)-([1-9])", lambda part: f"/{part[1]}{part[2].strip('1')}", text)


def _finite(number: Decimal, kind: UnitKind) -> Decimal:
    if not number.is_finite():
        raise wrong("not_finite", kind=kind.name)
    if number == 0:
        return Decimal(0)  # also -0.0 and 0e-500
    if not SMALLEST <= abs(number) <= LARGEST:
        raise wrong("out_of_range", kind=kind.name, least=str(SMALLEST), most=str(LARGEST), unit=Spelt((kind.si,)))
    return number if len(number.as_tuple().digits) <= DIGITS else Context(prec=DIGITS).plus(number)


def within(angle: Fraction) -> Fraction:
    """Take whole turns off an angle in degrees, exactly: as a float it would lose a digit with every ten of them.

    >>> within(Fraction(100_000)), within(Fraction(-725))
    (Fraction(280, 1), Fraction(-5, 1))
    """
    return angle - 360 * int(angle / 360)
