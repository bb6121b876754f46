"""The self-check of the numbers of positions: at the crank, at the output, at each slider (нумерация положений)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.letters import Label, labels_of, off
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.numbers.numbers_due import Course, DueNumbers, Seen, courses
from drawings.checks.reading import plain
from drawings.checks.wrong import on
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Group, Text
from drawings.paper.walk import texts
from plans.linkage.study import EXTREMES
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME, Output
from plans.model.motion import Complexes
from plans.model.order import POSITIONS
from plans.words.words import Message

LINKS = "links"  # the group of the numbers of links, among the letters of the plan
NUMBER = re.compile(r"(0|[1-9]\d*)('*)(?: \(.*°\))?")
UNDER = 3.0  # mm from a place to a letter in the way: a leader begins less than two millimetres off, clear of letters
FAR = 20.0  # mm from a place to its number: two rings of numbers outside the hatching of a barrier
NEARER = 3.0  # mm by which another position's place may be nearer, where numbers crowd
ROOMY = 12.0  # mm between positions on the crank's circle: none of their numbers crowds another
MOST = 0.34  # share of the numbers that may stand nearer to another position's place where places crowd


class Numbered(NamedTuple):
    """Places that bear numbers: by the scene's positions (N,), and of extremes that fall between two of them."""

    places: Complexes
    between: tuple[tuple[int, complex], ...] = ()
    point: str = ""


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that each number stands at a place of its position, and that none is missing where there is room."""
    crank, *tracks = _numbered(plan)
    labels = list(_labels(plan))
    read, strays = list[tuple[int, bool, int, Label]](), 0
    for text, label in labels:
        found = NUMBER.fullmatch(text)
        if found is None:
            yield on("position_number", POSITIONS.plan, name=text)
            continue
        number, middle = int(found[1]), _middle(label)
        own = [_own(one, number, bool(found[2]), middle) for one in (crank, *tracks)]
        best = int(np.argmin(own))
        near, apart = min(_nearest(one, middle, own[best]) for one in (crank, *tracks))
        crowded = own[best] > near + NEARER
        if not own[best] <= FAR or (crowded and apart >= ROOMY):
            yield on("position_number", POSITIONS.plan, name=text)
        read.append((number, bool(found[2]), best, label))
        strays += crowded
    if strays > MOST * len(labels):
        yield on("position_number", POSITIONS.plan, name=str(strays))
    for one in _due(plan, crank, tracks, read):
        lost = [k for k in one.missing(FAR, plan.near) if not _is_under(plan, complex(one.places[k]))]
        yield from (on("position_number", POSITIONS.plan, name=str(k)) for k in lost)


def _is_under(plan: LaidPlan, spot: complex) -> bool:
    """Tell whether a letter stands so near to a place that not even a leader of a number can begin there.

    Numbers stand where places leave them room, and that of a place beside the letter of the point that lies there.
    """
    points = ((name, complex(plan.poses.point(name)[plan.position])) for name in plan.poses.motion.points)
    own = {plain(name) for name, at in points if abs(at - spot) <= plan.near}
    letters = (one for one in texts(plan.leaf.groups) if NUMBER.fullmatch(one.plain) is None and one.plain not in own)
    return any(off(spot, bounds(text)) <= UNDER for text in letters)


def _due(
    plan: LaidPlan, crank: Numbered, tracks: Sequence[Numbered], read: Sequence[tuple[int, bool, int, Label]]
) -> Iterator[DueNumbers]:
    """Give what must be numbered: the positions at the crank, and along each track that has numbers at all."""
    seen = Seen.of([(number, between, label) for number, between, _, label in read])
    own = [{number for number, between, best, _ in read if best == k and not between} for k in range(1 + len(tracks))]
    yield DueNumbers(crank.places, plan.position, [0] * len(crank.places), crank.between, seen, own[0])
    known = {one.point: (one, numbers) for one, numbers in zip(tracks, own[1:], strict=True)}
    for course in courses(plan, _output_point(plan)):
        track, numbers = known[course.point]
        yield DueNumbers(track.places, plan.position, course.strokes(plan), _ends(plan, course), seen, numbers)


def _ends(plan: LaidPlan, course: Course) -> tuple[tuple[int, complex], ...]:
    """Give the extremes of a track, each with the position that comes before it."""
    own = [] if course.extremes is None else [*course.extremes.phi]
    motion = plan.road.freely(np.array(own)) if own else None
    if motion is None:
        return ()
    return tuple(
        zip(
            (_before(plan, phi) for phi in own),
            plan.poses._replace(motion=motion).point(course.point).tolist(),
            strict=True,
        )
    )


def _output_point(plan: LaidPlan) -> str | None:
    """Give the point of the output that bears numbers, if it has one."""
    mechanism, out = plan.laid.mechanism, plan.laid.study.output
    slide = frame_slide(mechanism, out.link)
    if slide is not None:
        return out.point or slide.point
    fixed = mechanism.links[FRAME].points
    free = [name for name in mechanism.links[out.link].points if name not in fixed]
    return out.point if out.point in free else free[-1] if free else None


def _labels(plan: LaidPlan) -> Iterator[tuple[str, Label]]:
    """Give the numbers among the letters of the plan, but those of links and on trajectories."""
    for group in plan.leaf.groups:
        if any(isinstance(one, Group) and one.name == LINKS for one in group.strokes):
            own = tuple(one for one in group.strokes if isinstance(one, Text) or not one.name)  # type: ignore[union-attr]
            for text, labels in labels_of(own).items():
                yield from ((text, label) for label in labels if text[:1].isdigit())


def _middle(label: Label) -> complex:
    left, bottom, right, top = label.place
    return complex(left + right, bottom + top) / 2


def _own(one: Numbered, number: int, between: bool, middle: complex) -> float:
    """Give how far a number is from its own place, mm; infinity where it has none."""
    spots = [spot for k, spot in one.between if k == number] if between else [*one.places[number : number + 1]]
    return min((abs(middle - spot) for spot in spots if np.isfinite(spot)), default=np.inf)


def _nearest(one: Numbered, middle: complex, own: float) -> tuple[float, float]:
    """Give how far a number is from the nearest place, and that at the least from the number's own, mm."""
    spots = one.places[np.isfinite(one.places)]
    if not spots.size:
        return math.inf, math.inf
    near = float(np.abs(middle - spots).min())
    return near, own - near


def _numbered(plan: LaidPlan) -> Iterator[Numbered]:
    """Give the places at the crank, then those of the output and of each other slider on the frame."""
    laid, study = plan.laid, plan.laid.study
    own = [] if plan.told is None else [*plan.told.phi]
    points, slides = [], [slide for slide in laid.mechanism.slides if slide.owner == FRAME]
    out = study.output
    for slide in slides:
        point = (out.point or slide.point) if slide.slider == out.link else slide.point
        points.append(point)
        if slide.slider != out.link and EXTREMES in study.plans:
            found = plan.road.extremes(Output(slide.slider, slide.point))
            own += [] if found is None else [*found.phi]
    points += [point for point in (_output_point(plan),) if point is not None]
    motion = plan.road.freely(np.array(own)) if own else None
    extremes = None if motion is None else plan.poses._replace(motion=motion)
    before = [_before(plan, phi) for phi in own]
    pivot, ends = complex(plan.poses.point(laid.mechanism.drive.pivot)[0]), plan.crank_ends
    arms = [(ends[0] - pivot) * np.exp(1j * (phi - laid.motion.phi[0])) for phi in own]
    yield Numbered(ends, tuple(zip(before, (pivot + arm for arm in arms), strict=True)))
    for point in dict.fromkeys(points):
        beside = () if extremes is None else tuple(zip(before, extremes.point(point).tolist(), strict=True))
        yield Numbered(plan.poses.point(point), beside, point)


def _before(plan: LaidPlan, phi: float) -> int:
    """Give the position that comes before a crank angle, as the crank turns."""
    ahead = np.mod(plan.laid.study.sense * (phi - plan.laid.motion.phi), 2 * np.pi)
    return int(np.argmin(ahead))
