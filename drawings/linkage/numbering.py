"""Numbers of positions on the crank circle, along the output's path and every other slider's (нумерация положений)."""

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.layout.labels import Labels, Lines
from drawings.layout.parallel_offsets import nearest
from drawings.layout.picture import Place
from drawings.lettering.lettering import TOGETHER, numbered, text_width
from drawings.lettering.words import number
from drawings.linkage.guides import aside
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.page.page import Scale, page_of
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Polyline, Stroke, Text
from drawings.symbols import symbols
from plans.linkage.primary import PRIMARIES, CrankPositions, pushed
from plans.linkage.travel import ExtremePositions, frame_slide
from plans.model.mechanism import FRAME, Slide, output_way
from plans.model.motion import Complexes


def stroke_line(bones: Skeletons, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the slider's stroke with a tick at every position; cross those that the mechanism does not reach."""
    ends = [place.on(bones.drive_end(k)) for k in range(len(bones.numbered))]
    along = pushed(bones.mechanism).way(FRAME).direction
    ticks: list[Stroke] = [symbols.tick(end, along, hand) for end in ends]
    lost = [arm for end, gone in zip(ends, bones.study.lost, strict=True) if gone for arm in symbols.cross(end, hand)]
    return [Line(ends[0], ends[-1], hand.drafted), *ticks, *lost]


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


class NumberedTrack(NamedTuple):
    """A point whose places are numbered: along its guide if it slides on the frame, its strokes, the places."""

    point: str
    slide: Slide | None
    travel: ExtremePositions | None
    places: tuple[NumberedPlace, ...]


def same(bones: Skeletons, extreme: int) -> int | None:
    """Give the scene's own position that an extreme of the output is, if it is one."""
    travel = bones.study.travel
    assert travel is not None  # asked only where there are extremes
    return _number(bones, travel.directions[extreme])


def _number(bones: Skeletons, direction: complex) -> int | None:
    apart = np.abs(bones.study.turn.directions - direction)
    best = int(np.argmin(apart))
    return best if apart[best] < SAME else None


def output_point(bones: Skeletons) -> str | None:
    """Give the point whose places on its path are numbered: the output's pin, or its end away from the frame."""
    mechanism, out = bones.mechanism, bones.study.output
    if (counted := output_way(mechanism, out)) is not None:
        return counted[0]
    free = [name for name in mechanism.links[out.link].points if name not in mechanism.links[FRAME].points]
    chosen = out.point if out.point in free else free[-1] if free else None
    return chosen if out.link != mechanism.drive.link else None


def crank_places(bones: Skeletons) -> tuple[NumberedPlace, ...]:
    """List what is numbered at the primary link: every position, and each extreme of a track that falls between two."""
    places = _turns(bones)
    for track in sliders(bones):
        places += [s for s in track.places if s.column is None and s.name not in {known.name for known in places}]
    extreme = {station.name for track in sliders(bones) for station in track.places if station.extreme}
    return tuple(station._replace(extreme=station.extreme or station.name in extreme) for station in places)


def _turns(bones: Skeletons) -> list[NumberedPlace]:
    """List the crank places of the positions and of the output's extremes."""
    nowhere = np.full(len(bones.numbered), np.nan + 0j)
    return list(_places(bones, bones.study.travel, nowhere, nowhere[:1].repeat(2), ()))


def output_track(bones: Skeletons) -> NumberedTrack | None:
    """Give the track of the output; none of one that has no point to show."""
    tip, travel = output_point(bones), bones.study.travel
    if tip is None:
        return None
    ends = (np.nan + 0j,) * 2 if bones.extremes is None else tuple(bones.extremes.points[tip].tolist())
    places = _places(bones, travel, bones.numbered.points[tip], ends, ())
    return NumberedTrack(tip, frame_slide(bones.mechanism, bones.study.output.link), travel, tuple(places))


def sliders(bones: Skeletons) -> Iterator[NumberedTrack]:
    """Give the tracks of the sliders on the frame besides the output."""
    taken = _turns(bones)
    for slide, travel in bones.strokes.items():
        way, spots = slide.way(FRAME), bones.numbered.points[slide.point]
        aside = 1j * float(np.nanmedian(((spots - way.through) * way.direction.conjugate()).imag))
        ends = [way.through + (reach + aside) * way.direction for reach in travel.extremes.reach]
        places = tuple(_places(bones, travel, spots, ends, taken))
        taken += [station for station in places if station.column is None]
        yield NumberedTrack(slide.point, slide, travel, places)


def _places(
    bones: Skeletons,
    travel: ExtremePositions | None,
    spots: Complexes,
    ends: Iterable[complex],
    taken: Iterable[NumberedPlace],
) -> Iterator[NumberedPlace]:
    """Number positions by their order, and extremes between two of them as k', those of one crank position alike."""
    found = [] if travel is None else [_number(bones, direction) for direction in travel.directions]
    for k, spot in enumerate(spots.tolist()):
        yield NumberedPlace(str(k), k, k in found, _returning(bones, travel, k), bones.drive_end(k), spot)
    known = {station.name: station.crank for station in taken}
    for which, (column, spot) in enumerate(zip(found, ends, strict=False)):
        if column is None and travel is not None:
            turn = CrankPositions(np.array(travel.extremes.phi), np.array(travel.directions))
            crank = complex(PRIMARIES[bones.mechanism.drive.kind].ends(bones.mechanism, turn)[which])
            name = _named(bones, travel.extremes.phi[which], crank, known)
            known[name] = crank
            yield NumberedPlace(name, None, True, which == 1, crank, spot)


def _named(bones: Skeletons, phi: float, crank: complex, known: dict[str, complex]) -> str:
    """Name an extreme after the position before it, with a prime for each other crank position that has the name."""
    before = int(np.argmin(np.mod(bones.study.sense * (phi - bones.study.turn.phi), 2 * np.pi)))
    name = f"{before}'"
    while name in known and not abs(known[name] - crank) <= SAME * abs(crank - known[name] + bones.reach):
        name += "'"
    return name


def _returning(bones: Skeletons, travel: ExtremePositions | None, k: int) -> bool:
    if travel is None or len(travel.rests) > 2:
        return False
    (start, end), sense, turn = travel.extremes.phi, bones.study.sense, 2 * np.pi
    ahead = (sense * (bones.study.turn.phi[k] - start) + SAME) % turn
    return bool(ahead >= (sense * (end - start)) % turn)


UNEVEN = 1e-6  # rad: steps of a turn in equal parts differ by roundings alone
CRANK_GAP, PATH_GAP = 1.2, 1.8  # mm from a place to its number
BARRED = 2.5  # mm of hatching outside the crank circle
RING = 1.6  # sizes of a number from one ring of numbers to the next
APART = 1.1  # heights or widths of a number between two that stand side by side
STEPS = (1, 2, 3, 4, 6, 12)  # every which position may bear a number at the output
MOST = 0.3  # share of the numbers chosen that may fall out where places crowd at the ends of a stroke
SHRUNK = (0.2, 0.5, 0.8)  # outlines within that of a block, as shares of it, by which it is felt
ANGLES = 12  # positions of a list whose crank angles still have room beside their numbers


def numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number every position outside the crank circle, at the output and each slider as many as stand legibly."""
    labels.ink.draw(_within(block.points) for _, block in pairs.blocks)
    yield from () if apart(pairs.bones) else crank_numbers(pairs, labels)
    for track in _tracks(pairs.bones):
        yield from _track_numbers(pairs, track, labels)


def _within(outline: Sequence[complex]) -> Stroke:
    """Run to and fro within a block, so that no number has room there: it would be read as that of the link."""
    middle = sum(outline) / len(outline)
    return Polyline(tuple(middle + share * (spot - middle) for share in SHRUNK for spot in outline), True)


def _tracks(bones: Skeletons) -> Iterator[NumberedTrack]:
    output = output_track(bones)
    yield from [output] if output else []
    yield from sliders(bones)


def lone(spot: complex, pairs: Pairs) -> bool:
    """Tell whether a place on paper is so far from all crank places and tracks that its number joins no row of theirs.

    Between them is room for the numbers of both, each with its gap; of a guide also between two of its places.
    """
    rows = [(station.crank, station.crank) for station in crank_places(pairs.bones)]
    rows += [piece for track in _tracks(pairs.bones) for piece in _row(track)]
    far, on = 2 * (PATH_GAP + pairs.hand.number), pairs.place.on
    return not any(abs(spot - nearest(on(start), on(end), spot)) < far for start, end in rows)


def _row(track: NumberedTrack) -> Lines:
    """Give where the numbers of a track stand: all along its guide, or at its places, m."""
    spots = [station.spot for station in track.places if not math.isnan(station.spot.real)]
    if track.slide is None:
        return [(spot, spot) for spot in spots]
    guide = track.slide.way(FRAME).direction.conjugate()
    return [(min(spots, key=lambda spot: (spot * guide).real), max(spots, key=lambda spot: (spot * guide).real))]


def _track_numbers(pairs: Pairs, track: NumberedTrack, labels: Labels) -> Iterator[Stroke]:
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    for station in legible(bones, track, place, hand):
        spot = place.on(station.spot)
        angle, more = _outward(bones, track, station, place)
        clear, shown = pairs.clear(track.point), [s.spot for s in track.places if _is_shown(bones, s)]
        gap = PATH_GAP + (clear if any(abs(place.on(under) - spot) < clear for under in shown) else 0.0)
        others = _ticks(track, station, place, hand)
        number = labels.free(spot, station.name, hand.number, gap, angle, others, ring=more * hand.number)
        yield from () if number is None else (number,)


def _ticks(track: NumberedTrack, station: NumberedPlace, place: Place, hand: Hand) -> Lines:
    """Give the other ticks along a track: a number is nearest to its own, or led to it."""
    own, others = place.on(station.spot), [place.on(other.spot) for other in track.places]
    return [(other, other) for other in others if abs(other - own) > TOGETHER * hand.number]


def _is_shown(bones: Skeletons, station: NumberedPlace) -> bool:
    return station.column == bones.shown


TINY, SHARE = 15.0, 0.7  # mm: of a smaller crank circle the numbers are not told apart; of a sheet, what a plan takes


def apart(bones: Skeletons) -> bool:
    """Tell whether the crank's circle is so small beside its mechanism that it is numbered on a detail of its own."""
    if bones.mechanism.drive.pushed:
        return False
    field, points = page_of(bones.study.scene, "kinematics").field, np.array(bones.points)
    mu = max(np.ptp(points.real) / field.width, np.ptp(points.imag) / field.height) / SHARE
    return bool(bones.crank(Place(0j, 0j, Scale(mu, "l", "m"))) < TINY)


def crank_numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number the crank circle; where they crowd, every other one stands further out, and of a tiny circle not all."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    places, end = crank_places(bones), bones.mechanism.drive.end
    texts = [_with_angle(bones, station) for station in places]
    wide = max(width(text, hand) for text in texts)
    every, further = _rings(bones, place, hand, wide)
    listed = _listed(bones, places, wide, place, hand)
    for station, text in zip(places, texts, strict=True):
        in_column = station.column is not None and station.column % every == 0 and station.column in listed
        if not (station.extreme or _is_shown(bones, station) or in_column):
            continue
        spot = place.on(station.crank)
        gap = CRANK_GAP + (pairs.clear(end) if _is_shown(bones, station) else 0.0)
        # Direct a number away from the crank's pivot, or off the guide of a slider that drives.
        out = aside(bones) if bones.mechanism.drive.pushed else spot - bones.pivot(place)
        gap += BARRED * hand.symbol if _in_barrier(out, bones) else 0.0
        ring = further if station.column is not None and station.column // every % 2 else 0.0
        number = labels.free(spot, text, hand.number, gap, cmath.phase(out), ring=ring)
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
    first = [s.column for s in places if s.column is not None and (s.extreme or _is_shown(bones, s))]
    ends = [place.on(bones.drive_end(k)) for k in range(len(bones.numbered))]
    around, off = _round(bones, place, hand), APART * max(wide / 2, hand.number)
    return numbered(ends, around, off, first) if _uneven(bones) else tuple(range(len(ends)))


def _uneven(bones: Skeletons) -> bool:
    """Tell whether positions stand as the scene lists their angles, or as characteristic ones fall."""
    apart = np.diff(bones.study.turn.phi)
    return bool(isinstance(bones.study.form.drive.positions, tuple) or (apart.size and np.ptp(apart) > UNEVEN))


def _round(bones: Skeletons, place: Place, hand: Hand) -> float:
    """Give the length mm that the numbers of the primary link stand along: round its circle, or along its stroke."""
    if bones.mechanism.drive.pushed:
        return abs(place.on(bones.drive_end(-1)) - place.on(bones.drive_end(0)))
    return 2 * math.pi * (bones.crank(place) + CRANK_GAP + hand.number / 2)


def _in_barrier(ray: complex, bones: Skeletons) -> bool:
    """Tell whether a number stands where the crank's circle is hatched; a stroke is not."""
    turn = 2 * math.pi
    barriers = () if bones.mechanism.drive.pushed else bones.study.met
    return any((cmath.phase(ray) - b.start) % turn <= b.end - b.start for b in barriers)


def _with_angle(bones: Skeletons, station: NumberedPlace) -> str:
    """Write a position's number, and its crank angle where the scene lists the angles."""
    listed = bones.study.form.drive.positions
    if not isinstance(listed, tuple) or station.column is None or len(listed) > ANGLES:
        return station.name
    return f"{station.name} ({number(float(listed[station.column]), bones.study.scene.sheet.language)}°)"


def width(text: str, hand: Hand) -> float:
    """Give the width of a number."""
    return text_width(Text(0j, text, hand.number, "start", True))


def legible(bones: Skeletons, track: NumberedTrack, place: Place, hand: Hand) -> list[NumberedPlace]:
    """Choose which numbers stand along a track: extremes always, the shown one, of the rest every so many as fit.

    Where every one is chosen, those that crowd come last, or with the number of the place that they fall together with.
    """
    known = [station for station in track.places if not math.isnan(station.spot.real)]
    first = [station for station in known if station.extreme]
    first += [station for station in known if _is_shown(bones, station) and station not in first]
    chosen, rest = list[NumberedPlace](), list[NumberedPlace]()
    for step in STEPS:
        rest = [s for s in known if s not in first and s.column is not None and s.column % step == 0]
        chosen = _uncrowded(first, rest, place, hand)
        if len(chosen) - len(first) >= (1 - MOST) * len(rest):
            break
    if len(rest) + len(first) == len(known):
        for station in (station for station in rest if station not in chosen):
            _join(station, chosen, place, hand)
    return chosen


def _join(station: NumberedPlace, chosen: list[NumberedPlace], place: Place, hand: Hand) -> None:
    """Add a place to those that are numbered, or its number to that of the place that it falls together with."""
    for k, other in enumerate(chosen):
        apart = abs(place.on(station.spot) - place.on(other.spot))
        if other.back == station.back and apart < TOGETHER * hand.number:
            names = sorted((*other.name.split(", "), station.name), key=lambda name: (int(name.rstrip("'")), name))
            chosen[k] = other._replace(name=", ".join(names))
            return
    chosen.append(station)


def _uncrowded(first: list[NumberedPlace], rest: list[NumberedPlace], place: Place, hand: Hand) -> list[NumberedPlace]:
    """Keep of the rest what does not crowd what is kept already, on its own side of the path."""
    kept = list(first)
    for station in rest:
        if not any(other.back == station.back and _crowds(station, other, place, hand) for other in kept):
            kept.append(station)
    return kept


def _crowds(station: NumberedPlace, other: NumberedPlace, place: Place, hand: Hand) -> bool:
    wide = APART * (width(station.name, hand) + width(other.name, hand)) / 2
    apart = place.on(station.spot) - place.on(other.spot)
    return abs(apart.real) < wide and abs(apart.imag) < 1.3 * APART * hand.number


def _outward(bones: Skeletons, track: NumberedTrack, station: NumberedPlace, place: Place) -> tuple[float, float]:
    """Direct a number away from its point's path: off a guide, off an arc by rings (in sizes), else outward."""
    if track.slide is not None:
        way = track.slide.way(FRAME).direction
        up = way * (1j if way.real >= 0 else -1j)
        return cmath.phase(-up if station.back else up), 0.0
    links, spot = bones.mechanism.links, place.on(station.spot)
    pivots = [links[FRAME].points[n] for n in links[bones.study.output.link].points if n in links[FRAME].points]
    if pivots:
        return cmath.phase(spot - place.on(pivots[0])), RING if station.back else 0.0
    known = [complex(value) for value in bones.way.points[track.point] if not math.isnan(value.real)]
    middle = place.on(sum(known) / len(known)) if known else spot
    return cmath.phase(spot - middle) if spot != middle else math.pi / 2, 0.0
