"""Numbers of positions, on the crank circle and along the output's path (нумерация положений)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.pushing import aside
from drawings.figures.linkage.skeleton import Poses, Skeletons
from drawings.layout.labels import Labels
from drawings.layout.place import Place
from drawings.layout.thinning import numbered
from drawings.lettering.lettering import text_width
from drawings.lettering.words import number
from drawings.paper.hand import Hand
from drawings.paper.strokes import Stroke, Text
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME

UNEVEN = 1e-6  # rad: steps of a turn in equal parts differ by roundings alone
SAME = 1e-9  # rad: a position and an extreme whose crank directions differ by less are one
CRANK_GAP, PATH_GAP = 1.2, 1.8  # mm from a place to its number
BARRED = 2.5  # mm of hatching outside the crank circle
RING = 1.6  # sizes of a number from one ring of numbers to the next
APART = 1.1  # heights or widths of a number between two that stand side by side
STEPS = (1, 2, 3, 4, 6, 12)  # every which position may bear a number at the output
MOST = 0.3  # share of the numbers chosen that may fall out where places crowd at the ends of a stroke
ANGLES = 12  # positions of a list whose crank angles still have room beside their numbers


class NumberedPlace(NamedTuple):
    """A place that bears a number: which poses it is of, its column there, the number, and if it is an extreme."""

    poses: Poses
    column: int
    name: str
    extreme: bool


def same(bones: Skeletons, extreme: int) -> int | None:
    """Give the scene's own position that an extreme is, if it is one."""
    travel = bones.study.travel
    assert travel is not None  # asked only where there are extremes
    apart = np.abs(bones.study.turn.directions - travel.directions[extreme])
    best = int(np.argmin(apart))
    return best if apart[best] < SAME else None


def numbered_places(bones: Skeletons) -> list[NumberedPlace]:
    """List what bears a number: every position, and each extreme that falls between two, as k'."""
    own = {same(bones, k) for k in range(2)} if bones.extremes else set()
    places = [NumberedPlace(bones.numbered, k, str(k), k in own) for k in range(len(bones.numbered))]
    for k in range(2) if bones.extremes else ():
        assert bones.study.travel is not None and bones.extremes is not None
        if same(bones, k) is None:
            phi, turn = bones.study.travel.extremes.phi[k], 2 * np.pi
            before = int(np.argmin(np.mod(bones.study.sense * (phi - bones.study.turn.phi), turn)))
            name = f"{before}'"
            taken = any(name == other.name for other in places)
            places.append(NumberedPlace(bones.extremes, k, f"{name}'" if taken else name, True))
    return places


def numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number every position outside the crank circle, and at the output as many as stand legibly."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    places = numbered_places(bones)
    yield from _crank_numbers(pairs, places, labels)
    tip = output_point(bones)
    if tip is not None:
        spots = [place.on(complex(one.poses.points[tip][one.column])) for one in places]
        for k in legible(bones, places, spots, hand):
            angle, more = _outward(bones, places[k], spots[k], place)
            gap = (pairs.clear(tip) if _is_shown(bones, places[k]) else 0.0) + PATH_GAP + more * hand.number
            number = labels.free(spots[k], places[k].name, hand.number, gap, angle)
            yield from () if number is None else (number,)


def _is_shown(bones: Skeletons, one: NumberedPlace) -> bool:
    return one.poses is bones.numbered and one.column == bones.shown


def _crank_numbers(pairs: Pairs, places: list[NumberedPlace], labels: Labels) -> Iterator[Stroke]:
    """Number the crank circle; where they crowd, every other one stands further out, and of a tiny circle not all."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    end = bones.mechanism.drive.end
    texts = [_with_angle(bones, one) for one in places]
    wide = max(width(text, hand) for text in texts)
    every, further = _rings(bones, place, hand, wide)
    listed = _listed(bones, places, wide, place, hand)
    for one, text in zip(places, texts, strict=True):
        if not (one.extreme or _is_shown(bones, one) or (one.column % every == 0 and one.column in listed)):
            continue
        known = one.poses is bones.numbered
        spot = place.on(bones.drive_end(one.column) if known else complex(one.poses.points[end][one.column]))
        gap = CRANK_GAP + (pairs.clear(end) if _is_shown(bones, one) else 0.0)
        out = _off_path(bones, spot, place)
        gap += BARRED * hand.symbol if _in_barrier(out, bones) else 0.0
        gap += further if known and one.column // every % 2 else 0.0
        number = labels.free(spot, text, hand.number, gap, cmath.phase(out))
        yield from () if number is None else (number,)


def _rings(bones: Skeletons, place: Place, hand: Hand, wide: float) -> tuple[int, float]:
    """Give every which position is numbered on the crank circle, and how far out every other one of them stands."""
    if _uneven(bones):
        return 1, 0.0
    room = _round(bones, place, hand) / len(bones.numbered)
    every = next((step for step in STEPS if step * room >= APART * max(wide / 2, hand.number)), STEPS[-1])
    return every, RING * hand.number if every * room < APART * wide else 0.0


def _listed(bones: Skeletons, places: list[NumberedPlace], wide: float, place: Place, hand: Hand) -> tuple[int, ...]:
    """Give the positions that have room for their numbers outside the crank circle: of a long list not all have."""
    first = [one.column for one in places if one.poses is bones.numbered and (one.extreme or _is_shown(bones, one))]
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
    if not isinstance(listed, tuple) or one.poses is not bones.numbered or len(listed) > ANGLES:
        return one.name
    return f"{one.name} ({number(float(listed[one.column]), bones.study.scene.sheet.language)}°)"


def width(text: str, hand: Hand) -> float:
    """Give the width of a number."""
    return text_width(Text(0j, text, hand.number, "start", True))


def legible(bones: Skeletons, places: list[NumberedPlace], spots: list[complex], hand: Hand) -> list[int]:
    """Choose which numbers stand at the output: extremes always, the shown one, of the rest every so many as fit."""
    first = [k for k, one in enumerate(places) if one.extreme]
    first += [k for k, one in enumerate(places) if _is_shown(bones, one) and k not in first]
    first = [k for k in first if not math.isnan(spots[k].real)]
    chosen: list[int] = []
    for step in STEPS:
        rest = [k for k in range(0, len(bones.numbered), step) if k not in first and not math.isnan(spots[k].real)]
        chosen = _uncrowded(bones, first, rest, places, spots, hand)
        if len(chosen) - len(first) >= (1 - MOST) * len(rest):
            break
    return chosen


def _uncrowded(
    bones: Skeletons, first: list[int], rest: list[int], places: list[NumberedPlace], spots: list[complex], hand: Hand
) -> list[int]:
    """Keep of the rest what does not crowd what is kept already, on its own side of the path."""
    kept = list(first)
    for k in rest:
        side = _returning(bones, places[k])
        near = (
            other
            for other in kept
            if _returning(bones, places[other]) == side
            and _crowds(places[k], places[other], spots[k] - spots[other], hand)
        )
        if next(near, None) is None:
            kept.append(k)
    return kept


def _crowds(one: NumberedPlace, other: NumberedPlace, apart: complex, hand: Hand) -> bool:
    wide = APART * (width(one.name, hand) + width(other.name, hand)) / 2
    return abs(apart.real) < wide and abs(apart.imag) < 1.3 * APART * hand.number


def _returning(bones: Skeletons, one: NumberedPlace) -> bool:
    """Tell whether a place is passed on the return stroke; extremes belong to the stroke that begins there."""
    travel = bones.study.travel
    if travel is None or len(travel.rests) > 2:
        return False
    start, end = travel.extremes.phi
    if one.poses is not bones.numbered:
        return one.column == 1
    sense, turn = bones.study.sense, 2 * math.pi
    ahead = (sense * (bones.study.turn.phi[one.column] - start) + SAME) % turn
    return bool(ahead >= (sense * (end - start)) % turn)


def output_point(bones: Skeletons) -> str | None:
    """Give the point whose places on its path are numbered: the output's pin, or its end away from the frame."""
    mechanism, out = bones.mechanism, bones.study.output
    slide = frame_slide(mechanism, out.link)
    if slide is not None:
        return out.point or slide.point
    free = [name for name in mechanism.links[out.link].points if name not in mechanism.links[FRAME].points]
    chosen = out.point if out.point in free else free[-1] if free else None
    return chosen if out.link != mechanism.drive.link else None


def _outward(bones: Skeletons, one: NumberedPlace, spot: complex, place: Place) -> tuple[float, float]:
    """Direct a number away from its point's path: off a guide by the stroke, off an arc from its centre, else outward.

    The second number is how many sizes further off it stands: the return stroke has its own ring outside an arc.
    """
    mechanism, back = bones.mechanism, _returning(bones, one)
    slide = frame_slide(mechanism, bones.study.output.link)
    if slide is not None:
        up = slide.on_owner.direction * (1j if slide.on_owner.direction.real >= 0 else -1j)
        return cmath.phase(-up if back else up), 0.0
    fixed_points, tip = mechanism.links[FRAME].points, output_point(bones)
    own = [fixed_points[name] for name in mechanism.links[bones.study.output.link].points if name in fixed_points]
    if own:
        return cmath.phase(spot - place.on(own[0])), RING if back else 0.0
    known = [] if tip is None else [complex(value) for value in bones.way.points[tip] if not math.isnan(value.real)]
    middle = place.on(sum(known) / len(known)) if known else spot
    return cmath.phase(spot - middle) if spot != middle else math.pi / 2, 0.0
