"""What a drawing changes of a kept file, by statement: a letter, vector or number, and where (что изменилось)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path

from drawings.collation.collate import collate
from drawings.collation.edit import Edit
from drawings.eye.sheet import see
from drawings.gallery.alike import differences

STATED = frozenset(
    (
        "letter",
        "cell",
        "heading",
        "equation",
        "note",
        "title_cell",
        "vector",
        "point",
        "pole",
        "profile",
        "arrow",
        "couple",
    )
)
CARRIED = frozenset(("cell", "heading", "equation", "note", "title_cell"))  # that move with all around them
CHANGES = {"missing": "went", "added": "came", "text": "{must} -> {is_}"}
LINES = 20  # that are told of a report


def changes(fresh: Path, kept: Path) -> list[str]:
    """Tell what a drawn file says otherwise than the kept one; nothing of what processors round otherwise."""
    others = list(islice(differences(fresh, kept), LINES))
    if not others or kept.suffix != ".svg" or not kept.exists():
        return others
    ours, theirs = (see(path.read_bytes()).written for path in (kept, fresh))
    found = collate(ours, theirs)
    told = (*map(str, found.whole), *statements(found.edits))
    return [f"{kept.name}: {one}" for one in told] or [f"{others[0]}; nothing that is seen"]


def statements(edits: Iterable[Edit]) -> Iterator[str]:
    """Tell each statement that changed in a line, and what else moved, came or went in a line a figure."""
    strokes: dict[str, list[Edit]] = defaultdict(list)
    for edit in edits:
        if edit.what in STATED and not (edit.moved is not None and edit.what in CARRIED):
            yield f"{edit.what} {edit.name} on {edit.figure or 'the sheet'}: {_change(edit)}"
        else:
            strokes[edit.figure].append(edit)
    for figure, own in strokes.items():
        yield f"strokes of {figure or 'the sheet'}: {_counts(own)}"


def _change(edit: Edit) -> str:
    """Name what came of a statement."""
    if edit.moved is not None:
        return f"{edit.how} by {edit.moved:.3g} mm"
    return CHANGES[edit.how].format(**dict(edit.told.parts)) if edit.how in CHANGES else str(edit.told)


def _counts(own: Iterable[Edit]) -> str:
    """Count strokes by what came of them, with how far the farthest moved."""
    found: dict[str, list[Edit]] = defaultdict(list)
    for edit in own:
        found["went" if edit.how == "missing" else "came" if edit.how == "added" else edit.how].append(edit)
    return ", ".join(f"{sum(one.strokes for one in some)} {how}{_farthest(some)}" for how, some in found.items())


def _farthest(edits: Iterable[Edit]) -> str:
    moved = [edit.moved for edit in edits if edit.moved is not None]
    return f" by up to {max(moved):.3g} mm" if moved else ""
