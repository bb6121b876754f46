"""What is said of a machine's motion in words: task, works, why the flywheel is as big as it is, motion (пояснения)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from drawings.page.drafting import Drafting
from plans.model.account import Account
from plans.model.dynamics import TURN, Cycle, Flywheel, Task, settled
from plans.model.flywheel_rim import Wheel

RPM = 30 / math.pi  # of a rad/s
OTHERS = (2.0, 0.5)  # times the fluctuation that is asked for
PER_CENT = 3  # digits of a share
NOISE = 1e-9  # of J0: what of it is less is rounding, whose digits differ from machine to machine


class DynamicsNotes(NamedTuple):
    """The notes on a machine's motion by one road, with so many digits.

    `flywheel_at` gives the flywheel for another fluctuation; `exact` is J kg*m2 of the flywheel without the error of
    the strips.
    """

    task: Task
    account: Account
    flywheel_at: Callable[[float], Flywheel]
    drafting: Drafting
    rim: Wheel | None = None
    exact: float | None = None
    digits: int = 4

    @property
    def all(self) -> tuple[str, ...]:
        """What is asked, what the loads take, why the flywheel is so big, what else it could be, what it achieves."""
        return (
            *self.asked(),
            *self.works(),
            *self.stopping(),
            *self.reasons(),
            *self.other(),
            *self.achieved(),
            *self.sizes(),
        )

    def asked(self) -> Iterator[str]:
        """Say what is asked of the motion."""
        speed = {"n": self._number(self.task.speed * RPM), "omega": self._number(self.task.speed)}
        if self.task.delta is None:
            yield self.drafting.word("dynamics asked speed", **speed)
        else:
            yield self.drafting.word("dynamics asked", **speed, delta=self.fluctuation(self.task.delta))

    def works(self) -> Iterator[str]:
        """Say what the loads take in a turn, and by what moment the drive gives it."""
        cycle = self.account.cycle
        if cycle is None:
            return
        if not cycle.net:
            yield self.drafting.word("no work of turn")
        else:
            key = "work of turn" if cycle.net < 0 else "work given"
            numbers = (self._number(abs(value)) for value in (cycle.net, cycle.driving))
            yield self.drafting.word(key, **dict(zip(("work", "moment"), numbers, strict=True)))

    def stopping(self) -> Iterator[str]:
        """Say that the machine would stop without a flywheel where none is asked for."""
        if self.stops:
            yield self.drafting.word("stops without flywheel")

    @property
    def stops(self) -> bool:
        """Whether a machine that no flywheel is asked for would stop under a constant moment of the drive."""
        cycle, before = self.account.cycle, self.account.before
        if cycle is None or self.task.delta is not None or self.account.run is not None:
            return False
        massive = cycle.inertia[0] + self.task.present > 0  # else nothing is said of its energy
        return massive and (before is None or not all(map(math.isfinite, before.extremes)))

    def reasons(self) -> Iterator[str]:
        """Say why the flywheel is as big as it is: where the excess work is taken, what divides it, what is there."""
        wheel, cycle = self.account.flywheel, self.account.cycle
        if wheel is None or cycle is None or not self.task.delta:
            return
        low, high = wheel.touches
        excess = high.surplus - low.surplus
        share = excess / (self.task.speed**2 * self.task.delta)
        said = {"fast": self._angle(high.turned), "slow": self._angle(low.turned), "excess": self._number(excess)}
        said |= {"most": self._number(resisting(cycle, high.turned, low.turned)), "whole": self._number(wheel.whole)}
        if abs(wheel.whole - share) <= NOISE * wheel.whole:  # the links have one inertia at both angles
            yield self.drafting.word("why loads alone", **said)
        else:
            key = "why loads" if share > wheel.whole / 2 else "why masses"
            links = self._signed(wheel.whole - share)
            yield self.drafting.word(key, **said, share=self._number(share), links=links)
        yield from self.missing()

    def missing(self) -> Iterator[str]:
        """Say what of J0 is there, and what the flywheel must add."""
        wheel = self.account.flywheel
        if wheel is None:
            return
        numbers = {"own": wheel.own, "present": wheel.present, "bare": wheel.own + wheel.present, "whole": wheel.whole}
        told = {name: self._number(value) for name, value in numbers.items()}
        key = "flywheel adds" if wheel.needed > 0 else "heavy enough"
        yield self.drafting.word(key, **told, inertia=self._number(wheel.inertia))

    def other(self) -> Iterator[str]:
        """Say what flywheel twice and half the fluctuation would ask for, and what the strips leave out."""
        wheel, cycle = self.account.flywheel, self.account.cycle
        if wheel is None or cycle is None or not self.task.delta or wheel.needed <= 0:
            return
        deltas = [times * self.task.delta for times in OTHERS]
        more, less = (self._number(self.flywheel_at(delta).inertia) for delta in deltas)
        twice, half = map(self.fluctuation, deltas)
        yield self.drafting.word("other fluctuation", twice=twice, more=more, half=half, less=less)
        if self.exact:
            off = self.drafting.number(100 * self._less(wheel.inertia, self.exact) / self.exact, PER_CENT)
            said = {"count": len(cycle.means), "exact": self._number(self.exact), "off": off}
            yield self.drafting.word("error of strips", **said)

    def achieved(self) -> Iterator[str]:
        """Say how evenly the machine runs with the flywheel, and how it would run without."""
        speeds, before, wheel = self.account.speeds, self.account.before, self.account.flywheel
        if speeds is None:
            return
        low, high = map(self._number, speeds.extremes)
        yield self.drafting.word("achieved motion", delta=self._number(speeds.delta), low=low, high=high)
        if wheel is not None and wheel.needed > 0:
            stops = before is None or not all(map(math.isfinite, before.extremes))
            own = self.drafting.word("would stop") if stops or before is None else f"δ = {self._number(before.delta)}"
            yield self.drafting.word("without flywheel", own=own)

    def sizes(self) -> Iterator[str]:
        """Say the sizes of the rim; of one that is too thick, what would do."""
        rim, number = self.rim, self._number
        if rim is None:
            return
        if not rim.fits:
            yield self.drafting.word(
                "rim too thick", diameter=number(1000 * rim.diameter), least=number(1000 * rim.least_diameter)
            )
            return
        speed = number(rim.at_speed(self.task.speed * self.task.rim.ratio))
        section = {"breadth": number(1000 * rim.breadth), "thickness": number(1000 * rim.thickness)}
        added = self.drafting.number(100 * rim.added, PER_CENT)
        yield self.drafting.word(
            "rim sizes",
            mass=number(rim.mass),
            diameter=number(1000 * rim.diameter),
            **section,
            speed=speed,
            added=added,
        )

    def fluctuation(self, delta: float) -> str:
        """Write a coefficient of fluctuation as tables of permitted ones do."""
        return f"1/{self._number(1 / delta)}"

    def _less(self, one: float, other: float) -> float:
        """Subtract; nothing is left where that is but rounding."""
        return float(settled(np.array([one - other]), abs(other))[0])

    def _angle(self, turned: float) -> str:
        return self._number(math.degrees(turned))

    def _signed(self, value: float) -> str:
        return f"{'−' if value < 0 else '+'} {self._number(abs(value))}"

    def _number(self, value: float) -> str:
        return self.drafting.number(value, self.digits)


def resisting(cycle: Cycle, start: float, end: float) -> float:
    """Give the greatest moment of resistance N*m between two angles, rad, in the sense of rotation."""
    middles = (cycle.turned[1:] + cycle.turned[:-1]) / 2
    within = np.mod(middles - start, TURN) <= np.mod(end - start, TURN)
    rows = np.column_stack([cycle.moments, cycle.means])[within]
    return float(np.max(-rows, initial=-np.inf)) if rows.size else 0.0
