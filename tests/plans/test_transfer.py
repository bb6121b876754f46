"""Transfer functions and the turned velocity plan: the five mechanisms of the tasks, worked by hand (theme 5)."""

from __future__ import annotations

from cmath import phase
from math import degrees, pi, radians

import numpy as np
import pytest

from plans.scene.scene import parse_scene
from plans.study import Study
from plans.transfer.quantities import TransferComparison, listed, marks
from plans.transfer.study import TransferStudy
from plans.transfer.turned import loci
from tests.plans.scenes import scene

FOUR_BAR = {
    "frame": "O = [0, 0]; C = [0.35, 0]", "links": "OA AB CB", "lengths": "OA = 0.1; AB = 0.4; CB = 0.3",
    "sketch": "B = [0.39, 0.3]",
}  # fmt: skip
SLIDER_CRANK = {
    "frame": "O = [0, 0]", "links": "OA AB B", "lengths": "OA = 0.06; AB = 0.2", "sketch": "B = [0.2, 0.02]",
    "slides": ["link = 3; along = { through = [0, 0.02], angle = 0 }"],
}  # fmt: skip
SLOTTED = {
    "frame": "O = [0, 0]; C = [0, -0.35]", "links": "OA A CB", "lengths": "OA = 0.12; CB = 0.7",
    "slides": ['link = 2; along = "CB"'], "sketch": "B = [0.01, 0.35]",
}  # fmt: skip
SINE = {
    "frame": "O = [0, 0]", "links": "OA A D", "lengths": "OA = 0.1", "sketch": "D = [0, 0]",
    "slides": [
        "link = 2; along = { link = 3, angle = 0 }",
        "link = 3; along = { through = [0, 0], angle = 90 }; angle = -90",
    ],
}  # fmt: skip
TANGENT = {
    "frame": "O = [0, 0]", "links": "OK A A", "lengths": "OK = 0.4", "sketch": "A = [0.15, 0]",
    "slides": ['link = 2; along = "OK"', "link = 3; along = { through = [0.15, 0], angle = 90 }"],
}  # fmt: skip
SIX_LINK = SLOTTED | {
    "links": "OA A CB BD D",
    "lengths": "OA = 0.12; CB = 0.7; BD = 0.2",
    "slides": ['link = 2; along = "CB"', "link = 5; along = { through = [0, 0.3287856445], angle = 0 }"],
    "sketch": "B = [0.09, 0.34]; D = [0.29, 0.33]",
}


def study_of(mechanism: dict[str, str | list[str]], *angles: float, head: str = 'sheets = ["transfer"]') -> Study:
    drive = f"link = 1; speed = -7; acceleration = 3; positions = [{', '.join(map(str, angles))}]"
    return Study(parse_scene(scene(head, **mechanism, drive=drive)))


# Worked with ten digits: M3.12 at 60 degrees (tangent 20) and theme 5, task 1, at 30.
WORKED = [
    (FOUR_BAR, 60, {"u_21": -0.1230551421, "u_31": 0.2040631384, "u_21'": 0.2714807724, "u_31'": 0.3722872764}),
    (FOUR_BAR, 30, {"u_31": -0.06782214294}),
    (SLIDER_CRANK, 60, {"u_21": -0.1519528713, "S_B'": -0.05681816961, "u_21'": 0.2594521481, "S_B''": -0.02626610002}),
    (SLIDER_CRANK, 30, {"S_B'": -0.03260132991}),
    (SLOTTED, 60, {"u_31": 0.2421846089, "u_31'": 0.05165011261}),
    (SLOTTED, 30, {"u_31": 0.1978759083}),
    (SINE, 60, {"S_D'": 0.05, "S_D''": -0.08660254038}),
    (SINE, 30, {"S_D'": 0.08660254038}),
    (TANGENT, 20, {"S_A'": 0.1698711497, "S_A''": 0.1236560843}),
    (TANGENT, 30, {"S_A'": 0.2}),
    (SIX_LINK, 60, {"u_31": 0.2421846089, "S_D'": -0.1697581816}),
]  # fmt: skip


@pytest.mark.parametrize(("mechanism", "angle", "values"), WORKED)
def test_both_roads_give_the_worked_values_whatever_the_crank_does(mechanism, angle, values):
    compared = study_of(mechanism, angle).of(TransferComparison)
    assert compared.agrees
    found = {one.name: one for one in compared.findings}
    for name, value in values.items():
        for road in (found[name].construction, found[name].analysis):
            assert float(road[0]) == pytest.approx(value, rel=6e-10), name


def test_a_chain_multiplies_its_ratios():
    found = {one.name: float(one.construction[0]) for one in study_of(SIX_LINK, 60).of(TransferComparison).findings}
    assert found["S_D'"] / found["u_31"] == pytest.approx(-0.7009453754, rel=1e-9)


# M3.13: where the images of the turned plan lie; the pole is O, and the crank's a' its end A.
IMAGES = [
    (FOUR_BAR, 60, "b'", 0.008161730877 + 0.06067243978j),
    (FOUR_BAR, 60, "a'", 0.05 + 0.08660254038j),
    (SLIDER_CRANK, 60, "b'", 0.05681816961j),
    (SLOTTED, 60, "a3'", 0.01453107654 + 0.109933176j),
    (SINE, 60, "a3'", 0.05),
    (TANGENT, 20, "a'", 0.1698711497),
]


@pytest.mark.parametrize(("mechanism", "angle", "name", "place"), IMAGES)
def test_the_images_of_the_turned_plan_lie_where_they_were_worked(mechanism, angle, name, place):
    board = study_of(mechanism, angle).of(TransferStudy).turned.board
    assert complex(np.ravel(board[name].point)[0]) == pytest.approx(place, abs=6e-11)


def test_the_stone_slips_by_what_lies_between_its_two_images():
    board = study_of(SLOTTED, 60).of(TransferStudy).turned.board
    slip = complex(np.ravel(board["a3'"].point - board["a'"].point)[0])
    assert abs(slip) == pytest.approx(0.04586441577, rel=6e-10)


# Theme 5, task 1: the position functions at 30 degrees, rad of the output link or m of its point.
PLACES = [
    (FOUR_BAR, 3, radians(79.92059457)),
    (SLIDER_CRANK, "B", 0.2517113678 + 0.02j),
    (SLOTTED, 3, radians(75.77674282)),
    (SINE, "D", 0.05j),
    (TANGENT, "A", 0.15 + 0.08660254038j),
]


@pytest.mark.parametrize(("mechanism", "of", "value"), PLACES)
def test_the_output_is_where_its_position_function_says(mechanism, of, value):
    compared = study_of(mechanism, 30).of(TransferComparison)
    for motion in (compared.construction, compared.analysis):
        found = motion.links[of].angle[0] if isinstance(of, int) else motion.points[of].r[0]
        assert found == pytest.approx(value, rel=6e-10)


def test_the_triangle_of_a_four_bar_has_the_worked_angles():
    study = study_of(FOUR_BAR, 60)
    board = study.of(TransferStudy).turned.board
    assert [marks(study, 0, name).steps[-1].name for name in ("O a'", "a' b'")] == ["a'", "b'"]
    a, b = (complex(np.ravel(board[name].point)[0]) for name in ("a'", "b'"))
    angles = [abs(degrees(phase(turn))) for turn in (b / a, (b - a) / -a, b / (b - a))]
    assert angles == pytest.approx([22.33849477, 28.21061052, 129.4508947], rel=1e-9)
    assert sum(angles) == pytest.approx(180.0)
    assert abs(b) == pytest.approx(0.06121894151, rel=1e-9)


def test_the_sides_are_drawn_along_the_links_and_square_to_the_guides():
    plan = study_of(SLIDER_CRANK, 60).of(TransferStudy).turned
    rod, guide = loci(plan.board["b'"])[::-1]
    assert (rod.step.op, guide.step.op) == ("parallel", "square")
    assert {rod.step.inputs[0].name, guide.step.inputs[0].name} == {"a'", "O"}


BAD = [
    (SLIDER_CRANK, "link = 3; stroke = { from = 0.2, to = 0.25, speed = 0.1 }", "", "a crank that turns"),
    (FOUR_BAR, "link = 1; speed = 1; positions = 12", "positions = [12]", "a position from 0 to 11"),
]


@pytest.mark.parametrize(("mechanism", "drive", "asked", "said"), BAD)
def test_what_has_no_transfer_functions_is_told(mechanism, drive, asked, said):
    text = scene('sheets = ["transfer"]', **mechanism, drive=drive, transfer=asked)
    assert any(said in str(fault) for fault in parse_scene(text).meaning.faults)


def test_the_course_over_the_turn_is_that_of_the_rocker():
    turned = study_of(FOUR_BAR, 0, 90).of(TransferStudy)
    motion = turned.around()
    swing = np.unwrap(motion.links[3].angle)
    back = np.gradient(swing, 2 * pi / 720 * turned.linkage.sense)
    assert np.abs(back - motion.links[3].omega)[2:-2].max() < radians(0.01)


def test_what_rounding_leaves_of_a_rod_that_does_not_turn_is_no_transfer_function():
    square = FOUR_BAR | {"lengths": "OA = 0.1; AB = 0.35; CB = 0.1", "sketch": "B = [0.4, 0.08]"}
    compared = study_of(square, 60, 61).of(TransferComparison)
    assert compared.agrees
    assert [one.name for one in listed(compared)] == ["u_31"]
