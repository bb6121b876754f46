"""Pairing: what is left of a sheet on either side, told as edits (правка)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterator, Sequence

from drawings.collation import edit
from drawings.collation.edit import Edit, Figures
from drawings.collation.items import Item
from drawings.collation.matching import alike_in_style, lies, reversed_lies
from drawings.collation.similarity import looks_alike, shift_of, stretch_of
from drawings.collation.spots import middle, spots
from drawings.paper.strokes import Circle, Line, Text

MOST_PAIRS = 250_000  # of strokes that are held against each other one by one: a second of work
NEAR = 10.0  # mm: a stroke drawn otherwise is still taken for the same one
FAR = 1e9  # mm: of no stroke of the same thing


class Pairing:
    """What must be there and is not, and what is there and must not, while it is told."""

    def __init__(self, missing: Sequence[Item], added: Sequence[Item], figures: Figures, rounding: float) -> None:
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
        ours, theirs = (_by(lambda item: item.home.figure, own) for own in self._left)
        for name, own in ours.items():
            if name and name not in theirs and len(own) > 1 and counts.get(str(name)) == len(own):
                self._done(own, ())
                yield edit.whole("missing", own, self.figures)
        for name, others in theirs.items():
            if name and name not in self.figures.named and len(others) > 1:
                self._done((), others)
                yield edit.whole("added", others, self.figures)

    def _as_one(self, key: Callable[[Item], Hashable], counts: dict[str, int]) -> Iterator[Edit]:
        """Tell what was moved as one, among strokes of one key."""
        ours, theirs = _by(key, self.missing), _by(key, self.added)
        for name, own in ours.items():
            others = theirs.get(name, [])
            if name is None or len(own) < 2:
                continue
            shift = shift_of(own, others, self.rounding)
            if shift is not None and looks_alike(own, others, shift.scale):
                self._done(own, others)
                yield edit.together(own, self.figures, shift, counts.get(str(name)) == len(own))

    def _stretched(self) -> Iterator[Edit]:
        """Tell lines of a figure that were stretched or mirrored as one, in whatever width."""
        ours, theirs = (
            _by(self.figures.of, [item for item in own if isinstance(item.stroke, Line)]) for own in self._left
        )
        for name, own in ours.items():
            others = theirs.get(name, [])
            shift = stretch_of(own, others, self.rounding)
            if shift is not None and shift.how != "moved":
                self._done(own, others)
                yield edit.together(own, self.figures, shift, False)

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
        for _, i, j in sorted(one for one in costs if one[0] < FAR):
            if i in left and j in right:
                left.discard(i)
                right.discard(j)
                self._done([ours[i]], [theirs[j]])
                yield self._told(ours[i], theirs[j])

    def _done(self, own: Sequence[Item], others: Sequence[Item]) -> None:
        mine, theirs = set(map(id, own)), set(map(id, others))
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

    def _told(self, ours: Item, theirs: Item) -> Edit:
        """Tell of one stroke that is another."""
        a, b = ours.stroke, theirs.stroke
        if isinstance(a, Text) and isinstance(b, Text):
            return self._text(ours, a, b)
        by = max(abs(x - y) for x, y in zip(spots(a), spots(b), strict=True))
        if reversed_lies(a, b, self.rounding) and not lies(a, b, self.rounding):
            return edit.retouched("reversed", ours, self.figures)
        if lies(a, b, self.rounding) or not alike_in_style(a.style, b.style):
            return edit.retouched("style", ours, self.figures, look=edit.style(a.style, b.style))
        if isinstance(a, Circle) and isinstance(b, Circle) and abs(a.centre - b.centre) <= self.rounding:
            return edit.moved("radius", ours, self.figures, abs(a.radius - b.radius))
        if isinstance(a, Line) and min(abs(x - y) for x, y in zip(spots(a), spots(b), strict=True)) <= self.rounding:
            return edit.moved("end", ours, self.figures, by)
        return edit.moved("moved" if self._same_shape(ours, theirs) else "reshaped", ours, self.figures, by)

    def _same_shape(self, ours: Item, theirs: Item) -> bool:
        a, b = spots(ours.stroke), spots(theirs.stroke)
        return all(abs((y - b[0]) - (x - a[0])) <= 2 * self.rounding for x, y in zip(a, b, strict=True))

    def _text(self, ours: Item, a: Text, b: Text) -> Edit:
        if a.runs != b.runs:
            return edit.retouched("text", ours, self.figures, is_=edit.written(b), must=edit.written(a))
        if abs(a.at - b.at) > self.rounding:
            return edit.moved("moved", ours, self.figures, abs(a.at - b.at))
        if not alike_in_style(a.style, b.style):
            return edit.retouched("style", ours, self.figures, look=edit.style(a.style, b.style))
        return edit.retouched("lettered", ours, self.figures)


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


def _by(key: Callable[[Item], Hashable], own: Sequence[Item]) -> dict[Hashable, list[Item]]:
    found: dict[Hashable, list[Item]] = defaultdict(list)
    for item in own:
        found[key(item)].append(item)
    return found


def nearest(item: Item, others: Sequence[Item]) -> float:
    """Give how far the nearest of other items is, mm."""
    return min((abs(middle(item.stroke) - middle(other.stroke)) for other in others), default=FAR)
