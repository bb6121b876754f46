"""What is wanted of a train whose teeth lack: a ratio, how far it may be off, bounds of teeth (задание)."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING

from plans.gears.axes import RawTrain
from plans.gears.synthesis import CLEAR, Searched, Wanted
from plans.model.gears import link_of
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import one
from plans.scene.tables import Missing, Table, key

if TYPE_CHECKING:
    from plans.gears.form import GearsTable

USUAL = (3, 4, 5, 6)  # planets that are tried where their number is not given
MOST_SOUGHT = 300  # teeth of a wheel that is sought: beyond it a search takes minutes
LEAST_SOUGHT = 6


def check_tolerance(value: object) -> Decimal:
    """Read how far a ratio may be off: a part, or text in per cent; less than all of it."""
    per_cent = units.per_cent(value)
    found = units.quantity(value, units.NUMBER) if per_cent is None else per_cent.scaleb(-2)
    if not 0 <= found < 1:
        raise wrong("ratio_tolerance")
    return found


def check_ratio(value: object) -> Decimal:
    """Read a ratio: negative where the links turn against each other."""
    found = units.quantity(value, units.NUMBER)
    if not found:
        raise wrong("zero", kind="ratio")
    return found


def check_sought(value: object) -> int:
    """Read a bound of the teeth that are sought."""
    if f.whole(value, LEAST_SOUGHT) > MOST_SOUGHT:
        raise wrong("many_teeth", most=MOST_SOUGHT)
    return int(str(value))


RATIO = one(check_ratio, lambda: {"type": "number"}, "number")
SOUGHT = one(check_sought, lambda: {**forms.whole(LEAST_SOUGHT), "maximum": MOST_SOUGHT}, "number")
TOLERANCE = one(check_tolerance, lambda: {"anyOf": [{"type": "number"}, {"type": "string"}]}, '"3 %"')


class WantedTable(Table):
    """A wanted ratio, and the bounds within which teeth are sought."""

    ratio: Decimal = key(
        RATIO,
        meaning="Wanted ratio of the driving link to the driven one; negative where they turn against each other.",
        missing=Missing("ratio", "ratio = 5.2", 1),
        also=("U", "u", "i"),
    )
    tolerance: Decimal = key(TOLERANCE, Decimal("0.05"), meaning='How far it may be off: a part, or "3 %".')
    least: int = key(SOUGHT, 17, meaning="Least teeth of an external wheel: fewer are undercut by a rack (подрез).")
    ring: int = key(SOUGHT, 85, meaning="Least teeth of a ring; it has 8 more than the wheel within it in any case.")
    greatest: int = key(SOUGHT, 150, meaning="Greatest teeth of any wheel.")

    def check(self) -> None:
        """See that some number of teeth is allowed."""
        if self.least > self.greatest:
            raise wrong("no_teeth_between", least=self.least, greatest=self.greatest, at=("greatest",))


def wanted_of(form: GearsTable, raw: RawTrain) -> Wanted | None:
    """Give what is wanted of a train; nothing where it is not of one carrier with one block of planets, one link held.

    All wheels must mesh with the block, each of a link of its own, and no shafts be joined.
    """
    asked, held = form.wanted, {*form.fixed, *form.brakes.values()}
    planets, ends = raw.planets, (*held, *(drive.link for drive in form.drives), form.output)
    rows = [mesh if link_of(mesh[1]) in planets else mesh[::-1] for mesh in raw.meshes]
    central = [link_of(one) for one, _ in rows]
    plain = len(planets) == 1 == len(raw.carriers) and not raw.coaxial and len(form.engaged) < 2
    apart = len(ends) == 3 == len({*ends}) and not planets.keys() & {*central, *ends}
    alone = len({*central}) == len(rows) > 1 and {*ends} <= {*central, *raw.carriers}
    if (
        asked is None
        or not (plain and apart and alone)
        or any(wheel in raw.rings or link_of(wheel) not in planets for _, wheel in rows)
    ):
        return None
    numbers = USUAL if form.planets is None else (form.planets,)
    within = Fraction(asked.ratio), Fraction(asked.tolerance)
    return Wanted(raw, tuple(rows), ends, *within, numbers, asked.least, asked.ring, asked.greatest)


def lack(found: Searched) -> tuple[str, dict[str, object]]:
    """Say why a search found nothing: what each condition leaves, and the nearest ratio that can be met."""
    asked, near = found.wanted, found.nearest
    numbers = "–".join(map(str, dict.fromkeys((asked.planets[0], asked.planets[-1]))))
    parts: dict[str, object] = {"least": asked.least, "ring": asked.ring, "greatest": asked.greatest, "count": numbers}
    parts |= {"clear": CLEAR, "coaxial": found.coaxial, "neighbours": found.clear, "whole": found.whole}
    if near is None:
        return "no_planets_fit", parts
    teeth = ", ".join(f"z_{name} = {abs(count)}" for name, count in near.teeth.items())
    lo, hi = (f"{float(one):.6g}" for one in asked.bounds)
    off = 100 * float(abs(near.ratio / asked.ratio - 1))
    return "no_such_ratio", {**parts, "lo": lo, "hi": hi, "near": f"{float(near.ratio):.6g}", "off": f"{off:.3g}"} | {
        "teeth": teeth
    }
