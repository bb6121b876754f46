"""Forms of single values in a JSON Schema: quantities with their units, names, lists and tables (формы значений)."""

from __future__ import annotations

from typing import Any

from plans.scene import units
from plans.scene.fields import ENTRIES_LIMIT, LINKS_LIMIT, NAME_LIMIT, TITLE_LIMIT
from plans.scene.units import ANGLE_LIMIT, COEFFICIENT_LIMIT, LARGEST, LENGTH_LEAST, LENGTH_LIMIT, RATE_LIMIT, Kind

Form = dict[str, Any]

NUMBER = r"\s*[+-]?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?\s*"
# Any letter of any alphabet, in what the regular expressions of all editors understand: no class of signs in ASCII.
ANY_LETTER = r"[A-Za-z\u00aa-\uffff]"
POINT = rf"{ANY_LETTER}[0-9A-Za-z_\u00aa-\uffff]*['\u2032]*"
LETTER = r"[A-ZА-ЯЁ][0-9]*['\u2032]*"
LINK = r"^[1-9][0-9]{0,5}$"


def text_with_unit(kind: Kind) -> str:
    """Give the pattern of a number with a unit; kg·m², kg*m^2 and kg m2 are one unit.

    >>> import re
    >>> [bool(re.search(text_with_unit(units.MOMENT), text)) for text in ("3 N·m", "3 N m", "3 N", "3 m*N")]
    [True, True, False, False]
    """
    written = [
        "".join({"*": r"(\s*[*·⋅]\s*|\s+)", "/": r"\s*/\s*", "2": r"(2|²|\^2|\*\*2)"}.get(sign, sign) for sign in unit)
        for unit in kind.units
    ]
    return rf"^{NUMBER}({'|'.join(written)})\s*$"


def quantity(kind: Kind, **bounds: float) -> Form:
    """Give the form of a quantity: a bare number in SI units (angles: degrees), or text with a unit."""
    most = {} if kind.most == LARGEST else {"maximum": float(kind.most)}
    least = {"minimum": -most["maximum"]} if most else {}
    number: Form = {"type": "number", **least, **most, **bounds}
    if not kind.units:
        return number
    return {"anyOf": [number, {"type": "string", "pattern": text_with_unit(kind)}]}


def rate(kind: Kind) -> Form:
    """Give the form of an angular velocity or acceleration."""
    return quantity(kind, minimum=-float(RATE_LIMIT), maximum=float(RATE_LIMIT))


def whole(least: int) -> Form:
    """Give the form of a whole number."""
    return {"type": "integer", "minimum": least}


def entries(form: Form, least: int = 0, most: int = ENTRIES_LIMIT, **more: Any) -> Form:
    """Give the form of a list."""
    return {"type": "array", "items": form, "minItems": least, "maxItems": most, **more}


def pair(form: Form) -> Form:
    """Give the form of two numbers."""
    return entries(form, 2, 2)


def named(form: Form, pattern: str, most: int = ENTRIES_LIMIT, **more: Any) -> Form:
    """Give the form of a table whose keys are names or numbers of one pattern."""
    table = {"type": "object", "patternProperties": {pattern: form}, "additionalProperties": False}
    return {**table, "maxProperties": most, **more}


LENGTH = quantity(units.LENGTH, exclusiveMinimum=0, minimum=float(LENGTH_LEAST), maximum=float(LENGTH_LIMIT))
COORDINATE = quantity(units.LENGTH, minimum=-float(LENGTH_LIMIT), maximum=float(LENGTH_LIMIT))
ANGLE = quantity(units.ANGLE, minimum=-float(ANGLE_LIMIT), maximum=float(ANGLE_LIMIT))
FORCE, GRAVITY = quantity(units.FORCE), quantity(units.ACCELERATION)
FRICTION = quantity(units.NUMBER, minimum=0, maximum=float(COEFFICIENT_LIMIT))
PLACE = pair(COORDINATE)
NAME = {"type": "string", "pattern": f"^{POINT}$", "maxLength": NAME_LIMIT}
NAMES = entries(NAME, 1, LINKS_LIMIT, uniqueItems=True)
LETTERS = {"anyOf": [{"type": "string", "pattern": f"^({LETTER})+$"}, NAMES]}
LINE = {"anyOf": [{"type": "string", "pattern": f"^({LETTER}){{2}}$"}, {**NAMES, "minItems": 2, "maxItems": 2}]}
TEXT = {"type": "string", "maxLength": TITLE_LIMIT}
MOVING, ANY_LINK, POSITION = whole(1), whole(0), whole(0)
SHARE = {"type": "number", "minimum": 0, "exclusiveMaximum": 1}
SYMBOL = {"type": "string", "pattern": rf"^{ANY_LETTER}[0-9A-Za-z_\u00aa-\uffff.'-]*$", "maxLength": NAME_LIMIT}
PAIR = r"^(0|[1-9][0-9]{0,5})-[1-9][0-9]{0,5}$"
LENGTH_NAME = f"^({LETTER}{LETTER}|{POINT}-{POINT})$"


def choice(words: tuple[str, ...], **more: Any) -> Form:
    """Give the form of one of some words."""
    return {"enum": list(words), **more}
