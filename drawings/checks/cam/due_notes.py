"""The notes that a cam must have, composed a second time, of what the analysis found (пояснения листа кулачка)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from drawings.checks.cam.cam_expected import phase_name
from drawings.checks.cam.cam_units import BARE
from drawings.page.drafting import Drafting
from plans.analytic.cam.laws import LAWS
from plans.model.cam import ROLLER, TABLE, Law, interval_of
from plans.model.cam_motion import CamFound, Extreme, Flaw

MM = 1000.0
CORNER = 1e-9  # m: so small a radius is that of a corner


@dataclass(frozen=True)
class DueNotes:
    """The notes that a cam must have, with all digits of their numbers."""

    found: CamFound
    drafting: Drafting

    def all(self) -> Iterator[str]:
        """Give them in their order."""
        yield from self.task()
        yield from self.smoothed()
        if not self.found.cam.translates:
            yield from self._face()
        yield from self.pressure()
        yield from self.rolled()
        yield from [self._word("cam lines")] if self.found.roller else []
        yield from self.failing()

    def sizes(self) -> Iterator[str]:
        """Give the main sizes, which the report tells in a note, and what a face needs."""
        own, cam = self.found.sizes, self.found.cam
        if cam.translates:
            return
        told = {"R_0": self._mm(own.base)}
        if cam.rocks:
            told |= {"L": self._mm(own.centre), "ψ_0": self._degrees(own.initial)}
        elif not cam.flat:
            level = math.sqrt((own.base - own.offset) * (own.base + own.offset))
            told |= {"e": self._mm(own.offset), "S_0": self._mm(level)}
        yield self._word("cam sizes", sizes=",  ".join(f"{letter} = {size}" for letter, size in told.items()))
        yield from self._face()

    def pressure(self) -> Iterator[str]:
        """Give the largest pressure angles; under a flat face that translates there is none."""
        if self.found.cam.rocks or not self.found.cam.flat:
            yield from map(self._pressure, self.found.pressure.items())

    def bent(self) -> Iterator[str]:
        """Give how sharply the curve bends, and into a hollow, as the report tells it."""
        found = self.found
        if found.sharpest is not None:
            key = "cam profile sharpest" if found.cam.flat else "cam sharpest"
            yield self._word(key, radius=self._mm(found.sharpest.value), phi=self._at(found.sharpest.turned))
        if found.hollow is not None and not found.cam.flat:
            radius = self._mm(-found.hollow.value)
            yield self._word("cam hollow radius", radius=radius, phi=self._at(found.hollow.turned))

    def failing(self) -> Iterator[str]:
        """Give where it knocks, how hard it is pressed, what is wrong and what would help."""
        yield from map(self._shock, range(len(self.found.shocks)))
        yield from self._pressing()
        yield from map(self._flaw, self.found.flaws)
        yield from self._mending()

    def _mending(self) -> Iterator[str]:
        base, told = self.found.mending, [one.kind for one in self.found.flaws]
        if base is not None and self.found.cam.flat and ("concave" in told or "sharp" in told):
            yield self._word("cam mending radius", base=self._mm(base))
        elif base is not None and "pressure" in told:
            yield self._word("cam mending", base=self._mm(base), offset=self._mm(self.found.sizes.offset))
        own = self.found.advised
        if own is not None and self.found.cam.rocks:
            yield self._word("cam advised rocking", base=self._mm(own.base), centre=self._mm(own.centre))
        elif own is not None:
            yield self._word("cam advised translating", base=self._mm(own.base), offset=self._mm(own.offset))

    def _word(self, key: str, **parts: str) -> str:
        return self.drafting.word(key, **parts)

    def _number(self, value: float, unit: str = "") -> str:
        return f"{self.drafting.number(value)} {self.drafting.word(unit)}" if unit else self.drafting.number(value)

    def _mm(self, value: float) -> str:
        return self._number(MM * value, "mm")

    def _degrees(self, value: float) -> str:
        return f"{self._number(math.degrees(value))}°"

    def _turn(self, turned: float) -> str:
        return (self._mm if self.found.cam.translates else self._degrees)(turned)

    def _way(self, value: float) -> str:
        return (self._degrees if self.found.cam.rocks else self._mm)(value)

    def _at(self, turned: float) -> str:
        return f"{'x' if self.found.cam.translates else 'φ'} = {self._turn(turned)}"

    def task(self) -> Iterator[str]:
        """Give what is asked, how fast it moves, its phases."""
        cam = self.found.cam
        moves, held = f"cam {cam.follower.motion} {cam.follower.end}", f"cam closed by {cam.closure}"
        lift = max(one.level + max(one.change, 0.0) for one in cam.phases)
        parts = {"follower": self._word(moves), "closure": self._word(held), "letter": "Ψ" if cam.rocks else "H"}
        reach = cam.follower.reach
        yield self._word(
            "cam asked" if reach is None else "cam asked reach",
            lift=self._way(lift),
            reach=self._mm(reach or 0.0),
            **parts,
        )
        if cam.speed is not None:
            key = "cam speed of travel" if cam.translates else "cam speed"
            sense = self._word("clockwise" if cam.sense < 0 else "counter-clockwise")
            turns = self._number(cam.speed / math.tau * 60)
            yield self._word(key, sense=sense, n=turns, omega=self._number(cam.speed))
        laws = ("" if one.law is None else f" ({self._word(f'law {one.law.name}')})" for one in cam.phases)
        letters = (phase_name(cam, k, self.drafting) for k in range(len(cam.phases)))
        yield self._word("cam phases", phases=";  ".join(map("".join, zip(letters, laws, strict=True))))

    def smoothed(self) -> Iterator[str]:
        """Say how far the curve of a smoothed table is from its points: at one of those where it is farthest."""
        for phase in self.found.cam.moving():
            if phase.law is not None and phase.law.name == TABLE and phase.law.tolerance > 0:
                off, share = smoothed(phase.law)
                far, most = (self._way(one * abs(phase.change)) for one in (off, phase.law.tolerance))
                at = self._at(phase.start + share * phase.angle)
                yield self._word(
                    "cam smoothed", phase=self._word(f"cam on {phase.kind}"), phi=at, off=far, allowed=most
                )

    def _face(self) -> Iterator[str]:
        if self.found.cam.flat:
            rocks = self.found.cam.rocks
            back, front = (self._mm(one if rocks else abs(one)) for one in self.found.face)
            reach = self.found.cam.follower.reach
            key = f"cam face{' rocking' if rocks else ''}{'' if reach is None else ' reach'}"
            yield self._word(key, back=back, front=front, reach=self._mm(reach or 0.0))

    def _pressure(self, one: tuple[str, Extreme]) -> str:
        kind, found = one
        limits = interval_of(self.found.cam, kind)
        parts = {"phase": self._word(f"cam on {kind}"), "angle": self._number(math.degrees(found.value))}
        if limits is None:
            return self._word("cam pressure", phi=self._at(found.turned), **parts)
        ends = {"low": self._number(math.degrees(limits.low)), "high": self._number(math.degrees(limits.high))}
        return self._word("cam pressure limit", phi=self._at(found.turned), **ends, **parts)

    def rolled(self) -> Iterator[str]:
        """Give how large the roller is, and by which rule."""
        found = self.found
        if found.roller:
            hollow = " in a groove" if found.cam.closure == "groove" and found.hollow is not None else ""
            key = f"cam roller{hollow} by {found.rule}" if found.cam.roller is None else "cam roller given"
            yield self._word(key, roller=self._mm(found.roller))

    def _shock(self, number: int) -> str:
        one, cam = self.found.shocks[number], self.found.cam
        key, place = ("cam hard shock", "cam soft shock")[one.order - 1], self._at(one.turned)
        if cam.speed is None:
            what = ("ψ" if cam.rocks else "S") + ("'", "''")[one.order - 1]
            return self._word(
                key, what=what, jump=self._number(one.jump, BARE[cam.rocks, cam.translates][one.order - 1]), phi=place
            )
        unit = ("rad" if cam.rocks else "m") + ("/s", "/s2")[one.order - 1]
        what = self._word(("cam velocity", "cam acceleration")[one.order - 1])
        return self._word(key, what=what, jump=self._number(one.jump * cam.speed**one.order, unit), phi=place)

    def _pressing(self) -> Iterator[str]:
        own = self.found.pressing
        if own is None:
            return
        least, most = (self._number(one.value, "N") for one in (own.least, own.most))
        yield self._word("cam pressing", least=least, most=most, phi=self._at(own.most.turned))
        if self.found.cam.follower.end != ROLLER:
            yield self._word("cam wear", wear=self._number(own.wear.value, "W"), phi=self._at(own.wear.turned))
        if own.least.value < 0:
            unit = "N*m" if self.found.cam.rocks else "N"
            yield self._word("cam preload", preload=self._number(own.preload, unit))

    def _flaw(self, one: Flaw) -> str:
        ends = {"start": self._at(one.start), "end": self._turn(one.end), "phi": self._at(one.worst.turned)}
        worst, key = one.worst.value, f"cam flaw {one.kind}"
        if one.kind == "crossing" and not math.isnan(worst):
            return self._word(
                f"cam flaw crossing and {'loss' if worst > 0 else 'no loss'}", worst=self._way(worst), **ends
            )
        if one.kind in ("undercut", "hollow") and abs(worst) < CORNER:
            return self._word(f"{key} corner", phi=ends["phi"])
        units = {"pressure": math.degrees(worst), "lift-off": worst, "crossing": 0.0}
        if one.kind in ("undercut", "hollow"):
            ends["most"] = self._number(MM * abs(worst))
        return self._word(key, worst=self._number(units.get(one.kind, MM * worst)), **ends)


def smoothed(law: Law) -> tuple[float, float]:
    """Give how far the analysis's curve of a table is from its points at the most, in shares, and at which."""
    shares, s = np.array(law.points, dtype=float).T
    off = np.abs(LAWS[law.name](law, shares, 0, False) - s)
    return float(off.max()), float(shares[off.round(9).argmax()])
