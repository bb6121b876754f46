"""Notes on a scene (замечания): what is allowed, but may well be a slip, such as millimetres taken for metres."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import NamedTuple

from plans.faults import TWINS, Fault, Path
from plans.fields import split_line
from plans.scene import FrameLine, Scene
from plans.units import WORKING

# Lengths in one mechanism that differ more (ratio of longest to shortest) are mostly of two units.
SPREAD = Decimal(10_000)
# A fault beyond this ratio: the shortest link moves the longest one by less than half the digits of a number can tell.
RATIO_LIMIT = Decimal(10_000_000)
# Metres: links of machines are shorter, and lengths in millimetres are mostly larger numbers.
METRES = Decimal(20)
# Where all angles of a list are smaller than a turn in radians, they were perhaps meant so.
TURN_IN_RADIANS = Decimal("6.3")
FEW_ANGLES = 3  # a shorter list tells nothing
RADIANS = re.compile(r"""["'].*\b(?:rad|рад)\s*["']""")


class Spread(NamedTuple):
    """The longest and the shortest length of a mechanism, by the names of their keys, and their ratio."""

    longest: str
    shortest: str
    ratio: Decimal


def spread(lengths: Mapping[str, Decimal]) -> Spread | None:
    """Compare the longest length with the shortest.

    >>> spread({"OA": Decimal("0.1"), "AB": Decimal(4), "CB": Decimal(2)})
    Spread(longest='AB', shortest='OA', ratio=Decimal('4E+1'))
    """
    if not lengths:
        return None
    longest, shortest = max(lengths, key=lambda key: lengths[key]), min(lengths, key=lambda key: lengths[key])
    return Spread(longest, shortest, WORKING.divide(lengths[longest], lengths[shortest]))


def notes_of(scene: Scene) -> list[Fault]:
    """Give the notes on a scene, in the order of its file."""
    found = [*_mark(scene), *_lengths(scene), *_angles(scene), *_twins(scene), *_spare_points(scene)]
    return sorted(found, key=lambda note: (note.line, note.column))


def _mark(scene: Scene) -> Iterator[Fault]:
    if scene.marked:
        yield scene.fault((), "byte_order_mark")


def _lengths(scene: Scene) -> Iterator[Fault]:
    lengths = scene.mechanism.lengths
    if lengths and max(lengths.values()) >= METRES:  # else nothing is odd, and the file need not be searched
        notes = {key: scene.fault(("mechanism", "lengths", key), "metres") for key in lengths}
        bare = [key for key in lengths if not notes[key].value.startswith(("'", '"'))]
        if bare and all(lengths[key] >= METRES for key in bare):
            details = {"least": METRES, "example": notes[bare[0]].value}
            yield scene.fault(("mechanism", "lengths", bare[0]), "metres", **details)
    apart = spread(lengths)
    if apart and apart.ratio > SPREAD:
        path = ("mechanism", "lengths", apart.longest)
        yield scene.fault(path, "spread", name=apart.longest, other=apart.shortest, ratio=f"{apart.ratio:.3g}")


def _angles(scene: Scene) -> Iterator[Fault]:
    drive = scene.drive
    start = drive.first
    if start is not None and abs(start) > 360:
        note = scene.fault(("drive", "start"), "degrees", turns=f"{start / 360:.3g}")
        if RADIANS.fullmatch(note.value):
            yield note
    if not isinstance(drive.positions, tuple):
        return
    whole = all(angle == angle.to_integral_value() for angle in drive.positions)
    small = all(abs(angle) < TURN_IN_RADIANS for angle in drive.positions)
    if small and not whole and len(drive.positions) >= FEW_ANGLES:
        example = next(angle for angle in drive.positions if angle)
        yield scene.fault(("drive", "positions"), "radians", most=TURN_IN_RADIANS, example=f"{example:f}")


def _twins(scene: Scene) -> Iterator[Fault]:
    """Find two points whose names differ only in an alphabet."""
    where: dict[str, Path] = {
        name: ("mechanism", "links", str(link)) for link, points in scene.mechanism.links.items() for name in points
    }
    where |= {name: ("mechanism", table, name) for table in ("points", "frame") for name in _table(scene, table)}
    plain: dict[str, str] = {}
    for name in sorted(where):
        other = plain.setdefault(name.translate(TWINS), name)
        if other != name:
            yield scene.fault(where[name], "twins", name=name, other=other)


def _table(scene: Scene, name: str) -> Mapping[str, object]:
    return scene.mechanism.frame if name == "frame" else scene.mechanism.points


def _spare_points(scene: Scene) -> Iterator[Fault]:
    used = {name for points in scene.mechanism.links.values() for name in points}
    for slide in scene.mechanism.slides:
        used.update(() if isinstance(slide.along, FrameLine) else slide.along)
    for key in scene.mechanism.lengths:
        used.update(split_line(key))
    for name in scene.mechanism.frame:
        if name not in used:
            yield scene.fault(("mechanism", "frame", name), "spare_point", name=name)
