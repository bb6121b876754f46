"""Loads over the positions: strokes, overruns, diagrams, against the motion, springs; by both roads' own motions."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.forces.loading import loading
from plans.forces.reading.inventory import machine_of
from plans.forces.stroke import Stroke, strokes
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import extremes
from plans.model.kinetostatics import Loading
from plans.model.machine import OUTPUT, Machine, Track
from plans.model.mechanism import Output, StructureError
from plans.model.motion import Complexes, Extremes, Motion
from plans.scene.scene import parse_scene
from plans.words.words import said
from tests.parts import some
from tests.plans.scenes import scene

ROADS = ("construction", "analysis")
SHAPER = scene(
    frame="O = [0, 0]; C = [0, -0.350]",
    links="OA A CB BD D",
    lengths="OA = 0.120; CB = 0.700; BD = 0.200",
    slides=['link = 2; along = "CB"', "link = 5; along = { through = [0, 0.3287856445], angle = 0 }"],
    sketch="B = [0.20, 0.32]; D = [0.40, 0.33]",
    drive='link = 1; speed = 10; acceleration = 5; start = "extreme"',
)
# The slider starts from x = 0.5 and is back there after a turn: H = 0.2, and at 60 degrees x = 0.05 + sqrt(0.1525).
ENGINE = scene(
    frame="O = [0, 0]",
    links="OA AB B",
    lengths="OA = 0.1; AB = 0.4",
    slides=["link = 3; along = { through = [0, 0] }"],
    sketch="B = [0.5, 0]",
    drive="link = 1; speed = 10; positions = [0, 60, 90, 180, 270, 300]",
)
AT_60 = (0.5 - 0.05 - math.sqrt(0.1525)) / 0.2
AT_90 = (0.5 - math.sqrt(0.15)) / 0.2
# A crank-rocker; its rocker swings between directions that the law of cosines gives.
ROCKER = scene(
    frame="O = [0, 0]; C = [0.350, 0]",
    links="OA AB CB",
    lengths="OA = 0.1; AB = 0.4; CB = 0.3",
    sketch="B = [0.39, 0.30]",
    drive='link = 1; speed = 10; start = "extreme"',
)
MIDDLE = "[mechanism.points]\nE = { on = 2, at = [0.2, 0] }\n"
ON_B, ON_D = '[[loads.forces]]\non = 3\npoint = "B"\n', '[[loads.forces]]\non = 5\npoint = "D"\n'
AGAINST = 'against = "motion"\n'


class Loaded(NamedTuple):
    machine: Machine
    motion: Motion
    strokes: dict[Track, Stroke]
    loading: Loading

    def force(self, k: int = 0) -> Complexes:
        return self.loading.forces[k].force


def loaded(text: str, by: str = "construction") -> Loaded:
    study = LinkageStudy(parse_scene(text))
    machine = machine_of(study.scene, study.mechanism)
    road = Analysis(study.mechanism, first=study.form.drive.first is not None)
    motion = study.motion() if by == "construction" else road.motion(study.turn.phi)

    def drawn(shown: Output) -> Extremes | None:
        found = extremes(study.sweep, shown)
        return found.extremes if found else None

    reached = strokes(machine, study.mechanism, study.output, drawn if by == "construction" else road.extremes)
    return Loaded(machine, motion, reached, loading(machine, motion, reached))


def positions(*degrees: float) -> tuple[str, str]:
    return 'start = "extreme"', f"positions = {list(degrees)}"


@pytest.mark.parametrize("by", ROADS)
def test_the_shaper_cuts_between_the_overruns(by: str) -> None:
    """Overrun 0.1 H at each end: the cut begins at 21.4590389 and ends at 159.5541014 degrees (M2.1)."""
    near = 1e-6
    at = (21.4590389 - near, 21.4590389 + near, 60.0, 159.5541014 - near, 159.5541014 + near, 250.0, 306.8819915)
    text = SHAPER.replace(*positions(*at)) + ON_D + 'value = 1500\nduring = "working stroke"\noverrun = 0.1\n' + AGAINST
    assert loaded(text, by).force() == pytest.approx([0, 1500, 1500, 1500, 0, 0, 0], abs=1e-9)


def test_an_extreme_is_the_same_position_to_the_rounding_of_its_angle() -> None:
    stroke = Stroke(1.0, 4.5, 1, (0.0, 0.2), 3)
    rounding = 16 * np.pi * np.finfo(float).eps
    beginning = np.array([1 - rounding, 1 + rounding, 1 + 2 * np.pi - rounding, 4.5 - 1e-6, 4.5 + rounding])
    assert stroke.working(beginning).tolist() == [True, True, True, True, False]
    back = Stroke(1.0, 4.5, -1, (0.0, 0.2), 3)
    assert back.working(np.array([1 + rounding, 0.9, 4.6, 4.5, 1.1])).tolist() == [True, True, True, False, False]


@pytest.mark.parametrize("by", ROADS)
def test_shares_of_the_stroke_are_of_the_place(by: str) -> None:
    text = ENGINE + ON_B + "diagram = { travel = [0, 1], force = [0, 1], back = [0, 1] }\ndirection = 0\n"
    found = loaded(text, by)
    assert found.strokes[OUTPUT].reach == pytest.approx((0.5, 0.3))
    assert found.force() == pytest.approx([0, AT_60, AT_90, 1, AT_90, AT_60], abs=1e-14)
    assert found.strokes[OUTPUT].share(found.motion).max() <= 1


@pytest.mark.parametrize("by", ROADS)
def test_an_indicator_diagram_has_one_abscissa_for_both_strokes(by: str) -> None:
    card = "diagram = { travel = [0, 0.5, 1], force = [0, 1000, 0], back = [0, 100, 0] }\n"
    there = [0, 2000 * AT_60, 2000 * (1 - AT_90), 0]
    expected = [*there, 200 * (1 - AT_90), 200 * AT_60]
    pushed = loaded(ENGINE + ON_B + card + "direction = 180\n", by).force()
    assert pushed == pytest.approx([-size for size in expected], abs=1e-11)
    against = loaded(ENGINE + ON_B + card + AGAINST, by).force()
    assert against == pytest.approx([*there, -expected[4], -expected[5]], abs=1e-10)


def test_overruns_are_shares_at_the_start_and_at_the_end_of_the_working_stroke_on_both_strokes() -> None:
    text = ENGINE + ON_B + "value = [0, 7]\noverrun = "
    assert round(AT_60, 7) == 0.2974376
    assert loaded(text + "[0.2, 0.4]\n").force().tolist() == [0, 7j, 7j, 0, 7j, 7j]
    assert loaded(text + "[0.3, 0.4]\n").force().tolist() == [0, 0, 7j, 0, 7j, 0]
    assert loaded(text + "[0.2, 0.45]\n").force().tolist() == [0, 7j, 0, 0, 0, 7j]
    assert loaded(text + "0.29\n").force().tolist() == [0, 7j, 7j, 0, 7j, 7j]


def test_a_crank_at_rest_is_about_to_move_with_its_acceleration() -> None:
    rest = ENGINE.replace("speed = 10", "speed = 0\nacceleration = 5") + ON_B + "value = 8\n" + AGAINST
    found = loaded(rest).force()
    assert found[1:3] == pytest.approx([8, 8])
    assert found[4:] == pytest.approx([-8, -8])
    still = rest.replace("acceleration = 5", "acceleration = 0")
    assert loaded(still).force().tolist() == [0] * 6


def turned(text: str, degrees: float) -> str:
    """Turn the crank-rocker about O: frame, sketch and crank angles."""
    turn = np.exp(1j * np.radians(degrees))
    for place in (0.35, 0.39 + 0.3j):
        written = f"[{place.real:.3f}, 0]" if place == 0.35 else "[0.39, 0.30]"
        new = place * turn
        text = text.replace(written, f"[{new.real:.17g}, {new.imag:.17g}]")
    angles = [(k * 30 + degrees) % 360 for k in range(12)]
    return text.replace('start = "extreme"', f"positions = {angles}")


@pytest.mark.parametrize("by", ROADS)
@pytest.mark.parametrize("degrees", some([100, 90, 110, 200, 300], 5))
def test_the_stroke_of_a_rocker_is_its_swing_whatever_its_direction(degrees: float, by: str) -> None:
    card = 'diagram = { travel = [0, 1], force = [0, 1], back = [0, 1] }\ndirection = 0\nstroke = "B"\n'
    plain, other = (loaded(turned(ROCKER, way) + ON_B + card, by).force().real for way in (0, degrees))
    assert other == pytest.approx(plain, abs=1e-12)
    # By the law of cosines: B of the extremes is 0.5 and 0.3 from O, and 0.35 and 0.3 are the triangle's other sides.
    ends = [math.pi - math.acos((0.35**2 + 0.3**2 - far**2) / (2 * 0.35 * 0.3)) for far in (0.5, 0.3)]
    assert sorted(loaded(turned(ROCKER, 0) + ON_B + card, by).strokes[Track("B")].reach) == pytest.approx(sorted(ends))
    # At 0 degrees A lies on OC, 0.25 from C.
    here = math.pi - math.acos((0.25**2 + 0.3**2 - 0.4**2) / (2 * 0.25 * 0.3))
    begun = loaded(turned(ROCKER, 0) + ON_B + card, by).strokes[Track("B")].reach[0]
    assert plain[0] == pytest.approx((here - begun) / (sum(ends) - 2 * begun))


@pytest.mark.parametrize("by", ROADS)
def test_a_load_without_a_stroke_to_count_says_what_to_do(by: str) -> None:
    text = ENGINE + ON_B + 'value = 3\nduring = "idle stroke"\nname = "F_1"\n' + AGAINST
    with pytest.raises(StructureError) as refused:
        loaded(text + "[output]\nlink = 1\n", by)
    message = str(refused.value)
    assert message.startswith("F_1 acts over the stroke of link 1, which has no two extreme positions. Fix: let it")
    assert said(refused.value, "ru").startswith(
        "F_1 действует по ходу: звено 1 не имеет двух крайних положений. Исправьте: "
    )
    with pytest.raises(StructureError, match="the stroke of point A"):
        loaded(text + 'stroke = "A"\n', by)
    with pytest.raises(StructureError, match="the stroke of point E"):
        loaded(text.replace('"AB"', '"ABE"') + 'stroke = "E"\n' + MIDDLE, by)


def test_a_spring_whose_ends_are_in_one_place_has_no_direction() -> None:
    named = "[mechanism.points]\nE = { on = 2, at = [0, 0] }\n"  # of the rod, in the crank pin
    spring = named + "[[loads.springs]]\nbetween = [{ on = 1, point = 'A' }, 'E']\nstiffness = 200\n"
    assert [end.force.tolist() for end in loaded(ENGINE + spring + "free = 0\n").loading.forces] == [[0] * 6] * 2
    assert all(np.isnan(end.force).all() for end in loaded(ENGINE + spring + "free = 0.1\n").loading.forces)
