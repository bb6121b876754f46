"""Both roads to a cam's profile agree at every turn, for every follower, both senses, both signs of e."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from geometry.meet import EPS
from plans.analytic.cam.contour import contour
from plans.cam.course import Course
from plans.cam.profile.profile import profile
from plans.model.cam import Cam, Phase
from plans.model.cam_motion import Sizes
from tests.plans.textbook_cams import FLAT_BASE, START, cam, offset_sizes, pivot, rocker

TURNS = 3600
FACE = complex(0.06, -0.15)  # O - O1 of a rocker with a flat face


def flat_rocker(sense: int, turns: int) -> tuple[Cam, Sizes]:
    own = rocker("flat", sense, turns, face=0.005)
    return own, pivot(own, FACE)


def every() -> list[object]:
    made = []
    for sense in (1, -1):
        for offset in (0.012, -0.012, 0.0):
            for end in ("pointed", "roller"):
                made.append((f"{end} e={offset} {sense}", cam(end=end, sense=sense), offset_sizes(offset, START)))
        made.append((f"flat {sense}", cam(end="flat", sense=sense), Sizes(FLAT_BASE)))
        for turns in (1, -1):
            own = rocker("roller", sense, turns)
            made.append((f"rocker {sense} {turns}", own, pivot(own, complex(0.12, -0.07))))
            made.append((f"flat rocker {sense} {turns}", *flat_rocker(sense, turns)))
        slow = tuple(Phase(p.kind, p.angle / 10, p.start / 10, p.level, p.change, p.law) for p in cam().phases)
        made.append((f"bar {sense}", replace(cam(slow, end="roller", sense=sense), translates=True), Sizes(0.0)))
        own = rocker("roller", sense, 1)
        slow = tuple(Phase(p.kind, p.angle / 10, p.start / 10, p.level, p.change, p.law) for p in own.phases)
        made.append((f"bar rocker {sense}", replace(own, phases=slow, translates=True), Sizes(0.0)))
    return [pytest.param(own, sizes, id=name) for name, own, sizes in made]


OWN = 4  # roundings of the law and of sums, beside those of a notch, in eps of the longest length


@pytest.mark.parametrize(("own", "sizes"), every())
def test_both_roads_agree_at_3600_turns(own, sizes):
    """To 4 kappa eps of the longest length: kappa of the notch, and of the normal, which is short where OD is."""
    roller = 0.01 if own.follower.end == "roller" else 0.0
    turned = np.linspace(0, own.turn, TURNS)
    drawn = profile(Course(own), sizes, roller, turned)
    one, other = drawn.contour, contour(own, sizes, roller, turned)
    long = max(*(np.abs(z).max() for z in (one.tip, one.pitch, one.lever)), abs(sizes.pivot), own.follower.length or 0)
    sharp = drawn.drawing.board["P"].sharpness
    bound = (4 / (1.0 if sharp is None else np.asarray(sharp)) + OWN) * EPS * long
    for name in ("tip", "pitch", "lever", "sliding"):
        assert (np.abs(getattr(one, name) - getattr(other, name)) <= 2 * bound).all(), name
    turning = bound * (1 + long / np.abs(one.lever))
    assert (np.abs(one.profile - other.profile) <= turning).all()
    assert (one.outer is None) == (other.outer is None) == own.flat
    if one.outer is not None:
        assert (np.abs(one.outer - other.outer) <= turning).all()
    assert (np.abs(one.pressure - other.pressure) <= 2 * bound / np.abs(one.lever)).all()
    assert bends_alike(own, one, other, long)


def bends_alike(own, one, other, long) -> bool:
    """Tell whether the radii agree: to the roundings of S'' and of the lengths, over what the radius is found from."""
    big, size = np.abs(one.travel.bend).max() * (own.follower.length or 1.0) + long, np.abs(one.lever)
    if not own.flat:
        return bool((np.abs(1 / one.radius - 1 / other.radius) <= 16 * EPS * big / size**2 * (1 + big / size)).all())
    lead = 1 - own.follower.sense * one.travel.slope if own.rocks else 1.0
    return bool((np.abs(one.radius - other.radius) <= 16 * EPS * big / np.abs(lead) ** 3).all())
