"""Notes on a scene (замечания): what is allowed, but may well be a slip, such as millimetres taken for metres."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from itertools import combinations
from math import pi

from geometry.errors import DraftError
from plans.model.mechanism import Link, Mechanism
from plans.scene.faults import TWINS, Fault, Path
from plans.scene.fields import split_line
from plans.scene.linkage import mechanism_of
from plans.scene.loads import DiagramTable, MassTable
from plans.scene.scene import FORCES, FrameLine, Scene
from plans.scene.survey import spread

# Lengths in one mechanism that differ more (ratio of longest to shortest) are mostly of two units.
SPREAD = Decimal(10_000)
# Metres: links of machines are shorter, and lengths in millimetres are mostly larger numbers.
METRES = Decimal(20)
# Where all angles of a list are smaller than a turn in radians, they were perhaps meant so.
TURN_IN_RADIANS = Decimal("6.3")
HUNDREDS = 100  # times as much as anything else of its kind: mostly another unit
TWELFTH, ROUNDED = pi / 12, 0.002  # an angle of the drawing board, 15 degrees, in radians, to three figures
FEW_ANGLES = 3  # a shorter list tells nothing
# Gravity of the Earth, m/s2, and how many times it a machine stands at most: the Sun's is 28 times.
EARTH, MOST_EARTHS = Decimal("9.81"), 30
ROUGH = 1  # rubber on a dry road; a larger coefficient of friction is mostly a lost decimal point
RADIANS = re.compile(r"""["'].*\b(?:rad|рад)\s*["']""")


def notes_of(scene: Scene, forces: bool = False) -> list[Fault]:
    """Give the notes on a scene, in the order of its file; `forces` are asked for whatever its sheets are."""
    found = [*_mark(scene), *_lengths(scene), *_angles(scene), *_twins(scene), *_spare_points(scene)]
    found += [*_sketch(scene), *_rest(scene), *(() if forces else _unused(scene))]
    found += [*_masses(scene), *_gravity(scene), *_friction(scene), *_diagrams(scene)]
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
        else:
            yield from _enormous(scene, bare)
    apart = spread(lengths)
    if apart and apart.ratio > SPREAD:
        path = ("mechanism", "lengths", apart.longest)
        yield scene.fault(path, "spread", name=apart.longest, other=apart.shortest, ratio=f"{apart.ratio:.3g}")


def _enormous(scene: Scene, bare: list[str]) -> Iterator[Fault]:
    """Find bare lengths a hundred times as long as the longest of the others."""
    lengths = scene.mechanism.lengths
    for key in bare:
        others = max((size for other, size in lengths.items() if other != key), default=lengths[key])
        if lengths[key] >= METRES and lengths[key] >= HUNDREDS * others:
            details = {"name": key, "ratio": f"{lengths[key] / others:.3g}"}
            note = scene.fault(("mechanism", "lengths", key), "enormous", **details)
            yield scene.fault(note.path, "enormous", example=note.value, **details)


def _angles(scene: Scene) -> Iterator[Fault]:
    drive = scene.drive
    start = drive.first
    if start is not None and abs(start) > 360:
        note = scene.fault(("drive", "start"), "degrees", turns=f"{start / 360:.3g}")
        if RADIANS.fullmatch(note.value):
            yield note
    for path, angle in _single(scene):
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


def _single(scene: Scene) -> Iterator[tuple[Path, Decimal]]:
    """Give the angles that stand alone, as bare numbers or not."""
    if isinstance(scene.drive.start, Decimal):
        yield ("drive", "start"), scene.drive.start
    for index, slide in enumerate(scene.mechanism.slides):
        path: Path = ("mechanism", "slides", index)
        yield (*path, "angle"), slide.angle
        if isinstance(slide.along, FrameLine):
            yield (*path, "along", "angle"), slide.along.angle


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
    for spring in scene.loads.springs if scene.loads else ():
        used.update(end for end in spring.between if isinstance(end, str))
    for name in scene.mechanism.frame:
        if name not in used:
            yield scene.fault(("mechanism", "frame", name), "spare_point", name=name)


def _sketch(scene: Scene) -> Iterator[Fault]:
    """Find fixed points that the sketch shows in another place."""
    for name, place in scene.mechanism.sketch.items():
        if scene.mechanism.frame.get(name, place) != place:
            yield scene.fault(("mechanism", "sketch", name), "fixed_sketch", name=name)


def _rest(scene: Scene) -> Iterator[Fault]:
    if not scene.drive.speed and not scene.drive.acceleration:
        yield scene.fault(("drive", "speed"), "at_rest")


def _unused(scene: Scene) -> Iterator[Fault]:
    """Find what forces alone need, where no sheet tells any."""
    if FORCES in scene.sheets:
        return
    given = {(name,): getattr(scene, name) for name in ("masses", "loads", "friction")}
    asked: dict[Path, object] = {("drive", name): name in scene.drive.given for name in ("gear", "balancing")}
    asked |= {("sheet", name): name in scene.sheet.given for name in ("forces", "hodographs", "reactions")}
    yield from (scene.fault(path, "unused") for path, there in (given | asked).items() if there)


def _friction(scene: Scene) -> Iterator[Fault]:
    if scene.friction is None:
        return
    path: Path = ("friction",)
    found = {path: scene.friction.coefficient}
    found |= {(*path, "pairs", name): pair.coefficient or Decimal(0) for name, pair in scene.friction.pairs.items()}
    yield from (scene.fault((*path, "coefficient"), "rough") for path, value in found.items() if value > ROUGH)


def _masses(scene: Scene) -> Iterator[Fault]:
    """Find mass centres far outside their links, and inertia about a hinge given for that about the centre."""
    mechanism = _mechanism(scene) if scene.masses else None
    if mechanism is None:
        return
    longest = max(map(_length, mechanism.links.values()))
    for number, mass in scene.masses.items():
        link, path = mechanism.links[number], ("masses", str(number))
        yield from _centre(scene, (*path, "centre"), mass, link, _length(link) or longest)
        most = float(mass.mass) * _length(link) ** 2
        # A crank has its gear or flywheel in its inertia, and a block no length.
        if number != mechanism.drive.link and _length(link) and float(mass.inertia) > most:
            details = {"inertia": f"{mass.inertia:.4g}", "most": f"{most:.4g}", "link": number}
            kind = "large_inertia" if float(mass.inertia) < HUNDREDS * most else "inertia_unit"
            yield scene.fault((*path, "inertia"), kind, **details)
    yield from _radii(scene, float(longest))


def _radii(scene: Scene, longest: float) -> Iterator[Fault]:
    """Find journals and gears that are larger than machines with such links have."""
    given: dict[Path, tuple[Decimal | None, float]] = {}
    if scene.friction is not None:
        given["friction", "radius"] = scene.friction.radius, longest
    if scene.drive.gear is not None:
        given["drive", "gear", "radius"] = scene.drive.gear.radius, HUNDREDS * longest
    for path, (radius, most) in given.items():
        if radius is not None and float(radius) > most > 0:
            note = scene.fault(path, "large_radius", longest=f"{longest:.4g}", example="")
            yield scene.fault(path, "large_radius", longest=f"{longest:.4g}", example=note.value)


def _centre(scene: Scene, path: Path, mass: MassTable, link: Link, size: float) -> Iterator[Fault]:
    centre = mass.place(link)
    far = min(abs(centre - place) for place in link.points.values())
    if far > size:
        yield scene.fault(path, "far_centre", far=f"{far:.4g}", link=link.number)


def _mechanism(scene: Scene) -> Mechanism | None:
    """Give the mechanism, for the shapes of its links; none where the scene has faults, which are told instead."""
    try:
        return mechanism_of(scene)
    except DraftError:
        return None


def _length(link: Link) -> float:
    """Give the largest distance between points of a link."""
    return max((abs(one - other) for one, other in combinations(link.points.values(), 2)), default=0.0)


def _gravity(scene: Scene) -> Iterator[Fault]:
    given = scene.loads.gravity if scene.loads else None
    path = ("loads", "gravity")
    if given is None:
        if FORCES in scene.sheets and any(mass.mass for mass in scene.masses.values()):
            yield scene.fault(("masses",), "weightless")
        return
    size = max(map(abs, given)) if isinstance(given, tuple) else abs(given)
    if size > MOST_EARTHS * EARTH:
        yield scene.fault(path, "heavy", ratio=f"{size / EARTH:.0f}", example=f"{size.normalize():f}")
    elif not isinstance(given, tuple) and given < 0:
        yield scene.fault(path, "upward")


def _diagrams(scene: Scene) -> Iterator[Fault]:
    """Find indicator diagrams whose two strokes do not meet at their ends."""
    for index, force in enumerate(scene.loads.forces if scene.loads else ()):
        table, path = force.diagram, ("loads", "forces", index, "diagram", "back")
        for share, there, back in _ends(table) if table and table.back else ():
            if there != back:
                yield scene.fault(path, "open_diagram", travel=f"{share:f}", jump=f"{abs(there - back):f}")


def _ends(table: DiagramTable) -> Iterator[tuple[Decimal, Decimal, Decimal]]:
    """Give the two ends of a diagram: share of the stroke, force, and force on the idle stroke."""
    yield from ((table.travel[end], table.force[end], table.back[end]) for end in (0, -1))
