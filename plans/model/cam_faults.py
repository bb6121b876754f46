"""Why a cam cannot be made as it is asked for, and what would do; both roads say it alike (невыполнимое задание)."""

from __future__ import annotations

import math

from geometry.errors import ConstructionError
from plans.model.cam import Cam, Limits
from plans.words.words import Message, message


class CamError(ConstructionError):
    """A cam that cannot be made as it is asked for, with the message that says why and what would do.

    `key` leads from the cam to what it is about in the file.
    """

    def __init__(self, what: Message, *key: str) -> None:
        super().__init__(what)
        self.key = key

    @property
    def message(self) -> Message:
        """What is wrong."""
        found = self.args[0]
        assert isinstance(found, Message)
        return found


def still(cam: Cam) -> CamError:
    """Say that nothing moves the follower."""
    return CamError(message("refused.cam_still", name=cam.name), "follower")


def no_region(cam: Cam, limits: Limits) -> CamError:
    """Say that the limits leave no place for the centre; with L given, that none is on its arc."""
    if cam.given.centre is not None:
        return CamError(message("refused.cam_circle", name=cam.name, centre=_mm(cam.given.centre)), "sizes", "centre")
    return CamError(message("refused.cam_region", name=cam.name, limits=_angles(limits)), "limits")


def vanishing(cam: Cam, limits: Limits) -> CamError:
    """Say that the limits are so large that hardly anything is left of the cam."""
    return CamError(message("refused.cam_vanishing", name=cam.name, limits=_angles(limits)), "limits")


def too_far(cam: Cam, offset: float, base: float) -> CamError:
    """Say that the offset is no smaller than the least radius."""
    return CamError(message("refused.cam_offset", name=cam.name, offset=_mm(offset), base=_mm(base)), "sizes", "offset")


def no_triangle(cam: Cam, length: float, base: float, centre: float) -> CamError:
    """Say that the rocker does not reach the cam."""
    ends = {"least": _mm(abs(length - base)), "most": _mm(length + base)}
    sizes = {"length": _mm(length), "base": _mm(base), "centre": _mm(centre)}
    return CamError(message("refused.cam_triangle", name=cam.name, **sizes, **ends), "sizes", "centre")


def no_level(cam: Cam, base: float, centre: float) -> CamError:
    """Say that the face of a rocker is nowhere so far from the centre."""
    sizes = {"base": _mm(base), "centre": _mm(centre), "most": _mm(centre + cam.follower.face)}
    return CamError(message("refused.cam_face_level", name=cam.name, **sizes), "sizes", "base")


def no_distance(cam: Cam) -> CamError:
    """Say that the distance of centres is needed."""
    return CamError(message("refused.cam_distance", name=cam.name), "sizes")


def hard_face(cam: Cam, turned: float) -> CamError:
    """Say that a flat face cannot follow a fall of S'."""
    return CamError(message("refused.cam_hard_face", name=cam.name, turned=f"{math.degrees(turned):.6g}"), "phases")


def fast_face(cam: Cam, turned: float) -> CamError:
    """Say that a rocker's face turns as fast as the cam."""
    return CamError(message("refused.cam_fast_face", name=cam.name, turned=f"{math.degrees(turned):.6g}"), "phases")


def pivot_passed(cam: Cam, farthest: float, centre: float) -> CamError:
    """Say that the profile under the face of a rocker passes its pivot: how far it goes from O, and L, m."""
    sizes = {"farthest": _mm(farthest), "centre": _mm(centre)}
    return CamError(message("refused.cam_pivot_passed", name=cam.name, **sizes), "sizes", "centre")


def large_roller(cam: Cam, roller: float, base: float, most: float) -> CamError:
    """Say that the roller reaches over the cam's centre, and which one the curvature bears, m."""
    sizes = {"roller": _mm(roller), "base": _mm(base), "most": _mm(most)}
    return CamError(message("refused.cam_roller", name=cam.name, **sizes), "sizes", "roller")


def no_radius(cam: Cam) -> CamError:
    """Say that no radius is the least."""
    return CamError(message("refused.cam_no_radius", name=cam.name), "limits")


def _angles(limits: Limits) -> str:
    return " / ".join(f"{math.degrees(one):.4g}" for one in (limits.rise, limits.back) if one is not None)


def _mm(size: float) -> str:
    return f"{1000 * size:.6g}"
