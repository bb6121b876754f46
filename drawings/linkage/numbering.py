"""Numbers of positions, on the crank circle and along the output's path (нумерация положений)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.layout.ink import LETTERED
from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.extent import bounds, numbered
from drawings.lettering.lettering import text_width
from drawings.lettering.words import number
from drawings.linkage.pairs import Joints, Pairs
from drawings.linkage.skeleton import Skeletons
from drawings.linkage.tracks import NumberedPlace, Track, aside, crank_places, output_track, sliders
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Box, Circle, Group, Line, Stroke, Text
from drawings.symbols.symbols import BLOCK
from plans.model.mechanism import FRAME

SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78)  # where along a bar its number may stand
OFFS = (0.6, 2.0, 4.0, 7.0, 11.0, 16.0, 22.0, 30.0, 40.0, 55.0)  # mm between a bar and the circle
BESIDE = 2.0  # mm: from further off a leader leads to the link
DOT = 0.5  # mm, radius of the dot that a leader ends with on its link
ROUND = 0.85  # radius of the circle, in sizes of its number: of two digits it is wider
DIRECTIONS = 16


class NumberPlace(NamedTuple):
    """A place for a number: the middle of its circle, the place of the link that it is for, mm between them."""

    middle: complex
    foot: complex
    off: float


def link_numbers(joints: Joints, links: list[int], labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Number the links where the lines of all figures leave room."""
    for link in links:
        spots = [spot for spot in _spots(joints, link, hand) if not cmath.isnan(spot.middle)]
        yield from (_number(str(link), spots, labels, hand),) if spots else ()


def frame_number(joints: Joints, labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Number the frame beside the stand of the drive's hinge, or of the first that has one."""
    fixed_points, drive = joints.bones.mechanism.links[FRAME].points, joints.bones.mechanism.drive
    hinges = sorted((name for name in fixed_points if name in joints.hinges), key=lambda name: name != drive.pivot)
    if hinges:
        bases = [line for line in joints.stand(hinges[0]) if isinstance(line, Line)]
        spots = [spot for line in bases[2:3] for spot in _around((line.start + line.end) / 2, FRAME, 0.0, hand)]
        yield _number(str(FRAME), spots, labels, hand)


def _spots(joints: Joints, link: int, hand: Hand) -> Iterator[NumberPlace]:
    """Give the places beside a link, the nearest first; beside a block where the link is no more than one."""
    radius = _radius(str(link), hand)
    outlines = (outline for outline in joints.outlines if outline.link == link)
    bars = [bar for outline in outlines for bar in joints.placed(outline) if abs(bar[1] - bar[0]) > 4 * radius]
    if not bars:
        yield from _around(_middle(joints, link), link, abs(complex(*BLOCK)) / 2 * joints.hand.symbol, hand)
    for off in OFFS if bars else ():
        for share in SHARES:
            for start, end in bars:
                across, foot = 1j * (end - start) / abs(end - start), start + share * (end - start)
                yield from (NumberPlace(foot + side * across * (radius + off), foot, off) for side in (1, -1))


def _around(foot: complex, link: int, clear: float, hand: Hand) -> Iterator[NumberPlace]:
    """Give the places round a spot that is kept clear so far."""
    for off in OFFS:
        reach = clear + _radius(str(link), hand) + off
        turns = (2 * math.pi * (k + 0.5) / DIRECTIONS for k in range(DIRECTIONS))
        yield from (NumberPlace(foot + cmath.rect(reach, turn), foot, off) for turn in turns)


def _middle(joints: Joints, link: int) -> complex:
    bones = joints.bones
    spots = bones.mechanism.links[link].points.values()
    places = [joints.place.on(complex(bones.numbered.of(link, spot)[bones.shown])) for spot in spots]
    return sum(places) / len(places)


def _radius(content: str, hand: Hand) -> float:
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    return max(ROUND * hand.text, abs(complex(right - left, top - bottom)) / 2 + 0.15 * hand.text)


def _number(content: str, spots: list[NumberPlace], labels: Labels, hand: Hand) -> Stroke:
    """Draw a number in its circle at the first free place, with a leader where that is not beside its link."""
    radius = _radius(content, hand)

    def covered(spot: NumberPlace) -> int:
        through = labels.ink.along(spot.middle, spot.foot) // LETTERED if spot.off > BESIDE else 0
        return labels.ink.under(_square(spot.middle, radius + 0.4)) + through

    spot = next((spot for spot in spots if not covered(spot)), None) or min(spots, key=covered)
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    text = Text(spot.middle - complex(left + right, bottom + top) / 2, content, hand.text, "middle")
    led = _leader(spot, radius, hand) if spot.off > BESIDE else ()
    group = Group((Circle(spot.middle, radius, hand.other), text, *led), "", {}, content)
    labels.ink.draw([group])
    return group


def _leader(spot: NumberPlace, radius: float, hand: Hand) -> tuple[Stroke, ...]:
    """Lead from a circle's rim to a dot on its link."""
    rim = spot.middle + (spot.foot - spot.middle) / abs(spot.foot - spot.middle) * radius
    return Line(rim, spot.foot, hand.drafted), Circle(spot.foot, DOT * hand.symbol, INK)


def _square(middle: complex, half: float) -> Box:
    return middle.real - half, middle.imag - half, middle.real + half, middle.imag + half


UNEVEN = 1e-6  # rad: steps of a turn in equal parts differ by roundings alone
CRANK_GAP, PATH_GAP = 1.2, 1.8  # mm from a place to its number
BARRED = 2.5  # mm of hatching outside the crank circle
RING = 1.6  # sizes of a number from one ring of numbers to the next
APART = 1.1  # heights or widths of a number between two that stand side by side
STEPS = (1, 2, 3, 4, 6, 12)  # every which position may bear a number at the output
MOST = 0.3  # share of the numbers chosen that may fall out where places crowd at the ends of a stroke
ANGLES = 12  # positions of a list whose crank angles still have room beside their numbers


def numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number every position outside the crank circle, at the output and each slider as many as stand legibly."""
    yield from _crank_numbers(pairs, labels)
    own = output_track(pairs.bones)
    for track in (*([own] if own else []), *sliders(pairs.bones)):
        yield from _track_numbers(pairs, track, labels)


def _track_numbers(pairs: Pairs, track: Track, labels: Labels) -> Iterator[Stroke]:
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    for one in legible(bones, track, place, hand):
        spot = place.on(one.spot)
        angle, more = _outward(bones, track, one, place)
        gap = (pairs.clear(track.point) if _is_shown(bones, one) else 0.0) + PATH_GAP + more * hand.number
        number = labels.free(spot, one.name, hand.number, gap, angle)
        yield from () if number is None else (number,)


def _is_shown(bones: Skeletons, one: NumberedPlace) -> bool:
    return one.column == bones.shown


def _crank_numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number the crank circle; where they crowd, every other one stands further out, and of a tiny circle not all."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    places, end = crank_places(bones), bones.mechanism.drive.end
    texts = [_with_angle(bones, one) for one in places]
    wide = max(width(text, hand) for text in texts)
    every, further = _rings(bones, place, hand, wide)
    listed = _listed(bones, places, wide, place, hand)
    for one, text in zip(places, texts, strict=True):
        seen = one.column is not None and one.column % every == 0 and one.column in listed
        if not (one.extreme or _is_shown(bones, one) or seen):
            continue
        spot = place.on(one.crank)
        gap = CRANK_GAP + (pairs.clear(end) if _is_shown(bones, one) else 0.0)
        out = _off_path(bones, spot, place)
        gap += BARRED * hand.symbol if _in_barrier(out, bones) else 0.0
        gap += further if one.column is not None and one.column // every % 2 else 0.0
        number = labels.free(spot, text, hand.number, gap, cmath.phase(out))
        yield from () if number is None else (number,)


def _rings(bones: Skeletons, place: Place, hand: Hand, wide: float) -> tuple[int, float]:
    """Give every which position is numbered on the crank circle, and how far out every other one of them stands."""
    if _uneven(bones):
        return 1, 0.0
    room = _round(bones, place, hand) / len(bones.numbered)
    every = next((step for step in STEPS if step * room >= APART * max(wide / 2, hand.number)), STEPS[-1])
    return every, RING * hand.number if every * room < APART * wide else 0.0


def _listed(
    bones: Skeletons, places: Sequence[NumberedPlace], wide: float, place: Place, hand: Hand
) -> tuple[int, ...]:
    """Give the positions that have room for their numbers outside the crank circle: of a long list not all have."""
    first = [one.column for one in places if one.column is not None and (one.extreme or _is_shown(bones, one))]
    ends = [place.on(bones.drive_end(k)) for k in range(len(bones.numbered))]
    around = _round(bones, place, hand)
    return (
        numbered(ends, around, APART * max(wide / 2, hand.number), first) if _uneven(bones) else tuple(range(len(ends)))
    )


def _uneven(bones: Skeletons) -> bool:
    """Tell whether positions stand as the scene lists their angles, or as characteristic ones fall."""
    apart = np.diff(bones.study.turn.phi)
    return bool(isinstance(bones.study.form.drive.positions, tuple) or (apart.size and np.ptp(apart) > UNEVEN))


def _round(bones: Skeletons, place: Place, hand: Hand) -> float:
    """Give the length mm that the numbers of the primary link stand along: round its circle, or along its stroke."""
    if bones.mechanism.drive.pushed:
        return abs(place.on(bones.drive_end(-1)) - place.on(bones.drive_end(0)))
    return 2 * math.pi * (bones.crank(place) + CRANK_GAP + hand.number / 2)


def _off_path(bones: Skeletons, spot: complex, place: Place) -> complex:
    """Direct a number away from the crank's pivot, or off the guide of a slider that drives."""
    return aside(bones) if bones.mechanism.drive.pushed else spot - bones.pivot(place)


def _in_barrier(ray: complex, bones: Skeletons) -> bool:
    """Tell whether a number stands where the crank's circle is hatched; a stroke is not."""
    turn = 2 * math.pi
    barriers = () if bones.mechanism.drive.pushed else bones.study.met
    return any((cmath.phase(ray) - b.start) % turn <= b.end - b.start for b in barriers)


def _with_angle(bones: Skeletons, one: NumberedPlace) -> str:
    """Write a position's number, and its crank angle where the scene lists the angles."""
    listed = bones.study.form.drive.positions
    if not isinstance(listed, tuple) or one.column is None or len(listed) > ANGLES:
        return one.name
    return f"{one.name} ({number(float(listed[one.column]), bones.study.scene.sheet.language)}°)"


def width(text: str, hand: Hand) -> float:
    """Give the width of a number."""
    return text_width(Text(0j, text, hand.number, "start", True))


def legible(bones: Skeletons, track: Track, place: Place, hand: Hand) -> list[NumberedPlace]:
    """Choose which numbers stand along a track: extremes always, the shown one, of the rest every so many as fit."""
    known = [one for one in track.places if not math.isnan(one.spot.real)]
    first = [one for one in known if one.extreme]
    first += [one for one in known if _is_shown(bones, one) and one not in first]
    chosen: list[NumberedPlace] = []
    for step in STEPS:
        rest = [one for one in known if one not in first and one.column is not None and one.column % step == 0]
        chosen = _uncrowded(first, rest, place, hand)
        if len(chosen) - len(first) >= (1 - MOST) * len(rest):
            break
    return chosen


def _uncrowded(first: list[NumberedPlace], rest: list[NumberedPlace], place: Place, hand: Hand) -> list[NumberedPlace]:
    """Keep of the rest what does not crowd what is kept already, on its own side of the path."""
    kept = list(first)
    for one in rest:
        if not any(other.back == one.back and _crowds(one, other, place, hand) for other in kept):
            kept.append(one)
    return kept


def _crowds(one: NumberedPlace, other: NumberedPlace, place: Place, hand: Hand) -> bool:
    wide, apart = (
        APART * (width(one.name, hand) + width(other.name, hand)) / 2,
        place.on(one.spot) - place.on(other.spot),
    )
    return abs(apart.real) < wide and abs(apart.imag) < 1.3 * APART * hand.number


def _outward(bones: Skeletons, track: Track, one: NumberedPlace, place: Place) -> tuple[float, float]:
    """Direct a number away from its point's path: off a guide by the stroke, off an arc from its centre, else outward.

    The second number is how many sizes further off it stands: the return stroke has its own ring outside an arc.
    """
    if track.slide is not None:
        way = track.slide.way(FRAME).direction
        up = way * (1j if way.real >= 0 else -1j)
        return cmath.phase(-up if one.back else up), 0.0
    links, spot = bones.mechanism.links, place.on(one.spot)
    own = [links[FRAME].points[name] for name in links[bones.study.output.link].points if name in links[FRAME].points]
    if own:
        return cmath.phase(spot - place.on(own[0])), RING if one.back else 0.0
    known = [complex(value) for value in bones.way.points[track.point] if not math.isnan(value.real)]
    middle = place.on(sum(known) / len(known)) if known else spot
    return cmath.phase(spot - middle) if spot != middle else math.pi / 2, 0.0
