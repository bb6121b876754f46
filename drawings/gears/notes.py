"""A gear train in words: what is given, coaxiality, Willis's formula with numbers, ratios (пояснения)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import chain
from typing import NamedTuple

from drawings.gears import synthesis
from drawings.gears.efficiency import EfficiencyNotes
from drawings.gears.willis import by_teeth, lettered, quantity, ratio_letters, stopped
from drawings.lettering.gear_letters import link_letters, teeth_letters
from drawings.lettering.words import Phrase, Slot, joined, with_index
from drawings.page.page import Drafting
from plans.analytic.gears import TrainSpeeds
from plans.gears.study import GearsStudy, of_gear
from plans.gears.synthesis import CLEAR
from plans.model.gears import FRAME, BoxGear, ToothedWheel, Train, assembly, bodies

MILLIMETRES = 1000.0
DIGITS = 5
OMEGA = "ω_{{{}}}"


class GearsNotes(NamedTuple):
    """The notes on a gear train."""

    study: GearsStudy
    speeds: TrainSpeeds
    drafting: Drafting

    @property
    def all(self) -> tuple[str, ...]:
        """What is given, how it fits, what Willis gives, how the plans are read."""
        told = self.given(), self.synthesis(), self.fit(), self.willis(), self.ratios(whole=True)
        return tuple(chain(*told, self.inertia(), self.moments(), self.read()))

    def given(self) -> Iterator[str]:
        """Tell teeth, module and speeds."""
        train, slot = self.study.train, self.drafting.slot
        for module in dict.fromkeys(wheel.module for wheel in train.wheels.values()):
            some = [wheel for wheel in train.wheels.values() if wheel.module == module]
            letter = module_letter(train, some[0])
            teeth = joined(",  ", (self._equal(teeth_letters(w.name), Slot(f"z_{w.name}", abs(w.teeth))) for w in some))
            size = Slot(f"m {some[0].name}", MILLIMETRES * float(module))
            yield self._said("gears teeth", letter=letter, module=slot(size), teeth=teeth)
        if self.study.lacking and not self.study.searched:
            found = (f"{teeth_letters(name)} ({self._coaxial(name)})" for name in self.study.lacking)
            yield self._said("gears found", names=",  ".join(found))
        for link, speed in train.drives:
            n, omega = Slot(f"n_{link}", speed * 30 / math.pi, DIGITS), Slot(f"given ω_{link}", speed, DIGITS)
            yield self._said("gears drive", link=link, n=n, omega=omega)
        if train.joined:
            groups = (" – ".join(map(link_letters, group)) for group in train.joined)
            yield self._said("gears joined", links=";  ".join(groups))
        for gear in train.gears:
            if gear.name:
                names = ", ".join(map(link_letters, self.study.engaged(gear)))
                yield self._said("gears engaged", gear=gear.name, names=names)

    def _coaxial(self, wheel: str) -> str:
        """Write the condition of coaxiality that gives the teeth of a wheel: a_12 = a_23."""
        train = self.study.train
        links = {mesh: {train.wheels[name].link for name in mesh} for mesh in train.meshes}
        axes = {mesh: {train.heights[link] for link in links[mesh]} for mesh in links}
        own = next(mesh for mesh in axes if wheel in mesh)
        alike = [mesh for mesh in axes if mesh != own and axes[mesh] == axes[own]]
        known = min(alike, key=lambda mesh: (len({*mesh} & {*self.study.lacking}), links[mesh].isdisjoint(links[own])))
        return " = ".join(f"a_{{{''.join(mesh)}}}" for mesh in (known, own))

    def synthesis(self, most: int | None = synthesis.SHOWN) -> Iterator[str]:
        """Tell how the teeth were found, where a ratio is wanted, and how many solutions are not listed."""
        if self.study.searched:
            yield from synthesis.notes(self.study.searched, self.drafting, most)

    def fit(self) -> Iterator[str]:
        """Tell the distances of axes, and the conditions of neighbourhood and of assembly."""
        train = self.study.train
        for one, other in train.pairs:
            if one.side:
                yield self._cones(one, other)
                continue
            sign = "−" if one.internal or other.internal else "+"
            large, small = (other, one) if other.internal else (one, other)
            terms = f"{teeth_letters(large.name)} {sign} {teeth_letters(small.name)}"
            formula = f"{module_letter(train, one)}({terms})/2"
            far = Slot(f"a_{one.name}{other.name}", MILLIMETRES * float(one.module * abs(one.teeth + other.teeth) / 2))
            yield self._said("gears distance", pair=f"{one.name}{other.name}", formula=formula, far=far)
        yield from self._cut()
        for link in train.carrier_of if (train.planets or 0) > 1 else ():
            yield from self._planets(link)

    def _cones(self, one: ToothedWheel, other: ToothedWheel) -> Phrase:
        """Tell the half angles of two pitch cones and how long their common edge is."""
        pair, far = f"{one.name}{other.name}", MILLIMETRES * float(one.module / 2) * math.hypot(one.teeth, other.teeth)
        said: dict[str, object] = {"pair": pair, "far": Slot(f"R_{pair}", far, DIGITS)}
        said |= {"one": one.name, "other": other.name}
        for key, a, b in (("first", one, other), ("second", other, one)):
            said[key] = Slot(f"δ_{a.name}", math.degrees(math.atan(a.teeth / b.teeth)), DIGITS)
        return self._said("gears cones", letter=module_letter(self.study.train, one), **said)

    def _cut(self) -> Iterator[str]:
        """Warn of wheels that a rack undercuts, and of rings with hardly more teeth than the wheel within."""
        least, wheels = synthesis.USUAL_LEAST[False], self.study.train.wheels.values()
        few = [f"{teeth_letters(w.name)} = {w.teeth}" for w in wheels if 0 < w.teeth < least and not w.side]
        pairs = (sorted(pair, key=lambda wheel: wheel.teeth) for pair in self.study.train.pairs)
        more = [(ring, inner, -ring.teeth - inner.teeth) for ring, inner in pairs if ring.internal]
        close = [f"{teeth_letters(a.name)} − {teeth_letters(b.name)} = {n}" for a, b, n in more if n < CLEAR]
        yield from (self._said("gears few", least=least, parts=",  ".join(few)),) if few else ()
        yield from (self._said("gears tips meet", clear=CLEAR, parts=",  ".join(close)),) if close else ()

    def _planets(self, link: str) -> Iterator[str]:
        train, count = self.study.train, self.study.train.planets or 1
        far = train.heights[link] - train.heights[train.carrier_of[link]]
        rows = {row.cross.name: ("".join(mesh), row) for mesh, row in train.bevels.items() if row.cross.link == link}
        for name, (pair, row) in rows.items():
            share, tip = Slot(f"share {name}", 180 / count, DIGITS), Slot(f"tip {name}", row.tip, DIGITS)
            yield self._said("gears cone", wheel=name, count=count, share=share, tip=tip, pair=pair)
        for wheel in (wheel for wheel in train.wheels.values() if wheel.link == link and not wheel.side):
            chord = Slot(f"chord {wheel.name}", MILLIMETRES * 2 * float(far) * math.sin(math.pi / count))
            tips = Slot(f"tips {wheel.name}", MILLIMETRES * float(wheel.module * (wheel.teeth + 2)))
            letter = module_letter(train, wheel)
            yield self._said("gears chord", letter=letter, wheel=wheel.name, count=count, chord=chord, tips=tips)
        for one in assembly(train, link):
            key = "gears alike" if one.blocks else "gears whole"
            yield self._said(key, **one.parts(count), share=str(abs(one.share)))

    def willis(self) -> Iterator[str]:
        """Write Willis's formula of each two wheels about a planet, in letters and in numbers."""
        for one in self.study.train.willis:
            over = f" − ω_{{{one.carrier}}}" if one.carrier else ""
            top, low = (OMEGA.format(wheel.link) + over for wheel in (one.first, one.other))
            speeds = f"({top})/({low})" if over else f"{top}/{low}"
            value = self.drafting.slot(Slot(quantity(one), float(one.ratio), DIGITS))
            yield joined(" = ", (ratio_letters(one), speeds, *by_teeth(one), value))

    def ratios(self, whole: bool = False) -> Iterator[str]:
        """Tell the ratio of each gear, by Willis's formula where that gives it at once, and the driven speed.

        The whole of it tells, before a ratio that its formulas give only together, these for the links as they turn.
        """
        for gear in self.study.train.gears:
            yield from self._together(gear) if whole and not stopped(self.study.train, gear) else ()
            yield from (self._ratio(gear), *self.racks(gear))

    def racks(self, gear: BoxGear) -> Iterator[Phrase]:
        """Tell how fast a rack goes by its wheel, and how far in a turn of the driving link."""
        train, slot, drive = self.study.train, self.drafting.slot, self.study.train.drives[0][0]
        for rack, name in train.racks.items():
            wheel, sign = train.wheels[name], "" if train.rack_side(rack) > 0 else "−"
            formula = f"{sign}ω_{{{wheel.link}}}·{module_letter(train, wheel)}·{teeth_letters(name)}/2"
            v = slot(Slot(of_gear(f"v_{rack}", gear), self.speeds.rack(gear, rack), DIGITS))
            yield joined("", (f"v_{{{of_gear(rack, gear)}}} = {formula} = ", v, f" {self.drafting.word('m/s')}"))
            if (travel := self.speeds.travel(gear, rack)) is not None:
                h = slot(Slot(of_gear(f"h_{rack}", gear), travel, DIGITS))
                letters = f"h_{{{of_gear(rack, gear)}}} = 2π·v_{{{rack}}}/ω_{{{drive}}}"
                yield self._said("gears rack", rack=rack, link=drive, letters=letters, far=h)

    def _together(self, gear: BoxGear) -> Iterator[str]:
        """Write Willis's formulas for what turns as one and what rests: w_1 - w_H = U_13^(H)(w_3 - w_H)."""
        train = self.study.train
        body = bodies(train.links, (*train.joined, *gear.locked, *((FRAME, link) for link in gear.held)))
        for one in train.willis:
            first, other, carrier = (body[link] for link in (one.first.link, one.other.link, one.carrier or FRAME))
            if len({first, other, carrier}) > 1:
                over, under = (_over_carrier(link, carrier) for link in (first, other))
                yield f"{over} = {ratio_letters(one)}{f'({under})' if '−' in under else under}"

    def _ratio(self, gear: BoxGear) -> Phrase:
        driving, driven, ratio = self.study.train.drives[0][0], self.study.train.output, self.speeds.ratio(gear)
        speed, slot = self.speeds.true(gear)[driven], self.drafting.slot
        n = slot(Slot(of_gear(f"n_{driven}", gear), speed * 30 / math.pi, DIGITS))
        turns = joined("", (f"n_{{{driven}}} = ", n, f" {self.drafting.word('rpm')}"))
        if ratio is None:
            omega = slot(Slot(of_gear(f"ω_{driven}", gear), speed, DIGITS))
            index = f"{driven},{gear.name}" if gear.name else driven
            return joined("", (f"ω_{{{index}}} = ", omega, f" {self.drafting.word('rad/s')};  ", turns))
        value = slot(Slot(of_gear(self.study.ratio_name, gear), float(ratio), DIGITS))
        formula = stopped(self.study.train, gear) or f"ω_{{{driving}}}/ω_{{{driven}}}"
        terms = [lettered(self.study.ratio_name, gear), formula]
        terms += [str(ratio).replace("-", "−")] if ratio.denominator != 1 else []
        return joined("", (joined(" = ", (*terms, value)), ";  ", turns))

    def inertia(self) -> Iterator[str]:
        """Tell the inertia of links, and how that of all is reduced."""
        train, slot = self.study.train, self.drafting.slot
        if train.single and (train.inertia or train.masses):
            parts = [self._equal(f"J_{{{one}}}", Slot(f"given J_{one}", size)) for one, size in train.inertia.items()]
            said = [joined("", (part, f" {self.drafting.word('kg*m2')}")) for part in parts]
            masses = ((f"m_{{{one}}} = ", slot(Slot(f"given m_{one}", size))) for one, size in train.masses.items())
            said += [joined("", (*pair, f" {self.drafting.word('kg')}")) for pair in masses]
            yield self._said(
                "gears inertia", drive=train.drives[0][0], parts=joined(",  ", said), count=train.planets or 1
            )
            if train.planets is None and train.carrier_of.keys() & {*train.inertia, *train.masses}:
                yield self._said("gears one planet")

    def moments(self) -> Iterator[str]:
        """Tell the load, how the moments that balance it are found, and what friction in the meshes takes."""
        train = self.study.train
        if train.load is not None:
            if self.study.force is not None:
                rack, force = self.study.force
                wheel = train.wheels[train.racks[rack]]
                arm = f"{module_letter(train, wheel)}·{teeth_letters(wheel.name)}/2"
                yield self._said("gears force", rack=rack, force=Slot("force", force), arm=arm, link=wheel.link)
            key = "gears load" if train.single else "gears load of several"
            yield self._said(key, link=link_letters(train.output), load=Slot("load", train.load))
            if train.load == self.study.resisted:
                yield self._said("gears load of machine")
            for gear in train.gears:
                if self.study.closed(gear) or not train.single:
                    yield from self._powers(gear)
            if not all(map(self.speeds.moments, train.gears)):
                yield self._said("gears unbalanced")
        yield from EfficiencyNotes(*self).all

    def _powers(self, gear: BoxGear) -> Iterator[str]:
        """Tell the power that is put in and what flows through joints; what is more than that circulates."""
        powers = self.speeds.powers(gear)
        if powers:
            told = ((f"P_{{{of_gear(name, gear)}}}", of_gear(f"P_{name}", gear), size) for name, size in powers.items())
            parts = [self._equal(letter, Slot(name, size, DIGITS)) for letter, name, size in told]
            said = "gears circulating" if self.speeds.circulates(gear) else "gears powers"
            said = said if self.study.train.joints else "gears put in"
            yield self._said(said, powers=joined(",  ", parts))

    def read(self) -> Iterator[str]:
        """Say how the plans are read, and on what assumed speed they rest."""
        yield self._said("gears read")
        yield from self._across()
        for link in dict.fromkeys(link for plan in self.study.plans for link in plan.assumed):
            yield self._said("gears assumed", link=link_letters(link))

    def _across(self) -> Iterator[Phrase]:
        """Say of all axes across in one note where velocities stand that are about them, and how links turn there."""
        across, planets = self.study.train.crossing, self.study.train.carrier_of
        image = next((with_index(spot.image) for spot in self.study.spots if spot.across is not None), "")
        over, fixed = ([link for link in across if (link in planets) == free] for free in (True, False))
        kinds = ("gears upright", "{}", [*across]), ("gears over", OMEGA, over), ("gears axis across", OMEGA, fixed)
        told = ((key, ", ".join(map(form.format, links))) for key, form, links in kinds if links)
        said = [self._said(key, links=links, image=image) for key, links in told]
        yield from (joined(";  ", said),) if said else ()

    def _equal(self, letter: str, slot: Slot) -> Phrase:
        return joined(" = ", (letter, self.drafting.slot(slot)))

    def _said(self, key: str, **parts: object) -> Phrase:
        return self.drafting.phrase(key, **parts)


def module_letter(train: Train, wheel: ToothedWheel) -> str:
    """Letter the module of a wheel: m, and where the train has several by the first mesh of that one, m_12."""
    meshes = *train.meshes, *((wheel, rack) for rack, wheel in train.racks.items())
    alike = [mesh for mesh in meshes if train.wheels[mesh[0]].module == wheel.module]
    return "m" if len(alike) == len(meshes) else f"m_{{{''.join(alike[0])}}}"


def _over_carrier(link: str, carrier: str) -> str:
    """Write the speed of a body over that of a carrier, either of which may rest."""
    parts = [f"{sign}ω_{{{one}}}" for sign, one in (("", link), ("−", carrier)) if one != FRAME]
    return "0" if link == carrier else " ".join(parts).replace(" −", " − ")
