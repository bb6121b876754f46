"""Fields of masses and loads: letters of loads, shares of a stroke, quantities of forces (величины нагрузок)."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any

from plans.linkage.reading import fields as g
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING
from plans.model.mechanism import FRAME, SLOWER, STROKES
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Wrong, wrong
from plans.scene.fields import NAME_LIMIT, not_empty, number, pair, positive, sample, whole
from plans.scene.forms import Form
from plans.scene.readers import Check, either, many, one
from plans.scene.tables import Missing, Table, key, table
from plans.scene.units import type_name

# What a force sheet letters itself: reactions, weights, inertia forces, moments of sliding pairs, what the drive gives.
TAKEN = re.compile(r"[RPF]_?\d+,?\d+|[GΦ]_?\d+|M_?\d\d+|[MP]_?bal")
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


def _united(value: object) -> bool:
    """Tell whether a value has a unit, as a text has but for a number that its comma forces into quotes."""
    return isinstance(value, str) and not re.fullmatch(rf"\s*{units.COMMA}\s*", value)


def place(value: object) -> Decimal:
    """Read a place of the stroke: a share of it, per cent, or a length.

    >>> place("15 %"), place("30 mm"), place("0,5")
    (Decimal('0.15'), Decimal('0.03'), Decimal('0.5'))
    """
    if not _united(value):
        return units.quantity(value, units.NUMBER)
    if (per_cent := units.per_cent(value)) is not None:
        if not 0 <= per_cent <= 100:
            raise wrong("travel_per_cent", found=f"{per_cent:f} %")
        return per_cent.scaleb(-2)
    return Metres(units.quantity(value, units.LENGTH))


def back(value: object) -> Decimal:
    """Read a size on the stroke back: a bare number, or a force or a pressure with its unit."""
    if not _united(value):
        return units.quantity(value, units.FORCE)
    units.quantity(value, units.FORCE_OR_PRESSURE)
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
TRAVEL = one(place, lambda: {"anyOf": [_PART, forms.text(units.PER_CENT.pattern), _LENGTH]}, "share or m")
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
    units.pressure_angle, lambda: forms.quantity(units.ANGLE, minimum=0, maximum=float(units.PRESSURE_LIMIT)), "degrees"
)


PARTS = (WORKING, IDLE, FORWARD, BACKWARD)
DURING = (ALWAYS, *PARTS)
Vector = tuple[Decimal, Decimal]
NO_OVERRUN = (Decimal(0), Decimal(0))
ON_LINK = Missing("number of a moving link", "on = 2")
POINT_OF_LINK = Missing("point of the link", 'point = "B"')

# What editors are told of keys that fit each other or do not.
PART: Form = {"required": ["during"], "properties": {"during": {"enum": list(PARTS)}}}


def symbol() -> Any:
    """Declare the letters of a load."""
    return key(SYMBOL, None, meaning="Its letters on the sheet; default: F_us, F_D, M_3, F_s.")


def only_with_stroke(*others: Form, owned: tuple[str, ...] = ("stroke",)) -> Form:
    """Give the rule that only a load which changes over a stroke names one, and of its own stroke which works."""
    changes: Form = {"anyOf": [PART, {"required": ["overrun"]}, *others]}
    has_own: Form = {"anyOf": [{"required": [name]} for name in owned]}
    return {"dependentSchemas": {"stroke": changes, "working": {"allOf": [changes, has_own]}}}


class LinkLoadTable(Table):
    """What loads on links have in common: when they act, and whether their work is the machine's purpose."""

    during: str | None = key(
        f.words(*DURING),
        None,
        meaning="When it acts; default: always, but a diagram against the motion without back on the working stroke. A "
        "stroke is the crank's turn from one extreme position to the other; a direction is wherever the point goes "
        "that way, also on a reversal within a stroke.",
    )
    overrun: Decimal | Vector = key(
        OVERRUN, NO_OVERRUN, meaning="Shares of the stroke at its ends (перебег) in which the load rests."
    )
    stroke: str | None = key(
        f.POINT,
        None,
        meaning="The point whose stroke counts; default: the output's, of a force between two points their own.",
    )
    working: str = key(
        f.words(*STROKES),
        SLOWER,
        meaning="Which stroke of that point is the working one; of the output [output] says it. A coupler's point goes "
        "along its load: by default against it.",
    )
    useful: bool = key(f.FLAG, True, meaning="Whether its work is what the machine is for.")
    name: str | None = symbol()

    @property
    def phase(self) -> str:
        """The part of the turn in which the load acts."""
        return self.during or ALWAYS

    @property
    def rests(self) -> Vector:
        """The shares of the stroke, at its two ends, in which the load rests."""
        return self.overrun if isinstance(self.overrun, tuple) else (self.overrun, self.overrun)

    @property
    def owns_stroke(self) -> bool:
        """Whether the stroke that counts is another than the output's."""
        return self.stroke is not None

    @property
    def changes(self) -> bool:
        """Whether the load needs to know the stroke."""
        return self.phase != ALWAYS or self.rests != NO_OVERRUN

    def check(self) -> None:
        """See that the load acts somewhere on its stroke, and has none without need."""
        if sum(self.rests) >= 1:
            raise wrong("no_stroke_left", at=("overrun",))
        if self.stroke is not None and not self.changes:
            raise wrong("spare_stroke", at=("stroke",))
        if "working" in self.given and not (self.changes and self.owns_stroke):
            raise wrong("spare_working", at=("working",))


class EndTable(Table):
    """An end of a spring or a force between links: a point of one of the links that have it."""

    on: int = key(g.ANY_LINK, meaning="The link, where several have the point.", missing=ON_LINK)
    point: str = key(f.POINT, meaning="Point of the link.", missing=POINT_OF_LINK)


Ends = tuple[str | EndTable, ...]
ENDS = many(either(dict, table(EndTable), f.POINT), first=Check(check_ends, least=2, most=2))


def holders(end: str | EndTable, points_of: Mapping[int, Iterable[str]]) -> tuple[int, ...]:
    """Give the links that an end may be of: the frame alone where the point is fixed.

    >>> holders("O", {0: "OC", 1: "OA", 2: "A"}), holders("A", {0: "OC", 1: "OA", 2: "A"})
    ((0,), (1, 2))
    """
    if isinstance(end, EndTable):
        return (end.on,)
    found = tuple(link for link, points in points_of.items() if end in points)
    return (FRAME,) if FRAME in found else found


def point_of(end: str | EndTable) -> str:
    """Give the point that an end is at."""
    return end if isinstance(end, str) else end.point
