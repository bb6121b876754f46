"""References of loads to the linkage (ссылки), and what of masses and loads may well be a slip (замечания)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from itertools import combinations
from operator import itemgetter

from geometry.errors import DraftError
from plans.forces.reading.fields import Ends, EndTable, holders, point_of
from plans.forces.reading.form import FORCES, MIDDLE, ForceForm, ForceTable, LoadsTable, MomentTable, PairTable
from plans.linkage.reading.linkage import check_numbers, mechanism_of
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.mechanism import FRAME, Link, Mechanism, Slide
from plans.scene.faults import Fault, Path
from plans.scene.notes import HUNDREDS
from plans.scene.scene import Meaning, Scene
from plans.words.words import message

HINGE, SLIDE = "a hinge", "a sliding pair"
ALONE = {"radius": HINGE, "length": SLIDE}  # which kind of pair alone has it


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """See that masses, loads, friction and the sheet name links, points, pairs and positions that exist."""
    linkage = meaning.of(LinkageSurvey)
    survey, form = replace(linkage, faults=[]), meaning.scene.of(ForceForm)
    _check_masses(survey, form)
    if form.loads is not None:
        _check_loads(survey, form.loads)
    whole = len(survey.slides) == len(survey.form.mechanism.slides)  # else a faulty one may be the pair that lacks
    if whole and (form.friction is not None or form.sheet.hodographs):
        _check_pairs(survey, form, joints(survey.points_of, survey.slides))
    _check_acting(survey, form)
    check_numbers(survey, {("sheet", "forces", index): number for index, number in enumerate(form.sheet.forces)})
    return survey


def joints(points_of: Mapping[int, tuple[str, ...]], slides: tuple[Slide, ...]) -> dict[str, str]:
    """Give the pairs that links may form, each with its kind; a hinge of three links has three of them.

    >>> joints({0: ("O",), 1: ("O", "A"), 2: ("A",), 3: ("A",)}, ())
    {'0-1': 'a hinge', '1-2': 'a hinge', '1-3': 'a hinge', '2-3': 'a hinge'}
    """
    found = {
        (first, other): HINGE
        for first, other in combinations(sorted(points_of), 2)
        if set(points_of[first]) & set(points_of[other])
    }
    found |= {(min(slide.slider, slide.owner), max(slide.slider, slide.owner)): SLIDE for slide in slides}
    return {f"{first}-{other}": found[first, other] for first, other in sorted(found)}


def _check_masses(survey: LinkageSurvey, form: ForceForm) -> None:
    for link, mass in form.masses.items():
        path: Path = ("masses", str(link))
        if not survey.know_link(path, link) or not isinstance(mass.centre, str):
            continue
        if mass.centre != MIDDLE:
            survey.on_link((*path, "centre"), link, mass.centre)
        elif len(survey.form.mechanism.links[link]) < 2:  # points that have a place of their own come in no order
            survey.report((*path, "centre"), "no_line", link=link)


def _check_loads(survey: LinkageSurvey, loads: LoadsTable) -> None:
    for path, load in _loads(loads):
        _check_place(survey, path, load)
        told = () if load.stroke is None else (load.stroke,)
        if told and survey.know((*path, "stroke"), told) and survey.owners(told)[:1] == [FRAME]:
            survey.report((*path, "stroke"), "fixed_output", name=told[0])
    for index, spring in enumerate(loads.springs):
        _check_ends(survey, ("loads", "springs", index), spring.between)


def _loads(loads: LoadsTable) -> Iterator[tuple[Path, ForceTable | MomentTable]]:
    yield from ((("loads", "forces", index), force) for index, force in enumerate(loads.forces))
    yield from ((("loads", "moments", index), moment) for index, moment in enumerate(loads.moments))


def _check_place(survey: LinkageSurvey, path: Path, load: ForceTable | MomentTable) -> None:
    """See that a load is on links and points that exist, and along a line of such points."""
    known = load.on is None or survey.know_link((*path, "on"), load.on)
    if isinstance(load, MomentTable):
        return
    if known and load.on is not None and load.point is not None:
        survey.on_link((*path, "point"), load.on, load.point)
    if load.between is not None:
        _check_ends(survey, path, load.between)
    if isinstance(load.direction, tuple):
        survey.know((*path, "direction"), load.direction)


def _check_ends(survey: LinkageSurvey, path: Path, ends: Ends) -> None:
    """See that each end is a point of one link, and that the links are two."""
    links = [_end(survey, (*path, "between", k), end) for k, end in enumerate(ends)]
    first, second = map(point_of, ends)
    if links[0] is not None and links[0] == links[1]:
        survey.report((*path, "between"), "one_link", link=links[0])
    elif None not in links and first == second:
        survey.report((*path, "between"), "one_hinge", name=first)


def _end(survey: LinkageSurvey, path: Path, end: str | EndTable) -> int | None:
    """Give the link that an end is of, or nothing where it is at fault."""
    if isinstance(end, EndTable):
        moving = end.on != FRAME
        known = not moving or survey.know_link((*path, "on"), end.on)
        return end.on if known and survey.on_link((*path, "point"), end.on, end.point) else None
    if not survey.know(path, (end,)):
        return None
    found = holders(end, survey.points_of)
    if len(found) > 1:
        survey.report(path, "many_links", links=", ".join(map(str, found)), name=end, first=found[0])
    return found[0] if len(found) == 1 else None


def _check_pairs(survey: LinkageSurvey, form: ForceForm, known: Mapping[str, str]) -> None:
    """See that friction and hodographs name pairs of the mechanism, and that a hinge has no length of contact."""
    if survey.doubtful(*(("mechanism", name) for name in ("frame", "links", "points", "slides"))):
        return
    for name, pair in (form.friction.pairs if form.friction else {}).items():
        path: Path = ("friction", "pairs", name)
        if _know_pair(survey, path, name, known):
            _check_form(survey, path, pair, known[name])
    for index, name in enumerate(form.sheet.hodographs):
        _know_pair(survey, ("sheet", "hodographs", index), name, known)


def _know_pair(survey: LinkageSurvey, path: Path, name: str, known: Mapping[str, str]) -> bool:
    if name not in known:
        advice = message("advice.pairs", pairs=", ".join(known))
        survey.report(path, "unknown_pair", name=name, suggestion=advice)
    return name in known


def _check_form(survey: LinkageSurvey, path: Path, pair: PairTable, kind: str) -> None:
    for name, alone in ALONE.items():
        if name in pair.given and kind != alone:
            survey.report((*path, name), "pair_form", thing=alone, name=name, pair=path[-1])


def _check_acting(survey: LinkageSurvey, form: ForceForm) -> None:
    """See that something acts on the mechanism where its forces are wanted; masses without weights have inertia."""
    loads = form.loads
    if FORCES not in survey.scene.sheets or survey.doubtful(("masses",), ("loads",)):
        return
    loaded = loads is not None and (loads.forces or loads.moments or loads.springs)
    if not loaded and not any(mass.mass or mass.inertia for mass in form.masses.values()):
        survey.report(("sheets",), "nothing_acts")


# Gravity of the Earth, m/s2, and how many times it a machine stands at most: the Sun's is 28 times.
EARTH, MOST_EARTHS = Decimal("9.81"), 30
HIGH, LOW = Decimal("1e8"), Decimal(1000)  # Pa: presses have up to 70 MPa, and a fan gives a few kilopascals
UNEVEN = 10_000  # times the least pressure of a load: compressors raise it a hundredfold, MPa for Pa is a million
SLOT = 2.0  # times the longest length of the mechanism: a slot reaches at most across the circle of its pin
ROUGH = 1  # rubber on a dry road; a larger coefficient of friction is mostly a lost decimal point


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on masses, loads and friction."""
    form = scene.of(ForceForm)
    for notes in (_masses, _gravity, _friction, _diagrams, _pistons, _letters):
        yield from notes(scene, form)


def _letters(scene: Scene, form: ForceForm) -> Iterator[Fault]:
    """Find loads that have the letter of a point: on a scheme it would be of both."""
    mechanism = _mechanism(scene) if form.loads else None
    points = {name for link in mechanism.links.values() for name in link.points} if mechanism else set()
    for path, load in _loads(form.loads) if form.loads else ():
        if load.name in points:
            yield scene.fault((*path, "name"), "letter_of_point", name=load.name, example=f"{load.name}_1")


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
        centre = mass.place(link)
        far = min(abs(centre - place) for place in link.points.values())
        if far > room:
            yield scene.fault((*path, "centre"), "far_centre", far=f"{far:.4g}", link=link.number)
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


def _mechanism(scene: Scene) -> Mechanism | None:
    """Give the mechanism, for the shapes of its links; none where the scene has faults, which are told instead."""
    try:
        return mechanism_of(scene)
    except DraftError:
        return None


def _length(link: Link) -> float:
    """Give the largest distance between points of a link."""
    return max((abs(first - other) for first, other in combinations(link.points.values(), 2)), default=0.0)


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
    """Find indicator diagrams whose strokes do not meet at an end: told once, of the larger jump.

    Where both strokes are level beside an end, as in a pump, the load changes there at once and is meant to.
    """
    for index, force in enumerate(form.loads.forces if form.loads else ()):
        table, jumps = force.diagram, list[tuple[Decimal, Decimal]]()
        if table is None or not table.back:
            continue
        for end, beside in (0, 1), (-1, -2):
            first, last = ((row[end], row[beside]) for row in (table.there, table.back))
            if first[0] != last[0] and not (first[0] == first[1] and last[0] == last[1]):
                jumps.append((abs(first[0] - last[0]), table.shares[end]))
        if jumps:
            jump, share = max(jumps, key=itemgetter(0))
            name, unit, size = ("pressure", "MPa", jump / 10**6) if table.pressure else ("force", "N", jump)
            details = {"travel": f"{share:f}", "jump": f"{size.normalize():f}", "name": name, "unit": unit}
            yield scene.fault(("loads", "forces", index, "diagram", "back"), "open_diagram", **details)


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
    names = ("behind", "ambient", "pressure")
    given: dict[Path, Decimal] = {(*path, name): getattr(force, name) or Decimal(0) for name in names}
    for name in ("pressure", "back") if force.diagram else ():
        given |= {(*path, "diagram", name, k): size for k, size in enumerate(getattr(force.diagram, name))}
    sizes = {where: abs(size) for where, size in given.items() if size}
    least, most = min(sizes, key=sizes.__getitem__, default=None), max(sizes.values(), default=Decimal(0))
    if least is not None and most >= UNEVEN * sizes[least]:
        yield scene.fault(least, "uneven_pressures", size=f"{float(sizes[least]):.6g}", most=f"{float(most):.6g}")
