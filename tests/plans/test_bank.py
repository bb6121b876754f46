"""A bank of slider-cranks: the textbook's values, the usual engines, harmonics to the last digits, and relations."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given

from drawings.bank.sheet import view_of
from plans.bank.engines import ENGINES
from plans.bank.harmonics import NotSettled
from plans.bank.quantities import compare_bank
from plans.model.balance.bank import Asked, BankTask, Harmonic, Member, Unit
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.bank_scenes import TURNING, bank
from tests.parts import examples
from tests.plans.drawn_banks import BOOK, angles, banks, drawn, series, study, summed, task
from tests.rows import over

ROADS = pytest.mark.parametrize("road", [drawn, summed])
EXACT = 1e-14  # of the first harmonic: what the harmonics are held to
RATIOS = (0.001, 0.01, 0.1, 0.25, 0.5, 0.8, 0.9, 0.99)


@ROADS
def test_textbook(road) -> None:
    """Book 8.2.3, figures 8.13, 8.14: methods M7.8, all printed digits."""
    found, pull = road(BOOK), 9.5 * 20.0**2
    first, second = (2 * found.single[n].ahead / pull / n**2 for n in (1, 2))
    assert f"{first.real:.10f}" == "0.1000000000" and f"{second.real:.12f}" == "0.006350626058"
    assert f"{found.force[0].real:.10g}" == "475"
    assert [f"{found.left[k].real:.9g}" for k in (0, 90, 180)] == ["95", "-98.1155781", "95"]
    (one,) = found.compensators
    assert [f"{size:.10g}" for size in (one.with_crank, one.against)] == ["0.475", "0.475"]
    assert one.with_angle == one.against_angle == math.pi  # opposite to the crank at the dead centre
    assert f"{one.residual:.10g}" == "22.8" and f"{one.couple:.10g}" == "0.114"


ROOT = math.sqrt
# Bosch, Automotive Handbook, free forces and moments of the usual engines: times F1 or F2 of one cylinder, moments
# times the pitch too; of an order that is not named nothing is free.
FREE: Mapping[str, tuple[Mapping[int, float], Mapping[int, float]]] = {
    "one": ({1: 1, 2: 1}, {}),
    "two_together": ({1: 2, 2: 2}, {}),
    "two": ({2: 2}, {1: 1}),
    "three": ({}, {1: ROOT(3), 2: ROOT(3)}),
    "four": ({2: 4}, {}),
    "five": ({}, {1: 0.449, 2: 4.98}),
    "six": ({}, {}),
    "vee_two": ({1: 1, 2: ROOT(2)}, {}),
    "vee_four": ({2: 2 * ROOT(2)}, {1: 1}),
    "vee_six_90": ({}, {1: ROOT(3), 2: ROOT(6)}),
    "vee_six_60": ({}, {1: 1.5, 2: 1.5}),
    "vee_eight_flat": ({2: 4 * ROOT(2)}, {}),
    "vee_eight": ({}, {1: ROOT(10)}),
    "boxer_two": ({}, {1: 0.5, 2: 0.5}),
    "boxer_four": ({}, {2: 1}),
    "boxer_six": ({}, {}),
}


@ROADS
def test_usual_engines(road) -> None:
    assert {one.key for one in ENGINES} == FREE.keys()
    for engine in ENGINES:
        found = road(BankTask(Unit(0.04, 0.14, 0.0, 0.5), engine.members, 100.0, (1, 2)))
        for harmonics, free in zip((found.forces, found.moments), FREE[engine.key], strict=True):
            sizes = {n: one.size / found.single[n].size for n, one in harmonics.items() if not one.vanishes}
            assert sizes == pytest.approx(free, rel=1e-3), engine.key
            assert all(one.size == 0.0 for n, one in harmonics.items() if n not in free)


def test_both_roads_agree_over_all_ratios() -> None:
    """Harmonics of the drawn plans against the closed series, in shares of the first."""
    for ratio in RATIOS:
        bank = task(ENGINES[0].members, Unit(ratio, 1.0, 0.0, 1.0), (1, 2, 3, 4, 6, 8))
        ours, theirs = drawn(bank).single, summed(bank).single
        for order, one in ours.items():
            off = max(abs(one.ahead - theirs[order].ahead), abs(one.back - theirs[order].back))
            assert off <= EXACT / 10 * abs(theirs[1].ahead), (ratio, order)
            assert one.vanishes == theirs[order].vanishes


@over("ratio", (0.001, 0.25, 0.99))
def test_the_roads_agree_on_a_bank(ratio: float) -> None:
    asked = (Asked(1, 1.0, 0.05, 0.3), Asked(2, None, -0.05, 0.2), Asked(3, offset=0.1))
    members = (Member("1", Fraction(7), Fraction("0.1"), Fraction(-30)), *ENGINES[3].members[1:])
    bank = BankTask(Unit(0.1 * ratio, 0.1, 0.3, 0.5), members, 314.0, (1, 2, 4, 6), asked)
    comparison = compare_bank(study(bank), series(bank))
    assert comparison.agrees and len(comparison.findings) > 50
    last = comparison.construction.compensators[-1]
    assert last.with_crank == 0.0 and last.with_angle is None and last.couple is None  # there is no third order


def turned(one: Harmonic, ahead: complex, back: complex, scale: float = 1.0) -> Harmonic:
    return Harmonic(one.order, one.ahead * ahead * scale, one.back * back * scale, one.slack)


def alike(found: Mapping[int, Harmonic], wanted: Mapping[int, Harmonic], times: float = 4.0) -> None:
    """See that harmonics are the same but for rounding."""
    for order, one in found.items():
        other = wanted[order]
        slack = times * max(one.slack, other.slack)
        assert abs(one.ahead - other.ahead) <= slack and abs(one.back - other.back) <= slack


def rotor(angle: Fraction, times: int = 1) -> complex:
    return complex(np.exp(1j * math.radians(times * angle % 360)))


@ROADS
@examples(3)
@given(banks(), angles)
def test_the_whole_bank_turned(road, bank: BankTask, angle: Fraction) -> None:
    """Guides and cranks turned together turn every force."""
    turn = tuple(one._replace(crank=one.crank + angle, axis=one.axis + angle) for one in bank.members)
    was, now = road(bank), road(bank._replace(members=turn))
    alike(now.forces, {n: turned(one, rotor(angle), rotor(angle)) for n, one in was.forces.items()})
    assert np.allclose(now.force, was.force * rotor(angle), atol=4 * (was.force_slack + now.force_slack), rtol=0)


@ROADS
@examples(3)
@given(banks())
def test_a_bank_in_the_mirror(road, bank: BankTask) -> None:
    """Mirrored about the reference guide, the crank turning the other way, every vector is mirrored."""
    mirrored = tuple(one._replace(crank=-one.crank, axis=-one.axis) for one in bank.members)
    was, now = road(bank), road(bank._replace(members=mirrored))
    conjugate = {
        n: Harmonic(n, one.ahead.conjugate(), one.back.conjugate(), one.slack) for n, one in was.forces.items()
    }
    alike(now.forces, conjugate)
    assert np.allclose(now.force, was.force[::-1].conj(), atol=4 * (was.force_slack + now.force_slack), rtol=0)


@examples(2)
@given(banks())
def test_any_bank_by_both_roads(bank: BankTask) -> None:
    asked = (Asked(1, 1.0, 0.05, 0.3), Asked(2, None, -0.05, 0.2))
    bank = bank._replace(asked=asked)
    assert compare_bank(study(bank), series(bank)).agrees


@ROADS
def test_speed_and_mass(road) -> None:
    """Forces grow with the square of the speed and with the masses, compensators with the masses alone."""
    slow = road(BOOK)
    fast = road(BOOK._replace(speed=-60.0, unit=BOOK.unit._replace(reciprocating=19.0)))
    alike(fast.forces, {n: turned(one, 1, 1, 18.0) for n, one in slow.forces.items()}, 18.0)
    assert fast.compensators[0].with_crank == pytest.approx(2 * slow.compensators[0].with_crank, rel=1e-14)


def test_a_rod_all_but_as_long_as_the_crank_is_told() -> None:
    """At equal lengths there is a second dead centre, where the acceleration jumps: near it nothing settles."""
    for ratio in (1 - 1e-7, 1 - 1e-15):
        with pytest.raises(NotSettled, match="near a dead centre the acceleration all but jumps"):
            drawn(task(ENGINES[0].members, Unit(ratio, 1.0, 0.0, 1.0)))
    scene = parse_scene(
        "[bank]\nspeed = 100\n[bank.unit]\ncrank = 0.0999999999\nrod = 0.1\nreciprocating = 1\n"
        "[[bank.members]]\ncrank = 0\n"
    )
    with pytest.raises(NotSettled, match=r"scene\.toml:1: the harmonics do not settle"):
        _ = Study(scene)["bank"].balance


def test_a_bank_that_turns_clockwise_is_the_mirror_image_of_one_that_turns_the_other_way() -> None:
    """In the reference guide: what the sheet follows over the turn comes in the order in which the shaft turns."""
    rows, head = [(0, -100, 45), (20, 0, -45), (90, 100, 30)], 'speed = "{} rpm"\norders = [1, 2]\n'
    scenes = (bank([(w * c, z, w * a) for c, z, a in rows], "", TURNING, head.format(3000 * w)) for w in (1, -1))
    one, other = (view.along(view.balance.force) for view in (view_of(Study(parse_scene(text))) for text in scenes))
    assert np.abs(other - one.conj()).max() < 1e-9 * np.abs(one).max()
