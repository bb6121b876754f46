"""A rotor balanced: the textbook's values, extreme and stiff cases, and the relations that hold of any rotor."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.analytic.rotor import balance as solve
from plans.model.rotor import EPS, Plane, Rotor, RotorBalance, Unbalance
from plans.rotor.quantities import compare_rotor
from plans.rotor.study import RotorStudy
from tests.parts import examples
from tests.plans.rotors import DYNAMIC, STATIC, angles, dynamic, mass, masses, rotors, sizes, static


def draw(rotor: Rotor) -> RotorBalance:
    return RotorStudy(rotor).balance


ROADS = pytest.mark.parametrize("road", [draw, solve])


def printed(value: float, text: str) -> bool:
    """Tell whether a value, rounded to the digits of a text, is that text."""
    digits = len(text.partition("e")[0].partition(".")[2])
    return f"{value:.{digits}f}" == text


@ROADS
def test_textbook_static(road) -> None:
    """Book 8.2, (8.4): methods M7.2, all printed digits."""
    found = road(static())
    assert printed(found.unbalance.value.real, "-0.004207294663")
    assert printed(found.unbalance.value.imag, "0.02409999776")
    (one,) = found.corrections
    assert printed(one.moment.size, "0.02446448896")
    assert printed(one.moment.angle, "-80.09729668")
    assert printed(one.radius, "0.04892897793")


@ROADS
def test_textbook_dynamic(road) -> None:
    """Book 8.2, (8.5), figure 8.3: methods M7.3, all printed digits."""
    found = road(dynamic())
    assert printed(found.couple.value.real, "-0.0198163056")
    assert printed(found.couple.value.imag, "-0.01327738772")
    first, second = found.corrections
    assert printed(first.moment.size, "0.04770639338") and printed(first.moment.angle, "33.82300909")
    assert printed(second.moment.size, "0.06181309812") and printed(second.moment.angle, "-124.9669425")
    assert math.isclose(first.radius, first.moment.size / 0.5) and math.isclose(second.mass, second.moment.size / 0.1)


def star(count: int, start: int = 0, place: str = "0") -> tuple[Unbalance, ...]:
    """Give equal masses around the shaft, which balance each other."""
    return tuple(mass(k + 1, "0.3", "0.1", start + Fraction(360 * k, count), place) for k in range(count))


@ROADS
@pytest.mark.parametrize("count", [2, 3, 4, 5, 7, 12, 360])
@pytest.mark.parametrize("planes", [STATIC, DYNAMIC])
def test_a_balanced_rotor_needs_nothing_and_points_nowhere(road, count, planes) -> None:
    """Catalogue J1, J5: a residual of rounding is zero, without a direction."""
    found = road(Rotor(star(count, 17, "0.37"), planes, (Fraction(0), Fraction(1)), 300.0))
    assert [(one.moment.size, one.moment.angle) for one in found.corrections] == [(0.0, None)] * len(planes)
    assert found.moments == (0j,) * len(planes)
    assert [one.size for one in (*found.before, *found.after)] == [0.0] * 4


@ROADS
def test_masses_outside_the_planes_are_balanced_too(road) -> None:
    """Catalogue J3: a mass plane outside those of correction."""
    found = road(Rotor((mass(1, "1", "0.1", 0, "0.75"),), DYNAMIC))
    first, second = found.corrections
    assert math.isclose(first.moment.value.real, -0.15) and math.isclose(second.moment.value.real, 0.05)


@ROADS
def test_one_plane_balances_the_resultant_and_leaves_the_couple(road) -> None:
    """Catalogue J2: static only."""
    found = road(static(bearings=(Fraction("-0.1"), Fraction("0.6")), speed=100.0))
    assert found.couple.size > 0.02
    one, other = found.after
    assert math.isclose(one.size, other.size) and math.isclose((one.angle - other.angle) % 360, 180.0)
    assert math.isclose(one.size * 0.7, found.couple.size * 100.0**2)


@ROADS
def test_a_dynamically_balanced_rotor_leaves_its_bearings_alone(road) -> None:
    found = road(dynamic(bearings=(Fraction("-0.1"), Fraction("0.6")), speed=314.0))
    assert min(one.size for one in found.before) > 3000
    assert [one.size for one in found.after] == [0.0, 0.0]


def agree(rotor: Rotor) -> None:
    comparison = compare_rotor(RotorStudy(rotor))
    assert [one.name for one in comparison.findings if one.excess.max() > 1] == []
    assert comparison.agrees


@pytest.mark.parametrize(
    "planes",
    [
        STATIC,
        DYNAMIC,
        (Plane("I", Fraction(1, 10**9)), Plane("II", Fraction(0))),  # close together
        (Plane("I", 10**6 + Fraction(1, 10**9)), Plane("II", Fraction(10**6))),  # and far from the masses
        (Plane("I", Fraction(10**9)), Plane("II", -Fraction(10**9))),
    ],
)
@pytest.mark.parametrize("least", ["1e-9", "0.5", "1e9"])
def test_stiff_rotors_agree_by_both_roads(planes, least) -> None:
    rows = [(least, "0.12", 20, "0.10"), ("1e9", "0.09", 130, "0.25"), ("1e-9", "1e-9", 250, "0.42")]
    agree(Rotor(masses(rows), planes, (Fraction(0), Fraction(1, 10**6)), 1e4))


@examples(4)
@given(rotors())
def test_roads_agree(rotor) -> None:
    agree(rotor)
    agree(replace(rotor, planes=rotor.planes[:1]))


@examples(4)
@given(rotors())
def test_the_polygons_close(rotor) -> None:
    """A polygon's residual is at most 8 eps of the sum of its vectors."""
    drawing = RotorStudy(rotor).drawing
    for one in (drawing.moments, drawing.forces):
        vectors = [complex(side.vector.point) for side in one.sides] + [complex(one.closing.point)]
        x, y = (math.fsum(part) for part in zip(*((v.real, v.imag) for v in vectors), strict=True))
        assert math.hypot(x, y) <= 8 * EPS * math.fsum(map(abs, vectors))


def near(ours: RotorBalance, theirs: RotorBalance, rotor: Rotor, of=lambda value: value) -> None:
    for one, other in zip(ours.corrections, theirs.corrections, strict=True):
        assert abs(one.moment.value - of(other.moment.value)) <= 32 * EPS * sizes(rotor)


@ROADS
@examples(4)
@given(rotor=rotors(), by=angles)
def test_turn(road, rotor, by) -> None:
    turned = replace(rotor, masses=tuple(one._replace(angle=one.angle + by) for one in rotor.masses))
    near(road(turned), road(rotor), rotor, lambda value: value * cmath.rect(1, math.radians(by)))


@ROADS
@examples(4)
@given(rotor=rotors())
def test_mirror(road, rotor) -> None:
    mirrored = replace(rotor, masses=tuple(one._replace(angle=-one.angle) for one in rotor.masses))
    near(road(mirrored), road(rotor), rotor, complex.conjugate)


@ROADS
@examples(4)
@given(rotor=rotors(), power=st.integers(-20, 20))
def test_scale_of_masses(road, rotor, power) -> None:
    scaled = replace(rotor, masses=tuple(one._replace(moment=one.moment * 2.0**power) for one in rotor.masses))
    assert road(scaled).moments == tuple(value * 2.0**power for value in road(rotor).moments)


@ROADS
@examples(4)
@given(rotor=rotors(), other=rotors())
def test_superposition(road, rotor, other) -> None:
    """What balances two rotors' masses together is the sum of what balances each."""
    both = replace(rotor, masses=rotor.masses + other.masses)
    apart = replace(rotor, masses=other.masses)
    pairs = zip(road(rotor).corrections, road(apart).corrections, strict=True)
    for one, (first, second) in zip(road(both).corrections, pairs, strict=True):
        assert abs(one.moment.value - first.moment.value - second.moment.value) <= 32 * EPS * sizes(both)
