"""Fields of a scene (поля): how each single value is read, with one fault for a wrong one, whatever was meant."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from decimal import Decimal
from functools import partial
from typing import TypeVar

from geometry.errors import LimitError
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.forms import ENTRIES_LIMIT
from plans.scene.readers import Check, FieldReader, many, one
from plans.scene.units import type_name
from plans.words.words import Message, message

T = TypeVar("T")

TITLE_LIMIT = 1_000  # characters
NAME_LIMIT = 40  # characters

NAME = re.compile(r"[^\W\d_]\w*[′']*")


def sample(example: str, how: str = "text") -> Message:
    """Show a text as the file would write it."""
    return message(f"example.{how}", written=f'"{example}"')


def check_name(value: object) -> str:
    """Read the name of one point."""
    if not isinstance(value, str):
        raise wrong("wrong_type", wanted="the name of a point", found=type_name(value), example=sample("D"))
    if not NAME.fullmatch(value) or len(value) > NAME_LIMIT or value != unicodedata.normalize("NFC", value):
        raise wrong("name")
    return value


def check_text(value: object, limit: int = TITLE_LIMIT) -> str:
    """Read a text for the sheet; line ends and tabs become spaces, other invisible characters are faults."""
    if not isinstance(value, str):
        raise wrong("wrong_type", wanted="text", found=type_name(value), example=sample("...", "quoted"))
    text = re.sub(r"[\t\r\n]+", " ", value).strip()
    if len(text) > limit:
        raise wrong("text_length", most=limit)
    for char in text:
        if unicodedata.category(char) in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"):
            raise wrong("text", code=f"U+{ord(char):04X}")
    return text


def flag(value: object) -> bool:
    """Read true or false."""
    if not isinstance(value, bool):
        raise wrong("wrong_type", wanted="true or false", found=type_name(value), example="true")
    return value


def choice(
    value: object, choices: tuple[str, ...], kind: str = "choice", likely: Callable[[object], str] | None = None
) -> str:
    """Read one of the words that are allowed, or what a language calls it; `likely` gives what else it may mean."""
    if isinstance(value, str) and (found := forms.called(value, choices)):
        return found
    near = [meant] if likely and (meant := likely(value)) else forms.likely(value, choices)
    advice = message("advice.meant", names=tuple(f'"{name}"' for name in near)) if near else message("advice.choose")
    raise wrong(kind, choices=choices, suggestion=advice)


def whole(value: object, least: int) -> int:
    """Read a whole number from `least`."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise wrong("not_whole", least=least)
    if value < least:
        raise wrong("too_low", least=least)
    return value


def check_pair(value: object, what: str = "[x, y]") -> object:
    """See that a list has two entries."""
    if not isinstance(value, list) or len(value) != 2:
        found = len(value) if isinstance(value, list) else type_name(value)
        raise wrong("pair", what=what, found=found, advice=message("advice.two", what=what))
    return value


def not_empty(value: T) -> T:
    """See that a list or table has an entry."""
    if not value:
        raise wrong("empty")
    return value


def no_repeats(value: tuple[T, ...]) -> tuple[T, ...]:
    """See that a list names nothing twice."""
    for entry in value:
        if value.count(entry) > 1:
            raise wrong("repeated", entry=entry)
    return value


def few(value: object, limit: int, name: str) -> object:
    """See that a table or list is no longer than a named limit, before its entries are looked at."""
    if isinstance(value, list | dict) and len(value) > limit:
        raise LimitError(message("limit.entries", count=len(value), name=name, limit=limit))
    return value


def number(kind: units.UnitKind) -> FieldReader:
    """Read any number of a kind of quantity."""
    return one(units.quantity, partial(forms.quantity, kind), kind.si, kind=kind)


def not_negative(kind: units.UnitKind) -> FieldReader:
    """Read a quantity of zero or above."""
    return one(units.not_negative, partial(forms.quantity, kind, minimum=0), kind.si, kind=kind)


def positive(kind: units.UnitKind) -> FieldReader:
    """Read a quantity above zero."""
    return one(units.positive, partial(forms.quantity, kind, exclusiveMinimum=0), kind.si, kind=kind)


def words(*choices: str, kind: str = "choice", likely: Callable[[object], str] | None = None) -> FieldReader:
    """Read one of some words."""
    shown = ", ".join(f'"{word}"' for word in choices)
    return one(choice, partial(forms.choice, choices), shown, choices=choices, kind=kind, likely=likely)


def pair(entry: FieldReader, what: str = "[x, y]") -> FieldReader:
    """Read a list of two."""
    two = Check(partial(check_pair, what=what), least=2, most=2)
    return many(entry, first=two)._replace(shown=f"{what} {entry.shown}")


FEW = Check(partial(few, limit=ENTRIES_LIMIT, name="ENTRIES_LIMIT"))
NOT_EMPTY, NO_REPEATS = Check(not_empty, least=1), Check(no_repeats, unique=True)

TEXT = one(check_text, lambda: forms.text(most=TITLE_LIMIT), "text")
POINT = one(check_name, lambda: forms.text(f"^{forms.POINT}$", NAME_LIMIT), "point")
FLAG = one(flag, lambda: {"type": "boolean"}, "true or false")
COORDINATE = one(units.coordinate, lambda: forms.quantity(units.LENGTH, **_sides(units.LENGTH_LIMIT)), "m")
MILLIMETRES = one(units.millimetres, lambda: forms.quantity(units.MILLIMETRES, exclusiveMinimum=0), "mm")
LENGTH = one(
    units.length,
    lambda: forms.quantity(
        units.LENGTH, exclusiveMinimum=0, minimum=float(units.LENGTH_LEAST), maximum=float(units.LENGTH_LIMIT)
    ),
    "m",
)
ANGLE = one(units.angle, lambda: forms.quantity(units.ANGLE, **_sides(units.ANGLE_LIMIT)), "degrees")
PLACE = pair(COORDINATE)
ANGULAR_SPEED = one(units.rate, lambda: forms.rate(units.SPEED), units.SPEED.si, kind=units.SPEED)
ANGULAR_ACCELERATION = one(
    units.rate,
    lambda: forms.rate(units.ANGULAR_ACCELERATION),
    units.ANGULAR_ACCELERATION.si,
    kind=units.ANGULAR_ACCELERATION,
)
MASS, INERTIA = not_negative(units.MASS), not_negative(units.INERTIA)
POSITION = one(whole, lambda: forms.whole(0), "number", least=0)  # of the crank, by its number


def _sides(most: Decimal) -> dict[str, float]:
    return {"minimum": -float(most), "maximum": float(most)}
