"""The law of letters: one is nearer to its own mark than to any other of its figure, or has a leader to it (буквы)."""

from __future__ import annotations

from collections.abc import Iterator

import shapely

from drawings.checks.hold import distance, labels_of
from drawings.lettering.lettering import bounds
from drawings.lettering.words import with_index
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Leaf, Line, Text
from drawings.paper.walk import groups
from tests.drawings.collisions import ink

ROUNDED = 0.1  # mm: a letter just as near to two lines is at both
DRAWN = ("scheme-", "lever-", "forces-", "couples")  # figures whose vectors are lettered
LEADS = 0.5  # mm: a leader that begins so near to a line leads from it
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
        for kind in ("force", "vector") if figure.name.startswith(DRAWN) else ():
            yield from (f"{figure.name}: the letter of {own} is at {other}" for own, other in _strayed(figure, kind))


def _points(figure: Group) -> Iterator[tuple[str, complex]]:
    for group in groups((figure,)):
        match group.strokes:
            case (Circle() as circle, *_) if group.data.get("kind") in ("point", "pole"):
                letter = group.title or group.data["name"]
                yield Text(0j, letter if "{" in letter else with_index(letter)).plain, circle.centre


def _strayed(figure: Group, kind: str) -> Iterator[tuple[str, str]]:
    """Name the vectors whose letter stands nearer to another, or is led from it; or two that are led crosswise."""
    lines, crossed, labels = dict[str, shapely.Geometry](), set[tuple[str, str]](), labels_of((figure,))
    drawn = [one for one in groups((figure,)) if one.data.get("kind") in (kind, "force") and one.title]
    for group in drawn:
        shafts, name = [ink(one).line for one in group.strokes if isinstance(one, Line)], Text(0j, group.title).plain
        lines[name] = shapely.union_all([*shafts, lines.get(name)])
    own = {Text(0j, group.title).plain for group in drawn if group.data["kind"] == kind}
    for name, label in ((one, label) for one in own for label in labels.get(one, ()) if label.text.plain == one):
        whole, letter = label.place, bounds(label.text._replace(content=label.text.runs[:1]))
        parts = [letter, (letter[2], *whole[1:])] if label.leader is None else [whole]  # the letter, and its index
        place = shapely.union_all([shapely.box(*part) for part in parts])
        leader = shapely.shortest_line(place, shapely.box(*bounds(label.text)))
        far = max(place.distance(lines[name]) - ROUNDED, LEADS * (label.leader is not None))
        others = [other for other in lines if other != name]
        yield from ((name, one) for one in others if lines[one].length > CLEAR and place.distance(lines[one]) < far)
        crossed |= {(name, other) for other in others if leader.intersects(lines[other])}
    yield from (pair for pair in sorted(crossed) if pair[::-1] in crossed)
