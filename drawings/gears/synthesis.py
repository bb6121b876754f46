"""The synthesis of a train on its sheet: what was wanted, what each condition left, the solutions (подбор зубьев)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.gear_letters import teeth_letters
from drawings.lettering.words import Phrase, Slot, fixed, joined
from drawings.page.page import Drafting
from plans.gears.study import pair_of
from plans.gears.synthesis import CLEAR, Searched, Solution, Wanted

SOLUTIONS = "solutions"  # the table
SHOWN = 12  # solutions on the sheet
DIGITS, OFF, PLACES = 5, 3, 2
MILLIMETRES, NBSP = 1000.0, "\N{NO-BREAK SPACE}"
USUAL_LEAST = {False: 17, True: 85}  # teeth without undercut of a wheel cut by a rack, of a ring (К. В. Фролов)


def solutions(found: Searched, drafting: Drafting, most: int | None = SHOWN) -> RuledTable:
    """Tell the teeth of the solutions, the smallest first, with planets, ratio, how far it is off, and size."""
    wheels = map(teeth_letters, found.wanted.raw.teeth)
    heads = *wheels, drafting.word("gears planets"), _ratio(found.wanted)
    heads += drafting.word("gears off"), drafting.word("gears across")
    rows = enumerate(found.solutions[:most], 1)
    lines = [TableRow(str(k), tuple(_cells(found.wanted, one, drafting))) for k, one in rows]
    return table(lines, drafting.word("gears solutions"), heads, drafting.hand.text)._replace(name=SOLUTIONS, least=6)


def _ratio(wanted: Wanted) -> str:
    return f"U_{{{pair_of(*wanted.ends[1:])}}}"


def _cells(wanted: Wanted, one: Solution, drafting: Drafting) -> Iterator[str]:
    yield from (str(abs(teeth)) for teeth in one.teeth.values())
    yield str(one.planets)
    yield drafting.number(float(one.ratio), DIGITS)
    yield fixed(_off(wanted, float(one.ratio)), drafting.language, PLACES)
    yield drafting.number(MILLIMETRES * float(one.across), DIGITS)


def _off(wanted: Wanted, ratio: float) -> float:
    """Give by how many per cent a ratio is more than the wanted one."""
    return 100 * (ratio - float(wanted.ratio)) / abs(float(wanted.ratio))


def notes(found: Searched, drafting: Drafting, most: int | None = SHOWN) -> Iterator[Phrase]:
    """Tell what was wanted, what each condition left, and how the train that is drawn meets them."""
    wanted, best = found.wanted, found.solutions[0]
    told = {name: Slot(f"U {name}", float(one), DIGITS) for name, one in zip(("lo", "hi"), wanted.bounds, strict=True)}
    told |= {"ratio": Slot("wanted U", float(wanted.ratio), DIGITS)}
    told |= {"tolerance": Slot("tolerance", 100 * float(wanted.tolerance))}
    yield drafting.phrase("gears wanted", name=_ratio(wanted), **told)
    counts = {"coaxial": found.coaxial, "clear": found.clear, "whole": found.whole, "count": len(found.solutions)}
    across = Slot("D", MILLIMETRES * float(best.across), DIGITS)
    sizes = {"across": across, "off": Slot("ΔU", _off(wanted, float(best.ratio)), OFF), "planets": best.planets}
    parts = {"greatest": wanted.greatest, "widest": _widest(wanted, best)}
    yield drafting.phrase("gears chosen", **parts, **counts, **sizes)
    if most and len(found.solutions) > most:
        yield drafting.phrase("gears more", shown=most, count=len(found.solutions))
    sound = all(abs(teeth) >= USUAL_LEAST[teeth < 0] for teeth in best.teeth.values())
    key, met = "gears undercut" if sound else "gears least", tuple(_undercut(wanted, best))
    yield drafting.phrase(key, parts=joined(",  ", met))


def _widest(wanted: Wanted, best: Solution) -> str:
    """Name the largest wheel of the block."""
    planets = dict.fromkeys(planet for _, planet in wanted.rows)
    return max(planets, key=lambda name: wanted.raw.modules[name] * best.teeth[name])


def _undercut(wanted: Wanted, best: Solution) -> Iterator[str]:
    """Write the least teeth of external wheels and of rings, and how many more a ring has than the wheel within it."""
    kinds = {False: wanted.least, True: wanted.ring}
    for ring, least in kinds.items():
        free = (name for name, teeth in wanted.raw.teeth.items() if teeth is None)
        if sought := [name for name in free if (name in wanted.raw.rings) == ring]:
            name = min(sought, key=lambda name: abs(best.teeth[name]))
            yield f"{teeth_letters(name)} = {abs(best.teeth[name])} ≥ {least}".replace(" ", NBSP)
    for one, planet in wanted.rows:
        if one in wanted.raw.rings:
            more = -best.teeth[one] - best.teeth[planet]
            yield f"{teeth_letters(one)} − {teeth_letters(planet)} = {more} ≥ {CLEAR}".replace(" ", NBSP)
