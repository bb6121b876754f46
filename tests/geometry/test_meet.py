"""Meetings of lines and arcs: their true errors against 60 digits, their gaps, dead centres and sides.

An error is judged by c = |error| / (u (sum |dP/dx_i| |x_i| + |P|)): forward error over the least that the rounding of
the data themselves would do. Near a dead centre that least is large and no formula helps; elsewhere c tells a careful
formula from a careless one.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Iterator, Sequence
from typing import Any

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
# rotation, three roundings, where the data themselves bring hardly more: short links 1.5, slots 2.6.
SHORT_LINK, SLOT = 1.6, 3.0
# Arcs that touch from inside are found with 0.64 where the difference of the radii keeps what its rounding lost, and
# with 0.96 where it does not.
INSIDE = 0.7
TINY, HUGE = 2.0**-30, 2.0**30  # 1e-9 and 1e+9, and exact
MP = mpmath.mp.clone()
MP.dps = 60

Solution = tuple[Any, Any]
Data = tuple[float, ...]


def conditioned(point: Any, slopes: Sequence[Any], data: Sequence[float]) -> Any:
    """Give u (sum |dP/dx_i| |x_i| + |P|), the error that no formula can be blamed for."""
    return U * (MP.fsum(abs(s) * abs(x) for s, x in zip(slopes, data, strict=True)) + abs(point))


def share(found: Any, point: Any, slopes: Sequence[Any], data: Sequence[float]) -> float:
    """Give c of a point found in doubles."""
    return float(abs(MP.mpc(complex(found)) - point) / conditioned(point, slopes, data))


def real(a: Any, b: Any) -> Any:
    return (MP.conj(a) * b).real


def moved(rows: tuple[Any, Any], changes: Sequence[tuple[Any, Any]]) -> list[Any]:
    """Solve rows[k] . dP = change[k] for the change of a point with each of the data."""
    first, second = rows
    det = (MP.conj(first) * second).imag
    return [MP.mpc((a * second.imag - b * first.imag) / det, (b * first.real - a * second.real) / det)
            for a, b in changes]  # fmt: skip


# Two arcs


def arcs_in_digits(base: complex, first: float, second: float, side: int) -> Solution:
    """Meet two arcs by the school formula, and say how the meeting moves with base.x, base.y and the two radii."""
    b, r, q = MP.mpc(base), MP.mpf(first), MP.mpf(second)
    d = abs(b)
    along = (d * d + r * r - q * q) / (2 * d)
    point = b / d * MP.mpc(along, side * MP.sqrt(r * r - along * along))
    arm = point - b
    return point, moved((point, arm), [(0, arm.real), (0, arm.imag), (r, 0), (0, q)])


def turned(size: float, rng: random.Random) -> complex:
    return cmath.rect(size, rng.uniform(-math.pi, math.pi))


def triangle(rng: random.Random, length: float) -> tuple[complex, float, float]:
    """Take two radii and the angle between them, which keeps every meeting away from its dead centres."""
    first, second = length * rng.uniform(0.2, 2), length * rng.uniform(0.2, 2)
    apart = first - cmath.rect(second, rng.uniform(0.3, math.pi - 0.3))
    return turned(abs(apart), rng), first, second


def outside(rng: random.Random, gap: float) -> tuple[complex, float, float]:
    """Two arcs that touch from outside but for a share of their radii (внешнее касание)."""
    first, second = rng.uniform(0.2, 2), rng.uniform(0.2, 2)
    return turned((first + second) * (1 - gap), rng), first, second


def inside(rng: random.Random, gap: float) -> tuple[complex, float, float]:
    """Two arcs, one of which touches the other from inside but for a share of their radii (внутреннее касание)."""
    first = rng.uniform(0.2, 2)
    second = first * rng.uniform(1.2, 3)
    return turned((second - first) * (1 + gap), rng), first, second


def needle(rng: random.Random, ratio: float) -> tuple[complex, float, float]:
    """Two long rods on a short base: a needle triangle."""
    base = rng.uniform(0.5, 2)
    first = base * ratio * rng.uniform(0.5, 2)
    return turned(base, rng), first, first + base * rng.uniform(-0.9, 0.9)


def short_link(rng: random.Random, ratio: float) -> tuple[complex, float, float]:
    """One link far shorter than the other and the base."""
    base = rng.uniform(0.5, 2)
    second = base * ratio * rng.uniform(0.5, 2)
    return turned(base, rng), base + second * rng.uniform(-0.9, 0.9), second


def right(rng: random.Random, _: float) -> tuple[complex, float, float]:
    """A right angle at the meeting, or at one of the centres."""
    legs = rng.uniform(0.2, 2), rng.uniform(0.2, 2)
    base, first, second = rng.choice([(math.hypot(*legs), *legs), (legs[0], math.hypot(*legs), legs[1])])
    return turned(base, rng), first, second


def isosceles(rng: random.Random, _: float) -> tuple[complex, float, float]:
    """Two equal radii, or a radius equal to the base."""
    base, equal = rng.uniform(0.2, 1), rng.uniform(0.6, 2)
    return rng.choice([(turned(base, rng), equal, equal), (equal + 0j, equal, base), (equal * 1j, base, equal)])


FAMILIES: dict[str, tuple[Callable[[random.Random, float], tuple[complex, float, float]], float]] = {
    "generic": (triangle, 1.0),
    "external tangency 1e-4": (outside, 1e-4),
    "external tangency 1e-8": (outside, 1e-8),
    "external tangency 1e-12": (outside, 1e-12),
    "internal tangency 1e-4": (inside, 1e-4),
    "internal tangency 1e-8": (inside, 1e-8),
    "internal tangency 1e-12": (inside, 1e-12),
    "long rods on a base 1e-4 of them": (needle, 1e4),
    "long rods on a base 1e-8 of them": (needle, 1e8),
    "short link 1e-4": (short_link, 1e-4),
    "short link 1e-8": (short_link, 1e-8),
    "right angle": (right, 0.0),
    "isosceles": (isosceles, 0.0),
    "lengths of 1e-9": (triangle, TINY),
    "lengths of 1e+9": (triangle, HUGE),
}


def cases(family: str) -> Iterator[tuple[complex, float, float, int]]:
    take, measure = FAMILIES[family]
    rng = random.Random(take.__name__)
    for k in range(CASES):
        yield *take(rng, measure), 1 if k % 2 else -1


@pytest.mark.parametrize("family", FAMILIES)
def test_two_arcs_meet_as_exactly_as_their_data_allow(family: str) -> None:
    allowed = SHORT_LINK if family.startswith("short link") else INSIDE if family.startswith("internal") else 1
    for base, first, second, side in cases(family):
        met = arc_arc(base, first, second, side)
        point, slopes = arcs_in_digits(base, first, second, side)
        data = (base.real, base.imag, first, second)
        assert share(met.first, point, slopes, data) <= allowed
        from_second = [slopes[0] - 1, slopes[1] - MP.j, *slopes[2:]]
        assert share(met.second, point - MP.mpc(base), from_second, data) <= allowed


@pytest.mark.parametrize("ratio", [1e4, 1e8])
def test_long_rods_on_a_short_base_meet_to_the_last_digits(ratio: float) -> None:
    rng = random.Random(7)
    for _ in range(CASES):
        base, first, second = needle(rng, ratio)
        point, _ = arcs_in_digits(base, first, second, +1)
        assert abs(complex(arc_arc(base, first, second, +1).first) - point) <= 8 * U * first


def test_centres_far_from_the_origin_lose_only_what_their_coordinates_lost() -> None:
    rng = random.Random("offset 1e8")
    for _ in range(CASES):
        base, first, second = triangle(rng, 1.0)
        start = turned(1e8, rng)
        end = start + base
        board = Board("positions")
        a, c = board.given("A", start), board.given("C", end)
        b = board.meet("B", board.arc("AB", a, first), board.arc("CB", c, second), +1)
        exact_base = MP.mpc(end) - MP.mpc(start)
        point, (by_x, by_y, by_first, by_second) = arcs_in_digits(exact_base, first, second, +1)
        data = (start.real, start.imag, end.real, end.imag, first, second)
        slopes = (1 - by_x, MP.j - by_y, by_x, by_y, by_first, by_second)
        assert share(b.point, point + MP.mpc(start), slopes, data) <= 1
        (_, ray), _ = b.rays
        assert abs(complex(ray) - complex(point)) <= 64 * U * (first + second)


def test_the_sharpness_of_two_arcs_is_the_sine_of_their_crossing_angle() -> None:
    for family in ("generic", "right angle", "long rods on a base 1e-8 of them", "internal tangency 1e-4"):
        for base, first, second, side in cases(family):
            point, _ = arcs_in_digits(base, first, second, side)
            sine = abs((MP.conj(point) * (point - MP.mpc(base))).imag) / (MP.mpf(first) * second)
            assert float(arc_arc(base, first, second, side).sharpness) == pytest.approx(float(sine), rel=1e-10, abs=0)


@pytest.mark.parametrize(
    ("base", "first", "second", "miss"),
    [(10 + 0j, 3.0, 4.0, 3.0), (1j, 3.0, 8.0, 4.0), (-1 + 0j, 8.0, 3.0, 4.0), (3 + 4j, 1.0, 1.5, 2.5)],
    ids=["too far apart", "first inside second", "second inside first", "slanted"],
)
def test_arcs_that_do_not_reach_each_other_tell_by_how_much_they_miss(
    base: complex, first: float, second: float, miss: float
) -> None:
    met = arc_arc(base, first, second, +1)
    assert float(met.miss) == miss
    assert np.isnan(met.first)
    assert np.isnan(met.second)
    assert float(met.sharpness) == 0


@pytest.mark.parametrize(
    ("base", "first", "second", "at"),
    [(7 + 0j, 3.0, 4.0, 3 + 0j), (1j, 3.0, 4.0, -3j), (-1 + 0j, 4.0, 3.0, -4 + 0j), (3 + 4j, 2.0, 3.0, 1.2 + 1.6j)],
)
@pytest.mark.parametrize("side", [+1, -1])
def test_arcs_that_touch_are_at_a_dead_centre(
    base: complex, first: float, second: float, at: complex, side: int
) -> None:
    met = arc_arc(base, first, second, side)
    assert (float(met.sharpness), float(met.miss)) == (0, 0)
    assert abs(complex(met.first) - at) <= 2 * EPS * abs(at)


def test_a_dead_centre_is_told_from_a_meeting_and_from_a_gap_by_a_few_roundings() -> None:
    width = 14 * EPS  # the perimeter of the triangle 3, 4, 7
    shares = (-40, -2, 0, 2, 40)
    met = arc_arc(7 + np.array(shares) * width + 0j, 3.0, 4.0, +1)
    assert list(np.asarray(met.sharpness) > 0) == [True, False, False, False, False]
    assert list(np.asarray(met.miss) > 0) == [False, False, False, False, True]
    assert list(np.isnan(met.first)) == [False, False, False, False, True]


def test_side_plus_one_lies_left_of_the_ray_from_the_first_centre_to_the_second() -> None:
    for base, first, second, side in cases("generic"):
        met = arc_arc(base, first, second, side)
        assert np.sign(cross(base, met.first)) == side
        other = arc_arc(base, first, second, -side)
        mirrored = complex(met.first / base).conjugate() * base
        assert complex(other.first) == pytest.approx(mirrored, rel=1e-12, abs=0)


# A line and an arc


def line_arc_in_digits(base: complex, unit: complex, radius: float, side: int) -> Solution:
    """Meet a directed line with an arc; the slopes are by base.x, base.y, direction.x, direction.y and the radius."""
    b, e, r = MP.mpc(base), MP.mpc(unit), MP.mpf(radius)
    size = abs(e)
    e = e / size
    foot = e * real(e, b)
    point = foot + side * e * MP.sqrt(r * r - abs(b - foot) ** 2)
    arm, along = point - b, real(e, point)
    changes = [(arm.real, 0), (arm.imag, 0), (0, along * e.imag), (0, -along * e.real), (r, 0)]
    # The point stays on the line: cross(e, P) = 0, so e x dP = -de x P, with de square to e.
    square = MP.j * e
    rows = (arm, square)
    return point, moved(rows, [
        changes[0], changes[1],
        (0, along * square.real / size), (0, along * square.imag / size),
        changes[4],
    ])  # fmt: skip


def slider(rng: random.Random, measure: float) -> tuple[complex, complex, float]:
    """A guide at an ordinary distance from the centre."""
    unit, radius = turned(1.0, rng), measure * rng.uniform(0.5, 2)
    height = radius * rng.uniform(-0.9, 0.9)
    return unit * complex(measure * rng.uniform(-3, 3), -height), unit, radius


def grazing(rng: random.Random, gap: float) -> tuple[complex, complex, float]:
    """A guide that touches the arc but for a share of its radius."""
    unit, radius = turned(1.0, rng), rng.uniform(0.5, 2)
    return unit * complex(rng.uniform(-3, 3), rng.choice([-1, 1]) * radius * (1 - gap)), unit, radius


def far_along(rng: random.Random, ratio: float) -> tuple[complex, complex, float]:
    """A guide named by a point far away along it."""
    base, unit, radius = slider(rng, 1.0)
    return base + ratio * unit, unit, radius


LINES_AND_ARCS: dict[str, tuple[Callable[[random.Random, float], tuple[complex, complex, float]], float]] = {
    "generic": (slider, 1.0),
    "tangency 1e-4": (grazing, 1e-4),
    "tangency 1e-8": (grazing, 1e-8),
    "tangency 1e-12": (grazing, 1e-12),
    "through the centre": (lambda rng, _: (2 * (unit := turned(1.0, rng)), unit, 1.5), 0.0),
    "point of the line far away": (far_along, 1e6),
    "lengths of 1e-9": (slider, TINY),
    "lengths of 1e+9": (slider, HUGE),
}


@pytest.mark.parametrize("family", LINES_AND_ARCS)
def test_a_line_and_an_arc_meet_as_exactly_as_their_data_allow(family: str) -> None:
    take, measure = LINES_AND_ARCS[family]
    rng = random.Random(take.__name__)
    for k in range(CASES):
        base, unit, radius = take(rng, measure)
        side = 1 if k % 2 else -1
        met = line_arc(base, unit, radius, side)
        point, slopes = line_arc_in_digits(base, unit, radius, side)
        data = (base.real, base.imag, unit.real, unit.imag, radius)
        assert share(met.first, point, slopes, data) <= 1
        from_centre = [slopes[0] - 1, slopes[1] - MP.j, *slopes[2:]]
        assert share(met.second, point - MP.mpc(base), from_centre, data) <= 1


def test_a_line_meets_an_arc_ahead_of_the_foot_or_behind_it() -> None:
    ahead, behind = (line_arc(3j, 1 + 0j, 5.0, side) for side in (+1, -1))
    assert (complex(ahead.first), complex(ahead.second)) == (4 + 0j, 4 - 3j)
    assert (complex(behind.first), complex(behind.second)) == (-4 + 0j, -4 - 3j)
    assert float(ahead.sharpness) == 0.8


def test_a_line_that_passes_an_arc_tells_by_how_much() -> None:
    for base in (7j, -7j, 100 + 7j):
        met = line_arc(base, 1 + 0j, 5.0, +1)
        assert float(met.miss) == 2
        assert np.isnan(met.first)


def test_a_line_that_touches_an_arc_is_at_a_dead_centre() -> None:
    for side in (+1, -1):
        met = line_arc(2 - 5j, 1 + 0j, 5.0, side)
        assert (complex(met.first), complex(met.second)) == (2 + 0j, 5j)
        assert (float(met.sharpness), float(met.miss)) == (0, 0)


# Two lines


def lines_in_digits(base: complex, first: complex, second: complex) -> Solution:
    """Meet two lines; the slopes are by base.x, base.y, and the x and y of the two directions."""
    b, e, f = MP.mpc(base), MP.mpc(first), MP.mpc(second)
    turn = (MP.conj(e) * f).imag
    t = (MP.conj(b) * f).imag / turn
    s = (MP.conj(b) * e).imag / turn
    point = e * t
    # cross(f, P - b) = 0 and cross(e, P) = 0: rows j f and j e
    return point, moved((MP.j * e, MP.j * f), [
        (0, (MP.j * f).real), (0, (MP.j * f).imag),
        (t * (MP.j * e).real, 0), (t * (MP.j * e).imag, 0),
        (0, s * (MP.j * f).real), (0, s * (MP.j * f).imag),
    ])  # fmt: skip


def crossing(rng: random.Random, angle: float) -> tuple[complex, complex, complex]:
    first = turned(rng.uniform(0.1, 10), rng)
    return turned(rng.uniform(0.1, 3), rng), first, first * cmath.rect(rng.uniform(0.1, 10), angle)


LINES: dict[str, tuple[float, float]] = {
    "generic": (0.0, 1.0),
    "angle 1e-4": (1e-4, 1.0),
    "angle 1e-8": (1e-8, 1.0),
    "angle 1e-12": (1e-12, 1.0),
    "lengths of 1e-9": (0.0, TINY),
    "lengths of 1e+9": (0.0, HUGE),
}


@pytest.mark.parametrize("family", LINES)
def test_two_lines_meet_as_exactly_as_their_data_allow(family: str) -> None:
    angle, measure = LINES[family]
    rng = random.Random("crossing")
    for _ in range(CASES):
        base, first, second = crossing(rng, angle or rng.uniform(0.3, 2.8))
        base *= measure
        met = line_line(base, first, second)
        point, slopes = lines_in_digits(base, first, second)
        data = tuple(x for z in (base, first, second) for x in (z.real, z.imag))
        assert share(met.first, point, slopes, data) <= 1
        from_second = [slopes[0] - 1, slopes[1] - MP.j, *slopes[2:]]
        assert share(met.second, point - MP.mpc(base), from_second, data) <= 1


def test_lines_far_from_the_origin_lose_only_what_their_coordinates_lost() -> None:
    rng = random.Random("lines at 1e8")
    for _ in range(CASES):
        base, first, second = crossing(rng, rng.uniform(0.3, 2.8))
        start = turned(1e8, rng)
        end = start + base
        board = Board("positions")
        a, c = board.given("A", start), board.given("C", end)
        e, f = board.given("e", first), board.given("f", second)
        met = board.meet("P", board.parallel("a", a, e), board.parallel("c", c, f))
        point, _ = lines_in_digits(complex(MP.mpc(end) - MP.mpc(start)), first, second)
        (_, ray), _ = met.rays
        assert abs(complex(ray) - complex(point)) <= 64 * U * (abs(base) + abs(point))
        assert abs(complex(met.point) - complex(point + MP.mpc(start))) <= 4 * U * 1e8


def test_parallel_lines_have_no_meeting_and_no_sharpness() -> None:
    for first, second in ((1 + 0j, 3 + 0j), (1 + 2j, -2 - 4j), (0.1 + 0.3j, (0.1 + 0.3j) * 7)):
        met = line_line(1j, first, second)
        assert np.isnan(met.first)
        assert float(met.sharpness) == 0
    assert float(line_line(1j, 1 + 0j, 2j).sharpness) == 1


# A slot that passes a pivot


def slot_in_digits(base: complex, offset: float, side: int) -> Solution:
    b, e = MP.mpc(base), MP.mpf(offset)
    reach = side * MP.sqrt(abs(b) ** 2 - e * e)
    unit = b / MP.mpc(reach, e)
    # base = unit (reach + j e): unit turns by (db . j unit - de) / reach
    square = MP.j * unit
    return unit, [square * square.real / reach, square * square.imag / reach, -square / reach]


SLOTS = {"generic": 0.0, "no offset": -1.0, "tangency 1e-4": 1e-4, "tangency 1e-8": 1e-8, "tangency 1e-12": 1e-12}


@pytest.mark.parametrize("family", SLOTS)
@pytest.mark.parametrize("measure", [TINY, 1.0, HUGE])
def test_a_slot_points_as_exactly_as_its_data_allow(family: str, measure: float) -> None:
    rng = random.Random(family)
    gap = SLOTS[family]
    for k in range(CASES):
        base, side = turned(measure * rng.uniform(0.5, 2), rng), 1 if k % 2 else -1
        full = rng.uniform(-0.9, 0.9) if gap == 0 else rng.choice([-1, 1]) * (1 - gap) if gap > 0 else 0.0
        offset = abs(base) * full
        met = tangent_direction(base, offset, side)
        unit, slopes = slot_in_digits(base, offset, side)
        assert share(met.first, unit, slopes, (base.real, base.imag, offset)) <= SLOT


def test_the_pin_lies_its_offset_left_of_the_slot_and_ahead_or_behind() -> None:
    for side in (+1, -1):
        for offset in (3.0, -3.0, 0.0):
            met = tangent_direction(4 + 3j, offset, side)
            unit = complex(met.first)
            assert abs(unit) == pytest.approx(1, abs=4 * EPS)
            assert cross(unit, 4 + 3j) == pytest.approx(offset, abs=32 * EPS)
            assert np.sign(dot(unit, 4 + 3j)) == side
            assert complex(met.second) == pytest.approx(unit * dot(unit, 4 + 3j), abs=32 * EPS)
            assert float(met.sharpness) == pytest.approx(math.sqrt(25 - offset**2) / 5, abs=4 * EPS)


def test_a_slot_that_cannot_pass_its_pivot_is_a_gap_and_one_that_just_does_a_dead_centre() -> None:
    gap, dead = tangent_direction(3 + 4j, 7.0, +1), tangent_direction(3 + 4j, 5.0, +1)
    assert float(gap.miss) == 2
    assert np.isnan(gap.first)
    assert (float(dead.miss), float(dead.sharpness)) == (0, 0)
    assert complex(dead.first) == pytest.approx((3 + 4j) / 5j)


def test_a_pin_on_its_pivot_gives_the_slot_no_direction() -> None:
    assert np.isnan(tangent_direction(0j, 0.0, +1).first)


# Arrays


def together(meeting: Callable[..., Meeting], data: Sequence[tuple[Any, ...]]) -> Iterator[tuple[Any, Any, float]]:
    """Give every number of every meeting, found one by one and found together, and the longest length it used."""
    whole = meeting(*(np.array(column) for column in zip(*data, strict=True)))
    for k, case in enumerate(data):
        longest = max(abs(x) for x in case)
        alone = meeting(*case)
        for told in ("first", "second", "sharpness", "miss"):
            one, many = getattr(alone, told), np.broadcast_to(getattr(whole, told), len(data))
            assert np.shape(one) == ()
            yield one, many[k], longest


def test_a_million_positions_are_met_as_one_is() -> None:
    rng = random.Random(3)
    arcs = [(*triangle(rng, 1.0), 1.0) for _ in range(CASES)] + [(9 + 0j, 1.0, 2.0, 1.0), (3 + 0j, 1.0, 2.0, -1.0)]
    guides = [(*slider(rng, 1.0), -1.0) for _ in range(CASES)] + [(9j, 1 + 0j, 1.0, 1.0), (1j, 1 + 0j, 1.0, 1.0)]
    lines = [crossing(rng, rng.uniform(0.3, 2.8)) for _ in range(CASES)] + [(1j, 1 + 0j, 2 + 0j)]
    slots = [(turned(1.0, rng), rng.uniform(-0.9, 0.9), 1.0) for _ in range(CASES)] + [(1j, 2.0, 1.0), (1j, 1.0, 1.0)]
    for meeting, data in ((arc_arc, arcs), (line_arc, guides), (line_line, lines), (tangent_direction, slots)):
        for one, many, longest in together(meeting, data):
            # Vector units fuse a multiplication with an addition, so that the last bits may differ.
            assert one == pytest.approx(many, rel=1e-13, abs=1e-13 * longest, nan_ok=True)


def test_a_gap_among_many_positions_leaves_the_others_alone() -> None:
    met = arc_arc(np.array([5 + 0j, 50 + 0j, 5j]), 3.0, 4.0, +1)
    assert list(np.isnan(met.first)) == [False, True, False]
    assert list(np.asarray(met.miss)) == [0, 43, 0]
    assert met.first[0] == pytest.approx(1.8 + 2.4j)


def test_one_side_for_each_position_is_taken() -> None:
    met = arc_arc(5 + 0j, 3.0, 4.0, np.array([1.0, -1.0]))
    assert list(met.first) == pytest.approx([1.8 + 2.4j, 1.8 - 2.4j])


def test_the_moment_and_the_product_of_two_vectors() -> None:
    assert meet.cross(1 + 2j, 3 + 4j) == -2
    assert meet.dot(1 + 2j, 3 + 4j) == 11
