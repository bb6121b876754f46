"""Assembly: the side of every group's meeting, chosen by the sketch, and its margin to a dead centre (сборка)."""

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Arc, Line, Mark, between
from geometry.branch import Side
from geometry.errors import DraftError
from geometry.meet import UNBORNE, cross
from geometry.three_leads import BodyPose, chosen
from plans.linkage.dyads import KINDS
from plans.linkage.motion_plans import positions
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES, CrankPositions
from plans.model.dyad import Assur
from plans.model.mechanism import Mechanism, Slide
from plans.model.motion import Complexes, Floats
from plans.words.words import message

SAME = 1e-6  # rad: an edge that touches is known to half the digits of an angle


class BarrierEdge(NamedTuple):
    """An edge of a barrier: its crank angle, rad, the first that is barred, and which group fails there, and how."""

    phi: float
    beyond: float
    kind: str  # "change point", "out of reach" or "parallel guides"
    group: int
    where: str  # the mark whose loci miss or touch


class Barrier(NamedTuple):
    """A part of the turn that the crank cannot pass, from one edge counter-clockwise to the other."""

    edges: tuple[BarrierEdge, BarrierEdge]
    miss: float  # m, the largest miss seen

    @property
    def start(self) -> float:
        """Where it begins, rad."""
        return self.edges[0].phi

    @property
    def end(self) -> float:
        """Where it ends, rad."""
        return self.edges[1].phi

    @property
    def kind(self) -> str:
        """What bars the crank where it begins."""
        return self.edges[0].kind

    @property
    def group(self) -> int:
        """The group that fails where it begins."""
        return self.edges[0].group

    @property
    def where(self) -> str:
        """The mark whose loci miss or touch where it begins."""
        return self.edges[0].where

    @property
    def middle(self) -> float:
        """The angle in the middle of it, rad."""
        return (self.start + self.end) / 2


def bounding(phi: float, home: float, barriers: Sequence[Barrier]) -> BarrierEdge | None:
    """Give the edge that keeps the crank from an angle, rad: of the two that bound its way from home, the nearer."""
    if not barriers:
        return None
    turn = 2 * np.pi
    ahead = min((b.edges[0] for b in barriers), key=lambda edge: float(np.mod(edge.phi - home, turn)))
    behind = min((b.edges[1] for b in barriers), key=lambda edge: float(np.mod(home - edge.phi, turn)))
    ways = [abs(float(np.angle(np.exp(1j * (phi - edge.phi))))) for edge in (ahead, behind)]
    return ahead if ways[0] <= ways[1] + SAME else behind


# Two points so much nearer to each other than their figure is large give a direction without a true digit.
NOWHERE = 8.0 * UNBORNE


def met_at(mark: Mark) -> str:
    """Name the point at which lines of a notch meet: of a slot's direction the pin that it holds."""
    return mark.step.inputs[-1].name if mark.step.op == "tangent" else mark.name


def margins(plan: Plan, groups: Sequence[Assur], sides: Sequence[Side]) -> tuple[Floats, list[Mark]]:
    """Give every group's margin over the positions, (groups, positions): above 0 assembled, 0 dead, below 0 missing.

    A miss counts as -1: only its sign is meant. Two guides cross with the sine of their angle, signed as the group's
    side: it changes sign where they are parallel and their pin runs to infinity. NaN: a group before fails.
    """
    marks = [meeting(plan, group) for group in groups]
    count = max(np.size(mark.point) for mark in plan.letters.values())
    rows = []
    for mark, side in zip(marks, sides, strict=True):
        miss = np.broadcast_to(np.asarray(mark.miss, dtype=float), count)
        sharpness = np.broadcast_to(np.asarray(mark.sharpness, dtype=float), count)
        turned = crossing(mark)
        assembled = np.where(miss > 0, -1.0, sharpness**2) if turned is None else np.asarray(side) * turned
        rows.append(np.broadcast_to(assembled, count))
    return np.array(rows).reshape(len(marks), count), marks


def crossing(mark: Mark) -> Floats | None:
    """Give the sine of the angle from the first of two lines to the second where they meet; None for other meetings."""
    first, second = (locus.value for locus in mark.step.inputs[:2])
    if not (mark.step.op == "meet" and isinstance(first, Line) and isinstance(second, Line)):
        return None
    turned = cross(first.direction, second.direction)
    return np.asarray(turned / (np.abs(first.direction) * np.abs(second.direction)))


def undefined(plan: Plan, groups: Sequence[Assur]) -> npt.NDArray[np.bool_]:
    """Tell at which positions each group has no one place, (groups, positions): its loci miss, fall into one, ..."""
    count = max(np.size(mark.point) for mark in plan.letters.values())
    return np.array([np.broadcast_to(_nowhere(meeting(plan, group)), count) for group in groups])


def _nowhere(mark: Mark) -> npt.NDArray[np.bool_]:
    """Tell where a meeting has no place, or any: its two centres, or a pin and its slot's pivot, are one point."""
    none = np.asarray(np.isnan(np.asarray(mark.point)))
    arcs = all(isinstance(locus.value, Arc) for locus in mark.step.inputs[:2])
    if mark.step.op != "tangent" and not arcs:
        return none
    ends = mark.step.inputs if not arcs else tuple(locus.step.inputs[0] for locus in mark.step.inputs)
    away = np.maximum(*(np.abs(np.asarray(end.point)) for end in ends))
    return np.asarray(none | (np.abs(between(*ends)) <= NOWHERE * away))


def meeting(plan: Plan, group: Assur) -> Mark:
    """Give the mark of a group's own meeting on the plan of positions."""
    return KINDS[group.kind].meeting(plan, group)


def of_arcs(mark: Mark) -> bool:
    """Tell whether a meeting is of an arc, which may be out of reach; two lines are not."""
    return crossing(mark) is None


# A hand sketch is trusted to 2 % of the distance between the two assemblies: what hands reach on textbook drawings.
CLARITY = 0.02
# Positions that fit a sketch as well as the best but for this share fit it alike: a symmetric mechanism has two, and
# rounding must not choose between them.
ALIKE = 1e-9


class SketchError(DraftError, ValueError):
    """A sketch that does not tell one assembly of a group from the other."""

    def __init__(self, message: object, points: tuple[str, ...]) -> None:
        super().__init__(message)
        self.points = points


class Assembly(NamedTuple):
    """The sides chosen, and the crank angle, rad, at which the sketch shows the mechanism; None: it has no position."""

    sides: tuple[Side, ...]
    phi: float | None


class SideChoice(NamedTuple):
    """For one group, over some crank angles: the side nearer to the sketch, how clearly, and the misfit in m2."""

    side: Floats | BodyPose
    clarity: Floats
    misfit: Floats


def assembly(
    mechanism: Mechanism, groups: Sequence[Assur], first: CrankPositions | None, whole: CrankPositions
) -> Assembly:
    """Choose each group's side by the sketch at the first position, or where the first is not known, over a whole turn.

    Where the first position cannot be assembled, or the start is an extreme still to be found, the crank angle at which
    the mechanism fits the sketch best decides. Raises SketchError where the sketch leaves a group undecided, or where
    a group has no one place at the first position, as no sketch could tell.
    """
    for turn in (first, whole):
        if turn is None:
            continue
        choices = _choices(mechanism, groups, turn)
        misfit = sum((choice.misfit for choice in choices), np.zeros(len(turn)))
        if np.isfinite(misfit).any():
            best = int(np.argmax(misfit <= np.nanmin(misfit) * (1.0 + ALIKE)))
            decided = [_decided(mechanism, group, c, best) for group, c in zip(groups, choices, strict=True)]
            sides, phi = _crossed(mechanism, groups, decided, turn.part([best])), float(turn.phi[best])
            return Assembly(_followed(mechanism, groups, sides, phi), phi)
        if turn is first:
            _out_of_reach(mechanism, groups, choices, turn)
    # No angle can be assembled: every position is a gap, whose advice tells of the sides that the sketch shows.
    shown = whole if first is None else first
    return Assembly(_crossed(mechanism, groups, _shown_sides(_choices(mechanism, groups, shown)), shown), None)


def _followed(mechanism: Mechanism, groups: Sequence[Assur], sides: Sequence[Side], home: float) -> tuple[Side, ...]:
    """Follow from home the assembly of each group that no side tells, group after group."""
    found: list[Side] = []
    for group, side in zip(groups, sides, strict=True):
        before = groups[: len(found)], tuple(found)
        found.append(KINDS[group.kind].followed(partial(_before, mechanism, before), group, side, home))
    return tuple(found)


def _before(mechanism: Mechanism, before: tuple[Sequence[Assur], Sequence[Side]], phi: Floats) -> Plan:
    return positions(mechanism, *before, CrankPositions(phi, np.exp(1j * phi)))


def _shown_sides(choices: Sequence[SideChoice]) -> list[Side]:
    """Give the sides of the sketch where most groups can be joined to those before them; 1 of what cannot."""
    joined = np.isfinite([choice.misfit for choice in choices])
    best = int(np.argmax(joined.sum(axis=0)))
    return [choice.side[best] if met[best] else 1.0 for choice, met in zip(choices, joined, strict=True)]


def _crossed(
    mechanism: Mechanism, groups: Sequence[Assur], sides: Sequence[Side], turn: CrankPositions
) -> tuple[Side, ...]:
    """Give a group with one assembly the sign with which its two lines cross: they must not become parallel."""
    plan = positions(mechanism, groups, sides, turn)
    turned = [crossing(mark) for mark in margins(plan, groups, sides)[1]]
    pairs = zip(sides, turned, strict=True)
    return tuple(side if sine is None else float(np.sign(sine.flat[0])) for side, sine in pairs)


def _out_of_reach(
    mechanism: Mechanism, groups: Sequence[Assur], choices: Sequence[SideChoice], first: CrankPositions
) -> None:
    """See that a first position without places is out of reach, and not one at which a group has no one place."""
    plan = positions(mechanism, groups, [choice.side for choice in choices], first)
    field, marks = margins(plan, groups, [1.0] * len(groups))
    for group, margin, mark in zip(groups, field[:, 0], marks, strict=True):
        if margin < 0 and crossing(mark) is None:
            return
        if np.isnan(mark.point).any() or _parallel(mark).any():
            raise SketchError(message("sketch.nowhere", group=group.label, point=met_at(mark)), ())


def _choices(mechanism: Mechanism, groups: Sequence[Assur], turn: CrankPositions) -> list[SideChoice]:
    plan, choices = PRIMARIES[mechanism.drive.kind].positions(mechanism, turn), []
    for group in groups:
        points = {point for link in group.links for point in mechanism.links[link].points}
        kind, shown = KINDS[group.kind], sorted(points & set(mechanism.sketch))
        if (known := untold(mechanism, group)) is not None:
            kind.positions(plan, group, known)
            places, ones = _places(plan, [], len(turn))[0], np.ones(len(turn))
            # A side that is given is clear, and fits any sketch
            choices.append(SideChoice(known * ones, ones, np.where(np.isfinite(places), 0.0, np.nan)))
            continue
        if len(turn) == 1 and (jammed := kind.jammed(plan, group)) is not None:
            raise SketchError(jammed, ())
        sides, places = kind.sides(plan, group), list[Complexes]()
        for side in sides:
            trial = plan.trial()
            kind.positions(trial, group, side)
            places.append(_places(trial, shown, len(turn)))
        choice = _choose(mechanism, shown, places, sides)
        kind.positions(plan, group, choice.side)
        choices.append(choice._replace(misfit=np.where(_parallel(meeting(plan, group)), np.nan, choice.misfit)))
    return choices


def _parallel(mark: Mark) -> npt.NDArray[np.bool_]:
    """Tell where the two lines that meet in a mark have one direction, but for rounding: their pin has no place."""
    turned = crossing(mark)
    return np.zeros(1, dtype=bool) if turned is None else np.asarray(~(np.abs(turned) > NOWHERE))


def untold(mechanism: Mechanism, group: Assur) -> float | None:
    """Give the side of a group that has no point but its outer hinges, so that no sketch can tell its assembly.

    A slot then runs from its link's own point through the stone: its angle tells which way it is directed.
    """
    hinges = [pair.joint for pair in group.outer_pairs if isinstance(pair.joint, str)]
    points = {point for link in group.links for point in mechanism.links[link].points}
    if KINDS[group.kind].assemblies < 2 or not points.issubset(hinges):
        return None
    slots = [pair.joint.owner for pair in group.inner_pairs if isinstance(pair.joint, Slide)]
    return 1.0 if group.links[-1] in slots else -1.0


def _places(plan: Plan, shown: list[str], count: int) -> Complexes:
    if not shown:  # a group that the sketch leaves out still tells whether it can be assembled
        image = next(reversed(plan.images.values()))
        arm = image.origin if image.arm is None else image.arm
        return np.broadcast_to(np.asarray(arm.point), (1, count))
    return np.array([np.broadcast_to(np.asarray(plan.point(point).point), count) for point in shown])


def _choose(mechanism: Mechanism, shown: list[str], places: list[Complexes], sides: Sequence[Side]) -> SideChoice:
    """Choose at each position the side whose places, (points, positions), lie nearest to the sketch."""
    rough = np.array([[mechanism.sketch[point]] for point in shown] or [[np.nan]])
    misfits = np.array([np.sum(np.abs(place - rough) ** 2, axis=0) for place in places])
    if not shown:
        misfits = np.where(np.isfinite(places)[:, 0], 0.0, np.nan)
    which = np.argmin(np.where(np.isnan(misfits), np.inf, misfits), axis=0)
    each = np.arange(len(which))
    with np.errstate(invalid="ignore", divide="ignore"):
        apart = np.sum(np.abs(np.array(places) - np.array(places)[which, :, each].T) ** 2, axis=1)
        clear = np.where(apart == 0, 0.0, (misfits - misfits[which, each]) / apart)
    clear[which, each] = np.inf
    poses = [side for side in sides if isinstance(side, BodyPose)]
    side = chosen(poses, which) if poses else np.choose(which, [np.asarray(side) for side in sides])
    return SideChoice(side, np.fmin.reduce(clear), misfits[which, each])


def _decided(mechanism: Mechanism, group: Assur, choice: SideChoice, position: int) -> Side:
    if KINDS[group.kind].assemblies > 1 and not choice.clarity[position] >= CLARITY:
        points = sorted({point for link in group.links for point in mechanism.links[link].points})
        free = tuple(p for p in points if p not in mechanism.links[0].points and p != mechanism.drive.end)
        raise SketchError(message("sketch.undecided", group=group.label, points=free or tuple(points)), free)
    return choice.side[position]
