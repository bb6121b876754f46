"""The form of balancing: what is aimed at, and which links may carry counterweights (данные уравновешивания)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.linkage.reading import fields as g
from plans.model.balance.linkage import DISC, FORCE, FULL, NONE, PARTIAL, REACTION, SECTOR, SHARE
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Wrong, nearest, wrong
from plans.scene.forms import Form
from plans.scene.readers import Check, many, one
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.words.words import message

STRAIGHT = Decimal(180)  # degrees: a sector of twice as many is a disc about its corner, and has no static moment
SIZES = ("mass", "radius", "at")  # of a disc: one is given, the others follow
AIMS = (NONE, FULL, PARTIAL, SHARE)
LEASTS = (FORCE, REACTION)
# A line that would do for a counterweight.
COUNTERWEIGHT = '[[balance.counterweights]] with on = 1 and mass = "2 kg"'


def share(value: object) -> Decimal | str:
    """Read a share of the reciprocating mass, or what is to be least by it.

    >>> share(Decimal("0.5")), share("50 %"), share("force")
    (Decimal('0.5'), Decimal('0.50'), 'force')
    """
    if isinstance(value, str) and value[:1].isalpha():
        return f.choice(value, LEASTS, "share_of_mass")
    found = units.part(value)
    if not 0 <= found <= 1:
        raise wrong("share_of_mass", choices=", ".join(LEASTS), suggestion=message("advice.share_of_mass"))
    return found


def half_angle(value: object) -> Decimal:
    """Read half the angle of a sector, degrees."""
    found = units.quantity(value, units.ANGLE)
    if not 0 < found < STRAIGHT:
        raise wrong("wide_sector")
    return found


def distance(value: object) -> Decimal:
    """Read a distance along a link's line, negative beyond its beginning; at the beginning nothing is balanced."""
    found = units.coordinate(value)
    if found == 0:
        raise wrong("at_beginning")
    return found


def _likely_aim(value: object) -> str:
    """Give the aim that another word is likely to mean: one that is spelt nearly so, else the whole of it."""
    return (nearest(str(value), AIMS) or [FULL])[0]


_PART: Form = {"type": "number", "minimum": 0, "maximum": 1}
SHARE_OF_MASS = one(
    share,
    lambda: {"anyOf": [_PART, forms.choice(LEASTS), forms.text(units.PER_CENT.pattern)]},
    'share, "force", "reaction"',
)
HALF_ANGLE = one(
    half_angle, lambda: forms.quantity(units.ANGLE, exclusiveMinimum=0, exclusiveMaximum=float(STRAIGHT)), "degrees"
)
DISTANCE = one(distance, lambda: f.COORDINATE.form() | {"not": {"const": 0}}, "m")
MASS = f.positive(units.MASS)


class CounterweightTable(Table):
    """A link that may carry a counterweight: what is given of it kg, m, and the body that it is made as."""

    on: int = key(
        g.MOVING_LINK,
        meaning="The link that may carry it.",
        missing=Missing("number of a moving link", "on = 1"),
        also=("link",),
    )
    mass: Decimal | None = key(
        MASS, None, meaning="Mass of the counterweight; its place is found.", missing=Missing("mass", 'mass = "2 kg"')
    )
    radius: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Distance of its centre from the link's beginning; its direction and mass are found.",
        also=("r", "distance"),
    )
    at: Decimal | None = key(
        DISTANCE,
        None,
        meaning="Place of its centre on the link's line, counted from the link's beginning, negative beyond it; its "
        "mass is found.",
    )
    shape: str = key(
        f.words(DISC, SECTOR),
        DISC,
        meaning="The body: a disc; or a sector about the link's beginning, whose mass and place follow from its sizes.",
    )
    density: Decimal = key(f.positive(units.DENSITY), Decimal(7850), meaning="Density; default: steel.")
    thickness: Decimal = key(f.LENGTH, Decimal("0.03"), meaning="Thickness of the body.")
    half_angle: Decimal = key(HALF_ANGLE, Decimal(60), meaning="Half the angle of a sector.")

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that one size of a disc is given, and of a sector none: both follow from its static moment."""
        sizes = [name for name in SIZES if name in value]
        if value.get("shape") == SECTOR:
            yield from (wrong("sector_size", at=(name,)) for name in sizes)
            return
        if not sizes:
            yield wrong("missing", at=("mass",), why=message("why.one_size"))
        yield from (wrong("two_sizes", first=sizes[0], at=(name,)) for name in sizes[1:])
        if "half_angle" in value:
            yield wrong("half_angle", at=("half_angle",))

    @classmethod
    def rules(cls) -> Form:
        """Say that one size of a disc is given, and of a sector none."""
        given: list[Form] = [{"required": [name]} for name in SIZES]
        return {
            "if": {"properties": {"shape": forms.choice((SECTOR,))}, "required": ["shape"]},
            "then": {"not": {"anyOf": given}},
            "else": {"oneOf": given, "not": {"required": ["half_angle"]}},
        }


def _check_once(entries: tuple[CounterweightTable, ...]) -> None:
    links = [entry.on for entry in entries]
    for number, link in enumerate(links):
        if link in links[:number]:
            raise wrong("counterweight_twice", link=link, at=(number, "on"))


class BalanceTable(Table):
    """The balancing that is asked for: aim, share of the reciprocating mass, links that may carry counterweights."""

    aim: str = key(
        f.words(*AIMS, likely=_likely_aim),
        NONE,
        meaning="What is aimed at: nothing, the mass centre and the shaking force alone; a mass centre that stands "
        "still (полное уравновешивание); one that moves along the guides alone (частичное); or a share of the "
        "reciprocating mass balanced by the crank beside that.",
        missing=Missing("aim", 'aim = "full"'),
    )
    share: Decimal | str = key(
        SHARE_OF_MASS,
        FORCE,
        meaning='Of aim = "share": the share, 0.5 or "50 %"; or the one with the least largest shaking force, "force", '
        'or reaction of the crank\'s shaft, "reaction".',
    )
    counterweights: tuple[CounterweightTable, ...] = key(
        many(table(CounterweightTable), Check(_check_once), first=f.FEW),
        (),
        meaning="The links that may carry a counterweight (противовес), each once.",
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that counterweights have an aim, and a share the aim that needs one."""
        if "share" in value and value.get("aim", NONE) in (NONE, FULL, PARTIAL):
            yield wrong("share_aim", at=("share",))
        elif value.get("counterweights") and "aim" not in value:
            yield wrong("missing", at=("aim",), why=message("why.counterweights"))

    @classmethod
    def rules(cls) -> Form:
        """Say that counterweights have an aim, and a share the aim that needs one."""
        return {
            "dependentRequired": {"share": ["aim"]},
            "if": {"required": ["share"]},
            "then": {"properties": {"aim": forms.choice((SHARE,))}},
            "else": {
                "if": {"properties": {"counterweights": {"minItems": 1}}, "required": ["counterweights"]},
                "then": {"required": ["aim"]},
            },
        }


class BalanceForm(TechniqueForm):
    """What a scene says of balancing its linkage."""

    balance: BalanceTable = key(
        table(BalanceTable),
        meaning="Balancing of the linkage (уравновешивание механизма): aim, counterweights.",
        missing=Missing("table", '[balance] with aim = "none"', {}),
    )

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive: it is."""
        return True
