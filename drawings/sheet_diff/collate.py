"""Collation of two sheets: the one that must be, and the one that is there (сличение двух листов)."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Circle, Group, Leaf, Line, Text
from drawings.paper.walk import groups
from drawings.reading.covering import crosses
from drawings.reading.items import BEARERS, STILL, Ink, Item, SheetFigures, brought, items, middle, spots
from drawings.reading.transform import STAY, Affine, placing
from drawings.sheet_diff import edit
from drawings.sheet_diff.edit import Edit
from drawings.sheet_diff.matching import alike_in_style, lies, looks_alike, match, reversed_lies, shift_of, stretch_of
from plans.words.words import Message, message

MOST_PAIRS = 250_000  # of strokes that are held against each other one by one: a second of work
NEAR = 10.0  # mm: a stroke drawn otherwise is still taken for the same one
FAR = 1e9  # mm: of no stroke of the same thing


class Pairing:
    """What must be there and is not, and what is there and must not, while it is told."""

    def __init__(self, missing: Sequence[Item], added: Sequence[Item], figures: SheetFigures, rounding: float) -> None:
        self.missing, self.added = list(missing), list(added)
        self.figures, self.rounding = figures, rounding

    def edits(self, counts: dict[str, int]) -> Iterator[Edit]:
        """Tell all edits: what was moved as one, then stroke by stroke; `counts` has the strokes of each figure."""
        yield from self._whole_figures(counts)
        yield from self._as_one(self.figures.of, counts)
        yield from self._as_one(_mark, {})
        yield from self._stretched()
        yield from self._one_by_one()
        yield from (edit.lone("missing", item, self.figures) for item in self.missing)
        yield from (edit.lone("added", item, self.figures) for item in self.added)

    def _whole_figures(self, counts: dict[str, int]) -> Iterator[Edit]:
        """Tell figures that are not there at all, and those that must not be."""
        ours, theirs = (_by(lambda item: item.home.figure, left) for left in self._left)
        for name, group in ours.items():
            if name and name not in theirs and len(group) > 1 and counts.get(str(name)) == len(group):
                self._done(group, ())
                yield edit.whole("missing", group, self.figures)
        for name, others in theirs.items():
            if name and name not in self.figures.named and len(others) > 1:
                self._done((), others)
                yield edit.whole("added", others, self.figures)

    def _as_one(self, key: Callable[[Item], Hashable], counts: dict[str, int]) -> Iterator[Edit]:
        """Tell what was moved as one, among strokes of one key."""
        ours, theirs = _by(key, self.missing), _by(key, self.added)
        for name, group in ours.items():
            others = theirs.get(name, [])
            if name is None or len(group) < 2:
                continue
            shift = shift_of(group, others, self.rounding)
            if shift is not None and looks_alike(group, others, shift.scale):
                self._done(group, others)
                yield edit.together(group, self.figures, shift, counts.get(str(name)) == len(group))

    def _stretched(self) -> Iterator[Edit]:
        """Tell lines of a figure that were stretched or mirrored as one, in whatever width."""
        lines = ([item for item in left if isinstance(item.stroke, Line)] for left in self._left)
        ours, theirs = (_by(self.figures.of, left) for left in lines)
        for name, group in ours.items():
            others = theirs.get(name, [])
            shift = stretch_of(group, others, self.rounding)
            if shift is not None and shift.how != "moved":
                self._done(group, others)
                yield edit.together(group, self.figures, shift, False)

    @property
    def _left(self) -> tuple[list[Item], list[Item]]:
        return self.missing, self.added

    def _one_by_one(self) -> Iterator[Edit]:
        """Tell strokes that have their like, the nearest pairs first."""
        if len(self.missing) * len(self.added) > MOST_PAIRS:
            return
        costs = (
            (self._cost(ours, theirs), i, j)
            for i, ours in enumerate(self.missing)
            for j, theirs in enumerate(self.added)
        )
        ours, theirs = list(self.missing), list(self.added)
        left, right = set(range(len(ours))), set(range(len(theirs)))
        for _, i, j in sorted(cost for cost in costs if cost[0] < FAR):
            if i in left and j in right:
                left.discard(i)
                right.discard(j)
                self._done([ours[i]], [theirs[j]])
                yield self._stated(ours[i], theirs[j])

    def _done(self, done: Sequence[Item], others: Sequence[Item]) -> None:
        mine, theirs = set(map(id, done)), set(map(id, others))
        self.missing = [item for item in self.missing if id(item) not in mine]
        self.added = [item for item in self.added if id(item) not in theirs]

    def _cost(self, ours: Item, theirs: Item) -> float:
        """Tell how far apart two strokes are that may be the same thing, mm; FAR if they are not."""
        if type(ours.stroke) is not type(theirs.stroke):
            return FAR
        if isinstance(ours.stroke, Text) and isinstance(theirs.stroke, Text):
            return _of_texts(ours, theirs)
        if lies(ours.stroke, theirs.stroke, self.rounding) or reversed_lies(ours.stroke, theirs.stroke, self.rounding):
            return 0.0
        a, b = spots(ours.stroke), spots(theirs.stroke)
        if len(a) != len(b) or self.figures.of(ours) != self.figures.of(theirs):
            return FAR
        off = sum(abs(x - y) for x, y in zip(a, b, strict=True)) / len(a)
        known = _mark(ours) is not None and _mark(ours) == _mark(theirs) and ours.what == theirs.what
        shifted = shift_of([ours], [theirs], self.rounding) is not None and abs(_turned(a, b) - 1) < 1e-3
        return off if known or shifted or off <= NEAR else FAR

    def _stated(self, ours: Item, theirs: Item) -> Edit:
        """Tell of one stroke that is another."""
        a, b = ours.stroke, theirs.stroke
        if isinstance(a, Text) and isinstance(b, Text):
            return self._text(ours, a, b)
        pairs = [*zip(spots(a), spots(b), strict=True)]
        by, least = (most(abs(x - y) for x, y in pairs) for most in (max, min))
        if reversed_lies(a, b, self.rounding) and not lies(a, b, self.rounding):
            return edit.lone("reversed", ours, self.figures)
        if lies(a, b, self.rounding) or not alike_in_style(a.style, b.style):
            return edit.lone("style", ours, self.figures, look=edit.style(a.style, b.style))
        if isinstance(a, Circle) and isinstance(b, Circle) and abs(a.centre - b.centre) <= self.rounding:
            return edit.moved("radius", ours, self.figures, abs(a.radius - b.radius))
        if isinstance(a, Line) and least <= self.rounding:
            return edit.moved("end", ours, self.figures, by)
        same_shape = all(abs((y - pairs[0][1]) - (x - pairs[0][0])) <= 2 * self.rounding for x, y in pairs)
        return edit.moved("moved" if same_shape else "reshaped", ours, self.figures, by)

    def _text(self, ours: Item, a: Text, b: Text) -> Edit:
        if a.runs != b.runs:
            return edit.lone("text", ours, self.figures, is_=edit.written(b), must=edit.written(a))
        if abs(a.at - b.at) > self.rounding:
            return edit.moved("moved", ours, self.figures, abs(a.at - b.at))
        if not alike_in_style(a.style, b.style):
            return edit.lone("style", ours, self.figures, look=edit.style(a.style, b.style))
        return edit.lone("lettered", ours, self.figures)


def _of_texts(ours: Item, theirs: Item) -> float:
    """Lettering is the same thing where it stands at the same place, or says the same not far away."""
    a, b = ours.stroke, theirs.stroke
    assert isinstance(a, Text) and isinstance(b, Text)
    off = abs(a.at - b.at)
    if off <= a.size:
        return off
    return off + a.size if a.runs == b.runs and off <= 10 * NEAR else FAR


def _turned(a: Sequence[complex], b: Sequence[complex]) -> complex:
    """Give by what number the longest side from the first point was multiplied."""
    far = max(range(len(a)), key=lambda k: abs(a[k] - a[0]))
    return (b[far] - b[0]) / (a[far] - a[0]) if a[far] != a[0] else 1.0


def _mark(item: Item) -> Hashable | None:
    """Give what tells a mark from all others of the sheet; None of what is no part of one."""
    names = ("kind", "plan", "quantity", "name", "position")
    return tuple(item.home.mark.get(name, "") for name in names) if item.home.mark else None


def _by(key: Callable[[Item], Hashable], listed: Sequence[Item]) -> dict[Hashable, list[Item]]:
    found: dict[Hashable, list[Item]] = defaultdict(list)
    for item in listed:
        found[key(item)].append(item)
    return found


def nearest(item: Item, others: Sequence[Item]) -> float:
    """Give how far the nearest of other items is, mm."""
    return min((abs(middle(item.stroke) - middle(other.stroke)) for other in others), default=FAR)


def covered(patch: Ink, drawn: Sequence[Item]) -> list[Item]:
    """List what has its middle under an area; nothing is under what is not filled."""
    if isinstance(patch, Text) or patch.style.fill == "none":
        return []
    return [item for item in drawn if _holds(patch, middle(item.stroke))]


def _holds(patch: Ink, spot: complex) -> bool:
    """Tell whether a place lies within an outline: a ray to the right of it crosses that an odd number of times."""
    if isinstance(patch, Circle):
        return abs(spot - patch.centre) < patch.radius
    corners = spots(patch)
    return sum(crosses(a - spot, b - spot) for a, b in pairwise((*corners, corners[0]))) % 2 == 1


CORNERS = 3
SIGNED = ("scene", "plandraft", "format")  # who drew a sheet and from what, which is looked at by itself
STRANGE = 0.5  # a sheet of which less is as it must be is another sheet
MILLIMETRE = 1e-3  # mm: what paper sizes are held to


class Hidden(NamedTuple):
    """A stroke that is in the file and is not seen, with the reason."""

    item: Item
    reason: str  # by its key among words


class Collation(NamedTuple):
    """How a written sheet differs from what it must be."""

    edits: tuple[Edit, ...]
    same: int  # lines and letters that are as they must be
    most: int  # all that must be
    whole: tuple[Message, ...] = ()  # of the sheet as a whole: its paper, how it was moved

    @property
    def clean(self) -> bool:
        """Whether nothing differs."""
        return not self.edits and not self.whole

    @property
    def strange(self) -> bool:
        """Whether it is rather another sheet."""
        return self.same < STRANGE * self.most


def collate(right: Leaf, there: Leaf, hidden: Sequence[Hidden] = (), usual: Sequence[Hidden] = ()) -> Collation:
    """Hold a sheet against what it must be; one that was moved as a whole is laid back first.

    What is `hidden` in it is told, but for what is hidden in every sheet like it, as it is `usual`.
    """
    back, whole = _laid_back(right, there)
    rounding = QUANTUM if back == STAY else 4 * QUANTUM * max(1.0, abs(back.p))
    brought = there if back == STAY else there._replace(groups=tuple(_brought(group, back) for group in there.groups))
    figures = SheetFigures(right)
    ours = items(right)
    found = match(ours, items(brought), rounding)
    left = _unusual(hidden, usual, rounding)
    unseen = list(_hidden(found.missing, left, figures, rounding))
    gone = {id(item) for item, _ in unseen}
    pairing = Pairing([item for item in found.missing if id(item) not in gone], found.added, figures, rounding)
    copies = (edit.lone("copied", item, figures) for item in found.copies)
    under = {id(lost.item): covered(lost.item.stroke, ours) for lost in left}
    others = [edit.unseen(lost.item, lost.reason, figures, under[id(lost.item)]) for lost in left]
    patched = {id(item) for gone in under.values() for item in gone}
    marks = (edit.restated(ours, theirs, figures) for ours, theirs in found.same if _restated(ours, theirs))
    # What a patch covers is told of the patch.
    edits = (
        *(change for item, change in unseen if id(item) not in patched),
        *marks,
        *pairing.edits(Counter(figures.of(item) for item in ours)),
        *copies,
        *others,
    )
    return Collation(edits, *_shares(ours, found.missing), (*_paper(right, there), *whole, *_stated(right, there)))


def _shares(ours: Sequence[Item], missing: Sequence[Item]) -> tuple[int, int]:
    """Count what is as it must be, and all that must be, without what every sheet has."""
    kept, gone = ([item for item in some if item.home.figure not in STILL] for some in (ours, missing))
    return len(kept) - len(gone), len(kept)


def _hidden(
    missing: Sequence[Item], left: list[Hidden], figures: SheetFigures, rounding: float
) -> Iterator[tuple[Item, Edit]]:
    """Tell what is in its place in the file and cannot be seen; that is taken from what is left of the hidden."""
    for item in missing:
        place = next((k for k, lost in enumerate(left) if _one_place(item, lost.item, rounding)), None)
        if place is not None:
            yield item, edit.lone("hidden", item, figures, reason=left.pop(place).reason)


def _restated(ours: Item, theirs: Item) -> bool:
    """Tell whether a mark is drawn as it must be, and states something else of itself."""
    return ours.what in BEARERS.values() and ours.home.mark != theirs.home.mark


def _unusual(hidden: Sequence[Hidden], usual: Sequence[Hidden], rounding: float) -> list[Hidden]:
    left = list(usual)
    found = []
    for lost in hidden:
        place = next((k for k, other in enumerate(left) if _one_place(lost.item, other.item, rounding)), None)
        if place is None:
            found.append(lost)
        else:
            left.pop(place)
    return found


def _one_place(item: Item, other: Item, rounding: float) -> bool:
    return type(item.stroke) is type(other.stroke) and lies(item.stroke, other.stroke, rounding)


def _paper(right: Leaf, there: Leaf) -> Iterator[Message]:
    if abs(right.width - there.width) > MILLIMETRE or abs(right.height - there.height) > MILLIMETRE:
        sizes = ((f"{leaf.width:.6g}", f"{leaf.height:.6g}") for leaf in (there, right))
        (width, height), (must_width, must_height) = sizes
        yield message("edit.paper", width=width, height=height, must_width=must_width, must_height=must_height)


def _stated(right: Leaf, there: Leaf) -> Iterator[Message]:
    """Tell what a file says of itself otherwise than it must, beside who drew it and from what."""
    if (right.title, right.description) != (there.title, there.description):
        yield message("edit.title")
    for key in sorted({*right.metadata, *there.metadata} - set(SIGNED)):
        if _json(right.metadata.get(key)) != _json(there.metadata.get(key)):
            yield message("edit.metadata", key=key)


def _json(value: Any) -> str:
    """Write data as a file has them, in which lists are no tuples."""
    return json.dumps(value, sort_keys=True, default=str)


def _laid_back(right: Leaf, there: Leaf) -> tuple[Affine, tuple[Message, ...]]:
    """Find by the corner marks how a sheet was moved as a whole; give the way back, and what is told of it.

    A sheet that was stretched or mirrored has no way back: placing refuses it.
    """
    ours, theirs = _corners(right), _corners(there)
    if ours.keys() != theirs.keys() or len(ours) != CORNERS:
        return STAY, ()
    stated, found = list(ours.values()), [theirs[name] for name in ours]
    if all(abs(a - b) <= QUANTUM for a, b in zip(stated, found, strict=True)):
        return STAY, ()
    by = placing(stated, found)
    farthest = max(abs(a - b) for a, b in zip(stated, found, strict=True))
    moved = message("edit.all", by=f"{farthest:.4g}", scale=f"{abs(by.p):.6g}")
    return Affine(1 / by.p, 0j, -by.t / by.p), (moved,)


def _corners(leaf: Leaf) -> Mapping[str, complex]:
    corners = (group for group in groups(leaf.groups) if group.data.get("kind") == "corner")
    return {
        corner.data.get("value", ""): corner.strokes[0].centre
        for corner in corners
        if corner.strokes and isinstance(corner.strokes[0], Circle)
    }


def _brought(group: Group, by: Affine) -> Group:
    moved = brought(group, by)
    assert isinstance(moved, Group)
    return moved
