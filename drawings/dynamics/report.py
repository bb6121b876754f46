"""The motion of a machine in the report: task, reduction, works, flywheel, motion, other fluctuations (отчёт)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.dynamics import report_tables as tables
from drawings.dynamics.flywheel_sketch import on_its_shaft
from drawings.dynamics.given import RPM, given, train_given
from drawings.forces.report import masses_and_loads
from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, entry, listed, plain, see
from drawings.report.report import Report, chapter, header, row, tiny
from plans.dynamics.cycle import methods, rim_of
from plans.dynamics.form import DynamicsForm
from plans.dynamics.loop import loop
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.study import DynamicsStudy
from plans.forces.statics import Statics
from plans.gears.form import geared
from plans.model.dynamics import TURN, Cycle, Flywheel, Task, Wheel, settled
from plans.model.run import Account
from plans.study import Study
from plans.words.words import Message, message, word

OTHERS = (2.0, 0.5)  # times the fluctuation that is asked for
PER_CENT = 3  # digits of a share
NOTES_NOISE = 1e-9  # of J0: what of it is less is rounding, whose digits differ from machine to machine


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
    given: tuple[str, ...] = ()  # of motor, shafts and brake
    engine: bool = False  # whether loads drive the machine as they should

    @property
    def all(self) -> tuple[str, ...]:
        """What a sheet says: what is asked, what the loads take, why the flywheel is so big."""
        return (
            *(*self.asked(), *self.works(), *self.directed(), *self.stopping()),
            *(*self.reasons(), *self.bare(), *self.sizes()),
        )

    def asked(self) -> Iterator[str]:
        """Say what is asked of the motion."""
        speed = {"n": self._slot("n", self.task.speed * RPM), "omega": self._slot("ω_m", self.task.speed)}
        if self.task.delta is None:
            yield self.drafting.phrase("dynamics asked speed", **speed)
        else:
            yield self.drafting.phrase("dynamics asked", **speed, delta=self.fluctuation(self.task.delta))
        yield from self.given
        if self.account.run is not None and self.account.speeds is not None:
            yield self.drafting.word("constant moment here")

    def works(self) -> Iterator[str]:
        """Say what the loads take in a turn, and by what moment the drive gives it."""
        cycle = self.account.cycle
        if cycle is None:
            return
        if not cycle.net:
            yield self.drafting.word("no work of turn")
        else:
            key = "work given" if cycle.engine else "work of turn"
            moment = self._slot("M_dr", abs(cycle.driving))
            work, count = self._slot("A_us(2π)", abs(cycle.net)), len(cycle.means)
            yield self.drafting.phrase(key, count=count, work=work, moment=moment)

    def directed(self) -> Iterator[str]:
        """Say of loads that drive a machine which is no engine that one of them may have the wrong direction."""
        if self.account.cycle is not None and self.account.cycle.engine and not self.engine:
            yield self.drafting.word("loads drive")

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
        massive = cycle.own + self.task.present > 0  # else nothing is said of its energy
        return massive and (before is None or not all(map(math.isfinite, before.extremes)))

    def reasons(self) -> Iterator[str]:
        """Say why the flywheel is as big as it is: where the excess work is taken, what divides it, what is there."""
        wheel, cycle = self.account.flywheel, self.account.cycle
        if wheel is None or cycle is None or not self.task.delta:
            return
        low, high = wheel.touches
        excess = high.surplus - low.surplus
        share = excess / (self.task.speed**2 * self.task.delta)
        said: dict[str, object] = {
            "fast": self._slot("Δφ fastest", math.degrees(high.turned)),
            "slow": self._slot("Δφ slowest", math.degrees(low.turned)),
        }
        taken, reached = ("taken over loads", "falls") if cycle.engine else ("taken over drive", "rises")
        said |= {"taken": self.drafting.phrase(taken, excess=self._slot("A excess", excess))}
        said |= {"whole": self._slot("J_0", wheel.whole)}
        most = self._slot("M_us most", -cycle.way * resisting(cycle, high.turned, low.turned))
        said |= {"reached": self.drafting.phrase(f"moment {reached}", most=most)}
        if abs(wheel.whole - share) <= NOTES_NOISE * wheel.whole:  # the links have one inertia at both angles
            yield self.drafting.phrase("why loads alone", **said)
        else:
            key = "why loads" if share > wheel.whole / 2 else "why masses"
            links = self._signed("J_0 of links", wheel.whole - share)
            yield self.drafting.phrase(key, **said, share=self._slot("J_0 of loads", share), links=links)

    def missing(self) -> Iterator[str]:
        """Say what of J0 is there, and what the flywheel must add."""
        wheel = self.account.flywheel
        if wheel is None:
            return
        said = {"own": self._slot("J_0^* of links", wheel.own), "present": self._slot("J_0^* of shafts", wheel.present)}
        said |= {"bare": self._slot("J_0^*", wheel.own + wheel.present), "whole": self._slot("J_0", wheel.whole)}
        key = "flywheel adds" if wheel.needed > 0 else "heavy enough"
        yield self.drafting.phrase(key, **said, inertia=self._slot("J_fly", wheel.inertia))

    def other(self) -> Iterator[str]:
        """Say what flywheel twice and half the fluctuation would ask for, and what the strips leave out."""
        wheel, cycle = self.account.flywheel, self.account.cycle
        if wheel is None or cycle is None or not self.task.delta or not self.aided:
            return
        deltas = [times * self.task.delta for times in OTHERS]
        more, less = (self.flywheel_at(delta).inertia for delta in deltas)
        said = {"more": self._slot("J_fly at 2δ", more), "less": self._slot("J_fly at δ/2", less)}
        twice, half = (self.fluctuation(delta, of) for delta, of in zip(deltas, ("2δ", "δ/2"), strict=True))
        yield self.drafting.phrase("other fluctuation", **said, twice=twice, half=half)
        if self.exact:
            less = float(settled(np.array([wheel.inertia - self.exact]), abs(self.exact))[0])  # of rounding nothing
            off = Slot("J_fly off", 100 * less / self.exact, PER_CENT)
            exact = self._slot("J_fly exact", self.exact)
            yield self.drafting.phrase("error of strips", count=len(cycle.means), exact=exact, off=off)

    def achieved(self) -> Iterator[str]:
        """Say how evenly the machine runs with the flywheel, and how it would run without."""
        if (speeds := self.account.speeds) is not None:
            low, high = map(self._slot, ("ω_min", "ω_max"), speeds.extremes)
            yield self.drafting.phrase("achieved motion", delta=self._slot("δ", speeds.delta), low=low, high=high)
        yield from self.bare()

    def bare(self) -> Iterator[str]:
        """Say how the machine would run without the flywheel."""
        before = self.account.before
        if self.account.speeds is not None and self.aided:
            stops = before is None or not all(map(math.isfinite, before.extremes))
            if stops or before is None:
                yield self.drafting.phrase("without flywheel", own=self.drafting.word("would stop"))
            else:
                motion = joined("", ("δ = ", self.drafting.slot(self._slot("δ without flywheel", before.delta))))
                yield self.drafting.phrase("without flywheel", own=motion)

    @property
    def aided(self) -> bool:
        """Whether the machine has a flywheel, as it needs one."""
        return self.account.flywheel is not None and self.account.flywheel.needed > 0

    def sizes(self) -> Iterator[str]:
        """Say the sizes of the rim; of one that is too thick, what would do."""
        rim, slot, phrase = self.rim, self._slot, self.drafting.phrase
        if rim is None:
            return
        if not rim.fits:
            least = slot("rim D least", 1000 * rim.least_diameter)
            yield phrase("rim too thick", diameter=slot("rim D", 1000 * rim.diameter), least=least)
            return
        said = {"mass": slot("rim m", rim.mass), "diameter": slot("rim D", 1000 * rim.diameter)}
        said |= {"breadth": slot("rim b", 1000 * rim.breadth), "thickness": slot("rim t", 1000 * rim.thickness)}
        said |= {"speed": slot("rim v", rim.at_speed(self.task.speed * self.task.rim.ratio))}
        yield phrase("rim sizes", **said, added=Slot("rim added", 100 * rim.added, PER_CENT))
        if self.task.rim.diameter is None:
            yield self.drafting.word("rim chosen")

    def fluctuation(self, delta: float, of: str = "δ") -> Phrase:
        """Write a coefficient of fluctuation as tables of permitted ones do."""
        return joined("", ("1/", self.drafting.slot(self._slot(f"1/{of}", 1 / delta))))

    def _signed(self, quantity: str, value: float) -> Phrase:
        """Write a number after its sign, which is a part of what it is called."""
        sign = "−" if value < 0 else "+"
        return joined(" ", (sign, self.drafting.slot(self._slot(f"{quantity} {sign}", abs(value)))))

    def _slot(self, quantity: str, value: float) -> Slot:
        return Slot(quantity, value, self.digits)


def resisting(cycle: Cycle, start: float, end: float) -> float:
    """Give the greatest moment of resistance N*m between two angles, rad, in the sense of rotation."""
    middles = (cycle.turned[1:] + cycle.turned[:-1]) / 2
    within = np.mod(middles - start, TURN) <= np.mod(end - start, TURN)
    rows = np.column_stack([cycle.moments, cycle.means])[within]
    return float(np.max(-rows, initial=-np.inf)) if rows.size else 0.0


EVEN = 5e-3  # of the fluctuation that is asked for: the share by which that of strips may be out
NOISE = 1e-9  # per cent: a smaller difference is rounding, whose digits differ from machine to machine


def headline(study: Study) -> str:
    """Say what flywheel the machine needs."""
    notes = notes_of(study, digits=5)
    return "; ".join(map(plain, (*notes.works(), *notes.directed(), *notes.missing())))


def remarks(study: Study) -> list[Message]:
    """Say that the machine would stop, or where a run ends before its time; gaps are told with the positions."""
    found = study.of(DynamicsComparison).construction.run
    if found is not None and found.failure is not None:
        return [found.failure.message]
    return [message("dynamics.stops")] if notes_of(study).stops else []


def notes_of(study: Study, digits: int = 4) -> DynamicsNotes:
    """Give the notes on what the construction finds, with the exact flywheel beside it."""
    dynamics, comparison = study.of(DynamicsStudy), study.of(DynamicsComparison)
    account, exact = comparison.construction, comparison.exact.flywheel
    rim = rim_of(account.flywheel.inertia, dynamics.task.rim) if account.flywheel is not None else None
    true = exact.inertia if exact is not None else None
    flywheel_at = partial(_flywheel, account.cycle, dynamics.task)
    form, drafting = study.scene.of(DynamicsForm).dynamics, drafting_of(study.scene)
    driving = account.cycle.driving if account.cycle is not None else 0.0
    train = tuple(train_given(study, driving, drafting)) if geared(study.scene) else ()
    told = tuple(given(form, dynamics.task, drafting, train))
    engine = form.motor is None and not all(load.useful for load in study.of(Statics).machine.loads)
    return DynamicsNotes(dynamics.task, account, flywheel_at, drafting, rim, true, digits, told, engine)


def _flywheel(cycle: Cycle | None, task: Task, delta: float) -> Flywheel:
    """Give the flywheel of another fluctuation by the same loop."""
    assert cycle is not None  # of a machine without one no other fluctuation is told
    return loop(cycle, task._replace(delta=delta)).flywheel


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the motion of a machine, and its masses and loads where no chapter of forces does."""
    language, notes, statics = study.scene.sheet.language, notes_of(study, DIGITS), study.of(Statics)
    told = [] if "forces" in study.techniques else masses_and_loads(statics, language)
    way = "clockwise" if statics.study.mechanism.drive.omega < 0 else "counter-clockwise"
    turns = word(language, "report.crank_turns", way=message(f"way.{way}"))
    account: Account = study.of(DynamicsComparison).construction
    return Chapters(
        subject=[*told, *listed(chapter(language, "dynamics"), notes.asked()), turns],
        values=[
            *_reduction(account, notes),
            *_works(account, notes),
            *see(leaves, language, "moments", "works", "surplus", "speeds"),
            *_wheel(study, notes),
            *see(leaves, language, "inertia", "loop", "flywheel_sketch"),
            *listed(chapter(language, "motion" if notes.aided else "motion_unaided"), notes.achieved()),
            *_run(study, notes),
            *see(leaves, language, "tachogram", "run"),
        ],
        left_out=[word(language, f"report.{'motor' if account.run is not None else 'dynamics'}_left_out")],
    )


def _reduction(account: Account, notes: DynamicsNotes) -> Iterator[str]:
    yield chapter(notes.drafting.language, "reduction")
    yield from tables.reduction(account.reduced, notes.drafting)


def _works(account: Account, notes: DynamicsNotes) -> Iterator[str]:
    if account.cycle is not None:
        told = *notes.works(), *notes.directed(), *notes.stopping()
        yield from listed(chapter(notes.drafting.language, "works"), told)
        yield ""
        yield from tables.works(account.cycle, account.speeds, notes.task.divisions, notes.drafting)


def _wheel(study: Study, notes: DynamicsNotes) -> Iterator[str]:
    """Tell the tangents, the flywheel by every method, and what other fluctuations ask for."""
    wheel, language, drafting = notes.account.flywheel, notes.drafting.language, notes.drafting
    if wheel is None:
        return
    exact, further = study.of(DynamicsComparison).exact.flywheel, on_its_shaft(notes.rim, drafting) if notes.rim else ()
    yield from listed(
        chapter(language, "flywheel"), [*notes.reasons(), *notes.missing(), *notes.other(), *notes.sizes(), *further]
    )
    yield ""
    yield from tables.tangents(wheel, exact, drafting)
    yield ""
    yield from _methods(notes, wheel, exact)
    yield chapter(language, "other_fluctuations")
    yield from tables.others(notes.task, notes.flywheel_at, notes.fluctuation, drafting)


def _methods(notes: DynamicsNotes, wheel: Flywheel, exact: Flywheel | None) -> Iterator[str]:
    """Tell J0 by Wittenbauer, Mertsalov, Gutyar and the book's formula, and how far each is off the first."""
    language, drafting = notes.drafting.language, notes.drafting
    assert notes.account.cycle is not None  # there is a flywheel
    found = methods(notes.account.cycle, notes.task)
    if found is None or not wheel.whole:
        return
    yield from header([word(language, f"table.{head}") for head in ("method", "whole", "off_loop")])
    values = {"loop": wheel.whole, "mertsalov": found.mertsalov, "gutyar": found.gutyar, "book": found.book}
    if exact is not None:
        values["exact"] = exact.whole
    for name, whole in values.items():
        share = 100 * (whole / wheel.whole - 1)
        off = "—" if abs(share) < NOISE else tiny(share, language)
        yield row([word(language, f"report.method_{name}"), drafting.number(whole, DIGITS), off])
    yield f"\n{word(language, 'report.energy', energy=drafting.number(wheel.energy, DIGITS))}"


def _concluded(study: Study) -> Iterator[str]:
    """Say what flywheel the machine needs, and how even it runs with it for what was asked."""
    notes = notes_of(study, DIGITS)
    task, speeds, language = notes.task, notes.account.speeds, notes.drafting.language
    yield from map(entry, (*notes.works(), *notes.directed(), *notes.missing()))
    if task.delta and speeds is not None:
        key = "report.even_enough" if speeds.delta <= task.delta * (1 + EVEN) else "report.uneven"
        text = notes.drafting.number(speeds.delta, DIGITS)
        machine = word(language, f"report.{'with' if notes.aided else 'without'}_flywheel")
        yield word(language, key, machine=machine, delta=text, asked=notes.fluctuation(task.delta))


def _run(study: Study, notes: DynamicsNotes) -> Iterator[str]:
    """Tell the run from rest by the table and by the solver, of a machine with a motor."""
    comparison, language = study.of(DynamicsComparison), notes.drafting.language
    pairs = {"report.by_table": comparison.construction.run, "report.by_solver": comparison.exact.run}
    runs = {name: run for name, run in pairs.items() if run is not None}
    if runs:
        yield from listed(chapter(language, "run"), tables.run_lines(runs, notes.drafting))
        yield ""
        yield from tables.stages(runs, notes.drafting)


REPORT = Report(chapters, headline, remarks, conclusion=_concluded)
