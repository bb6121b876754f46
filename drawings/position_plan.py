"""The figure of the plan of positions: all positions thin, one in full lines with its pairs, paths and extremes."""

from __future__ import annotations

import cmath
import math

import numpy as np

from drawings.figure import Place, Subject
from drawings.hand import Hand
from drawings.layout import Labels
from drawings.skeleton import Skeletons
from drawings.strokes import INK, Arc, Circle, Group, Line, LineStyle, Polyline, Stroke, Text
from drawings.symbols import arrowhead, fixed_hinge, guide, hinge, slider, turning_arrow
from drawings.vector_plan import written
from drawings.words import fixed
from geometry.board import Arc as Notch
from geometry.board import at
from plans.extreme import frame_slide
from plans.mechanism import FRAME, Slide
from plans.motion import Complexes
from plans.passage import CHANGE

NOTCH = 9.0  # mm of a notch arc kept on each side of its meeting
ARROW_RADIUS = 13.0  # mm, of the crank's sense of rotation
NUMBER, LETTER = 3.5, 5.0
CROSS = 1.8  # mm, half an arm of the cross at a crank position that is a gap
TICK = 1.2  # mm of a position's tick on each side of a guide's axis
DIMENSION_STEP = 22.0  # mm from a guide to the dimension of its stroke: clear of the numbers and the guide's ground


def figure(bones: Skeletons, place: Place, hand: Hand, language: str) -> list[Group]:
    """Draw the plan of positions at its place, from the thinnest lines to the pairs; its letters come last of all."""
    layers = [
        Group(tuple(_paths(bones, place, hand)), "paths"),
        Group(tuple(_circle_and_positions(bones, place, hand)), "all-positions"),
        Group(tuple(_extreme(bones, place, hand)), "extremes"),
        Group(tuple(_guides(bones, place, hand)), "guides"),
        Group(tuple(_notches(bones, place, hand)), "notches"),
        Group(tuple(_body(bones, place, hand)), "shown-position"),
        Group(tuple(_pairs(bones, place, hand)), "pairs"),
        Group(tuple(_stroke(bones, place, hand, language)), "stroke"),
        Group(tuple(_sense(bones, place, hand)), "rotation"),
    ]
    return [layer for layer in layers if layer.strokes]


def _paths(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the trajectories of the points that go neither on the crank's circle nor along a guide."""
    mechanism = bones.study.mechanism
    still = set(mechanism.links[FRAME].points) | set(mechanism.links[mechanism.drive.link].points)
    guided = {slide.point for slide in mechanism.slides if FRAME in (slide.slider, slide.owner)}
    drawn: list[Stroke] = []
    for name in sorted(bones.path.keys() - still - guided):
        arc = _swing(bones, name, place, hand)
        drawn += [arc] if arc else [Polyline(tuple(run), False, hand.path) for run in _runs(bones.path[name], place)]
    return drawn


def _swing(bones: Skeletons, name: str, place: Place, hand: Hand) -> Arc | None:
    """Draw the path of a rocker's point as one arc: drawn there and back, its dashes would close up."""
    mechanism = bones.study.mechanism
    fixed_points = mechanism.links[FRAME].points
    rockers = [link for link in bones.links if name in mechanism.links[link].points]
    pivots = [point for link in rockers for point in mechanism.links[link].points if point in fixed_points]
    values = bones.path[name]
    if not pivots or np.isnan(values.real).any():
        return None
    pivot = fixed_points[pivots[0]]
    angles = np.unwrap(np.angle(values - pivot))
    low, high = float(angles.min()), float(angles.max())
    if high - low >= math.pi:  # a full turn is no swing
        return None
    return Arc(place.on(pivot), place.length(abs(complex(values[0]) - pivot)), low, high, hand.path)


def _runs(values: Complexes, place: Place) -> list[list[complex]]:
    """Break a path at its gaps: never across one."""
    runs: list[list[complex]] = [[]]
    for value in values:
        if math.isnan(value.real):
            runs.append([])
        else:
            runs[-1].append(place.on(complex(value)))
    return [run for run in runs if len(run) > 1]


def _circle_and_positions(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    points = bones.motion.points
    pivot, shown = bones.pivot(place), bones.shown
    radius = abs(place.on(bones.crank_end(shown)) - pivot)
    low, high = bones.swept
    drawn: list[Stroke] = [Arc(pivot, radius, low, high, hand.drafted), *_barred(bones, pivot, radius, hand)]
    extremes = {_numbered(bones, k) for k in range(2 if bones.extremes else 0)}
    for k in range(len(bones.motion.phi)):
        if k != shown and k not in extremes:
            drawn += _links(bones, {n: complex(m.r[k]) for n, m in points.items()}, place, hand.drafted)
    return drawn


def _barred(bones: Skeletons, pivot: complex, radius: float, hand: Hand) -> list[Stroke]:
    """Hatch the crank circle where the crank cannot go, and mark its gap positions and change points by a cross."""
    drawn: list[Stroke] = []
    for barrier in bones.study.met:
        count = max(int((barrier.end - barrier.start) * radius / 2.5), 1)
        for k in range(count + 1):
            ray = cmath.rect(1.0, barrier.start + (barrier.end - barrier.start) * k / count)
            drawn.append(Line(pivot + radius * ray, pivot + (radius + 2.5) * ray * cmath.rect(1.0, 0.02), hand.drafted))
    crosses = [complex(d) for d in bones.study.turn.directions[bones.study.lost]]
    crosses += [cmath.rect(1.0, barrier.start) for barrier in bones.study.met if barrier.kind == CHANGE]
    for direction in crosses:
        spot = pivot + radius * direction
        for arm in (CROSS * cmath.rect(1.0, math.pi / 4), CROSS * cmath.rect(1.0, -math.pi / 4)):
            drawn.append(Line(spot - arm, spot + arm, hand.other))
    return drawn


def _links(
    bones: Skeletons, places: dict[str, complex], place: Place, style: LineStyle, whole: bool = False
) -> list[Stroke]:
    drawn: list[Stroke] = []
    for link in bones.links:
        ends = [place.on(places[name]) for name in bones.ends(link, whole)]
        if len(ends) > 1 and not any(math.isnan(end.real) for end in ends):
            drawn.append(Polyline(tuple(ends), len(ends) > 2, style))
    return drawn


def _extreme(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the extreme positions in dash-two-dots lines."""
    drawn: list[Stroke] = []
    for k in range(2 if bones.extremes else 0):
        if _numbered(bones, k) != bones.shown:
            places = {name: complex(values[k]) for name, values in bones.extremes.items()}
            drawn += _links(bones, places, place, hand.extreme)
    return drawn


def _numbered(bones: Skeletons, extreme: int) -> int | None:
    """Give the scene's own position that an extreme is, if it is one: the same crank direction to rounding."""
    found = bones.study.found
    assert found is not None  # asked only where there are extremes
    apart = np.abs(bones.study.turn.directions - found.directions[extreme])
    best = int(np.argmin(apart))
    return best if apart[best] < 1e-9 else None  # a nanoradian is no distance on any sheet


def _guides(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw each frame's guide: its axis over the travel, ground beside the shown block, a tick at each position."""
    drawn: list[Stroke] = []
    for slide in bones.study.mechanism.slides:
        if FRAME in (slide.slider, slide.owner) and slide.point in bones.path:
            start, end = _travel(bones, slide, place)
            places = [place.on(complex(r)) for r in bones.motion.points[slide.point].r if not math.isnan(r.real)]
            block = place.on(bones.spot(slide.point, bones.shown))
            drawn += guide(start, end, (start + end) / 2 if math.isnan(block.real) else block, hand)
            across = 1j * (end - start) / abs(end - start) * TICK
            drawn += [Line(at_k - across, at_k + across, hand.drafted) for at_k in places]
    return drawn


def _travel(bones: Skeletons, slide: Slide, place: Place) -> tuple[complex, complex]:
    """Give the ends of a frame's guide on paper: the pin's travel and a block's length more."""
    values = bones.path[slide.point]
    direction = slide.way(FRAME).direction
    known = values[~np.isnan(values.real)]
    if not known.size:  # nothing is assembled: the guide is where the scene puts it
        known = np.array([slide.way(FRAME).through])
    along = (known * np.conj(direction)).real
    base = complex(known[0]) - direction * along[0]
    more = 16.0 * direction
    return place.on(base + direction * along.min()) - more, place.on(base + direction * along.max()) + more


def _notches(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Keep the notch arcs of the shown position, trimmed to their use; arcs that miss each other are drawn whole."""
    plan = bones.study.drafts().positions
    drawn: list[Stroke] = []
    for mark in plan.board:
        for (source, ray), locus in zip(mark.rays, mark.step.inputs, strict=False):
            if mark.step.op == "meet" and isinstance(locus.value, Notch):
                centre, arm = place.on(at(source.point, bones.shown)), at(ray, bones.shown)
                if math.isnan(arm.real) and not math.isnan(centre.real):
                    drawn.append(Circle(centre, place.length(abs(at(locus.value.radius, 0))), hand.drafted))
                elif not math.isnan(arm.real):
                    drawn.append(_trimmed(centre, place.length(abs(arm)), cmath.phase(arm), hand))
    return drawn


def _trimmed(centre: complex, radius: float, angle: float, hand: Hand) -> Arc:
    half = min(NOTCH / radius, math.pi)
    return Arc(centre, radius, angle - half, angle + half, hand.drafted)


def _body(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    places = {name: complex(motion.r[bones.shown]) for name, motion in bones.motion.points.items()}
    return _links(bones, places, place, hand.result, whole=True)


def _pairs(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw stones and sliders, fixed hinges, hinges and other named points; all points can be measured."""
    mechanism, shown = bones.study.mechanism, bones.shown
    scale, subject = place.scale, Subject("positions", "r", shown)
    drawn: list[Stroke] = []
    for slide in mechanism.slides:
        pin = bones.spot(slide.point, shown)
        if not math.isnan(pin.real):
            drawn.append(slider(place.on(pin), _line_direction(bones, slide), hand))
    for name in sorted(mechanism.links[FRAME].points):
        if name in mechanism.hinges:
            drawn += fixed_hinge(place.on(mechanism.links[FRAME].points[name]), hand)
    for name in sorted(bones.motion.points):
        value = bones.spot(name, shown)
        if math.isnan(value.real):
            continue
        spot = place.on(value)
        jointed = name in mechanism.hinges
        circle = hinge(spot, hand) if jointed else Circle(spot, 0.9, INK)
        kind = "pole" if name == mechanism.drive.pivot else "point"
        drawn.append(Group((circle,), "", subject.data(kind, name, value, scale), name))
    return drawn


def _line_direction(bones: Skeletons, slide: Slide) -> complex:
    """Give the direction of a sliding line in the shown position."""
    owner = slide.owner
    turn = 0.0 if owner == FRAME else float(bones.motion.links[owner].angle[bones.shown])
    return slide.on_owner.direction * cmath.rect(1.0, turn)


def _stroke(bones: Skeletons, place: Place, hand: Hand, language: str) -> list[Stroke]:
    """Dimension the stroke H of a sliding output, in millimetres of the machine."""
    found, out = bones.study.found, bones.study.output
    slide = frame_slide(bones.study.mechanism, out.link)
    if found is None or slide is None:
        return []
    pins = [place.on(complex(value)) for value in bones.extremes[out.point or slide.point]]
    first, last = sorted(pins, key=lambda pin: (pin.real, pin.imag))
    along = (last - first) / abs(last - first)
    up = 1j * along
    start, end = first + DIMENSION_STEP * up, last + DIMENSION_STEP * up
    text = f"H = {fixed(1000 * found.extremes.stroke, language)}".rstrip("0").rstrip(".,")
    heads = [head for head in (arrowhead(end, start), arrowhead(start, end)) if head is not None]
    return [
        Line(first + 4 * up, start + 2 * up, hand.drafted),
        Line(last + 4 * up, end + 2 * up, hand.drafted),
        Line(start, end, hand.drafted),
        *heads,
        Text((start + end) / 2 + 1.2 * up, text, LETTER, "middle", True, math.degrees(cmath.phase(along))),
    ]


def _sense(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Show the sense of the crank's rotation by an arc with an arrowhead."""
    pivot = bones.pivot(place)
    angle = float(bones.study.turn.phi[bones.shown])
    sweep = 1.2 * bones.study.sense
    return list(turning_arrow(pivot, ARROW_RADIUS, angle + 0.25 * bones.study.sense, sweep, hand))


def letters(bones: Skeletons, place: Place, labels: Labels) -> Group:
    """Letter the points and number the positions, where the lines of all figures leave room."""
    drive = bones.study.mechanism.drive
    pivot = bones.pivot(place)
    drawn: list[Stroke] = []
    for name in sorted(bones.motion.points):
        value = bones.spot(name, bones.shown)
        if not math.isnan(value.real):
            spot = place.on(value)
            drawn.append(labels.beside(spot, written(name), LETTER, 3.0, math.pi / 4))
    turn = float(bones.study.turn.phi[bones.shown]) + 0.85 * bones.study.sense
    drawn.append(labels.beside(pivot + cmath.rect(ARROW_RADIUS, turn), f"ω_{drive.link}", LETTER, 1.5, turn))
    return Group((*drawn, *_numbers(bones, place, labels)))


def _numbers(bones: Skeletons, place: Place, labels: Labels) -> list[Stroke]:
    """Number the crank's positions outside its circle, and the output's; an extreme between two has a prime."""
    drive, points = bones.study.mechanism.drive, bones.motion.points
    pivot = bones.pivot(place)
    drawn: list[Stroke] = []
    tip = _tip(bones)
    for k, name in _numbered_places(bones):
        extreme = isinstance(k, tuple)
        places = bones.extremes if extreme else {n: m.r for n, m in points.items()}
        column = k[0] if isinstance(k, tuple) else k
        crank = place.on(complex(places[drive.end][column]) if extreme else bones.crank_end(column))
        drawn.append(labels.beside(crank, name, NUMBER, 1.2, cmath.phase(crank - pivot)))
        if tip is not None and not math.isnan(places[tip][column].real):
            end = place.on(complex(places[tip][column]))
            drawn.append(labels.beside(end, name, NUMBER, 1.8, _outward(bones, end, place, column)))
    return drawn


def _numbered_places(bones: Skeletons) -> list[tuple[int | tuple[int], str]]:
    """List what bears a number: every position, and each extreme that falls between two, as k'."""
    found: list[tuple[int | tuple[int], str]] = [(k, str(k)) for k in range(len(bones.motion.phi))]
    turn, step = bones.study.turn, 2 * np.pi
    for k in range(2 if bones.extremes else 0):
        extremes = bones.study.found
        if extremes is not None and _numbered(bones, k) is None:
            ahead = np.mod(bones.study.sense * (extremes.extremes.phi[k] - turn.phi), step)
            name = f"{int(np.argmin(ahead))}'"
            found.append(((k,), f"{name}'" if any(name == other for _, other in found) else name))
    return found


def _tip(bones: Skeletons) -> str | None:
    """Give the point whose places on its path are numbered: the output's pin, or its end away from the frame."""
    mechanism, out = bones.study.mechanism, bones.study.output
    slide = frame_slide(mechanism, out.link)
    if slide is not None:
        return out.point or slide.point
    free = [name for name in mechanism.links[out.link].points if name not in mechanism.links[FRAME].points]
    return free[-1] if free and out.link != mechanism.drive.link else None


def _outward(bones: Skeletons, end: complex, place: Place, column: int) -> float:
    """Direct a number away from the line that its point runs along: by the stroke, to one side or the other."""
    slide = frame_slide(bones.study.mechanism, bones.study.output.link)
    if slide is None:
        fixed_points = bones.study.mechanism.links[FRAME].points
        own = [p for p in bones.study.mechanism.links[bones.study.output.link].points if p in fixed_points]
        return cmath.phase(end - place.on(fixed_points[own[0]])) if own else math.pi / 2
    up = cmath.phase(slide.way(FRAME).direction) + math.pi / 2
    return up if column % 2 == 0 else up + math.pi
