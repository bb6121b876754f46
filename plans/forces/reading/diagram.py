"""A load over the stroke as the scene gives it: its diagram (диаграмма нагрузки)."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.fields import Metres, Newtons, Pascals
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import many
from plans.scene.tables import Missing, Table, key
from plans.scene.units import WORKING


class DiagramTable(Table):
    """A load over the stroke: places of the stroke, force N or pressure Pa at each, and on the idle stroke there."""

    travel: tuple[Decimal, ...] = key(
        many(h.TRAVEL, h.TWO, first=f.FEW),
        meaning=(
            "Places of the stroke, rising from 0, where the working stroke begins: shares of it up to 1, per cent up "
            'to "100 %", or lengths up to the stroke, "200 mm".'
        ),
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
    return next((k for k, one in enumerate(holds) if one), None)
