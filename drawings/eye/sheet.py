"""A sheet that was seen: all that is drawn on it and can be seen, and what cannot (увиденный лист)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

from drawings.eye.observer import Observer, Unseen
from drawings.measure.measure import Measured, measure
from drawings.paper.strokes import Group, Leaf, Stroke


class SeenSheet(NamedTuple):
    """What an eye sees of a sheet, what it does not, and all that is written, seen or not."""

    leaf: Leaf
    unseen: tuple[Unseen, ...]
    written: Leaf
    measured: Measured


def see(source: bytes) -> SeenSheet:
    """See a written sheet, and measure it: it is read once for both."""
    observer = Observer()
    measured = measure(source, observer)
    whole = _leaf(observer, measured)
    hidden = {id(one.stroke) for one in observer.unseen}
    leaf = replace(whole, groups=tuple(_kept(whole.groups, hidden))) if hidden else whole
    return SeenSheet(leaf, tuple(observer.unseen), whole, measured)


def _leaf(observer: Observer, measured: Measured) -> Leaf:
    """Give all that is written; what stands in no group stands in one of its own."""
    root = observer.root
    groups = tuple(one if isinstance(one, Group) else Group((one,)) for one in root.strokes)
    data = {key: value for key, value in measured.metadata.items() if key != "format"}
    paper = observer.paper
    return Leaf(paper.width, paper.height, groups, root.title, observer.description, data, observer.lettering)


def _kept(groups: Iterable[Group], hidden: Collection[int]) -> Iterator[Group]:
    """Give groups with what can be seen in them."""
    for group in groups:
        yield replace(group, strokes=tuple(_visible(group.strokes, hidden)))


def _visible(strokes: Iterable[Stroke], hidden: Collection[int]) -> Iterator[Stroke]:
    for stroke in strokes:
        if isinstance(stroke, Group):
            yield from _kept((stroke,), hidden)
        elif id(stroke) not in hidden:
            yield stroke
