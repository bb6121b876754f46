"""Meetings of lines and arcs: their true errors against 60 digits, their gaps, dead centres and sides.

An error is judged by c = |error| / (u (sum |dP/dx_i| |x_i| + |P|)): forward error over the least that the rounding of
the data themselves would do. Near a dead centre that least is large and no formula helps; elsewhere c tells a careful
formula from a careless one.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import mpmath
import numpy as np
import pytest

from geometry import meet
from geometry.board import Board
from geometry.meet import EPS, Meeting, arc_arc, cross, dot, line_arc, line_line, tangent_direction
from tests import parts

U = EPS / 2
pytestmark = pytest.mark.part
CASES = 120 if parts.whole else 40
# A thousand positions are found with c up to 1 in nearly all families; what exceeds it does so by its own last
# rotation, three roundings, where the data themselves bring hardly more: short links 1.5, slots 2.6. Of two lines that
# cross at a wide angle 1.5, by the quotient and the last product; at a small one 0.5.
SHORT_LINK, SLOT, LINE = 1.6, 3.0, 1.6
# Arcs that touch from inside are found with 0.64 where the difference of the radii keeps what its rounding lost, and
# with 0.96 where it does not.
INSIDE = 0.7
TINY, HUGE = 2.0**-30, 2.0**30  # 1e-9 and 1e+9, and exact
MP = mpmath.mp.clone()
MP.dps = 90
STEP = MP.mpf(10) ** -40  # of a datum: slopes are known to some forty digits

Data = tuple[Any, ...]  # complex numbers and lengths
Solve = Callable[..., tuple[Any, ...]]  # data of many digits, and a side, to the vectors that are judged
Lot = random.Random


def share(found: Any, solve: Solve, data: Data, side: int, told: int = 0) -> float:
    """Give c of a vector found in doubles: slopes by central differences, by every real number of the data."""
    exact = [MP.mpmathify(one) for one in data]
    point, blamed = solve(*exact, side)[told], MP.mpf(0)
    for k, one in enumerate(data):
        for part in (one.real, 1j * one.imag) if isinstance(one, complex) else (one,):
            ahead, behind = ([*exact[:k], exact[k] + sign * part * STEP, *exact[k + 1 :]] for sign in (1, -1))
            blamed += abs(solve(*ahead, side)[told] - solve(*behind, side)[told]) / (2 * STEP)
    return float(abs(MP.mpc(complex(found)) - point) / (U * (blamed + abs(point))))


# The school's formulas


def arcs_in_digits(base: Any, first: Any, second: Any, side: int) -> tuple[Any, ...]:
    apart = abs(base)
    along = (apart**2 + first**2 - second**2) / (2 * apart)
    point = base / apart * MP.mpc(along, side * MP.sqrt(first**2 - along**2))
    return point, point - base


def line_and_arc_in_digits(base: Any, unit: Any, radius: Any, side: int) -> tuple[Any, ...]:
    unit = unit / abs(unit)
    foot = unit * (MP.conj(unit) * base).real
    point = foot + side * unit * MP.sqrt(radius**2 - abs(base - foot) ** 2)
    return point, point - base


def lines_in_digits(base: Any, first: Any, second: Any, _: int) -> tuple[Any, ...]:
    point = first * (MP.conj(base) * second).imag / (MP.conj(first) * second).imag
    return point, point - base


def slot_in_digits(base: Any, offset: Any, side: int) -> tuple[Any, ...]:
    return (base / MP.mpc(side * MP.sqrt(abs(base) ** 2 - offset**2), offset),)


# Families of data, by a measure


def turned(size: float, lot: Lot) -> complex:
    return cmath.rect(size, lot.uniform(-math.pi, math.pi))


def triangle(lot: Lot, length: float) -> Data:
    """Take two radii and the angle between them, which keeps every meeting away from its dead centres."""
    first, second = length * lot.uniform(0.2, 2), length * lot.uniform(0.2, 2)
    apart = first - cmath.rect(second, lot.uniform(0.3, math.pi - 0.3))
    return turned(abs(apart), lot), first, second


def outside(lot: Lot, gap: float) -> Data:
    """Two arcs that touch from outside but for a share of their radii (внешнее касание)."""
    first, second = lot.uniform(0.2, 2), lot.uniform(0.2, 2)
    return turned((first + second) * (1 - gap), lot), first, second


def inside(lot: Lot, gap: float) -> Data:
    """Two arcs, one of which touches the other from inside but for a share of their radii (внутреннее касание)."""
    first = lot.uniform(0.2, 2)
    second = first * lot.uniform(1.2, 3)
    return turned((second - first) * (1 + gap), lot), first, second


def needle(lot: Lot, ratio: float) -> Data:
    """Two long rods on a short base: a needle triangle."""
    base = lot.uniform(0.5, 2)
    first = base * ratio * lot.uniform(0.5, 2)
    return turned(base, lot), first, first + base * lot.uniform(-0.9, 0.9)


def short_link(lot: Lot, ratio: float) -> Data:
    """One link far shorter than the other and the base."""
    base = lot.uniform(0.5, 2)
    second = base * ratio * lot.uniform(0.5, 2)
    return turned(base, lot), base + second * lot.uniform(-0.9, 0.9), second


def right(lot: Lot, _: float) -> Data:
    """A right angle at the meeting, or at one of the centres."""
    legs = lot.uniform(0.2, 2), lot.uniform(0.2, 2)
    base, first, second = lot.choice([(math.hypot(*legs), *legs), (legs[0], math.hypot(*legs), legs[1])])
    return turned(base, lot), first, second


def isosceles(lot: Lot, _: float) -> Data:
    """Two equal radii, or a radius equal to the base."""
    base, equal = lot.uniform(0.2, 1), lot.uniform(0.6, 2)
    return lot.choice([(turned(base, lot), equal, equal), (equal + 0j, equal, base), (equal * 1j, base, equal)])


def slider(lot: Lot, measure: float) -> Data:
    """A guide at an ordinary distance from the centre."""
    unit, radius = turned(1.0, lot), measure * lot.uniform(0.5, 2)
    height = radius * lot.uniform(-0.9, 0.9)
    return unit * complex(measure * lot.uniform(-3, 3), -height), unit, radius


def grazing(lot: Lot, gap: float) -> Data:
    """A guide that touches the arc but for a share of its radius."""
    unit, radius = turned(1.0, lot), lot.uniform(0.5, 2)
    return unit * complex(lot.uniform(-3, 3), lot.choice([-1, 1]) * radius * (1 - gap)), unit, radius


def far_along(lot: Lot, ratio: float) -> Data:
    """A guide named by a point far away along it."""
    base, unit, radius = slider(lot, 1.0)
    return base + ratio * unit, unit, radius


def central(lot: Lot, _: float) -> Data:
    """A guide through the centre of the arc."""
    unit = turned(1.0, lot)
    return 2 * unit, unit, 1.5


def crossing(lot: Lot, angle: float, measure: float = 1.0) -> Data:
    """Two lines that cross at an angle, any where it is 0."""
    first = turned(lot.uniform(0.1, 10), lot)
    second = first * cmath.rect(lot.uniform(0.1, 10), angle or lot.uniform(0.3, 2.8))
    return turned(measure * lot.uniform(0.1, 3), lot), first, second


def slot(lot: Lot, gap: float, measure: float = 1.0) -> Data:
    """A slot whose pin is as far from its pivot as its offset but for a share; of 0 at any offset, of 1 at none."""
    base = turned(measure * lot.uniform(0.5, 2), lot)
    return base, abs(base) * (lot.choice([-1, 1]) * (1 - gap) if gap else lot.uniform(-0.9, 0.9))


class Kind(NamedTuple):
    """How two loci meet in doubles and in many digits, and how many roundings are borne."""

    meet: Callable[..., Meeting]
    solve: Solve
    allowed: float = 1.0


ARCS, LINE_AND_ARC = Kind(arc_arc, arcs_in_digits), Kind(line_arc, line_and_arc_in_digits)
LINES = Kind(lambda *data: line_line(*data[:-1]), lines_in_digits, LINE)
SLOTS = Kind(tangent_direction, slot_in_digits, SLOT)
NEAR = (1e-4, 1e-8, 1e-12)
FAMILIES: list[tuple[Kind, Callable[..., Data], tuple[float, ...]]] = [
    *((ARCS, triangle, (size,)) for size in (1.0, TINY, HUGE)),
    *((ARCS, outside, (gap,)) for gap in NEAR),
    *((ARCS._replace(allowed=INSIDE), inside, (gap,)) for gap in NEAR),
    *((ARCS, needle, (ratio,)) for ratio in (1e4, 1e8)),
    *((ARCS._replace(allowed=SHORT_LINK), short_link, (ratio,)) for ratio in (1e-4, 1e-8)),
    *((ARCS, family, (0.0,)) for family in (right, isosceles)),
    *((LINE_AND_ARC, slider, (size,)) for size in (1.0, TINY, HUGE)),
    *((LINE_AND_ARC, grazing, (gap,)) for gap in NEAR),
    *((LINE_AND_ARC, family, (1e6,)) for family in (central, far_along)),
    *((LINES, crossing, (angle,)) for angle in (0.0, *NEAR)),
    *((LINES, crossing, (0.0, size)) for size in (TINY, HUGE)),
    *((SLOTS, slot, (gap, size)) for gap in (0.0, 1.0, *NEAR) for size in (TINY, 1.0, HUGE)),
]


def cases(family: Callable[..., Data], *measure: float) -> Iterator[tuple[Data, int]]:
    lot = Lot(family.__name__)
    for k in range(CASES):
        yield family(lot, *measure), 1 if k % 2 else -1


@pytest.mark.parametrize(("kind", "family", "measure"), FAMILIES)
def test_loci_meet_as_exactly_as_their_data_allow(kind: Kind, family: Any, measure: tuple[float, ...]) -> None:
    for data, side in cases(family, *measure):
        met = kind.meet(*data, side)
        for told, vector in enumerate((met.first, met.second)[: 1 if kind is SLOTS else 2]):
            assert share(vector, kind.solve, data, side, told) <= kind.allowed, (data, side)


@pytest.mark.parametrize("ratio", [1e4, 1e8])
def test_long_rods_on_a_short_base_meet_to_the_last_digits(ratio: float) -> None:
    for data, _ in cases(needle, ratio):
        point = arcs_in_digits(*map(MP.mpmathify, data), 1)[0]
        assert abs(complex(arc_arc(*data, +1).first) - point) <= 8 * U * data[1]


@pytest.mark.parametrize("kind", [ARCS, LINES], ids=["arcs", "lines"])
def test_far_from_the_origin_only_what_the_coordinates_lost_is_lost(kind: Kind) -> None:
    lot = Lot("offset 1e8")
    for _ in range(CASES):
        base, first, second = triangle(lot, 1.0) if kind is ARCS else crossing(lot, 0.0)
        start, board = turned(1e8, lot), Board("positions")
        end = start + base
        a, c = board.given("A", start), board.given("C", end)
        if kind is ARCS:
            loci = board.arc("a", a, first), board.arc("c", c, second)
        else:
            loci = board.parallel("a", a, board.given("e", first)), board.parallel("c", c, board.given("f", second))
        met = board.meet("B", *loci, +1)
        point = kind.solve(MP.mpc(end) - MP.mpc(start), MP.mpmathify(first), MP.mpmathify(second), 1)[0]
        assert abs(complex(met.point) - complex(point + MP.mpc(start))) <= 4 * U * 1e8
        assert abs(complex(met.rays[0][1]) - complex(point)) <= 64 * U * (abs(base) + abs(point) + abs(second))


def test_the_sharpness_of_two_arcs_is_the_sine_of_their_crossing_angle() -> None:
    for family, measure in ((triangle, 1.0), (right, 0.0), (needle, 1e8), (inside, 1e-4)):
        for data, side in cases(family, measure):
            first, second = arcs_in_digits(*map(MP.mpmathify, data), side)
            sine = abs((MP.conj(first) * second).imag) / (MP.mpf(data[1]) * data[2])
            assert float(arc_arc(*data, side).sharpness) == pytest.approx(float(sine), rel=1e-10, abs=0)


# Gaps, dead centres and sides


@pytest.mark.parametrize(
    ("met", "miss"),
    [
        (arc_arc(10 + 0j, 3.0, 4.0, +1), 3.0),  # too far apart
        (arc_arc(1j, 3.0, 8.0, +1), 4.0),  # the first inside the second
        (arc_arc(-1 + 0j, 8.0, 3.0, +1), 4.0),  # the second inside the first
        (arc_arc(3 + 4j, 1.0, 1.5, +1), 2.5),
        *((line_arc(base, 1 + 0j, 5.0, +1), 2.0) for base in (7j, -7j, 100 + 7j)),
    ],
)
def test_loci_that_do_not_reach_each_other_tell_by_how_much_they_miss(met: Meeting, miss: float) -> None:
    assert (float(met.miss), float(met.sharpness)) == (miss, 0)
    assert np.isnan(met.first) and np.isnan(met.second)


@pytest.mark.parametrize("side", [+1, -1])
@pytest.mark.parametrize(
    ("touch", "at"),
    [
        (lambda side: arc_arc(7 + 0j, 3.0, 4.0, side), 3 + 0j),
        (lambda side: arc_arc(1j, 3.0, 4.0, side), -3j),
        (lambda side: arc_arc(-1 + 0j, 4.0, 3.0, side), -4 + 0j),
        (lambda side: arc_arc(3 + 4j, 2.0, 3.0, side), 1.2 + 1.6j),
        (lambda side: line_arc(2 - 5j, 1 + 0j, 5.0, side), 2 + 0j),
        (lambda side: tangent_direction(3 + 4j, 5.0, side), (3 + 4j) / 5j),
    ],
)
def test_loci_that_touch_are_at_a_dead_centre(touch: Callable[[int], Meeting], at: complex, side: int) -> None:
    met = touch(side)
    assert (float(met.sharpness), float(met.miss)) == (0, 0)
    assert abs(complex(met.first) - at) <= 2 * EPS * abs(at)


def test_parallel_lines_have_no_meeting_and_no_sharpness_and_a_pin_on_its_pivot_no_direction() -> None:
    for first, second in ((1 + 0j, 3 + 0j), (1 + 2j, -2 - 4j), (0.1 + 0.3j, (0.1 + 0.3j) * 7)):
        met = line_line(1j, first, second)
        assert np.isnan(met.first)
        assert float(met.sharpness) == 0
    assert float(line_line(1j, 1 + 0j, 2j).sharpness) == 1
    assert np.isnan(tangent_direction(0j, 0.0, +1).first)
    far = tangent_direction(3 + 4j, 7.0, +1)  # of a pin that is too near for the offset
    assert float(far.miss) == 2 and np.isnan(far.first)


def test_the_pin_lies_its_offset_left_of_the_slot_and_ahead_or_behind() -> None:
    for side, offset in ((side, offset) for side in (+1, -1) for offset in (3.0, -3.0, 0.0)):
        met = tangent_direction(4 + 3j, offset, side)
        unit = complex(met.first)
        assert abs(unit) == pytest.approx(1, abs=4 * EPS)
        assert cross(unit, 4 + 3j) == pytest.approx(offset, abs=32 * EPS)
        assert np.sign(dot(unit, 4 + 3j)) == side
        assert complex(met.second) == pytest.approx(unit * dot(unit, 4 + 3j), abs=32 * EPS)
        assert float(met.sharpness) == pytest.approx(math.sqrt(25 - offset**2) / 5, abs=4 * EPS)


# Arrays


MANY: list[tuple[Kind, Callable[..., Data], tuple[float, ...], list[Data]]] = [
    (ARCS, triangle, (1.0,), [(9 + 0j, 1.0, 2.0, 1.0), (3 + 0j, 1.0, 2.0, -1.0)]),
    (LINE_AND_ARC, slider, (1.0,), [(9j, 1 + 0j, 1.0, 1.0), (1j, 1 + 0j, 1.0, 1.0)]),
    (LINES, crossing, (0.0,), [(1j, 1 + 0j, 2 + 0j, 1.0)]),
    (SLOTS, slot, (0.0,), [(1j, 2.0, 1.0), (1j, 1.0, 1.0)]),
]


@pytest.mark.parametrize(("kind", "family", "measure", "odd"), MANY)
def test_a_million_positions_are_met_as_one_is(kind: Kind, family: Any, measure: Any, odd: list[Data]) -> None:
    """And a gap or a dead centre among them leaves the others alone."""
    data = [*((*one, float(side)) for one, side in cases(family, *measure)), *odd]
    whole = kind.meet(*(np.array(column) for column in zip(*data, strict=True)))
    for k, case in enumerate(data):
        alone = kind.meet(*case)
        for told in ("first", "second", "sharpness", "miss"):
            one, many = getattr(alone, told), np.broadcast_to(getattr(whole, told), len(data))[k]
            assert np.shape(one) == ()
            # Vector units fuse a multiplication with an addition, so that the last bits may differ.
            assert one == pytest.approx(many, rel=1e-13, abs=1e-13 * max(map(abs, case)), nan_ok=True)


def test_the_moment_and_the_product_of_two_vectors() -> None:
    assert (meet.cross(1 + 2j, 3 + 4j), meet.dot(1 + 2j, 3 + 4j)) == (-2, 11)


def test_a_dead_centre_is_told_from_a_meeting_and_from_a_gap_by_a_few_roundings() -> None:
    width = 14 * EPS  # the perimeter of the triangle 3, 4, 7
    met = arc_arc(7 + np.array((-40, -2, 0, 2, 40)) * width + 0j, 3.0, 4.0, +1)
    assert list(np.asarray(met.sharpness) > 0) == [True, False, False, False, False]
    assert list(np.asarray(met.miss) > 0) == [False, False, False, False, True]
    assert list(np.isnan(met.first)) == [False, False, False, False, True]
