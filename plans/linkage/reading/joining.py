"""Joining (соединение звеньев): which links hang together, and which hang in the air or hold each other twice."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from plans.linkage.reading.survey import Survey
from plans.model.mechanism import FRAME, Slide
from plans.scene.faults import Path
from plans.words.words import Message, message


def check_joining(survey: Survey, slides: tuple[Slide, ...]) -> None:
    """See that every link is joined to the frame, if only through others, that none is loose, and no two are one."""
    if len(slides) < len(survey.form.mechanism.slides):
        return  # a faulty slide may be the very connection that is missing
    if survey.doubtful(*(("mechanism", name) for name in ("frame", "links", "points", "slides"))):
        return
    waiting = _islands(survey, slides)
    if waiting:
        links = message("place.links", count=len(waiting), links=", ".join(map(str, sorted(waiting))))
        survey.report(_link(min(waiting)), "island", links=links)
    if survey.faults or survey.doubts:
        return  # what is told already may be the reason
    sliding = {link for slide in slides for link in (slide.slider, slide.owner)}
    for link, points in survey.points_of.items():
        if link not in (FRAME, survey.form.drive.link) and len(points) == 1 and link not in sliding:
            survey.report(_link(link), "loose", link=link, name=points[0])
    for first, second, how in _doubled(survey, slides):
        survey.report(_link(second), "one_body", first=first, second=second, how=how)


def _link(number: int) -> Path:
    return "mechanism", "links", str(number)


def _islands(survey: Survey, slides: tuple[Slide, ...]) -> set[int]:
    """Give the links that nothing joins to the frame."""
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


def _doubled(survey: Survey, slides: tuple[Slide, ...]) -> Iterator[tuple[int, int, str | Message]]:
    """Give moving links that two pairs hold in one place: two hinges, or a hinge and a slide."""
    for first, second in combinations(survey.form.mechanism.links, 2):
        common = [name for name in survey.points_of[first] if name in survey.points_of[second]]
        lines = [slide for slide in slides if {slide.slider, slide.owner} == {first, second}]
        if len(common) > 1 or (common and lines and lines[0].label):
            yield first, second, ", ".join([*common, *(slide.label for slide in lines)][:2])
        elif common and lines:
            yield first, second, message("place.point_and_line", name=common[0], link=lines[0].owner)
