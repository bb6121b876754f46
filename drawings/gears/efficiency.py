"""The efficiency of a train on its sheet: of meshes, ratios with friction, what the train passes on (КПД механизма)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from drawings.gears.willis import quantity, ratio_letters, ratio_named, stopped
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
        train = self.study.train
        if train.efficiency:
            alike = dict.fromkeys(train.efficiency.values())
            parts = [self._equal([m for m, one in train.efficiency.items() if one == part], part) for part in alike]
            yield self.drafting.phrase("gears efficiency", parts=joined(",  ", parts))
        for gear in train.gears:
            found = self.speeds.friction(gear)
            if found:
                less = lossy(train, gear)
                yield from self._gear(gear, less)
                yield from self._found(gear, found, less)

    def _equal(self, meshes: list[tuple[str, str]], part: Fraction) -> Phrase:
        letters = [f"η_{{{pair_of(*mesh)}}}" for mesh in meshes]
        return joined(" = ", (*letters, self.drafting.slot(Slot(f"η {'-'.join(meshes[0])}", float(part), DIGITS))))

    def _gear(self, gear: BoxGear, lossy: Train) -> Iterator[Phrase]:
        """Write the ratios with carriers stopped as friction changes them, and the ratio of moments by them."""
        start = f"{gear.name}:  " if gear.name else ""
        for one in lossy.willis:
            letters, numbers, value = self._factors(one, lossy)
            if letters:
                name, own = ratio_letters(one), self.drafting.number(float(one.ratio), DIGITS)
                slot = self.drafting.slot(Slot(of_gear(f"{quantity(one)}'", gear), float(one.ratio * value), DIGITS))
                yield joined(" = ", (f"{start}{primed(name)}", f"{name}{letters}", f"{own}{numbers}", slot))

    def _factors(self, one: Willis, lossy: Train) -> tuple[str, str, Fraction]:
        """Give what friction multiplies a ratio by: in letters, in numbers, the product."""
        letters, numbers, product = "", "", Fraction(1)
        for way in ((first.name, second.name) for first, second in zip(one.driving, one.driven, strict=True)):
            mesh, power = (way, 1) if way in lossy.factors else (way[::-1], -1)
            factor, part = lossy.factors[mesh] ** power, lossy.efficiency[mesh]
            sign = "" if factor == 1 else "·" if factor < 1 else "/"
            letters += f"{sign}η_{{{pair_of(*mesh)}}}" if sign else ""
            numbers += f"{sign}{self.drafting.number(float(part), DIGITS)}" if sign else ""
            product *= factor
        return letters, numbers, product

    def _found(self, gear: BoxGear, found: TrainFriction, lossy: Train) -> Iterator[str]:
        """Write the ratio of moments over that of speeds; of several drives what is given out of what is put in."""
        value = self.drafting.slot(Slot(of_gear(self.study.efficiency_name, gear), found.efficiency, DIGITS))
        locks = self.drafting.phrase("gears locks", link=link_letters(lossy.drives[0][0])) if found.locks else ""
        said = (locks,) if locks else ()
        if not lossy.single:
            power = self.drafting.phrase("gears given out")
            yield locks or joined(" = ", ("η", power, value))
            return
        ratio = TrainSpeeds(lossy).ratio(gear) if determined(lossy, gear) else Fraction(0)
        name, slot = ratio_named(self.study, gear), self.drafting.slot
        whole = slot(Slot(of_gear(f"{self.study.ratio_name}'", gear), float(ratio or 0), DIGITS))
        first = joined(" = ", (primed(name), *filter(None, (primed(stopped(lossy, gear)),)), whole))
        terms = name.replace("U", "η"), f"{primed(name)}/{name}", value
        yield joined(";  ", (first, joined(" = ", terms), *said))


def primed(letters: str) -> str:
    """Letter a ratio as friction changes it."""
    return letters.replace("U", "U'")
