"""What `solve` and `explain` tell of a bank."""

from __future__ import annotations

import numpy as np
import pytest

from plans.bank.marks import marks
from plans.bank.quantities import numbers
from plans.explanation import NoMark, UnknownMark
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.scenes import scene

SCENE = scene(
    bank='speed = "3000 rpm"; orders = [1, 2]', bank_unit='crank = "40 mm"; rod = "140 mm"; reciprocating = "0.5 kg"',
    bank_members=['crank = 0; place = "-50 mm"', 'crank = 180; place = "50 mm"'],
    bank_compensators=['order = 2; mass = "2 kg"; offset = "60 mm"; shafts = "300 mm"'],
)  # fmt: skip


@pytest.fixture(scope="module")
def study() -> Study:
    return Study.of_all(parse_scene(SCENE))


def test_numbers_of_both_roads(study: Study) -> None:
    ours, theirs = (numbers(study, by).plain()["bank"] for by in ("construction", "analysis"))
    for found in (ours, theirs):
        first, second = (found["harmonics"][order] for order in ("1", "2"))
        assert first["force"] == {"with_crank": [0, 0], "against": [0, 0], "size": 0}
        assert first["moment"]["size"] == pytest.approx(0.1 * first["mechanism"]["size"], rel=1e-14)
        assert second["force"]["size"] == pytest.approx(2 * second["mechanism"]["size"], rel=1e-14)
        assert second["moment"]["size"] == 0
        (one,) = found["compensators"]
        assert one["with_crank"]["radius"] == pytest.approx(one["with_crank"]["moment"] / 2, rel=1e-14)
        assert one["couple"]["moment"] == pytest.approx(0.4 * one["with_crank"]["moment"], rel=1e-14)
        assert 0 < found["left"]["force"] < found["largest"]["force"]
    assert ours["largest"] == pytest.approx(theirs["largest"], rel=1e-13)


@pytest.mark.parametrize("by", ["construction", "analysis"])
def test_the_largest_force_is_that_of_any_position(by: str) -> None:
    """Two cranks 77.3 degrees apart: held against the pistons' accelerations at a million positions."""
    text = SCENE.replace("crank = 180", "crank = 77.3").split("[[bank.compensators]]")[0]
    found = numbers(Study.of_all(parse_scene(text)), by).plain()["bank"]["largest"]
    shaken = [
        -0.5 * acceleration(0.04, 0.14, 100 * np.pi, np.arange(1e6) * 2e-6 * np.pi + at) for at in (0, np.radians(77.3))
    ]
    assert found["force"] == pytest.approx(np.abs(shaken[0] + shaken[1]).max(), rel=1e-11)
    assert found["moment"] == pytest.approx(0.05 * np.abs(shaken[0] - shaken[1]).max(), rel=1e-11)


def acceleration(crank: float, rod: float, speed: float, phi: np.ndarray) -> np.ndarray:
    """Differentiate r cos(phi) + (l2 - r2 sin2(phi))^(1/2) twice."""
    root, down = np.sqrt(rod**2 - (crank * np.sin(phi)) ** 2), crank**2 * np.sin(phi) * np.cos(phi)
    second = -(crank**2) * np.cos(2 * phi) / root - down**2 / root**3
    return np.asarray(speed**2 * (second - crank * np.cos(phi)))


def test_a_harmonic_is_explained_by_its_ordinates(study: Study) -> None:
    told = marks(study, 0, "f_-II")
    assert told.notes == () and told.steps[-1].name == "f_-II"
    assert str(told.steps[1].step.why) == "ordinate: the shaking force at 0 degrees of the crank"


def test_a_couple_is_explained_by_its_compensator(study: Study) -> None:
    told = marks(study, 0, "mr_M,II")
    assert [mark.name for mark in told.steps[-2:]] == ["mr_II", "mr_M,II"]
    assert told.units[told.steps[-1].subject] == "kg*m"


def test_a_mark_that_is_not_there(study: Study) -> None:
    answer = marks(study, 0, "F_I,7")
    assert isinstance(answer, NoMark)
    assert str(answer.listed) == "marks are f_I, F_I, M_I, F_I,1, mr_II" and "M_-II" in answer.names
    with pytest.raises(UnknownMark, match="same in every position"):
        marks(study, 3, "F_I")


def test_a_mark_of_another_technique_draws_no_bank(study: Study) -> None:
    bare = Study.of_all(study.scene)
    assert isinstance(marks(bare, 0, "v_B"), NoMark)
    assert bare.made == frozenset()
