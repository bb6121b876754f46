"""Trajectories: the paths of points that go neither on the crank's circle nor along a guide (траектории)."""

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from drawings.layout.picture import Place
from drawings.lettering.words import Phrase, fixed, slotted
from drawings.linkage.guides import NUMBERS, OUTER
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Kind, Line, LineStyle, Polyline, Statement, Stroke
from drawings.paper.walk import stating
from drawings.symbols.symbols import TurnArrow
from plans.linkage.travel import ExtremePositions
from plans.model.mechanism import FRAME
from plans.model.motion import POSITIONS, Complexes, Floats
from plans.words.words import word

INDICES = ("index.work", "index.idle")
WITHIN = 0.75  # of the crank circle, where there is room between it and the arrow of rotation
APART = 5.0  # mm from other arcs about the pivot
PAST = 2.0  # mm that the lines of the extreme positions go past the arcs that they bound


class StrokeArc(NamedTuple):
    """An arc about the crank's pivot from where a stroke begins to where it ends, in the sense of rotation."""

    letter: str
    arc: TurnArrow
    crank: float  # radius of the crank circle
    text: Phrase  # the letter with the angle's size

    def strokes(self, pairs: Pairs) -> Iterator[Stroke]:
        """Draw it with its arrow, and where it lies outside the crank circle the line that it begins at."""
        drawn, (centre, radius, start, _) = self.arc.draw(pairs.hand, pairs.hand.drafted), self.arc
        yield stating(Statement(Kind.ANGLE, POSITIONS.plan, self.letter), *drawn)
        if radius > self.crank:
            ray, reach = cmath.rect(1.0, start), radius + PAST * pairs.hand.symbol
            yield Line(centre + self.crank * ray, centre + reach * ray, pairs.hand.drafted)


def phases(pairs: Pairs, language: str) -> tuple[StrokeArc, ...]:
    """Give the arcs of both strokes; none where they are alike and none is asked for, or there are no two strokes."""
    study = pairs.bones.study
    if study.travel is None or not (study.scene.has(("output", "working")) or _differ(study.travel)):
        return ()
    extremes, centre, crank = study.travel.extremes, pairs.bones.pivot(pairs.place), pairs.bones.crank(pairs.place)
    # The arcs are within the crank circle beyond the arrow of rotation, or outside its numbers.
    within = WITHIN * crank
    fits = within >= (OUTER + APART) * pairs.hand.symbol and crank - within >= APART * pairs.hand.symbol
    radius = within if fits else crank + NUMBERS + APART * pairs.hand.symbol
    names = (f"φ_{{{word(language, index)}}}" for index in INDICES)
    ends = zip(names, extremes.phi, extremes.angles, strict=True)
    return tuple(
        StrokeArc(name, TurnArrow(centre, radius, phi, study.sense * arc), crank, sized(name, arc, language))
        for name, phi, arc in ends
    )


def sized(letter: str, angle: float, language: str) -> Phrase:
    """Write the letter of an angle rad with its size in degrees."""
    return slotted(f"{letter} = ", letter, fixed(math.degrees(angle), language), "°")


def _differ(travel: ExtremePositions) -> bool:
    """Tell whether there are two strokes over a turn, of angles that differ in the digits that are written."""
    first, second = (fixed(abs(math.degrees(arc)), "en") for arc in travel.extremes.angles)
    return len(travel.rests) == 2 and first != second


# Two paths nearer than this share of a line's width are one line on paper.
SAME = 0.3
STILL = 0.2  # mm: a shorter path is a dot under its point's own symbol


def trajectories(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw each path once, also where its point goes there and back along it: drawn twice, its dashes would close."""
    strokes: list[Stroke] = []
    for path in traced(bones):
        arc = _swing(bones, path.name, place, hand) if path.name not in bones.masses else None
        strokes += [arc] if arc else _path(np.asarray(place.origin + (path.way - place.zero) / place.scale.mu), hand)
    return strokes


class Traced(NamedTuple):
    """A point whose path is drawn: its places on the way and in the scene's positions, m; NaN at gaps."""

    name: str
    way: Complexes
    numbered: Complexes


def traced(bones: Skeletons) -> Iterator[Traced]:
    """Give the points whose paths are drawn, and the mass centres that no point names."""
    mechanism = bones.mechanism
    still = mechanism.links[FRAME].points.keys() | mechanism.links[mechanism.drive.link].points.keys()
    guided = {slide.slider for slide in mechanism.slides if slide.owner == FRAME}
    still |= {name for link in guided for name in mechanism.links[link].points}
    for name in sorted(bones.way.points.keys() - still):
        yield Traced(name, bones.way.points[name], bones.numbered.points[name])
    for name, mass in sorted(bones.masses.items()):
        if mass[0] not in guided:
            way, numbered = bones.way.of(*mass), bones.numbered.of(*mass)
            yield Traced(name, _swept(bones, way, numbered) if mass[0] == mechanism.drive.link else way, numbered)


def _swept(bones: Skeletons, way: Complexes, numbered: Complexes) -> Complexes:
    """Give of the circle of a crank's mass centre no more than is drawn of that of its end."""
    drive = bones.mechanism.drive
    if drive.pushed:
        return way
    pivot = bones.mechanism.links[FRAME].points[drive.pivot]
    shown = bones.shown
    turns = np.angle((way - pivot) / (numbered[shown] - pivot) * (bones.drive_end(shown) - pivot))
    return np.asarray(np.where([bones.sweeps(float(turn)) for turn in turns], way, np.nan))


def _swing(bones: Skeletons, name: str, place: Place, hand: Hand) -> Arc | None:
    """Draw the path of a rocker's point as one arc."""
    links = bones.mechanism.links
    rockers = [link for link in bones.links if name in links[link].points]
    pivots = [point for link in rockers for point in links[link].points if point in links[FRAME].points]
    values = bones.way.points[name]
    if not pivots or np.isnan(values.real).any():
        return None
    pivot = links[FRAME].points[pivots[0]]
    angles = np.unwrap(np.angle(values - pivot))
    low, high = float(angles.min()), float(angles.max())
    radius = place.length(abs(complex(values[0]) - pivot))
    if high - low >= math.pi or radius * (high - low) <= STILL:  # a full turn is no swing, and no more is rest
        return None
    return Arc(place.on(pivot), radius, low, high, hand.path)


def _path(spots: Complexes, hand: Hand) -> list[Stroke]:
    """Draw a path, broken at its gaps, each stretch of it once."""
    kept: list[Complexes] = []
    for stretch in sorted(_stretches(spots), key=length, reverse=True):
        if length(stretch) > STILL and not (kept and _lies_on(stretch, kept, SAME * hand.thin)):
            kept.append(stretch)
    return [_line(stretch, hand.path, SAME * hand.thin) for stretch in kept]


def length(stretch: Complexes) -> float:
    """Give the length of a chain of places."""
    return float(np.abs(np.diff(stretch)).sum())


def _stretches(spots: Complexes) -> Iterator[Complexes]:
    """Give the runs of a path between its gaps, each broken where the point turns back."""
    gaps = np.flatnonzero(np.isnan(spots.real))
    for run in np.split(spots, sorted({*gaps, *(gaps + 1)})):
        if len(run) < 2 or np.isnan(run[0].real):
            continue
        steps = np.diff(run)
        if not gaps.size and abs(run[0] - run[-1]) <= abs(steps).max():  # a whole turn: it has neither end
            back = _turned(np.append(steps[-1], steps))
            whole = run if not back.size else np.append(np.roll(run[:-1], -back[0]), run[back[0]])
            yield from _cut(whole, back - (back[0] if back.size else 0))
        else:
            yield from _cut(run, _turned(steps) + 1)


def _turned(steps: Complexes) -> npt.NDArray[np.intp]:
    return np.flatnonzero((steps[1:] * np.conj(steps[:-1])).real < 0)


def _cut(run: Complexes, turned: npt.NDArray[np.intp]) -> Iterator[Complexes]:
    cuts = sorted({0, *(int(cut) for cut in turned), len(run) - 1})
    yield from (run[low : high + 1] for low, high in pairwise(cuts))


def _lies_on(stretch: Complexes, others: list[Complexes], within: float) -> bool:
    starts = np.concatenate([other[:-1] for other in others])
    runs = np.concatenate([np.diff(other) for other in others])
    return all(float(_apart(spot, starts, runs).min()) <= within for spot in stretch)


def _apart(spot: complex, starts: Complexes, runs: Complexes) -> Floats:
    with np.errstate(invalid="ignore", divide="ignore"):
        shares = np.nan_to_num(((spot - starts) * np.conj(runs)).real / np.abs(runs) ** 2)
    return np.asarray(np.abs(starts + np.clip(shares, 0, 1) * runs - spot))


def _line(stretch: Complexes, style: LineStyle, within: float) -> Stroke:
    """Draw a stretch: one straight line where it is one, else a chain, closed where it comes back to its beginning."""
    ends = stretch[[int(np.argmin(stretch.real + stretch.imag)), int(np.argmax(stretch.real + stretch.imag))]]
    start, end = (complex(spot) for spot in (ends if ends[0] != ends[1] else stretch[[0, -1]]))
    if _lies_on(stretch, [np.array([start, end])], within):
        return Line(start, end, style)
    closed = bool(abs(stretch[0] - stretch[-1]) < STILL)
    return Polyline(tuple(complex(spot) for spot in (stretch[:-1] if closed else stretch)), closed, style)
