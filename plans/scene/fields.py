"""Fields of a scene (поля): how each single value is read, with one fault for a wrong one, whatever was meant."""

from __future__ import annotations

import re
import unicodedata
from decimal import Decimal
from functools import partial
from typing import Literal, TypeVar

from geometry.errors import LimitError
from plans.scene import units
from plans.scene.faults import suggestion, wrong
from plans.scene.tables import either, many, one
from plans.scene.units import type_name
from plans.words.words import Message, message, placed

T = TypeVar("T")

POSITIONS_LIMIT = 100_000
MANY = message("limit.more", name="POSITIONS_LIMIT", limit=POSITIONS_LIMIT)
ENTRIES_LIMIT = 1_000  # of any other table or list; 60 links have far fewer points, lengths and loads
TITLE_LIMIT = 1_000  # characters
NAME_LIMIT = 40  # characters
LINKS_LIMIT = 60

LETTER = re.compile(r"[A-ZА-ЯЁ][0-9]*[′']*")
NAME = re.compile(r"[^\W\d_]\w*[′']*")
LINK = re.compile(r"[1-9][0-9]{0,5}")
LINKS_OF_PAIR = re.compile(r"(0|[1-9][0-9]{0,5})-(0|[1-9][0-9]{0,5})")
# What a force sheet letters itself: reactions, weights, inertia forces, moments of sliding pairs, what the drive gives.
TAKEN = re.compile(r"[RPF]_?\d+,?\d+|[GΦ]_?\d+|M_?\d\d+|[MP]_?bal")
SYMBOL_SIGNS = re.compile(r"[^\W\d_][\w.′'-]*")


def split_letters(text: str) -> tuple[str, ...]:
    """Split the letters of a link or a line into its points; nothing where they are no letters.

    >>> split_letters("OAB1"), split_letters("O'B"), split_letters("crank")
    (('O', 'A', 'B1'), ("O'", 'B'), ())
    """
    points = LETTER.findall(text)
    return tuple(points) if "".join(points) == text else ()


def split_line(text: str) -> tuple[str, ...]:
    """Split the key of a length: two letters, or two longer names with a hyphen between them."""
    return split_letters(text) or tuple(text.split("-"))


def _text(example: str, how: str = "text") -> Message:
    return message(f"example.{how}", written=f'"{example}"')


def check_name(value: object) -> str:
    """Read the name of one point."""
    if not isinstance(value, str):
        raise wrong(
            "wrong_type",
            wanted="the name of a point",
            found=type_name(value),
            example=_text("D"),
        )
    if not NAME.fullmatch(value) or len(value) > NAME_LIMIT or value != unicodedata.normalize("NFC", value):
        raise wrong("name")
    return value


def check_letters(value: object) -> tuple[str, ...]:
    """Read the points of a link or a line: letters in a row, or a list of longer names."""
    if isinstance(value, list) and value:
        few(value, LINKS_LIMIT, "LINKS_LIMIT")
        names = tuple(check_name(name) for name in value)
    elif isinstance(value, str):
        names = split_letters(value)
        few(list(names), LINKS_LIMIT, "LINKS_LIMIT")
        if not names:
            raise wrong("letters")
    else:
        raise wrong(
            "wrong_type",
            wanted="letters of points",
            found=type_name(value),
            example=_text("OA"),
        )
    for name in names:
        if names.count(name) > 1:
            raise wrong("repeated", entry=name)
    return names


def check_line(value: object) -> tuple[str, ...]:
    """Read a line named by two points, as along = "CB"; equal points have no direction."""
    if isinstance(value, int | Decimal) and not isinstance(value, bool):
        wanted, example = "letters of points", f"along = {{ through = [0, 0], angle = {value} }}"
        raise wrong("wrong_type", wanted=wanted, found=type_name(value), example=example)
    if isinstance(value, str) and len(set(split_letters(value))) == 1 == len(split_letters(value)) - 1:
        raise wrong("no_direction", first=value[: len(value) // 2], second=value[len(value) // 2 :])
    names = check_letters(value)
    if len(names) != 2:
        raise wrong("two_letters")
    return names


def check_text(value: object, limit: int = TITLE_LIMIT) -> str:
    """Read a text for the sheet; line ends and tabs become spaces, other invisible characters are faults."""
    if not isinstance(value, str):
        raise wrong("wrong_type", wanted="text", found=type_name(value), example=_text("...", "quoted"))
    text = re.sub(r"[\t\r\n]+", " ", value).strip()
    if len(text) > limit:
        raise wrong("text_length", most=limit)
    for char in text:
        if unicodedata.category(char) in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"):
            raise wrong("text", code=f"U+{ord(char):04X}")
    return text


def check_symbol(value: object) -> str:
    """Read the letters of a load as they stand on the sheet: F_us, M_3.

    >>> check_symbol("F_us")
    'F_us'
    """
    if not isinstance(value, str):
        raise wrong(
            "wrong_type",
            wanted="the letters of a load",
            found=type_name(value),
            example=_text("F_us"),
        )
    if not SYMBOL_SIGNS.fullmatch(value) or len(value) > NAME_LIMIT or value != unicodedata.normalize("NFC", value):
        raise wrong("symbol")
    if TAKEN.fullmatch(value):
        raise wrong("symbol_taken", name=value)
    return value


def check_pair_name(value: object) -> str:
    """Read the name of a pair of links, the lower number first: 0-1."""
    found = LINKS_OF_PAIR.fullmatch(value) if isinstance(value, str) else None
    low, high = sorted((int(found[1]), int(found[2]))) if found else (0, 0)
    if low == high:
        raise wrong("pair_name", example="0-1")
    if value != f"{low}-{high}":
        raise wrong("pair_name", example=f"{low}-{high}")
    return value


def check_ends(value: object) -> None:
    """See that a spring has two ends."""
    if not isinstance(value, list) or len(value) != 2:
        raise wrong("two_ends", found=len(value) if isinstance(value, list) else type_name(value))


def flag(value: object) -> bool:
    """Read true or false."""
    if not isinstance(value, bool):
        raise wrong("wrong_type", wanted="true or false", found=type_name(value), example="true")
    return value


def share(value: object) -> Decimal:
    """Read a share of the stroke."""
    if not 0 <= (result := units.quantity(value, units.NUMBER)) < 1:
        raise wrong("share")
    return result


def loaded_link(value: object) -> int:
    """Read the number of a link that a load acts on."""
    if value == 0 and not isinstance(value, bool):
        raise wrong("loaded_frame")
    return whole(value, 1)


def choice(value: object, choices: tuple[str, ...], kind: str = "choice") -> str:
    """Read one of the words that are allowed."""
    if not isinstance(value, str):
        raise wrong(
            "wrong_type",
            wanted="text",
            found=type_name(value),
            example=_text(choices[0]),
        )
    if value not in choices:
        listed, advice = ", ".join(choices), message("advice.write", name=choices[0])
        raise wrong(kind, choices=listed, suggestion=suggestion(value, choices, advice))
    return value


def whole(value: object, least: int) -> int:
    """Read a whole number from `least`."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise wrong("not_whole", least=least)
    if value < least:
        raise wrong("too_low", least=least)
    return value


def moving_link(value: object) -> int:
    """Read the number of a moving link."""
    if value == 0 and not isinstance(value, bool):
        raise wrong("frame_moves")
    return whole(value, 1)


def link_key(key: object) -> int:
    """Read a key that is a link's number; 0 is the frame."""
    if not LINK.fullmatch(str(key)):
        raise wrong("link_number")
    return int(str(key))


def check_pair(value: object, what: str = "[x, y]") -> object:
    """See that a list has two entries; four or three of them are mostly decimal commas."""
    if not isinstance(value, list):
        raise wrong("pair", what=what, found=type_name(value), advice=message("advice.two", what=what))
    if len(value) != 2:
        commas = len(value) in (3, 4) and any(isinstance(entry, int) for entry in value)
        advice = message("advice.decimal_comma") if commas else message("advice.two", what=what)
        raise wrong("pair", what=what, found=len(value), advice=advice)
    return value


def start_angle(value: object) -> Decimal | Literal["extreme"]:
    """Read the first crank angle, or the word extreme."""
    if isinstance(value, str) and re.fullmatch(r"[A-Za-z_ ]+", value):
        choice(value, ("extreme",))
        return "extreme"
    return units.angle(value)


def count_positions(value: object) -> int:
    """Read the number of positions, before anything of that size is made."""
    if isinstance(value, Decimal) or (isinstance(value, int) and not isinstance(value, bool)):
        value = whole(value, 1)
    else:
        wanted = "a whole number, or a list of crank angles"
        raise wrong("wrong_type", wanted=wanted, found=type_name(value), example="positions = 12")
    if value > POSITIONS_LIMIT:
        raise LimitError(placed(f"drive.positions = {value}", MANY))
    return value


def position_list(value: tuple[Decimal, ...]) -> tuple[Decimal, ...]:
    """See that no position of a list is given twice, a turn more or less included."""
    if not value:
        raise wrong("empty")
    if len(value) > POSITIONS_LIMIT:
        raise LimitError(placed("drive.positions", MANY))
    seen: dict[Decimal, Decimal] = {}
    for place in value:
        # In EXACT the remainder is exact; a whole turn more is the same position of the crank.
        turn = units.EXACT.remainder(place, Decimal(360))
        turn = units.EXACT.add(turn, Decimal(360)) if turn < 0 else turn
        if turn in seen:
            raise wrong("repeated", entry=f"{place.normalize(units.WORKING):f} deg", at=(len(seen),))
        seen[turn] = place
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


FEW = partial(few, limit=ENTRIES_LIMIT, name="ENTRIES_LIMIT")
FEW_LINKS = partial(few, limit=LINKS_LIMIT, name="LINKS_LIMIT")

ANY = one(lambda value: value)
POINT, LETTERS, TEXT = one(check_name), one(check_letters), one(check_text)
LINE = one(check_line)
COORDINATE, LENGTH, ANGLE = one(units.coordinate), one(units.length), one(units.angle)
PLACE = many(COORDINATE, first=check_pair)
ANGULAR_SPEED = one(units.rate, kind=units.SPEED)
ANGULAR_ACCELERATION = one(units.rate, kind=units.ANGULAR_ACCELERATION)
GRAVITY = one(units.quantity, kind=units.ACCELERATION)
STIFFNESS = one(units.positive, kind=units.STIFFNESS)
FREE_LENGTH = one(units.free_length)
FRICTION = one(units.friction)
PRESSURE_ANGLE = one(units.pressure_angle)
SHARE, FLAG, SYMBOL, PAIR = one(share), one(flag), one(check_symbol), one(check_pair_name)
MASS, INERTIA = one(units.not_negative, kind=units.MASS), one(units.not_negative, kind=units.INERTIA)
FORCE, MOMENT = one(units.quantity, kind=units.FORCE), one(units.quantity, kind=units.MOMENT)
NUMBER = one(units.quantity, kind=units.NUMBER)
LINK_NUMBER = one(link_key)  # as a key
MOVING_LINK, LOADED_LINK = one(moving_link), one(loaded_link)
ANY_LINK = POSITION_NUMBER = one(whole, least=0)
START = one(start_angle)
POSITIONS = either(list, many(ANGLE, position_list), one(count_positions))
