"""Notes on masses and loads (замечания): what is allowed, but may well be a slip, such as another unit of inertia."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from itertools import combinations

from geometry.errors import DraftError
from plans.forces.reading.form import FORCES, ForceForm, ForceTable, MassTable
from plans.forces.reading.pressed import DiagramTable
from plans.linkage.reading.linkage import mechanism_of
from plans.model.mechanism import Link, Mechanism
from plans.scene.faults import Fault, Path
from plans.scene.notes import HUNDREDS
from plans.scene.scene import Scene

# Gravity of the Earth, m/s2, and how many times it a machine stands at most: the Sun's is 28 times.
EARTH, MOST_EARTHS = Decimal("9.81"), 30
HIGH, LOW = Decimal("1e8"), Decimal(1000)  # Pa: presses have up to 70 MPa, and a fan gives a few kilopascals
UNEVEN = 10_000  # times the least pressure of a load: compressors raise it a hundredfold, MPa for Pa is a million
SLOT = 2.0  # times the longest length of the mechanism: a slot reaches at most across the circle of its pin
ROUGH = 1  # rubber on a dry road; a larger coefficient of friction is mostly a lost decimal point


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on masses, loads and friction."""
    form = scene.of(ForceForm)
    for notes in (_masses, _gravity, _friction, _diagrams, _pistons):
        yield from notes(scene, form)


def _friction(scene: Scene, form: ForceForm) -> Iterator[Fault]:
    if form.friction is None:
        return
    path: Path = ("friction",)
    found = {path: form.friction.coefficient}
    found |= {(*path, "pairs", name): pair.coefficient or Decimal(0) for name, pair in form.friction.pairs.items()}
    yield from (scene.fault((*path, "coefficient"), "rough") for path, value in found.items() if value > ROUGH)


def _masses(scene: Scene, form: ForceForm) -> Iterator[Fault]:
    """Find mass centres far outside their links, and inertia about a hinge given for that about the centre."""
    mechanism = _mechanism(scene) if form.masses else None
    if mechanism is None:
        return
    longest = max(map(_length, mechanism.links.values()))
    for number, mass in form.masses.items():
        link, path = mechanism.links[number], ("masses", str(number))
        slotted = any(slide.owner == number for slide in mechanism.slides)
        room = _length(link) or (SLOT if slotted else 1.0) * longest
        yield from _centre(scene, (*path, "centre"), mass, link, room)
        most = float(mass.mass) * _length(link) ** 2
        # A crank has its gear or flywheel in its inertia, and a block no length.
        if number != mechanism.drive.link and _length(link) and float(mass.inertia) > most:
            details = {"inertia": f"{mass.inertia:.4g}", "most": f"{most:.4g}", "link": number}
            kind = "large_inertia" if float(mass.inertia) < HUNDREDS * most else "inertia_unit"
            yield scene.fault((*path, "inertia"), kind, **details)
    yield from _radii(scene, form, float(longest))


def _radii(scene: Scene, form: ForceForm, longest: float) -> Iterator[Fault]:
    """Find journals and gears that are larger than machines with such links have."""
    given: dict[Path, tuple[Decimal | None, float]] = {}
    if form.friction is not None:
        given["friction", "radius"] = form.friction.radius, longest
    if form.drive.gear is not None:
        given["drive", "gear", "radius"] = form.drive.gear.radius, HUNDREDS * longest
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


def _gravity(scene: Scene, form: ForceForm) -> Iterator[Fault]:
    given = form.loads.gravity if form.loads else None
    path = ("loads", "gravity")
    if given is None:
        if FORCES in scene.sheets and any(mass.mass for mass in form.masses.values()):
            yield scene.fault(("masses",), "weightless")
        return
    size = max(map(abs, given)) if isinstance(given, tuple) else abs(given)
    if size > MOST_EARTHS * EARTH:
        yield scene.fault(path, "heavy", ratio=f"{size / EARTH:.0f}", example=f"{size.normalize():f}")
    elif not isinstance(given, tuple) and given < 0:
        yield scene.fault(path, "upward")


def _diagrams(scene: Scene, form: ForceForm) -> Iterator[Fault]:
    """Find indicator diagrams whose two strokes do not meet at their ends."""
    for index, force in enumerate(form.loads.forces if form.loads else ()):
        table, path = force.diagram, ("loads", "forces", index, "diagram", "back")
        for share, there, back in _ends(table) if table and table.back else ():
            if there != back:
                name, unit = ("pressure", "Pa") if table and table.pressure else ("force", "N")
                told = {"travel": f"{share:f}", "jump": f"{abs(there - back):f}", "name": name, "unit": unit}
                yield scene.fault(path, "open_diagram", **told)


def _pistons(scene: Scene, form: ForceForm) -> Iterator[Fault]:
    """Find pressures of another unit, and pistons that are wider than the mechanism's longest link."""
    forces = form.loads.forces if form.loads else ()
    pressed = {("loads", "forces", index): force for index, force in enumerate(forces) if force.pressed}
    mechanism = _mechanism(scene) if pressed else None
    longest = max(map(_length, mechanism.links.values())) if mechanism else 0.0
    for path, force in pressed.items():
        where = (*path, "pressure") if force.pressure is not None else (*path, "diagram", "pressure")
        sizes = force.diagram.there + force.diagram.back if force.diagram else (force.pressure or Decimal(0),)
        most = max(map(abs, sizes))
        if most > HIGH:
            yield scene.fault(where, "high_pressure", size=f"{most / 1_000_000:.4g}")
        elif 0 < most < LOW:
            yield scene.fault(where, "low_pressure", size=f"{most:.4g}")
        else:
            yield from _uneven(scene, path, force)
        if force.bore is not None and float(force.bore) > longest > 0:
            yield scene.fault((*path, "bore"), "wide_bore", longest=f"{longest:.4g}")


def _uneven(scene: Scene, path: Path, force: ForceTable) -> Iterator[Fault]:
    """Find pressures of one load of which one is given in another unit than the others."""
    given = {(*path, "behind"): force.behind, (*path, "pressure"): force.pressure or Decimal(0)}
    for name in ("pressure", "back") if force.diagram else ():
        given |= {(*path, "diagram", name, k): size for k, size in enumerate(getattr(force.diagram, name))}
    sizes = {where: abs(size) for where, size in given.items() if size}
    least, most = min(sizes, key=sizes.__getitem__, default=None), max(sizes.values(), default=Decimal(0))
    if least is not None and most >= UNEVEN * sizes[least]:
        yield scene.fault(least, "uneven_pressures", size=f"{float(sizes[least]):.6g}", most=f"{float(most):.6g}")


def _ends(table: DiagramTable) -> Iterator[tuple[Decimal, Decimal, Decimal]]:
    """Give the two ends of a diagram: share of the stroke, force, and force on the idle stroke."""
    yield from ((table.shares[end], table.there[end], table.back[end]) for end in (0, -1))
