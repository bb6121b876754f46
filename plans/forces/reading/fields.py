"""Fields of masses and loads: letters of loads, shares of a stroke, quantities of forces (величины нагрузок)."""

from __future__ import annotations

import re
import unicodedata
from decimal import Decimal

from plans.linkage.reading import fields as g
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Wrong, wrong
from plans.scene.fields import NAME_LIMIT, not_empty, number, pair, positive, sample, whole
from plans.scene.readers import Check, either, one
from plans.scene.units import type_name

# What a force sheet letters itself: reactions, weights, inertia forces, moments of sliding pairs, what the drive gives.
TAKEN = re.compile(r"[RPF]_?\d+,?\d+|[GΦ]_?\d+|M_?\d\d+|[MP]_?bal")
PER_CENT = re.compile(r"^\s*([+-]?[0-9]+(?:\.[0-9]+)?)\s*%\s*$")
FORCE_OR_PRESSURE = units.Kind("force or pressure", "N", {**units.FORCE.units, **units.PRESSURE.units})
SYMBOL_SIGNS = re.compile(r"[^\W\d_][\w.′'-]*")


def check_symbol(value: object) -> str:
    """Read the letters of a load as they stand on the sheet: F_us, M_3.

    >>> check_symbol("F_us")
    'F_us'
    """
    if not isinstance(value, str):
        raise wrong("wrong_type", wanted="the letters of a load", found=type_name(value), example=sample("F_us"))
    if not SYMBOL_SIGNS.fullmatch(value) or len(value) > NAME_LIMIT or value != unicodedata.normalize("NFC", value):
        raise wrong("symbol")
    if TAKEN.fullmatch(value):
        raise wrong("symbol_taken", name=value)
    return value


def check_ends(value: object) -> None:
    """See that a spring has two ends."""
    if not isinstance(value, list) or len(value) != 2:
        raise wrong("two_ends", found=len(value) if isinstance(value, list) else type_name(value))


def share(value: object) -> Decimal:
    """Read a share of the stroke."""
    if not 0 <= (result := units.quantity(value, units.NUMBER)) < 1:
        raise wrong("share")
    return result


def line(value: object) -> Decimal | tuple[str, ...]:
    """Read a direction: an angle in degrees, or the letters of two points.

    >>> line("AB"), line("90 deg")
    (('A', 'B'), Decimal('90'))
    """
    lettered = isinstance(value, str) and value[:1].isalpha()
    return g.check_line(value) if lettered or isinstance(value, list) else units.angle(value)


class Metres(Decimal):
    """A place that the scene gives as a length, m."""


class Newtons(Decimal):
    """A size that the scene gives in units of force, N."""


class Pascals(Decimal):
    """A size that the scene gives in units of pressure, Pa."""


def place(value: object) -> Decimal:
    """Read a place of the stroke: a share of it, per cent, or a length.

    >>> place("15 %"), place("30 mm")
    (Decimal('0.15'), Decimal('0.030'))
    """
    if not isinstance(value, str):
        return units.quantity(value, units.NUMBER)
    found = PER_CENT.fullmatch(value)
    if found:
        per_cent = units.quantity(Decimal(found[1]), units.NUMBER)
        if not 0 <= per_cent <= 100:
            raise wrong("travel_per_cent", found=f"{per_cent:f} %")
        return per_cent.scaleb(-2)
    return Metres(units.quantity(value, units.LENGTH))


def back(value: object) -> Decimal:
    """Read a size on the stroke back: a bare number, or a force or a pressure with its unit."""
    if not isinstance(value, str):
        return units.quantity(value, units.FORCE)
    units.quantity(value, FORCE_OR_PRESSURE)
    try:
        return Pascals(units.quantity(value, units.PRESSURE))
    except Wrong as wrong_pressure:
        if wrong_pressure.kind != "wrong_unit":
            raise
        return Newtons(units.quantity(value, units.FORCE))


def loaded_link(value: object) -> int:
    """Read the number of a link that a load acts on."""
    if value == 0 and not isinstance(value, bool):
        raise wrong("loaded_frame")
    return whole(value, 1)


# Of a diagram over the stroke; that its lists are as long as each other is seen to by the table.
TWO, AS_MANY = Check(not_empty, least=2), Check(lambda entries: entries, least=2)
SYMBOL = one(
    check_symbol, lambda: forms.text(rf"^{forms.ANY_LETTER}[0-9A-Za-z_\u00aa-\uffff.'-]*$", NAME_LIMIT), "letters"
)
DIRECTION = one(line, lambda: {"anyOf": [f.ANGLE.form(), g.LINE.form()]}, "degrees, or two points")
LOADED_LINK = one(loaded_link, lambda: forms.whole(1), "link")
_PART = {"type": "number", "minimum": 0, "maximum": 1}
_LENGTH = {"type": "string", "pattern": forms.text_with_unit(units.LENGTH)}
SHARE = one(share, lambda: {"type": "number", "minimum": 0, "exclusiveMaximum": 1}, "share")
OVERRUN = either(list, pair(SHARE, "[start, end]"), SHARE)
TRAVEL = one(place, lambda: {"anyOf": [_PART, forms.text(PER_CENT.pattern), _LENGTH]}, "share or m")
PRESSURE = number(units.PRESSURE)
BACK = one(back, lambda: {"anyOf": [forms.quantity(units.PRESSURE), forms.quantity(units.FORCE)]}, "N or Pa")
FORCE, MOMENT, GRAVITY = number(units.FORCE), number(units.MOMENT), number(units.ACCELERATION)
STIFFNESS = positive(units.STIFFNESS)
FREE_LENGTH = one(
    units.free_length, lambda: forms.quantity(units.LENGTH, minimum=0, maximum=float(units.LENGTH_LIMIT)), "m"
)
FRICTION = one(
    units.friction, lambda: forms.quantity(units.NUMBER, minimum=0, maximum=float(units.COEFFICIENT_LIMIT)), "number"
)
PRESSURE_ANGLE = one(
    units.pressure_angle,
    lambda: forms.quantity(units.ANGLE, minimum=0, maximum=float(units.PRESSURE_LIMIT)),
    "degrees",
)
