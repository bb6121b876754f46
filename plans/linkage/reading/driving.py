"""The drive of a scene: a crank on the frame, or a link that is pushed along a guide of the frame (привод)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from decimal import Decimal
from math import ceil, log2

import numpy as np

from geometry.meet import cross
from plans.linkage.assembly import SketchError
from plans.linkage.ram import cylinder, passage
from plans.linkage.reading.fields import LineTable
from plans.linkage.reading.form import SlideTable
from plans.linkage.reading.guides import Spot, plain
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.mechanism import FRAME, SLIDER, Drive, Link, Mechanism, Ram, StructureError
from plans.scene.faults import Path
from plans.scene.units import WORKING
from plans.words.words import message

BETWEEN: Path = ("drive", "stroke", "between")


def by_ram(
    survey: LinkageSurvey, ends: tuple[str, str], links: Mapping[int, Link], sketch: Mapping[str, complex]
) -> Drive | None:
    """Make the drive of a crank that a cylinder turns; its rates are those at the first length, from rest halfway.

    Of one that the crank's triangle does not hold they are found when the whole linkage is known: see `between_links`.
    """
    stroke = survey.form.drive.stroke
    points = _points(survey, ends)
    if stroke is None or points is None or not _moves(survey):
        return None
    fixed, point = points
    ram = Ram(fixed, point, float(stroke.from_), float(stroke.to), *stroke.rates, 0.0)
    drive = Drive(survey.form.drive.link, *ends, 1.0, 0.0, ram=ram, law=stroke.law)
    if not _on_crank(survey, points, ends):
        owners = survey.owners((fixed,))[0], survey.owners((point,))[0]
        return drive._replace(ram=ram._replace(links=owners))
    if not _reached(survey, points, links, ends):
        return None
    hinge, foot = links[FRAME].points[ends[0]], links[FRAME].points[fixed]
    if point not in sketch:
        survey.report(BETWEEN, "ram_sketch", name=point)
        return None
    turned = float(cross(np.asarray(hinge - foot), np.asarray(sketch[point] - foot)))
    found = ram._replace(side=1.0 if turned >= 0 else -1.0)
    whole = Mechanism("", (stroke.to, stroke.to), links, (), drive._replace(ram=found), sketch, None)
    return _begun(whole, found)


def between_links(survey: LinkageSurvey, mechanism: Mechanism) -> Mechanism | None:
    """Give a linkage that a cylinder between two of its links drives the rates that its crank has at the first length.

    What has no structure or no one assembly is left as it is: the study of it says so.
    """
    ram = mechanism.drive.ram
    if ram is None or ram.links is None or mechanism.mobility != 1:
        return mechanism
    try:
        passed = passage(mechanism)
    except (StructureError, SketchError):
        return mechanism
    line = f"{ram.foot}{ram.point}"
    if passed is None:
        survey.report(BETWEEN, "ram_nowhere", line=line)
        return None
    for name, way in (("from", ram.begin), ("to", ram.end)):
        if not passed[1][0] < way < passed[1][1]:
            least, most = (_millimetres(float(f"{end:.6g}")) for end in passed[1])
            survey.report(("drive", "stroke", name), "ram_passage", line=line, least=least, most=most)
            return None
    found = ram._replace(passage=passed[0])
    whole = replace(mechanism, drive=mechanism.drive._replace(ram=found))
    return replace(whole, drive=_begun(whole, found))


def _begun(whole: Mechanism, found: Ram) -> Drive:
    """Give the drive of a mechanism the crank's rates at the first length; where it rests there, halfway."""
    rests = dict(whole.drive.law).get(found.begin) == 0
    drive = cylinder(whole)
    first = drive.positions(np.array([(found.begin + found.end) / 2 if rests else found.begin]))
    omega, epsilon = drive.pace(first.phi).at(0)
    return whole.drive._replace(omega=omega, epsilon=epsilon)


def _points(survey: LinkageSurvey, ends: tuple[str, str]) -> tuple[str, str] | None:
    """Give the two points that a cylinder acts between, a fixed one first: no link has both."""
    stroke = survey.form.drive.stroke
    assert stroke is not None and stroke.between is not None  # it is a cylinder's
    if not survey.know(BETWEEN, stroke.between):
        return None
    first, second = sorted(stroke.between, key=lambda name: name not in survey.points_of[FRAME])
    if first == second or survey.owners((first, second)):
        survey.report(BETWEEN, "ram_points", line="".join(stroke.between))
        return None
    return first, second


def _on_crank(survey: LinkageSurvey, points: tuple[str, str], ends: tuple[str, str]) -> bool:
    """Tell whether the triangle of a fixed point, the crank's hinge and its point holds the cylinder."""
    crank, fixed = survey.points_of[survey.form.drive.link], survey.points_of[FRAME]
    return points[0] in fixed and points[0] != ends[0] and points[1] in crank


def _moves(survey: LinkageSurvey) -> bool:
    stroke = survey.form.drive.stroke
    assert stroke is not None  # it is a cylinder's
    if not stroke.rates[0]:
        survey.report(("drive", "stroke", "speed"), "ram_still")
    return bool(stroke.rates[0])


def _reached(survey: LinkageSurvey, points: tuple[str, str], links: Mapping[int, Link], ends: tuple[str, str]) -> bool:
    """See that the triangle closes over the whole stroke, and is no line at either end: no speed is borne there."""
    stroke = survey.form.drive.stroke
    assert stroke is not None  # it is a cylinder's
    crank, frame = links[survey.form.drive.link].points, links[FRAME].points
    base, arm = abs(frame[points[0]] - frame[ends[0]]), abs(crank[points[1]] - crank[ends[0]])
    least, most = abs(base - arm), base + arm
    for name, way in (("from", stroke.from_), ("to", stroke.to)):
        if not least < float(way) < most:
            reach = {"least": _millimetres(least), "most": _millimetres(most)}
            survey.report(("drive", "stroke", name), "ram_reach", line="".join(points), **reach)
            return False
    return True


def _millimetres(length: float) -> str:
    return plain(WORKING.create_decimal_from_float(1000 * length))


ORIGIN: Spot = (Decimal(0), Decimal(0))
LINK: Path = ("drive", "link")


def drive_ends(survey: LinkageSurvey) -> tuple[str, str] | None:
    """Find the drive's fixed hinge and its far end; of a link that is pushed along its named point is both."""
    if not survey.know_link(LINK, survey.form.drive.link):
        return None
    stroke = survey.form.drive.stroke
    if stroke is not None:
        _check_turnless(survey)
    return _pushed_ends(survey) if stroke is not None and stroke.between is None else _crank_ends(survey)


def _crank_ends(survey: LinkageSurvey) -> tuple[str, str] | None:
    link = survey.form.drive.link
    points = survey.points_of[link]
    fixed = [name for name in points if name in survey.points_of[FRAME]]
    free = [name for name in points if name not in fixed]
    if survey.doubtful(LINK, ("mechanism", "links", str(link)), ("mechanism", "frame")):
        return (fixed[0], free[0]) if fixed and free else None
    if len(fixed) > 1:
        survey.report(LINK, "many_hinges", points=", ".join(fixed), link=link)
        survey.doubts.add(("mechanism", "links", str(link)))
    elif not fixed and _pushed(survey) is not None:
        _report_pushed(survey)
    elif not fixed:
        survey.report(LINK, "no_hinge", suggestion=message("advice.hinge", link=link))
    elif not free:
        survey.report(LINK, "no_end", link=link, pivot=fixed[0])
    return (fixed[0], free[0]) if fixed and free else None


def _report_pushed(survey: LinkageSurvey) -> None:
    """Say that a link that slides on the frame is no crank: neither a speed nor a cylinder turns it."""
    link = survey.form.drive.link
    if survey.form.drive.stroke is not None:
        survey.report(BETWEEN, "pushed_itself", link=link)
    else:
        survey.report(LINK, "stroke_needed", (("drive", "speed"),), link=link)


def _pushed_ends(survey: LinkageSurvey) -> tuple[str, str] | None:
    table, link = _pushed(survey), survey.form.drive.link
    if table is None:
        if not survey.doubtful(LINK, ("mechanism", "slides"), ("mechanism", "frame"), BETWEEN):
            survey.report(LINK, "no_guide", link=link)
        return None
    point = table.point or survey.points_of[link][0]
    return point, point


def _check_turnless(survey: LinkageSurvey) -> None:
    """See that nothing is asked for that a drive without a turn has not."""
    scene = survey.scene
    for name in scene.techniques:
        form = scene.part(name)
        if form is not None and form.needs_turn:
            survey.report(("drive", "stroke"), "turn_needed", name=name)
    for name in ("balancing", "gear", "train"):
        if scene.has(("drive", name)):
            survey.report(("drive", name), "turn_alone", name=name)


def _pushed(survey: LinkageSurvey) -> SlideTable | None:
    frame, link = survey.points_of[FRAME], survey.form.drive.link
    tables = (table for table in survey.form.mechanism.slides if table.link == link)
    return next((table for table in tables if _on_frame(table.along, frame)), None)


def _on_frame(along: tuple[str, ...] | LineTable, frame: Collection[str]) -> bool:
    return along.link == FRAME if isinstance(along, LineTable) else all(name in frame for name in along)


def datum_of(survey: LinkageSurvey, ends: tuple[str, str] | None) -> Spot:
    """Give the point that coordinates are measured from: the drive's fixed hinge, or the point of its guide."""
    frame = survey.form.mechanism.frame
    if ends is None:
        return ORIGIN
    table = _pushed(survey) if ends[0] == ends[1] else None
    if table is None:
        return frame.get(ends[0], ORIGIN)
    if isinstance(table.along, LineTable):
        return table.along.place(frame) or ORIGIN
    return frame[table.along[0]]


def drive_of(
    survey: LinkageSurvey, ends: tuple[str, str], links: Mapping[int, Link], sketch: Mapping[str, complex]
) -> Drive | None:
    """Make the drive of a scene; a stroke is counted in a power of two metres, near the largest length there is."""
    form = survey.form.drive
    if form.stroke is None:
        return Drive(form.link, *ends, float(form.omega), float(form.acceleration))
    if form.stroke.between is not None:
        return by_ram(survey, ends, links, sketch)
    guide = next(slide for slide in survey.slides if slide.slider == form.link and slide.owner == FRAME)
    places = [abs(place) for link in links.values() for place in link.points.values()]
    ways = [abs(float(way)) for way in (form.stroke.from_, form.stroke.to)]
    # The power of two metres that no place of the stroke and no length of a link is beyond.
    unit = float(2.0 ** ceil(log2(max(*places, *ways, abs(guide.on_owner.through)))))
    omega, epsilon = (rate / unit for rate in form.stroke.rates)
    return Drive(form.link, *ends, omega, epsilon, SLIDER, guide, unit, law=form.stroke.law)
