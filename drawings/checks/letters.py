"""Letters held to their marks: each point and each end of a vector bears its own letter, close by or by a leader."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from drawings.checks.expected import on
from drawings.layout.ink import CELL, CLEAR
from drawings.layout.labels import NEAR
from drawings.lettering.extent import bounds
from drawings.lettering.vector_letters import with_index
from drawings.paper.limits import QUANTUM, SEEN
from drawings.paper.statement import Key, Kind
from drawings.paper.strokes import Box, Circle, Group, Leaf, Line, Stroke, Text
from drawings.paper.walk import groups, stated
from drawings.symbols.symbols import BLOCK
from plans.model.motion import ORDERS, POSITIONS
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
        if not beside(labels.get(plain, ()), spots, WITHIN.get(plan, NEAREST)):
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
    writes it; one that is too short to be seen as a vector has none.
    """
    for stroke in groups(strokes):
        match stroke:
            case Group((Line() as line, *_)) if stroke.data.get("kind") == "vector":
                *start, name = stroke.data["name"].split(" ")
                if start:
                    yield _key(Kind.VECTOR, stroke), name, [line.end]
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
