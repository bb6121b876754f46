"""Collation of two sheets: the one that must be, and the one that is there (сличение двух листов)."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any, NamedTuple

from drawings.collation import edit
from drawings.collation.edit import STILL, Edit, Figures
from drawings.collation.items import BEARERS, Ink, Item, items
from drawings.collation.matching import lies, match
from drawings.collation.pairing import Pairing
from drawings.collation.spots import brought, middle, spots
from drawings.eye.covering import crosses
from drawings.measure.transform import STAY, Affine, placing
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Circle, Group, Leaf, Text
from drawings.paper.walk import groups
from plans.words.words import Message, message


def covered(patch: Ink, drawn: Sequence[Item]) -> list[Item]:
    """List what has its middle under an area; nothing is under what is not filled."""
    if isinstance(patch, Text) or patch.style.fill == "none":
        return []
    return [item for item in drawn if _holds(patch, middle(item.stroke))]


def _holds(patch: Ink, spot: complex) -> bool:
    """Tell whether a place lies within an outline: a ray to the right of it crosses that an odd number of times."""
    if isinstance(patch, Circle):
        return abs(spot - patch.centre) < patch.radius
    own = spots(patch)
    return sum(crosses(a - spot, b - spot) for a, b in pairwise((*own, own[0]))) % 2 == 1


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
    laid = there if back == STAY else replace(there, groups=tuple(_brought(group, back) for group in there.groups))
    figures = Figures(right)
    ours = items(right)
    found = match(ours, items(laid), rounding)
    left = _unusual(hidden, usual, rounding)
    unseen = list(_hidden(found.missing, left, figures, rounding))
    gone = {id(item) for item, _ in unseen}
    pairing = Pairing([item for item in found.missing if id(item) not in gone], found.added, figures, rounding)
    copies = (edit.lone("copied", item, figures) for item in found.copies)
    under = {id(one.item): covered(one.item.stroke, ours) for one in left}
    others = [edit.unseen(one.item, one.reason, figures, under[id(one.item)]) for one in left]
    patched = {id(item) for own in under.values() for item in own}
    marks = (edit.restated(ours, theirs, figures) for ours, theirs in found.same if _restated(ours, theirs))
    # What a patch covers is told of the patch.
    edits = (
        *(told for item, told in unseen if id(item) not in patched),
        *marks,
        *pairing.edits(_counts(ours, figures)),
        *copies,
        *others,
    )
    return Collation(edits, *_shares(ours, found.missing), (*_paper(right, there), *whole, *_told(right, there)))


def _shares(ours: Sequence[Item], missing: Sequence[Item]) -> tuple[int, int]:
    """Count what is as it must be, and all that must be, without what every sheet has."""
    own, gone = ([item for item in some if item.home.figure not in STILL] for some in (ours, missing))
    return len(own) - len(gone), len(own)


def _counts(ours: Sequence[Item], figures: Figures) -> dict[str, int]:
    return Counter(figures.of(item) for item in ours)


def _hidden(
    missing: Sequence[Item], left: list[Hidden], figures: Figures, rounding: float
) -> Iterator[tuple[Item, Edit]]:
    """Tell what is in its place in the file and cannot be seen; that is taken from what is left of the hidden."""
    for item in missing:
        place = next((k for k, one in enumerate(left) if _one_place(item, one.item, rounding)), None)
        if place is not None:
            yield item, edit.lone("hidden", item, figures, reason=left.pop(place).reason)


def _restated(ours: Item, theirs: Item) -> bool:
    """Tell whether a mark is drawn as it must be, and states something else of itself."""
    return ours.what in BEARERS.values() and ours.home.mark != theirs.home.mark


def _unusual(hidden: Sequence[Hidden], usual: Sequence[Hidden], rounding: float) -> list[Hidden]:
    left = list(usual)
    found = []
    for one in hidden:
        place = next((k for k, other in enumerate(left) if _one_place(one.item, other.item, rounding)), None)
        if place is None:
            found.append(one)
        else:
            left.pop(place)
    return found


def _one_place(item: Item, other: Item, rounding: float) -> bool:
    return type(item.stroke) is type(other.stroke) and lies(item.stroke, other.stroke, rounding)


def _paper(right: Leaf, there: Leaf) -> Iterator[Message]:
    """Tell paper of another size."""
    if abs(right.width - there.width) > MILLIMETRE or abs(right.height - there.height) > MILLIMETRE:
        sizes = ((f"{leaf.width:.6g}", f"{leaf.height:.6g}") for leaf in (there, right))
        (width, height), (must_width, must_height) = sizes
        yield message("edit.paper", width=width, height=height, must_width=must_width, must_height=must_height)


def _told(right: Leaf, there: Leaf) -> Iterator[Message]:
    """Tell what a file says of itself otherwise than it must, beside who drew it and from what."""
    if (right.title, right.description) != (there.title, there.description):
        yield message("edit.title")
    keys = sorted({*right.metadata, *there.metadata} - set(SIGNED))
    for key in keys:
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
    told = message(
        "edit.all", by=f"{max(abs(a - b) for a, b in zip(stated, found, strict=True)):.4g}", scale=f"{abs(by.p):.6g}"
    )
    return Affine(1 / by.p, 0j, -by.t / by.p), (told,)


def _corners(leaf: Leaf) -> Mapping[str, complex]:
    """Give the corner marks of a sheet by what they state."""
    own = (group for group in groups(leaf.groups) if group.data.get("kind") == "corner")
    return {
        one.data.get("value", ""): one.strokes[0].centre
        for one in own
        if one.strokes and isinstance(one.strokes[0], Circle)
    }


def _brought(group: Group, by: Affine) -> Group:
    moved = brought(group, by)
    assert isinstance(moved, Group)
    return moved
