"""The involute pair: worked values, tables of handbooks, random pairs against an independent envelope (эвольвента)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from random import Random
from typing import Any

import numpy as np
import pytest

from plans.analytic.involute import angle_of, flank, inv, solve
from plans.involute.limits import limits, lowest
from plans.involute.quantities import compare_pair
from plans.involute.shift import AIMS, EQUAL_SLIDING, NoShift, aimed, least_shift
from plans.involute.study import POINTS, InvoluteStudy
from plans.model.involute import GearWheel, InvolutePair, Rack
from plans.model.motion import Complexes, Floats
from plans.words.words import languages, word

RACK = Rack(0.005, math.radians(20))
UNIT = Rack(1.0, math.radians(20))
LENGTHS = {10: "4.5683", 12: "4.5963", 17: "4.6663", 20: "7.6604", 30: "10.7526", 40: "13.8448"}  # over teeth


def wheel(teeth: int, shift: float, rack: Rack = RACK) -> GearWheel:
    return GearWheel(rack, 1, teeth, shift)


# By (17 - z)/17, as the book has it, a wheel is undercut by a hair: that is told, and the pair is drawn.
@pytest.mark.parametrize(("teeth", "shift"), [(10, 7 / 17), (12, 5 / 17), (17, 0.0)])
def test_the_rule_of_17_teeth(teeth: int, shift: float) -> None:
    pair = InvolutePair(RACK, (teeth, 40), (shift, 0.0))
    assert [limit.kind for limit in limits(pair)] == ["slight_undercut"] and compare_pair(InvoluteStudy(pair)).agrees
    assert "undercut_teeth" in {limit.kind for limit in limits(replace(pair, shifts=(shift - 0.004, 0.0)))}


def test_least_shift_and_teeth_without_undercut() -> None:
    assert [f"{least_shift(wheel(teeth, 0.0)):.10f}" for teeth in (10, 12)] == ["0.4151111078", "0.2981333294"]
    first, other = (least_shift(wheel(teeth, 0.0)) for teeth in (17, 18))  # in a line with the teeth: where it is zero
    assert f"{17 + first / (first - other):.8f}" == "17.09726434" and abs(first) < 0.006


# Tables of the involute function (Anuriev, vol. 2).
@pytest.mark.parametrize(("degrees", "value"), [(15, 0.0061498), (20, 0.0149044), (25, 0.0299753), (30, 0.0537515)])
def test_involute_function(degrees: float, value: float) -> None:
    assert round(inv(math.radians(degrees)), 7) == value
    assert math.degrees(angle_of(inv(math.radians(degrees)))) == pytest.approx(degrees, abs=1e-12)


@pytest.mark.parametrize(("pair", "pins"), [  # usual ones; then two that would lie below the tips
    (((21, 21), (0.0, 0.0)), (1.7, 1.7)), (((20, 60), (0.4, 0.4), True), (1.7, 1.68)),
    (((13, 83), (0.45, 0.2)), (1.92, 1.7)),
])  # fmt: skip
def test_pins(pair: tuple[Any, ...], pins: tuple[float, float]) -> None:
    for sizes in (solve(InvolutePair(UNIT, *pair)), InvoluteStudy(InvolutePair(UNIT, *pair)).sizes):
        assert tuple(round(one.pin, 9) for one in sizes.wheels) == pins


@pytest.mark.parametrize(("module", "pair", "told"), [
    # Theme 6 of the book, tasks 2 and 3: by (17 - z)/17, and by the exact least shift; p - s is e
    (5, ((12, 30), (5 / 17, -5 / 17)), {"s_1": "8.924482323"}),
    (5, ((12, 30), (0.2981333294, -0.2981333294)), {"s_1": "8.939098211"}),
    (5, ((10, 30), (7 / 17, -7 / 17)), {"d_a1": "64.11764706", "d_f1": "41.61764706"}),
    (5, ((10, 30), (0.4151111078, -0.4151111078)), {"d_a1": "64.15111108", "d_f1": "41.65111108"}),
    # Tables at m = 1 (Anuriev, vol. 2); M_1 by hand: inv = 1.7/(21 cos 20°) + inv 20° - π/42
    *((1, ((teeth, teeth), (0.0, 0.0)), {"W_1": length}) for teeth, length in LENGTHS.items()),
    (1, ((20, 40), (0.0, 0.0)), {"s_c1": "1.3870", "h_c1": "0.7476"}), (1, ((21, 21), (0.0, 0.0)), {"M_1": "23.236"}),
    # Examples of "Elements of Metric Gear Technology"; of the first Δy = 0.12671
    (3, ((12, 24), (0.6, 0.36)), {"a_w": "56.4999", "d_a1": "44.840", "d_a2": "79.400", "d_f1": "32.100"}),
    (3, ((16, 24), (0.0, 0.5), True), {"a_w": "13.1683", "d_w2": "79.010", "d_a2": "69.46"}),
    (3, ((24, 24), (0.4, -0.4)), {"W_1": "32.8266"}), (1, ((20, 20), (0.0, 0.0)), {"M_1": "22.2941"}),
    (10, ((12, 24), (0.3, -0.3)), {"s_c1": "15.7988", "h_c1": "10.1248"}),
    # By hand, as d_a2 above: k_2 = 0.25 - 0.125 x_2 (GOST 19274), 0 from 2 on
    *((4, ((20, 60), (x, x), True), {"d_a2": tip}) for x, tip in {0.0: "234.0", 0.4: "236.8", 2.0: "248.0"}.items()),
])  # fmt: skip
def test_worked_sizes(module: float, pair: tuple[Any, ...], told: dict[str, str]) -> None:
    study = InvoluteStudy(InvolutePair(Rack(module / 1e3, RACK.angle), *pair))
    known = {one.name: one for one in compare_pair(study).findings}
    for name, digits in told.items():
        for road in (known[name].construction, known[name].analysis):
            assert f"{1e3 * float(road[0]):.{len(digits) - digits.index('.') - 1}f}" == digits


def test_no_constant_chord() -> None:
    beyond = InvoluteStudy(InvolutePair(UNIT, (61, 110), (-0.85, 0.65)))  # its chord would lie above the tip
    assert math.isnan(solve(beyond.pair).wheels[0].chord) and math.isnan(beyond.sizes.wheels[0].chord)


def pairs(count: int, seed: int) -> Iterator[InvolutePair]:
    """Give random pairs that keep all limits, every third one internal."""
    chance = Random(seed)
    for _ in range(20 * count):
        rack = Rack(chance.choice((0.002, 0.005, 0.01)), math.radians(chance.choice((20.0, 20.0, 25.0))))
        first, internal = chance.randint(10, 32), count % 3 == 0
        second = first + chance.randint(14, 60) if internal else chance.randint(first, 90)
        shift = max(least_shift(wheel(first, 0.0, rack)), 0.0) + chance.uniform(0.0, 0.3)
        other = shift + chance.uniform(0.0, 0.3) if internal else chance.uniform(-0.2, 0.5)
        pair = InvolutePair(rack, (first, second), (shift, other), internal)
        if not any(limit.broken for limit in limits(pair)):
            count -= 1
            yield pair
        if not count:
            return
    raise AssertionError("limits let too few pairs pass")


PAIRS = [*pairs(60, 31)]
CUT = [InvolutePair(RACK, (z, 40), (least_shift(wheel(z, 0.0)) - lack, 0.0)) for z in (9, 17) for lack in (1e-4, 0.006)]
NARROW = InvolutePair(RACK, (20, 60), (0.5, 1.2), True)  # its spaces have no room for the rack's corner


def sunk(spots: Complexes, cut: GearWheel, rolled: Floats) -> Floats:
    """Give how deep places lie in the rolled rack, m, < 0 outside: in a lesser trapezium with a radius all round."""
    rack, m = cut.rack, cut.rack.module
    moved = spots[:, None] * np.exp(-1j * rolled / cut.radius) - rolled
    off = np.abs(moved.real) - rack.land * m
    up = moved.imag - cut.radius - (cut.shift - rack.straight + rack.rounding * math.sin(rack.angle)) * m
    along = off * math.sin(rack.angle) + up * math.cos(rack.angle)
    beside = off * math.cos(rack.angle) - up * math.sin(rack.angle)
    corner = np.where(off <= 0, -up, np.hypot(off, up))
    return np.asarray(rack.rounding * m - np.where(along >= 0, beside, corner))


def deepest(depth: Callable[[Floats], Floats], low: Floats, high: Floats) -> Floats:
    """Give the largest depth over a range, place by place: by a grid, then by thirds."""
    grid = np.linspace(0, 1, 4001)
    tried = depth(low[:, None] + (high - low)[:, None] * grid)
    best = tried.argmax(axis=1)
    step = (high - low) / 4000
    start, end = low + step * (best - 1), low + step * (best + 1)
    for _ in range(80):
        third = (end - start) / 3
        one, other = (depth((start + k * third)[:, None])[:, 0] for k in (1, 2))
        start, end = np.where(one < other, start + third, start), np.where(one < other, end, end - third)
    return np.asarray(depth(((start + end) / 2)[:, None])[:, 0])


@pytest.mark.parametrize("pair", PAIRS + CUT)
def test_roads_agree_and_the_rack_touches_every_place_and_cuts_none(pair: InvolutePair) -> None:
    study = InvoluteStudy(pair)
    comparison = compare_pair(study)
    assert comparison.agrees
    for flanks in study.flanks:
        end = lowest(flanks.wheel, flanks.root)
        begin, base = abs(study.profile(flanks)[POINTS - 1]), flanks.wheel.base
        assert begin == pytest.approx(math.hypot(base, end), rel=1e-12) if end > 0 else begin > base
        if not flanks.wheel.internal:
            spots, reach = study.profile(flanks)[1::3], np.ones(27) * 3 * pair.rack.pitch
            left = deepest(lambda rolled, f=flanks, s=spots: sunk(s, f.wheel, rolled), -reach, reach)
            assert np.abs(left).max() < 1e-12 * pair.rack.module


@pytest.mark.parametrize("pair", [NARROW, *(pair for pair in PAIRS if pair.internal)])
def test_the_pinion_touches_the_ring_everywhere_and_cuts_nowhere(pair: InvolutePair) -> None:
    study, sizes, (first, second) = InvoluteStudy(pair), solve(pair), pair.wheels
    whole = study.profile(study.flanks[1])  # the middle of a space above the ring's centre
    part = whole[40::4]
    half = first.width / (2 * first.radius) + inv(pair.rack.angle)

    def depth(turned: Floats) -> Floats:
        """Give how deep the flank lies in the pinion's tooth, along its normal, at turns of the ring."""
        seen = part[:, None] * np.exp(1j * turned) - 1j * sizes.distance
        seen = seen * np.exp(-1j * turned * second.teeth / first.teeth)
        slope = np.sqrt(np.maximum((np.abs(seen) / first.base) ** 2 - 1, 0.0))
        return np.asarray((half - slope + np.arctan(slope) + np.angle(seen / 1j)) * first.base)

    reach = np.full(len(part), 4 * math.pi / second.teeth)
    assert np.abs(deepest(depth, -reach, reach)).max() < 1e-12 * second.radius
    # A circle through three places of the fillet: it touches root circle and involute, as large as it can
    start, end = whole[20] - whole[0], (whole[40] - whole[0]) / (whole[20] - whole[0])
    centre = whole[0] + start * (end - abs(end) ** 2) / (end - end.conjugate())
    corner = np.abs(whole[:41] - centre)
    assert np.ptp(corner) < 1e-9 * corner[0] and abs(centre) + corner[0] == pytest.approx(sizes.wheels[1].root)
    arm = centre * (whole[40] - centre).conjugate()  # the normal of an involute touches the base circle
    assert abs(arm.imag) == pytest.approx(second.base * corner[40], rel=1e-9)
    usual, left = pair.rack.rounding * pair.rack.module, whole[0].real  # to the middle of the space
    assert left > -1e-9 * usual and (corner[0] == pytest.approx(usual) or (corner[0] < usual and left < 1e-9 * usual))


@pytest.mark.parametrize("pair", PAIRS[:12])
def test_pins_touch_both_flanks_and_lie_farthest_apart(pair: InvolutePair) -> None:
    for flanks, sizes in zip(InvoluteStudy(pair).flanks, solve(pair).wheels, strict=True):
        spots, cut = flank(flanks.wheel, sizes.tip, sizes.root, 4001)[4000:], flanks.wheel
        middle = abs(complex(flanks.pins[0].point) - complex(flanks.centre.point))
        assert np.abs(spots - 1j * middle).min() == pytest.approx(sizes.pin / 2, rel=1e-6)  # by a grid of the flank
        apart = middle * np.abs(1 - np.exp(1j * math.tau * np.arange(cut.teeth) / cut.teeth)).max()
        assert apart + cut.inward * sizes.pin == pytest.approx(sizes.over, rel=1e-12)


def spare(pair: InvolutePair) -> float:
    """Give the least angle that is left in a ring's spaces beside the pinion's tips as they swing through, rad."""
    sizes, (first, second) = solve(pair), pair.wheels
    tip, ring = sizes.wheels
    turned = np.linspace(-2.0, 2.0, 40001)  # of the pinion, in whose space of the ring the tooth stands at 0
    corner = tip.tip * np.exp(1j * (turned - tip.tip_thickness / 2 / tip.tip)) * 1j + 1j * sizes.distance
    seen = corner * np.exp(-1j * turned * first.teeth / second.teeth) / 1j
    slope = np.sqrt(np.maximum((np.abs(seen) / second.base) ** 2 - 1, 0.0))
    space = second.width / (2 * second.radius) + inv(pair.rack.angle) - slope + np.arctan(slope)
    return float(np.min((space - np.abs(np.angle(seen)))[np.abs(seen) > ring.tip]))


@pytest.mark.parametrize("shift", [0.3, 0.5, 0.7])
@pytest.mark.parametrize("teeth", [(20, 24), (20, 26), (20, 28), (20, 30), (30, 36), (30, 40)])
def test_tips_of_a_ring_are_told_to_meet_where_they_do(teeth: tuple[int, int], shift: float) -> None:
    pair = InvolutePair(RACK, teeth, (shift, shift), True)
    told = [limit.details["gap"] for limit in limits(pair) if limit.kind == "tips_meet"]
    gaps = [float(str(gap).replace("\N{MINUS SIGN}", "-")) for gap in told] or [0.0]
    assert gaps[0] == pytest.approx(min(math.degrees(spare(pair)), 0.0), abs=1e-3)  # by a grid of turns


def speeds(pair: InvolutePair, spot: complex) -> tuple[float, float]:
    """Give how fast both flanks move along themselves in a place on the line of action, at 1 rad/s of wheel 1."""
    first, second = (one.operating for one in solve(pair).wheels)
    tangent = 1j * np.exp(1j * solve(pair).angle)
    ratio = pair.sense * pair.teeth[0] / pair.teeth[1]
    ways = -1j * (spot + 1j * first), 1j * ratio * (spot - 1j * pair.sense * second)
    return tuple(float((way * np.conj(tangent)).real) for way in ways)  # type: ignore[return-value]


@pytest.mark.parametrize("pair", PAIRS[:12])
def test_sliding_is_that_of_the_velocities(pair: InvolutePair) -> None:
    study = InvoluteStudy(pair)
    for number, mark in enumerate(study.action.active):
        both = speeds(pair, complex(mark.point))
        own, other = both[number], both[1 - number]
        assert solve(pair).wheels[number].sliding == pytest.approx((own - other) / own, rel=1e-9)
        arm, turning = (complex(one.point) for one in study.action.slid(number))  # by which a hand is told its error
        assert turning / arm == pytest.approx(1j * pair.sense * other / own, rel=1e-9)


def turned(pair: InvolutePair, k: int) -> float:
    """Give the turn of wheel 1 from the touch in P at which a tip slides along the flank of the other wheel."""
    sizes, own, other = solve(pair).wheels, pair.wheels[k], pair.wheels[1 - k]
    centres = -1j * sizes[0].operating, 1j * pair.sense * sizes[1].operating
    speeds = -1.0, pair.sense * pair.teeth[0] / pair.teeth[1]
    slopes = (math.sqrt((radius / own.base) ** 2 - 1) for radius in (sizes[k].operating, sizes[k].tip))
    pole, tip = (np.exp(1j * slope) * (1 - 1j * slope) for slope in slopes)
    low, high = 0.0, (-1) ** k * 3 * math.tau / pair.teeth[0]
    for _ in range(6):
        turns = np.linspace(low, high, 601)
        arm = -centres[k] * tip / pole * np.exp(1j * speeds[k] * turns)
        seen = arm + centres[k] - centres[1 - k]
        normal = seen - seen / (1 - 1j * np.sqrt(np.maximum(np.abs(seen / other.base) ** 2 - 1, 0.0)))
        along = ((speeds[k] * arm - speeds[1 - k] * seen) * 1j * normal.conj()).real
        first = int(np.argmax(along[1:] * along[:-1] < 0))
        low, high = turns[first : first + 2]
    return float(low)


@pytest.mark.parametrize("pair", PAIRS)
def test_the_contact_ratio_is_how_many_pitches_lie_between_the_touches_of_both_tips(pair: InvolutePair) -> None:
    told = (turned(pair, 0) - turned(pair, 1)) * pair.teeth[0] / math.tau
    assert abs(InvoluteStudy(pair).sizes.ratio - told) < 1e-12 > abs(solve(pair).ratio - told)


@pytest.mark.parametrize("aim", AIMS)
@pytest.mark.parametrize("plain", [((12, 28), False), ((28, 12), False), ((15, 41), False), ((18, 64), True)])
@pytest.mark.parametrize("more", [None, 0.3])
def test_shifts_bring_what_is_aimed_at(aim: str, plain: tuple[tuple[int, int], bool], more: float | None) -> None:
    teeth, internal = plain
    bare = InvolutePair(RACK, teeth, (0.0, 0.0), internal)
    centre = None if more is None else bare.standard + more * RACK.module
    pair = aimed(bare, aim, centre)
    sizes = solve(pair)
    assert sizes.distance == pytest.approx(centre or sizes.distance, rel=1e-12)
    if aim == EQUAL_SLIDING:
        assert sizes.wheels[0].sliding == pytest.approx(sizes.wheels[1].sliding, rel=1e-6)
    else:
        spared = [one.shift - least_shift(one) for one in pair.wheels if not one.internal]
        assert min(spared) >= -1e-12
        if centre and not internal:  # inversely as the teeth, as far as none is undercut
            inverse = np.divide(*pair.shifts) == pytest.approx(teeth[1] / teeth[0])
            assert inverse or min(spared) < 1e-12


def test_axes_too_near_for_whole_teeth() -> None:
    with pytest.raises(NoShift) as told:  # 2 x_min = 0.830; inv α_w = inv 20° + 0.083 tan 20°: a_w = 53.423
        aimed(InvolutePair(RACK, (10, 10), (0.0, 0.0)), AIMS[0], 0.05)
    assert told.value.details == {"total": 0.0, "sum": 0.83, "least": 53.43}


def test_limits_are_told_in_words_of_every_language() -> None:
    bad = [InvolutePair(RACK, (10, 30), (shift, 0.0)) for shift in (0.0, 1.2)]
    bad += [InvolutePair(RACK, (20, 24), (0.5, 0.5), internal=True), InvolutePair(RACK, (20, 40), (0.0, -2.0))]
    told = {limit.kind: limit.details for pair in bad for limit in limits(pair) if limit.broken}
    assert {"undercut_teeth", "pointed_tip", "tips_meet", "no_mesh"} <= told.keys() and len(languages()) == 2
    assert not any("." in word("ru", f"fault.{kind}.expected", **parts) for kind, parts in told.items())
    assert not any(limit.broken for limit in limits(replace(bad[0], shifts=(0.4152, 0.0))))
