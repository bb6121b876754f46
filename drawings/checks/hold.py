"""Sheets held against the analysis, letters against marks: what lacks, nobody asked for, is otherwise (сверка)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache
from typing import NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from drawings.checks.expected import NOTES, Expected, Wrong, on
from drawings.checks.readers import Read, frames, read, reads
from drawings.checks.readers import value as number
from drawings.layout.ink import CELL, CLEAR
from drawings.layout.labels import NEAR
from drawings.lettering.lettering import bounds
from drawings.lettering.words import SLOT, read_back, template_of, with_index
from drawings.paper.limits import QUANTUM, SEEN
from drawings.paper.strokes import Box, Circle, Group, Key, Kind, Leaf, Line, Stroke, Text
from drawings.paper.walk import groups, stated
from drawings.reading.measure import Measured
from drawings.symbols.symbols import BLOCK
from plans.model.motion import ORDERS, POSITIONS, Complexes, Floats
from plans.words.words import Message

GAP = 3.0  # mm, the widest gap at which a label is placed beside its point
SLACK = 2.0  # mm: letters of images that fall on one place stand at the first of them
NEAREST = GAP + NEAR[-1] + CLEAR + CELL + SLACK
ROUNDED = 0.1  # mm: a box of lettering is found again from its strokes
ONE = 0.5  # mm: images that are nearer to each other share a label
# On plans letters are nearer: beside an image, and beside the symbols of a point.
WITHIN = {order.plan: 1.6 + NEAR[-1] + ONE + ROUNDED for order in ORDERS[1:]}
WITHIN[POSITIONS.plan] = BLOCK[1] / 2 + 1.0 + NEAR[-1] + ROUNDED


class Label(NamedTuple):
    """A lettering, and the start of its leader if it has one."""

    text: Text
    leader: complex | None

    @property
    def place(self) -> Box:
        """Where it points to: its own box, or the start of its leader."""
        if self.leader is None:
            return _box(self.text)
        return self.leader.real, self.leader.imag, self.leader.real, self.leader.imag


_box = lru_cache(maxsize=4096)(bounds)


def unlettered(leaf: Leaf, expected: Mapping[Key, str] | None = None) -> Iterator[Message]:
    """Name each mark of a sheet that no letter of its own stands beside: the one that is due, else what it says."""
    labels, known = dict[str, list[Label]](), expected or {}
    for figure in leaf.groups:
        found = labels_of((figure,))
        yield from strayed(figure, found)
        for plain, some in found.items():
            labels.setdefault(plain, []).extend(some)
    for key, letter, spots in _marks(leaf.groups):
        _, plan, name, _ = key
        wanted = known.get(key) or letter
        plain = Text(0j, wanted if "{" in wanted else with_index(wanted)).plain
        if not beside(labels.get(wanted) or labels.get(plain) or (), spots, WITHIN.get(plan, NEAREST)):
            yield on("letter", plan, name=name)


def strayed(figure: Group, labels: Mapping[str, Sequence[Label]]) -> Iterator[Message]:
    """Name each letter of a vector plan that stands beside another mark than its own: an image's, a vector's."""
    vectors = [(group, line) for group in groups((figure,)) for line in group.strokes[:1] if _is_vector(group, line)]
    if not vectors:
        return
    plan, images = vectors[0][0].data["plan"], dict[str, list[complex]]()
    for group, line in vectors:
        assert isinstance(line, Line)
        for name, spot in zip(group.data["name"].split(" "), (line.start, line.end), strict=True):
            images.setdefault(Text(0j, with_index(name)).plain, []).append(spot)
    for letter, spots in ((letter, images[letter]) for letter in labels if letter in images):
        if not all(beside((label,), spots, WITHIN.get(plan, NEAREST)) for label in labels[letter]):
            yield on("letter", plan, name=letter)
    lines = {group.data["name"]: line for group, line in vectors if isinstance(line, Line)}
    for group in (said for said in stated((figure,)) if said.states and said.states.kind is Kind.LETTER):
        assert group.states is not None
        vector, _, name = group.states.name.rpartition(" ")
        carrier = lines.get(vector)
        if carrier is not None and not beside(_labels(group.strokes), along(carrier.start, carrier.end), NEAREST):
            yield on("letter", plan, name=name)


def _is_vector(group: Group, line: Stroke) -> bool:
    """Tell whether a group is a vector that is named by the letters of both its ends."""
    return isinstance(line, Line) and group.data.get("kind") == "vector" and " " in group.data["name"]


def labels_of(strokes: tuple[Stroke, ...]) -> dict[str, list[Label]]:
    """Give the labels of strokes by the letters that are read; one label may bear several."""
    labels: dict[str, list[Label]] = {}
    for label in _labels(strokes):
        for letter in label.text.plain.split(", "):
            labels.setdefault(letter, []).append(label)
    return labels


def beside(labels: Iterable[Label], spots: Sequence[complex], most: float) -> bool:
    """Tell whether one of some labels is so near to one of some spots, mm."""
    return any(off(spot, box) <= most for box in (label.place for label in labels) for spot in spots)


def distance(labels: Iterable[Label], spots: Iterable[complex]) -> float:
    """Give how far the nearest of some labels is from the nearest of some spots, mm; infinity without any."""
    places = tuple(spots)
    return min((off(spot, box) for box in (label.place for label in labels) for spot in places), default=math.inf)


def _labels(strokes: tuple[Stroke, ...]) -> Iterator[Label]:
    """Give the labels of strokes; a line and a letter alone in a group are a leader (линия-выноска) and its letter."""
    for group in groups((Group(strokes),)):
        inner = group.strokes
        leader = inner[0].start if len(inner) == 2 and isinstance(inner[0], Line) else None
        yield from (Label(text, leader) for text in inner if isinstance(text, Text))


def _marks(strokes: tuple[Stroke, ...]) -> Iterator[tuple[Key, str, list[complex]]]:
    """Give key, letter and places of every point, of the end of every vector of two letters, of every force.

    A vector named by one letter of its own, as a force or an arm is, bears it anywhere along its line, as its title
    writes it; one that is too short to be seen as a vector has none, nor has one that a detail of its plan enlarges.
    """
    vectors = (stroke.data for stroke in groups(strokes) if stroke.data.get("kind") == "vector")
    enlarged = {(data["plan"].rpartition("-")[0], data["name"]) for data in vectors}  # a detail's letter ends its name
    for stroke in groups(strokes):
        match stroke:
            case Group((Line() as line, *_)) if stroke.data.get("kind") == "vector":
                *start, name = stroke.data["name"].split(" ")
                if start:
                    yield _key(Kind.VECTOR, stroke), name, [line.end]
                elif (stroke.data["plan"].replace("forces-", "detail-"), name) in enlarged:
                    continue
                elif abs(line.end - line.start) > SEEN + QUANTUM:  # one that is just so long may bear a letter or not
                    yield _key(Kind.VECTOR, stroke), stroke.title or name, along(line.start, line.end)
            case Group((Circle() as circle, *_)) if stroke.data.get("kind") in ("point", "pole"):
                yield _key(Kind.POINT, stroke), stroke.title or stroke.data["name"], [circle.centre]


def _key(kind: Kind, mark: Group) -> Key:
    position = mark.data.get("position")
    return kind, mark.data["plan"], mark.data["name"], None if position is None else int(position)


def along(start: complex, end: complex) -> list[complex]:
    """Give places along a line, no further from each other than a label may be from its mark."""
    count = math.ceil(abs(end - start) / NEAREST) + 1
    return [start + (end - start) * k / count for k in range(count + 1)]


def off(spot: complex, box: Box) -> float:
    """Give how far a place is from a box, mm."""
    left, bottom, right, top = box
    x, y = spot.real, spot.imag
    across = left - x if x < left else max(x - right, 0.0)
    return math.hypot(across, bottom - y if y < bottom else max(y - top, 0.0))


Seen = Mapping[Key, Sequence[Read]]
Spots = TypeVar("Spots", complex, Complexes)
FRAMES = frozenset((Kind.AXIS,))  # what tells where values lie, and is none itself
SIDES = (-1.0, -1e-6, 0.0, 1e-6, 1.0)  # of the paper's resolution: where a graph is looked at beside a jump, hard by it
LOOKED, STRIDE = 360, 16  # places of a path that are looked at; of its lines the first that are
# What measuring reads, by the kind of its data.
MARKS = {"vector": Kind.VECTOR, "point": Kind.POINT, "profile": Kind.CURVE}


def readings(measured: Measured, leaf: Leaf) -> Seen:
    """Read all that a sheet states: its marks as they were measured, all else off the ink that states it."""
    found: dict[Key, list[Read]] = {}
    marks = ((Kind.VECTOR, measured.vectors), (Kind.POINT, measured.points))
    for kind, mark in ((kind, mark) for kind, group in marks for mark in group):
        found.setdefault((kind, mark.plan, mark.name, mark.position), []).append(Read(mark.value, mark.scale))
    for curve in measured.profiles:
        known = found.setdefault((Kind.CURVE, curve.plan, curve.name, None), [])
        known.append(Read(np.array(curve.places), curve.scale))
    places = frames(leaf)
    for group in stated(leaf.groups):
        said = group.states
        if said is not None and said.kind is Kind.PHRASE:
            for name, number in read_back(said.name, str(read(group, None).value)) or [(said.name, "")]:
                found.setdefault((said.kind, said.figure, name, said.position), []).append(Read(number))
        elif said is not None and said.kind not in FRAMES:
            at = None if said.position is None else str(said.position)
            frame = places.get((said.figure, at)) or places.get((said.figure, None))
            with suppress(StopIteration, IndexError):  # a forger took the ink away: it is told as missing
                found.setdefault(said.key, []).append(read(group, frame))
    return found


def stated_keys(leaf: Leaf) -> frozenset[Key]:
    """Give the keys of all that a leaf states, without reading any of it."""
    return frozenset(key for group in groups(leaf.groups) for key in _keys(group))


def _keys(group: Group) -> Iterator[Key]:
    if group.data.get("kind") in MARKS:
        yield _key(MARKS[group.data["kind"]], group)
    if (said := group.states) is not None and said.kind is Kind.PHRASE:
        yield from ((said.kind, said.figure, name, said.position) for name in SLOT.findall(said.name))
    elif said is not None and said.kind not in FRAMES:
        yield said.key


def faults(read: Seen, rows: Mapping[Key, Expected], only: Collection[Key] = ()) -> Iterator[Wrong]:
    """Tell what is read otherwise than the analysis has it, what nobody asked for, and what lacks of `only` some."""
    for key, found in read.items():
        row = rows.get(key)
        if row is None:
            yield wrong("stranger_on", key)
        else:
            yield from (wrong("differs_on", key) for reading in found if not holds(reading, row))
    yield from (wrong("missing_on", key) for key in only if key not in read and key in rows and not rows[key].may_lack)


def phrase_faults(lines: Iterable[str], expected: Mapping[Key, Expected]) -> Iterator[Wrong]:
    """Tell the numbers of phrases beside the sheets, as in a report, that are not those of their quantities.

    A report tells more than its sheets show: what is due on none of them is not held.
    """
    for line in (text for text in lines if SLOT.search(template_of(text))):
        for name, text in read_back(template_of(line), line, markup=False) or [(line, "")]:
            row = expected.get((Kind.PHRASE, NOTES, name, None))
            if name == line or (row is not None and not holds(Read(text), row)):
                yield wrong("differs_on", (Kind.PHRASE, NOTES, name, None))


def wrong(how: str, key: Key) -> Wrong:
    """Say what is wrong with a statement."""
    _, figure, name, position = key
    name = name.replace("{", "").replace("}", "")
    return on(how, figure, name=name if position is None else f"{name} ({position})")


def holds(found: Read, expected: Expected) -> bool:
    """Tell whether what was read is what is expected, to the paper's resolution and what both roads may differ by."""
    value, slack = found.value, expected.allowed + 2 * QUANTUM * found.scale
    match expected.value:
        case _ if expected.allowed == math.inf:
            return True
        case str() as text:
            return value == text
        case float() | int() | complex() as true if isinstance(value, str):
            return _reads(value.lstrip("±+"), float(abs(true)) if isinstance(true, complex) else float(true), expected)
        case np.ndarray() as path if isinstance(value, np.ndarray):
            analytic, other = even(value, found), even(path, found)
            return near(analytic, other, slack) and near(other, analytic, slack)
        case np.ndarray() as path if not isinstance(value, str):
            return near(np.array([value]), path, slack)
        case float() | int() | complex() as true if isinstance(value, complex | float | int):
            return bool(abs(even(value - true, found)) <= slack)
    return isinstance(value, np.ndarray) and callable(expected.value) and _follows(value, found, expected)


def even(values: Spots, found: Read) -> Spots:
    """Give values as they lie on paper, in units of the abscissas, where those of the ordinates are others."""
    return values.real + 1j * values.imag * (found.scale / found.up) if found.up and found.scale else values


def _reads(text: str, true: float, expected: Expected) -> bool:
    """Tell whether a written number is a true one, or a full turn off where that is the same."""
    found = number(text)
    turns = expected.period * round((found - true) / expected.period) if expected.period and found is not None else 0.0
    return any(reads(text, true + turns, expected.allowed, digits) for digits in {0, expected.digits})


def _follows(drawn: Complexes, found: Read, expected: Expected) -> bool:
    """Tell whether a graph goes as a function does, from end to end; where that jumps it may be anywhere between."""
    assert callable(expected.value)
    (low, high), near = expected.ends, 2 * QUANTUM * found.scale
    if not (abs(drawn.real.min() - low) <= near and abs(drawn.real.max() - high) <= near):
        return False
    slack = expected.allowed + 2 * QUANTUM * found.up
    left = drawn[~(np.abs(drawn.imag - expected.value(np.clip(drawn.real, low, high))) <= slack)]
    if not left.size:
        return True
    beside = np.clip(np.add.outer(near * np.array(SIDES), left.real), low, high)
    true = np.reshape(expected.value(beside.ravel()), beside.shape)
    least, most = np.fmin.reduce(true, axis=0), np.fmax.reduce(true, axis=0)  # beside a gap there is one side alone
    return bool(((left.imag >= least - slack) & (left.imag <= most + slack)).all())


def bows(path: Complexes) -> Floats:
    """Give how far a curve may lie from the lines between places on it, as far as one that turns at once."""
    run = np.diff(path)
    off = np.abs(np.angle(run[1:] * run[:-1].conj())) * np.maximum(np.abs(run[1:]), np.abs(run[:-1])) / 4
    return np.asarray(np.maximum(np.append(0.0, off), np.append(off, 0.0)))


def near(drawn: Complexes, path: Complexes, slack: float) -> bool:
    """Tell whether places of one path, evenly of many, are on the lines between those of another.

    Where that bends a place may lie as far from its lines as an arc does from its chords.
    """
    start, run, most = path[:-1], np.diff(path), bows(path) + slack
    along = run.conj() / np.where(np.abs(run) > 0, np.abs(run) ** 2, 1.0)

    def reached(spots: Complexes, lines: npt.NDArray[np.intp]) -> npt.NDArray[np.bool_]:
        off = start[lines] - spots[:, None]
        share = np.minimum(np.maximum(-(off * along[lines]).real, 0.0), 1.0)
        return np.asarray((np.abs(off + share * run[lines]) <= most[lines]).any(axis=1))

    spots = drawn[:: math.ceil(len(drawn) / LOOKED)]
    by = STRIDE * np.abs(start[::STRIDE] - spots[:, None]).argmin(axis=1)  # that line is hard by, most likely
    lines = np.clip(np.add.outer(by, np.arange(-STRIDE, STRIDE + 1)), 0, len(run) - 1)
    left, every = spots[~reached(spots, lines)], np.arange(len(run))[None]
    return all(reached(left[k : k + 1], every)[0] for k in range(len(left)))
