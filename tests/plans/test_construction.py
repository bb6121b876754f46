"""The construction road: the worked values of the method descriptions, to all ten printed digits."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import radians, sqrt

import numpy as np

from plans.linkage.plan import Plan, rate
from plans.linkage.sweep import interval, pressure
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


def rates(plan: Plan, *links: int) -> tuple[float, ...]:
    return tuple(value(rate(plan, link)).real for link in links)


# Positions, M1.1


# Pressure and transmission angles, M1.3 and M1.6


def test_pressure_angle_of_the_crank_rocker():
    study = study_of(crank_rocker(), 60)
    at_sixty = pressure(study.drafts().positions, study.groups[0])[0]
    assert printed(np.degrees(at_sixty), np.degrees(np.pi / 2 - at_sixty)) == (39.45089471, 50.54910529)
    found = interval(study.sweep, study.groups[0])
    assert printed(np.degrees(found.low), np.degrees(found.high)) == (11.41515774, 51.37516713)


def test_pressure_angle_of_the_slider_crank():
    study = study_of(SLIDER_CRANK, 60)
    assert printed(np.degrees(pressure(study.drafts().positions, study.groups[0])[0])) == (-9.195730045,)
    found = interval(study.sweep, study.groups[0])
    assert printed(np.degrees(found.low), np.degrees(found.high)) == (-11.53695903, 23.57817848)


# Plans of velocities and accelerations, M3.2 to M3.6


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
