"""All that the construction finds of one cam's profile (кулачок, итог построения)."""

from __future__ import annotations

from plans.cam.course import Course
from plans.cam.profile.contact import contact_of, pressing
from plans.cam.profile.extremes import Extremes
from plans.cam.profile.flaws import Search
from plans.cam.profile.profile import profile
from plans.cam.profile.remedy import base_needed, sizes_advised
from plans.cam.profile.roller import Roller, roller_of
from plans.cam.profile.stretches import Stretches
from plans.model.cam import GROOVE, ROLLER
from plans.model.cam_motion import CONSTRUCTION, CamFound, Sizes
from plans.model.motion import Floats


def cam_found(course: Course, sizes: Sizes, turned: Floats) -> CamFound:
    """Find a cam's profile at some turns, rad, its extremes over the whole turn, and its flaws."""
    extremes = Extremes(Stretches(course, sizes))
    roller, rule = roller_for(extremes)
    contact = contact_of(course.cam, roller)
    flaws = Search(extremes, roller, contact).flaws()
    return CamFound(
        by=CONSTRUCTION,
        cam=course.cam,
        sizes=sizes,
        roller=roller,
        contour=profile(course, sizes, roller, turned).contour,
        shocks=course.shocks,
        peaks=extremes.peaks,
        pressure=extremes.pressure,
        sharpest=extremes.sharpest,
        hollow=extremes.hollow,
        face=extremes.face,
        flaws=flaws,
        rule=rule,
        pressing=pressing(contact, extremes.stretches) if contact and not extremes.outrun else None,
        mending=base_needed(extremes.stretches),
        advised=sizes_advised(course.cam) if any(one.kind == "pressure" for one in flaws) else None,
    )


def roller_for(extremes: Extremes) -> Roller:
    """Take the roller of a cam, by its rule where none is given; a pointed or a flat follower has none."""
    cam, sharpest = extremes.stretches.course.cam, extremes.sharpest
    if cam.follower.end != ROLLER:
        return Roller(0.0, "given")
    hollow = extremes.hollow if cam.closure == GROOVE else None
    bends = sharpest.value if sharpest else None, -hollow.value if hollow else None
    return roller_of(cam.roller, bends[0], extremes.stretches.sizes.base, bends[1])
