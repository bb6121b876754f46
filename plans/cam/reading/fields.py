"""Fields of a cam: angles left to the rest of the turn, quantities of two kinds, laws (величины кулачка)."""

from __future__ import annotations

import re
from decimal import Decimal
from functools import partial
from itertools import chain
from typing import Any, NamedTuple

from geometry.errors import LimitError
from plans.model.cam import LAWS
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import FieldReader, one
from plans.scene.units import UnitKind
from plans.words.words import message, placed

REST, CYCLOGRAM = "rest", "cyclogram"  # of an angle: what the others leave of the turn; what the cyclogram gives
DIVISIONS_LEAST, DIVISIONS_MOST = 2, 360
COORDINATES_LEAST, COORDINATES_LIMIT = 4, 36_000  # a hundredth of a degree: finer than any profile is made
SWING_LIMIT = Decimal(180)  # degrees: a rocker that reaches it has gone through its line of centres
PRESSURE_LEAST = Decimal(1)  # degrees: less leaves the diagram of sizes no width; limits in radians are less
PRESSURE_LIMIT = Decimal(90)  # degrees: there a follower jams without any friction


class Measure(NamedTuple):
    """A quantity as the file writes it, of one of two kinds: which is known when its cam is."""

    written: Any

    def of(self, kind: UnitKind) -> Decimal:
        """Give it in the unit of a kind (SI, angles in degrees); of the other kind it is Wrong."""
        return units.quantity(self.written, kind)


def _joint(*kinds: UnitKind) -> UnitKind:
    """Give what takes the units of several kinds; sizes of them are not compared."""
    forms, listed = (tuple(chain(*parts)) for parts in ((k.forms for k in kinds), (k.listed for k in kinds)))
    return UnitKind(" or ".join(kind.name for kind in kinds), kinds[0].si, forms, listed)


def measure(*kinds: UnitKind, least: Decimal | None = None) -> FieldReader:
    """Read a quantity of one of some kinds, `least` 0 where it cannot be negative."""
    joint = _joint(*kinds)

    def check(value: object) -> Measure:
        _ = units.quantity(value, joint) if least is None else units.not_negative(value, joint)
        return Measure(value)

    bounds = {} if least is None else {"minimum": float(least)}
    return one(check, partial(forms.quantity, joint, **bounds), " or ".join(kind.si for kind in kinds))


def angle_or(value: object, words: tuple[str, ...]) -> Decimal | str:
    """Read an angle of a phase in degrees, of 0 or above, or a word that stands for one."""
    if isinstance(value, str) and value[:1].isalpha():
        return f.choice(value, words, "angle_word")
    found = units.angle(value)
    if found < 0:
        raise wrong("negative", kind="angle")
    return found


def setting(value: object) -> Decimal | str:
    """Read the turn of the main shaft in degrees at which a cam begins, or leave it to the cyclogram."""
    if isinstance(value, str) and value[:1].isalpha():
        return f.choice(value, (CYCLOGRAM,), "angle_word")
    return units.angle(value)


def check_cam_name(value: object) -> str:
    """Read the name of a cam, which figures of the sheet are named after.

    >>> check_cam_name("впуск-1")
    'впуск-1'
    """
    text = f.check_text(value, f.NAME_LIMIT)
    if not re.fullmatch(r"[\w.-]*", text):
        bare = re.sub(r"[^\w.]+", "-", text).strip("-")
        raise wrong("cam_name", example=f.sample(bare or "I", "quoted"))
    return text


def _angle_or(angle: Form, *words: str) -> Form:
    return {"anyOf": [*angle["anyOf"], forms.choice(words)]}


def below(value: object, most: Decimal, kind: str, least: bool = False) -> Decimal:
    """Read an angle in degrees from 0 to less than a limit; 0 itself only with `least`."""
    found = units.quantity(value, units.ANGLE)
    if not (0 < found < most or (least and found == 0)):
        raise wrong(kind, most=f"{most}")
    return found


def limit(value: object) -> Decimal:
    """Read a limit of the pressure angle in degrees."""
    found = below(value, PRESSURE_LIMIT, "pressure_limit")
    if found < PRESSURE_LEAST:
        raise wrong("pressure_limit_tiny", least=f"{PRESSURE_LEAST}", example=f"{found}")
    return found


def first(value: object) -> Decimal:
    """Read the share of a phase that accelerates, between 0 and 1."""
    found = units.quantity(value, units.NUMBER)
    if not 0 < found < 1:
        raise wrong("share_of_phase")
    return found


def divisions(value: object) -> int:
    """Read the number of parts of a phase."""
    found = f.whole(value, DIVISIONS_LEAST)
    if found > DIVISIONS_MOST:
        raise wrong("too_many_parts", most=DIVISIONS_MOST)
    return found


COORDINATES_MANY = message("limit.more", name="COORDINATES_LIMIT", limit=COORDINATES_LIMIT)


def coordinates(value: object) -> int:
    """Read the number of parts of the turn at which the profile's coordinates are told."""
    found = f.whole(value, COORDINATES_LEAST)
    if found > COORDINATES_LIMIT:
        raise LimitError(placed(f"coordinates = {found}", COORDINATES_MANY))
    return found


SPEED = measure(units.SPEED, units.VELOCITY)
PHASE_ANGLE = one(
    angle_or,
    lambda: _angle_or(forms.quantity(units.ANGLE, minimum=0, maximum=float(units.ANGLE_LIMIT)), REST, CYCLOGRAM),
    f'degrees, "{REST}", "{CYCLOGRAM}"',
    words=(REST, CYCLOGRAM),
)
SETTING = one(setting, lambda: _angle_or(f.ANGLE.form(), CYCLOGRAM), f'degrees, "{CYCLOGRAM}"')
SWING = one(
    below,
    lambda: forms.quantity(units.ANGLE, minimum=0, exclusiveMaximum=float(SWING_LIMIT)),
    "degrees",
    most=SWING_LIMIT,
    kind="swing",
    least=True,
)
LIMIT = one(
    limit,
    lambda: forms.quantity(units.ANGLE, minimum=float(PRESSURE_LEAST), exclusiveMaximum=float(PRESSURE_LIMIT)),
    "degrees",
)
FIRST = one(first, lambda: forms.quantity(units.NUMBER, exclusiveMinimum=0, exclusiveMaximum=1), "share")
COORDINATES = one(coordinates, lambda: forms.whole(COORDINATES_LEAST) | {"maximum": COORDINATES_LIMIT}, "number")
DIVISIONS = one(divisions, lambda: forms.whole(DIVISIONS_LEAST) | {"maximum": DIVISIONS_MOST}, "number")
SIZE = f.not_negative(units.LENGTH)
LAW = f.words(*LAWS)
POINT = f.pair(measure(units.ANGLE, units.LENGTH), "[turn, travel]")
TOLERANCE = measure(units.LENGTH, units.ANGLE, least=Decimal(0))
PRELOAD = measure(units.FORCE, units.MOMENT, least=Decimal(0))
STIFFNESS = measure(units.STIFFNESS, units.TURNING_STIFFNESS, least=Decimal(0))
CAM_NAME = one(check_cam_name, lambda: forms.text(r"^[0-9A-Za-z_\u00aa-\uffff.-]*$", f.NAME_LIMIT), "text")
