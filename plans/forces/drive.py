"""What the drive must give: the primary link under its forces, and the force of a cylinder (начальное звено; 6.4.5).

A cylinder acts between itself and its rod along the line of their hinges; the crank then needs no moment of its own:
its power is that of all other forces (усилие гидроцилиндра).
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Mark
from plans.forces import polygon as statics
from plans.forces.cut import CLOSING, PART, CutGroup, ForcePlan, Load, MomentEquation, PolygonSide, indices
from plans.forces.loading import carried
from plans.linkage import leads
from plans.linkage.ram import apart
from plans.model.kinetostatics import Applied, Effort, Kinetostatics, Loading, Reaction
from plans.model.machine import FORCE, GEAR, Body, Machine, Transmission
from plans.model.mechanism import FRAME, Drive, Mechanism, Slide
from plans.model.motion import Complexes, Floats, Motion
from plans.words.words import because

DRIVING, BALANCING = "P_bal", "M_bal"
NOTHING = because("no_moment")


class BalancingQuantity(NamedTuple):
    """What the drive is told to give: its letters, its unit, and how much of it a balancing moment of 1 N*m is."""

    name: str
    unit: str
    share: float = 1.0


def balancing_quantity(drive: Drive) -> BalancingQuantity:
    """Give what is told of a drive: the moment on the shaft of a crank, the force of a slide or of a cylinder."""
    by_force = drive.pushed or drive.ram is not None
    return BalancingQuantity(DRIVING, "N", 1.0 / drive.unit) if by_force else BalancingQuantity(BALANCING, "N*m")


def primary(plan: ForcePlan) -> CutGroup:
    """Balance the primary link, and close its polygon in the frame: a crank by moments, a slide along its guide."""
    slide = plan.mechanism.drive.guide
    return _turned(plan) if slide is None else _pushed(plan, slide)


def _pushed(plan: ForcePlan, slide: Slide) -> CutGroup:
    """Close the polygon of a slide along its guide and square to it; no moment is needed for what pushes it."""
    drive, board = plan.mechanism.drive, plan.board
    (loads, couples), along = plan.acting(drive.link), leads.direction(plan.positions, slide, FRAME)
    chain = statics.chain(plan, str(drive.link), *statics.known_sides(loads))
    lead = statics.direction_on(plan, along)
    pushed = board.parallel(f"∥{lead.name}", chain.start, lead, because("pushed_along"))
    lines = pushed, board.square(f"⊥{lead.name}", chain.end, lead, because("guide_presses"))
    name = f"R_{indices(FRAME, drive.link)}"
    closed = statics.close(plan, chain, (DRIVING, name), lines)
    plan.driven = _foot(plan, slide, along)
    plan.drive = board.join(DRIVING, closed.corner, chain.start, because("closing"))
    plan.shaft = _wheel(plan, along, plan.driven)
    plan.balancing = board.moment(BALANCING, plan.shaft, plan.driven, plan.drive, because("wheel_moment"))
    force = board.join(name, chain.end, closed.corner, because("closing"))
    pushing = Load(DRIVING, drive.link, plan.driven, plan.drive, PART)
    support = statics.support(plan, (FRAME, drive.link), slide, force, (), [*loads, pushing], couples)
    return CutGroup(None, (drive.link,), tuple(loads), tuple(couples), (support,), (), (), closed.polygon)


def _foot(plan: ForcePlan, slide: Slide, along: Mark) -> Mark:
    """Give where a slide is pushed: its named point, or the foot of that on the guide's line."""
    point, board = plan.positions.point(slide.point), plan.positions.board
    left = leads.offset(plan.positions, slide, slide.slider, slide.point)
    if not left:
        return point
    back = board.turn(f"h{slide.slider}'", along, -1j * left, because("offset"))
    return board.lay_off(f"{slide.point}''", point, back, because("pushed_along"))


def _wheel(plan: ForcePlan, along: Mark, end: Mark) -> Mark:
    """Mark the centre of the wheel that would roll on the slide, of the drive's unit as its radius."""
    board, unit = plan.positions.board, plan.mechanism.drive.unit
    arm = board.turn(f"r{plan.mechanism.drive.link}", along, 1j * unit, because("wheel_radius"))
    return board.lay_off(f"W{plan.mechanism.drive.link}", end, arm, because("wheel_centre"))


def _turned(plan: ForcePlan) -> CutGroup:
    """Balance the crank by moments about its shaft, then close its polygon in the frame (figure 6.17)."""
    drive, board = plan.mechanism.drive, plan.board
    shaft, (loads, couples) = plan.positions.point(drive.pivot), plan.acting(drive.link)
    plan.shaft = shaft
    terms = statics.moments(plan, shaft, loads, couples)
    line = _line(plan, terms)
    why, driving = because("moments", point=shaft.name, link=drive.link), list[tuple[str, Mark, str]]()
    if line is None:
        plan.balancing = board.close(BALANCING, *terms, why=why) if terms else board.given(BALANCING, 0.0, NOTHING)
    else:
        plan.driven = line.step.inputs[0]
        balanced = board.balance(DRIVING, shaft, line, *terms, why=why) if terms else None
        plan.drive = balanced or board.given(DRIVING, 0j, NOTHING)
        plan.balancing = board.moment(BALANCING, shaft, plan.driven, plan.drive, because("driving_moment"))
        driving = [(DRIVING, plan.drive, PART)]
    armed = tuple(load for load in loads if load.at is not shaft)
    equation = MomentEquation(shaft, armed, tuple(couples), line, plan.drive or plan.balancing)
    chain = statics.chain(plan, str(drive.link), *driving, *statics.known_sides(loads))
    name = f"R_{indices(FRAME, drive.link)}"
    force = board.join(name, chain.end, chain.start, because("closing"))
    support = statics.support(plan, (FRAME, drive.link), drive.pivot, force)
    sides = (*chain.sides, PolygonSide(name, chain.end, chain.start, CLOSING))
    return CutGroup(None, (drive.link,), tuple(loads), tuple(couples), (support,), (), (equation,), sides)


def _line(plan: ForcePlan, terms: Sequence[Mark]) -> Mark | None:
    """Draw the line along which the crank is driven against some moments; None where a moment drives it."""
    base, drive, how = plan.positions, plan.mechanism.drive, plan.machine.transmission
    if how.kind == FORCE:
        arm = base.arm(drive.link)
        return base.board.square(f"⊥{arm.name}", base.point(drive.end), arm, because("driving_square"))
    if how.kind == GEAR:
        pitch = base.board.given("W", cmath.rect(how.radius, how.at), because("pitch_point"))
        asked = np.asarray(-sum(term.point.real for term in terms))
        plan.push = plan.board.given("line of action", pushing(how, drive, asked), because("pressure_angle"))
        return base.board.parallel("line of action", pitch, plan.push, because("line_of_action"))
    return None


def pushing(gear: Transmission, drive: Drive, moment: Floats) -> Complexes:
    """Give the direction in which the pinion's tooth presses: it pushes, and never pulls, by whichever flank bears.

    The pitch tangent in the sense of the moment that is asked of it, turned by the pressure angle towards the wheel's
    centre; with the rotation in book figure 6.17 (M5.7), where it drives.
    """
    sense = np.where(np.abs(moment) > 0, np.sign(moment), -1.0 if drive.omega < 0 else 1.0)  # a gap has its line too
    return np.asarray(sense * 1j * np.exp(1j * (gear.at + sense * gear.pressure)))


def joined(parts: Sequence[Kinetostatics]) -> Kinetostatics:
    """Put the forces over parts of the positions together."""
    if len(parts) == 1:
        return parts[0]
    reactions = {}
    for key, first in parts[0].reactions.items():
        names = ("r", "force", "moment", "along")
        rows = (_together([getattr(part.reactions[key], name) for part in parts]) for name in names)
        reactions[key] = Reaction(first.giver, first.taker, first.point, *rows)
    balancing = Effort(*(_together(rows) for rows in zip(*(part.balancing for part in parts), strict=True)))
    return Kinetostatics(parts[0].by, np.concatenate([part.phi for part in parts]), reactions, balancing, ())


def without(forces: Kinetostatics, gone: npt.NDArray[np.bool_]) -> Kinetostatics:
    """Leave no force at some positions."""

    def kept(row: Any) -> Any:
        return None if row is None else np.where(gone, np.nan, row)

    reactions = {
        key: reaction._replace(force=kept(reaction.force), moment=kept(reaction.moment))
        for key, reaction in forces.reactions.items()
    }
    drive = forces.balancing
    balancing = Effort(kept(drive.moment), kept(drive.force), drive.r)
    return replace(forces, reactions=reactions, balancing=balancing)


def _together(rows: Sequence[Any]) -> Any:
    return None if rows[0] is None else np.concatenate(rows)


def with_cylinder(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Loading:
    """Add to loads the force of the cylinder that drives a mechanism over a motion of order 2, where one does."""
    if mechanism.drive.ram is None:
        return loads
    along, _ = _growth(mechanism, motion)
    force = np.asarray(push(mechanism, machine, motion, loads) * along)
    ends = zip(_ends(mechanism), (force, 0.0 - force), (DRIVING, DRIVING.replace("_", "′_")), strict=True)
    pushes = (Applied(name, *end, pushed, useful=False) for end, pushed, name in ends if end[0] != FRAME)
    return loads._replace(forces=(*loads.forces, *pushes))


def push(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Floats:
    """Give the force N with which a cylinder pushes its ends apart, (N,), under other loads; below zero it pulls."""
    _, growth = _growth(mechanism, motion)
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        return np.asarray(-_power(mechanism, machine, motion, loads) / growth)


def _growth(mechanism: Mechanism, motion: Motion) -> tuple[Complexes, Floats]:
    """Give the unit direction from the cylinder's foot to its point, and how fast they part, m/s."""
    span, *rates = (apart(mechanism, motion, order) for order in range(3))
    along = span / np.abs(span)
    return along, (np.conj(along) * _way(mechanism, motion, rates)).real


def _way(mechanism: Mechanism, motion: Motion, rates: Sequence[Any]) -> Any:
    """Give the rates by which powers are told: of first order, and where all rests those of second, as those begin."""
    ends = motion.points[mechanism.drive.end]
    return np.where(ends.v == 0, rates[1], rates[0])


def _ends(mechanism: Mechanism) -> Iterator[tuple[int, str, complex]]:
    """Give the links that a cylinder pushes apart, each with its point: rod or its link, cylinder or its link."""
    ram, links = mechanism.drive.ram, mechanism.links
    assert ram is not None  # one drives
    # Where the scene has cylinder and rod as links: of two that slide in each other the ends of both
    pairs = (pair for slide in mechanism.slides for pair in permutations((slide.slider, slide.owner)))
    drawn = (pair for pair in pairs if ram.foot in links[pair[0]].points and ram.point in links[pair[1]].points)
    cylinder, rod = next(drawn, ram.links or (FRAME, mechanism.drive.link))
    yield rod, ram.point, links[rod].points[ram.point]
    yield cylinder, ram.foot, links[cylinder].points[ram.foot]


def _power(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Floats:
    """Give the power W, where all rests its rate W/s, of loads, weights, inertia forces and moments, (N,)."""
    total = np.zeros(len(motion.phi))
    for load in loads.forces:
        if load.link != FRAME:
            _, *rates = carried(mechanism, motion, load.link, load.at)
            total += (np.conj(load.force) * _way(mechanism, motion, rates)).real
    for twist in loads.moments:
        turned = motion.links[twist.link]
        total += twist.moment * _way(mechanism, motion, (turned.omega, turned.epsilon))
    return total + sum((_borne(mechanism, machine, motion, body) for body in machine.bodies.values()), 0.0 * total)


def _borne(mechanism: Mechanism, machine: Machine, motion: Motion, body: Body) -> Floats:
    """Give the power W of the weight and the inertia of a link."""
    _, v, a = carried(mechanism, motion, body.link, body.centre)
    turned = motion.links[body.link]
    force = body.mass * (machine.gravity - a)
    way, turning = (_way(mechanism, motion, pair) for pair in ((v, a), (turned.omega, turned.epsilon)))
    return np.asarray((np.conj(force) * way).real - body.inertia * turned.epsilon * turning)
