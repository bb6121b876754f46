"""References of loads (ссылки): masses, loads, friction and hodographs name links, points and pairs of the linkage."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations

from plans.forces.reading.fields import Ends, EndTable, holders, point_of
from plans.forces.reading.form import FORCES, MIDDLE, ForceForm, ForceTable, LoadsTable, MomentTable, PairTable
from plans.linkage.reading.linkage import check_numbers
from plans.linkage.reading.survey import Survey
from plans.model.mechanism import FRAME, Slide
from plans.scene.faults import Path
from plans.scene.scene import Meaning
from plans.words.words import message

HINGE, SLIDE = "a hinge", "a sliding pair"
ALONE = {"radius": HINGE, "length": SLIDE}  # which kind of pair alone has it


def survey_of(meaning: Meaning) -> Survey:
    """See that masses, loads, friction and the sheet name links, points, pairs and positions that exist."""
    linkage: Survey = meaning["linkage"]
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
        (one, other): HINGE
        for one, other in combinations(sorted(points_of), 2)
        if set(points_of[one]) & set(points_of[other])
    }
    found |= {(min(slide.slider, slide.owner), max(slide.slider, slide.owner)): SLIDE for slide in slides}
    return {f"{one}-{other}": found[one, other] for one, other in sorted(found)}


def _check_masses(survey: Survey, form: ForceForm) -> None:
    for link, mass in form.masses.items():
        path: Path = ("masses", str(link))
        if not survey.know_link(path, link) or not isinstance(mass.centre, str):
            continue
        if mass.centre != MIDDLE:
            survey.on_link((*path, "centre"), link, mass.centre)
        elif len(survey.form.mechanism.links[link]) < 2:  # points that have a place of their own come in no order
            survey.report((*path, "centre"), "no_line", link=link)


def _check_loads(survey: Survey, loads: LoadsTable) -> None:
    for path, load in _loads(loads):
        _check_place(survey, path, load)
        if load.stroke is not None and survey.know((*path, "stroke"), (load.stroke,)):
            _check_moves(survey, (*path, "stroke"), load.stroke)
    for index, spring in enumerate(loads.springs):
        _check_ends(survey, ("loads", "springs", index), spring.between)


def _loads(loads: LoadsTable) -> Iterator[tuple[Path, ForceTable | MomentTable]]:
    yield from ((("loads", "forces", index), force) for index, force in enumerate(loads.forces))
    yield from ((("loads", "moments", index), moment) for index, moment in enumerate(loads.moments))


def _check_place(survey: Survey, path: Path, load: ForceTable | MomentTable) -> None:
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


def _check_moves(survey: Survey, path: Path, name: str) -> None:
    if survey.owners((name,))[:1] == [FRAME]:
        survey.report(path, "fixed_output", name=name)


def _check_ends(survey: Survey, path: Path, ends: Ends) -> None:
    """See that each end is a point of one link, and that the links are two."""
    links = [_end(survey, (*path, "between", k), end) for k, end in enumerate(ends)]
    first, second = map(point_of, ends)
    if links[0] is not None and links[0] == links[1]:
        survey.report((*path, "between"), "one_link", link=links[0])
    elif None not in links and first == second:
        survey.report((*path, "between"), "one_hinge", name=first)


def _end(survey: Survey, path: Path, end: str | EndTable) -> int | None:
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


def _check_pairs(survey: Survey, form: ForceForm, known: Mapping[str, str]) -> None:
    """See that friction and hodographs name pairs of the mechanism, and that a hinge has no length of contact."""
    if survey.doubtful(*(("mechanism", name) for name in ("frame", "links", "points", "slides"))):
        return
    for name, pair in (form.friction.pairs if form.friction else {}).items():
        path: Path = ("friction", "pairs", name)
        if _know_pair(survey, path, name, known):
            _check_form(survey, path, pair, known[name])
    for index, name in enumerate(form.sheet.hodographs):
        _know_pair(survey, ("sheet", "hodographs", index), name, known)


def _know_pair(survey: Survey, path: Path, name: str, known: Mapping[str, str]) -> bool:
    if name not in known:
        advice = message("advice.pairs", pairs=", ".join(known))
        survey.report(path, "unknown_pair", name=name, suggestion=advice)
    return name in known


def _check_form(survey: Survey, path: Path, pair: PairTable, kind: str) -> None:
    for name, alone in ALONE.items():
        if name in pair.given and kind != alone:
            survey.report((*path, name), "pair_form", thing=alone, name=name, pair=path[-1])


def _check_acting(survey: Survey, form: ForceForm) -> None:
    """See that something acts on the mechanism where its forces are wanted; masses without weights have inertia."""
    loads = form.loads
    if FORCES not in survey.scene.sheets or survey.doubtful(("masses",), ("loads",)):
        return
    loaded = loads is not None and (loads.forces or loads.moments or loads.springs)
    if not loaded and not any(mass.mass or mass.inertia for mass in form.masses.values()):
        survey.report(("sheets",), "nothing_acts")
