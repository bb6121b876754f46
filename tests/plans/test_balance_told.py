"""What solve and explain tell of a balance: numbers alike by both roads, the mass centre, counterweights in steps."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from geometry.board import at
from plans.balance.marks import marks
from plans.explanation import Explanation, NoMark
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.techniques import techniques
from tests.parts import first
from tests.plans.balanced import ENGINE, FOUR_BAR
from tests.plans.scenes import scene

FULL = scene(balance='aim = "full"', balance_counterweights=["on = 1; mass = 9", "on = 2; mass = 6"])


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
    row = techniques()["balance"]
    study = studied()
    study["balance"].construct(row.plans)
    assert set(study["balance"].made) == set(row.plans)


ASKED_NOTHING = "[balance]\n"
ASKED = scene(balance='aim = "share"; share = "{least}"', balance_counterweights=["on = 1; mass = 20"])


def told(text: str, by: str) -> Any:
    return Study.of_all(parse_scene(text)).numbers("balance", by).plain()["balance"]


def leaves(data: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Give every number of plain data with its path."""
    if isinstance(data, dict | list):
        for key, value in data.items() if isinstance(data, dict) else enumerate(data):
            yield from leaves(value, f"{path}/{key}")
    else:
        yield path, data


@pytest.mark.parametrize("least", first(["force", "reaction"]))
def test_numbers_of_both_roads_are_of_one_form(least) -> None:
    text = ENGINE.format(positions=3) + ASKED.format(least=least)
    ours, theirs = (dict(leaves(told(text, by))) for by in ("construction", "analysis"))
    assert ours.keys() == theirs.keys()
    for path, value in ours.items():
        near = value if isinstance(value, str) else pytest.approx(value, rel=1e-11, abs=1e-11)
        assert theirs[path] == near, path
    assert {"/mass_centre/r/2/1", "/mass_centre/vectors/2/0", "/counterweights/0/centre/0", "/left/B/0"} <= ours.keys()
    assert {"/before/reactions/0-1", "/after/path", "/after/balancing", "/shares/curve/20/reaction"} <= ours.keys()
    assert ours["/after/force"] == pytest.approx(ours[f"/shares/least_{least}/force"], rel=1e-13)


@pytest.mark.rest
def test_numbers_of_a_machine_as_it_is_and_of_one_that_is_balanced_already() -> None:
    """Catalogue J1: what is not needed has a mass of 0, and no place."""
    as_it_is = told(ENGINE.format(positions=3) + ASKED_NOTHING, "analysis")
    assert as_it_is.keys() == {"aim", "mass_centre", "before"}
    away = told(
        ENGINE.format(positions=3).replace("[0, 0]", "[1, 2]").replace("[0.44, 0]", "[1.44, 2]") + ASKED_NOTHING,
        "analysis",
    )
    moved = [[x - 1, y - 2] for x, y in away["mass_centre"]["r"]]
    assert moved == [pytest.approx(row, abs=1e-15) for row in as_it_is["mass_centre"]["r"]]
    rests = ENGINE.format(positions=3).replace("centre = [0.04, 0]", "centre = [0, 0]")
    rests = rests.partition("2 = { mass")[0]
    asks = '[balance]\naim = "full"\n[[balance.counterweights]]\non = 1\nmass = 2\n'
    for by in ("construction", "analysis"):
        (one,) = told(rests + asks, by)["counterweights"]
        assert one == {"on": 1, "mass": 0.0, "moment": [0.0, 0.0], "begin": "O"}
