"""A cylinder of a scene that turns the crank: between a fixed point and a point of the crank (гидроцилиндр)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from geometry.meet import cross
from plans.linkage.primaries import ram
from plans.linkage.reading.shapes import plain
from plans.linkage.reading.survey import Survey
from plans.model.mechanism import FRAME, Drive, Link, Mechanism, Ram
from plans.scene.faults import Path
from plans.scene.units import WORKING

BETWEEN: Path = ("drive", "stroke", "between")


def by_ram(
    survey: Survey, ends: tuple[str, str], links: Mapping[int, Link], sketch: Mapping[str, complex]
) -> Drive | None:
    """Make the drive of a crank that a cylinder turns; its rates are those at the first length."""
    stroke = survey.form.drive.stroke
    points = _points(survey, ends)
    if stroke is None or points is None or not _reached(survey, points, links, ends):
        return None
    fixed, point = points
    hinge, foot = links[FRAME].points[ends[0]], links[FRAME].points[fixed]
    if point not in sketch:
        survey.report(BETWEEN, "ram_sketch", name=point)
        return None
    turned = float(cross(np.asarray(hinge - foot), np.asarray(sketch[point] - foot)))
    found = Ram(fixed, point, float(stroke.from_), float(stroke.to), *stroke.rates, 1.0 if turned >= 0 else -1.0)
    drive = Drive(survey.form.drive.link, *ends, 1.0, 0.0, ram=found, law=stroke.law)
    whole = Mechanism("", (stroke.to, stroke.to), links, (), drive, sketch, None)
    first = ram.positions(whole, np.array([found.begin]))
    omega, epsilon = ram.pace(whole)(first.phi).at(0)
    return replace(drive, omega=omega, epsilon=epsilon)


def _points(survey: Survey, ends: tuple[str, str]) -> tuple[str, str] | None:
    """Give the fixed point and the crank's point that a cylinder acts between."""
    stroke, link = survey.form.drive.stroke, survey.form.drive.link
    assert stroke is not None and stroke.between is not None  # it is a cylinder's
    if not survey.know(BETWEEN, stroke.between):
        return None
    fixed = [name for name in stroke.between if name in survey.points_of[FRAME] and name != ends[0]]
    own = [name for name in stroke.between if name in survey.points_of[link] and name != ends[0]]
    if len(fixed) != 1 or len(own) != 1:
        survey.report(BETWEEN, "ram_points", link=link, pivot=ends[0])
        return None
    return fixed[0], own[0]


def _reached(survey: Survey, points: tuple[str, str], links: Mapping[int, Link], ends: tuple[str, str]) -> bool:
    """See that the triangle closes over the whole stroke, and is no line at either end: no speed is borne there."""
    stroke = survey.form.drive.stroke
    assert stroke is not None  # it is a cylinder's
    own, frame = links[survey.form.drive.link].points, links[FRAME].points
    base, arm = abs(frame[points[0]] - frame[ends[0]]), abs(own[points[1]] - own[ends[0]])
    least, most = abs(base - arm), base + arm
    if not stroke.rates[0]:
        survey.report(("drive", "stroke", "speed"), "ram_still")
    for name, way in (("from", stroke.from_), ("to", stroke.to)):
        if not least < float(way) < most:
            reach = {"least": _millimetres(least), "most": _millimetres(most)}
            survey.report(("drive", "stroke", name), "ram_reach", line="".join(points), **reach)
            return False
    return True


def _millimetres(length: float) -> str:
    return plain(WORKING.create_decimal_from_float(1000 * length))
