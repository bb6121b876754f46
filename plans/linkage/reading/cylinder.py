"""A cylinder of a scene that drives: between a fixed point and one of the crank, or two others (гидроцилиндр)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from geometry.meet import cross
from plans.linkage.primaries import between, ram
from plans.linkage.reading.shapes import plain
from plans.linkage.reading.survey import Survey
from plans.linkage.sketch import SketchError
from plans.model.mechanism import FRAME, Drive, Link, Mechanism, Ram, StructureError
from plans.scene.faults import Path
from plans.scene.units import WORKING

BETWEEN: Path = ("drive", "stroke", "between")


def by_ram(
    survey: Survey, ends: tuple[str, str], links: Mapping[int, Link], sketch: Mapping[str, complex]
) -> Drive | None:
    """Make the drive of a crank that a cylinder turns; its rates are those at the first length, from rest halfway.

    Of one that the crank's triangle does not hold they are found when the whole linkage is known: see `between_links`.
    """
    stroke = survey.form.drive.stroke
    points = _points(survey, ends)
    if stroke is None or points is None or not _moves(survey):
        return None
    fixed, point = points
    told = Ram(fixed, point, float(stroke.from_), float(stroke.to), *stroke.rates, 0.0)
    drive = Drive(survey.form.drive.link, *ends, 1.0, 0.0, ram=told, law=stroke.law)
    if not _on_crank(survey, points, ends):
        owners = survey.owners((fixed,))[0], survey.owners((point,))[0]
        return replace(drive, ram=replace(told, links=owners))
    if not _reached(survey, points, links, ends):
        return None
    hinge, foot = links[FRAME].points[ends[0]], links[FRAME].points[fixed]
    if point not in sketch:
        survey.report(BETWEEN, "ram_sketch", name=point)
        return None
    turned = float(cross(np.asarray(hinge - foot), np.asarray(sketch[point] - foot)))
    found = replace(told, side=1.0 if turned >= 0 else -1.0)
    whole = Mechanism("", (stroke.to, stroke.to), links, (), replace(drive, ram=found), sketch, None)
    return _begun(whole, found)


def between_links(survey: Survey, mechanism: Mechanism) -> Mechanism | None:
    """Give a linkage that a cylinder between two of its links drives the rates that its crank has at the first length.

    What has no structure or no one assembly is left as it is: the study of it says so.
    """
    ram = mechanism.drive.ram
    if ram is None or ram.links is None or mechanism.mobility != 1:
        return mechanism
    try:
        told = between.passage(mechanism)
    except (StructureError, SketchError):
        return mechanism
    line = f"{ram.foot}{ram.point}"
    if told is None:
        survey.report(BETWEEN, "ram_nowhere", line=line)
        return None
    for name, way in (("from", ram.begin), ("to", ram.end)):
        if not told[1][0] < way < told[1][1]:
            least, most = (_millimetres(float(f"{end:.6g}")) for end in told[1])
            survey.report(("drive", "stroke", name), "ram_passage", line=line, least=least, most=most)
            return None
    found = replace(ram, passage=told[0])
    whole = replace(mechanism, drive=replace(mechanism.drive, ram=found))
    return replace(whole, drive=_begun(whole, found))


def _begun(whole: Mechanism, found: Ram) -> Drive:
    """Give the drive of a mechanism the crank's rates at the first length; where it rests there, halfway."""
    rests = dict(whole.drive.law).get(found.begin) == 0
    first = ram.positions(whole, np.array([(found.begin + found.end) / 2 if rests else found.begin]))
    omega, epsilon = ram.pace(whole)(first.phi).at(0)
    return replace(whole.drive, omega=omega, epsilon=epsilon)


def _points(survey: Survey, ends: tuple[str, str]) -> tuple[str, str] | None:
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


def _on_crank(survey: Survey, points: tuple[str, str], ends: tuple[str, str]) -> bool:
    """Tell whether the triangle of a fixed point, the crank's hinge and its point holds the cylinder."""
    own, fixed = survey.points_of[survey.form.drive.link], survey.points_of[FRAME]
    return points[0] in fixed and points[0] != ends[0] and points[1] in own


def _moves(survey: Survey) -> bool:
    """See that the cylinder has a speed."""
    stroke = survey.form.drive.stroke
    assert stroke is not None  # it is a cylinder's
    if not stroke.rates[0]:
        survey.report(("drive", "stroke", "speed"), "ram_still")
    return bool(stroke.rates[0])


def _reached(survey: Survey, points: tuple[str, str], links: Mapping[int, Link], ends: tuple[str, str]) -> bool:
    """See that the triangle closes over the whole stroke, and is no line at either end: no speed is borne there."""
    stroke = survey.form.drive.stroke
    assert stroke is not None  # it is a cylinder's
    own, frame = links[survey.form.drive.link].points, links[FRAME].points
    base, arm = abs(frame[points[0]] - frame[ends[0]]), abs(own[points[1]] - own[ends[0]])
    least, most = abs(base - arm), base + arm
    for name, way in (("from", stroke.from_), ("to", stroke.to)):
        if not least < float(way) < most:
            reach = {"least": _millimetres(least), "most": _millimetres(most)}
            survey.report(("drive", "stroke", name), "ram_reach", line="".join(points), **reach)
            return False
    return True


def _millimetres(length: float) -> str:
    return plain(WORKING.create_decimal_from_float(1000 * length))
