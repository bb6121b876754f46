"""Relations between a mechanism and the same one turned, mirrored, enlarged, driven faster, or described otherwise."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import radians

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from plans.model.dyad import decompose, formula
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, Motion
from tests.parts import examples
from tests.plans import alterations
from tests.plans.alterations import Map, renamed
from tests.plans.chains import Chain, allowed, chains, numbers, studied
from tests.plans.studies import driven

ORDERS = (0, 1, 2)


def vectors(motion: Motion, name: str) -> tuple[Complexes | None, ...]:
    point = motion.points[name]
    return point.r, point.v, point.a


def turns(motion: Motion, link: int) -> tuple[Floats | None, ...]:
    return motion.links[link].angle, motion.links[link].omega, motion.links[link].epsilon


def moved(chain: Chain, phi: float, frame: Map, own: Map | None = None) -> Chain:
    """Map the frame and the sketch, and where `own` says so, every link in its own frame."""
    return replace(chain, mechanism=alterations.moved(chain.mechanism, frame, own), phi=phi)


@examples(3)
@given(chains(), numbers(-180, 180))
def test_everything_turned(chain, degrees):
    turn = cmath.exp(1j * radians(degrees))
    first = studied(chain).motion()
    again = studied(moved(chain, chain.phi + degrees, lambda place: place * turn)).motion()
    for order in ORDERS:
        margin = 2 * allowed(chain, first, order)[0]
        for name in first.points:
            old, new = vectors(first, name)[order], vectors(again, name)[order]
            assert old is not None and new is not None
            assert abs(new[0] - old[0] * turn) <= margin, (name, order)
        for link in first.links:
            old, new = turns(first, link)[order], turns(again, link)[order]
            assert old is not None and new is not None
            apart = new[0] - old[0] - (radians(degrees) if order == 0 else 0)
            assert abs(cmath.phase(cmath.exp(1j * apart)) if order == 0 else apart) <= margin / 0.2, (link, order)


@examples(3)
@given(chains())
def test_everything_mirrored(chain):
    """A mirrored mechanism with a crank of the other sense is drawn as the mirror image of every plan."""
    drive = chain.mechanism.drive
    image = moved(chain, -chain.phi, complex.conjugate, complex.conjugate)
    image = replace(image, mechanism=driven(image.mechanism, -drive.omega, -drive.epsilon))
    first, again = studied(chain).motion(), studied(image).motion()
    for order in ORDERS:
        margin = 2 * allowed(chain, first, order)[0]
        for name in first.points:
            old, new = vectors(first, name)[order], vectors(again, name)[order]
            assert old is not None and new is not None
            assert abs(new[0] - old[0].conjugate()) <= margin, (name, order)
        for link in first.links:
            old, new = turns(first, link)[order], turns(again, link)[order]
            assert old is not None and new is not None
            apart = new[0] + old[0]
            assert abs(cmath.phase(cmath.exp(1j * apart)) if order == 0 else apart) <= margin / 0.2, (link, order)


@examples(2)
@given(chains(), st.sampled_from((2.0**-60, 2.0**-1, 2.0**60)))
def test_everything_enlarged_by_a_power_of_two_is_the_same_to_the_bit(chain, times):
    first = studied(chain, (0, 3)).motion()
    again = studied(moved(chain, chain.phi, lambda z: times * z, lambda z: times * z), (0, 3)).motion()
    for name in first.points:
        for old, new in zip(vectors(first, name), vectors(again, name), strict=True):
            assert old is not None and np.array_equal(times * old, new, equal_nan=True), name
    for link in first.links:
        for rate, same in zip(turns(first, link), turns(again, link), strict=True):
            assert np.array_equal(rate, same, equal_nan=True), link


@examples(3)
@given(chains(), st.sampled_from((2, -1)))
def test_a_faster_crank_stretches_the_plans(chain, times):
    """The crank n times as fast makes velocities n times, accelerations n^2 times as large; 2 and -1 round nothing."""
    drive = chain.mechanism.drive
    fast = replace(chain, mechanism=driven(chain.mechanism, times * drive.omega, times**2 * drive.epsilon))
    first, again = studied(chain).motion(), studied(fast).motion()
    for order in ORDERS:
        for name in first.points:
            old = vectors(first, name)[order]
            assert old is not None and np.array_equal(times**order * old, vectors(again, name)[order]), (name, order)


@examples(3)
@given(chains(), st.randoms(use_true_random=False))
def test_other_names_and_numbers_change_nothing(chain, chance):
    names, links = list(chain.places), [number for number in chain.mechanism.links if number != FRAME]
    points = dict(zip(names, chance.sample(names, len(names)), strict=True))
    numbers = {FRAME: FRAME} | dict(zip(links, chance.sample(links, len(links)), strict=True))
    again = studied(replace(chain, mechanism=renamed(chain.mechanism, points, numbers))).motion()
    first = studied(chain).motion()
    for order in ORDERS:
        margin = 2 * allowed(chain, first, order)[0]
        for name in names:
            old, new = vectors(first, name)[order], vectors(again, points[name])[order]
            assert old is not None and new is not None and abs(new[0] - old[0]) <= margin, (name, order)
        for link in links:
            old, new = turns(first, link)[order], turns(again, numbers[link])[order]
            assert old is not None and new is not None
            apart = cmath.phase(cmath.exp(1j * (new[0] - old[0]))) if order == 0 else new[0] - old[0]
            assert abs(apart) <= margin / 0.2, (link, order)


@examples(3)
@given(chains(), st.randoms(use_true_random=False))
def test_the_order_of_the_tables_changes_no_bit(chain, chance):
    old = chain.mechanism
    links = {n: old.links[n] for n in chance.sample(list(old.links), len(old.links))}
    slides = tuple(chance.sample(old.slides, len(old.slides)))
    sketch = {name: old.sketch[name] for name in chance.sample(list(old.sketch), len(old.sketch))}
    again = replace(chain, mechanism=replace(old, links=links, slides=slides, sketch=sketch))
    assert formula(old, decompose(old)) == formula(again.mechanism, decompose(again.mechanism))
    first, second = studied(chain).motion(), studied(again).motion()
    for name in first.points:
        for one, other in zip(vectors(first, name), vectors(second, name), strict=True):
            assert one is not None and np.array_equal(one, other), name
