"""The coordinates of a profile as text for a machine tool: a row for each turn of the cam (таблица координат профиля).

Commas between columns, decimal points and plain names whatever the language of the sheets: programs read it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from plans.model.cam import Cam
from plans.model.cam_motion import Contour, Points
from plans.model.motion import Floats

DIGITS = 6  # after the point: a millionth of a millimetre or of a degree
CURVATURE = "curvature_radius_mm"
THETA = "theta_deg"  # from the zero ray through the first point, against the rotation, as on the sheet
MM, DEGREES = 1e3, 180 / np.pi


def columns(cam: Cam, contour: Contour) -> Mapping[str, Floats]:
    """Give the columns, (N,) each, by their names with their units; an infinite radius is that of a straight piece.

    Angles are counted from the x axis counter-clockwise, but for θ.
    """
    turned, s = ("travel_mm", MM) if cam.translates else ("turned_deg", DEGREES), DEGREES if cam.rocks else MM
    found: dict[str, Floats] = {turned[0]: contour.turned * turned[1]}
    found["s_deg" if cam.rocks else "s_mm"] = contour.travel.s * s
    found |= _placed("", contour.profile, polar=not cam.translates)
    if not cam.translates:
        found[THETA] = -cam.sense * (found["angle_deg"] - found["angle_deg"][0]) + 0.0
    if contour.outer is not None:
        found |= _placed("outer_", contour.outer, polar=not cam.translates)
    if contour.profile is not contour.pitch and not cam.flat:
        found |= _placed("pitch_", contour.pitch, polar=not cam.translates)
    return found | {"pressure_deg": contour.pressure * DEGREES, CURVATURE: contour.radius * MM}


def written(cam: Cam, contour: Contour) -> bytes:
    """Write the coordinates at the turns of a contour."""
    found = columns(cam, contour)
    rows = zip(*(np.round(column, DIGITS) + 0.0 for column in found.values()), strict=True)  # adding 0 makes -0 into 0
    lines = [",".join(found), *(",".join(f"{value:.{DIGITS}f}" for value in row) for row in rows)]
    return "".join(f"{line}\r\n" for line in lines).encode("ascii")


def read(content: bytes) -> Mapping[str, list[float]]:
    """Read coordinates back, by the names of their columns."""
    heading, *rows = content.decode("ascii").splitlines()
    values = [[float(cell) for cell in row.split(",")] for row in rows]
    return dict(zip(heading.split(","), map(list, zip(*values, strict=True)), strict=True))


def _placed(name: str, points: Points, polar: bool) -> Mapping[str, Floats]:
    """Give points by x and y, and about the cam's centre by radius and angle."""
    return dict(_columns(name, points, polar))


def _columns(name: str, points: Points, polar: bool) -> Iterator[tuple[str, Floats]]:
    if polar:
        yield f"{name}radius_mm", np.abs(points) * MM
        yield f"{name}angle_deg", np.unwrap(np.angle(points)) * DEGREES
    yield f"{name}x_mm", points.real * MM
    yield f"{name}y_mm", points.imag * MM
