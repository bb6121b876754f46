"""Notes on cams (замечания): what is allowed, but may well be a slip, what is mended, and what is taken unasked."""

from __future__ import annotations

import math
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

from plans.cam.reading.cams import WHOLE, entries_of
from plans.cam.reading.entry import CamEntry, pace_of, shown
from plans.cam.reading.fields import CYCLOGRAM, REST
from plans.cam.reading.phase_form import LawTable
from plans.model.cam import BOOK_LIMITS, DWELL, FORCE, GROOVE, RISE, TABLE
from plans.scene import units
from plans.scene.faults import Fault, Path
from plans.scene.notes import odd_lengths
from plans.scene.scene import Scene

FEW_POINTS = 3  # of a table: what lies between them is the curve's, not the table's


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's cams."""
    entries = [*entries_of(scene)]
    yield from odd_lengths(scene, {path: size for entry in entries for path, size in _lengths(entry)})
    # One shaft has one speed: that of the first cam that turns.
    found = ((entry, *pace_of(entry)) for entry in entries if not entry.translates)
    paces = [(entry, sense * speed) for entry, sense, speed in found if speed]
    for entry, pace in paces[1:]:
        if pace != paces[0][1] and entry.form.speed is not None:
            first = {"name": paces[0][0].name, "first": f"{paces[0][1]:.5g}"}
            yield _note(entry, ("speed",), "other_pace", found=f"{pace:.5g}", **first)
    for entry in entries:
        for notes in (_turns, _dwells, _way, _limits, _laws, _unused):
            yield from notes(entry)


def _lengths(entry: CamEntry) -> Iterator[tuple[Path, Decimal]]:
    """Give the lengths m that a cam states; a zero is one in any unit."""
    follower, sizes = entry.form.follower, entry.form.sizes
    stated = {("follower", name): getattr(follower, name) for name in ("lift", "length")}
    stated |= {("sizes", name): getattr(sizes, name) for name in ("base", "offset", "centre", "roller")}
    return ((entry.path(*path), abs(size)) for path, size in stated.items() if size)


def _note(entry: CamEntry, path: Path, kind: str, **details: object) -> Fault:
    return entry.scene.fault(entry.path(*path), kind, **details)


def _turns(entry: CamEntry) -> Iterator[Fault]:
    """Tell of a sum that was near a whole turn and is taken for one."""
    angles = [phase.angle for phase in entry.form.phases]
    if entry.translates or REST in angles or CYCLOGRAM in angles:
        return
    total = sum((Fraction(angle) for angle in angles if isinstance(angle, Decimal)), Fraction(0))
    if total != WHOLE:
        largest = max(range(len(angles)), key=lambda number: Fraction(angles[number] or 0))
        yield _note(entry, ("phases", largest, "angle"), "turn_snapped", found=f"{float(total):.12g}")


def _dwells(entry: CamEntry) -> Iterator[Fault]:
    kinds = [phase.kind for phase in entry.form.phases]
    for number in range(1, len(kinds)):
        if kinds[number - 1] == kinds[number] == DWELL:
            yield _note(entry, ("phases", number, "kind"), "two_dwells")


def _way(entry: CamEntry) -> Iterator[Fault]:
    """Find a follower that does not move, or moves farther than the cam is wide."""
    base, key = entry.form.sizes.base, "swing" if entry.rocks else "lift"
    if entry.lift == 0:
        yield _note(entry, ("follower", key), "no_lift")
    elif base is not None and not entry.rocks and entry.lift >= 2 * Fraction(base):
        yield _note(entry, ("follower", key), "high_lift", base=shown(1000 * base))


def _limits(entry: CamEntry) -> Iterator[Fault]:
    """Tell of limits that nothing is found from, and of those that are taken from the book."""
    given, sizes = entry.form.limits.given, entry.form.sizes
    if "return" in given and entry.form.closure == FORCE:
        yield _note(entry, ("limits", "return"), "free_return")
    if entry.flat and not entry.rocks:
        yield from (_note(entry, ("limits", name), "level_face") for name in ("rise", "return") if name in given)
        if "offset" in sizes.given:
            yield _note(entry, ("sizes", "offset"), "spare_offset")
    if entry.flat and sizes.base is None and not entry.form.limits.curvature:
        yield _note(entry, (), "sharp_face", name=entry.name)
    if entry.flat or entry.translates or _sized(entry):
        return
    most = f"{math.degrees(BOOK_LIMITS[entry.form.follower.motion]):g}"
    kept = ("rise", "return") if entry.form.closure == GROOVE else ("rise",)
    for name in kept:
        if name not in given:
            yield _note(entry, (), f"book_{name}", name=entry.name, most=most)


def _sized(entry: CamEntry) -> bool:
    """Tell whether no size is left to be found by limits: without any a radius alone is that of a radial follower."""
    given, limits = entry.form.sizes.given, entry.form.limits.given & {"rise", "return"}
    return "base" in given and ("centre" in given if entry.rocks else "offset" in given or not limits)


def _laws(entry: CamEntry) -> Iterator[Fault]:
    """Tell of tables with few points, and of those that are smoothed."""
    for number, phase in enumerate(entry.form.phases):
        law, path = phase.law, ("phases", number, "law")
        if not isinstance(law, LawTable) or law.name != TABLE:
            continue
        levels = [s.of(units.ANGLE if entry.rocks else units.LENGTH) for _, s in law.points]
        way = 1 if phase.kind == RISE else -1
        back = [at for at, (level, other) in enumerate(pairwise(levels), 1) if way * (other - level) < 0]
        if back and phase.kind != DWELL:
            yield _note(entry, (*path, "points", back[0], 1), "table_falls" if phase.kind == RISE else "table_rises")
        if len(law.points) <= FEW_POINTS:
            yield _note(entry, (*path, "points"), "sparse_table", count=len(law.points))
        if law.tolerance is not None and law.tolerance.of(units.ANGLE if entry.rocks else units.LENGTH):
            yield _note(entry, (*path, "tolerance"), "smoothed")


def _unused(entry: CamEntry) -> Iterator[Fault]:
    """Find a spring or a flat face beside a groove, and a mass that needs a speed."""
    if entry.form.closure == GROOVE:
        if entry.flat:
            yield _note(entry, ("closure",), "flat_groove")
        yield from _each(entry, "idle_spring", "preload", "stiffness")
    if entry.form.speed is None and (entry.translates or not entry.scene.has(("drive",))):
        yield from _each(entry, "still_cam", "mass", "inertia")


def _each(entry: CamEntry, kind: str, *names: str) -> Iterator[Fault]:
    """Give a note at each of some keys of the load that is given."""
    given = entry.form.load.given if entry.form.load else ()
    return (_note(entry, ("load", name), kind) for name in names if name in given)
