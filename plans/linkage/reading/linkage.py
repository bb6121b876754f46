"""The linkage of a scene: the scene's tables made into a Mechanism, with every fault that its meaning shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from itertools import combinations, pairwise

from plans.linkage.reading.driving import between_links, datum_of, drive_ends, drive_of
from plans.linkage.reading.fields import split_line
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.guides import Guides, Shaper, Spot, as_complex, direction, from_datum, line_name
from plans.linkage.reading.survey import RATIO_LIMIT, LinkageSurvey, natural, spread
from plans.model.mechanism import FRAME, SLOWER, Link, Mechanism, Output, Slide, StructureError
from plans.scene.faults import Path, SceneError, suggestion
from plans.scene.scene import Meaning, Scene
from plans.words.words import Message, message

# Whole numbers some of which a comma without a space joins in pairs, while a space follows the others.
COMMAS = r"\[\s*[+-]?\d+(?:,\d+)?(?:\s*,\s+[+-]?\d+(?:,\d+)?)+\s*,?\s*\]"


def check_positions(survey: LinkageSurvey) -> None:
    """See that the sheet names positions that there are, and that their list has no decimal commas."""
    sheet = survey.form.sheet
    check_numbers(survey, {("sheet", "plans", index): number for index, number in enumerate(sheet.plans)})
    check_numbers(survey, {("sheet", "position"): sheet.position or 0})
    _check_commas(survey)


def check_numbers(survey: LinkageSurvey, numbers: Mapping[Path, int]) -> None:
    """See that there are positions of some numbers, each told at a key."""
    count = survey.form.drive.count
    if survey.doubtful(("drive", "positions")):
        return
    for path, number in numbers.items():
        if number >= count:
            survey.report(path, "position_number", most=count - 1, count=count)


def see_positions(meaning: Meaning, table: str, numbers: Sequence[int]) -> LinkageSurvey:
    """Examine the positions that a technique's table names; what else is at fault its linkage tells."""
    survey = replace(meaning.of(LinkageSurvey), faults=[])
    check_numbers(survey, {(table, "positions", index): number for index, number in enumerate(numbers)})
    return survey


def _check_commas(survey: LinkageSurvey) -> None:
    """See that a list of crank angles is none of numbers with decimal commas: [0,5, 30,2] reads as four numbers."""
    path: Path = ("drive", "positions")
    given = survey.form.drive.positions
    if not isinstance(given, tuple) or _one_way(given):
        return
    written = survey.scene.fault(path, "comma_list").value
    pointed = re.sub(r"(?<=\d),(?=\d)", ".", written)
    meant = [Decimal(part) for part in pointed.strip("[] ,").split(",")] if re.fullmatch(COMMAS, written) else []
    if len(meant) < len(given) and meant and _one_way(meant):
        survey.report(path, "comma_list", written=pointed)


def _one_way(angles: Sequence[Decimal]) -> bool:
    steps = [low < high for low, high in pairwise(angles)]
    return all(steps) or not any(steps)


def check_joining(survey: LinkageSurvey, slides: tuple[Slide, ...]) -> None:
    """See that every link is joined to the frame, if only through others, that none is loose, and no two are one."""
    if len(slides) < len(survey.form.mechanism.slides):
        return  # a faulty slide may be the very connection that is missing
    if survey.doubtful(*(("mechanism", name) for name in ("frame", "links", "points", "slides"))):
        return
    if waiting := _islands(survey, slides):
        links = message("place.links", count=len(waiting), links=", ".join(map(str, sorted(waiting))))
        survey.report(_link(min(waiting)), "island", links=links)
    if survey.faults or survey.doubts:
        return  # what is told already may be the reason
    sliding = {link for slide in slides for link in (slide.slider, slide.owner)}
    held = {FRAME, survey.form.drive.link, *sliding}
    touching = {name for form in survey.scene.forms for name in form.borrowed()}  # as a roller by its contact
    for link, points in survey.points_of.items():
        if link not in held and len(points) == 1 and points[0] not in touching:
            survey.report(_link(link), "loose", link=link, name=points[0])
    for first, second, how in _doubled(survey, slides):
        survey.report(_link(second), "one_body", first=first, second=second, how=how)


def _link(number: int) -> Path:
    return "mechanism", "links", str(number)


def _islands(survey: LinkageSurvey, slides: tuple[Slide, ...]) -> set[int]:
    joined, points = {FRAME}, set(survey.points_of[FRAME])
    pairs = [(slide.slider, slide.owner) for slide in slides]
    waiting = set(survey.form.mechanism.links)
    while reached := {
        link
        for link in waiting
        if points & set(survey.points_of[link]) or any(link in pair and joined & set(pair) for pair in pairs)
    }:
        joined |= reached
        waiting -= reached
        points = points.union(*(survey.points_of[link] for link in reached))
    return waiting


def _doubled(survey: LinkageSurvey, slides: tuple[Slide, ...]) -> Iterator[tuple[int, int, str | Message]]:
    """Give moving links that two pairs hold in one place: two hinges, or a hinge and a slide."""
    for first, second in combinations(survey.form.mechanism.links, 2):
        common = [name for name in survey.points_of[first] if name in survey.points_of[second]]
        lines = [slide for slide in slides if {slide.slider, slide.owner} == {first, second}]
        if len(common) > 1 or (common and lines and lines[0].label):
            yield first, second, ", ".join([*common, *(slide.label for slide in lines)][:2])
        elif common and lines:
            yield first, second, message("place.point_and_line", name=common[0], link=lines[0].owner)


def mechanism_of(scene: Scene) -> Mechanism:
    """Make the mechanism of a scene; all its faults together are one SceneError, a wrong mobility a StructureError."""
    mechanism = described(scene)
    if mechanism.mobility != 1:
        raise _wrong_mobility(scene, mechanism)
    return mechanism


def described(scene: Scene) -> Mechanism:
    """Make the mechanism of a scene, whatever its mobility is."""
    mechanism = scene.meaning.of(LinkageSurvey).mechanism
    faults = scene.meaning.faults
    if faults or mechanism is None:
        raise SceneError(faults)
    return mechanism


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """Examine what a scene says of its linkage, and make the mechanism of it."""
    survey = LinkageSurvey(meaning.scene, set(meaning.doubts))
    survey.mechanism = _build(survey)
    return survey


def _build(survey: LinkageSurvey) -> Mechanism | None:
    form = survey.form
    ends = drive_ends(survey)
    datum = datum_of(survey, ends)
    frame = form.mechanism.frame
    fixed = {name: from_datum(frame[name], datum) for name in survey.points_of[FRAME]}
    sketch = _sketch(survey, datum)
    places = {**sketch, **{name: as_complex(spot) for name, spot in fixed.items()}}
    shaper = Shaper(survey, _with_crank(survey, ends, places))
    shapes = {FRAME: fixed, **{link: shaper.shape(link) for link in sorted(form.mechanism.links)}}
    _check_points(survey)
    _check_places(survey)
    slides = survey.slides = Guides(survey, shapes, datum).slides()
    check_positions(survey)
    check_joining(survey, slides)
    output = _output(survey, slides)
    if survey.faults or not ends:
        return None
    points = {link: {name: as_complex(spot) for name, spot in shape.items()} for link, shape in shapes.items()}
    links = {number: Link(number, places) for number, places in points.items()}
    drive = drive_of(survey, ends, links, sketch)
    if drive is None:
        return None
    working = form.output.working if form.output else SLOWER
    through = form.mechanism.through
    whole = Mechanism(survey.scene.heading(), datum, links, slides, drive, sketch, output, through, working)
    return between_links(survey, whole)


def _sketch(survey: LinkageSurvey, datum: Spot) -> dict[str, complex]:
    sketch: dict[str, complex] = {}
    for name, place in sorted(survey.form.mechanism.sketch.items(), key=lambda item: natural(item[0])):
        path: Path = ("mechanism", "sketch", name)
        if name in survey.points_of[FRAME]:
            continue  # it stands in its own place; where the sketch shows another, a note says so
        if survey.know(path, (name,)):
            sketch[name] = as_complex(from_datum(place, datum))
    return sketch


def _with_crank(survey: LinkageSurvey, ends: tuple[str, str] | None, places: dict[str, complex]) -> dict[str, complex]:
    """Add the place of the crank's end, where the first crank angle gives it better than no sketch."""
    first = survey.form.drive.first
    if not ends or ends[1] in places or first is None or survey.form.drive.stroke:
        return places
    size = Shaper(survey, places).length(*ends)
    return places if size is None else {**places, ends[1]: float(size) * direction(first)}


def _check_points(survey: LinkageSurvey) -> None:
    """See that [mechanism.points] and [mechanism.lengths] say things once, of links that exist."""
    form = survey.form.mechanism
    for name, placed in form.points.items():
        path: Path = ("mechanism", "points", name)
        if placed.on == FRAME:
            survey.report((*path, "on"), "on_frame")
        elif survey.know_link((*path, "on"), placed.on) and name in form.links[placed.on][:2]:
            line = line_name(*survey.points_of[placed.on][:2]) if len(survey.points_of[placed.on]) > 1 else name
            survey.report(path, "second_by_place", name=name, link=placed.on, line=line)
    for pair, key in survey.lengths.items():
        _check_length(survey, pair, ("mechanism", "lengths", key))
    if (apart := spread(form.lengths)) and apart.ratio > RATIO_LIMIT:
        details = {"name": apart.longest, "other": apart.shortest, "ratio": f"{apart.ratio:.3g}"}
        survey.report(("mechanism", "lengths", apart.longest), "ratio", most=f"{RATIO_LIMIT:.0e}", **details)


def _check_places(survey: LinkageSurvey) -> None:
    form = survey.form.mechanism
    for name in sorted(form.points.keys() & form.frame.keys(), key=natural):
        survey.report(("mechanism", "points", name), "two_places", name=name, link=form.points[name].on)


def _check_length(survey: LinkageSurvey, pair: frozenset[str], path: Path) -> None:
    first, second = split_line(str(path[2]))
    owners = survey.owners(pair)
    moving = [link for link in owners if link != FRAME]
    if not owners:
        if not survey.doubtful(("mechanism", "links"), ("mechanism", "points")):
            near = [line_name(*link[:2]) for link in survey.form.mechanism.links.values() if len(link) > 1]
            advice = suggestion(str(path[2]), near, message("advice.add_link"))
            survey.report(path, "no_common_link", first=first, second=second, suggestion=advice)
    elif not moving:
        survey.report(path, "fixed_length", first=first, second=second)
    elif all(_by_place(survey, link, pair) for link in moving):
        name = next(name for name in (second, first) if name in survey.form.mechanism.points)
        survey.report(path, "placed_twice", name=name)
    elif not any(pair & set(survey.points_of[link][:2]) for link in moving):
        base = survey.points_of[moving[0]][:2]
        needed = ", ".join(line_name(end, name) for name in (first, second) for end in base)
        survey.report(path, "spare_length", needed=needed)


def _by_place(survey: LinkageSurvey, link: int, pair: frozenset[str]) -> bool:
    placed = survey.form.mechanism.points
    letters = survey.form.mechanism.links[link][:2]
    return any(name in placed and placed[name].on == link and name not in letters for name in pair)


def _output(survey: LinkageSurvey, slides: tuple[Slide, ...]) -> Output | None:
    """Give the output link: named, or that of the named point, of several the one that slides, else the last."""
    wanted = survey.form.output
    if wanted is None or (wanted.link is None and wanted.point is None):
        return None
    if wanted.link is not None:
        if not survey.know_link(("output", "link"), wanted.link):
            return None
        sliding = [slide.point for slide in slides if slide.slider == wanted.link and slide.owner == FRAME]
        return Output(wanted.link, sliding[0] if sliding else None, wanted.working)
    point = wanted.point or ""
    if not survey.know(("output", "point"), (point,)):
        return None
    owners = survey.owners((point,))
    if not owners or owners[0] == FRAME:
        survey.report(("output", "point"), "fixed_output", name=point)
        return None
    sliders = [slide.slider for slide in slides if slide.slider in owners and slide.owner == FRAME]
    if sliders and wanted.along is not None:
        survey.report(("output", "along"), "guided_output", name=point)
    along = None if wanted.along is None else direction(wanted.along)
    return Output(sliders[-1] if sliders else owners[-1], point, wanted.working, along=along)


def _wrong_mobility(scene: Scene, mechanism: Mechanism) -> StructureError:
    hinges = sum(len(links) - 1 for links in mechanism.hinges.values())
    details = {
        "n": mechanism.moving_links,
        "p": mechanism.lower_pairs,
        "found": str(mechanism.mobility).replace("-", "\N{MINUS SIGN}"),
        "hinges": hinges,
        "slides": len(mechanism.slides),
        "advice": _mobility_advice(scene, mechanism),
    }
    links = tuple(sorted(scene.of(LinkageForm).mechanism.links))
    return StructureError(scene.fault(("mechanism", "links"), "mobility", **details), links, mechanism.mobility)


def _mobility_advice(scene: Scene, mechanism: Mechanism) -> Message:
    fixed = mechanism.links[FRAME].points
    unused = [name for name in fixed if name not in mechanism.hinges]
    if mechanism.mobility > 1 and unused:
        return message("advice.joint_fixed", points=", ".join(unused))
    # Ends that hang on nothing: of a lead, one of its first two points is of no other link.
    slid = {link for slide in mechanism.slides for link in (slide.slider, slide.owner)}
    leads = {link: points[:2] for link, points in scene.of(LinkageForm).mechanism.links.items() if link not in slid}
    ends = [(link, name) for link, names in leads.items() for name in names if name not in mechanism.hinges]
    if mechanism.mobility > 1 and ends:
        link, name = ends[0]
        return message("advice.joint_end", name=name, link=link)
    return message("advice.joint" if mechanism.mobility > 1 else "advice.held_twice")
