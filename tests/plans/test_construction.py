"""The construction road: the worked values of the method descriptions, to all ten printed digits."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import degrees, radians, sqrt

import numpy as np
import pytest

from plans.linkage.margin import angle, rate
from plans.linkage.plan import Plan
from plans.linkage.pressure import interval, pressure
from plans.model.mechanism import Mechanism, Way
from tests.plans import linkages
from tests.plans.digits import printed
from tests.plans.studies import plans_at, shown, study_of, value


def crank_rocker() -> Mechanism:
    coupler = {"S": cmath.rect(0.22, radians(25))}
    return linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler=coupler)


SLIDER_CRANK = linkages.slider_crank(0.06, 0.20, 0.02)


def image(plan: Plan, point: str) -> complex:
    return value(plan.point(point).point)


def heading(plan: Plan, link: int) -> float:
    return degrees(value(angle(plan, link)).real)


def rates(plan: Plan, *links: int) -> tuple[float, ...]:
    return tuple(value(rate(plan, link)).real for link in links)


# Positions, M1.1


def test_four_bar_by_notches():
    plan = plans_at(crank_rocker(), 60)[0]
    assert printed(image(plan, "A"), image(plan, "B")) == (0.05 + 0.08660254038j, 0.3899961058 + 0.2973218988j)
    assert printed(heading(plan, 2), heading(plan, 3)) == (31.78938948, 82.33849477)
    assert printed(1 / value(plan.board["B"].sharpness)) == (1.29505253,)  # |dB/dl2|
    crossed = replace(crank_rocker(), sketch={"B": 0.2 - 0.3j})
    assert printed(image(plans_at(crossed, 60)[0], "B")) == (0.2253885096 - 0.2728955413j,)


# Pressure and transmission angles, M1.3 and M1.6


def test_pressure_angle_of_the_crank_rocker():
    study = study_of(crank_rocker(), 60)
    at_sixty = pressure(study.drafts().positions, study.groups[0])[0]
    assert printed(np.degrees(at_sixty), np.degrees(np.pi / 2 - at_sixty)) == (39.45089471, 50.54910529)
    found = interval(study.sweep, study.groups[0])
    assert printed(np.degrees(found.low), np.degrees(found.high)) == (11.41515774, 51.37516713)
    assert np.cos([found.at_low, found.at_high]) == pytest.approx([-1, 1])


def test_pressure_angle_of_the_slider_crank():
    study = study_of(SLIDER_CRANK, 60)
    assert printed(np.degrees(pressure(study.drafts().positions, study.groups[0])[0])) == (-9.195730045,)
    found = interval(study.sweep, study.groups[0])
    assert printed(np.degrees(found.low), np.degrees(found.high)) == (-11.53695903, 23.57817848)


# Plans of velocities and accelerations, M3.2 to M3.6


def test_four_bar_velocities():
    plan = plans_at(crank_rocker(), 60)[1]
    assert printed(*(shown(plan, name) for name in "ab")) == (-0.8660254038 + 0.5j, -0.6067243978 + 0.08161730877j)
    assert printed(abs(shown(plan, "pb")), abs(shown(plan, "ab"))) == (0.6121894151, 0.4922205685)
    assert printed(*rates(plan, 2, 3)) == (-1.230551421, 2.040631384)
    assert printed(*(shown(plan, name) * -1j for name in "ab")) == (0.5 + 0.8660254038j, 0.08161730877 + 0.6067243978j)


def test_four_bar_accelerations():
    plan = plans_at(crank_rocker(), 60)[2]
    assert printed(*(shown(plan, name) for name in ("a", "n_BA", "n_B", "b"))) == (
        -5.433012702 - 8.410254038j,
        -5.947854117 - 8.729337259j,
        -0.1665508417 - 1.238100847j,
        -11.53882903 + 0.2917119375j,
    )
    assert printed(abs(shown(plan, "πb")), *rates(plan, 2, 3)) == (11.54251581, 26.53280153, 38.24904333)


def test_four_bar_image_of_a_third_point():
    """M3.9: the figure of the coupler on every plan is similar to the coupler."""
    found = [image(plan, "S") for plan in plans_at(crank_rocker(), 60)]
    assert printed(*found) == (
        0.1704979981 + 0.2706683777j,
        -0.6395229261 + 0.3517210172j,
        -10.49925994 - 5.491827515j,
    )


def test_four_bar_points_whose_image_is_the_pole():
    """M3.2: the instantaneous centre P and the acceleration pole Q of the coupler, by the image theorem in reverse."""
    positions, velocities, accelerations = plans_at(crank_rocker(), 60)
    turned = cmath.exp(1j * value(angle(positions, 2)).real)
    for plan, place, size in (
        (velocities, 0.4563219069 + 0.7903727274j, 1.0),
        (accelerations, 0.3542983727 - 0.1355299991j, 12.0),
    ):
        local = (place - image(positions, "A")) / turned
        assert printed(value(positions.place(2, local, "P").point)) == (place,)
        assert abs(value(plan.place(2, local, "P").point)) < 1e-9 * size


def test_slider_crank_plans():
    positions, velocities, accelerations = plans_at(SLIDER_CRANK, 60)
    assert printed(image(positions, "B")) == (0.2274296355 + 0.02j,)
    assert printed(shown(velocities, "a"), shown(velocities, "b")) == (-0.5196152423 + 0.3j, -0.5681816961)
    assert printed(abs(shown(velocities, "ab")), *rates(velocities, 2)) == (0.3039057427, -1.519528713)
    assert printed(*(shown(accelerations, name) for name in ("a", "n_BA", "b"))) == (
        -3.259807621 - 5.046152423j,
        -3.715666235 - 4.972354302j,
        -2.91070085,
    )
    assert printed(*rates(accelerations, 2)) == (25.18545045,)
    assert printed(shown(velocities, "b") * -1j) == (0.5681816961j,)


def test_slotted_link_plans():
    positions, velocities, accelerations = plans_at(linkages.slotted_link(0.12, 0.35, 0.70), 60)
    assert printed(heading(positions, 3), abs(shown(positions, "CA"))) == (82.47023729, 0.4578713072)
    assert printed(shown(velocities, "a"), shown(velocities, "a3"), shown(velocities, "aa3")) == (
        -1.039230485 + 0.6j,
        -1.09933176 + 0.1453107654j,
        -0.06010127525 - 0.4546892346j,
    )
    assert printed(abs(shown(velocities, "aa3")), *rates(velocities, 2, 3)) == (0.4586441577, 2.421846089, 2.421846089)
    assert printed(*(shown(accelerations, name) for name in ("a", "a^k_A", "n_A3", "a3"))) == (
        -6.519615242 - 10.09230485j,
        2.20237469 - 0.2911120769j,
        -0.3519203088 - 2.662412323j,
        -3.246103845 - 2.279856265j,
    )
    along = shown(accelerations, "a3") - shown(accelerations, "k_A")
    assert printed(abs(shown(accelerations, "a^k_A")), abs(along)) == (2.221531119, 8.174046071)
    assert printed(*rates(accelerations, 2, 3)) == (6.375934305, 6.375934305)


def test_scotch_yoke_plans():
    positions, velocities, accelerations = plans_at(linkages.scotch_yoke(0.1), 60)
    assert printed(image(positions, "D")) == (0.08660254038j,)
    assert printed(image(velocities, "D"), abs(shown(velocities, "aa3"))) == (0.5j, 0.8660254038)
    along = shown(accelerations, "a3") - shown(accelerations, "a")
    assert printed(image(accelerations, "D"), abs(along)) == (-8.410254038j, 5.433012702)
    assert rates(velocities, 2, 3) == rates(accelerations, 2, 3) == (0, 0)
    assert not any(mark.name.startswith("k") for mark in accelerations.board)  # the slot does not turn: no Coriolis


def test_tangent_mechanism_plans():
    positions, velocities, accelerations = plans_at(linkages.tangent_mechanism(0.15), 20)
    assert printed(image(positions, "A")) == (0.15 + 0.05459553514j,)
    assert printed(shown(velocities, "a1"), shown(velocities, "a")) == (-0.1091910703 + 0.3j, 0.3397422994j)
    assert printed(abs(shown(velocities, "a1a"))) == (0.1161987099,)
    assert printed(*(shown(accelerations, name) for name in ("a1", "a^k_A", "a"))) == (
        -0.4362133946 - 0.6683821406j,
        -0.1589691977 + 0.4367642811j,
        -0.01498911189j,
    )
    assert printed(*rates(velocities, 1, 2, 3), *rates(accelerations, 1, 2, 3)) == (2, 2, 0, -3, -3, 0)


# The six-link shaper, M3.8


def shaper() -> Mechanism:
    """The ram's guide halves the height of the arc that B describes: y_D = 0.3287856445 m when printed."""
    mechanism = linkages.shaper()
    slot, guide = mechanism.slides
    middle = 0.35 * sqrt(1 - (0.12 / 0.35) ** 2)
    return replace(mechanism, slides=(slot, guide._replace(on_owner=Way(middle * 1j, 1 + 0j))))


def test_six_link_shaper_positions_and_velocities():
    positions, velocities, _ = plans_at(shaper(), 60)
    assert printed(*(image(positions, name) for name in "ABD")) == (
        0.06 + 0.1039230485j,
        0.09172883154 + 0.3439638474j,
        0.2911520553 + 0.3287856445j,
    )
    assert printed(abs(shown(positions, "CA"))) == (0.4578713072,)
    assert printed(*(shown(velocities, name) for name in ("a", "a3", "aa3", "b", "d"))) == (
        -1.039230485 + 0.6j,
        -1.09933176 + 0.1453107654j,
        -0.06010127525 - 0.4546892346j,
        -1.68067363 + 0.2221531119j,
        -1.697581816,
    )
    assert printed(*rates(velocities, 3, 4)) == (2.421846089, -1.113978141)


def test_six_link_shaper_accelerations():
    plan = plans_at(shaper(), 60)[2]
    assert printed(*(shown(plan, name) for name in ("a", "a^k_A", "k_A", "n_A3", "a3", "b", "n_DB", "d"))) == (
        -6.519615242 - 10.09230485j,
        2.20237469 - 0.2911120769j,
        -4.317240553 - 10.38341692j,
        -0.3519203088 - 2.662412323j,
        -3.246103845 - 2.279856265j,
        -4.962688547 - 3.485475855j,
        -5.210162257 - 3.466640505j,
        -4.946314486,
    )
    assert printed(*rates(plan, 3, 4)) == (6.375934305, 17.383334)
    assert printed(image(plan, "S3"), image(plan, "S4")) == (-2.481344273 - 1.742737927j, -4.954501516 - 1.742737927j)
