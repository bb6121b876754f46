"""Tables of positions: of a rod, of crank and rocker, of a coupler's point that dwells (синтез по положениям)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any, Final

from plans.scene import fields as f
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import Check, many
from plans.scene.tables import Missing, Table, key

TWO, THREE = 2, 3
Place = tuple[Decimal, Decimal]


def _length(name: str, meaning: str, example: int) -> Any:
    """Give the key of a length that is required, m; an example of it in mm."""
    missing = Missing("length of the link", f'{name} = "{example} mm"', Decimal(example) / 1000)
    return key(f.LENGTH, meaning=meaning, missing=missing)


def _two_or_three(value: object) -> object:
    """See that a list has two or three entries."""
    if isinstance(value, list) and not TWO <= len(value) <= THREE:
        raise wrong("synthesis_positions", count=len(value))
    return value


SOME: Final = Check(_two_or_three, least=TWO, most=THREE)
ANGLES = many(f.ANGLE, first=SOME)
PLACES = f.pair(f.PLACE, "[[x, y], [x, y]]")


def _alike(value: Mapping[str, Any], one: str, other: str, free: str) -> Iterator[Wrong]:
    """See that two lists are as long, and that what is free is told of two positions, and of no more."""
    lists = [value.get(name) for name in (one, other)]
    if not all(isinstance(entries, list) for entries in lists):
        return
    first, second = (len(entries) for entries in lists if isinstance(entries, list))
    if first != second:
        yield wrong("synthesis_as_many", other=one, count=first, found=second, at=(other,))
    elif (first == TWO) != (free in value):
        yield wrong("synthesis_two_free", free=free, at=(free,) if free in value else ())


class RodTable(Table):
    """A four-bar that is wanted to guide its rod: the rod's positions, and its hinges or the pivots."""

    places: tuple[Place, ...] = key(
        many(f.PLACE, first=SOME),
        meaning="Places of a point D of the rod in two or three positions, m, in their order.",
        missing=Missing("places of the rod", "places = [[0, 0], [0.2, 0.1], [0.4, 0.1]]", ()),
    )
    angles: tuple[Decimal, ...] = key(
        ANGLES,
        meaning="Angles of the rod there, degrees.",
        missing=Missing("angles of the rod", "angles = [0, 20, 50]", ()),
    )
    hinges: tuple[Place, Place] | None = key(
        PLACES, None, meaning="Hinges A and B of the rod in its first position, m: the pivots are found."
    )
    pivots: tuple[Place, Place] | None = key(
        PLACES, None, meaning="Pivots O and C, m, instead of the hinges, which are found by inversion."
    )
    arms: tuple[Decimal, Decimal] | None = key(
        f.pair(f.LENGTH, "[l1, l3]"), None, meaning="Of two positions: the lengths of the links OA and CB, m."
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that hinges or pivots are told, and as many angles as places."""
        if ("hinges" in value) == ("pivots" in value):
            found = "both" if "hinges" in value else "neither"
            yield wrong("one_of_two", first="hinges", second="pivots", found=found)
        yield from _alike(value, "places", "angles", "arms")

    @classmethod
    def rules(cls) -> Form:
        """Say that hinges or pivots are told."""
        return {"oneOf": [{"required": ["hinges"]}, {"required": ["pivots"]}]}


class FunctionTable(Table):
    """A four-bar that is wanted to meet a function: angles of its crank, and of its rocker with them."""

    inputs: tuple[Decimal, ...] = key(
        ANGLES,
        meaning="Two or three angles of the crank OA from the line OC on, degrees, in their order.",
        missing=Missing("angles of the crank", "inputs = [30, 60, 90]", ()),
    )
    outputs: tuple[Decimal, ...] = key(
        ANGLES,
        meaning="Angles of the rocker with them, degrees: their differences are met.",
        missing=Missing("angles of the rocker", "outputs = [0, 20, 45]", ()),
    )
    crank: Decimal = _length("crank", "Crank l1, m: chosen.", 100)
    frame: Decimal = _length("frame", "Frame l4, m: chosen.", 300)
    rocker: Decimal | None = key(f.LENGTH, None, meaning="Of two angles: the rocker l3, m.")

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that there are as many outputs as inputs, and that the rocker turns."""
        outputs = value.get("outputs")
        if isinstance(outputs, list) and len(set(map(str, outputs))) == 1:
            yield wrong("synthesis_no_swing", at=("outputs",))
        yield from _alike(value, "inputs", "outputs", "rocker")


class DwellTable(Table):
    """A rocker that is wanted to rest while a point of a four-bar's coupler goes round an arc."""

    crank: Decimal = _length("crank", "Crank l1, m.", 100)
    coupler: Decimal = _length("coupler", "Coupler l2, m.", 250)
    rocker: Decimal = _length("rocker", "Rocker l3, m.", 250)
    frame: Decimal = _length("frame", "Frame l4, m.", 200)
    arm: Decimal = _length("arm", "AK, from the crank's end to K, m.", 500)
    lean: Decimal = key(f.ANGLE, Decimal(0), meaning="Angle BAK of K from the coupler, degrees counter-clockwise.")
    dwell: tuple[Decimal, Decimal] = key(
        f.pair(f.ANGLE, "[from, to]"),
        meaning="Angles of the crank from the line OC on between which the rocker rests, degrees.",
        missing=Missing("dwell of the crank", "dwell = [130, 230]", (130, 230)),
    )
    output: Decimal = _length("output", "Rocker DF that rests, m.", 300)
    crossed: bool = key(f.FLAG, False, meaning="Whether the four-bar is crossed: B right of the ray from A to C.")
