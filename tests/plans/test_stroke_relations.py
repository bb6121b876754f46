"""Machines driven over a stroke: places by hand, their power, what they obey turned, mirrored, enlarged, reversed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.forces.drive import balancing_quantity
from plans.linkage import ram
from plans.linkage.primary import PRIMARIES
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, Motion
from plans.study import Study
from tests.parts import examples, first, some
from tests.plans.chains import numbers
from tests.plans.pushed_machines import (
    BOOM_MASSES,
    FORCE,
    GUIDE,
    LIFT,
    MOMENT,
    OFFSET,
    PLAIN,
    PULL,
    PUSH,
    ROD,
    SLIDER_MASSES,
    STEPS,
    Picture,
    Stroke,
    cylinder,
    slider,
)

NEAR = 1e-9  # of the largest: far more than roundings here, and far less than any part left out
MACHINES: dict[str, tuple[Callable[..., Study], Stroke]] = {
    "slider": (slider, PUSH),
    "cylinder": (cylinder, LIFT),
    "bare": (partial(cylinder, bare=True), LIFT),
}
LAW = (0.1, 0.4, 0.2)


class Row(NamedTuple):
    """What a machine does over its stroke: points and links, what pushes, what the frame bears, (N,) each."""

    motion: Motion
    push: Floats
    reactions: dict[tuple[int, int, str], Complexes]
    moments: dict[tuple[int, int, str], Floats]


@cache
def rows(name: str, picture: Picture = PLAIN, speeds: tuple[float, ...] = (), back: bool = False) -> Row:
    """Study a machine; both roads agree on it."""
    return _rows(name, picture, speeds, back, 1.0)


def _rows(name: str, picture: Picture, speeds: tuple[float, ...], back: bool, times: float) -> Row:
    make, way = MACHINES[name]
    way = replace(way, speeds=speeds, times=times)
    study = make(picture, way.back if back else way)
    assert study.comparison("forces").agrees
    motion, statics = study["linkage"].motion(2), study["forces"]
    forces = statics.forces
    told = {(one.giver, one.taker, one.point): one for one in forces.reactions.values()}
    turned = {key: one.moment for key, one in told.items() if one.moment is not None}
    return Row(motion, statics.given(forces, motion), {key: one.force for key, one in told.items()}, turned)


def alike(new: Floats | Complexes, old: Floats | Complexes) -> None:
    """See that rows are those of before, but for roundings of the largest."""
    assert np.isfinite(old).all()
    assert np.abs(new - old).max() <= NEAR * max(float(np.abs(old).max()), 1.0)


def obeys(new: Row, old: Row, picture: Picture, chosen: slice = slice(None), rate: float = 1.0) -> None:
    """See that a machine does what it did, in another picture, `rate` times as fast and with so much more force."""
    for name, point in old.motion.points.items():
        for order, row in enumerate(point):
            alike(new.motion.points[name][order][chosen], np.vectorize(picture.vector)(rate**order * row))
    for link, turns in old.motion.links.items():
        for order, rates in enumerate(turns[1:], 1):
            alike(new.motion.links[link][order][chosen], picture.sense * rate**order * rates)
    size = picture.size * rate**2
    alike(new.push[chosen] / size, old.push)
    assert new.reactions.keys() == old.reactions.keys()
    for key, force in old.reactions.items():
        alike(new.reactions[key][chosen] / size, np.vectorize(picture.unit)(force))
    for key, moment in old.moments.items():
        alike(new.moments[key][chosen] / (size * picture.size), picture.sense * moment)


@examples(2, 30)
@given(st.sampled_from(sorted(MACHINES)), numbers(-3.1, 3.1), st.booleans(), st.sampled_from((0.3, 1.0, 3.7)))
def test_a_machine_turned_mirrored_and_enlarged_does_the_same(name, turn, mirrored, size):
    picture = Picture(turn, mirrored, size)
    obeys(_rows(name, picture, (), False, 1.0), rows(name), picture)


@pytest.mark.parametrize("name", MACHINES)
def test_a_machine_at_another_scale_mirrored_does_the_same(name: str) -> None:
    picture = Picture(2.0, True, 3.7)
    obeys(rows(name, picture), rows(name), picture)


@pytest.mark.parametrize("name", MACHINES)
def test_a_law_over_the_stroke_is_turned_and_enlarged_with_the_machine(name: str) -> None:
    picture = Picture(-1.0, False, 0.3)
    obeys(rows(name, picture, LAW), rows(name, speeds=LAW), picture)


@pytest.mark.parametrize("speeds", first([(), LAW]))
@pytest.mark.parametrize("name", some(MACHINES, 3))
def test_a_stroke_gone_back_has_its_velocities_turned_about(name: str, speeds: tuple[float, ...]) -> None:
    """And the same accelerations and forces: nothing here is against the motion."""
    obeys(rows(name, speeds=speeds, back=True), rows(name, speeds=speeds), PLAIN, slice(None, None, -1), -1)


@pytest.mark.parametrize("name", MACHINES)
def test_a_faster_drive_stretches_the_plans(name: str) -> None:
    obeys(_rows(name, PLAIN, LAW, False, 2.0), rows(name, speeds=LAW), PLAIN, rate=2.0)


@pytest.mark.parametrize("speeds", [(), LAW])
@pytest.mark.parametrize("name", ["cylinder", "bare"])
def test_the_cylinder_s_points_part_by_its_law(name: str, speeds: tuple[float, ...]) -> None:
    motion = rows(name, speeds=speeds).motion
    apart = motion.points["F"].r - motion.points["E"].r
    length, along = np.abs(apart), apart.conj() / np.abs(apart)
    ways = np.linspace(LIFT.begin, LIFT.end, STEPS + 1)
    v, a = _law(LIFT, ways, speeds)
    own = along * motion.points["F"].v, along * motion.points["F"].a
    alike(length, ways)
    alike(own[0].real, v)
    alike(own[1].real + own[0].imag ** 2 / length, a)


def _law(way: Stroke, ways: Floats, speeds: tuple[float, ...]) -> tuple[Floats, Floats]:
    """Give speed and acceleration: those told, or between the two halves of the law, a = v dv/ds."""
    if not speeds:
        return np.full(len(ways), way.speed), np.full(len(ways), way.acceleration)
    half = (way.end - way.begin) / 2
    first = ways < way.begin + half
    slope = np.where(first, speeds[1] - speeds[0], speeds[2] - speeds[1]) / half
    v = np.where(first, speeds[0] + slope * (ways - way.begin), speeds[1] + slope * (ways - way.begin - half))
    return v, v * slope


@pytest.mark.parametrize("name", MACHINES)
def test_the_force_of_the_drive_has_the_power_of_all_others(name: str) -> None:
    """Of weights, inertia and loads, from places of mass centres midway between two points of their links."""
    make, way = MACHINES[name]
    study = make(gravity=9.81)
    motion, statics = study["linkage"].motion(2), study["forces"]
    ends = {1: "HB", 2: "HA", 3: "OA"} if name == "slider" else {1: "OH", 2: "FG"}
    told = {"slider": SLIDER_MASSES, "cylinder": (BOOM_MASSES, ROD), "bare": (BOOM_MASSES,)}[name]
    power = np.zeros(STEPS + 1)
    for link, mass, inertia in told:
        v, a = (sum(motion.points[point][order] for point in ends[link]) / 2 for order in (1, 2))
        power += mass * ((-9.81j - a) * np.conj(v)).real
        power -= inertia * motion.links[link].omega * motion.links[link].epsilon
    loaded, turned = {"slider": ("A", 3), "cylinder": ("H", 2), "bare": ("H", 1)}[name]
    power += FORCE * (PULL * np.conj(motion.points[loaded].v)).real + MOMENT * motion.links[turned].omega
    alike(-power / way.speed, statics.given(statics.forces, motion))  # at one speed, the acceleration beside it


@pytest.mark.parametrize("name", MACHINES)
def test_the_frame_bears_what_acts_on_the_machine(name: str) -> None:
    """Forces on the frame, of a bare cylinder too, and their moments, are those of loads and inertia."""
    row = rows(name)
    motion = row.motion
    ends = {1: "HB", 2: "HA", 3: "OA"} if name == "slider" else {1: "OH", 2: "FG"}
    told = {"slider": SLIDER_MASSES, "cylinder": (BOOM_MASSES, ROD), "bare": (BOOM_MASSES,)}[name]
    loaded = "A" if name == "slider" else "H"
    force, moment = np.full(STEPS + 1, FORCE * PULL), np.zeros(STEPS + 1)
    moment += MOMENT + _cross(motion.points[loaded].r, force)
    for link, mass, inertia in told:
        r, a = (sum(motion.points[point][order] for point in ends[link]) / 2 for order in (0, 2))
        force = force - mass * a
        moment -= _cross(r, mass * a) + inertia * motion.links[link].epsilon
    for (giver, taker, point), borne in row.reactions.items():
        if FRAME in (giver, taker):
            own = borne if giver == FRAME else -borne
            force = force + own
            moment += _cross(motion.points[point].r, own)
            turned = row.moments.get((giver, taker, point), np.zeros(STEPS + 1))
            moment += turned if giver == FRAME else -turned
    pushed, at = _pushed(name, row)
    alike(force + pushed, np.zeros(STEPS + 1))
    alike(moment + _cross(at, pushed), np.zeros(STEPS + 1))


def _pushed(name: str, row: Row) -> tuple[Complexes, Complexes]:
    """Give what the drive itself does from the frame: along the guide, or a bare cylinder along its line."""
    points = row.motion.points
    if name == "slider":
        return row.push * GUIDE, points["B"].r - 1j * OFFSET * GUIDE  # along its guide
    apart = points["F"].r - points["E"].r
    along = apart / np.abs(apart) if name == "bare" else 0.0 * apart
    return row.push * along, points["F"].r


def _cross(arm: Complexes, force: Complexes) -> Floats:
    return np.asarray((np.conj(arm) * force).imag)


def test_solve_tells_the_way_of_the_slider_and_the_length_of_the_cylinder() -> None:
    for make, way in ((slider, PUSH), (cylinder, LIFT)):
        told = make().numbers("linkage", "construction").plain()["s"]
        assert told == pytest.approx(np.linspace(way.begin, way.end, STEPS + 1).tolist(), rel=1e-12)


def test_a_law_is_straight_between_its_places_and_at_a_corner_the_line_ahead_counts() -> None:
    """Two halves of the stroke: at its middle the second one's slope, gone back the first one's."""
    half, middle = (PUSH.end - PUSH.begin) / 2, (PUSH.end + PUSH.begin) / 2
    for back, slope in ((False, -0.2 / half), (True, 0.3 / half)):
        way = replace(PUSH, speeds=LAW)
        mechanism = slider(stroke=way.back if back else way)["linkage"].mechanism
        pace = ram.pace(mechanism)
        assert pace is not None
        rates = pace(np.array([middle / mechanism.drive.unit]))
        assert rates.epsilon[0] * mechanism.drive.unit == pytest.approx(0.4 * slope, rel=1e-9)


@pytest.mark.parametrize("name", MACHINES)
def test_a_force_is_told_of_a_drive_over_a_stroke(name: str) -> None:
    make, _ = MACHINES[name]
    told = balancing_quantity(make()["linkage"].mechanism.drive)
    assert (told.name, told.unit) == ("P_bal", "N")


def test_the_drive_s_end_is_where_its_plans_have_it() -> None:
    for make, _ in MACHINES.values():
        linkage = make()["linkage"]
        drive = linkage.mechanism.drive
        found = PRIMARIES[drive.kind].ends(linkage.mechanism, linkage.turn)
        alike(found, linkage.motion(0).points[drive.end].r)
