"""What `explain` tells of a balance: the mass centre in a position, each counterweight step by step."""

from __future__ import annotations

import pytest

from geometry.board import at
from plans.balance.marks import marks
from plans.explanation import Explanation, NoMark
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.techniques import TECHNIQUES, named
from tests.plans.balanced import ENGINE, FOUR_BAR
from tests.plans.scenes import scene

FULL = scene(
    balance='aim = "full"',
    balance_counterweights=["on = 1; mass = 9", "on = 2; mass = 6"],
)


def studied(text: str = FOUR_BAR.format(positions=12) + FULL, whole: bool = False) -> Study:
    return Study.of_all(parse_scene(text), whole=whole)


def test_balanced_force_is_nothing_but_rounding() -> None:
    found = marks(studied(), 3, "Φ'")
    assert isinstance(found, Explanation)
    assert found.steps[-1] in found.zeros


@pytest.mark.parametrize("name", ["S'", "a_S'"])
def test_a_mass_centre_that_no_vector_leads_to_rests_in_the_shaft(name: str) -> None:
    """Methods M7.6: the engine balanced in full has h_1 = h_2 = 0, and S in O."""
    study = studied(ENGINE.format(positions=12) + FULL.replace("9", "28").replace("6", "16"))
    found = marks(study, 3, name)
    assert isinstance(found, Explanation)
    assert at(found.steps[-1].point, 3) == 0
    none = marks(study, 3, "h_2'")
    assert isinstance(none, NoMark)
    assert "h_2" in none.names and "h_2'" not in none.names


@pytest.mark.parametrize("name", ["A", "Φ_2", "U_3", "nothing", "OS1"])
def test_what_others_explain_or_nobody(name: str) -> None:
    found = marks(studied(), 0, name)
    assert isinstance(found, NoMark)
    assert {"S", "U_1", "U_2", "Φ'"} <= set(found.names)


def test_technique_names_its_marks_and_study() -> None:
    row = TECHNIQUES["balance"]
    assert named(row.marks) is marks
    study = studied()
    study["balance"].construct(row.plans)
    assert set(study["balance"].made) == set(row.plans)
