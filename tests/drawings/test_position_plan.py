"""The plan of positions: what a strict eye finds on a textbook's figure, on every gallery scene and hard mechanism."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import shapely
from shapely.geometry.base import BaseGeometry

from drawings.checks.hold import distance, labels_of
from drawings.kinds.scheme import link_numbers
from drawings.kinds.vector_plan import letter_images
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Place, picture
from drawings.lettering.lettering import TOGETHER, bounds
from drawings.linkage.numbering import lone, numbers
from drawings.linkage.position_letters import stroke
from drawings.linkage.position_plan import layers
from drawings.linkage.sheet import leaves, position
from drawings.linkage.skeleton import Pairs, Skeletons, skeletons
from drawings.linkage.trajectories import phases
from drawings.page.page import Field, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Fill, Group, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat, texts
from plans.linkage.quantities import Comparison, compare
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings import mechanisms
from tests.drawings.collisions import ink
from tests.gallery import LINKAGES
from tests.plans.test_loading import AGAINST

A1 = Hand(0.7, 0.35, 0.25)
ROOM = Field(40, 40, 400, 400)
HAIR = 1e-6  # mm: rounding of places on paper


class Figure(NamedTuple):
    bones: Skeletons
    place: Place
    hand: Hand
    groups: dict[str, Group]

    def strokes(self, *names: str) -> list[Stroke]:
        return [*flat(group for name, group in self.groups.items() if not names or name in names)]

    def circle(self, name: str) -> Circle:
        marks = (mark for mark in self.groups["pairs"].strokes if isinstance(mark, Group) and mark.title == name)
        found = next(marks).strokes[0]
        assert isinstance(found, Circle)
        return found

    def on(self, name: str, k: int | None = None) -> complex:
        return self.place.on(self.bones.spot(name, self.bones.shown if k is None else k))


@cache
def compared(name: str) -> tuple[LinkageStudy, Comparison]:
    paths = {path.stem: path for path in LINKAGES}
    study = LinkageStudy(parse_scene(mechanisms.ALL[name]) if name in mechanisms.ALL else read_scene(paths[name]))
    return study, compare(study)


@cache
def drawn(name: str, hand: Hand = A1) -> Figure:
    study, comparison = compared(name)
    bones = skeletons(study, comparison.construction, position(study, comparison.construction))
    measured = picture(name, bones.points, ("l", "m"), Margins(0.0, 0.0, 0.0), 0.0)
    place = measured.place(ROOM, measured.rungs(ROOM.width, ROOM.height)[0].scale)
    groups = layers(Pairs(bones, place, hand), "en")
    return Figure(bones, place, hand, {group.name: group for group in groups})


def shape(stroke: Stroke) -> BaseGeometry:
    return ink(stroke).line


def thick(found: Figure) -> list[Line]:
    bars = found.strokes("shown-position", "pairs")
    return [bar for bar in bars if isinstance(bar, Line) and bar.style.width == found.hand.main]


@pytest.mark.parametrize(("name", "pin"), [("offset stone", "D"), ("offset block", "B")])
def test_an_offset_slide_is_joined_to_its_block_square_and_rigidly(name: str, pin: str) -> None:
    found = drawn(name)
    slide = next(slide for slide in found.bones.mechanism.slides if slide.point == pin)
    line = complex(found.bones.numbered.line(slide)[found.bones.shown])
    circle = found.circle(pin)
    block = next(s for s in found.strokes("shown-position") if isinstance(s, Polyline))
    bracket = [
        bar
        for bar in thick(found)
        if min(abs(abs(end - circle.centre) - circle.radius) for end in (bar.start, bar.end)) < HAIR
        and abs(((bar.end - bar.start) * line.conjugate()).real) < HAIR * abs(bar.end - bar.start)
    ]
    assert len(bracket) == 1 and shape(bracket[0]).distance(shape(block)) < HAIR
    fills = [s for s in found.strokes("shown-position") if isinstance(s, Fill)]
    assert sum(shape(fill).distance(shape(block)) < HAIR for fill in fills) == 2
    offset = found.place.length(abs(float(found.bones.study.form.mechanism.slides[0].offset)))
    assert abs(np.mean(block.points) - circle.centre) == pytest.approx(offset)


def test_a_path_that_is_gone_there_and_back_is_drawn_once() -> None:
    """The point K of the press's arm follows the rocker: what it draws forwards it draws again backwards."""
    found = drawn("toggle press")
    path = found.place.origin + (found.bones.way.points["K"] - found.place.zero) / found.place.scale.mu
    fully = [s for s in found.strokes("paths") if shape(s).distance(shapely.Point(path[0].real, path[0].imag)) < 0.2]
    assert sum(shape(s).length for s in fully) == pytest.approx(np.abs(np.diff(path)).sum() / 2, rel=0.02)


def test_a_swinging_crank_has_its_guide_as_far_as_its_positions_go() -> None:
    """The block of a tangent mechanism is at h tan φ: here of 60 mm, and from -40 to 40 degrees."""
    (travel,) = (ends for slide, ends in drawn("tangent").bones.travels.items() if slide.owner == FRAME)
    assert travel == pytest.approx([share * 0.06 * np.tan(np.radians(40)) for share in (-1, 1)])


def test_a_lever_without_a_pin_has_its_swing_from_slot_to_slot_in_its_extreme_positions() -> None:
    found = drawn("slotted-lever")
    swing = shapely.union_all([shape(part) for part in found.strokes("swing")])
    assert sum(shape(line).distance(swing) < A1.main for line in found.strokes("extremes")) == 2


def test_the_stroke_of_a_point_is_dimensioned_along_the_direction_told() -> None:
    study = LinkageStudy(parse_scene(f'{mechanisms.TOGGLE_PRESS}\n[output]\npoint = "K"\nalong = 30'))
    bones, place = skeletons(study, study.motion(), 2), Place(100 + 100j, 0j, Scale(0.001, "l", "m"))
    (_, dimension, *_) = flat(stroke(bones, place, A1, "en", Ink()))
    assert isinstance(dimension, Line)
    along = np.exp(1j * np.pi / 6)
    size = np.ptp((bones.way.points["K"] * along.conjugate()).real) / place.scale.mu
    assert (dimension.end - dimension.start) / along == pytest.approx(size, rel=1e-4)


def test_hinges_do_not_swallow_a_crank_of_a_hundredth() -> None:
    found = drawn("eccentric")
    first, second = found.circle("O"), found.circle("A")
    assert first.radius + second.radius < abs(first.centre - second.centre)


def test_two_blocks_on_one_pin_are_a_block_and_a_slot_about_the_pin() -> None:
    found = drawn("cross-slide")
    shapes = [s for s in found.strokes("shown-position") if isinstance(s, Polyline)]
    corners = sorted(len(s.points) for s in shapes)
    assert corners[:2] == [4, 4] and corners[2] > 8  # the stone A, the frame's block, and a slot with round ends
    assert sum(abs(complex(np.mean(s.points)) - found.on("D")) < HAIR for s in shapes) == 2


def test_a_dimension_runs_through_no_mark() -> None:
    found = drawn("high centre")
    dimension = shapely.union_all([shape(s) for s in found.strokes("stroke")])
    assert all(shape(s).distance(dimension) > 0.5 for s in found.strokes("pairs") if isinstance(s, Circle))


def test_a_number_on_a_trajectory_joins_no_row_of_a_guide() -> None:
    found = drawn("shaper")
    pin, pairs = found.on("D"), Pairs(found.bones, found.place, A1)
    assert not lone(pin, pairs) and not lone(pin + 5j, pairs) and lone(pin + 20j, pairs)


def test_a_number_along_a_guide_is_nearest_to_its_own_tick_or_led_to_it() -> None:
    found, sheet = drawn("three-lead-press"), Ink(500, 500)
    sheet.draw(found.strokes())
    labels = labels_of(tuple(numbers(Pairs(found.bones, found.place, A1), Labels(sheet, A1.drafted))))
    ticks, along = [found.on("E", k) for k in range(12)], 0
    for tick, label in ((tick, label) for k, tick in enumerate(ticks) for label in labels[str(k)]):
        others = [other for other in ticks if abs(other - tick) > TOGETHER * A1.number]
        own, least = distance([label], [tick]), distance([label], others)
        along += own < 20  # farther off is the crank
        assert own > 20 or own <= least + HAIR
    assert along > 3


def test_a_number_of_a_link_is_nearest_to_its_own_or_led_to_it() -> None:
    """The crank of 5 mm is shorter than the circle with its number, and the rod begins at its end."""
    found, sheet = drawn("eccentric"), Ink(500, 500)
    sheet.draw(found.strokes())
    pairs = Pairs(found.bones, found.place, A1)
    ((ring, _, *led),) = (one.strokes for one in link_numbers(pairs, [1], Labels(sheet, A1.drafted), A1))
    off = {one.link: [shape(Line(*bar)).distance(shape(ring)) for bar in pairs.placed(one)] for one in pairs.outlines}
    assert led or off[1] < off[2]


def test_of_ends_of_vectors_in_a_row_each_has_its_own_letter() -> None:
    ends = {letter: 50 + 50j + 3.0 * k for k, letter in enumerate("abcde")}
    letters = letter_images([(at, [one]) for one, at in ends.items()], A1.letter, Labels(Ink(99, 99), A1.drafted))
    for one, (label,) in labels_of(tuple(letters)).items():
        assert label.leader or distance([label], [ends[one]]) <= distance([label], [*ends.values()]) + HAIR


@pytest.mark.parametrize("marks", [[], [Circle(58 + 50j, 1.0)], [Fill((58 + 53.3j, 57 + 48.3j, 59 + 48.3j))]])
def test_a_leader_runs_along_no_line_and_through_no_mark_or_head(marks: list[Stroke]) -> None:
    """Of two bare places the nearer lies straight along the ray that the pivot's letter should stand on."""
    near, far, sheet = Field(64, 46, 74, 54), Field(46, 70, 54, 82), Ink(100, 100)
    rules = [Line(complex(x, y), complex(x + (0.2 if marks else 1.0), y)) for x in range(99) for y in range(99)]
    sheet.draw([*marks, *(line for line in rules if not any(field.holds(line.start + 0.5) for field in (near, far)))])
    assert any(far.holds(text.at) for text in texts([Labels(sheet, A1.drafted).beside(50 + 50j, "O", 5, 3, 0.0)]))


def test_a_number_is_not_read_as_one_with_letters() -> None:
    sheet, size = Ink(100, 100), Text(20 + 50j, "R_0 = 37,12", 3.5, "start", True)
    sheet.draw([size])
    right = bounds(size)[2]
    (number,) = texts([Labels(sheet, A1.drafted).beside(complex(right + 2.5, 54), "1", 3.5, 1.0, -math.pi / 2)])
    left, bottom, *_ = bounds(number)
    assert left > right + 1.7 or bottom > bounds(size)[3]


def test_a_tiny_crank_circle_is_numbered_on_a_detail() -> None:
    """Of 5 mm beside a rod of 500: every position has its number there, and none where it would not be read."""
    (leaf, *_) = leaves(Study(parse_scene(mechanisms.ECCENTRIC)))
    (detail,) = (group for group in leaf.groups if group.name == "crank")
    assert {str(k) for k in range(12)} <= {text.plain for text in texts([detail])}
    assert not any(text.plain == "7" for group in leaf.groups if group.name == "positions" for text in texts([group]))


AS_LONG = '[[loads.forces]]\non = 3\npoint = "B"\nname = "F_us"\nvalue = 900\nduring = "working stroke"\n' + AGAINST


@pytest.mark.parametrize("load", ["", AS_LONG])
def test_two_halves_of_a_turn_are_not_shown_also_where_a_load_tells_which_is_the_working_one(load: str) -> None:
    """Of a piston in line with its shaft both strokes take 180 degrees, and none is asked for."""
    text = (Path(__file__).parents[1] / "cases/kinematics/v-compressor.toml").read_text("utf-8")
    study = LinkageStudy(parse_scene(f"{text}\n{load}"))
    pairs = Pairs(skeletons(study, study.motion(), 2), Place(100 + 100j, 0j, Scale(0.001, "l", "m")), A1)
    assert phases(pairs, "en") == ()
