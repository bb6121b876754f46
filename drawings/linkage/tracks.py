"""Tracks of numbered places: of the output on its path, of every other slider along its guide (нумерация положений)."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from drawings.layout.picture import Place
from drawings.linkage.guides import BESIDE, THICK, Turning, felt, senses, turnings
from drawings.linkage.pairs import Pairs
from drawings.linkage.skeleton import Skeletons
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols import symbols
from drawings.symbols.symbols import arrowhead
from plans.linkage.primary import PRIMARIES, CrankPositions
from plans.linkage.travel import ExtremePositions, frame_slide
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes

LENGTH = 14.0  # mm of an arrow
OFFS = (9.0, 12.0, 16.0, 21.0, 27.0)  # mm from the guide to an arrow


class Push(NamedTuple):
    """An arrow beside the slider's guide, with the letter of what it shows."""

    letter: str
    start: complex
    end: complex
    side: complex  # unit vector away from the guide

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arrow, and the direction away from the guide there."""
        return (self.start + self.end) / 2, cmath.phase(self.side)

    @property
    def room(self) -> list[Stroke]:
        """Lines along it and on either side: what they cross comes too near."""
        offs = (k * BESIDE * self.side for k in (-1, 0, 1, 2, 3))
        return [Line(self.start + off, self.end + off) for off in offs]

    def strokes(self, pairs: Pairs) -> tuple[Stroke, ...]:
        """Draw it."""
        head = arrowhead(self.start, self.end, pairs.hand.symbol)
        return Line(self.start, self.end, pairs.hand.other), *(() if head is None else (head,))


def pushed(mechanism: Mechanism) -> Slide:
    """Give the slide that is pushed along."""
    slide = mechanism.drive.guide
    assert slide is not None  # asked only where one is
    return slide


def stroke_line(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the slider's stroke with a tick at every position; cross those that the mechanism does not reach."""
    ends = [place.on(bones.drive_end(k)) for k in range(len(bones.numbered))]
    along = pushed(bones.mechanism).way(FRAME).direction
    ticks: list[Stroke] = [symbols.tick(end, along, hand) for end in ends]
    lost = [arm for end, gone in zip(ends, bones.study.lost, strict=True) if gone for arm in symbols.cross(end, hand)]
    return [Line(ends[0], ends[-1], hand.drafted), *ticks, *lost]


def aside(bones: Skeletons) -> complex:
    """Give the unit direction off the slider's guide to the side where the mechanism is not."""
    line = pushed(bones.mechanism).way(FRAME)
    offs = [((spot - line.through) * line.direction.conjugate()).imag for spot in bones.points]
    return line.direction * (-1j if max(offs) + min(offs) >= 0 else 1j)


def arrows(pairs: Pairs) -> tuple[Turning | Push, ...]:
    """Give the arrows of how the primary link moves: it turns, or it is pushed along."""
    return pushes(pairs) if pairs.bones.mechanism.drive.pushed else turnings(pairs)


@lru_cache(maxsize=1)  # the figure draws the arrows, and later their letters stand beside them
def pushes(pairs: Pairs) -> tuple[Push, ...]:
    """Place the arrow of the slider's velocity where it crosses the fewest lines, and that of its acceleration."""
    ink, arrows = felt(pairs), list[Push]()
    for symbol, sense in senses("va", pairs.bones):
        places = _candidates(f"{symbol}_{pushed(pairs.bones.mechanism).point}", sense, pairs)
        arrows.append(min(places, key=lambda push: ink.crossed_by(push.room)))
        ink.draw(arrows[-1].room, THICK)
    return tuple(arrows)


def _candidates(letter: str, sense: int, pairs: Pairs) -> Iterator[Push]:
    """Give the places of an arrow beside the shown block, the nearest to it first."""
    bones, factor = pairs.bones, pairs.hand.symbol
    along, away = pushed(bones.mechanism).way(FRAME).direction, aside(bones)
    spot = pairs.place.on(bones.drive_end(bones.shown))
    for off in OFFS:
        for side in (away, -away):
            for shift in (0.5, -0.5, 1.5, -1.5):
                middle = spot + (off * side + shift * LENGTH * along) * factor
                half = along * sense * LENGTH / 2 * factor
                yield Push(letter, middle - half, middle + half, side)


SAME = 1e-6  # rad: a position and an extreme that differ by less are one: no paper tells them apart


class NumberedPlace(NamedTuple):
    """A place that bears a number: its column among the scene's positions, none of an extreme between two of them.

    `crank` and `spot` are where the primary link's end and the track's point are, m; `back` is the return stroke.
    """

    name: str
    column: int | None
    extreme: bool
    back: bool
    crank: complex
    spot: complex


class Track(NamedTuple):
    """A point whose places are numbered: along its guide if it slides on the frame, its strokes, the places."""

    point: str
    slide: Slide | None
    travel: ExtremePositions | None
    places: tuple[NumberedPlace, ...]


def same(bones: Skeletons, extreme: int) -> int | None:
    """Give the scene's own position that an extreme of the output is, if it is one."""
    travel = bones.study.travel
    assert travel is not None  # asked only where there are extremes
    return _own(bones, travel.directions[extreme])


def _own(bones: Skeletons, direction: complex) -> int | None:
    apart = np.abs(bones.study.turn.directions - direction)
    best = int(np.argmin(apart))
    return best if apart[best] < SAME else None


def output_point(bones: Skeletons) -> str | None:
    """Give the point whose places on its path are numbered: the output's pin, or its end away from the frame."""
    mechanism, out = bones.mechanism, bones.study.output
    slide = frame_slide(mechanism, out.link)
    if slide is not None:
        return out.point or slide.point
    free = [name for name in mechanism.links[out.link].points if name not in mechanism.links[FRAME].points]
    chosen = out.point if out.point in free else free[-1] if free else None
    return chosen if out.link != mechanism.drive.link else None


def crank_places(bones: Skeletons) -> tuple[NumberedPlace, ...]:
    """List what is numbered at the primary link: every position, and each extreme of a track that falls between two."""
    nowhere = np.full(len(bones.numbered), np.nan + 0j)
    places = list(_places(bones, bones.study.travel, nowhere, (nowhere[0], nowhere[0]), ()))
    for track in sliders(bones):
        places += [one for one in track.places if one.column is None and one.name not in {own.name for own in places}]
    extreme = {one.name for track in sliders(bones) for one in track.places if one.extreme}
    return tuple(one._replace(extreme=one.extreme or one.name in extreme) for one in places)


def output_track(bones: Skeletons) -> Track | None:
    """Give the track of the output; none of one that has no point to show."""
    tip, travel = output_point(bones), bones.study.travel
    if tip is None:
        return None
    ends = (np.nan + 0j,) * 2 if bones.extremes is None else tuple(bones.extremes.points[tip].tolist())
    places = _places(bones, travel, bones.numbered.points[tip], ends, ())
    return Track(tip, frame_slide(bones.mechanism, bones.study.output.link), travel, tuple(places))


def sliders(bones: Skeletons) -> Iterator[Track]:
    """Give the tracks of the sliders on the frame besides the output."""
    nowhere = np.full(len(bones.numbered), np.nan + 0j)
    taken = list(_places(bones, bones.study.travel, nowhere, (nowhere[0], nowhere[0]), ()))
    for slide, travel in bones.strokes.items():
        way, spots = slide.way(FRAME), bones.numbered.points[slide.point]
        aside = 1j * float(np.nanmedian(((spots - way.through) * way.direction.conjugate()).imag))
        ends = [way.through + (reach + aside) * way.direction for reach in travel.extremes.reach]
        places = tuple(_places(bones, travel, spots, ends, taken))
        taken += [one for one in places if one.column is None]
        yield Track(slide.point, slide, travel, places)


def _places(
    bones: Skeletons,
    travel: ExtremePositions | None,
    spots: Complexes,
    ends: Iterable[complex],
    taken: Iterable[NumberedPlace],
) -> Iterator[NumberedPlace]:
    """Number positions by their order, and extremes between two of them as k', those of one crank position alike."""
    found = [] if travel is None else [_own(bones, direction) for direction in travel.directions]
    for k, spot in enumerate(spots.tolist()):
        yield NumberedPlace(str(k), k, k in found, _returning(bones, travel, k), bones.drive_end(k), spot)
    known = {one.name: one.crank for one in taken}
    for which, (own, spot) in enumerate(zip(found, ends, strict=False)):
        if own is None and travel is not None:
            crank = _crank(bones, travel, which)
            name = _named(bones, travel.extremes.phi[which], crank, known)
            known[name] = crank
            yield NumberedPlace(name, None, True, which == 1, crank, spot)


def _crank(bones: Skeletons, travel: ExtremePositions, which: int) -> complex:
    turn = CrankPositions(np.array(travel.extremes.phi), np.array(travel.directions))
    return complex(PRIMARIES[bones.mechanism.drive.kind].ends(bones.mechanism, turn)[which])


def _named(bones: Skeletons, phi: float, crank: complex, known: dict[str, complex]) -> str:
    """Name an extreme after the position before it, with a prime for each other crank position that has the name."""
    before = int(np.argmin(np.mod(bones.study.sense * (phi - bones.study.turn.phi), 2 * np.pi)))
    name = f"{before}'"
    while name in known and not abs(known[name] - crank) <= SAME * abs(crank - known[name] + bones.reach):
        name += "'"
    return name


def _returning(bones: Skeletons, travel: ExtremePositions | None, k: int) -> bool:
    """Tell whether a position is passed on the return stroke."""
    if travel is None or len(travel.rests) > 2:
        return False
    (start, end), sense, turn = travel.extremes.phi, bones.study.sense, 2 * np.pi
    ahead = (sense * (bones.study.turn.phi[k] - start) + SAME) % turn
    return bool(ahead >= (sense * (end - start)) % turn)
