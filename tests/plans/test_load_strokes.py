"""The working stroke that the scene chooses, and strokes of a load's own: by both roads."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import extremes
from plans.model.machine import Track
from plans.model.mechanism import Output, Parting, StructureError
from plans.model.motion import Extremes
from plans.scene.faults import SceneError, dotted
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import some
from tests.plans.force_cases import ROADS, compared
from tests.plans.test_load_lines import PUMP
from tests.plans.test_loading import AGAINST, AT_60, AT_90, ENGINE, ON_B, ON_D, ROCKER, SHAPER, loaded

CARD = "diagram = { travel = [0, 1], force = [0, 1], back = [0, 1] }\n"
UPRIGHT = ENGINE.replace("through = [0, 0] }", "through = [0, 0], angle = 90 }").replace("B = [0.5, 0]", "B = [0, 0.5]")
# Of the pump: the rod's end B goes from 0.07 m beyond C at 0 degrees to 0.17 m before it at 180.
FAR = np.abs(0.6 - 0.12 * np.exp(1j * np.radians(np.arange(12) * 30)))
PRESSED = PUMP.replace('value = "3 кН"', "diagram = { travel = [0, 1], force = [0, 1000], back = [0, 1000] }")


def found(text: str, by: str, shown: Output | None = None) -> Extremes:
    study = LinkageStudy(parse_scene(text))
    output = study.output if shown is None else shown._replace(working=study.output.working)
    if by == "analysis":
        reached = Analysis(study.mechanism, first=False).extremes(output)
        assert reached is not None
        return reached
    drawn = extremes(study.sweep, output)
    assert drawn is not None
    return drawn.extremes


@pytest.mark.parametrize("by", some(ROADS, 3))
@pytest.mark.parametrize(
    ("text", "working", "begin", "reach"),
    [
        (ENGINE, "slower", 0, (0.5, 0.3)),  # of equal strokes time tells none: the lesser crank angle
        (ENGINE, "faster", 0, (0.5, 0.3)),
        (ENGINE, "left", 0, (0.5, 0.3)),
        (ENGINE, "right", 180, (0.3, 0.5)),
        (UPRIGHT, "up", 270, (0.3, 0.5)),
        (UPRIGHT, "down", 90, (0.5, 0.3)),
    ],
)
def test_a_slider_works_the_way_that_the_scene_says(
    text: str, working: str, begin: float, reach: tuple[float, float], by: str
) -> None:
    told = found(text + f'[output]\nworking = "{working}"\n', by)
    assert math.cos(told.phi[0] - math.radians(begin)) == pytest.approx(1)
    assert told.reach == pytest.approx(reach)
    assert (told.faster, told.ratio) == (False, pytest.approx(1))


@pytest.mark.parametrize("by", ROADS)
def test_the_faster_stroke_may_be_the_working_one(by: str) -> None:
    """The shaper's slower stroke takes pi + theta of the crank, sin(theta/2) = OA/OC = 0.12/0.35 (M2.1)."""
    slow, fast = (found(SHAPER + f'[output]\nworking = "{word}"\n', by) for word in ("slower", "faster"))
    theta = 2 * math.asin(0.12 / 0.35)
    assert slow.angles == pytest.approx((math.pi + theta, math.pi - theta))
    assert fast.angles == pytest.approx((math.pi - theta, math.pi + theta))
    assert (fast.phi, fast.reach) == (slow.phi[::-1], slow.reach[::-1])
    assert (fast.overlap, fast.ratio) == (slow.overlap, slow.ratio)  # K is of the slower stroke over the faster
    assert slow.ratio > 1
    assert (slow.faster, fast.faster) == (False, True)
    assert (fast.phi[1] - fast.phi[0]) % (2 * math.pi) == pytest.approx(math.pi - theta)


@pytest.mark.parametrize("by", some(ROADS, 3))
@pytest.mark.parametrize(
    ("output", "sense"),
    [
        ('link = 3\nworking = "counter-clockwise"\n', 1),
        ('link = 3\nworking = "clockwise"\n', -1),
        ('point = "B"\nworking = "left"\n', 1),
        ('point = "B"\nworking = "right"\n', -1),
    ],
)
def test_a_rocker_works_by_its_turn_or_by_the_way_of_its_point(output: str, sense: int, by: str) -> None:
    """Its end B swings above C between 0.5 and 0.3 from O: counter-clockwise it goes to the left."""
    told = found(ROCKER + f"[output]\n{output}", by)
    assert math.copysign(1, told.reach[1] - told.reach[0]) == sense


@pytest.mark.parametrize("by", ROADS)
def test_the_sense_of_the_crank_does_not_change_the_way_of_the_working_stroke(by: str) -> None:
    for text in (SHAPER, SHAPER.replace("speed = 10", "speed = -10")):
        assert np.diff(found(text + '[output]\nworking = "right"\n', by).reach) > 0


@pytest.mark.parametrize("by", ROADS)
def test_loads_follow_the_working_stroke_that_is_chosen(by: str) -> None:
    """The shaper's working stroke takes 220.1 of its 360 degrees, the faster one the rest: five of twelve positions."""
    cut = ON_D + f'value = 1500\nduring = "working stroke"\n{AGAINST}'
    assert loaded(SHAPER + cut, by).force() == pytest.approx([1500] * 8 + [0] * 4, abs=1e-9)
    turned = loaded(SHAPER + cut + '[output]\nworking = "faster"\n', by).force()
    assert turned == pytest.approx([-1500] * 5 + [0] * 7, abs=1e-9)
    card = loaded(ENGINE + ON_B + CARD + 'direction = 0\n[output]\nworking = "right"\n', by).force()
    assert card == pytest.approx([1, 1 - AT_60, 1 - AT_90, 0, 1 - AT_90, 1 - AT_60], abs=1e-14)


@pytest.mark.parametrize("by", ROADS)
def test_a_load_says_which_stroke_of_its_own_point_works(by: str) -> None:
    text = SHAPER + ON_D + 'value = [1, 0]\nduring = "working stroke"\nstroke = "B"\nworking = "faster"\n'
    told = loaded(text, by)
    assert told.strokes.keys() == {Track("B", "faster")}
    # Position 0 begins the ram's slower stroke, and ends the rocker's faster one.
    assert told.force().real.tolist() == [0] * 8 + [1] * 4


@pytest.mark.parametrize("by", ROADS)
def test_a_force_between_two_links_counts_how_far_they_are_apart(by: str) -> None:
    told = loaded(PRESSED, by)
    ((track, stroke),) = told.strokes.items()
    assert track == Track("B", "slower", Parting("C", ("A", "B")))
    assert stroke.reach == pytest.approx((0.55 - 0.48, 0.55 - 0.72))
    assert stroke.sliding
    assert abs(told.force()) == pytest.approx(1000 * (FAR - 0.48) / 0.24, abs=1e-9)
    back = loaded(PRESSED.replace("direction", 'working = "apart"\ndirection'), by)
    assert abs(back.force()) == pytest.approx(1000 * (0.72 - FAR) / 0.24, abs=1e-9)


@pytest.mark.parametrize("by", ROADS)
def test_a_pump_that_presses_on_one_stroke_alone(by: str) -> None:
    once = PUMP.replace("direction", 'during = "working stroke"\nworking = "together"\ndirection')
    assert abs(loaded(once, by).force()) == pytest.approx([3000] * 6 + [0] * 6, abs=1e-9)
    assert compared(once).agrees


def test_both_roads_agree_in_the_strokes_of_any_two_points() -> None:
    for far, line in (("O", ("O", "E")), ("A", ("A", "E")), ("C", ("C", "E"))):
        text = SHAPER.replace('4 = "BD"', '4 = "BDE"') + "[mechanism.points]\nE = { on = 4, at = [0.1, 0.07] }\n"
        shown = Output(4, "E", parting=Parting(far, line))
        ours, theirs = (found(text, by, shown) for by in ROADS)
        assert ours.phi == pytest.approx(theirs.phi, abs=1e-9)
        assert ours.reach == pytest.approx(theirs.reach, abs=1e-13)
        assert ours.faster == theirs.faster


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            ENGINE + '[output]\nworking = "up"\n',
            'output.working: working = "up", but the output link 3 does not go that',
        ),
        (ENGINE + '[output]\nworking = "clockwise"\n', "of a slider name a way that it slides"),
        (ROCKER + '[output]\nlink = 3\nworking = "up"\n', "of a link that swings also how it turns, or its point"),
    ],
)
def test_a_way_that_the_output_does_not_go_is_refused(text: str, said: str) -> None:
    with pytest.raises(StructureError) as refused:
        _ = LinkageStudy(parse_scene(text)).extreme_positions
    assert said in str(refused.value)
    assert str(refused.value).startswith("scene.toml:")


def test_a_way_that_a_load_does_not_go_is_refused_where_the_loads_stand() -> None:
    text = SHAPER + ON_D + 'value = [1, 0]\nduring = "working stroke"\nstroke = "D"\nworking = "apart"\n'
    with pytest.raises(StructureError, match='loads: working = "apart", but the output link 5 does not go that way'):
        compared('sheets = ["forces"]\n' + text)


@pytest.mark.parametrize(
    ("text", "where", "said"),
    [
        ("[output]\n", "output", "either link or point"),
        ('[output]\nworking = "upward"\n', "output.working", 'Fix: write "slower"'),
        (ON_D + 'value = [1, 0]\nworking = "up"\n', "loads.forces[0].working", "a stroke of the load's own"),
        (
            ON_D + 'value = [1, 0]\nduring = "idle stroke"\nworking = "up"\n',
            "loads.forces[0].working",
            "write working in [output]",
        ),
    ],
)
def test_a_wrong_use_is_told_with_what_to_write(text: str, where: str, said: str) -> None:
    with pytest.raises(SceneError) as refused:
        loaded(SHAPER + text)
    (fault,) = refused.value.faults
    assert (dotted(fault.path), said in str(fault)) == (where, True), str(fault)


def test_the_pumping_jack_lifts_on_its_faster_stroke() -> None:
    """What the author means by its working stroke, up, happens to be the faster: K is told of the slower over it."""
    text = (Path(__file__).parents[1] / "cases/loads/pumping-jack.toml").read_text("utf-8")
    up = found(text, "construction")
    assert up.faster
    assert up.angles[0] < math.pi < up.angles[1]
    assert up.ratio > 1
    down = found(text.replace('working = "up"', 'working = "slower"'), "construction")
    assert down.phi == up.phi[::-1]
    assert compared(text).agrees


PRESS = (Path(__file__).parents[1] / "cases/loads/press.toml").read_text("utf-8")


@pytest.mark.parametrize("by", ROADS)
@pytest.mark.parametrize(("during", "sense"), [("working direction", -1), ("idle direction", 1)])
def test_a_load_may_act_wherever_its_point_goes_that_way(during: str, sense: int, by: str) -> None:
    """The slider of the press reverses four times in a turn; it works downwards."""
    card = 'diagram = { travel = [0, 0.8, 0.85, 1], force = [0, 0, "40 кН", "70 кН"] }'
    text = PRESS.replace(card, "value = 1000").replace('"working direction"', f'"{during}"')
    told = loaded(text.replace("positions = 12", "positions = 72"), by)
    speed = told.motion.points["G"].v.imag
    moves = abs(speed) > 1e-9  # at rest it is about to move
    assert np.sign(speed[moves]).tolist().count(sense) > 5
    expected = np.where(np.sign(speed) == sense, -1000j * np.sign(speed), 0)
    assert told.force()[moves] == pytest.approx(expected[moves], abs=1e-9)
    arc = loaded(
        text.replace(during, during.replace("direction", "stroke")).replace("positions = 12", "positions = 72"), by
    )
    assert (abs(arc.force() - told.force())[moves] > 500).any()  # within a stroke it goes back


def test_numbers_tell_whether_the_working_stroke_is_the_faster() -> None:
    for working, faster in (("slower", False), ("faster", True)):
        study = Study(parse_scene(SHAPER + f'[output]\nworking = "{working}"\n'))
        assert study.numbers("linkage", "construction").plain()["extremes"]["faster"] is faster


def test_a_moment_and_a_force_between_links_know_the_direction_too() -> None:
    rocked = '[[loads.moments]]\non = 3\nvalue = 12\nduring = "idle direction"\nstroke = "B"\n'
    told = loaded(ROCKER + rocked)
    omega = told.motion.links[3].omega
    assert omega is not None
    way = -np.sign(np.diff(told.strokes[Track("B")].reach)[0])
    assert told.loading.moments[0].moment[1:] == pytest.approx(np.where(np.sign(omega[1:]) == way, 12, 0))
    once = PUMP.replace("direction", 'during = "working direction"\nworking = "together"\ndirection')
    assert abs(loaded(once).force()) == pytest.approx([3000] * 6 + [0] * 6, abs=1e-9)
