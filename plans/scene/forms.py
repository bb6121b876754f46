"""Forms of all techniques in one scene, and what they demand of each other (исходные данные)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any

from plans.scene.faults import Path, nearest
from plans.scene.units import COMMA, FACTOR, LARGEST, MEGA, RATE_LIMIT, SYMBOLS, WRITTEN, UnitKind, folded
from plans.techniques import TECHNIQUES, Technique, techniques
from plans.words.words import languages, spoken

Form = dict[str, Any]

ENTRIES_LIMIT = 1_000  # of any table or list that has no other limit; 60 links have far fewer points, lengths and loads
SIGNS = {  # of a unit, as they may be written
    **{"*": r"\s*[*·⋅]?\s*", "/": r"\s*/\s*", "1": "1", "-1": r"((\^|\*\*)?-1|⁻¹)"},
    **{"2": r"(2|²|\^2|\*\*2)", "3": r"(3|³|\^3|\*\*3)"},
}
LETTERS = "".join(map(chr, (*range(65, 91), *range(97, 123), *range(0x410, 0x450))))  # Latin and Russian ones
# Any letter of any alphabet, in what the regular expressions of all editors understand: no class of signs in ASCII.
ANY_LETTER = r"[A-Za-z\u00aa-\uffff]"
POINT = rf"{ANY_LETTER}[0-9A-Za-z_\u00aa-\uffff]*['\u2032]*"


def text_with_unit(kind: UnitKind) -> str:
    """Give the pattern of a number with a unit; kg·m², kg*m^2 and kg m2 are one unit, as are kN, КН and кН.

    >>> import re
    >>> from plans.scene import units
    >>> [bool(re.search(text_with_unit(units.MOMENT), text)) for text in ("3 N·m", "3 N m", "3 Н·м", "3 N", "3 m*N")]
    [True, True, True, False, False]
    """
    written = [part for form in kind.forms for part in _products(FACTOR.findall(form))]
    lettered = "|".join(part for part in written if part[0] != "1")
    counted = "".join(rf"|\s+({part})" for part in written if part[0] == "1")
    whole = rf"({WRITTEN}(\s*({lettered}){counted})|{COMMA})" if written else COMMA
    return rf"^\s*{whole}\s*$".replace("(?:", "(")


def _products(factors: list[tuple[str, str, str]]) -> Iterator[str]:
    """Give the patterns of a product of groups; of a group that is a product already, one for each unit."""
    symbols = [[symbol for row in SYMBOLS[group] for symbol in row.split()[1:]] for _, group, _ in factors]
    if len(factors) == 1:
        yield from dict.fromkeys(map(_pattern, symbols[0]))
    else:
        parts = zip(factors, ("|".join(dict.fromkeys(map(_pattern, some))) for some in symbols), strict=True)
        yield "".join(f"{_pattern(sign)}({group}){_pattern(power)}" for (sign, _, power), group in parts)


def _pattern(unit: str) -> str:
    return re.sub(r"-1|.", lambda sign: SIGNS.get(sign[0]) or _letter(sign[0]), unit)


def _letter(letter: str) -> str:
    """Give the pattern of a letter: small or large, of either alphabet; a mega is large."""
    alike = MEGA if letter in MEGA else "".join(sign for sign in LETTERS if folded(sign) == folded(letter))
    return f"[{alike}]" if alike else letter


def quantity(kind: UnitKind, **bounds: float) -> Form:
    """Give the form of a quantity: a bare number in SI units (angles: degrees), or text with a unit."""
    most = {} if kind.most == LARGEST else {"maximum": float(kind.most)}
    least = {"minimum": -most["maximum"]} if most else {}
    number: Form = {"type": "number", **least, **most, **bounds}
    return {"anyOf": [number, {"type": "string", "pattern": text_with_unit(kind)}]}


def rate(kind: UnitKind) -> Form:
    """Give the form of an angular velocity or acceleration."""
    return quantity(kind, minimum=-float(RATE_LIMIT), maximum=float(RATE_LIMIT))


def whole(least: int) -> Form:
    """Give the form of a whole number."""
    return {"type": "integer", "minimum": least}


def choice(words: tuple[str, ...]) -> Form:
    """Give the form of one of some words, or of what a language calls it."""
    return {"enum": list(dict.fromkeys([*words, *(said for said, _ in _said(words, "kind"))]))}


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


SHEETS = tuple(sheet for technique in techniques().values() for sheet in technique.sheets)
PLANS = tuple(plan for technique in techniques().values() for plan in technique.plans)


def called(name: object, own: tuple[str, ...] = SHEETS, group: str = "kind") -> str:
    """Give which of some words, of sheets or plans, a text is in any language, however it is cased; else nothing.

    >>> called("Force"), called("Силовой расчет"), called("план скоростей", PLANS, "plan"), called("speed")
    ('forces', 'forces', 'velocities', '')
    """
    return str(name) if name in own else natural(own, group).get(_plain(name), "")


def likely(name: object, own: tuple[str, ...], group: str = "kind") -> tuple[str, ...]:
    """Give those of some words whose names in any language are nearest to a text, or begin alike: силовая."""
    names, text = natural(own, group), _plain(name)
    alike = [known for known in names if text.startswith(known[:3])]
    return tuple(dict.fromkeys(names[near] for near in nearest(text, names) or alike))


@cache
def natural(own: tuple[str, ...], group: str = "kind") -> Mapping[str, str]:
    """Give some words by what they are called in each language; those of the file itself go before others."""
    return {_plain(said): name for said, name in [*_said(own, group), *((name, name) for name in own)]}


def _said(own: tuple[str, ...], group: str) -> Iterator[tuple[str, str]]:
    for name in own:
        yield from ((said, name) for language in languages() for said in spoken(language, name, group))


def _plain(name: object) -> str:
    """Give a name without its case and the sign of a plural, and with one letter for those that look alike."""
    return folded(str(name).casefold().replace("ё", "е").strip().removesuffix("s").rstrip("аеиоуыьэюяй"))


def with_sheets_named(data: Mapping[str, Any]) -> Mapping[str, Any]:
    """Give a file with its sheets by their own names, where another name is understood."""
    wanted = data.get("sheets")
    return {**data, "sheets": [called(name) or name for name in wanted]} if isinstance(wanted, list) else data


def techniques_of(data: Mapping[str, Any]) -> tuple[str, ...]:
    """Name the techniques that a file has a part in, by a sheet, a table or a key, and those that they build on."""
    return reading([name for name, technique in techniques().items() if next(_parts(technique, data), None)])


def reading(names: Iterable[str]) -> tuple[str, ...]:
    """Add to some techniques those whose tables they read: they rest on them, or borrow from them.

    >>> reading(["dynamics"])
    ('linkage', 'forces', 'dynamics')
    """
    asked = resting(names)
    return resting([*asked, *(other for name in asked for other in techniques()[name].borrows)])


def resting(names: Iterable[str]) -> tuple[str, ...]:
    """Add to some techniques those that they rest on, in the order of the table.

    >>> resting(["forces"])
    ('linkage', 'forces')
    """
    waiting = list(names)
    for name in waiting:
        waiting += techniques()[name].needs
    return tuple(name for name in TECHNIQUES if name in waiting)


def first_sheet(data: Mapping[str, Any]) -> tuple[str, ...]:
    """Give the sheet of a file that asks for none: the first of the first technique that it has a table of."""
    found = (technique for technique in techniques().values() if any(name in data for name in technique.tables))
    return next(((next(iter(technique.sheets)),) for technique in found), ())


def needing(table: str, data: Mapping[str, Any]) -> Path:
    """Find the key of a file that needs a table which it lacks: a sheet first, else a table or a key."""
    owner = next((name for name, technique in techniques().items() if table in technique.tables), "")
    others = [technique for name, technique in techniques().items() if owner in resting([name])]
    parts = (part for technique in others for part in _parts(technique, data))
    return min(parts, key=lambda path: 0 if path == ("sheets",) else len(path), default=())


def _parts(technique: Technique, data: Mapping[str, Any]) -> Iterator[Path]:
    wanted = data.get("sheets")
    if isinstance(wanted, list) and any(sheet in wanted for sheet in technique.sheets):
        yield ("sheets",)
    yield from ((name,) for name in technique.tables if name in data)
    for table, names in technique.shares.items():
        given = data.get(table)
        yield from ((table, name) for name in names if isinstance(given, dict) and name in given)
