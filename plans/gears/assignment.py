"""What a scene asks of the synthesis of a train, and why nothing was found for it (задание на подбор зубьев)."""

from __future__ import annotations

from fractions import Fraction

from plans.gears.axes import RawTrain
from plans.gears.form import GearsTable
from plans.gears.synthesis import CLEAR, Searched, Wanted
from plans.model.gears import link_of

USUAL = (3, 4, 5, 6)  # planets that are tried where their number is not given


def wanted_of(form: GearsTable, raw: RawTrain) -> Wanted | None:
    """Give what is wanted of a train; nothing where it is not of one carrier with one block of planets, one link held.

    All wheels must mesh with the block, each of a link of its own, and no shafts be joined.
    """
    asked, held = form.wanted, {*form.fixed, *form.brakes.values()}
    planets, ends = raw.planets, (*held, *(drive.link for drive in form.drives), form.output)
    rows = [mesh if link_of(mesh[1]) in planets else mesh[::-1] for mesh in raw.meshes]
    central = [link_of(one) for one, _ in rows]
    plain = len(planets) == 1 == len(raw.carriers) and not raw.coaxial and len(form.engaged) < 2
    apart = len(held) == 1 == len(form.drives) and len({*ends}) == 3 and not planets.keys() & {*central, *ends}
    alone = len({wheel for _, wheel in rows}) < 3 and len({*central}) == len(rows) > 1
    alone &= {*ends} <= {*central, *raw.carriers}
    alone &= all(wheel not in raw.rings and link_of(wheel) in planets for _, wheel in rows)
    if asked is None or not (plain and apart and alone):
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
    kind = "no_such_ratio" if float(f"{off:.3g}") < 100 else "no_ratio_near"  # a tolerance is less than 100 %
    return kind, parts | {"lo": lo, "hi": hi, "near": f"{float(near.ratio):.6g}", "off": f"{off:.3g}", "teeth": teeth}
