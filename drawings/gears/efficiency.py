"""The efficiency of a train on its sheet: of meshes, ratios with friction, what the train passes on (КПД механизма)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from drawings.gears.willis import lettered, quantity, ratio_letters, stopped
from drawings.lettering.gear_letters import link_letters
from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting
from plans.analytic.gears import TrainFriction, TrainSpeeds
from plans.gears.efficiency import lossy
from plans.gears.study import GearsStudy, of_gear, pair_of
from plans.model.gears import BoxGear, Train, Willis
from plans.model.trains import determined

DIGITS = 5


class EfficiencyNotes(NamedTuple):
    """The notes on what friction in the meshes takes."""

    study: GearsStudy
    speeds: TrainSpeeds
    drafting: Drafting

    @property
    def all(self) -> Iterator[str]:
        """Tell the efficiency of meshes, then of each gear what friction makes of its ratios, and the efficiency."""
        parts = self.study.train.efficiency
        if parts:
            alike = [[mesh for mesh, part in parts.items() if part == one] for one in dict.fromkeys(parts.values())]
            slots = (self._slot(f"η {'-'.join(some[0])}", parts[some[0]]) for some in alike)
            told = (joined(" = ", (*map(_letter, some), slot)) for some, slot in zip(alike, slots, strict=True))
            yield self.drafting.phrase("gears efficiency", parts=joined(",  ", told))
        for gear in self.study.train.gears:
            if found := self.speeds.friction(gear):
                yield from self._gear(gear, lossy(self.study.train, gear), found)

    def _slot(self, name: str, value: Fraction | float) -> Phrase:
        return self.drafting.slot(Slot(name, float(value), DIGITS))

    def _gear(self, gear: BoxGear, lossy: Train, found: TrainFriction) -> Iterator[str]:
        """Write ratios as friction changes them, and the efficiency: of several drives by their powers."""
        for one in lossy.willis:
            letters, numbers, product = self._factors(one, lossy)
            name, own = ratio_letters(one), self.drafting.number(float(one.ratio), DIGITS)
            if letters:
                start = f"{gear.name}:  " if gear.name else ""
                value = self._slot(of_gear(f"{quantity(one)}'", gear), one.ratio * product)
                yield joined(" = ", (start + primed(name), name + letters, own + numbers, value))
        value, said = self._slot(of_gear(self.study.efficiency_name, gear), found.efficiency), list[str]()
        if lossy.single:
            ratio = TrainSpeeds(lossy).ratio(gear) if determined(lossy, gear) else None
            name, slot = lettered(self.study.ratio_name, gear), of_gear(f"{self.study.ratio_name}'", gear)
            whole = primed(name), primed(stopped(lossy, gear)), self._slot(slot, ratio or 0)
            said.append(joined(" = ", filter(None, whole)))
            racks = (_letter(mesh) for mesh in lossy.efficiency if lossy.driven in mesh)
            terms = "·".join((f"{primed(name)}/{name}", *racks))
            said.append(joined(" = ", (lettered(self.study.efficiency_name, gear), terms, value)))
        elif not found.locks:
            said.append(joined(" = ", ("η", self.drafting.phrase("gears given out"), value)))
        if found.locks:
            said.append(self.drafting.phrase("gears locks", link=link_letters(lossy.drives[0][0])))
        yield joined(";  ", said)

    def _factors(self, one: Willis, lossy: Train) -> tuple[str, str, Fraction]:
        """Give what friction multiplies a ratio by: in letters, in numbers, the product."""
        letters, numbers, product = "", "", Fraction(1)
        for way in ((first.name, second.name) for first, second in zip(one.driving, one.driven, strict=True)):
            mesh, power = (way, 1) if way in lossy.factors else (way[::-1], -1)
            factor = lossy.factors[mesh] ** power
            if factor != 1:
                sign = "·" if factor < 1 else "/"
                letters += f"{sign}{_letter(mesh)}"
                numbers += f"{sign}{self.drafting.number(float(lossy.efficiency[mesh]), DIGITS)}"
            product *= factor
        return letters, numbers, product


def _letter(mesh: tuple[str, str]) -> str:
    return f"η_{{{pair_of(*mesh)}}}"


def primed(letters: str) -> str:
    """Letter a ratio as friction changes it."""
    return letters.replace("U", "U'")
