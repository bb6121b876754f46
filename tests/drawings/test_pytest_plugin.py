"""Acceptance: what a test asks of a sheet that is handed in, what it is told, and what it is shown."""

from __future__ import annotations

import base64
import cmath
import math
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from drawings.pytest_plugin.assertions import assert_close_to_analysis, assert_sheet_matches, assert_well_drawn, picture
from drawings.pytest_plugin.assignment import AcceptanceError, Assignment
from drawings.pytest_plugin.handed_sheet import HandedSheet, NotDrawnError, ReadAngle, handed
from tests.drawings.students import TABLED, drawn, task, true_places
from tests.drawings.test_grading import MISTAKES, made
from tests.parts import first

BACK = next(row for row in MISTAKES if row["name"] == "the Coriolis part is turned the wrong way")
UNSCALED = next(row for row in MISTAKES if row["how"] == "unscaled" and row["scene"] == "shaper")


@pytest.fixture(scope="module")
def scene() -> Assignment:
    return Assignment(task("shaper").originals)


@pytest.fixture(scope="module")
def right(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Our own sheet as a student may hand it in: the plans and tables alone."""
    own = task("shaper")
    path = tmp_path_factory.mktemp("right") / "ann.svg"
    plan = own.plan("velocities", 2)
    path.write_bytes(drawn(own.sheet(plan.sheet), plan, true_places(plan), aside=TABLED))
    return path


@pytest.fixture(scope="module")
def wrong(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same with the Coriolis part turned the wrong way."""
    path = tmp_path_factory.mktemp("wrong") / "bob.svg"
    path.write_bytes(made(task("shaper"), BACK, TABLED))
    return path


def true(name: str) -> complex:
    return next(one.true for one in task("shaper").plan("velocities", 2).vectors if one.name == name)


@pytest.mark.parametrize("name", first(["план скоростей", "velocity", "velocities", "Velocities"]))
def test_a_vector_is_asked_for_in_the_words_of_the_trade(right: Path, scene: Assignment, name: str) -> None:
    b = HandedSheet(right, scene).plan(name, position=2).vector("b")
    paper = 2e-4 * task("shaper").plan("velocities", 2).scales["velocities"]
    assert b.value == pytest.approx(true("v_B"), abs=paper)
    assert (b.size, b.unit) == (pytest.approx(abs(true("v_B")), abs=paper), "m/s")
    assert b.angle == pytest.approx(math.degrees(cmath.phase(true("v_B"))) % 360, abs=0.01)
    assert b.angle - 360 * 2 == pytest.approx(math.remainder(b.angle, 360))
    assert ReadAngle(359.9) == pytest.approx(0.1, abs=0.3)
    assert repr(b) == f"b = {b.size:.4g} m/s at {b.angle:.1f}°"
    assert complex(b.x, b.y) == b.value


def test_a_vector_has_several_names(right: Path, scene: Assignment) -> None:
    plan = HandedSheet(right, scene).plan("velocity", 2)
    assert plan.vector("v_B") == replace_name(plan.vector("p b"), "v_B") == replace_name(plan.vector("b"), "v_B")
    between = plan.vector("d b")  # which nobody has drawn
    assert between.value == pytest.approx(plan.vector("b").value - plan.vector("d").value)


def replace_name(vector: object, name: str) -> object:
    return vector._replace(name=name)  # type: ignore[attr-defined]


def test_a_sheet_of_no_known_scene_is_read_by_its_marks(right: Path, scene: Assignment) -> None:
    alone, known = handed(right).plan("velocity", 2), HandedSheet(right, scene).plan("velocity", 2)
    assert alone.vector("p b").value == known.vector("v_B").value
    assert alone.scale == known.scale == pytest.approx(task("shaper").plan("velocities", 2).scales["velocities"])


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        (lambda sheet: sheet.plan("velocity"), 'several plans are called "velocity".*position 2, 9'),
        (lambda sheet: sheet.plan("speed"), 'no plan is called "speed".*acceleration plan, position 2, 9'),
        (lambda sheet: sheet.plan("velocity", 3), 'no plan is called "velocity" on the sheet for position 3'),
        (lambda sheet: sheet.plan("velocity", 2).vector("q"), 'velocity plan, position 2: no "q" is drawn.*v_B'),
    ],
)
def test_what_is_not_there_is_told_with_what_is(
    right: Path, scene: Assignment, asked: Callable[[HandedSheet], object], told: str
) -> None:
    with pytest.raises(NotDrawnError, match=told):
        asked(HandedSheet(right, scene))


def test_a_right_sheet_passes(right: Path, scene: Assignment) -> None:
    assert_close_to_analysis(right, scene, tolerance="2 %")
    assert_well_drawn(HandedSheet(right), scene)


def test_what_is_wrong_is_told_in_true_units_and_shown(wrong: Path, scene: Assignment, tmp_path: Path) -> None:
    sheet = HandedSheet(wrong, scene, tmp_path / "report", "bob")
    with pytest.raises(AssertionError, match=r"bob\.svg: not as the analysis gives it \(tolerance 2 %\)") as failure:
        assert_close_to_analysis(sheet, tolerance="2 %")
    told = str(failure.value)
    assert "a^k_A3A: the Coriolis part is turned the wrong way (out by" in told
    size = abs(next(one.true for one in task("shaper").plan("accelerations", 2).vectors if one.name == "a^k_A3A"))
    said = re.search(r"drawn (\S+) m/s² at (\S+)°, by the analysis (\S+) m/s² at (\S+)°", told)
    assert said is not None
    assert [float(said[1]), float(said[3])] == pytest.approx([size, size], rel=1e-3)
    assert (float(said[2]) - float(said[4])) % 360 == pytest.approx(180, abs=0.2)
    shown = ElementTree.fromstring((tmp_path / "report" / "bob.svg").read_bytes())
    assert "picture: " in told
    assert sum(one.tag.endswith("}line") for one in shown.iter()) == 1


def test_a_student_is_told_no_value(wrong: Path, scene: Assignment) -> None:
    with pytest.raises(AssertionError) as failure:
        assert_close_to_analysis(HandedSheet(wrong, scene, silent=True))
    told = str(failure.value).partition(":\n")[2]
    assert "the Coriolis part is turned the wrong way; look again at" in told
    assert not re.search(r"\d[.,]\d", told)


def test_a_fault_of_drawing_is_no_fault_of_values(tmp_path: Path, scene: Assignment) -> None:
    path = tmp_path / "dan.svg"
    path.write_bytes(made(task("shaper"), UNSCALED, TABLED))
    with pytest.raises(AssertionError, match=r"not drawn as a sheet is drawn:\n.*no scale is written"):
        assert_well_drawn(path, scene)
    assert_close_to_analysis(path, scene)


def test_our_own_sheet_matches_and_an_edited_one_does_not(tmp_path: Path, scene: Assignment) -> None:
    (own, *_) = task("shaper").originals.sheets
    source = task("shaper").originals.drawn(own)
    path = tmp_path / own.name
    path.write_bytes(source + b"\n")  # saved again
    assert_sheet_matches(path, scene)
    path.write_bytes(re.sub(rb"<line [^>]*/>", b"", source, count=1))
    with pytest.raises(AssertionError, match=rf"{own.name}: not as shaper\.toml gives it"):
        assert_sheet_matches(path, scene)


@pytest.mark.parametrize("source", [b"<html><body>log in</body></html>", b"%PDF-1.7", b""])
def test_what_is_no_sheet_fails_with_advice(tmp_path: Path, scene: Assignment, source: bytes) -> None:
    path = tmp_path / "fay.svg"
    path.write_bytes(source)
    with pytest.raises(AssertionError, match=r"fay\.svg: cannot be read: .*Fix:"):
        assert_close_to_analysis(path, scene)
    with pytest.raises(AssertionError, match=r"fay\.svg"):
        assert_sheet_matches(path, scene)
    with pytest.raises(NotDrawnError, match=r"fay\.svg: cannot be read"):
        handed(path).plan("velocity")


def test_what_the_teacher_writes_wrong_is_no_fault_of_a_sheet(right: Path, scene: Assignment) -> None:
    with pytest.raises(AcceptanceError, match="much: no tolerance"):
        assert_close_to_analysis(right, scene, tolerance="much")
    with pytest.raises(AcceptanceError, match="not known of what scene"):
        assert_close_to_analysis(right)
    assert not issubclass(AcceptanceError, AssertionError)


def test_a_picture_shows_the_place_and_nothing_runs_in_it() -> None:
    source = b'<svg xmlns="http://www.w3.org/2000/svg"><script>alert(1)</script></svg>'
    spots = [("an arrow <b>", 100 + 50j, 110 + 50j), ("a letter", 20 + 30j, 20 + 30j)]
    shown = picture(source, (420.0, 297.0), "ann.svg", spots)
    assert b'x1="100.000" y1="247.000" x2="110.000" y2="247.000"' in shown
    assert b'<circle cx="20.000" cy="267.000"' in shown
    assert b"script" not in shown
    assert base64.b64encode(source) in shown
    assert b"an arrow &lt;b&gt;" in shown
