"""Limits of the pressure angle: an interval for both phases in a groove (5.30); sizes that are found keep to it."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import product

import pytest

from plans.analytic.cam.findings import cam_found as analysed
from plans.analytic.cam.sizes import sizes
from plans.cam.centre.sizes import sizing
from plans.cam.course import FollowerCourse, positions
from plans.cam.hub import wall
from plans.cam.profile.findings import cam_found
from plans.cam.study import PROFILE, CamStudy
from plans.model.cam import DWELL, FORCE, GROOVE, RETURN, RISE, ROCKING, TRANSLATING, Cam, GivenSizes, Hub, Limits
from plans.model.cam_motion import CamError, CamFound, CamSizes
from tests.parts import some
from tests.plans.cam_cases import LIFT, SWING, cam, phases

SHORT = ((RISE, 60.0, "sine"), (DWELL, 20.0, ""), (RETURN, 100.0, "cosine"), (DWELL, 180.0, ""))
ANGLES = ((15, 40), (40, 15), (30, 30), (20, 60), (25, 45))


def limited(motion: str, closure: str, rise: float, back: float, sense: int = 1) -> Cam:
    """Give a cam whose rise is short, with limits in degrees."""
    limits = Limits(math.radians(rise), math.radians(back) if closure == GROOVE else None)
    own = phases(SHORT, SWING if motion == ROCKING else LIFT)
    return cam(motion, sense=sense, with_cam=sense, closure=closure, limits=limits, phases=own)


def draw(one: Cam, own: CamSizes) -> CamFound:
    return cam_found(FollowerCourse(one), own, positions(one))


def analyse(one: Cam, own: CamSizes) -> CamFound:
    return analysed(one, own, positions(one))


BOTH = pytest.mark.parametrize("road", [draw, analyse])
CASES = [(*kind, *pair, to) for *kind, pair, to in product((TRANSLATING, ROCKING), (GROOVE, FORCE), ANGLES, (1, -1))]


@pytest.mark.parametrize("case", some(CASES, 21))
def test_sizes_that_are_found_keep_to_the_limits(case):
    one = limited(*case)
    for found in (draw(one, sizing(FollowerCourse(one)).sizes), analyse(one, sizes(one))):
        assert "pressure" not in {flaw.kind for flaw in found.flaws} and found.advised is None


@BOTH
def test_rockers_are_advised_and_radial_bases_mend(road):
    one = limited(ROCKING, FORCE, 30, 30)
    own = sizes(replace(one, limits=Limits(math.radians(60))))
    found = road(one, own)
    assert "pressure" in {flaw.kind for flaw in found.flaws} and found.mending is None
    assert found.advised is not None and found.advised.centre == pytest.approx(sizes(one).centre)


def test_a_roller_over_the_centre_is_refused():
    """It is told which roller the curvature bears."""
    one = replace(cam(), given=GivenSizes(0.05, 0.0), roller=0.05)
    with pytest.raises(CamError) as refused:
        CamStudy([one]).found  # noqa: B018
    least = draw(replace(one, roller=0.01), CamSizes(0.05)).sharpest
    assert least is not None and dict(refused.value.message.parts)["most"] == f"{1000 * min(least.value, 0.05):.6g}"
    assert CamStudy([replace(one, roller=0.049)]).found


@pytest.mark.parametrize("sense", [1, -1])
def test_a_wall_is_left_over_bore_and_keyway(sense):
    """Where the cam dwells its rim is a circle, and the corners of a keyway are nearest to it."""
    base, bore, width, depth = 0.05, 0.03, 0.008, 0.0033
    resting = math.radians(300)  # of the zero ray, against the rotation: in the middle of the last dwell

    def keyed(bore: float, depth: float, angle: float) -> Cam:
        hub = Hub(bore, width, depth, angle, wall=depth)
        return replace(limited(TRANSLATING, FORCE, 30, 30, sense), given=GivenSizes(base, 0.0), roller=0.0, hub=hub)

    left = base - math.hypot(bore / 2 + depth, width / 2)
    # A quarter of a degree
    assert wall(draw(keyed(bore, depth, resting), CamSizes(base))) == pytest.approx(left, abs=1e-7)
    on_the_rise = wall(draw(keyed(bore, depth, math.radians(50)), CamSizes(base)))
    assert left < on_the_rise < base - bore / 2 + 1e-12  # there the bore itself is nearest
    for deeper, told in ((left / 2, "leaves a wall of"), (left + 0.001, "breaks through")):
        cam = keyed(bore, depth + deeper, resting)
        with pytest.raises(CamError, match=told) as refused:
            CamStudy([cam]).found  # noqa: B018
        more = re.search(r"larger by ([\d.]+) mm", str(refused.value))
        assert more and len(more[1].replace(".", "").lstrip("0")) <= 4
        assert wall(draw(cam, CamSizes(base + float(more[1]) / 1000))) >= depth + deeper  # the cure helps
        assert "R_0 = 50 mm" in str(refused.value)
        fits = [int(size) / 1000 for size in re.findall(r"at most (\d+) mm", str(refused.value))]
        cams = (keyed(fit + over, depth + deeper, resting) for fit in fits for over in (0, 0.001))
        kept = [wall(draw(one, CamSizes(base))) >= depth + deeper for one in cams]
        assert kept == [True, False] * told.startswith("le")  # the largest that fits


def test_a_roller_by_rule_grows_with_the_cam_and_the_cure_of_a_thin_wall_counts_it() -> None:
    cam = replace(
        limited(TRANSLATING, FORCE, 30, 30, 1), given=GivenSizes(0.035, 0.0), hub=Hub(0.035, 0, 0, wall=0.004)
    )
    with pytest.raises(CamError) as refused:
        CamStudy([cam]).found  # noqa: B018
    more = re.search(r"larger by ([\d.]+) mm", str(refused.value))
    assert more
    CamStudy([replace(cam, given=GivenSizes(0.035 + float(more[1]) / 1000, 0.0))]).found  # noqa: B018
    with pytest.raises(CamError) as both:
        CamStudy([cam, replace(cam, name="second")]).construct({PROFILE})
    assert str(both.value).count("larger by") == 2
