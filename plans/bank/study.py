"""The study of a bank: harmonics, polygons and compensators, each made once (взаимоуравновешивание)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

import numpy as np

from geometry.board import Board
from geometry.errors import ConstructionError
from geometry.precision import errors
from plans.balance.mass_centre import Drawing, MainPoints
from plans.balance.shares import drawing, turns
from plans.balance.study import BalanceStudy
from plans.balance.weights import tree_of
from plans.bank.harmonics import COMPENSATORS, HARMONICS, Harmonics, NotSettled, Shaker, Shaking, SliderCrank, harmonics
from plans.bank.polygons import CompensatorMasses, Polygons, compensators, left_over, polygons
from plans.bank.reading import BankSurvey
from plans.forces.statics import Statics
from plans.linkage.drafts import Drafts
from plans.linkage.primary import even
from plans.linkage.study import LinkageStudy, obstruction
from plans.model.balance.bank import CONSTRUCTION, EPS, ROUNDING, STEPS, BankBalance, BankTask, Member
from plans.model.balance.linkage import NONE
from plans.model.motion import Complexes, Floats, Rates
from plans.rotor.balancing import heading
from plans.study import Study
from plans.words.words import message, placed

LOOKS = 72  # positions of a turn over which the size of the forces is taken


class NoTurn(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """A bank is asked of a linkage whose crank does not turn fully."""


class Linkage:
    """A linkage whose crank turns evenly at an angular speed rad/s, with its masses or those after balancing."""

    def __init__(self, study: LinkageStudy, points: MainPoints, speed: float) -> None:
        self.study, self.points, self.speed = study, points, speed

    @cached_property
    def scale(self) -> float:
        """The largest sum of the sizes of all inertia forces, N."""
        sides = self._drawing(Fraction(0), LOOKS).shaking.sides
        sizes = sum((np.abs(np.asarray(side.vector.point)) for side in sides), start=np.zeros(1))
        return float(np.max(sizes))

    def shaking(self, start: Fraction, count: int) -> Shaking:
        """Draw the linkage over a turn, its velocities and accelerations, and its main-point vectors."""
        force = self._drawing(start, count).force
        slack = np.broadcast_to(errors(force)[force].place, count)
        return Shaking(np.array(np.broadcast_to(force.point, count)), slack)

    def _drawing(self, start: Fraction, count: int) -> Drawing:
        turn = even(start, count, +1).paced(lambda _: Rates(self.speed, 0.0))
        return drawing(self.points, Drafts(self.study, turn))


def linkage_of(study: Study, speed: float) -> Linkage:
    """Take the scene's linkage, with its counterweights where the scene asks for them, for one mechanism of a bank."""
    linkage = study.of(LinkageStudy)
    if not turns(linkage):
        line, _ = study.scene.place(("bank",))
        raise NoTurn(placed(f"{study.scene.file}:{line}", message("bank.no_turn", why=obstruction(linkage.sweep))))
    if study.scene.has(("balance",)):
        balance = study.of(BalanceStudy)
        return Linkage(linkage, balance.points(after=balance.task.aim != NONE), speed)
    statics = study.of(Statics)
    return Linkage(linkage, MainPoints(tree_of(linkage.mechanism), statics.machine.bodies), speed)


class Whole(NamedTuple):
    """Force N and moment N*m of the bank over STEPS + 1 even positions of a turn, and how far each can be out."""

    phi: Floats  # (STEPS + 1,) rad
    force: Complexes
    moment: Complexes
    force_slack: float
    moment_slack: float
    largest: float  # N: of one mechanism
    largest_moment: float  # N*m: of one mechanism


def whole(source: Shaker, members: Sequence[Member]) -> Whole:
    """Add the forces of all mechanisms, and their moments about the plane of place 0."""
    found = {phase: source.shaking(phase, STEPS) for phase in {member.phase % 360 for member in members}}
    shares = [found[member.phase % 360] for member in members]
    force = [heading(member.axis) * share.force for member, share in zip(members, shares, strict=True)]
    places = [float(member.place) for member in members]
    moment = [place * each for place, each in zip(places, force, strict=True)]
    slacks = [_slack(source, share) for share in shares]
    lever = sum(abs(place) * slack for place, slack in zip(places, slacks, strict=True))
    phi = 2 * np.pi * np.arange(STEPS + 1) / STEPS
    largest = [float(np.max(np.abs(rows))) for rows in (force, moment)]
    return Whole(phi, _round(force), _round(moment), sum(slacks), lever, *largest)


def _slack(source: Shaker, share: Shaking) -> float:
    """Give how far one mechanism's force can be out anywhere, with the roundings of a sum."""
    largest = max(source.scale, float(np.max(np.abs(share.force))))
    return float(np.max(share.slack)) + ROUNDING * EPS * largest


def _round(terms: Sequence[Complexes]) -> Complexes:
    """Add the terms and close the turn."""
    total = np.sum(terms, axis=0)
    return np.concatenate([total, total[:1]])


class BankStudy:
    """A bank, by construction; nothing is made before it is asked for."""

    def __init__(self, task: BankTask, source: Shaker, place: str = "") -> None:
        self.task, self.source = task, source
        self.place = place  # of the bank in the scene's file
        self.made: dict[str, None] = {}  # what was made, in order

    def construct(self, plans: Collection[str]) -> None:
        """Draw what is asked for."""
        _ = self.drawing
        if COMPENSATORS in plans:
            _ = self.weights

    @cached_property
    def single(self) -> Harmonics:
        """The harmonics of one mechanism."""
        try:
            return harmonics(self.source, self.orders)
        except NotSettled as error:
            raise NotSettled(placed(self.place, error.args[0]) if self.place else error.args[0]) from None

    @property
    def orders(self) -> tuple[int, ...]:
        """The orders that are told, with those that compensators are asked of."""
        return orders_of(self.task)

    @cached_property
    def drawing(self) -> Polygons:
        """The polygons of the bank's forces and moments."""
        self.made.setdefault(HARMONICS)
        return polygons(self.single, self.task.members)

    @cached_property
    def whole(self) -> Whole:
        """The whole force and moment over a turn."""
        return whole(self.source, self.task.members)

    @cached_property
    def weights(self) -> tuple[CompensatorMasses, ...]:
        """The masses of the compensators."""
        return self._read[1]

    @cached_property
    def _read(self) -> tuple[Board, tuple[CompensatorMasses, ...]]:
        self.made.setdefault(COMPENSATORS)
        return compensators(self.task, self.drawing)

    @property
    def boards(self) -> tuple[Board, ...]:
        """All boards in the order of drawing."""
        return self.single.board, self.drawing.moment_board, self._read[0]

    @cached_property
    def balance(self) -> BankBalance:
        """The bank as it is told."""
        found, drawing, orders = self.whole, self.drawing, self.orders
        return BankBalance(
            by=CONSTRUCTION,
            task=self.task,
            single={order: self.single.harmonic(order) for order in orders},
            forces={order: drawing.force(order) for order in orders},
            moments={order: drawing.moment(order) for order in orders},
            compensators=tuple(weight.stated for weight in self.weights),
            phi=found.phi,
            force=found.force,
            left=left_over(found.force, self.weights, found.phi, self.task.speed),
            moment=found.moment,
            force_slack=found.force_slack,
            moment_slack=found.moment_slack,
        )


def orders_of(task: BankTask) -> tuple[int, ...]:
    """Give the orders that are told, with those that compensators are asked of."""
    return tuple(dict.fromkeys((*task.orders, *(asked.order for asked in task.asked))))


def study_of(study: Study) -> BankStudy:
    """Make the study of a scene's bank."""
    task: BankTask = study.scene.meaning.of(BankSurvey).task
    unit, speed = task.unit, task.speed
    line, _ = study.scene.place(("bank",))
    source = linkage_of(study, speed) if unit is None else SliderCrank(unit, speed)
    return BankStudy(task, source, f"{study.scene.file}:{line}")
