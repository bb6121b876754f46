"""Notes on a linkage (замечания): what is allowed, but may well be a slip, such as millimetres taken for metres."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from decimal import Decimal
from math import pi

from plans.linkage.reading.fields import split_line
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.stroke import LineTable
from plans.linkage.reading.survey import spread
from plans.scene.faults import TWINS, Fault, Path
from plans.scene.notes import odd_lengths
from plans.scene.scene import Scene

# Lengths in one mechanism that differ more (ratio of longest to shortest) are mostly of two units.
SPREAD = Decimal(10_000)
# Where all angles of a list are smaller than a turn in radians, they were perhaps meant so.
TURN_IN_RADIANS = Decimal("6.3")
TWELFTH, ROUNDED = pi / 12, 0.002  # an angle of the drawing board, 15 degrees, in radians, to three figures
FEW_ANGLES = 3  # a shorter list tells nothing
RADIANS = re.compile(r"""["'].*\b(?:rad|рад)\s*["']""")


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a linkage and its drive."""
    form = scene.of(LinkageForm)
    for notes in (_lengths, _angles, _twins, _spare_points, _sketch, _rest):
        yield from notes(scene, form)


def _lengths(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    lengths = form.mechanism.lengths
    stated: dict[Path, Decimal] = {("mechanism", "lengths", key): size for key, size in lengths.items()}
    yield from odd_lengths(scene, stated, lambda path: str(path[-1]))
    apart = spread(lengths)
    if apart and apart.ratio > SPREAD:
        path = ("mechanism", "lengths", apart.longest)
        yield scene.fault(path, "spread", name=apart.longest, other=apart.shortest, ratio=f"{apart.ratio:.3g}")


def _angles(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    drive = form.drive
    start = drive.first
    if start is not None and abs(start) > 360:
        note = scene.fault(("drive", "start"), "degrees", turns=f"{start / 360:.3g}")
        if RADIANS.fullmatch(note.value):
            yield note
    for path, angle in _single(form):
        share = round(float(angle) / TWELFTH)
        if share and abs(angle) < TURN_IN_RADIANS and abs(float(angle) - share * TWELFTH) < ROUNDED:
            yield scene.fault(path, "radian", example=f"{angle:f}", degrees=15 * share)
    if not isinstance(drive.positions, tuple):
        return
    whole = all(angle == angle.to_integral_value() for angle in drive.positions)
    small = all(abs(angle) < TURN_IN_RADIANS for angle in drive.positions)
    if small and not whole and len(drive.positions) >= FEW_ANGLES:
        example = next(angle for angle in drive.positions if angle)
        yield scene.fault(("drive", "positions"), "radians", most=TURN_IN_RADIANS, example=f"{example:f}")


def _single(form: LinkageForm) -> Iterator[tuple[Path, Decimal]]:
    """Give the angles that stand alone, as bare numbers or not."""
    if isinstance(form.drive.start, Decimal):
        yield ("drive", "start"), form.drive.start
    for index, slide in enumerate(form.mechanism.slides):
        path: Path = ("mechanism", "slides", index)
        yield (*path, "angle"), slide.angle
        if isinstance(slide.along, LineTable):
            yield (*path, "along", "angle"), slide.along.angle


def _twins(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    """Find two points whose names differ only in an alphabet."""
    where: dict[str, Path] = {
        name: ("mechanism", "links", str(link)) for link, points in form.mechanism.links.items() for name in points
    }
    where |= {name: ("mechanism", table, name) for table, names in _placed(form) for name in names}
    plain: dict[str, str] = {}
    for name in sorted(where):
        other = plain.setdefault(name.translate(TWINS), name)
        if other != name:
            yield scene.fault(where[name], "twins", name=name, other=other)


def _placed(form: LinkageForm) -> Iterator[tuple[str, Iterable[str]]]:
    """Give the tables of points that have their own places."""
    yield from (("points", form.mechanism.points), ("frame", form.mechanism.frame))


def _spare_points(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    used = {name for points in form.mechanism.links.values() for name in points}
    for slide in form.mechanism.slides:
        used.update(filter(None, [slide.along.letter]) if isinstance(slide.along, LineTable) else slide.along)
    for key in form.mechanism.lengths:
        used.update(split_line(key))
    used.update((form.drive.stroke and form.drive.stroke.between) or ())  # the foot of a cylinder
    used.update(*(other.borrowed() for other in scene.forms))
    for name in form.mechanism.frame:
        if name not in used:
            yield scene.fault(("mechanism", "frame", name), "spare_point", name=name)


def _sketch(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    """Find fixed points that the sketch shows in another place."""
    for name, place in form.mechanism.sketch.items():
        if form.mechanism.frame.get(name, place) != place:
            yield scene.fault(("mechanism", "sketch", name), "fixed_sketch", name=name)


def _rest(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    stroke, drive = form.drive.stroke, form.drive
    if not any(stroke.rates if stroke else (drive.speed, drive.acceleration)):
        still: Path = ("drive", "stroke", "speed") if stroke else ("drive", "speed")
        yield scene.fault(still, "stroke_at_rest" if stroke else "at_rest")
