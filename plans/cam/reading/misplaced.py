"""Keys of a cam that its follower, its phases or its closure have no use for (лишние данные)."""

from __future__ import annotations

from plans.cam.reading.entry import Entry
from plans.model.cam import DWELL, ROLLER


def misplaced(entry: Entry) -> None:
    """Put a fault at each key that is of another kind of cam."""
    _follower(entry)
    _phases(entry)
    _sizes(entry)
    _load(entry)
    if entry.translates and entry.flat:
        entry.fault(("follower", "end"), "flat_translating")


def _follower(entry: Entry) -> None:
    given = entry.form.follower.given
    if not entry.rocks:
        entry.spare(("swing", "length", "turns"), given, "rocking", "follower")
    else:
        entry.spare(("lift",), given, "translating", "follower")
    if entry.rocks and entry.flat:
        entry.spare(("length",), given, "pinned", "follower")
    else:
        entry.spare(("face",), given, "flat_rocking", "follower")
    if not entry.flat:
        entry.spare(("reach",), given, "flat", "follower")


def _phases(entry: Entry) -> None:
    part, owner = ("lift", "translating") if entry.rocks else ("swing", "rocking")
    for number, phase in enumerate(entry.form.phases):
        entry.spare((part,), phase.given, owner, "phases", number)
        if phase.kind == DWELL and entry.path("phases", number, "kind") not in entry.doubts:
            entry.spare({"law", "lift", "swing"} - {part}, phase.given, "moving", "phases", number)


def _sizes(entry: Entry) -> None:
    given = entry.form.sizes.given
    if entry.form.follower.end != ROLLER:
        entry.spare(("roller",), given, "roller", "sizes")
    if entry.translates:
        entry.spare(("base", "offset", "centre"), given, "turning", "sizes")
    elif entry.rocks:
        entry.spare(("offset",), given, "translating", "sizes")
    else:
        entry.spare(("centre",), given, "rocking", "sizes")
    if not entry.flat:
        entry.spare(("curvature",), entry.form.limits.given, "flat", "limits")


def _load(entry: Entry) -> None:
    given = entry.form.load.given if entry.form.load else ()
    names, owner = (("mass", "force"), "translating") if entry.rocks else (("inertia", "moment"), "rocking")
    entry.spare(names, given, owner, "load")
