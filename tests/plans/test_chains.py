"""Properties of any mechanism of class II: generated chains closed, differentiated, and compared with the analysis."""

from __future__ import annotations

from decimal import Decimal

import numpy as np
from hypothesis import given

from plans.linkage.plan import Plan
from plans.model.mechanism import FRAME, Way
from plans.model.motion import Complexes, Floats, Motion
from tests.parts import examples
from tests.plans.chains import Chain, allowed, chains, studied
from tests.plans.derivatives import REACH, derivative
from tests.plans.studies import study_of, value

NEARBY = (0, "0.5", -3, 40)  # degrees from the first position; some are out of reach


@examples(3)
@given(chains())
def test_the_sketch_leads_back_to_the_first_position(chain):
    motion = studied(chain).motion(0)
    assert not motion.gaps
    margin = allowed(chain, motion, 0)[0]
    for name, place in chain.places.items():
        assert abs(motion.points[name].r[0] - place) <= margin, name
    for link, turn in chain.turns.items():
        if link != FRAME:
            assert abs(np.exp(1j * motion.links[link].angle[0]) - turn) <= margin / 0.2, link


@examples(3)
@given(chains())
def test_the_joints_stay_closed(chain):
    """Lengths, hinges and sliding lines: every link has one image, at every position that is reached."""
    motion = studied(chain, NEARBY).motion(0)
    margin = allowed(chain, motion, 0)
    for number, link in chain.mechanism.links.items():
        ends = [(motion.points[name].r, local) for name, local in link.points.items()]
        for place, local in ends[1:]:
            turned = _turn(motion, number) * (local - ends[0][1])
            assert _within(place - ends[0][0] - turned, margin), number
    for slide in chain.mechanism.slides:
        (p, u), (q, w) = (_line(chain, motion, number, slide.way(number)) for number in (slide.slider, slide.owner))
        assert _within(u - w, margin / 0.2) and _within(np.imag((p - q) * np.conj(w)), 2 * margin), slide


def _turn(motion: Motion, link: int) -> Complexes:
    return np.ones(1, dtype=complex) if link == FRAME else np.exp(1j * motion.links[link].angle)


def _line(chain: Chain, motion: Motion, link: int, way: Way) -> tuple[Complexes, Complexes]:
    name, local = next(iter(chain.mechanism.links[link].points.items()))
    turn = _turn(motion, link)
    return motion.points[name].r + turn * (way.through - local), turn * way.direction


def _within(difference: Complexes | Floats, margin: Floats) -> bool:
    size = np.abs(difference)
    return bool(np.all(np.isnan(size) | (size <= margin)))


@examples(3)
@given(chains())
def test_every_link_is_similar_to_its_images(chain):
    """The image theorem: v_S = v_A + i omega AS and a_S = a_A + (i epsilon - omega^2) AS, whichever link S is of."""
    study = studied(chain)
    motion, drafts = study.motion(), study.drafts()
    for number, link in chain.mechanism.links.items():
        if number == FRAME:
            continue
        turn = motion.links[number]
        factors = (1j * turn.omega[0], 1j * turn.epsilon[0] - turn.omega[0] ** 2)
        for order, factor in enumerate(factors, 1):
            plan, margin = drafts.plan(order), allowed(chain, motion, order)[0]
            first, *others = (_images(plan, number, name, local) for name, local in link.points.items())
            base = motion.points[next(iter(link.points))].r[0]
            for name, (one, same) in zip(list(link.points)[1:], others, strict=True):
                assert abs(one - same) <= margin, (number, name)
                arm = motion.points[name].r[0] - base
                assert abs(one - first[0] - factor * arm) <= margin, (number, name)


def _images(plan: Plan, link: int, name: str, local: complex) -> tuple[complex, complex]:
    """Give the image of a point as it is named on the plan, and as a point of this link."""
    return value(plan.point(name).point), value(plan.place(link, local, f"{name}'").point)


@examples(3)
@given(chains())
def test_velocities_and_accelerations_are_the_derivatives(chain):
    drive = chain.mechanism.drive
    sweep = studied(chain).sweep
    phi = np.radians(chain.phi) + REACH
    study = study_of(chain.mechanism, positions=[Decimal(float(angle)) for angle in np.degrees(phi)])
    study.__dict__["sweep"] = sweep
    motion = study.motion()
    if motion.gaps:
        return  # a dead centre is as near as the step
    margins = [float(np.max(allowed(chain, motion, order))) for order in (0, 1)]
    for name, point in motion.points.items():
        _differentiated(drive.omega, drive.epsilon, (point.r, point.v, point.a), margins, name)
    for number, link in motion.links.items():
        turns = (np.unwrap(link.angle), link.omega, link.epsilon)
        _differentiated(drive.omega, drive.epsilon, turns, [margin / 0.2 for margin in margins], number)


def _differentiated(
    omega: float, epsilon: float, values: tuple[Floats | Complexes, ...], margins: list[float], name: object
) -> None:
    first, error = derivative(values[0], margins[0])
    assert abs(values[1][3] - omega * first) <= abs(omega) * error, name
    second, error = derivative(values[1], margins[1])
    assert abs(values[2][3] - omega * second - epsilon / omega * values[1][3]) <= abs(omega) * error, name
