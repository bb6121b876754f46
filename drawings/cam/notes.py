"""The letters of a cam's law and sizes, and what the sheet says of it in words (кулачок словами)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting
from plans.cam.tables import smoothing
from plans.model.cam import GROOVE, MM, RATIO, ROLLER, TABLE, Cam, Phase, dimensions, interval_of
from plans.model.cam_motion import HARD, CamFlaw, CamFound, CamSizes, Extreme, Shock

ACCELERATION, VELOCITY, TRAVEL = "acceleration", "velocity", "travel"


class TableUnit(NamedTuple):
    """The unit that a table tells a quantity in, "" of what has none, and how many of it are one of SI."""

    unit: str
    size: float


MILLIMETRES, DEGREES, BARE = TableUnit("mm", MM), TableUnit("°", math.degrees(1)), TableUnit("", 1.0)
TABLE_UNITS = dict.fromkeys(("m", "m/rad", "m/rad2"), MILLIMETRES) | {"rad": DEGREES, RATIO: BARE, "1/rad": BARE}


def letters(cam: Cam) -> tuple[str, str]:
    """Give the letter of the follower's travel and that of the cam's turn."""
    return "ψ" if cam.rocks else "S", "x" if cam.translates else "φ"


def units(cam: Cam) -> dict[str, str]:
    """Give the units of the rows: of travel, then once and twice over that of the cam's turn."""
    return dict(zip((TRAVEL, VELOCITY, ACCELERATION), dimensions(cam), strict=True))


def table_units(cam: Cam) -> tuple[TableUnit, ...]:
    """Give how a table tells S, S' and S''."""
    return tuple(TABLE_UNITS.get(unit, TableUnit(unit, 1.0)) for unit in dimensions(cam))


DIGITS = 5
EXPLAINED = ("b", "h", "F_0", "M_0", "c")  # letters of the follower that the sheet says in words
REST = "rest"


def phase_indices(cam: Cam) -> tuple[str, ...]:
    """Give the index of each phase: a dwell at the lowest level is a rest, several of one kind are numbered."""
    lowest = min(min(phase.level, phase.level + phase.change) for phase in cam.phases)
    kinds = [REST if phase.change == 0 and phase.level == lowest else phase.kind for phase in cam.phases]
    return tuple(
        kind if kinds.count(kind) == 1 else f"{kind}\N{NO-BREAK SPACE}{kinds[: k + 1].count(kind)}"
        for k, kind in enumerate(kinds)
    )


def phase_letter(cam: Cam, number: int, drafting: Drafting) -> Phrase:
    """Letter a phase with its angle in degrees, or with its travel in millimetres where the cam translates."""
    index, angle = phase_indices(cam)[number], cam.phases[number].angle
    letter, size, unit = ("x", MM * angle, "") if cam.translates else ("φ", math.degrees(angle), "°")
    parts = drafting.letter(f"{letter}_{{{index}}} = "), drafting.slot(Slot(f"φ_{number}", size, DIGITS)), unit
    return joined("", parts)


RPM = 30 / math.pi  # of a rad/s
CORNERED = ("undercut", "hollow")  # flaws that a corner of the pitch curve has
SHARP = 1e-9  # m: so small a radius is that of a corner


class CamNotes(NamedTuple):
    """The notes on a cam by one road, with so many digits."""

    found: CamFound
    drafting: Drafting
    digits: int = 4

    @property
    def all(self) -> tuple[str, ...]:
        """What is asked, over which phases, how it runs, what is wrong with it; the sizes are in the table."""
        asked = (self.asked, self.phases, self.smoothed, self.face, self.pressure, self._radius)
        return tuple(line for part in (*asked, self.shocks, self.pressing, self.flaws) for line in part())

    @property
    def cam(self) -> Cam:
        """The cam as it is asked for."""
        return self.found.cam

    def asked(self) -> Iterator[str]:
        """Say what kind of cam it is."""
        cam, word, phrase = self.cam, self.drafting.word, self.drafting.phrase
        kind = word(f"cam {cam.follower.motion} {cam.follower.end}")
        parts = {"lift": self.way("lift", cam.lift), "letter": "Ψ" if cam.rocks else "H"}
        told = joined(", ", ("", *(self._told(letter, *size) for letter, size in cam.told.items())))
        yield phrase("cam asked", follower=kind, closure=word(f"cam closed by {cam.closure}"), told=told, **parts)
        if cam.speed is not None:
            sense = word("counter-clockwise" if cam.sense > 0 else "clockwise")
            key = "cam speed of travel" if cam.translates else "cam speed"
            numbers = {"n": self._slot("n", cam.speed * RPM), "omega": self._slot("ω", cam.speed)}
            yield phrase(key, sense=sense, **numbers)

    def _told(self, letter: str, size: float, unit: str) -> Phrase:
        """Write what is given, what only words explain with those."""
        said = f"{self.drafting.word(f'cam given {letter}')} " if letter in EXPLAINED else ""
        return joined("", (said, self.drafting.letter(letter), " = ", self._of(letter, size, unit)))

    def phases(self) -> Iterator[str]:
        """Tell the phases in their order, with their laws."""
        phases = ";  ".join(self._phase(k, phase) for k, phase in enumerate(self.cam.phases))
        yield self.drafting.word("cam phases", phases=phases)

    def _phase(self, number: int, phase: Phase) -> str:
        law = f" ({self.drafting.word(f'law {phase.law.name}')})" if phase.law is not None else ""
        return f"{phase_letter(self.cam, number, self.drafting)}{law}"

    def smoothed(self) -> Iterator[str]:
        """Say of each table that may be smoothed how far its curve is from its points, and where at most."""
        for k, phase in enumerate(self.cam.moving()):
            if phase.law is not None and phase.law.name == TABLE and phase.law.tolerance > 0:
                off, at = smoothing(phase.law)
                shares = (("off", off), ("allowed", phase.law.tolerance))
                parts = {name: self.way(f"{name} {k}", share * abs(phase.change)) for name, share in shares}
                parts |= {"phi": self.place(f"off {k}", phase.start + at * phase.angle)}
                yield self.drafting.phrase("cam smoothed", phase=self.drafting.word(f"cam on {phase.kind}"), **parts)

    def sizes(self) -> Iterator[str]:
        """Say which main sizes were found."""
        cam, sizes = self.cam, self.found.sizes
        if cam.translates:
            return
        parts = [self._mm("R_0", sizes.base)]
        if cam.rocks:
            parts += [self._mm("L", sizes.centre), self._angle("ψ_0", sizes.initial)]
        elif not cam.flat:
            parts += [self._mm("e", sizes.offset), self._mm("S_0", math.sqrt(sizes.base**2 - sizes.offset**2))]
        names = ("R_0", *(("L", "ψ_0") if cam.rocks else ("e", "S_0")))
        equations = (joined(" = ", pair) for pair in zip(names, parts, strict=False))
        yield self.drafting.phrase("cam sizes", sizes=joined(",  ", equations))
        yield from self.face()

    def face(self) -> Iterator[str]:
        """Say how far contact goes on a flat face."""
        if self.cam.flat and not self.cam.translates:
            ends = zip(("back", "front"), self.found.face, strict=True)
            sides = {side: self._mm(side, far if self.cam.rocks else abs(far)) for side, far in ends}
            yield self.drafting.phrase("cam face rocking" if self.cam.rocks else "cam face", **sides)

    def setting(self) -> Iterator[str]:
        """Say how the cam stands on the main shaft."""
        if self.cam.setting:
            yield self.drafting.phrase("cam setting", angle=self._slot("setting", math.degrees(self.cam.setting)))

    def pressure(self) -> Iterator[str]:
        """Say how large the pressure angle grows on each kind of phase, and where; of sizes chosen by it, that."""
        if self.cam.eased and not any(flaw.kind == "pressure" for flaw in self.found.flaws):
            yield self.drafting.phrase("cam eased", size="L" if self.cam.rocks else "e")
        for kind, found in self.found.pressure.items() if self.cam.pressed else ():
            permitted = interval_of(self.cam, kind)
            parts = {"phase": self.drafting.word(f"cam on {kind}"), "phi": self.place(f"α {kind}", found.turned)}
            numbers = {"angle": self._slot(f"α {kind}", math.degrees(found.value)), **parts}
            if permitted is None:
                asked = self.cam.limits.of(kind)  # of a return under force closure, and kept to by nothing
                more = {} if asked is None else {"asked": self.drafting.number(math.degrees(asked), self.digits)}
                yield self.drafting.phrase("cam pressure free" if more else "cam pressure", **numbers, **more)
            else:
                low, high = (self.drafting.number(math.degrees(limit), self.digits) for limit in permitted)
                yield self.drafting.phrase("cam pressure limit", low=low, high=high, **numbers)

    def roller(self) -> Iterator[str]:
        """Say how sharply the pitch curve is bent, and how large the roller is."""
        found, phrase = self.found, self.drafting.phrase
        key = "cam profile sharpest" if self.cam.flat else "cam sharpest"
        if found.sharpest is not None:
            yield phrase(key, **self._radius_at("ρ_min", found.sharpest, 1))
        if found.hollow is not None and not self.cam.flat:
            yield phrase("cam hollow radius", **self._radius_at("ρ_hol", found.hollow, -1))
        yield from self._radius()

    def _radius(self) -> Iterator[str]:
        if self.found.roller:
            groove = self.found.hollow is not None and self.cam.closure == GROOVE
            by_rule = "cam roller in a groove by" if groove else "cam roller by"
            key = f"{by_rule} {self.found.rule}" if self.cam.roller is None else "cam roller given"
            yield self.drafting.phrase(key, roller=self._mm("r_rol", self.found.roller))

    def shocks(self) -> Iterator[str]:
        """Say where it knocks, and how hard."""
        for k, shock in enumerate(self.found.shocks):
            key = "cam hard shock" if shock.order == HARD else "cam soft shock"
            at = self.place(f"jump {k}", shock.turned)
            yield self.drafting.phrase(key, what=self._jumping(shock), jump=self._jump(f"jump {k}", shock), phi=at)

    def _jumping(self, shock: Shock) -> str:
        """Name what jumps: without a speed the derivative by the cam's turn."""
        if self.cam.speed is None:
            return letters(self.cam)[0] + "'" * shock.order
        return self.drafting.word("cam velocity" if shock.order == HARD else "cam acceleration")

    def _jump(self, name: str, shock: Shock) -> Phrase:
        cam = self.cam
        if cam.speed is None:
            unit = units(cam)[VELOCITY if shock.order == HARD else ACCELERATION]
            return self._of(name, shock.jump, "" if unit == RATIO else unit)
        unit = ("rad" if cam.rocks else "m") + ("/s" if shock.order == HARD else "/s2")
        return self._of(name, shock.jump * cam.speed**shock.order, unit)

    def flaws(self) -> Iterator[str]:
        """Say what is wrong from where to where, and what would help."""
        yield from (self.flaw(k, flaw) for k, flaw in enumerate(self.found.flaws))
        mending, kinds = self.found.mending, {flaw.kind for flaw in self.found.flaws}
        if mending is not None and "pressure" in kinds:
            parts = {"base": self._mm("mending", mending), "offset": self._mm("e", self.found.sizes.offset)}
            yield self.drafting.phrase("cam mending", **parts)
        if mending is not None and kinds & {"concave", "sharp"}:
            yield self.drafting.phrase("cam mending radius", base=self._mm("mending", mending))
        if self.found.advised is not None:
            yield self._advised(self.found.advised)

    def _advised(self, sizes: CamSizes) -> str:
        """Say which main sizes would keep the pressure angle to its limits."""
        base = self._mm("R_0 advised", sizes.base)
        if self.cam.rocks:
            return self.drafting.phrase("cam advised rocking", base=base, centre=self._mm("L advised", sizes.centre))
        return self.drafting.phrase("cam advised translating", base=base, offset=self._mm("e advised", sizes.offset))

    def pressing(self) -> Iterator[str]:
        """Say how hard the follower is pressed on the cam, where it wears most, and what spring would just hold it.

        A roller rolls: what it would wear stuck on its pin is not told.
        """
        found = self.found.pressing
        if found is None:
            return
        ends = {"least": self._of("N_min", found.least.value, "N"), "most": self._of("N_max", found.most.value, "N")}
        yield self.drafting.phrase("cam pressing", **ends, phi=self.place("N_max", found.most.turned))
        if self.cam.follower.end != ROLLER:
            wear, at = self._of("wear", found.wear.value, "W"), self.place("wear", found.wear.turned)
            yield self.drafting.phrase("cam wear", wear=wear, phi=at)
        if found.least.value < 0:
            preload = self._of("preload", found.preload, "N*m" if self.cam.rocks else "N")
            yield self.drafting.phrase("cam preload", preload=preload)

    def flaw(self, number: int, flaw: CamFlaw) -> str:
        """Say one flaw."""
        name, value = f"flaw {number}", flaw.worst.value
        ends: dict[str, object] = {
            "start": self.place(f"{name} start", flaw.start),
            "end": self.turn(f"φ {name} end", flaw.end),
            "phi": self.place(name, flaw.worst.turned),
        }
        if flaw.kind in CORNERED and abs(value) < SHARP:
            return self.drafting.phrase(f"cam flaw {flaw.kind} corner", phi=ends["phi"])
        if flaw.kind == "crossing":
            return self._crossing(name, value, ends)
        unit = {"pressure": math.degrees(1), "lift-off": 1.0, "outrun": 1.0}.get(flaw.kind, MM)
        most = {"most": self._slot(f"{name} most", MM * abs(value))} if flaw.kind in CORNERED else {}
        return self.drafting.phrase(f"cam flaw {flaw.kind}", worst=self._slot(name, unit * value), **most, **ends)

    def _crossing(self, name: str, lost: float, ends: Mapping[str, object]) -> str:
        """Say what a loop that is cut away costs, where the follower rests on what is left at all."""
        if math.isnan(lost):
            return self.drafting.phrase("cam flaw crossing", **ends)
        key = "cam flaw crossing and loss" if lost > 0 else "cam flaw crossing and no loss"
        return self.drafting.phrase(key, worst=self.way(name, lost), **ends)

    def way(self, name: str, value: float) -> Phrase:
        """Write how far the follower goes: mm, or degrees of one that rocks."""
        return self._angle(name, value) if self.cam.rocks else self._mm(name, value)

    def turn(self, name: str, value: float) -> Phrase:
        """Write how far the cam goes: degrees, or mm of one that translates."""
        return self._mm(name, value) if self.cam.translates else self._angle(name, value)

    def place(self, name: str, value: float) -> Phrase:
        """Write where the cam is at a quantity, with the letter of its turn or of its travel."""
        return joined(" = ", (letters(self.cam)[1], self.turn(f"φ {name}", value)))

    def _radius_at(self, name: str, found: Extreme, sign: int) -> dict[str, Phrase]:
        return {"radius": self._mm(name, sign * found.value), "phi": self.place(name, found.turned)}

    def _angle(self, name: str, value: float) -> Phrase:
        return joined("", (self.drafting.slot(self._slot(name, math.degrees(value))), "°"))

    def _mm(self, name: str, value: float) -> Phrase:
        return self._of(name, MM * value, "mm")

    def _of(self, name: str, value: float, unit: str) -> Phrase:
        size = self.drafting.slot(self._slot(name, value))
        return joined(" ", (size, self.drafting.word(unit))) if unit else size

    def _slot(self, name: str, value: float) -> Slot:
        """Name a number by its quantity and its cam."""
        return Slot(f"{name} {self.cam.name}", value, self.digits)
