"""Random chains of dyads: closed joints, images, derivatives; turned, mirrored, enlarged, faster, or told otherwise."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import replace
from decimal import Decimal
from math import radians

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from plans.linkage.plan import Plan
from plans.model.decomposition import decompose
from plans.model.dyad import formula
from plans.model.mechanism import FRAME, Way
from plans.model.motion import Complexes, Floats, Motion
from tests.parts import examples
from tests.plans import alterations
from tests.plans.alterations import Map, renamed
from tests.plans.chains import Chain, allowed, chains, numbers, studied
from tests.plans.derivatives import REACH, derivative
from tests.plans.studies import driven, study_of, value

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


SHORTEST = 0.2  # m: by what a place of the margin turns a link at the most


def moved(chain: Chain, phi: float, frame: Map, own: Map | None = None) -> Chain:
    """Map the frame and the sketch, and where `own` says so, every link in its own frame."""
    return replace(chain, mechanism=alterations.moved(chain.mechanism, frame, own), phi=phi)


def same(value: complex) -> complex:
    return value


def alike(
    chain: Chain,
    other: Chain,
    vector: Callable[[complex], complex] = same,
    turn: Callable[[float, int], float] = lambda value, _: value,
    names: Callable[[object], object] = lambda name: name,
) -> None:
    """See that vectors and turns, of each order, are those of before but for rounding, mapped and named anew."""
    first, again = studied(chain).motion(), studied(other).motion()
    for order in range(3):
        margin = 2 * allowed(chain, first, order)[0]
        for name, point in first.points.items():
            assert abs(again.points[names(name)][order][0] - vector(point[order][0])) <= margin, (name, order)
        for link, turns in first.links.items():
            apart = again.links[names(link)][order][0] - turn(turns[order][0], order)
            assert abs(apart if order else cmath.phase(cmath.exp(1j * apart))) <= margin / SHORTEST, (link, order)


def to_the_bit(first: Motion, again: Motion, times: Callable[[int], float] = lambda _: 1.0, turns: bool = True) -> None:
    """See that vectors are those of before, so many times as large, and turns are, with no rounding between."""
    for name, point in first.points.items():
        for order, row in enumerate(point):
            assert np.array_equal(times(order) * row, again.points[name][order], equal_nan=True), (name, order)
    for link, rows in first.links.items() if turns else ():
        for row, other in zip(rows, again.links[link], strict=True):
            assert np.array_equal(row, other, equal_nan=True), link


@examples(3)
@given(chains(), numbers(-180, 180))
def test_everything_turned(chain: Chain, degrees: float) -> None:
    unit = cmath.exp(1j * radians(degrees))
    again = moved(chain, chain.phi + degrees, lambda place: place * unit)
    alike(chain, again, lambda one: one * unit, lambda one, order: one + (0 if order else radians(degrees)))


@examples(3)
@given(chains())
def test_everything_mirrored(chain: Chain) -> None:
    """A mirrored mechanism with a crank of the other sense is drawn as the mirror image of every plan."""
    drive = chain.mechanism.drive
    image = moved(chain, -chain.phi, complex.conjugate, complex.conjugate)
    image = replace(image, mechanism=driven(image.mechanism, -drive.omega, -drive.epsilon))
    alike(chain, image, lambda one: complex(one).conjugate(), lambda one, _: -one)


@examples(2)
@given(chains(), st.sampled_from((2.0**-60, 2.0**-1, 2.0**60)))
def test_everything_enlarged_by_a_power_of_two_is_the_same_to_the_bit(chain: Chain, times: float) -> None:
    large = moved(chain, chain.phi, lambda z: times * z, lambda z: times * z)
    to_the_bit(studied(chain, (0, 3)).motion(), studied(large, (0, 3)).motion(), lambda _: times)


@examples(3)
@given(chains(), st.sampled_from((2, -1)))
def test_a_faster_crank_stretches_the_plans(chain: Chain, times: int) -> None:
    """The crank n times as fast makes velocities n times, accelerations n^2 times as large; 2 and -1 round nothing."""
    drive = chain.mechanism.drive
    fast = replace(chain, mechanism=driven(chain.mechanism, times * drive.omega, times**2 * drive.epsilon))
    to_the_bit(studied(chain).motion(), studied(fast).motion(), lambda order: times**order, turns=False)


@examples(3)
@given(chains(), st.randoms(use_true_random=False))
def test_other_names_and_numbers_change_nothing(chain, chance):
    names, links = list(chain.places), [number for number in chain.mechanism.links if number != FRAME]
    points = dict(zip(names, chance.sample(names, len(names)), strict=True))
    figures = {FRAME: FRAME} | dict(zip(links, chance.sample(links, len(links)), strict=True))
    again = replace(chain, mechanism=renamed(chain.mechanism, points, figures))
    alike(chain, again, names=lambda name: points[name] if isinstance(name, str) else figures[name])


@examples(3)
@given(chains(), st.randoms(use_true_random=False))
def test_the_order_of_the_tables_changes_no_bit(chain, chance):
    old = chain.mechanism
    links = {n: old.links[n] for n in chance.sample(list(old.links), len(old.links))}
    slides = tuple(chance.sample(old.slides, len(old.slides)))
    sketch = {name: old.sketch[name] for name in chance.sample(list(old.sketch), len(old.sketch))}
    again = replace(chain, mechanism=replace(old, links=links, slides=slides, sketch=sketch))
    assert formula(old, decompose(old)) == formula(again.mechanism, decompose(again.mechanism))
    to_the_bit(studied(chain).motion(), studied(again).motion(), turns=False)
