"""Marks of a cam by the names that `explain` takes: O, D, K, P, Q, T_1 ..., of one of several cams as K2:P (точки)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from geometry.board import GIVEN, Board, Mark, behind
from plans.cam.centre.place import Sizing
from plans.cam.study import PROFILE, SIZES, CamDrawing, CamStudy
from plans.explanation import Explanation, NoMark, UnknownMark, in_position
from plans.model.cam import Cam, dimensions
from plans.study import Study
from plans.words.words import Message, because, message

LAW = "law"  # the board of the diagrams
OF = ":"  # between the name of a cam and the name of a mark
UNITS = {SIZES: "m", PROFILE: "m", LAW: ""}
WAYS = {"S": "cam_travel", "S'": "cam_law_slope", "S''": "cam_law_bend"}
POLES = {"P_1": ("S'", "S'_1"), "P_2": ("S",)}  # of the diagrams, by whose curve they are drawn to
PRESSURE = ("alpha", "α")
EXAMPLES = ("P", "Q", "D", "R_0", "S''", "alpha", "P_1")


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark of a cam's profile in one numbered position, or of its sizes."""
    cams = study.of(CamStudy)
    drawing, bare = _asked(cams, name)
    count = len(drawing.turned)
    if not 0 <= position < count:
        raise UnknownMark(message("mark.position", position=position, last=count - 1))
    found = _explained(drawing, position, bare)
    if found is None:
        drawn = dict.fromkeys(mark.name for board in _boards(drawing, 0) for mark in board)
        named = (*drawn, *WAYS, *POLES, *PRESSURE[:1])
        examples = tuple(example for example in EXAMPLES if _explained(drawing, 0, example) is not None)
        other = [*cams.drawings][1:2]
        listed = message("mark.of_cam", example=f"{other[0]}{OF}P") if other else None
        return NoMark(named, listed, examples)
    steps = in_position(behind(*found.marks), position, count)
    title = _title(drawing.cam, float(drawing.turned[position]), mark=name, position=position)
    return Explanation(title, steps, {**UNITS, **found.units}, found.notes)


class Explained(NamedTuple):
    """The marks that explain a name, with what is told after their steps."""

    marks: tuple[Mark, ...]
    notes: tuple[Message, ...] = ()
    units: Mapping[str, str] = {}


def _title(cam: Cam, turned: float, **parts: object) -> Message:
    """Head the steps with the turn of the cam, or with the travel of one that translates."""
    if cam.translates:
        return message("explain.along_way", way=f"{1000 * turned:.7g}", **parts)
    return message("explain.title", angle=f"{math.degrees(turned):.4f}", **parts)


def _explained(drawing: CamDrawing, position: int, name: str) -> Explained | None:
    """Find what explains a name: a quantity of the law, an angle, a radius, a pole, or a mark of that name."""
    if name in WAYS:
        return _way(drawing, position, name)
    if name in PRESSURE:
        return _pressure(drawing, position)
    called = tuple(f"{curve}:P" for curve in POLES.get(name, ())) or (name,)  # a pole bears the name of its curve
    known = [mark for board in _boards(drawing, position) for mark in board if mark.name in called]
    mark = min(known, key=lambda mark: mark.role == GIVEN, default=None)  # one board is given what another constructs
    if mark is not None:
        return Explained((mark,))
    return _radius(drawing.sizing) if name == "R_0" else None


def _way(drawing: CamDrawing, position: int, name: str) -> Explained:
    """Give S, S' or S'' in a position, upwards where it is above 0."""
    order, at = [*WAYS].index(name), drawing.turned[position : position + 1]
    mark = Board(LAW).given(name, 1j * float(drawing.course.at(at)[order][0]), because(WAYS[name]))
    return Explained((mark,), units={LAW: dimensions(drawing.cam)[order]})


def _pressure(drawing: CamDrawing, position: int) -> Explained:
    """Give the normal of the profile in a position, with the angle that it makes with the follower's way."""
    board = drawing.profile(drawing.turned[position : position + 1]).drawing.board
    angle = math.degrees(float(drawing.found.contour.pressure[position]))
    lines = tuple(mark for mark in board if mark.name == ("n" if drawing.cam.flat else "OD"))
    return Explained(lines, (message("explain.pressure", angle=f"{angle:.10g}"),))


def _radius(sizing: Sizing) -> Explained | None:
    """Give the least radius as it is found: from the centre to where the tip starts."""
    if sizing.start is None or sizing.centre is None:
        return None
    mark = Board(SIZES).join("R_0", sizing.centre, sizing.start, because("cam_base"))
    return Explained((mark,), (message("explain.least_radius", size=f"{sizing.sizes.base:.10g}"),))


def _asked(cams: CamStudy, name: str) -> tuple[CamDrawing, str]:
    """Tell which cam's mark is asked for: without a cam's name the first one's."""
    named = (cam for cam in cams.drawings if name.startswith(cam + OF))
    cam = next(named, "")
    return (cams.drawings[cam], name[len(cam + OF) :]) if cam else (next(iter(cams.drawings.values())), name)


def _boards(drawing: CamDrawing, position: int) -> Iterator[Board]:
    """Give the profile drawn at one position alone, then the sizes, then the diagrams of the law."""
    profile = drawing.profile(drawing.turned[position : position + 1])
    yield from (profile.drawing.board, drawing.sizing.board, drawing.diagrams.board)
