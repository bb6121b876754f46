"""What is refused of a rotor: all at once, each with its reason, and what was likely meant."""

from __future__ import annotations

import re

import pytest

from plans.rotor.reading import notes_of
from plans.scene.faults import Fault, SceneError
from plans.scene.scene import parse_scene

MASSES = "masses = [{ moment = 1, angle = 0 }, { moment = 1, angle = 9 }]\n"


def refused(rotor: str) -> list[Fault]:
    with pytest.raises(SceneError) as told:
        parse_scene(f"[rotor]\n{rotor}")
    return list(told.value.faults)


def places(faults: list[Fault]) -> list[str]:
    return [".".join(map(str, fault.path[1:])) for fault in faults]


def test_all_that_is_missing_is_told_at_once_with_its_reason() -> None:
    faults = refused(f'grade = "G6.3"\n{MASSES}planes = [{{ place = 1 }}, {{ radius = 1 }}]\n')
    assert places(faults) == ["speed", "mass", "masses.0.place", "masses.1.place", "planes.1.place"]
    assert ["grade" in fault.expected for fault in faults] == [True, True, False, False, False]
    assert ["two planes" in fault.expected for fault in faults] == [False, False, True, True, True]
    assert all("такой записи нет" in fault.worded("ru") for fault in faults)


def test_what_is_missing_is_told_beside_what_is_wrong() -> None:
    faults = refused("grade = 'G1'\nspeed = 'fast'\nmasses = [{ mass = -1, angle = 0 }, { moment = 1, angel = 0 }]\n")
    assert places(faults) == ["mass", "speed", "masses.0.radius", "masses.0.mass", "masses.1.angel"]


def test_a_misspelt_key_is_not_missed_besides() -> None:
    assert places(refused(f"grade = 'G1'\nsped = 9\nmass = 9\n{MASSES}")) == ["sped"]


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ('"G7"', "G6.3"), ('"G5"', "G6.3"), ('"G3"', "G2.5"), ('"G63"', "G6.3"), ('"G6,3"', "G6.3"), ('"6.3"', "G6.3"),
        ("6.3", "G6.3"), ('"G17"', "G16"), ('"G0"', "G0.4"), ('"G9000"', "G4000"),
    ],
)  # fmt: skip
def test_the_likely_grade_is_advised(written: str, meant: str) -> None:
    (fault,) = refused(f"speed = 1\nmass = 1\ngrade = {written}\n{MASSES}")
    assert f'"{meant}"' in fault.advice


def test_a_rotor_that_stands_is_refused_and_one_that_turns_backward_is_not() -> None:
    (fault,) = refused(f"speed = 0\n{MASSES}")
    assert "other than 0" in fault.expected
    assert parse_scene(f"[rotor]\nspeed = -100\n{MASSES}").has(("rotor", "speed"))


def noted(rotor: str) -> list[tuple[str, str]]:
    notes = list(notes_of(parse_scene(f"[rotor]\n{rotor}")))
    assert all(re.search("[а-я]{3}", note.worded("ru")) for note in notes)
    return list(zip((note.kind for note in notes), places(notes), strict=True))


BALANCED = "{ mass = 1, radius = 0.1, angle = 0, place = 0.2 }, { mass = 1, radius = 0.1, angle = 180, place = 0.2 }"


@pytest.mark.parametrize(
    ("rotor", "notes"),
    [
        (f"masses = [{BALANCED}]\n", []),
        ("masses = [{ mass = 1, radius = 120, angle = 0 }]\n", [("metres", "masses.0.radius")]),
        ('masses = [{ mass = 1, radius = "120 m", angle = 0 }]\n', []),
        ("masses = [{ mass = 1, radius = 19, angle = 0 }]\n", []),
        (f"masses = [{BALANCED}]\nspeed = 9\nbearings = [-100, 0.6]\n", [("enormous", "bearings.0")]),
        (f"masses = [{BALANCED}]\nspeed = 9\nbearings = [-0.1, 0.6]\n", []),
        (f"masses = [{BALANCED}]\nspeed = 9\nmass = 1.9\n", [("light_rotor", "mass")]),
        (f"masses = [{BALANCED}]\nspeed = 9\nmass = 2\n", []),
        (f"masses = [{BALANCED}]\nspeed = 9\n", [("spare_speed", "speed")]),
        (f"masses = [{BALANCED}]\nbearings = [0, 1]\n", [("still_bearings", "bearings")]),
        (f"masses = [{BALANCED}]\nmass = 3\n", [("still_mass", "mass")]),
        (f"masses = [{BALANCED}]\nplanes = [{{ place = 0.0019 }}, {{ place = 0 }}]\n", [("near_planes", "planes")]),
        (f"masses = [{BALANCED}]\nplanes = [{{ place = 0.002 }}, {{ place = 0 }}]\n", []),
    ],
)
def test_what_may_be_a_slip_is_noted(rotor: str, notes: list[tuple[str, str]]) -> None:
    assert noted(rotor) == notes
