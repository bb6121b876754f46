"""Fields of machine dynamics: a coefficient of fluctuation as 0.0125 or "1/80", ratios (величины динамики)."""

from __future__ import annotations

import re
from decimal import Decimal

from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import one
from plans.scene.units import WORKING

FRACTION = re.compile(r"\s*1\s*/\s*([0-9]+(?:\.[0-9]+)?)\s*")
PLAIN = re.compile(r"\s*[+-]?[0-9]+(?:[.,][0-9]+)?(?:[eE][+-]?[0-9]+)?\s*")
WRITTEN = r"^\s*1\s*/\s*(?!0+(?:\.0+)?\s*$)[0-9]+(?:\.[0-9]+)?\s*$"  # for editors
DIVISIONS_LEAST, DIVISIONS_MOST = 12, 4096
RATIO_LIMIT = Decimal("1e4")
TIME = units.Kind(
    "time",
    "s",
    {"s": Decimal(1), "ms": Decimal("0.001"), "с": Decimal(1), "мс": Decimal("0.001")},
    Decimal("1e-9"),
    Decimal("1e6"),
)


def fluctuation(value: object) -> Decimal:
    """Read a coefficient of fluctuation of speed, above 0 and at most 1 (коэффициент неравномерности).

    >>> fluctuation("1/80"), fluctuation(Decimal("0.04"))
    (Decimal('0.0125'), Decimal('0.04'))
    """
    found = units.quantity(_unbroken(value) if isinstance(value, str) else value, units.NUMBER)
    if found == 0:
        raise wrong("no_fluctuation")
    if not 0 < found <= 1:
        raise wrong("fluctuation")
    return found


def _unbroken(text: str) -> Decimal | str:
    """Give "1/80" as a number; a decimal comma and a number in quotes have advice of their own."""
    told = FRACTION.fullmatch(text)
    if told and Decimal(told[1]):
        return WORKING.divide(Decimal(1), Decimal(told[1]))
    if told or not PLAIN.fullmatch(text):
        raise wrong("fluctuation_written")
    return text


def divisions(value: object) -> int:
    """Read the number of strips of a turn."""
    found = f.whole(value, DIVISIONS_LEAST)
    if found > DIVISIONS_MOST:
        raise wrong("too_many_strips", most=DIVISIONS_MOST)
    return found


def ratio(value: object) -> Decimal:
    """Read how many turns a shaft makes for one of the crank; negative where it turns against it."""
    found = units.quantity(value, units.NUMBER)
    if found == 0 or abs(found) > RATIO_LIMIT:
        raise wrong("shaft_ratio", most=f"{RATIO_LIMIT:f}")
    return found


FLUCTUATION = one(
    fluctuation,
    lambda: {
        "anyOf": [{"type": "number", "exclusiveMinimum": 0, "maximum": 1}, {"type": "string", "pattern": WRITTEN}]
    },
    'share, or "1/80"',
)
DIVISIONS = one(divisions, lambda: forms.whole(DIVISIONS_LEAST) | {"maximum": DIVISIONS_MOST}, "number")
RATIO = one(ratio, lambda: forms.quantity(units.NUMBER) | {"not": {"const": 0}}, "number")
INERTIA = f.positive(units.INERTIA)
MATERIAL = f.positive(units.DENSITY)
SHARE = f.positive(units.NUMBER)
STEP = f.positive(TIME)
