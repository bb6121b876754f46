"""The arcs of the crank's angles over the working and the idle stroke on the plan of positions."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import pytest

from drawings.layout.picture import Margins, picture
from drawings.linkage.position_plan import layers
from drawings.linkage.skeleton import Pairs, skeletons
from drawings.linkage.trajectories import phases
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Fill, Group
from drawings.paper.walk import flat
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from tests.plans.test_loading import AGAINST, ON_D, SHAPER

JACK = (Path(__file__).parents[1] / "cases/loads/pumping-jack.toml").read_text("utf-8")
CUT = ON_D + f'value = 1500\nduring = "working stroke"\n{AGAINST}'
ROOM, ANYWHERE = Field(40, 40, 400, 400), Margins(0.0, 0.0, 0.0)


def pairs_of(text: str, hand: Hand | None = None) -> Pairs:
    study = LinkageStudy(parse_scene(text))
    bones = skeletons(study, study.motion(), 2)
    measured = picture("positions", bones.points, ("l", "m"), ANYWHERE, 0.0)
    place = measured.place(ROOM, measured.ladder(ROOM.width, ROOM.height).rungs[0].scale)
    return Pairs(bones, place, hand or Hand(0.7, 0.35, 0.25))


def arcs(pairs: Pairs) -> list[Group]:
    return [group for group in layers(pairs, "ru") if group.name == "phases"]


@pytest.mark.parametrize(
    ("text", "work"),
    [
        (SHAPER + '[output]\nworking = "slower"\n', 180 + 2 * math.degrees(math.asin(0.12 / 0.35))),
        (SHAPER + '[output]\nworking = "faster"\n', 180 - 2 * math.degrees(math.asin(0.12 / 0.35))),
        (SHAPER.replace("speed = 10", "speed = -10") + CUT, -180 - 2 * math.degrees(math.asin(0.12 / 0.35))),
        (JACK, 163.8029),
    ],
    ids=["asked", "faster", "a load, clockwise", "jack"],
)
def test_the_arcs_span_the_angles_of_the_strokes_from_extreme_to_extreme(text: str, work: float) -> None:
    pairs = pairs_of(text)
    working, idle = phases(pairs, "ru")
    assert (working.letter, idle.letter) == ("φ_{р}", "φ_{х}")
    assert math.degrees(working.arc.sweep) == pytest.approx(work, abs=1e-4)
    assert working.arc.sweep + idle.arc.sweep == pytest.approx(math.copysign(2 * math.pi, work))
    travel = pairs.bones.study.travel
    assert travel is not None
    for phase, begin, end in ((working, *travel.directions), (idle, *travel.directions[::-1])):
        assert cmath.rect(1.0, phase.arc.start) == pytest.approx(begin)
        assert cmath.rect(1.0, phase.arc.start + phase.arc.sweep) == pytest.approx(end)
    (group,) = arcs(pairs)
    strokes = [*flat((group,))]
    tips = [stroke.points[0] for stroke in strokes if isinstance(stroke, Fill)]
    pivot, radius = pairs.bones.pivot(pairs.place), working.arc.radius
    ends = [pivot + radius * complex(ray) for ray in travel.directions[::-1]]
    assert tips == pytest.approx(ends)
    assert [stroke.radius for stroke in strokes if isinstance(stroke, Arc)] == [radius] * 2


def test_there_are_none_where_both_strokes_take_half_a_turn_and_none_is_asked_for() -> None:
    pairs = pairs_of((Path(__file__).parents[1] / "cases/kinematics/v-compressor.toml").read_text("utf-8"))
    assert phases(pairs, "en") == ()
    assert arcs(pairs) == []


def test_a_load_of_the_working_stroke_does_not_show_two_halves_of_a_turn() -> None:
    """Of a piston in line with its shaft, both of 180 degrees: its load diagram tells which is the working one."""
    text = (Path(__file__).parents[1] / "cases/kinematics/v-compressor.toml").read_text("utf-8")
    load = '[[loads.forces]]\non = 3\npoint = "B"\nname = "F_us"\nvalue = 900\nduring = "working stroke"\n'
    assert phases(pairs_of(f"{text}\n{load}{AGAINST}"), "en") == ()
