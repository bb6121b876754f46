"""The working stroke that the scene chooses, and strokes of a load's own: by both roads."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import extremes
from plans.model.mechanism import Output, Parting, StructureError
from plans.model.motion import Extremes
from plans.scene.faults import SceneError, dotted
from plans.scene.scene import parse_scene
from tests.parts import some
from tests.plans.force_cases import ROADS, compared
from tests.plans.test_load_lines import PUMP
from tests.plans.test_loading import AGAINST, AT_60, AT_90, ENGINE, ON_B, ON_D, ROCKER, SHAPER, loaded

IDLE = 'value = [1, 0]\nduring = "idle stroke"\nworking = "up"\n'
CARD = "diagram = { travel = [0, 1], force = [0, 1], back = [0, 1] }\n"


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
    ("output", "ways"), [("link = 3", ("counter-clockwise", "clockwise")), ('point = "B"', ("left", "right"))]
)
def test_a_rocker_works_by_its_turn_or_by_the_way_of_its_point(output: str, ways: tuple[str, str], by: str) -> None:
    """Its end B swings above C between 0.5 and 0.3 from O: counter-clockwise it goes to the left."""
    for way, sense in zip(ways, (1, -1), strict=True):
        told = found(ROCKER + f'[output]\n{output}\nworking = "{way}"\n', by)
        assert math.copysign(1, told.reach[1] - told.reach[0]) == sense


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
@pytest.mark.parametrize("own", ['stroke = "K"\n', '[output]\npoint = "K"\n'])
@pytest.mark.parametrize("angle", [0.0, 75.0, 180.0])
def test_a_load_on_a_coupler_works_while_its_point_goes_against_it(angle: float, own: str, by: str) -> None:
    """A crusher's jaw: its way is that of the point along the load, whatever the turn of its link does."""
    jaw = ROCKER.replace("AB C", "ABK C").replace('start = "extreme"', "positions = 720")
    jaw += "[mechanism.points]\nK = { on = 2, at = [0.25, 0.09] }\n"
    load = f'[[loads.forces]]\non = 2\npoint = "K"\ndirection = {angle}\nvalue = 7\nduring = "working stroke"\n{own}'
    one, along = loaded(jaw + load, by), cmath.rect(1.0, math.radians(-angle))
    place, speed = ((along * row).real for row in one.motion.points["K"][:2])
    assert (np.abs(one.force()) > 0).tolist() == (speed < 0).tolist()
    (stroke,) = one.strokes.values()
    assert stroke.reach == pytest.approx((place.max(), place.min()), abs=1e-5)


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
        assert (ours.phi, ours.faster) == (pytest.approx(theirs.phi, abs=1e-9), theirs.faster)
        assert ours.reach == pytest.approx(theirs.reach, abs=1e-13)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (ENGINE + '[output]\nworking = "up"\n', 'output.working: working = "up", but the output link 3 does not go'),
        (ENGINE + '[output]\nworking = "clockwise"\n', "of a slider name a way that it slides"),
        (ROCKER + '[output]\nlink = 3\nworking = "up"\n', "of a link that swings also how it turns, or its point"),
    ],
)
def test_a_way_that_the_output_does_not_go_is_refused(text: str, said: str) -> None:
    with pytest.raises(StructureError) as refused:
        _ = LinkageStudy(parse_scene(text)).extreme_positions
    assert said in str(refused.value) and str(refused.value).startswith("scene.toml:")


def test_a_way_that_a_load_does_not_go_is_refused_where_the_loads_stand() -> None:
    text = SHAPER + ON_D + 'value = [1, 0]\nduring = "working stroke"\nstroke = "D"\nworking = "apart"\n'
    with pytest.raises(StructureError, match='loads: working = "apart", but the output link 5 does not go that way'):
        compared('sheets = ["forces"]\n' + text)


@pytest.mark.parametrize(
    ("text", "where", "said"),
    [
        ("[output]\n", "output", "either link or point"),
        ('[output]\nworking = "upward"\n', "output.working", 'did you mean "up"'),
        (ON_D + 'value = [1, 0]\nworking = "up"\n', "loads.forces[0].working", "a stroke of the load's own"),
        (ON_D + IDLE, "loads.forces[0].working", "write working in [output]"),
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
    assert up.faster and up.ratio > 1 and up.angles[0] < math.pi < up.angles[1]
    down = found(text.replace('working = "up"', 'working = "slower"'), "construction")
    assert down.phi == up.phi[::-1]
    assert compared(text).agrees
