"""Loads as the scene gives them: gravity, forces, moments, springs (нагрузки)."""

from __future__ import annotations

from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.ends import ENDS, Ends
from plans.forces.reading.force import ForceTable
from plans.forces.reading.load import ON_LINK, LoadTable, Vector, only_with_stroke, symbol
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many
from plans.scene.tables import Missing, Table, key, table


class MomentTable(LoadTable):
    """A moment on a link, N*m, positive counter-clockwise; or its size, against the link's rotation."""

    value: Decimal = key(
        h.MOMENT,
        meaning="Moment, positive counter-clockwise; or its size, against the rotation.",
        missing=Missing("moment", "value = 12"),
    )
    against: str | None = key(f.words("motion"), None, meaning="The moment acts against the rotation of its link.")
    on: int = key(h.LOADED_LINK, meaning="The link.", missing=ON_LINK)

    @classmethod
    def rules(cls) -> Form:
        """Say that only a moment which changes over a stroke names one."""
        return only_with_stroke()


class SpringTable(Table):
    """A spring between points of two links: its ends, stiffness N/m and free length m."""

    between: Ends = key(
        ENDS,
        meaning='Its two ends: points of two links, ["B", "O"].',
        missing=Missing("pair of ends", 'between = ["B", "O"]'),
    )
    stiffness: Decimal = key(h.STIFFNESS, meaning="Stiffness.", missing=Missing("stiffness", 'stiffness = "20 N/mm"'))
    free: Decimal = key(h.FREE_LENGTH, meaning="Free length.", missing=Missing("free length", 'free = "80 mm"'))
    name: str | None = symbol()


class LoadsTable(Table):
    """Gravity, forces, moments and springs; gravity as a number is downward, and none where it is not given."""

    gravity: Decimal | Vector | None = key(
        either(list, f.pair(h.GRAVITY, "[gx, gy]"), h.GRAVITY),
        None,
        meaning="Gravity, downward or as a vector; without it links have no weight.",
    )
    forces: tuple[ForceTable, ...] = key(many(table(ForceTable), first=f.FEW), (), meaning="Forces on points of links.")
    moments: tuple[MomentTable, ...] = key(many(table(MomentTable), first=f.FEW), (), meaning="Moments on links.")
    springs: tuple[SpringTable, ...] = key(
        many(table(SpringTable), first=f.FEW), (), meaning="Springs between points of two links (пружины)."
    )

    def check(self) -> None:
        """See that no two loads bear the same letters."""
        seen = set()
        for kind in ("forces", "moments", "springs"):
            for index, load in enumerate(getattr(self, kind)):
                if load.name in seen:
                    raise wrong("repeated", entry=load.name, at=(kind, index, "name"))
                seen |= {load.name} - {None}
