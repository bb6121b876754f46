"""The drive of a scene: a crank on the frame, or a link that is pushed along a guide of the frame (привод)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from decimal import Decimal
from math import ceil, log2

from plans.linkage.reading.cylinder import BETWEEN, by_ram
from plans.linkage.reading.form import SlideTable
from plans.linkage.reading.line import LineTable
from plans.linkage.reading.shapes import Spot
from plans.linkage.reading.stroke import StrokeTable
from plans.linkage.reading.survey import Survey
from plans.model.mechanism import FRAME, SLIDER, Drive, Link, Slide
from plans.scene.faults import Path
from plans.words.words import message

ORIGIN: Spot = (Decimal(0), Decimal(0))
LINK: Path = ("drive", "link")


def drive_ends(survey: Survey) -> tuple[str, str] | None:
    """Find the drive's fixed hinge and its far end; of a link that is pushed along its named point is both."""
    if not survey.know_link(LINK, survey.form.drive.link):
        return None
    stroke = survey.form.drive.stroke
    if stroke is not None:
        _check_turnless(survey)
    return _pushed_ends(survey) if stroke is not None and stroke.between is None else _crank_ends(survey)


def _crank_ends(survey: Survey) -> tuple[str, str] | None:
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
        advice = message("advice.hinge", link=link)
        survey.report(LINK, "no_hinge", suggestion=survey.twin(points, survey.points_of[FRAME]) or advice)
    elif not free:
        survey.report(LINK, "no_end", link=link, pivot=fixed[0])
    return (fixed[0], free[0]) if fixed and free else None


def _report_pushed(survey: Survey) -> None:
    """Say that a link that slides on the frame is no crank: neither a speed nor a cylinder turns it."""
    link = survey.form.drive.link
    if survey.form.drive.stroke is not None:
        survey.report(BETWEEN, "pushed_itself", link=link)
    else:
        survey.report(LINK, "stroke_needed", (("drive", "speed"),), link=link)


def _pushed_ends(survey: Survey) -> tuple[str, str] | None:
    table, link = _pushed(survey), survey.form.drive.link
    if table is None:
        if not survey.doubtful(LINK, ("mechanism", "slides"), ("mechanism", "frame"), BETWEEN):
            survey.report(LINK, "no_guide", link=link)
        return None
    point = table.point or survey.points_of[link][0]
    return point, point


def _check_turnless(survey: Survey) -> None:
    """See that nothing is asked for that a drive without a turn has not."""
    scene = survey.scene
    for name in scene.techniques:
        form = scene.part(name)
        if form is not None and form.needs_turn:
            survey.report(("drive", "stroke"), "turn_needed", name=name)
    for name in ("balancing", "gear"):
        if scene.has(("drive", name)):
            survey.report(("drive", name), "turn_alone", name=name)


def _pushed(survey: Survey) -> SlideTable | None:
    """Give the slide on the frame of the drive's link."""
    frame, link = survey.points_of[FRAME], survey.form.drive.link
    own = (table for table in survey.form.mechanism.slides if table.link == link)
    return next((one for one in own if _on_frame(one.along, frame)), None)


def _on_frame(along: tuple[str, ...] | LineTable, frame: Collection[str]) -> bool:
    return along.link == FRAME if isinstance(along, LineTable) else all(name in frame for name in along)


def datum_of(survey: Survey, ends: tuple[str, str] | None) -> Spot:
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
    survey: Survey, ends: tuple[str, str], links: Mapping[int, Link], sketch: Mapping[str, complex]
) -> Drive | None:
    """Make the drive of a scene; a stroke is counted in a power of two metres, near the largest length there is."""
    form = survey.form.drive
    if form.stroke is None:
        return Drive(form.link, *ends, float(form.omega), float(form.acceleration))
    if form.stroke.between is not None:
        return by_ram(survey, ends, links, sketch)
    guide = next(slide for slide in survey.slides if slide.slider == form.link and slide.owner == FRAME)
    unit = _unit(form.stroke, guide, links)
    omega, epsilon = (rate / unit for rate in form.stroke.rates)
    return Drive(form.link, *ends, omega, epsilon, SLIDER, guide, unit, law=form.stroke.law)


def _unit(stroke: StrokeTable, guide: Slide, links: Mapping[int, Link]) -> float:
    """Give the power of two metres that no place of the stroke and no length of a link is beyond."""
    places = [abs(place) for link in links.values() for place in link.points.values()]
    ways = [abs(float(way)) for way in (stroke.from_, stroke.to)]
    return float(2.0 ** ceil(log2(max(*places, *ways, abs(guide.on_owner.through)))))
