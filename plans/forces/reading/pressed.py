"""A force that a pressure gives on a piston, as the scene gives it: pressure, bore, rod (давление на поршень)."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.fields import LinkLoadTable, Metres, Newtons, Pascals
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import many
from plans.scene.tables import Missing, Table, key, table
from plans.scene.units import PI, WORKING


class DiagramTable(Table):
    """A load over the stroke: places of the stroke, force N or pressure Pa at each, and on the idle stroke there."""

    travel: tuple[Decimal, ...] = key(
        many(h.TRAVEL, h.TWO, first=f.FEW),
        meaning="Places of the stroke, rising from 0, where the working stroke begins: shares of it up to 1, per cent "
        'up to "100 %", or lengths up to the stroke, "200 mm".',
        missing=Missing("list of shares of the stroke", "travel = [0, 1]"),
    )
    force: tuple[Decimal, ...] = key(
        many(h.FORCE, h.AS_MANY, first=f.FEW),
        (),
        meaning="The force at each.",
        missing=Missing("list of forces", "force = [1500, 1500]"),
    )
    pressure: tuple[Decimal, ...] = key(
        many(h.PRESSURE, h.AS_MANY, first=f.FEW),
        (),
        meaning="Instead of force the pressure on a piston at each, as of an indicator diagram; with bore beside.",
    )
    back: tuple[Decimal, ...] = key(
        many(h.BACK, h.AS_MANY, first=f.FEW),
        (),
        meaning="Force or pressure at each on the stroke back, as of an indicator diagram.",
    )

    @property
    def there(self) -> tuple[Decimal, ...]:
        """Force or pressure on the working stroke."""
        return self.pressure or self.force

    @property
    def length(self) -> Decimal | None:
        """The stroke m that the places are told of; None where they are shares."""
        return self.travel[-1] if any(isinstance(place, Metres) for place in self.travel) else None

    @property
    def shares(self) -> tuple[Decimal, ...]:
        """The places as shares of the stroke."""
        whole = self.length
        return self.travel if whole is None else tuple(WORKING.divide(place, whole) for place in self.travel)

    def check(self) -> None:
        """See that travel rises over the stroke with one size each, on the idle stroke too where it is given."""
        if self.given >= {"force", "pressure"}:
            raise wrong("one_of_two", first="force", second="pressure", found="both")
        if self.given.isdisjoint(("force", "pressure")):
            raise wrong("missing", at=("force",))
        self._check_kinds()
        self._check_places()
        rises = all(low <= high for low, high in zip(self.travel, self.travel[1:], strict=False))
        name = "pressure" if "pressure" in self.given else "force"
        for part in (name, "back") if "back" in self.given else (name,):
            if not rises or len(self.travel) != len(getattr(self, part)):
                raise wrong("diagram", name=part)
        if self.travel[0] != 0 or self.shares[-1] != 1:
            raise wrong("travel", first=f"{self.travel[0]:f}", last=f"{self.travel[-1]:f}", at=("travel",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a diagram is of forces or of pressures."""
        return {"oneOf": [{"required": ["force"]}, {"required": ["pressure"]}]}

    def _check_kinds(self) -> None:
        """See that the stroke back is told in the unit of the way there."""
        other = Newtons if self.pressure else Pascals
        strange = _first(isinstance(size, other) for size in self.back)
        if strange is not None:
            raise wrong("back_kind", name="pressure" if self.pressure else "force", at=("back", strange))

    def _check_places(self) -> None:
        """See that shares lie on the stroke, and that lengths stand among lengths, but for a bare 0."""
        if self.length is not None:
            bare = _first(place != 0 and not isinstance(place, Metres) for place in self.travel)
            if bare is not None:
                raise wrong("mixed_travel", found=f"{self.travel[bare]:f}", at=("travel", bare))
            if self.travel[-1] <= 0:
                raise wrong("travel", first=f"{self.travel[0]:f}", last=f"{self.travel[-1]:f}", at=("travel",))
            return
        beyond = _first(not 0 <= share <= 1 for share in self.travel)
        if beyond is not None:
            raise wrong("travel_share", found=f"{self.travel[beyond]:f}", at=("travel", beyond))


def _first(holds: Iterable[bool]) -> int | None:
    """Give the number of the first that holds."""
    return next((k for k, true in enumerate(holds) if true), None)


PRESSED, BEHIND, BOTH = "pressure", "behind", "both"  # the sides of a piston that its rod passes through
_OF_ROD = ("rod_on", "ambient")
_BESIDE = ("bore", "rod", "rod_on", "behind", "ambient")


class PressedTable(LinkLoadTable):
    """A load that a pressure Pa may give on a piston of a bore m, less its rod on the side that it passes through."""

    diagram: DiagramTable | None = key(
        table(DiagramTable), None, meaning="The size of the force over the stroke, instead of value."
    )
    pressure: Decimal | None = key(
        h.PRESSURE, None, meaning="The pressure on a piston, instead of value; also in kPa, MPa, bar."
    )
    bore: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Diameter of the piston (диаметр поршня) that a pressure acts on.",
        missing=Missing("bore", 'bore = "80 mm"'),
    )
    rod: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Diameter of the rod: the side of the piston that it passes through is smaller by its section.",
        missing=Missing("rod", 'rod = "30 mm"'),
    )
    rod_on: str = key(
        f.words(PRESSED, BEHIND, BOTH),
        PRESSED,
        meaning="The side that the rod passes through: that of the pressure, that behind the piston, or both.",
    )
    behind: Decimal = key(
        h.PRESSURE,
        Decimal(0),
        meaning="Pressure on the piston's other side, as that of the air where pressures are absolute; without it they "
        "are the excess over it.",
    )
    ambient: Decimal = key(
        h.PRESSURE,
        Decimal(0),
        meaning="Pressure of the air on the rod's section outside the cylinder, where pressures are absolute.",
    )

    @property
    def pressed(self) -> bool:
        """Whether a pressure gives the load."""
        return self.pressure is not None or (self.diagram is not None and bool(self.diagram.pressure))

    def area(self, side: str) -> Decimal:
        """Give the area m2 of a side of the piston."""
        bore, rod = self.bore or Decimal(0), self.rod or Decimal(0)
        through = rod if self.rod_on in (side, BOTH) else Decimal(0)
        return WORKING.multiply(PI / 4, WORKING.subtract(bore * bore, through * through))

    def forced(self, size: Decimal) -> float:
        """Give the force N of a pressure Pa against what presses behind and on the rod outside; a force as it is."""
        if not self.pressed:
            return float(size)
        there, behind = self.area(PRESSED), self.area(BEHIND)
        terms = (size, there), (-self.behind, behind), (self.ambient, behind - there)
        return float(sum((WORKING.multiply(*term) for term in terms), Decimal(0)))

    def check(self) -> None:
        """See that a pressure has a piston to act on, thicker than its rod, and nothing else has one."""
        given = [name for name in _BESIDE if name in self.given]
        if not self.pressed and given:
            raise wrong("no_pressure", name=given[0], at=(given[0],))
        if self.pressed and self.bore is None:
            raise wrong("missing", at=("bore",))
        if self.rod is None and not self.given.isdisjoint(_OF_ROD):
            raise wrong("missing", at=("rod",))
        if self.rod is not None and self.bore is not None and self.rod >= self.bore:
            raise wrong("thick_rod", at=("rod",))
        super().check()


def with_piston() -> Form:
    """Give the rule that a pressure has a bore, and nothing else a piston."""
    inner: Form = {"required": ["diagram"], "properties": {"diagram": {"required": ["pressure"]}}}
    piston: list[Form] = [{"required": [name]} for name in _BESIDE]
    pressed: Form = {"anyOf": [{"required": ["pressure"]}, inner]}
    rod = {name: ["rod"] for name in _OF_ROD}
    return {"if": pressed, "then": {"required": ["bore"]}, "else": {"not": {"anyOf": piston}}, "dependentRequired": rod}
