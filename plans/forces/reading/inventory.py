"""The inventory of a machine (машина): what a scene's masses, loads, drive and friction are in numbers.

Only what asks for forces pays for it.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from math import radians

from plans.forces.loading import output_at
from plans.forces.reading import form as tables
from plans.forces.reading import references
from plans.forces.reading.fields import Ends, Vector, holders, point_of
from plans.forces.reading.pressed import BEHIND, PRESSED, DiagramTable
from plans.linkage.reading.guides import direction
from plans.model.decomposition import decompose
from plans.model.dyad import pairs
from plans.model.machine import (
    GEAR,
    Body,
    Diagram,
    End,
    Force,
    Machine,
    Moment,
    Piston,
    Rubbing,
    Spring,
    Track,
    Transmission,
)
from plans.model.mechanism import AGAINST, FRAME, SLOWER, Mechanism, Parting
from plans.scene.faults import Path, SceneError
from plans.scene.scene import Scene
from plans.scene.units import within
from plans.words.words import message

# Letters of a lone useful force against the motion (полезное сопротивление) and of a spring, where the scene has none.
USEFUL, SPRING = "F_us", "F_s"


def machine_of(scene: Scene, mechanism: Mechanism) -> Machine:
    """Make the machine of a scene; a pair of friction or a hodograph that is told of no reaction is a SceneError."""
    form = scene.of(tables.ForceForm)
    _check_told(scene, form, mechanism)
    loads = form.loads or tables.LoadsTable()
    names = iter(letters(loads))
    return Machine(
        {
            link: Body(link, float(mass.mass), float(mass.inertia), mass.place(mechanism.links[link]))
            for link, mass in form.masses.items()
        },
        gravity(loads.gravity),
        tuple(_force(next(names), force, mechanism) for force in loads.forces),
        tuple(_moment(next(names), moment) for moment in loads.moments),
        tuple(_spring(next(names), spring, mechanism) for spring in loads.springs),
        _transmission(form.drive.balancing, form.drive.gear),
        _rubbing(form.friction, mechanism),
    )


def letters(loads: tables.LoadsTable) -> list[str]:
    """Give the letters of all forces, moments and springs: the scene's own, or F_us, F_D, M_3, F_s made distinct."""
    against = [force for force in loads.forces if force.against is not None and force.useful]
    lone = against[0] if len(against) == 1 else None
    named = [(force.name, USEFUL if force is lone else f"F_{_places(force)}") for force in loads.forces]
    named += [(moment.name, f"M_{moment.on}") for moment in loads.moments]
    named += [(spring.name, SPRING) for spring in loads.springs]
    taken = {name for name, _ in named if name is not None}
    found = []
    for given, name in named:
        # Make a name another than those taken: F_s, F_s1, F_s2.
        found.append(given or next(other for k in range(len(taken) + 1) if (other := f"{name}{k or ''}") not in taken))
        taken.add(found[-1])
    return found


def _places(force: tables.ForceTable) -> str:
    return "".join(map(point_of, force.between)) if force.between is not None else force.point or ""


def gravity(given: Decimal | Vector | None) -> complex:
    """Give gravity as a vector m/s2: a number is downward, and what is not given is none.

    >>> gravity(Decimal("9.81")), gravity(None), gravity((Decimal(1), Decimal(-2)))
    (-9.81j, 0j, (1-2j))
    """
    if isinstance(given, tuple):
        return complex(float(given[0]), float(given[1]))
    return complex(0.0, -float(given)) if given else 0j


def _force(name: str, force: tables.ForceTable, mechanism: Mechanism) -> Force:
    given = force.value if force.pressure is None else Decimal(force.forced(force.pressure))
    size, course = _sized(given, force.direction)
    diagram = _diagram(force, force.diagram) if force.diagram else None
    (end, other), resists = _where(force, mechanism), force.between is not None and force.against is not None
    line = _line(force, end, other)
    track = Track(force.stroke or "", force.working)
    if other is not None and line is not None and force.stroke is None and force.changes:
        track = track._replace(point=end.point, parting=Parting(other.point, line))
    elif course is not None and force.changes:
        track = _coupled(track, course, mechanism)
    when = force.phase, diagram, _overrun(force.rests), track, force.useful
    there, behind = float(force.area(PRESSED)), float(force.area(BEHIND))
    piston = Piston(there, behind, -force.forced(Decimal(0))) if force.pressed else None
    return Force(name, end.link, end.point, end.at, size, course, *when, line, other, resists, piston)


def _coupled(track: Track, course: complex, mechanism: Mechanism) -> Track:
    """Give the track of a force: a point of a coupler, named or the output's, goes along the direction of the force.

    Its working stroke is that against the force, if no way is named: time tells hardly more than which is longer.
    """
    out = mechanism.output
    if out and out.along and not track.point:
        return track
    own = Track(out.point or "", out.working) if out and not track.point else track
    if not own.point or output_at(mechanism, own.point) is not None:
        return track
    return own._replace(along=course, working=AGAINST if own.working == SLOWER else own.working)


def _diagram(force: tables.ForceTable, table: DiagramTable) -> Diagram:
    """Give a diagram of forces, those of pressures on the piston."""
    there, back = (tuple(map(force.forced, sizes)) for sizes in (table.there, table.back))
    return Diagram(tuple(map(float, table.shares)), there, back, float(table.length or 0))


def _where(force: tables.ForceTable, mechanism: Mechanism) -> tuple[End, End | None]:
    """Give where a force acts, and where it acts back: of one between two links the first end is one that moves."""
    if force.between is not None:
        first, other = _ends(force.between, mechanism)
        return (other, first) if first.link == FRAME else (first, other)
    assert force.on is not None  # the form has seen to it
    assert force.point is not None
    return End(force.on, force.point, mechanism.links[force.on].points[force.point]), None


def _line(force: tables.ForceTable, end: End, other: End | None) -> tuple[str, str] | None:
    """Give the points whose line a force acts along: one between two links away from the other, or as it is told."""
    if not isinstance(force.direction, tuple):
        return None if other is None else (other.point, end.point)
    first, second = force.direction
    turned = force.between is not None and point_of(force.between[0]) != end.point
    return (second, first) if turned else (first, second)


def _ends(ends: Ends, mechanism: Mechanism) -> list[End]:
    points_of = {number: link.points for number, link in sorted(mechanism.links.items())}
    links = [holders(end, points_of)[0] for end in ends]
    names = map(point_of, ends)
    return [End(link, name, points_of[link][name]) for link, name in zip(links, names, strict=True)]


def _sized(value: Decimal | Vector | None, course: Decimal | tuple[str, ...] | None) -> tuple[float, complex | None]:
    """Give the size of a force and its direction: that of its vector or its angle, or none where the motion tells."""
    if isinstance(value, tuple):
        force = complex(float(value[0]), float(value[1]))
        return abs(force), force / abs(force) if force else 1 + 0j
    return 1.0 if value is None else float(value), direction(course) if isinstance(course, Decimal) else None


def _overrun(rests: Vector) -> tuple[float, float]:
    return float(rests[0]), float(rests[1])


def _moment(name: str, moment: tables.MomentTable) -> Moment:
    when = moment.phase, _overrun(moment.rests), Track(moment.stroke or "", moment.working), moment.useful
    return Moment(name, moment.on, float(moment.value), moment.against is not None, *when)


def _spring(name: str, spring: tables.SpringTable, mechanism: Mechanism) -> Spring:
    first, second = _ends(spring.between, mechanism)
    both = (first.link, second.link), (first.point, second.point), (first.at, second.at)
    return Spring(name, *both, float(spring.stiffness), float(spring.free))


def _transmission(balancing: str, gear: tables.GearTable | None) -> Transmission:
    if gear is None:
        return Transmission(balancing)
    at = within(Fraction(gear.at))
    return Transmission(GEAR, float(gear.radius), radians(at), radians(gear.pressure_angle))


def _rubbing(friction: tables.FrictionTable | None, mechanism: Mechanism) -> dict[str, Rubbing]:
    """Give each pair its friction: its own, or else that of all; a hinge has a journal, a slide a length."""
    if friction is None:
        return {}
    known = references.joints({n: tuple(link.points) for n, link in mechanism.links.items()}, mechanism.slides)
    return {
        name: _of_pair(friction, friction.pairs.get(name, tables.PairTable()), kind) for name, kind in known.items()
    }


def _of_pair(friction: tables.FrictionTable, pair: tables.PairTable, kind: str) -> Rubbing:
    radius, length = pair.radius or friction.radius, pair.length or friction.length or Decimal(0)
    coefficient = float(friction.coefficient if pair.coefficient is None else pair.coefficient)
    return Rubbing(coefficient, float(radius)) if kind == references.HINGE else Rubbing(coefficient, 0.0, float(length))


def _check_told(scene: Scene, form: tables.ForceForm, mechanism: Mechanism) -> None:
    """See that friction and hodographs name pairs of the groups: of a hinge of three links they hang on two."""
    rubbing = form.friction.pairs if form.friction else ()
    named: dict[Path, str] = {("friction", "pairs", name): name for name in rubbing}
    named |= {("sheet", "hodographs", index): name for index, name in enumerate(form.sheet.hodographs)}
    if not named:
        return
    known = [pair.key for pair in pairs(mechanism, decompose(mechanism))]
    details = {"suggestion": message("advice.pairs", pairs=", ".join(known))}
    strange = {path: name for path, name in named.items() if name not in known}
    if strange:
        raise SceneError(scene.fault(path, "unknown_pair", name=name, **details) for path, name in strange.items())
