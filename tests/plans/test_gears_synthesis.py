"""Synthesis of planetary trains: worked ones are found, and all that setting planets one by one finds (подбор)."""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise, product

import pytest

from plans.gears.study import GearsStudy
from plans.gears.synthesis import Searched
from plans.scene.faults import SceneError
from plans.study import Study
from tests.plans.test_gears import FIXED, train
from tests.rows import over

ROW, MIXED, OUTER, RINGS = "1=0 2=0 3=-0", "1=0 2=0 2'=0 3=-0", "1=0 2=0 2'=0 3=0", "1=-0 2=0 2'=0 3=-0"


def searched(
    wheels: str, meshes: str, output: str, wanted: str, planets: int | None = 3, drive: str = "1=960", held: str = FIXED
) -> Searched:
    more = f"{held}\nwanted = {{ {wanted} }}" + (f"\nplanets = {planets}" if planets else "")
    found = Study(train(wheels, meshes, output, more, drive=drive)).of(GearsStudy).searched
    assert found is not None
    return found


# The train, its wanted ratio, and teeth, planets and ratio that the books print for it.
WORKED = {
    "U = 6": ((ROW, "1-2 2-3", "H", "ratio = 6"), (18, 36, 90), 3, Fraction(6)),
    "the digest's row": ((ROW, "1-2 2-3", "H", "ratio = 3.5, ring = 60", 2), (24, 18, 60), 2, Fraction(7, 2)),
    "the digest's mixed rows": ((MIXED, "1-2 2'-3", "H", "ratio = 10.5"), (20, 50, 25, 95), 3, Fraction(21, 2)),
    "the digest's outer rows": (
        (OUTER, "1-2 2'-3", "1", "ratio = 20, tolerance = 0", 2, "H=960"),
        (40, 38, 39, 39),
        2,
        Fraction(20),
    ),
    "the digest's 3K": (
        ("1=0 2=0 2'=0 3=-0 4=-0", "1-2 2-3 2'-4", "4", "ratio = 116, tolerance = 0"),
        (18, 36, 33, 90, 87),
        3,
        Fraction(116),
    ),
    "four planets": ((ROW, "1-2 2-3", "H", "ratio = 5, tolerance = 0, ring = 80", 4), (20, 30, 80), 4, Fraction(5)),
}


@over("name", [*WORKED])
def test_a_worked_train_is_among_the_solutions(name: str) -> None:
    asked, teeth, planets, ratio = WORKED[name]
    found = {tuple(map(abs, one.teeth.values())): one for one in searched(*asked).solutions}
    assert (found[teeth].planets, found[teeth].ratio) == (planets, ratio)


def test_the_smallest_train_is_drawn_with_the_most_planets_that_fit() -> None:
    scene = train(ROW, "1-2 2-3", "H", f"{FIXED}\nwanted = {{ ratio = 3.5 }}")
    study = Study(scene).of(GearsStudy)
    assert study.searched is not None
    best = study.searched.solutions[0]
    assert best.across == min(one.across for one in study.searched.solutions)
    assert {name: wheel.teeth for name, wheel in study.train.wheels.items()} == best.teeth
    assert study.train.planets == best.planets == 6  # the sun of 35 is the larger one
    assert best.across == study.train.wheels["3"].radius * 2


def test_a_ring_has_eight_teeth_more_than_the_wheel_within_it() -> None:
    found = searched(RINGS, "1-2 2'-3", "1", "ratio = 50, ring = 30, greatest = 60", 1, "H=960").solutions
    assert min(-one.teeth["1"] - one.teeth["2"] for one in found) == 8


# How the distance of axes and the ratio are told in textbooks, from z_1, z_2, z_2', z_3; the ring's teeth positive.
SCHEMES = {
    ROW: ("1-2 2-3", "H", "1=960", lambda a, b, c, d: (a + b, d - c, 1 + Fraction(d, a))),
    MIXED: ("1-2 2'-3", "H", "1=960", lambda a, b, c, d: (a + b, d - c, 1 + Fraction(b * d, a * c))),
    OUTER: ("1-2 2'-3", "1", "H=960", lambda a, b, c, d: (a + b, c + d, _carrier(a, b, c, d))),
    RINGS: ("1-2 2'-3", "1", "H=960", lambda a, b, c, d: (a - b, d - c, _carrier(a, b, c, d))),
}


def _carrier(a: int, b: int, c: int, d: int) -> Fraction:
    """The ratio of the carrier to wheel 1: over 1 - U_13 with the carrier held."""
    return Fraction(a * c, a * c - b * d) if a * c != b * d else Fraction(0)


def put_in(z1: int, z2: int, z3: int, z4: int, rings: tuple[bool, bool], count: int) -> bool:
    """Set blocks alike at equal angles, turned until they mesh with wheel 1, and compare their phases at wheel 3."""

    def phase(central: int, planet: int, ring: bool, at: Fraction, turned: Fraction) -> Fraction:
        own = (at - turned) * planet  # of the planet: its teeth pass the line as it turns against the wheel about it
        return (at * central - own if ring else at * central + own) % 1

    for k in range(count):
        at = Fraction(k, count)
        first = at * z1 / z2 * (-1 if rings[0] else 1) + at  # rolled about wheel 1 without slip
        ways = (first + Fraction(tooth, z2) for tooth in range(z2))
        if not any(phase(z4, z3, rings[1], at, way) == 0 for way in ways if phase(z1, z2, rings[0], at, way) == 0):
            return False
    return True


def apart(far: float, count: int, teeth: int) -> bool:
    """Set planets at equal angles and measure between the tips of neighbours."""
    centres = [far * cmath.exp(2j * math.pi * k / count) for k in range(count + 1)]
    return count == 1 or all(abs(one - other) - (teeth + 2) > 1e-9 for one, other in pairwise(centres))


def by_hand(
    scheme: str, sun: int, span: range, rings: range, ratio: Fraction, counts: tuple[int, ...]
) -> Iterator[object]:
    """Go through all teeth, and see of each train what it is like."""
    *_, told = SCHEMES[scheme]
    inner = scheme == RINGS, scheme != OUTER
    for z2, z3, z4 in product(span, span, rings if inner[1] else span):
        if scheme == ROW and z3 != z2:
            continue
        far, other, found = told(sun, z2, z3, z4)
        if far != other or (inner[0] and sun - z2 < 8) or (inner[1] and z4 - z3 < 8):
            continue
        if abs(found - ratio) > abs(ratio) / 10:
            continue
        clear = [k for k in counts if apart(far / 2, k, max(z2, z3))]
        most = [k for k in clear if put_in(sun, z2, z3, z4, inner, k)]
        if most:
            yield (sun, z2, z4) if scheme == ROW else (sun, z2, z3, z4), max(most), found


@over("scheme", [*SCHEMES])
def test_a_search_finds_what_setting_planets_one_by_one_finds(scheme: str) -> None:
    rng, all_found = random.Random(scheme), 0
    for _ in range(5):
        least, ring = rng.randint(9, 20), rng.randint(30, 60)
        span, rings = range(least, least + 24), range(ring, least + 90)
        sun = rng.choice(rings) if scheme == RINGS else rng.choice(span)
        meshes, output, drive, _ = SCHEMES[scheme]
        ratio = Fraction(rng.choice([-9, 3, 5, 8]) if scheme in (OUTER, RINGS) else rng.randint(30, 60), 1)
        ratio = ratio if scheme in (OUTER, RINGS) else ratio / 10
        planets = rng.choice([None, 1, 2, 3, 4])
        bounds = f"least = {least}, ring = {ring}, greatest = {least + 89}"
        wanted = f"ratio = {float(ratio)}, tolerance = 0.1, {bounds}"
        expected = {*by_hand(scheme, sun, span, rings, ratio, (planets,) if planets else (3, 4, 5, 6))}
        wheels = scheme.replace("1=0", f"1={sun}").replace("1=-0", f"1=-{sun}")
        try:
            found = searched(wheels, meshes, output, wanted, planets, drive).solutions
        except SceneError:
            found = ()
        told = {(tuple(map(abs, one.teeth.values())), one.planets, one.ratio) for one in found}
        within = {row for row in told if all(z in span for z in row[0][1 : None if scheme == OUTER else -1])}
        assert within == expected
        all_found += len(expected)
    assert all_found > 5


# A train, what is wanted of it, and words of what is said.
BAD = (
    (
        (ROW, "1-2 2-3", "H", "ratio = 15"),
        ("14.25 to 15.75", "nearest ratio of these is 9.52941", "z_2 = 64", "36.5 %"),
    ),
    ((ROW, "1-2 2-3", "H", "ratio = 0.3"), ("nearest ratio of these is 2.29565", "want 2.29565, or change")),
    ((ROW, "1-2 2-3", "H", "ratio = -3"), ("a positive ratio: with link 3 held, 1 and H turn the same", "ratio = 3,")),
    ((ROW, "1-2 2-3", "3", "ratio = 3", 3, "1=960", 'fixed = ["H"]'), ("a negative ratio", "ratio = -3,")),
    ((ROW, "1-2 2-3", "H", "ratio = 4", 40), ("40 planets", "0 can be put together")),
    (
        ("1=20 2=30 3=-80 4=20", "1-2 2-3 1-4", "H", "ratio = 5"),
        ("one carrier with one block of one or two planet wheels",),
    ),
    ((ROW, "1-2 2-3", "3", "ratio = 1.5"), ("one held, one driving, one driven",)),
    ((ROW, "1-2 2-3", "H", "ratio = 1.3, tolerance = 0.2", 3, "1=960 3=10", ""), ("one held, one driving",)),
    ((ROW, "1-2 2-3", "H", "ratio = 4, least = 30, greatest = 20"), ("least one, 30",)),
    ((ROW, "1-2 2-3", "H", "ratio = 4, greatest = 3000"), ("at most 300",)),
    ((ROW, "1-2 2-3", "H", 'ratio = 4, tolerance = "100 %"'), ("from 0 to less than 1",)),
    ((ROW, "1-2 2-3", "H", "ratio = 0"), ("other than 0",)),
)


@over("row", range(len(BAD)))
def test_what_cannot_be_met_is_told_with_its_conditions_in_numbers(row: int) -> None:
    asked, words = BAD[row]
    with pytest.raises(SceneError) as told:
        searched(*asked)
    assert all(word in str(told.value) for word in words), str(told.value)
