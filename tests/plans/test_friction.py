"""Friction of a machine: the worked values of the method descriptions, efficiency, wear, and self-locking."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import cos, radians, sin, sqrt, tan

import numpy as np
import pytest

from plans.analytic.friction import friction as by_analysis
from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.forces.force_template import ForcePattern
from plans.forces.friction import friction, pressing
from plans.model.dyad import pairs
from plans.model.kinetostatics import SLANTED, TILTED, Applied, Friction, Loading
from plans.model.machine import GEAR, Body, Machine, Rubbing, Transmission
from plans.model.mechanism import Mechanism, Way
from plans.model.motion import Motion
from tests.plans import linkages
from tests.plans.studies import Angle, study_of

DIGITS = 5.1e-10  # values printed with ten digits: half a unit of the tenth of a value that begins with 1
MASSES = {1: Body(1, 6, 0.25, 0j), 3: Body(3, 15, 0.6, 0.35 + 0j), 4: Body(4, 3, 0.01, 0.1 + 0j), 5: Body(5, 25, 0, 0j)}
GEARED = Transmission(GEAR, 0.18, radians(210), radians(20))
JOURNAL, GUIDE = Rubbing(0.12, 0.02), Rubbing(0.12)
ALL_PAIRS = {"0-1": JOURNAL, "1-2": JOURNAL, "0-3": JOURNAL, "3-4": JOURNAL, "4-5": JOURNAL, "2-3": GUIDE, "0-5": GUIDE}
SHAPER = Machine(MASSES, -9.81j, (), (), (), GEARED, ALL_PAIRS)
LIGHT = Machine({}, 0j, (), (), (), Transmission(), {})
ROADS = ("construction", "analysis")
ROAD = {"by": ROADS[0]}  # of the test that runs
Load = Callable[[Motion], Loading]


@pytest.fixture(autouse=True, params=ROADS)
def road(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Every test is held to both roads."""
    monkeypatch.setitem(ROAD, "by", request.param)
    return str(request.param)


def printed(*values: float) -> object:
    return pytest.approx(values, rel=DIGITS)


def shaper(omega: float = 10.0, epsilon: float = 5.0) -> Mechanism:
    """The shaper with the ram's guide exactly amid the sagitta of B's arc."""
    mechanism = linkages.shaper(omega=omega, epsilon=epsilon)
    slot, guide = mechanism.slides
    return replace(mechanism, slides=(slot, guide._replace(on_owner=Way(1j * sqrt(0.35**2 - 0.12**2), 1 + 0j))))


def found(
    mechanism: Mechanism,
    machine: Machine,
    load: Load,
    first: Angle = 0,
    positions: int | list[Angle] = 12,
    road: str = "",
) -> Friction:
    study = study_of(mechanism, first, positions)
    if (road or ROAD["by"]) == "construction":
        motion = study.motion(2)
        loading = load(motion)
        numbers = study.drafts().follow(2)
        pattern = ForcePattern(numbers[0], study.groups, machine, loading)
        statics = pattern.read(pattern.follow(numbers[1], loading), motion.phi)
    else:
        analysis = Analysis(mechanism)
        motion = analysis.motion(study.turn.phi)
        loading = load(motion)
        statics = kinetostatics(analysis, machine, motion, loading, pairs(mechanism, study.groups))
        return by_analysis(analysis, machine, motion, loading, statics, pairs(mechanism, study.groups))
    return friction(mechanism, study.groups, machine, motion, loading, statics)


def on(link: int, point: str, force: complex) -> Load:
    """A force that never changes, on the first point of a link."""
    return lambda motion: Loading((Applied("F", link, point, 0j, np.full(len(motion.phi), force + 0j)),), ())


def against(link: int, point: str, size: float) -> Load:
    """A force of a size against the motion of the first point of a link."""

    def load(motion: Motion) -> Loading:
        v = motion.points[point].v
        assert v is not None
        return Loading((Applied("F", link, point, 0j, -size * v / np.abs(v)),), ())

    return load


# Worked values (M6.1, M6.2)


def test_power_lost_in_each_pair_of_the_shaper(road: str) -> None:
    now = found(shaper(), SHAPER, on(5, "D", 1500), 60, 1, road)
    assert list(now.powers) == list(ALL_PAIRS)
    powers = [float(now.powers[key][0]) for key in ("0-1", "1-2", "0-3", "3-4", "4-5", "2-3", "0-5")]
    assert powers == printed(98.4781403, 46.54555493, 5.027749402, 13.95183052, 4.351089769, 140.8512356, 27.31331339)
    assert float(now.lost[0]) == pytest.approx(336.5189139, rel=DIGITS)


def test_efficiency_and_wear_of_the_shaper(road: str) -> None:
    now = found(shaper(), SHAPER, on(5, "D", 1500), 60, 1, road)
    assert (now.useful[0], now.efficiency[0]) == printed(2546.372724, 0.8832703562)
    assert list(now.wear)[:3] == ["2-3", "0-1", "1-2"]
    assert tuple(now.wear.values())[:3] == printed(0.4185536972, 0.2926377574, 0.1383148257)
    assert now.cycle is None  # one position is no cycle


def test_against_weight_alone_no_efficiency_is_told(road: str) -> None:
    now = found(shaper(), SHAPER, lambda _: Loading((), ()), 60, 12, road)
    assert np.isfinite(now.lost).all() and np.isnan(now.efficiency).all() and now.cycle is None


@pytest.mark.parametrize(("x", "total"), [(0.0, 800), (0.06, 800), (-0.06, 800), (-0.09, 1200), (0.12, 1600)])
def test_pressure_of_a_contact_by_the_place_of_the_line_of_action(x: float, total: float) -> None:
    assert pressing(np.float64(-800), np.float64(-800 * x), 0.12) == pytest.approx(total)


# How powers depend on what is given


def test_twice_the_coefficient_loses_twice_the_power() -> None:
    twice = {key: pair._replace(coefficient=0.24) for key, pair in ALL_PAIRS.items()}
    more = found(shaper(), replace(SHAPER, friction=twice), on(5, "D", 1500), 60, 1)
    assert more.lost[0] == pytest.approx(2 * 336.5189139, rel=DIGITS)
    assert more.wear["2-3"] == pytest.approx(0.4185536972, rel=DIGITS)


def test_a_load_on_any_place_of_a_link_has_the_velocity_of_that_place() -> None:
    """On the line from C to B the velocity is omega_3 times the distance from C, square to it."""

    def load(motion: Motion) -> Loading:
        square = -1j * np.exp(1j * motion.links[3].angle)
        return Loading((Applied("F", 3, "S3", 0.35 + 0j, 200 * square),), ())

    assert found(shaper(), SHAPER, load, 60, 1).useful[0] == pytest.approx(200 * 0.35 * 2.421846089, rel=1e-9)


# Cycles and gaps


# Self-locking


def slider_crank(f: float, load: Load, positions: int | list[Angle] = 12, road: str = "") -> Friction:
    """Crank 1 m, rod 1.2 m: tan of the rod's angle to the guide is sin(phi)/sqrt(1.44 - sin(phi)^2)."""
    return found(linkages.slider_crank(1, 1.2), replace(LIGHT, friction={"0-3": Rubbing(f)}), load, 0, positions, road)


def test_a_slider_jams_where_the_rod_is_too_steep(road: str) -> None:
    now = slider_crank(0.7, against(3, "B", 500), [10, 60, 90, 120, 170, 270], road)
    rod = [sin(radians(k)) / sqrt(1.44 - sin(radians(k)) ** 2) for k in (10, 60, 90, 120, 170, 270)]
    assert now.locking["0-3"] == pytest.approx([0.7 * abs(slant) for slant in rod])
    assert [(jam.pair, jam.position) for jam in now.jams] == [("0-3", 2), ("0-3", 5)]
    assert now.jams[0].ratio == pytest.approx(0.7 / sqrt(0.44))
    assert (now.jams[0].phi, now.jams[0].advice) == (pytest.approx(radians(90)), SLANTED)
    assert slider_crank(0.66, against(3, "B", 500), [90, 270], road).jams == ()  # 0.66/sqrt(0.44) = 0.995


def test_a_yoke_jams_when_the_block_is_far_from_a_short_guide(road: str) -> None:
    """The block's force is along the guide at the distance 0.1 |cos(phi)|: 0.3 * 2 * 0.1 |cos(phi)|/0.05 >= 1."""
    rubs = replace(LIGHT, friction={"0-3": Rubbing(0.3, 0, 0.05)})
    now = found(linkages.scotch_yoke(0.1), rubs, against(3, "D", 500), 0, [5, 30, 35, 80, 145, 150, 170], road)
    wanted = [1.2 * abs(cos(radians(k))) for k in (5, 30, 35, 80, 145, 150, 170)]
    assert now.locking["0-3"] == pytest.approx(wanted)
    assert [jam.position for jam in now.jams] == [0, 1, 5, 6]
    assert {jam.advice for jam in now.jams} == {TILTED}


def test_a_slider_driven_by_a_moving_guide() -> None:
    """PRP: the rocker's slot presses square to itself, at phi to the line x = h on which the pin slides."""
    machine = replace(LIGHT, friction={"0-3": Rubbing(0.5)})
    now = found(linkages.tangent_mechanism(0.2), machine, against(3, "A", 100), 0, [10, 50, 63, 64, 70])
    assert now.locking["0-3"] == pytest.approx([0.5 * tan(radians(k)) for k in (10, 50, 63, 64, 70)])
    assert [jam.position for jam in now.jams] == [3, 4]  # arctan 2 = 63.43 degrees


def test_a_contact_may_be_far_from_the_origin_of_its_link() -> None:
    """The yoke's contact is about E, 1 m from D: the block's force passes it at the distance 1 - 0.1 cos(phi)."""
    yoke = linkages.scotch_yoke(0.1)
    slot, guide = yoke.slides
    guide = guide._replace(on_slider=Way(1 + 0j, 1j), on_owner=Way(1 + 0j, 1j), point="E")
    machine = replace(LIGHT, friction={"0-3": Rubbing(0.3, 0, 1.5)})
    now = found(replace(yoke, slides=(slot, guide)), machine, against(3, "D", 500), 0, [20, 60, 150, 200])
    wanted = [0.3 * 2 * (1 - 0.1 * cos(radians(k))) / 1.5 for k in (20, 60, 150, 200)]
    assert now.locking["0-3"] == pytest.approx(wanted)
