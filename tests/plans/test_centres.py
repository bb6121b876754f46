"""Instant centres: three of three links in one line, one velocity in each; by them the rates of the plans (M3.2)."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from geometry.meet import EPS, cross
from plans.centres.kennedy import Kennedy
from plans.centres.quantities import CentresComparison
from plans.centres.study import CentresStudy
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.scenes import scene
from tests.plans.test_transfer import FOUR_BAR, SINE, SIX_LINK, SLIDER_CRANK, SLOTTED, TANGENT, study_of

RAM = {
    "frame": "O = [0, 0]; C = [0.3, 0.1]",
    "links": "OA AB B",
    "lengths": "OA = 0.1; AB = 0.3",
    "slides": ["link = 3; along = { through = [0, 0], angle = 0 }"],
    "sketch": "A = [0.05, 0.09]",
}
MECHANISMS = {
    "four-bar": FOUR_BAR, "slider-crank": SLIDER_CRANK, "slotted link": SLOTTED, "sine": SINE, "tangent": TANGENT,
    "six-link": SIX_LINK,
}  # fmt: skip
ANGLES = (17.0, 29.3, 41.0)


def asked(name: str) -> Study:
    return study_of(MECHANISMS[name], *ANGLES, head='sheets = ["centres"]')


def test_the_centre_of_a_rod_lies_where_it_was_worked():
    found = study_of(FOUR_BAR, 60, head='sheets = ["centres"]').of(CentresStudy).at(0)
    assert found.found[0, 2].place == pytest.approx(0.4563219069 + 0.7903727274j, rel=1e-9)


@pytest.mark.parametrize("name", MECHANISMS)
def test_both_roads_find_all_centres_and_the_rates_by_them_are_those_of_the_plans(name):
    study = asked(name)
    compared, linkage = study.of(CentresComparison), study.of(CentresStudy).linkage
    assert compared.agrees
    links = len(linkage.mechanism.links)
    assert len(study.of(CentresStudy).at(0).found) == links * (links - 1) / 2
    plans = {row.name: row for row in compared.plans.findings}
    kappa = max(1 / sharpness for k in range(len(ANGLES)) for sharpness in sharpnesses(study.of(CentresStudy).at(k)))
    for row in compared.findings:
        if row.unit == "rad/s":
            off = np.abs(row.construction - plans[row.name].construction)
            assert off.max() <= 8 * EPS * kappa * plans[row.name].largest, row.name


def sharpnesses(found: Kennedy) -> list[float]:
    return [
        float(np.ravel(mark.sharpness)[0]) for mark in (*found.board, *found.plan.board) if mark.sharpness is not None
    ]


@pytest.mark.parametrize("name", MECHANISMS)
def test_three_links_have_their_centres_in_one_line(name):
    found = asked(name).of(CentresStudy).at(1)
    for three in combinations(sorted(found.plan.mechanism.links), 3):
        centres = [found.found[pair] for pair in combinations(three, 2)]
        places = [one.place for one in centres if not one.infinite]
        ways = [one.place for one in centres if one.infinite] if len(places) > 1 else []
        ways += [place - places[0] for place in places[1:] if abs(place - places[0]) > 1e-9]
        assert all(abs(cross(one, two)) < 1e-12 * abs(one) * abs(two) for one, two in combinations(ways, 2)), three


@pytest.mark.parametrize("name", MECHANISMS)
def test_each_centre_has_one_velocity_on_both_of_its_links(name):
    study = asked(name)
    linkage, motion = study.of(CentresStudy).linkage, study.of(CentresComparison).plans.construction

    def velocity(link: int, place: complex) -> complex:
        point = next(iter(linkage.mechanism.links[link].points))
        omega = motion.links[link].omega[1] if link else 0.0
        return complex(motion.points[point].v[1] + 1j * omega * (place - motion.points[point].r[1]))

    for (one, two), centre in study.of(CentresStudy).at(1).found.items():
        if centre.infinite:
            assert motion.links[two].omega[1] == pytest.approx(motion.links[one].omega[1] if one else 0.0, abs=1e-12)
        else:
            assert velocity(one, centre.place) == pytest.approx(velocity(two, centre.place), abs=1e-12)


def test_a_slide_that_drives_gives_the_rates_too():
    stroke = "link = 3; stroke = { from = 0.25, to = 0.35, speed = 0.2 }; positions = 4"
    compared = Study(parse_scene(scene('sheets = ["centres"]', **RAM, drive=stroke))).of(CentresComparison)
    assert compared.agrees and {"ω_1", "ω_2"} <= {
        row.name for row in compared.findings if np.abs(row.construction).max() > 0
    }


def test_what_lies_on_one_line_alone_is_left_open():
    """A crank in line with its rod: P_02 may be anywhere on that line for all that its centres tell."""
    flat = SLIDER_CRANK | {"slides": ["link = 3; along = { through = [0, 0], angle = 0 }"], "sketch": "B = [0.26, 0]"}
    found = study_of(flat, 0, 40, head='sheets = ["centres"]').of(CentresStudy)
    assert found.at(0).found[0, 2].place == pytest.approx(0.26)
    assert found.at(0).found[1, 3].place == pytest.approx(0.0)


def test_a_position_that_is_not_there_is_told():
    text = scene(
        'sheets = ["centres"]', **FOUR_BAR, drive="link = 1; speed = 1; positions = 4", centres="positions = [4]"
    )
    assert "a position from 0 to 3" in str(parse_scene(text).meaning.faults[0])


def test_a_drive_that_rests_has_its_centres_too_and_no_rates():
    drive = "link = 1; speed = 0; acceleration = 2; positions = [30, 70]"
    compared = Study(parse_scene(scene('sheets = ["centres"]', **FOUR_BAR, drive=drive))).of(CentresComparison)
    assert compared.agrees
    assert all(np.abs(one.analysis).max() == 0 for one in compared.findings if one.unit == "rad/s")
    assert np.isfinite(next(one for one in compared.findings if one.name == "P_02").analysis).all()
