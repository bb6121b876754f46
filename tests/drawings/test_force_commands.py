"""Forces by the command: numbers of both roads, the steps behind a reaction, what is said of jams and of nothing."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.drawings.conftest import Run
from tests.plans.force_cases import ROADS, WORKED, text_of
from tests.plans.scenes import scene

STEEP = scene(
    'title = "Steep rod"; sheets = ["forces"]', frame="O = [0, 0]", links="OA AB B",
    lengths="OA = 0.07; AB = 0.09", slides=["link = 3; along = { through = [0, 0], angle = 0 }"],
    sketch="B = [0.16, 0]", drive="link = 1; speed = 1; start = 7; positions = 12",
    forces=['on = 3; point = "B"; against = "motion"; value = 100'],
    friction='coefficient = 1.0; radius = "1 mm"', sheet='language = "ru"',
)  # fmt: skip
BRACES = str.maketrans("{}", "()")
GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
LOADED = GALLERY / "shaper-loaded.toml"
SHAPER = WORKED["shaper"]


@pytest.fixture
def worked(tmp_path: Path) -> Path:
    scene = tmp_path / "shaper.toml"
    scene.write_text(text_of("shaper"), "utf-8")
    return scene


def numbers(run: Run, *arguments: object) -> dict[str, Any]:
    code, out, _ = run("solve", *arguments)
    assert code == 0
    found: dict[str, Any] = json.loads(out)
    return found


@pytest.mark.parametrize("road", ROADS)
def test_the_worked_example_as_json(run: Run, worked: Path, road: str) -> None:
    told = numbers(run, worked, "--by", road)
    assert told["by"] == road
    assert list(told["reactions"]) == ["0-1", "0-3", "0-5", "1-2", "2-3", "3-4", "4-5"]
    assert told["reactions"]["3-4"]["force"][0] == pytest.approx(SHAPER["3-4"], rel=1e-8)
    assert told["reactions"]["3-4"]["at"][0] == pytest.approx([0.09172883154, 0.3439638474], rel=1e-8)
    assert "moment" not in told["reactions"]["3-4"]  # a hinge has none
    assert told["reactions"]["0-5"]["moment"] == [pytest.approx(0, abs=1e-9)]
    assert told["reactions"]["0-5"]["point"] == "D"
    assert told["balancing"]["moment"] == pytest.approx([SHAPER["moment"]], rel=1e-9)
    assert told["balancing"]["force"][0] == pytest.approx(SHAPER["force"], rel=1e-8)
    assert told["friction"]["2-3"]["power"] == pytest.approx([140.8512356], rel=1e-8)
    assert told["friction"]["2-3"]["share"] == pytest.approx(0.4185536972, rel=1e-8)
    assert told["efficiency"]["instantaneous"] == pytest.approx([0.8832703562], rel=1e-8)
    assert told["efficiency"]["cycle"] is None  # a list of one position is no cycle
    assert told["jams"] == []


def test_only_forces_of_a_scene_on_which_nothing_acts_is_refused_with_advice(run: Run) -> None:
    code, out, err = run("solve", GALLERY / "shaper.toml", "--only", "forces")
    assert (code, out) == (3, "")
    assert "nothing acts on the mechanism. Fix: add [masses]" in err


@pytest.mark.parametrize(
    ("mark", "last"),
    [
        ("R_34", "R_34 [forces]: join"),
        ("P_34", "R_34 [forces]: join"),
        ("R^t_34", "R^t_34 [forces]: balance"),
        ("R_12", "R_12 [forces]: balance"),
        ("Phi_3", "Φ_3 [forces]: turn"),
        ("M^Phi_3", "M^Φ_3 [forces]: couple"),
        ("G_5", "G_5 [forces]: given = (0, -245.25) N"),
        ("M_bal", "M_bal [forces]: moment"),
        ("M_{ур}", "M_bal [forces]: moment"),
        ("P^τ_34", "R^t_34 [forces]: balance"),
        ("h_1", "D(Φ_4) [forces]: moment"),
        ("h′_{1}", "p(Φ_3) [lever]: moment"),
    ],
)
def test_the_steps_behind_a_force_end_with_it(run: Run, worked: Path, mark: str, last: str) -> None:
    code, out, _ = run("explain", worked, mark)
    assert code == 0
    steps = [line for line in out.splitlines() if re.match(r" *\d+\. ", line)]
    assert last in steps[-1]
    assert not any(": meet (" in step and "[forces]" not in step for step in steps)  # the plans below are left out


def test_what_a_table_tells_is_explained_by_what_shows_it_and_by_both_roads(run: Run, worked: Path) -> None:
    code, out, _ = run("explain", worked, "v_{DB}")
    assert code == 0 and out.startswith("v_{DB}, 34 steps")
    assert re.fullmatch(r" *v_\{DB\} = (\S+) m/s by construction, (\S+) m/s by analysis", out.splitlines()[-1])
    assert "d [velocities]: meet" in out


def test_steps_and_results_by_strips_are_told_as_the_sheet_of_the_language_does(run: Run) -> None:
    assert "R^τ_12 [силы]" in (out := run("explain", GALLERY / "pumping-jack.toml", "M_ур")[1]) and "R^t" not in out
    assert re.search(r"\d\)\. активная часть", run("explain", GALLERY / "involute-pair.toml", "ε_α")[1])  # no unit
    last = run("explain", GALLERY / "compressor.toml", "J_мах")[1].splitlines()[-1]
    assert re.search(r"J_мах = 120,99 кг·м² по .* участках, 120,84 кг·м² .* без погрешности", last)


def test_a_force_that_there_is_not_is_refused_with_what_there_is(run: Run, worked: Path) -> None:
    code, _, err = run("explain", worked, "R_35")
    assert code == 3
    assert "also v_B, a_B, omega_3, dS/dt, R_12, M_bal" in err


def test_masses_that_solve_is_asked_for_are_in_use(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(LOADED.read_text("utf-8").replace('sheets = ["forces"]', ""), "utf-8")
    assert "no sheet that is asked for uses this" in run("solve", scene)[2]
    assert "no sheet that is asked for" not in run("solve", scene, "--only", "forces")[2]


def test_a_pair_that_jams_is_named_and_ends_with_4(run: Run, tmp_path: Path) -> None:
    """A short rod leans up to 51 degrees to the guide: with f = 1 a force along it cannot drive the slider."""
    steep = tmp_path / "steep.toml"
    steep.write_text(STEEP.replace("start = 7\n", "").replace('"ru"', '"en"'), "utf-8")
    code, _, err = run("draw", steep, "-o", tmp_path / "out")
    assert code == 4
    assert "pair 0-3 jams by friction in positions" in err
    assert "make the rod longer" in err


def test_all_steps_behind_a_force_go_back_to_the_fixed_points(run: Run, worked: Path) -> None:
    code, out, _ = run("explain", worked, "R_34", "--all")
    assert code == 0
    assert "O: given = (0, 0) m. fixed point" in out and "u0: given = (1, 0). direction" in out
    assert "R_34 [forces]: join" in out


def test_a_diagram_over_lengths_that_is_stretched_to_the_stroke_is_told(run: Run, tmp_path: Path) -> None:
    """A central crank of 100 mm has a stroke of 200 mm; the table of the load ends a millimetre before."""
    press = scene(
        'title = "Press"; sheets = ["forces"]', frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.1; AB = 0.3",
        slides=["link = 3; along = { through = [0, 0], angle = 0 }"], sketch="B = [0.39, 0]",
        drive="link = 1; speed = 1; start = 7; positions = 12",
        forces=['on = 3; point = "B"; against = "motion"; diagram = { travel = [0, "199 mm"], force = [0, 900] }'],
    )  # fmt: skip
    (tmp_path / "press.toml").write_text(press, "utf-8")
    (tmp_path / "exact.toml").write_text(press.replace("199 mm", "200 mm"), "utf-8")
    told = (
        "its diagram covers 199 mm of a stroke of 200 mm, and is stretched to all of it: its lengths count 1.005 times"
    )
    assert told in run("draw", tmp_path / "press.toml", "-o", tmp_path)[1]
    assert "its 199 mm stretched to the stroke of 200 mm" in (tmp_path / "press-forces.svg").read_text("utf-8")
    assert "stretched" not in run("draw", tmp_path / "exact.toml", "-o", tmp_path)[1]


@pytest.mark.parametrize("report", [pytest.param(path, id=path.stem) for path in sorted(GALLERY.glob("*-report.md"))])
def test_what_a_report_works_out_comes_to_what_it_says(report: Path) -> None:
    """Each line `letters = numbers = value` of the kept reports, by the numbers that stand there, to their digits."""
    for line in report.read_text("utf-8").replace("{,}", ".").splitlines():
        worked = re.match(r"- \$(.*?)\\text\{", line)
        plain = worked[1].replace(r"\cdot", "*").replace("^", "**").translate(BRACES) if worked else ""
        parts = plain.replace(" ", "").split("=")
        if len(parts) > 2 and not re.search(r"[^\W\d]|\\|_", "".join(parts[-2:])):
            found, told, size = map(eval, (parts[-2], parts[-1], parts[-2].replace("-", "+")))
            assert abs(found - told) <= 2e-4 * size, line  # five digits of each factor
