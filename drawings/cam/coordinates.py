"""Coordinates of the profiles beside their sheet, each number held to the analysis (координаты профиля).

A row of the table of sheets: what is written is the construction, what it is held to is not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from drawings.checks.expected import KNOWN, Wrong
from drawings.files.atomic_files import Enclosure
from drawings.files.coordinate_table import CURVATURE, DIGITS, THETA, read, written
from plans.analytic.cam.contour import contour
from plans.cam.course import FollowerCourse, settled
from plans.cam.study import CamStudy
from plans.model.cam import MM, Cam
from plans.model.cam_motion import CamFound, Points
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import message

ROUNDED = 0.5 * 10.0**-DIGITS


def enclosures(study: Study) -> Iterator[Enclosure]:
    """Give the coordinates of each cam's profile at equal parts of its turn, or of its travel."""
    drawings, theirs = study.of(CamStudy).drawings.values(), study.comparison("cam").analysis.cams
    for number, (drawing, found) in enumerate(zip(drawings, theirs, strict=True)):
        turned = turns(drawing.cam)
        content = written(drawing.cam, drawing.profile(turned).contour)
        yield Enclosure(_named(number), content, partial(faults, found=found, name=_named(number)))


def turns(cam: Cam) -> Floats:
    """Give the turns at which a profile is told, rad, (N,): the last is the first again, none beside a joint."""
    return settled(np.linspace(0.0, cam.turn, cam.coordinates + 1), FollowerCourse(cam))


def faults(content: bytes, found: CamFound, name: str) -> Iterator[Wrong]:
    """Hold written coordinates to the analysis: the same columns, each number rounded."""
    exact = dict(_columns(found))
    table = read(content)
    for column in exact.keys() ^ table.keys():
        yield message("wrong.column", name=column, file=name)
    for column in exact.keys() & table.keys():
        off = _bends_off if column == CURVATURE else _off
        if (row := _first(off, np.array(table[column]), exact[column])) is not None:
            yield message("wrong.coordinate", name=column, row=row + 1, file=name)


def _columns(found: CamFound) -> Iterator[tuple[str, Floats]]:
    """Give what the columns must say, (N,) each in mm or degrees: the follower's way, the curves, how they bend."""
    cam = found.cam
    at = contour(cam, found.sizes, found.roller, turns(cam))
    way = at.travel.s
    yield ("travel_mm", MM * at.turned) if cam.translates else ("turned_deg", np.degrees(at.turned))
    yield ("s_deg", np.degrees(way)) if cam.rocks else ("s_mm", MM * way)
    curves = {"": at.profile} | ({"pitch_": at.pitch} if at.profile is not at.pitch and not cam.flat else {})
    for name, curve in (curves if at.outer is None else curves | {"outer_": at.outer}).items():
        yield from ((f"{name}x_mm", MM * np.real(curve)), (f"{name}y_mm", MM * np.imag(curve)))
        if not cam.translates:
            yield from ((f"{name}radius_mm", MM * np.abs(curve)), (f"{name}angle_deg", _turn(curve)))
    if not cam.translates:
        turned = _turn(at.profile)
        yield THETA, turned[0] - turned if cam.sense > 0 else turned - turned[0]
    yield from (("pressure_deg", np.degrees(at.pressure)), (CURVATURE, MM * at.radius))


def _turn(curve: Points) -> Floats:
    """Give the directions of points from O in degrees, counter-clockwise without a leap."""
    return np.degrees(np.unwrap(np.angle(curve)))


def _first(off: Callable[[Floats, Floats], Floats], table: Floats, exact: Floats) -> int | None:
    """Give the first row in which a number is off by more than is allowed."""
    if table.shape != exact.shape:
        return min(len(table), len(exact))
    right = off(table, exact) <= 0
    return None if right.all() else int(np.argmin(right))


def _off(table: Floats, exact: Floats) -> Floats:
    """Give how far numbers are off, less what is allowed."""
    return np.abs(table - exact) - ROUNDED - KNOWN * np.abs(exact)


def _bends_off(table: Floats, exact: Floats) -> Floats:
    """Give it for radii by how the curve bends: where it is nearly straight either road may have any large radius.

    An edge, whose radius is no more than the rounding, bends by that: there it is the radii that are compared.
    """
    bend, true = (np.copysign(1 / np.maximum(np.abs(radii), ROUNDED), radii) for radii in (table, exact))
    bent = np.abs(bend - true) - ROUNDED * true**2 - KNOWN * np.abs(true).max()
    edge = np.abs(exact) <= ROUNDED
    with np.errstate(invalid="ignore"):  # of a straight place both are infinite
        return np.where(edge, np.abs(table) - ROUNDED - np.abs(exact), bent)


def _named(number: int) -> str:
    return f"profile-{number + 1}.csv" if number else "profile.csv"
