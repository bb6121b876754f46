"""A sheet that was seen: all that is drawn on it and can be seen, and what cannot (увиденный лист)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

from drawings.eye.covering import veiled
from drawings.eye.ink import Unseen
from drawings.eye.observer import Observer
from drawings.measure.measure import Measured, measure
from drawings.paper.strokes import Group, Leaf, Stroke


class SeenSheet(NamedTuple):
    """What an eye sees of a sheet, what it does not, and all that is written, seen or not."""

    leaf: Leaf
    unseen: tuple[Unseen, ...]
    written: Leaf
    measured: Measured


def see(source: bytes, observer: Observer | None = None) -> SeenSheet:
    """See a written sheet, and measure it: it is read once for both."""
    observer = observer or Observer()
    measured = measure(source, observer)
    whole = _leaf(observer, measured)
    gone = {id(one.stroke) for one in observer.unseen}
    under = (one for one in veiled(whole, observer.clear, observer.gone) if id(one.stroke) not in gone)
    unseen = (*observer.unseen, *under)
    return SeenSheet(without(whole, [one.stroke for one in unseen]), unseen, whole, measured)


def uncovered(leaf: Leaf) -> Leaf:
    """Give a leaf without what is covered or off the paper."""
    return without(leaf, [one.stroke for one in veiled(leaf)])


def without(leaf: Leaf, strokes: Iterable[Stroke]) -> Leaf:
    """Give a leaf without some of its strokes."""
    hidden = {id(one) for one in strokes}
    return replace(leaf, groups=tuple(_kept(leaf.groups, hidden))) if hidden else leaf


def _leaf(observer: Observer, measured: Measured) -> Leaf:
    """Give all that is written; what stands in no group stands in one of its own."""
    root = observer.root
    groups = _unwrapped(tuple(one if isinstance(one, Group) else Group((one,)) for one in root.strokes))
    data = {key: value for key, value in measured.metadata.items() if key != "format"}
    paper = observer.paper
    return Leaf(paper.width, paper.height, groups, root.title, observer.description, data, observer.lettering)


def _unwrapped(groups: tuple[Group, ...]) -> tuple[Group, ...]:
    """Take what an editor has put into one layer out of it."""
    while len(groups) == 1 and not groups[0].data and groups[0].strokes:
        inside = tuple(one for one in groups[0].strokes if isinstance(one, Group))
        if len(inside) < len(groups[0].strokes):
            break
        groups = inside
    return groups


def _kept(groups: Iterable[Group], hidden: Collection[int]) -> Iterator[Group]:
    """Give groups with what can be seen in them."""
    for group in groups:
        yield replace(group, strokes=tuple(_visible(group.strokes, hidden)))


def _visible(strokes: Iterable[Stroke], hidden: Collection[int]) -> Iterator[Stroke]:
    for stroke in strokes:
        if id(stroke) in hidden:
            continue
        if isinstance(stroke, Group):
            yield from _kept((stroke,), hidden)
        else:
            yield stroke
