"""The arcs of the crank's angles over the working and the idle stroke on the plan of positions."""

from __future__ import annotations

from pathlib import Path

from drawings.layout.picture import Margins, picture
from drawings.linkage.position_plan import layers
from drawings.linkage.skeleton import Pairs, skeletons
from drawings.linkage.trajectories import phases
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from tests.plans.test_loading import AGAINST

ROOM, ANYWHERE = Field(40, 40, 400, 400), Margins(0.0, 0.0, 0.0)


def pairs_of(text: str, hand: Hand | None = None) -> Pairs:
    study = LinkageStudy(parse_scene(text))
    bones = skeletons(study, study.motion(), 2)
    measured = picture("positions", bones.points, ("l", "m"), ANYWHERE, 0.0)
    place = measured.place(ROOM, measured.rungs(ROOM.width, ROOM.height)[0].scale)
    return Pairs(bones, place, hand or Hand(0.7, 0.35, 0.25))


def arcs(pairs: Pairs) -> list[Group]:
    return [group for group in layers(pairs, "ru") if group.name == "phases"]


def test_there_are_none_where_both_strokes_take_half_a_turn_and_none_is_asked_for() -> None:
    pairs = pairs_of((Path(__file__).parents[1] / "cases/kinematics/v-compressor.toml").read_text("utf-8"))
    assert phases(pairs, "en") == ()
    assert arcs(pairs) == []


def test_a_load_of_the_working_stroke_does_not_show_two_halves_of_a_turn() -> None:
    """Of a piston in line with its shaft, both of 180 degrees: its load diagram tells which is the working one."""
    text = (Path(__file__).parents[1] / "cases/kinematics/v-compressor.toml").read_text("utf-8")
    load = '[[loads.forces]]\non = 3\npoint = "B"\nname = "F_us"\nvalue = 900\nduring = "working stroke"\n'
    assert phases(pairs_of(f"{text}\n{load}{AGAINST}"), "en") == ()
