"""The law of letters: one is nearer to its own mark than to any other of its figure, or has a leader to it (буквы)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.hold import distance, labels_of
from drawings.lettering.words import with_index
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Leaf, Text
from drawings.paper.walk import groups

CLEAR = 1.0  # mm: marks whose letters may be either's are no nearer to each other, nor is one letter between them


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name the points whose letter stands nearer to another point of the figure that has a letter too."""
    labels = labels_of(leaf.groups)
    for figure in leaf.groups:
        marks = [*_points(figure)]
        lettered = [(name, at) for name, at in marks if labels.get(name)]
        for name, at in lettered:
            own = min(labels[name], key=lambda label, at=at: distance([label], [at]))
            far = distance([own], [at])
            for other, there in lettered:
                free = all(distance([label], [there]) > far for label in labels[other])
                if abs(there - at) > CLEAR and distance([own], [there]) < far - CLEAR and free:
                    yield f"{figure.name}: the letter of {name} stands at {other}"


def _points(figure: Group) -> Iterator[tuple[str, complex]]:
    for group in groups((figure,)):
        match group.strokes:
            case (Circle() as circle, *_) if group.data.get("kind") in ("point", "pole"):
                letter = group.title or group.data["name"]
                yield Text(0j, letter if "{" in letter else with_index(letter)).plain, circle.centre
