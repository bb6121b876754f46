"""Walks over strokes that are grouped in groups: all of them, those that ink, the lettering (обход линий)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from drawings.paper.strokes import Group, Stroke, Text


def walk(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Give strokes in their order from back to front, each group before what it holds.

    >>> [type(stroke).__name__ for stroke in walk([Group((Text(0j, "A"),))])]
    ['Group', 'Text']
    """
    for stroke in strokes:
        yield stroke
        if isinstance(stroke, Group):
            yield from walk(stroke.strokes)


def flat(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Give the strokes that ink the paper: all but the groups."""
    return (stroke for stroke in walk(strokes) if not isinstance(stroke, Group))


def groups(strokes: Iterable[Stroke]) -> Iterator[Group]:
    """Give the groups, each before those within it."""
    return (stroke for stroke in walk(strokes) if isinstance(stroke, Group))


def group_named(strokes: Iterable[Stroke], name: str) -> Group | None:
    """Give the first group of a name, if there is one."""
    return next((one for one in groups(strokes) if one.name == name), None)


def texts(strokes: Iterable[Stroke]) -> Iterator[Text]:
    """Give the lettering."""
    return (stroke for stroke in walk(strokes) if isinstance(stroke, Text))
