"""No scene that was a false alarm of the self-check is one again, nor is a sample of the random mechanisms."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from tests.alarms.drawing import CRASHED, WITHHELD, drawing
from tests.alarms.machines import machine, papered
from tests.alarms.neighbours import neighbour
from tests.gallery import SCENES
from tests.parts import first

SOON = "ram-pushed-evenly"  # the scene that is drawn in the shortest time
CASES = sorted(
    (Path(__file__).parents[1] / "cases" / "alarms").glob("*.toml"), key=lambda path: (path.stem != SOON, path)
)


@pytest.mark.parametrize("path", first(CASES), ids=lambda path: path.stem)
def test_an_earlier_alarm_is_drawn(path: Path) -> None:
    one = drawing((path.stem, path.read_text(encoding="utf-8")))
    assert not one.alarm, one.told


@pytest.mark.rest
@pytest.mark.parametrize("number", first(range(12)))
def test_a_random_mechanism_is_drawn_or_refused(number: int) -> None:
    one = drawing((f"machine-{number}", machine(1, number)))
    assert not one.alarm, one.told


@pytest.mark.rest
@pytest.mark.parametrize("number", first(range(len(SCENES))))
def test_a_neighbour_of_a_scene_is_drawn_or_refused(number: int) -> None:
    one = drawing((f"neighbour-{number}", neighbour(1, number)))
    assert not one.alarm, one.told


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
