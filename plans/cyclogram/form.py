"""The form of the cyclogram: the tool, its overrun, where the load changes (исходные данные циклограммы)."""

from __future__ import annotations

from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.fields import Metres
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import either, many, one
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Missing, Table, key, table

EXAMPLE = "overrun = 0.1"


def along(value: object) -> Decimal:
    """Read a part of the stroke: a share of it from 0 to less than 1, per cent, or a length.

    >>> along("10 %"), along("48 mm")
    (Decimal('0.10'), Decimal('0.048'))
    """
    found = h.place(value)
    if found < 0 and isinstance(found, Metres):
        raise wrong("negative", kind="length")
    if not isinstance(found, Metres) and not 0 <= found < 1:
        raise wrong("share")
    return found


ALONG = one(
    along,
    lambda: {
        "anyOf": [
            h.SHARE.form(),
            forms.text(h.PER_CENT.pattern),
            {"type": "string", "pattern": forms.text_with_unit(units.LENGTH)},
        ]
    },
    "share or m",
)
OVERRUN = either(list, f.pair(ALONG, "[start, end]"), ALONG)
Overrun = Decimal | tuple[Decimal, Decimal]


class CyclogramTable(Table):
    """The tool of the main mechanism: its point, its overrun at the ends of its stroke, where its load changes."""

    point: str | None = key(f.POINT, None, meaning="The point of the tool; default: that of the output.")
    overrun: Overrun = key(
        OVERRUN,
        meaning=(
            "How far the tool goes past the work at both ends of its stroke (перебег), or [start, end]: shares of the "
            'stroke, per cent, or lengths, "48 mm".'
        ),
        missing=Missing("overrun of the tool", EXAMPLE, 0.1),
    )
    breaks: tuple[Decimal, ...] = key(
        many(ALONG, f.NO_REPEATS, first=f.FEW),
        (),
        meaning=(
            "Where the load changes on the working stroke, counted from its beginning; default: where the diagram of "
            "the output's load in [loads] has its points."
        ),
    )

    @property
    def ends(self) -> tuple[Decimal, Decimal]:
        """The overrun where the working stroke begins, and where it ends."""
        return self.overrun if isinstance(self.overrun, tuple) else (self.overrun, self.overrun)

    def check(self) -> None:
        """See that the tool goes past the work somewhere, and that some of the stroke is left for it."""
        if not any(self.ends):
            raise wrong("no_overrun", at=("overrun",))
        if not any(isinstance(one, Metres) for one in self.ends) and sum(self.ends) >= 1:
            raise wrong("no_stroke_left", at=("overrun",))


class CyclogramForm(TechniqueForm):
    """What a scene says of the cyclogram of its machine."""

    cyclogram: CyclogramTable = key(
        table(CyclogramTable),
        meaning="The cyclogram of a machine (циклограмма): its tool, the overrun, where the load changes.",
        missing=Missing("table", f"[cyclogram] with {EXAMPLE}", {}),
    )

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive: it is."""
        return True
