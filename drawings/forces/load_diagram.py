"""A load over its stroke, there and back: its course, and the figure of it (диаграмма нагрузки)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import pairwise
from string import ascii_lowercase
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.kinds.axes import OVER, UNDER, Axes, Letter
from drawings.kinds.graph import BESIDE, DOT, LEAST, Graph, GraphForm, standing
from drawings.kinds.vector_plan import SAME
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Spot
from drawings.lettering.lettering import numbered, spaced, text_width
from drawings.lettering.words import Slot, joined, telling
from drawings.lettering.words import letter as lettered
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Kind, Polyline, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension, Subject, heading
from drawings.symbols.symbols import arrowhead
from plans.forces.loading import OutputStroke, asks, size_of, working_of
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING, Force, Machine, Moment, Track
from plans.model.motion import Motion

Branch: TypeAlias = tuple[complex, ...]  # corners: way m or degrees + load N or N*m * i, in the order of the motion

STRAIGHT = 1e-3  # of the products whose difference is the bend: less than what a table of a diagram rounds away


class LoadCourse(NamedTuple):
    """A load over its stroke: how long that is, m or degrees, and the load on the working and on the idle stroke.

    A load against the motion is positive on the working stroke and negative on the idle one, any other one positive
    in its own direction. A stroke on which it rests has no branch. Of an indicator card the load is the pressure, MPa.
    """

    name: str
    turning: bool  # whether the stroke is that of a link that swings
    couple: bool  # whether the load is a moment
    length: float
    overrun: tuple[float, float]
    out: Branch
    back: Branch
    places: tuple[complex, ...] = ()  # way + load * i in each position of a scene, NaN at gaps
    returning: tuple[int, ...] = ()  # the positions of the idle stroke
    shown: tuple[int, ...] = ()  # those that always bear their numbers
    card: bool = False

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest load, zero among them."""
        sizes = [corner.imag for corner in (*self.out, *self.back)]
        return min(0.0, *sizes), max(0.0, *sizes)

    @property
    def higher(self) -> bool:
        """Whether the branch of the working stroke lies over the other: a gas that is compressed idly lies over it."""
        parts = [*pairwise(self.out), *pairwise(self.back)]
        return math.fsum((end - start).real * (start + end).imag for start, end in parts) >= 0

    @property
    def corners(self) -> tuple[complex, ...]:
        """The ends of branches and their bends where the load is not zero, each once: out, then back."""
        return tuple(dict.fromkeys(corner for corner in (*_bends(self.out), *_bends(self.back)) if corner.imag))


def _bends(branch: Branch) -> Iterator[complex]:
    for k, corner in enumerate(branch):
        if k in (0, len(branch) - 1):
            yield corner
            continue
        before, after = corner - branch[k - 1], branch[k + 1] - corner
        across, along = (before.conjugate() * after).imag, abs(before.real * after.imag) + abs(before.imag * after.real)
        if abs(across) > STRAIGHT * along or (before.conjugate() * after).real < 0:
            yield corner


def courses(
    machine: Machine, strokes: Mapping[Track, OutputStroke], motion: Motion | None = None
) -> Iterator[LoadCourse]:
    """Give the course of every load that changes over a stroke, with its places at the positions of a motion."""
    for load in machine.loads:
        if asks(load):
            bare = course_of(load, strokes[load.stroke])
            yield bare if motion is None else _placed(bare, load, strokes, motion)


def _placed(
    bare: LoadCourse, load: Force | Moment, strokes: Mapping[Track, OutputStroke], motion: Motion
) -> LoadCourse:
    stroke = strokes[load.stroke]
    back = ~working_of(load, stroke, motion)
    sense = np.where(back & _opposing(load), -1.0, 1.0)
    sizes = np.array([_stated(load, size) for size in (sense * size_of(load, motion, strokes) + 0.0).tolist()])
    places = bare.length * stroke.share(motion) + 1j * sizes
    return bare._replace(places=tuple(places.tolist()), returning=tuple(np.flatnonzero(back).tolist()))


def course_of(load: Force | Moment, stroke: OutputStroke) -> LoadCourse:
    """Give the course of a load over its stroke."""
    low, high = stroke.reach
    length = abs(high - low) if stroke.sliding else math.degrees(abs(high - low))
    out = tuple(_corners(load, length, False)) if load.during in (ALWAYS, WORKING, FORWARD) else ()
    back = tuple(reversed([*_corners(load, length, True)])) if load.during in (ALWAYS, IDLE, BACKWARD) else ()
    kinds = isinstance(load, Moment), length, load.overrun, out, back
    return LoadCourse(load.name, not stroke.sliding, *kinds, card=isinstance(load, Force) and load.card is not None)


def _stated(load: Force | Moment, size: float) -> float:
    card = load.card if isinstance(load, Force) else None
    return size if card is None else card.pressure(size)


def _corners(load: Force | Moment, length: float, idle: bool) -> Iterator[complex]:
    begin, end = load.overrun[0], 1 - load.overrun[1]
    sense = -1.0 if idle and _opposing(load) else 1.0
    if begin > 0:
        yield from (0j, complex(length * begin))
    travel = load.diagram.travel if isinstance(load, Force) and load.diagram is not None else ()
    for share in sorted({begin, end, *(place for place in travel if begin < place < end)}):
        yield complex(length * share, _stated(load, sense * _size(load, share, idle) + 0.0))
    if end < 1:
        yield from (complex(length * end), complex(length))


def _opposing(load: Force | Moment) -> bool:
    """Tell whether a load turns over with the motion."""
    if isinstance(load, Moment):
        return load.against
    return load.resists or (load.direction is None and load.line is None)


def _size(load: Force | Moment, share: float, idle: bool) -> float:
    if isinstance(load, Moment) or load.diagram is None:
        return load.size
    travel, there, back, *_ = load.diagram
    return load.size * float(np.interp(share, travel, back or there if idle else there))


NAME = "load_diagram"
FORM = GraphForm(1.3, 1.3, Margins(3.2, 1.6, 1.0), 12.0)
MOST = 20.0, 28.0  # sizes of a letter, its length at most: of a load, of an indicator card
LEVELS = (9.0, 17.0)  # mm under the diagram: the overruns, the whole stroke
FEW = 12  # corners that all are lettered a, b, c; of more those that have room
APART = 2.6  # sizes of a letter from one corner of many to the next
SPARE = 0.5  # sizes of a number that stay free between those of two positions
ABOVE = 1.2  # mm from a dimension line to its letters
DIGITS = 4
CARD = "p", "MPa"  # letter and unit of the ordinates of an indicator card
SLIDING, SWINGING = ("S", "m", "H"), ("ψ", "°", "ψ")  # letters of the way and of the whole stroke, unit of the way


def name_of(course: LoadCourse) -> str:
    """Name the figure of a load."""
    return f"{NAME}-{course.name}"


def marks(course: LoadCourse, hand: Hand) -> list[tuple[str, complex]]:
    """Letter the corners at their true places; of many those that the smallest diagram has room for."""
    corners, (low, high) = course.corners, course.span
    if len(corners) <= FEW:
        return [*zip(ascii_lowercase, corners, strict=False)]
    long = FORM.letters * hand.letter
    wide, tall = long / course.length, long / FORM.ratio / (high - low)
    places = [complex(wide * corner.real, tall * corner.imag) for corner in corners]
    kept = spaced(places, APART * hand.number, (0, len(corners) - 1, *range(len(corners))))
    return [*zip(ascii_lowercase, (corners[k] for k in sorted(kept)), strict=False)]


def measure(course: LoadCourse, drafting: Drafting) -> Picture:
    """Measure the room of a load diagram: its scale is that of the way."""
    hand, axis = drafting.hand, _way(course)[:2]
    room = FORM.room(name_of(course), course.length, axis, _title(course, drafting), hand)
    below = room.margins.below + (LEVELS[-1] + 2) * hand.symbol
    return room._replace(margins=room.margins._replace(below=below), most=MOST[course.card] * hand.letter)


def draw(course: LoadCourse, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the diagram in its spot: axes, both branches with their arrows, corners, the stroke and its overruns."""
    hand, span = drafting.hand, course.span
    axes = standing(room, spot, span, CARD if course.card else ("M", "N*m") if course.couple else ("F", "N"), drafting)
    graph = Graph(room.name, axes, hand)
    sizes, shown = tuple(_sizes(course, axes, drafting)), marks(course, hand)
    numbers, dots = _positions(course, axes, hand)
    lines = (
        heading(spot.box, _title(course, drafting), drafting.scale(spot.scale, axes.up), hand),
        *axes.lines((0.0, course.length), span, hand, room.name),
        *(_sized(course, size, value, spot.scale, hand) for size, value in zip(sizes, spans(course), strict=True)),
        *(stroke for letter, at in shown for stroke in graph.station(at.real, [at.imag], letter)),
        *_branches(course, axes, hand),
        *dots,
    )
    across, up = (f"{letter}, {drafting.word(of)}" for letter, of in (_way(course)[:2], axes.up[1:]))
    corners = (_corner(letter, axes.on(at.real, at.imag), at.imag > 0, hand) for letter, at in shown)
    letters = *graph.ends((course.length, across), (span[1], up)), *_shared((*corners, *numbers))
    return LetteredFigure(room.name, lines, partial(_letters, room.name, sizes, letters, hand))


def _letters(
    name: str, sizes: Sequence[Dimension], letters: Sequence[Letter], hand: Hand, labels: Labels
) -> Iterator[Stroke]:
    for size in sizes:
        yield telling(name, labels.along(*size.lines[0], size.letter, hand.number, ABOVE, OVER))
    for letter in letters:
        yield labels.beside(letter.at, letter.text, letter.size, letter.gap, letter.side)


def spans(course: LoadCourse) -> tuple[tuple[str, float], ...]:
    """Give what is dimensioned along the way, by its mark: the whole stroke, and each overrun."""
    _, _, whole = _way(course)
    shares = (("overrun_1", course.overrun[0]), ("overrun_2", course.overrun[1]))
    return (whole, course.length), *((name, share * course.length) for name, share in shares if share)


def _way(course: LoadCourse) -> tuple[str, str, str]:
    return SWINGING if course.turning else SLIDING


def _title(course: LoadCourse, drafting: Drafting) -> str:
    key = "indicator card of" if course.card else "load diagram of"
    head, _, index = course.name.partition("_")
    return drafting.word(key, name=lettered(drafting.language, f"{head}_{{{index}}}" if index else head))


def _corner(text: str, at: complex, above: bool, hand: Hand) -> Letter:
    return Letter(at, text, hand.number, OVER if above else UNDER, DOT + BESIDE)


def _shared(letters: Iterable[Letter]) -> Iterable[Letter]:
    """Letter each place once: a corner where a position falls with its letter and the number."""
    kept = dict[complex, Letter]()
    for letter in letters:
        spot = next((spot for spot in kept if abs(spot - letter.at) < SAME), letter.at)
        kept[spot] = letter._replace(text=f"{kept[spot].text}, {letter.text}") if spot in kept else letter
    return kept.values()


def _positions(course: LoadCourse, axes: Axes, hand: Hand) -> tuple[Iterator[Letter], Iterator[Stroke]]:
    """Give the numbers of positions on the course of the load, and their points: as many as have room."""
    spots = [axes.on(place.real, place.imag) for place in course.places]
    length, wide = 2 * abs(axes.on(course.length) - axes.zero), text_width(Text(0j, str(len(spots)), hand.number))
    numbers = numbered(spots, length, wide + SPARE * hand.number, course.shown)
    dots = numbered(spots, length, 3 * DOT * hand.symbol, numbers)
    letters = (_corner(str(k), spots[k], (k in course.returning) != course.higher, hand) for k in numbers)
    return letters, (Circle(spots[k], DOT * hand.symbol, INK) for k in dots)


def _branches(course: LoadCourse, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    for way, branch in (("out", course.out), ("back", course.back)):
        for line in (drawn := tuple(_branch(branch, axes, hand)))[:1]:
            yield stating(Statement(Kind.CURVE, name_of(course), way), line)
        yield from drawn[1:]
    if course.out and course.back:
        for ends in ((course.out[0], course.back[-1]), (course.out[-1], course.back[0])):
            yield from _branch(ends, axes, hand)


def _branch(branch: Branch, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    places = [axes.on(corner.real, corner.imag) for corner in branch]
    parts = [(start, other) for start, other in pairwise(places) if abs(other - start) > LEAST]
    if not parts:
        return
    yield Polyline(tuple(places), False, hand.result)
    start, end = max(parts, key=lambda part: abs(part[1] - part[0]))
    head = arrowhead(start, (start + end) / 2, hand.symbol)
    if head is not None and len(branch) > 2:
        yield head


def _sizes(course: LoadCourse, axes: Axes, drafting: Drafting) -> Iterator[Dimension]:
    _, unit, whole = _way(course)
    low = 1j * (axes.on(0.0, course.span[0]).imag - axes.zero.imag)
    near, far = (low - 1j * level * drafting.hand.symbol for level in LEVELS)
    number = drafting.slot(Slot(whole, course.length if course.turning else 1000 * course.length, DIGITS))
    text = joined("", (f"{whole} = ", number, unit if course.turning else ""))
    yield Dimension(text, axes.on(0.0), axes.on(course.length), far)
    first, last = course.overrun
    for share, start, end in ((first, 0.0, first), (last, 1 - last, 1.0)):
        if share:
            text = joined("", (drafting.slot(Slot(f"overrun_{1 if start == 0.0 else 2}", share)), whole))
            yield Dimension(text, axes.on(start * course.length), axes.on(end * course.length), near)


def _sized(course: LoadCourse, size: Dimension, span: tuple[str, float], scale: Scale, hand: Hand) -> Group:
    name, length = span
    data = Subject(name_of(course), scale.letter, None).data("vector", name, complex(length), scale)
    return Group(size.draw(hand), "", data, size.letter)
