"""What acts in one position by the analysis: forces, arms, letters; loads over their strokes (действующие силы)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from string import ascii_lowercase
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import Expected, measured
from drawings.lettering.words import letter, with_index
from drawings.paper.strokes import Kind
from drawings.symbols.figure import plain_name
from plans.forces.bill import ActingForce, ForceBill, LoadedPosition
from plans.forces.cut import CutGroup, MomentEquation
from plans.forces.loading import OutputStroke, asks
from plans.forces.quantities import ForceComparison
from plans.forces.statics import Statics
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING, Force, Moment, Track
from plans.model.motion import NOTHING, POSITIONS, VELOCITIES, Floats
from plans.quantity import Quantity

REACTION = re.compile(r"R(?=(\^.)?_\d+(,\d+)?$)")
EPS = float(np.finfo(np.float64).eps)
ABOUT = 30.0  # times more or less: whether such a force or moment is none is decided by rounding
CENTRE = re.compile(r"S\d*'*")  # a mass centre by its letter: no arm ends there


class ExpectedArm(NamedTuple):
    """An arm in an equation of moments: its letter, the force and the point, the foot on the line of action, m."""

    letter: str
    force: ActingForce
    about: str
    pivot: complex
    moment: float
    line: str = ""  # how it is lettered where it is the line between two points

    @property
    def foot(self) -> complex:
        """The foot of the perpendicular on the line of action."""
        way = self.force.value / abs(self.force.value)
        return self.force.at + way * ((self.pivot - self.force.at) * way.conjugate()).real

    @property
    def length(self) -> float:
        """How long it is, m."""
        return abs(self.moment / self.force.value)


@dataclass(frozen=True)
class ExpectedForces:
    """All that acts on the links in one position."""

    statics: Statics
    comparison: ForceComparison
    k: int

    @cached_property
    def position(self) -> LoadedPosition:
        """The machine in the position."""
        study, solved, machine = self.statics.study, self.comparison.motion.analysis, self.statics.machine
        loads, forces = self.statics.loading(solved), self.comparison.analysis
        return LoadedPosition(study.mechanism, machine, study.groups, solved, loads, forces, self.k)

    @cached_property
    def bills(self) -> dict[str, ForceBill]:
        """What acts on each group, and on the primary link, by their links."""
        bills = (ForceBill(self.position, group) for group in (*self.position.groups, None))
        return {"-".join(map(str, bill.links)): bill for bill in bills}

    @cached_property
    def slack(self) -> float:
        """What the two roads may differ by in a force, N."""
        bounds = (float(force.allowed[self.k]) for force in self.comparison.of("forces") if force.unit == "N")
        return 2 * max(bounds, default=0.0)

    @cached_property
    def none(self) -> tuple[float, float]:
        """The force N and the moment N*m below which there may be none."""
        found = self.comparison.analysis
        force, moment = found.nothing_at(self.k)
        sizes = [abs(force.value) for bill in self.bills.values() for force in bill.forces.values()]
        force = self.slack + max(force, NOTHING * max(sizes, default=0.0))
        return force, force * found.size + moment

    @cached_property
    def off(self) -> float:
        """What the two roads may differ by in a place, m."""
        return self._off(POSITIONS.plan)

    @cached_property
    def fast(self) -> float:
        """What the two roads may differ by in a velocity, m/s."""
        return self._off(VELOCITIES.plan)

    def _off(self, plan: str) -> float:
        found = self.comparison.motion.of(plan)
        return 2 * max(float(np.broadcast_to(point.allowed, point.analysis.shape)[self.k]) for point in found)

    def letter(self, name: str) -> str:
        """Write a force or a moment as a sheet does: R^t_34, or M^Φ_4/BD."""
        return lettered(self.statics, name)

    def name(self, name: str) -> str:
        """Name a force or a moment by its letter, without braces."""
        return plain_name(self.letter(name))

    @cached_property
    def arms(self) -> dict[str, tuple[ExpectedArm, ...]]:
        """The arms of each cut, numbered through all of them; forces on one line of action have one."""
        found, start = dict[str, tuple[ExpectedArm, ...]](), 0
        for cut in self.statics.drafts().plans.plan.cuts:
            found[cut.label] = tuple(self._arms(cut, start))
            start += len({arm.letter for arm in found[cut.label] if arm.letter.startswith("h")})
        return found

    def _arms(self, cut: CutGroup, start: int) -> Iterator[ExpectedArm]:
        bill, known = self.bills[cut.label], list[ExpectedArm]()
        share = 1 / ABOUT if self.doubtful else 1.0  # all that rounding may have an arm for
        for equation in cut.equations:
            for force in self._forces(bill, equation):
                pivot = self.position.place(equation.about.name)
                run = force.at - pivot
                arm = ExpectedArm("", force, equation.about.name, pivot, (run.conjugate() * force.value).imag)
                least = share * NOTHING * abs(run * force.value)
                if abs(force.value) > share * self._least and abs(arm.moment) > least:
                    arm = arm._replace(line=self._line(equation, arm))
                    known.append(arm._replace(letter=self._lettered(arm, known, start)))
        yield from known

    def lettered_arms(self, label: str) -> Iterator[ExpectedArm]:
        """Give the arms of a cut; where rounding decides how they are lettered, with each letter that they may bear."""
        count = sum(map(len, self.arms.values())) if self.doubtful else 0
        for arm in self.arms[label]:
            yield arm
            others = (*(f"h_{{{number}}}" for number in range(1, count + 1)), *([arm.line] if arm.line else []))
            yield from (arm._replace(letter=other) for other in others if self.doubtful)

    @cached_property
    def _least(self) -> float:
        bills = self.bills.values()
        known = (force for bill in bills for force in (*bill.known, *(bearing.whole for bearing in bill.bearings)))
        return NOTHING * max((abs(force.value) for force in known), default=0.0)

    def _forces(self, bill: ForceBill, equation: MomentEquation) -> Iterator[ActingForce]:
        """Give the forces of an equation, the one that it finds last."""
        names = [load.name for load in equation.loads] + ([] if equation.line is None else [equation.found.name])
        return (bill.forces[name] for name in names)

    def _line(self, equation: MomentEquation, arm: ExpectedArm) -> str:
        """Letter an arm as the line to a point where its force acts, named as the lead there is; or not at all."""
        places, k = self.comparison.motion.analysis.points, self.k
        points = (arm.force.point, *self.statics.study.mechanism.links[arm.force.link].points)
        spots = (point for point in points if point in places and not CENTRE.fullmatch(point))
        near = NOTHING * abs(arm.force.at - arm.pivot)
        spot = next((point for point in spots if abs(places[point].r[k] - arm.force.at) <= near), "")
        ends, leads = arm.about + spot, () if equation.line is None else equation.line.step.inputs[1:]
        name = next((lead.name for lead in leads if sorted(lead.name) == sorted(ends)), ends)
        return f"l_{{{name}}}" if spot else ""

    def _lettered(self, arm: ExpectedArm, known: list[ExpectedArm], start: int) -> str:
        """Letter an arm: as the line between two points where it is one; or number it."""
        run, way = arm.force.at - arm.pivot, arm.force.value / abs(arm.force.value)
        near = NOTHING * abs(run)
        if arm.line and abs((run * way.conjugate()).real) <= near:
            return arm.line
        numbered = [other for other in known if other.letter.startswith("h")]
        same = (other.letter for other in numbered if other.about == arm.about and abs(other.foot - arm.foot) <= near)
        return next(same, f"h_{{{start + len({other.letter for other in numbered}) + 1}}}")

    @cached_property
    def doubtful(self) -> bool:
        """Whether rounding may decide which forces have arms, so how these are numbered."""
        cuts = self.statics.drafts().plans.plan.cuts
        turned = ABOUT * EPS / NOTHING * self._least / NOTHING  # the direction of a smaller force is rounding
        return any(
            _near(abs(force.value), self._least)
            or self._least < abs(force.value) < turned
            or _near(abs((run.conjugate() * force.value).imag), NOTHING * abs(run * force.value))
            for cut in cuts
            for equation in cut.equations
            for force in self._forces(self.bills[cut.label], equation)
            for run in (force.at - self.position.place(equation.about.name),)
        )


def _near(size: float, least: float) -> bool:
    """Tell whether a size is about the least that counts."""
    return least / ABOUT < size < least * ABOUT


def lettered(statics: Statics, name: str) -> str:
    """Write a force or a moment as the sheets of a scene do."""
    head, slash, line = name.partition("/")
    head = REACTION.sub(statics.form.sheet.reactions, head)
    return letter(statics.study.language, with_index(head)) + slash + line


def named(statics: Statics, comparison: ForceComparison) -> Iterator[tuple[str, Quantity]]:
    """Give the findings of forces that the table tells, each with what its row is lettered: R_34, M_bal."""
    every = (found for found in comparison.of("forces") if " " not in found.name)
    yield from ((lettered(statics, found.name), found) for found in every)


FIGURE = "load_diagram"
KNOWN = 1e-7  # of a stroke: where it ends is known to half the digits of an angle
FEW = 12  # corners that are lettered a, b, c; of more the layout chooses
STRAIGHT = 1e-3  # of two slopes: a bend that is less is none
SHORT = 2e-3  # of the greatest load: on paper a point
PIECES = 500  # of a line: corners that are lines apart are no arc
DOUBT = 4.0  # times more or less: rounding of a table decides whether it is one


class Branch(NamedTuple):
    """A load, or its pressure on a piston MPa, on the way there or back: corners by shares of the stroke, rising."""

    back: bool
    shares: Floats
    sizes: Floats

    @property
    def bends(self) -> Floats:
        """How far each corner is from going straight on, as a share of both slopes; an end is one."""
        slopes = np.diff(self.sizes) / np.diff(self.shares)
        both = np.maximum(np.abs(slopes[1:]) + np.abs(slopes[:-1]), np.finfo(float).tiny)
        return np.concatenate(([1.0], np.abs(np.diff(slopes)) / both, [1.0]))


def branches(load: Force | Moment) -> Iterator[Branch]:
    """Give the load over its stroke there, and over that back; it may rest on one of them."""
    law = load.diagram if isinstance(load, Force) else None
    begin, end = load.overrun[0], 1 - load.overrun[1]
    shares = np.array(sorted({begin, end, *(share for share in (law.travel if law else ()) if begin < share < end)}))
    turns = load.against if isinstance(load, Moment) else load.resists or (load.direction is None and load.line is None)
    for during, sense in (((WORKING, FORWARD), 1.0), ((IDLE, BACKWARD), -1.0 if turns else 1.0)):
        if load.during in (ALWAYS, *during):
            back = IDLE in during
            sizes = (law.back or law.sizes if back else law.sizes) if law else ()
            found = np.interp(shares, law.travel, sizes) if law else np.ones(len(shares))
            force = sense * load.size * found
            card = load.card if isinstance(load, Force) else None
            yield Branch(back, shares, force if card is None else (force + card.behind) / (1e6 * card.area))


def diagrams(loads: Iterable[Force | Moment], strokes: Mapping[Track, OutputStroke]) -> Iterator[Expected]:
    """Give what the diagram of each load that changes over a stroke must show."""
    for load in loads:
        if asks(load):
            yield from _diagram(load, strokes[load.stroke])


def _diagram(load: Force | Moment, stroke: OutputStroke) -> Iterator[Expected]:
    figure, reach = f"{FIGURE}-{load.name}", abs(stroke.reach[1] - stroke.reach[0])
    length, whole = (reach, "H") if stroke.sliding else (math.degrees(reach), "ψ")
    written = 1000 * length if stroke.sliding else length
    row = Expected(Kind.VECTOR, figure, whole, complex(length), KNOWN * length)
    yield from measured(row, written, digits=4, unit=1000.0 if stroke.sliding else 1.0)
    for k, share in enumerate(load.overrun, 1):
        if share:
            yield Expected(Kind.VECTOR, figure, f"overrun_{k}", complex(share * length), KNOWN * length)
            yield Expected(Kind.PHRASE, figure, f"overrun_{k}", share, digits=4)
    for branch in branches(load):
        path = branch.shares * length + 1j * branch.sizes
        begin = [0j, complex(path[0].real)] if load.overrun[0] else []  # it jumps up and down at the overruns
        end = [complex(path[-1].real), complex(length)] if load.overrun[1] else []
        way = np.concatenate((begin, path, end))
        places = np.linspace(0, len(way) - 1, PIECES * (len(way) - 1) + 1)
        way = np.asarray(np.interp(places, np.arange(len(way)), way), dtype=np.complex128)
        yield Expected(Kind.CURVE, figure, "back" if branch.back else "out", way, KNOWN * length)
    yield from _corners(figure, load)


def _corners(figure: str, load: Force | Moment) -> Iterator[Expected]:
    """Give the ordinates of the corners that are not zero, lettered in the order of the motion."""
    found: dict[tuple[float, float], float] = {}
    for branch in branches(load):
        rows = zip(branch.shares.tolist(), branch.sizes.tolist(), branch.bends.tolist(), strict=True)
        for share, size, bend in reversed([*rows]) if branch.back else rows:
            if size and bend > STRAIGHT / DOUBT:
                found.setdefault((share, size), bend)
    doubtful = any(bend < STRAIGHT * DOUBT for bend in found.values())
    most = max((abs(size) for _, size in found), default=0.0)
    many = doubtful or len(found) > FEW
    for name, (_, size) in zip(ascii_lowercase, found, strict=False):
        allowed, short = math.inf if many else KNOWN * most, not abs(size) > SHORT * most
        yield Expected(Kind.VECTOR, figure, name, 1j * size, allowed, may_lack=many or short)
