"""What the notes on a machine's motion must say by the analysis alone, sentence for sentence (пояснения)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.checks.dynamics.dynamics_expected import Expected
from drawings.checks.precise import precise
from drawings.page.drafting import Drafting
from plans.analytic.dynamics.flywheel import flywheel_of_points
from plans.analytic.dynamics.rim import wheel
from plans.model.dynamics import TURN, Cycle, Flywheel, Speeds, settled
from plans.model.flywheel_rim import THICKEST

ROUNDING = 1e-9  # of J0: so much of it is no share of the links
TWICE, HALF = 2.0, 0.5  # times the fluctuation that is asked for


class DueNotes(NamedTuple):
    """The notes: what the analysis finds, the exact inertia of the flywheel, the words and numbers of the sheet."""

    expected: Expected
    exact: Flywheel | None
    drafting: Drafting

    @property
    def exactly(self) -> DueNotes:
        """The same notes with all digits of their numbers."""
        return self._replace(drafting=precise(self.drafting))

    def all(self) -> Iterator[str]:
        """Give every sentence in its turn."""
        yield self._asked()
        yield self.work()
        wheel, cycle = self.expected.wheel, self.expected.cycle
        if self._stops:
            yield self._word("stops without flywheel")
        if wheel is not None and self.expected.task.delta:
            yield self._reason(wheel, cycle)
            yield self.missing(wheel)
            yield from self._others(wheel) if wheel.whole > wheel.own + wheel.present else ()
        if self.expected.account.speeds is not None:
            yield from self._achieved(self.expected.account.speeds)
        if wheel is not None:
            yield from self._rim(max(wheel.whole - wheel.own - wheel.present, 0.0))

    def _word(self, key: str, **numbers: float | str) -> str:
        told = {name: one if isinstance(one, str) else self.drafting.number(one) for name, one in numbers.items()}
        return self.drafting.word(key, **told)

    def _asked(self) -> str:
        task = self.expected.task
        speed = {"n": task.speed * 30 / math.pi, "omega": task.speed}
        if task.delta is None:
            return self._word("dynamics asked speed", **speed)
        return self._word("dynamics asked", **speed, delta=self._fluctuation(task.delta))

    def _fluctuation(self, delta: float) -> str:
        return f"1/{self.drafting.number(1 / delta)}"

    def work(self) -> str:
        """Tell what the loads take in a turn, and by what moment the drive gives it."""
        taken, driving = -self.expected.cycle.net, self.expected.cycle.driving
        if not taken:
            return self._word("no work of turn")
        return self._word("work of turn" if taken > 0 else "work given", work=abs(taken), moment=abs(driving))

    @property
    def _stops(self) -> bool:
        """Whether a machine of which no fluctuation is asked, and that no motor drives, comes to rest in a turn."""
        account, task = self.expected.account, self.expected.task
        if task.delta is not None or account.run is not None:
            return False
        return float(self.expected.cycle.inertia[0]) + task.present > 0 and not _turns(account.before)

    def _reason(self, wheel: Flywheel, cycle: Cycle) -> str:
        """Give from where to where the excess is taken, what divides it, and what the links have of it."""
        slow, fast = wheel.touches
        excess, task = fast.surplus - slow.surplus, self.expected.task
        told: dict[str, float | str] = {"fast": math.degrees(fast.turned), "slow": math.degrees(slow.turned)}
        told |= {"excess": excess, "most": _greatest(cycle, fast.turned, slow.turned), "whole": wheel.whole}
        share = excess / (task.speed**2 * (task.delta or 0.0))
        rest = wheel.whole - share
        if abs(rest) <= ROUNDING * wheel.whole:
            return self._word("why loads alone", **told)
        links = f"{'+' if rest > 0 else '−'} {self.drafting.number(abs(rest))}"
        return self._word("why loads" if 2 * share > wheel.whole else "why masses", **told, share=share, links=links)

    def missing(self, wheel: Flywheel) -> str:
        """Tell what there is of the inertia that is due, and what the flywheel must add."""
        there = wheel.own + wheel.present
        told = {"own": wheel.own, "present": wheel.present, "bare": there, "whole": wheel.whole}
        if wheel.whole > there:
            return self._word("flywheel adds", **told, inertia=wheel.whole - there)
        return self._word("heavy enough", **told, inertia=0.0)

    def _others(self, wheel: Flywheel) -> Iterator[str]:
        """Give what other fluctuations ask for, and how far the strips are off."""
        task, number = self.expected.task, self.drafting.number
        told: dict[str, float | str] = {}
        for name, inertia, times in (("twice", "more", TWICE), ("half", "less", HALF)):
            delta = times * (task.delta or 0.0)
            other = flywheel_of_points(self.expected.cycle, task._replace(delta=delta))
            told |= {name: self._fluctuation(delta), inertia: max(other.whole - wheel.own - wheel.present, 0.0)}
        yield self._word("other fluctuation", **told)
        exact = 0.0 if self.exact is None else max(self.exact.whole - self.exact.own - self.exact.present, 0.0)
        if exact:
            own = wheel.whole - wheel.own - wheel.present
            off = number(100 * float(settled(np.array([own - exact]), exact)[0]) / exact)
            yield self._word("error of strips", count=str(len(self.expected.cycle.turned) - 1), exact=exact, off=off)

    def _achieved(self, speeds: Speeds) -> Iterator[str]:
        low, high = float(speeds.omega.min()), float(speeds.omega.max())
        yield self._word("achieved motion", delta=2 * (high - low) / (high + low), low=low, high=high)
        wheel, before = self.expected.wheel, self.expected.account.before
        if wheel is not None and wheel.whole > wheel.own + wheel.present:
            own = f"δ = {self.drafting.number(before.delta)}" if _turns(before) and before else self._word("would stop")
            yield self._word("without flywheel", own=own)

    def _rim(self, inertia: float) -> Iterator[str]:
        """Give mass, sizes mm and speed m/s of the rim on its own shaft; of one that is too thick, what would do."""
        rim = self.expected.task.rim
        own = wheel(inertia, rim)
        if own is None:
            return
        if own.thickness > THICKEST * own.diameter:
            least = own.diameter * (own.thickness / (THICKEST * own.diameter)) ** 0.4
            yield self._word("rim too thick", diameter=1000 * own.diameter, least=1000 * least)
            return
        sizes = {name: 1000 * float(getattr(own, name)) for name in ("diameter", "breadth", "thickness")}
        speed = abs(self.expected.task.speed * rim.ratio) * own.diameter / 2
        added = 100 * (own.thickness / own.diameter) ** 2
        yield self._word("rim sizes", mass=own.mass, speed=speed, added=added, **sizes)


def _turns(speeds: Speeds | None) -> bool:
    """Tell whether a machine turns on."""
    return speeds is not None and all(map(math.isfinite, speeds.extremes))


def _greatest(cycle: Cycle, start: float, end: float) -> float:
    """Give the greatest moment of resistance N*m from an angle to another one, rad, on and over the turn's end."""
    middles = (cycle.turned[1:] + cycle.turned[:-1]) / 2
    within = (middles - start) % TURN <= (end - start) % TURN
    resisting = -np.minimum(cycle.moments.min(axis=1), cycle.means)
    return float(resisting[within].max()) if within.any() else 0.0
