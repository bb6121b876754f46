"""The report of a machine's motion: tables, methods beside each other, other fluctuations, in both languages."""

from __future__ import annotations

import math

import pytest

from drawings.dynamics.report import chapters, headline, remarks
from drawings.report.report import of_dynamics
from plans.dynamics.cycle import methods
from plans.dynamics.loop import loop
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import several
from tests.plans.dynamics_scenes import PLANING, study, text


def told(made: Study) -> str:
    found = chapters(made, {})
    return "\n".join([*found.subject, *found.values, *found.left_out])


def scene(asked: str = 'fluctuation = "1/25"', language: str = "en") -> Study:
    return study(asked=asked, drive=f'positions = 12\n[sheet]\nlanguage = "{language}"\n')


def test_the_reduction_and_the_exact_flywheel_are_those_of_the_book() -> None:
    """M4.2, M4.9: J(60 deg) = 0.1289878783, J' = 0.07465262898; J0 = 36.73754573, Mertsalov's 36.75686191."""
    lines = told(scene())
    assert "| 2 | 60 | −195.3817189 | 0.1289878783 | 0.07465262898 |" in lines
    assert "| exact, by analysis | 36.73754573 |" in lines


def test_every_fluctuation_has_the_flywheel_of_its_own_tangents() -> None:
    made = scene()
    own = made["dynamics"]
    for parts in (6.25, 12.5, 25, 50, 100):
        wheel = loop(own.cycle, own.task._replace(delta=1 / parts)).flywheel
        assert f"| 1/{parts:g} | {wheel.whole:.10g} | {wheel.inertia:.10g} |" in told(made)


def test_other_methods_from_the_points_of_the_loop() -> None:
    """M4.10: Gutyar's is the loop's own J0; Mertsalov's and the book's by the order of delta and its square."""
    own = scene()["dynamics"]
    found, whole = methods(own.cycle, own.task), own.flywheel.whole
    assert found is not None
    assert found.gutyar == pytest.approx(whole, rel=1e-12)
    assert 0 < abs(found.mertsalov / whole - 1) < 0.04
    assert 0 < abs(found.book / whole - 1) < 0.04**2


@pytest.mark.parametrize(
    ("asked", "said"),
    several(
        [
            ('fluctuation = "1/5"\nshafts = [{ inertia = 40 }]', "heavy enough without a flywheel"),
            ('fluctuation = "1/25"', "the machine would stop"),
            ('fluctuation = "1/40"\nflywheel.diameter = "0.2 m"', "No rim of D = 200"),
            ('fluctuation = "1/25"\nshafts = [{ inertia = 0.4, ratio = 2.5, name = "gear" }]', "gear: 0.4 kg·m²"),
        ],
        2,
    ),
)
def test_what_is_special_is_said_in_words(asked: str, said: str) -> None:
    assert said in told(scene(asked))


def test_without_a_fluctuation_there_is_no_flywheel() -> None:
    lines = told(scene("divisions = 24"))
    assert "Flywheel" not in lines and "M_dr" in lines
    assert headline(scene("divisions = 24")).endswith("N·m")


def test_the_strips_are_those_that_there_are() -> None:
    """The cut sets in and ends at 0.05 of the stroke, between two of the 24 edges: there are edges there too."""
    made = scene()
    count = len(made["dynamics"].cycle.turned) - 1
    assert count > 24
    assert f"By {count} strips" in told(made)


def test_tangents_are_told_by_half_the_square_of_the_speed() -> None:
    """Mean 12.566 rad/s and 1/25 are 12.315 to 12.818 rad/s; the angle on paper depends on the scales."""
    lines = told(scene())
    for name, speed in (("ψ_min", 4 * math.pi * 0.98), ("ψ_max", 4 * math.pi * 1.02)):
        assert f"| {name}, as drawn | {speed**2 / 2:.10g} |" in lines
    assert "| tan ψ, J/(kg·m²) |" in lines and "89.9" not in lines


def test_rounding_is_told_as_nothing() -> None:
    """Weights have no moment where the crank is upright, and no work over a turn, whatever the last digit."""
    lines = told(study("[loads]\ngravity = 9.81\n", "positions = 12")).splitlines()
    cells = [cell.strip() for line in lines if line.startswith("|") for cell in line.split("|")]
    assert "0" in cells
    assert [cell for cell in cells if cell.lstrip("−").startswith("0.0000000000")] == []


@pytest.mark.parametrize(("speed", "way"), several([("120 rpm", "counter-clockwise"), ("-120 rpm", "clockwise")], 9))
def test_rotation_and_working_stroke_are_told_without_forces(speed: str, way: str) -> None:
    lines = told(Study(parse_scene(text().replace("120 rpm", speed))))
    assert f"- Crank: turns {way}\n" in lines
    assert "Working stroke: to the " in lines and "the crank turns 180.0000° over it" in lines
    both = Study(parse_scene(text().replace('["dynamics"]', '["dynamics", "forces"]')))
    assert "Working stroke" not in told(both)


def test_of_loads_that_drive_it_is_asked_whether_their_direction_is_right() -> None:
    drives = study(PLANING.replace('against = "motion"', "direction = 180"))
    assert drives["dynamics"].cycle.net > 0
    assert "has the wrong direction" in headline(drives)
    assert "wrong direction" not in headline(scene())


def test_a_machine_that_would_stop_is_told_so_where_no_flywheel_is_asked_for() -> None:
    """I12: the links alone have too little energy for the cut; a heavy shaft, or a flywheel, has enough."""
    made = scene("divisions = 24")
    assert "the machine would stop within the turn" in told(made)
    assert ["would stop within the turn" in str(line) for line in remarks(made)] == [True]
    for enough in ("shafts = [{ inertia = 40 }]", 'fluctuation = "1/25"'):
        assert remarks(scene(enough)) == []
        assert "would stop within the turn" not in told(scene(enough))


def test_the_russian_report_has_no_english_words() -> None:
    lines = told(scene(language="ru"))
    assert not {"the", "flywheel", "works", "loads", "at", "of"} & set(lines.lower().replace("|", " ").split())


def test_a_scene_that_draws_no_such_sheet_is_told_so() -> None:
    other = parse_scene(text().replace('sheets = ["dynamics"]', 'sheets = ["positions"]'))
    assert of_dynamics(other) == ["- Motion of the machine under its loads: the sheets do not need it."]
    assert remarks(scene()) == []
