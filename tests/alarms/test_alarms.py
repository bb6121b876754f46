"""No scene that was a false alarm of the self-check is one again, nor is a sample of the random mechanisms."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from plans.scene.scene import parse_scene
from tests import parts
from tests.alarms.drawing import CRASHED, WITHHELD, drawing
from tests.alarms.machines import papered
from tests.alarms.neighbours import neighbour
from tests.alarms.scenes import TECHNIQUES, drawn, scene, scenes
from tests.gallery import SCENES
from tests.parts import first

SOON = "ram-pushed-evenly"  # the scene that is drawn in the shortest time
EVERY_DAY = (22, 28, 35, 40, 63, 81, 86, 87, 89, 94)  # of each technique one that is drawn in a short time
WHOLE = range(120)
CASES = sorted(
    (Path(__file__).parents[1] / "cases" / "alarms").glob("*.toml"), key=lambda path: (path.stem != SOON, path)
)
REST = [k for k in WHOLE if k not in EVERY_DAY] if parts.whole else []


@pytest.mark.parametrize("path", first(CASES), ids=lambda path: path.stem)
def test_an_earlier_alarm_is_drawn(path: Path) -> None:
    one = drawing((path.stem, path.read_text(encoding="utf-8")))
    assert not one.alarm, one.told


@pytest.mark.parametrize("number", [*EVERY_DAY, *(pytest.param(k, marks=pytest.mark.rest) for k in REST)])
def test_a_random_scene_is_drawn_or_refused(number: int) -> None:
    made = scene(1, number)
    one = drawing((made.name, made.text))
    assert not one.alarm, one.told


def test_a_scene_of_a_number_is_the_same_alone_and_among_others() -> None:
    found = list(scenes(7, 3, ["cam", "chain"], first=5))
    assert [one.number for one in found] == [7, 8, 17]
    assert found == [scene(7, one.number) for one in found]


def test_scenes_of_all_techniques_are_read() -> None:
    for one in scenes(1, 80, list(TECHNIQUES)):
        assert parse_scene(one.text).sheets, one.name


def test_the_sheets_of_a_scene_are_laid_out_in_memory() -> None:
    made, leaves = drawn(1, 5)
    assert made.technique == "rotor"
    assert [len(own) for own in leaves.values()] == [1]


def test_a_neighbour_differs_in_what_is_measured_alone() -> None:
    same = neighbour(1, 0), neighbour(1, 0)
    own, other = (tomllib.loads(text) for text in (SCENES[0].read_text(encoding="utf-8"), same[0]))
    assert same[0] == same[1]
    assert own.keys() == other.keys()
    first, changed = own["cam"][0], other["cam"][0]
    assert first["follower"]["lift"] != changed["follower"]["lift"]
    assert [one["kind"] for one in first["phases"]] == [one["kind"] for one in changed["phases"]]


def test_what_is_withheld_or_crashes_is_an_alarm(monkeypatch: pytest.MonkeyPatch) -> None:
    for code, outcome in ((5, WITHHELD), (1, CRASHED)):
        monkeypatch.setattr("tests.alarms.drawing.cli.main", lambda _, code=code: code)
        one = drawing(("any", ""))
        assert one.outcome == outcome
        assert one.alarm


def test_a_scene_is_put_on_other_paper() -> None:
    text = 'title = "a"\n[sheet]\nformat = "A1"\ndrawn = "b"\n'
    assert papered(text, {"format": "A4"}).splitlines() == [
        'title = "a"',
        "[sheet]",
        'format = "A4"',
        "",
        'drawn = "b"',
    ]
    assert papered('title = "a"', {"format": "A4"}).endswith('[sheet]\nformat = "A4"\n')
