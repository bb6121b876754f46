"""Forms of single values in a JSON Schema: quantities with their units, lists and tables (формы значений)."""

from __future__ import annotations

from typing import Any

from plans.scene.units import LARGEST, RATE_LIMIT, Kind

Form = dict[str, Any]

ENTRIES_LIMIT = 1_000  # of any table or list that has no other limit; 60 links have far fewer points, lengths and loads
NUMBER = r"\s*[+-]?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?\s*"
# Any letter of any alphabet, in what the regular expressions of all editors understand: no class of signs in ASCII.
ANY_LETTER = r"[A-Za-z\u00aa-\uffff]"
POINT = rf"{ANY_LETTER}[0-9A-Za-z_\u00aa-\uffff]*['\u2032]*"


def text_with_unit(kind: Kind) -> str:
    """Give the pattern of a number with a unit; kg·m², kg*m^2 and kg m2 are one unit.

    >>> import re
    >>> from plans.scene import units
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


def choice(words: tuple[str, ...]) -> Form:
    """Give the form of one of some words."""
    return {"enum": list(words)}


def text(pattern: str = "", most: int | None = None) -> Form:
    """Give the form of a text."""
    return {"type": "string"} | ({"pattern": pattern} if pattern else {}) | ({"maxLength": most} if most else {})


def entries(form: Form, least: int = 0, most: int | None = None, **more: Any) -> Form:
    """Give the form of a list."""
    return {"type": "array", "items": form, "minItems": least, "maxItems": most or ENTRIES_LIMIT, **more}


def named(form: Form, pattern: str, least: int = 0, most: int | None = None) -> Form:
    """Give the form of a table whose keys are names or numbers of one pattern."""
    table: Form = {"type": "object", "patternProperties": {pattern: form} if pattern else form}
    fewest = {"minProperties": least} if least else {}
    return {**table, "additionalProperties": False, "maxProperties": most or ENTRIES_LIMIT, **fewest}
