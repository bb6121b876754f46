"""What a hand may be out on polygons of vectors: against chance drawings, each slip tried, and reckoned on paper."""

from __future__ import annotations

import math

import numpy as np
import pytest

from geometry.hand_error import POINT
from plans.bank.quantities import bank_by_hand
from plans.cam.numbers import cam_by_hand
from plans.model.rotor import Rotor
from plans.quantity import SLIP, by_hand
from plans.rotor.quantities import compare_rotor
from plans.rotor.study import RotorStudy
from plans.scene.scene import read_scene
from plans.study import Study
from tests import draughtsman
from tests.draughtsman import Draughtsman, copies
from tests.gallery import GALLERY
from tests.plans.rotors import STATIC, masses

DRAWINGS = 2000


@pytest.fixture(scope="module")
def fan() -> RotorStudy:
    rotor: RotorStudy = Study(read_scene(GALLERY / "fan.toml"))["rotor"]
    return rotor


def test_95_of_100_polygons_close_within_what_is_told(fan: RotorStudy) -> None:
    """Both counterweights of a fan, its polygons drawn by chance."""
    scales = {"couples": 0.0004, "unbalances": 0.002}
    told, (first, last) = by_hand(compare_rotor(fan).findings, scales), (one.mark for one in fan.drawing.corrections)
    rows = {plan: np.array([mu]) for plan, mu in scales.items()}
    drawn = copies(Draughtsman(SLIP, rows, DRAWINGS), first, last)
    for name, mark in (("m_ID_I", first), ("m_IID_II", last)):
        off = np.abs(np.abs(np.ravel(drawn[mark])) - abs(complex(mark.point)))
        assert np.quantile(off, 0.95) == pytest.approx(told[name, 0], rel=0.1)


def test_each_slip_tried_by_itself_moves_a_polygon_as_its_rule_says(fan: RotorStudy) -> None:
    scales = {"couples": 0.0004, "unbalances": 0.002}
    ruled, tried = (by_hand(compare_rotor(fan).findings, scales, 0, *by) for by in ((), (draughtsman.slopes,)))
    assert ruled.keys() == tried.keys() == {("ΣmDh", 0), ("ΣmD", 0), ("m_ID_I", 0), ("m_IID_II", 0)}
    assert all(error == pytest.approx(tried[key], rel=1e-5) for key, error in ruled.items())


def test_a_row_of_vectors_is_out_by_the_root_of_their_number() -> None:
    """Sixteen laid end to end, each by up to 0.2 mm in x and in y: along the sum the deviation is 0.2 sqrt(16/3) mm."""
    rotor = RotorStudy(Rotor(masses([("1", "1", 0, "0")] * 16), STATIC))
    told = by_hand(compare_rotor(rotor).findings, {"unbalances": 0.1})
    assert told["ΣmD", 0] == pytest.approx(0.1 * POINT * 0.2 * np.sqrt(16 / 3), rel=0.02)  # a cloud of 1000 ends


def test_a_polygon_of_a_bank_is_out_by_its_members_and_its_mass_by_the_square_of_the_speed() -> None:
    """Four equal vectors of order 2 in line: along the sum the deviation is 0.2 sqrt(4/3) mm."""
    study = Study(read_scene(GALLERY / "four-cylinder-bank.toml"))
    told, bank = bank_by_hand(study.comparison("bank").findings, {"order_forces-2": 10.0}), study["bank"]
    assert told["F_II", 0] == pytest.approx(10.0 * POINT * 0.2 * np.sqrt(4 / 3), rel=0.03)
    assert told["F_-II", 0] == pytest.approx(told["F_II", 0])  # the mirror image
    assert told["mr_II", 0] == pytest.approx(told["F_II", 0] / (2 * bank.task.speed) ** 2, rel=0.01)
    assert told.keys() == {("F_II", 0), ("F_-II", 0), ("mr_II", 0), ("mr_-II", 0)}


@pytest.mark.parametrize("name", ["feed-cam", "rocker-cam"])
def test_95_of_100_diagrams_of_a_cam_give_its_sizes_within_what_is_told(name: str) -> None:
    """The least radius and the largest pressure angle on the rise, by chance: from A to O, and at D."""
    (drawing,) = Study(read_scene(GALLERY / f"{name}.toml"))["cam"].drawings.values()
    own, told = drawing.sizing, cam_by_hand(drawing, {"sizes": 0.001})
    end = next(own.binding).point
    marks = own.start, own.centre, end, own.origin, end.step.inputs[0]
    drawn = copies(Draughtsman(SLIP, {"sizes": np.array([0.001])}, DRAWINGS), *marks)
    start, centre, far, origin, tip = (np.ravel(drawn[one]) for one in marks)
    radius = np.abs(1000 * (np.abs(centre - start) - own.sizes.base))
    assert np.quantile(radius, 0.95) == pytest.approx(told["R_0", 0], rel=0.1)
    way = 1j * (tip - origin) / abs(tip - origin) if own.cam.rocks else 1j
    angle = np.degrees(np.angle((far - centre) / way))
    true = math.degrees(drawing.found.pressure["rise"].value)
    off = np.abs(np.minimum(np.abs(np.abs(angle) - true), np.abs(180 - np.abs(angle) - true)))
    assert np.quantile(off, 0.95) == pytest.approx(told["α_{rise}", 0], rel=0.1)
