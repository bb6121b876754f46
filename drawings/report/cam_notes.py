"""What is said of a cam in words: what is asked, its phases, sizes, angles, roller, shocks, flaws (пояснения)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from drawings.page.drafting import Drafting
from drawings.report.cam_letters import ACCELERATION, VELOCITY, letters, units
from drawings.report.phase_letters import phase_letter
from plans.cam.dimensions import RATIO
from plans.cam.tables import smoothing
from plans.model.cam import GROOVE, ROLLER, TABLE, Cam, Phase, interval_of
from plans.model.cam_motion import CamFound, Extreme, Flaw, Shock, Sizes

MM = 1000.0  # of a metre
RPM = 30 / math.pi  # of a rad/s
HARD = 1  # order of a shock that jumps the speed
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
        return (
            *self.asked(),
            *self.phases(),
            *self.smoothed(),
            *self.face(),
            *self.pressure(),
            *self.rolling(),
            *self.shocks(),
            *self.pressing(),
            *self.flaws(),
        )

    @property
    def cam(self) -> Cam:
        """The cam as it is asked for."""
        return self.found.cam

    def asked(self) -> Iterator[str]:
        """Say what kind of cam it is."""
        cam, word = self.cam, self.drafting.word
        kind = word(f"cam {cam.follower.motion} {cam.follower.end}")
        parts = {"lift": self.way(cam.lift), "letter": "Ψ" if cam.rocks else "H"}
        key = "cam asked" if cam.follower.reach is None else "cam asked reach"
        yield word(key, follower=kind, closure=word(f"cam closed by {cam.closure}"), **parts, **self._reach())
        if cam.speed is not None:
            sense = word("counter-clockwise" if cam.sense > 0 else "clockwise")
            key = "cam speed of travel" if cam.translates else "cam speed"
            numbers = {"n": self._number(cam.speed * RPM), "omega": self._number(cam.speed)}
            yield word(key, sense=sense, **numbers)

    def phases(self) -> Iterator[str]:
        """Tell the phases in their order, with their laws."""
        told = ";  ".join(self._phase(k, one) for k, one in enumerate(self.cam.phases))
        yield self.drafting.word("cam phases", phases=told)

    def _phase(self, number: int, phase: Phase) -> str:
        law = f" ({self.drafting.word(f'law {phase.law.name}')})" if phase.law is not None else ""
        return f"{phase_letter(self.cam, number, self.drafting)}{law}"

    def smoothed(self) -> Iterator[str]:
        """Say of each table that may be smoothed how far its curve is from its points, and where at most."""
        for phase in self.cam.moving():
            if phase.law is not None and phase.law.name == TABLE and phase.law.tolerance > 0:
                off, at = smoothing(phase.law)
                far, most = (self.way(share * abs(phase.change)) for share in (off, phase.law.tolerance))
                on, phi = self.drafting.word(f"cam on {phase.kind}"), self.place(phase.start + at * phase.angle)
                yield self.drafting.word("cam smoothed", phase=on, phi=phi, off=far, allowed=most)

    def sizes(self) -> Iterator[str]:
        """Say which main sizes were found."""
        cam, sizes = self.cam, self.found.sizes
        if cam.translates:
            return
        parts = [f"R_0 = {self._mm(sizes.base)}"]
        if cam.rocks:
            angle = f"{self._number(math.degrees(sizes.initial))}°"
            parts += [f"L = {self._mm(sizes.centre)}", f"ψ_0 = {angle}"]
        elif not cam.flat:
            parts += [f"e = {self._mm(sizes.offset)}", f"S_0 = {self._mm(math.sqrt(sizes.base**2 - sizes.offset**2))}"]
        yield self.drafting.word("cam sizes", sizes=",  ".join(parts))
        yield from self.face()

    def face(self) -> Iterator[str]:
        """Say how far contact goes on a flat face, and how far that reaches if the scene says it."""
        if self.cam.flat and not self.cam.translates:
            sides = (self._mm(one if self.cam.rocks else abs(one)) for one in self.found.face)
            key = ("cam face rocking" if self.cam.rocks else "cam face") + (" reach" if self._reach() else "")
            yield self.drafting.word(key, **dict(zip(("back", "front"), sides, strict=True)), **self._reach())

    def _reach(self) -> dict[str, str]:
        reach = self.cam.follower.reach
        return {} if reach is None else {"reach": self._mm(reach)}

    def setting(self) -> Iterator[str]:
        """Say how the cam stands on the main shaft."""
        if self.cam.setting:
            yield self.drafting.word("cam setting", angle=self._number(math.degrees(self.cam.setting)))

    def pressure(self) -> Iterator[str]:
        """Say how large the pressure angle grows on each kind of phase, and where."""
        pressed = self.cam.rocks or not self.cam.flat  # under a flat face that translates it is 0 throughout
        for kind, found in self.found.pressure.items() if pressed else ():
            permitted = interval_of(self.cam, kind)
            parts = {"phase": self.drafting.word(f"cam on {kind}"), **self._place(found)}
            told = {"angle": self._number(math.degrees(found.value)), **parts}
            if permitted is None:
                yield self.drafting.word("cam pressure", **told)
            else:
                low, high = (self._number(math.degrees(one)) for one in permitted)
                yield self.drafting.word("cam pressure limit", low=low, high=high, **told)

    def roller(self) -> Iterator[str]:
        """Say how sharply the pitch curve is bent, and how large the roller is."""
        found, word = self.found, self.drafting.word
        key = "cam profile sharpest" if self.cam.flat else "cam sharpest"
        if found.sharpest is not None:
            yield word(key, radius=self._mm(found.sharpest.value), **self._place(found.sharpest))
        if found.hollow is not None and not self.cam.flat:
            yield word("cam hollow radius", radius=self._mm(-found.hollow.value), **self._place(found.hollow))
        yield from self._radius()

    def rolling(self) -> Iterator[str]:
        """Say how large the roller is, and which line shows where its centre goes."""
        yield from self._radius()
        if self.found.roller:
            yield self.drafting.word("cam lines")

    def _radius(self) -> Iterator[str]:
        if self.found.roller:
            groove = self.found.hollow is not None and self.cam.closure == GROOVE
            by_rule = "cam roller in a groove by" if groove else "cam roller by"
            key = f"{by_rule} {self.found.rule}" if self.cam.roller is None else "cam roller given"
            yield self.drafting.word(key, roller=self._mm(self.found.roller))

    def shocks(self) -> Iterator[str]:
        """Say where it knocks, and how hard."""
        for one in self.found.shocks:
            key = "cam hard shock" if one.order == HARD else "cam soft shock"
            yield self.drafting.word(key, what=self._jumping(one), jump=self._jump(one), phi=self.place(one.turned))

    def _jumping(self, one: Shock) -> str:
        """Name what jumps: without a speed the derivative by the cam's turn."""
        if self.cam.speed is None:
            return letters(self.cam)[0] + "'" * one.order
        return self.drafting.word("cam velocity" if one.order == HARD else "cam acceleration")

    def _jump(self, one: Shock) -> str:
        cam = self.cam
        if cam.speed is None:
            unit = units(cam)[VELOCITY if one.order == HARD else ACCELERATION]
            return self._number(one.jump) if unit == RATIO else self._of(one.jump, unit)
        unit = ("rad" if cam.rocks else "m") + ("/s" if one.order == HARD else "/s2")
        return self._of(one.jump * cam.speed**one.order, unit)

    def flaws(self) -> Iterator[str]:
        """Say what is wrong from where to where, and what would help."""
        yield from map(self.flaw, self.found.flaws)
        mending, kinds = self.found.mending, {one.kind for one in self.found.flaws}
        if mending is not None and "pressure" in kinds:
            yield self.drafting.word("cam mending", base=self._mm(mending), offset=self._mm(self.found.sizes.offset))
        if mending is not None and kinds & {"concave", "sharp"}:
            yield self.drafting.word("cam mending radius", base=self._mm(mending))
        if self.found.advised is not None:
            yield self._advised(self.found.advised)

    def _advised(self, one: Sizes) -> str:
        """Say which main sizes would keep the pressure angle to its limits."""
        if self.cam.rocks:
            return self.drafting.word("cam advised rocking", base=self._mm(one.base), centre=self._mm(one.centre))
        return self.drafting.word("cam advised translating", base=self._mm(one.base), offset=self._mm(one.offset))

    def pressing(self) -> Iterator[str]:
        """Say how hard the follower is pressed on the cam, where it wears most, and what spring would just hold it.

        A roller rolls: what it would wear stuck on its pin is not told.
        """
        found = self.found.pressing
        if found is None:
            return
        ends = {"least": self._of(found.least.value, "N"), "most": self._of(found.most.value, "N")}
        yield self.drafting.word("cam pressing", **ends, phi=self.place(found.most.turned))
        if self.cam.follower.end != ROLLER:
            yield self.drafting.word(
                "cam wear", wear=self._of(found.wear.value, "W"), phi=self.place(found.wear.turned)
            )
        if found.least.value < 0:
            preload = self._of(found.preload, "N*m" if self.cam.rocks else "N")
            yield self.drafting.word("cam preload", preload=preload)

    def flaw(self, one: Flaw) -> str:
        """Say one flaw."""
        ends = {"start": self.place(one.start), "end": self.turn(one.end), "phi": self.place(one.worst.turned)}
        value = one.worst.value
        if one.kind in CORNERED and abs(value) < SHARP:
            return self.drafting.word(f"cam flaw {one.kind} corner", phi=ends["phi"])
        if one.kind == "crossing":
            return self._crossing(value, ends)
        told = self._number(math.degrees(value)) if one.kind == "pressure" else self._number(value * self._unit(one))
        most = {"most": self._number(MM * abs(value))} if one.kind in CORNERED else {}
        return self.drafting.word(f"cam flaw {one.kind}", worst=told, **most, **ends)

    def _crossing(self, lost: float, ends: Mapping[str, str]) -> str:
        """Say what a loop that is cut away costs, where the follower rests on what is left at all."""
        if math.isnan(lost):
            return self.drafting.word("cam flaw crossing", **ends)
        key = "cam flaw crossing and loss" if lost > 0 else "cam flaw crossing and no loss"
        return self.drafting.word(key, worst=self.way(lost), **ends)

    def _unit(self, one: Flaw) -> float:
        return 1.0 if one.kind in ("lift-off", "outrun") else MM

    def way(self, value: float) -> str:
        """Write how far the follower goes: mm, or degrees of one that rocks."""
        return f"{self._number(math.degrees(value))}°" if self.cam.rocks else self._mm(value)

    def turn(self, value: float) -> str:
        """Write how far the cam goes: degrees, or mm of one that translates."""
        return self._mm(value) if self.cam.translates else f"{self._number(math.degrees(value))}°"

    def place(self, value: float) -> str:
        """Write where the cam is, with the letter of its turn or of its travel."""
        return f"{letters(self.cam)[1]} = {self.turn(value)}"

    def _place(self, found: Extreme) -> dict[str, str]:
        return {"phi": self.place(found.turned)}

    def _mm(self, value: float) -> str:
        return self._of(MM * value, "mm")

    def _of(self, value: float, unit: str) -> str:
        return f"{self._number(value)} {self.drafting.word(unit)}"

    def _number(self, value: float) -> str:
        return self.drafting.number(value, self.digits)
