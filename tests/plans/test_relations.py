"""Relations between a mechanism and the same one turned, mirrored, enlarged, driven faster, or described otherwise."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import replace
from math import radians

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from plans.model.dyad import decompose, formula
from plans.model.mechanism import FRAME
from plans.model.motion import Motion
from tests.parts import examples
from tests.plans import alterations
from tests.plans.alterations import Map, renamed
from tests.plans.chains import Chain, allowed, chains, numbers, studied
from tests.plans.studies import driven

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
