"""Lean: what a command does not need is neither made nor imported; each is asked in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

from drawings.cam.report import chapters
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.gallery import GALLERY

ROOT = Path(__file__).parent.parent.parent
SHAPER = str(ROOT / "drawings/gallery/shaper.toml")
CAMS = ("plans.cam.", "plans.analytic.cam", "plans.cyclogram.", "drawings.cam")
HEAVY = ("mpmath", "scipy", "shapely", "matplotlib")

# Runs the command, then tells which modules it has imported and which plans each study has made.
WATCHED = """
import contextlib, io, json, sys
from drawings.commands import cli
made = []
with contextlib.redirect_stdout(io.StringIO()):
    from plans.linkage.study import LinkageStudy
    begin = LinkageStudy.__init__
    def watched(study, *given):
        begin(study, *given)
        made.append(study.made)
    LinkageStudy.__init__ = watched
    code = cli.main(sys.argv[1:])
    assert code == 0, code
print(json.dumps({"modules": sorted(sys.modules), "made": [list(study) for study in made]}))
"""


def watched(*arguments: object) -> tuple[set[str], set[str]]:
    """Run a command; give the libraries that it imported, and the plans that it made."""
    command = [sys.executable, "-c", WATCHED, *map(str, arguments)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    modules = {*told["modules"], *(name.partition(".")[0] for name in told["modules"])}
    return modules, {plan for study in told["made"] for plan in study}


class Run(NamedTuple):
    """A run of `draw` that was watched: the folder of its sheets, what it imported and what it made."""

    out: Path
    modules: set[str]
    made: set[str]


@pytest.fixture(scope="module")
def draw(tmp_path_factory: pytest.TempPathFactory) -> Run:
    out = tmp_path_factory.mktemp("plain")
    return Run(out, *watched("draw", SHAPER, "-o", out))


def test_positions_alone_need_no_velocities_and_no_paper(tmp_path: Path) -> None:
    scene = tmp_path / "crank.toml"
    scene.write_text(Path(SHAPER).read_text("utf-8").replace('start = "extreme"', "start = 20"), "utf-8")
    modules, made = watched("solve", scene, "--only", "positions")
    assert "positions" in made
    assert not made & {"velocities", "accelerations"}
    assert "numpy" in modules
    assert not modules & {"svgwrite", *HEAVY}


@pytest.mark.parametrize(("scene", "most"), [("crank-rocker", 288), ("turbine", 192)])
def test_a_draw_imports_no_more_of_our_modules_than_it_did(scene: str, most: int, tmp_path: Path) -> None:
    command = "import sys; from drawings.commands import cli; cli.main(sys.argv[1:]); print(*sys.modules, sep='\\n')"
    drawn = ("draw", ROOT / f"drawings/gallery/{scene}.toml", "-o", tmp_path)
    told = subprocess.run(
        [sys.executable, "-c", command, *drawn], cwd=ROOT, capture_output=True, text=True, check=True, timeout=120
    )
    own = [name for name in told.stdout.splitlines() if name.startswith(("geometry", "plans", "drawings"))]
    assert 100 < len(own) <= most


def test_velocities_need_no_accelerations() -> None:
    _, made = watched("solve", SHAPER, "--only", "velocities")
    assert {"positions", "velocities"} <= made
    assert "accelerations" not in made


def test_the_analysis_makes_no_construction(tmp_path: Path) -> None:
    scene = tmp_path / "crank.toml"
    scene.write_text(Path(SHAPER).read_text("utf-8").replace('start = "extreme"', "start = 20"), "utf-8")
    modules, made = watched("solve", scene, "--by", "analysis")
    assert made == set()
    assert not modules & {"svgwrite", *HEAVY}


def test_what_sheets_never_use_of_the_standard_library_is_not_imported_either(draw: Run) -> None:
    unused = {"urllib.request", "http.client", "ssl", "socket", "difflib", "secrets", "importlib.metadata"}
    assert not draw.modules & {*unused, "numpy.random", "numpy.ma", "svgwrite.data.svgparser"}


@pytest.mark.parametrize("arguments", [["--help"], ["draw", "--help"]], ids=" ".join)
def test_help_needs_no_library(arguments: list[str]) -> None:
    lines = "import sys; from drawings.commands import cli\ntry: cli.main(sys.argv[1:])\nfinally: print(*sys.modules)"
    command = [sys.executable, "-c", lines, *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    modules = {name.partition(".")[0] for name in done.stdout.splitlines()[-1].split()}
    assert "drawings" in modules
    assert not modules & {"numpy", "svgwrite", "tomllib", *HEAVY}


def test_drawing_needs_one_pen_and_no_other_library(draw: Run) -> None:
    assert draw.made >= {"positions", "velocities", "accelerations"}
    assert {"numpy", "svgwrite"} <= draw.modules
    assert not draw.modules & set(HEAVY)


def run(*arguments: object) -> tuple[set[str], str]:
    """Run a command with nothing watching it; give the modules that it imported, and what it told on stderr."""
    lines = "import sys; from drawings.commands import cli; cli.main(sys.argv[1:]); print(*sys.modules)"
    command = [sys.executable, "-c", lines, *map(str, arguments)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    return set(done.stdout.splitlines()[-1].split()), done.stderr


def imported(*arguments: object) -> set[str]:
    return run(*arguments)[0]


def test_measuring_a_sheet_needs_no_mechanism(draw: Run) -> None:
    modules = imported("measure", draw.out / "shaper-kinematics.svg")
    assert not modules & {"numpy", "svgwrite", *HEAVY}
    beyond = {name for name in modules if name.startswith("plans.") and not name.startswith("plans.words")}
    assert not beyond  # why a sheet cannot be read is told in words


def test_a_rotor_is_drawn_without_any_linkage(tmp_path: Path) -> None:
    modules = imported("draw", GALLERY / "flywheel.toml", "-o", tmp_path)
    assert "plans.rotor.balancing" in modules
    assert not modules & set(HEAVY)
    others = ("plans.linkage.", "plans.forces.", "drawings.linkage", "drawings.forces", *CAMS)
    assert [name for name in modules if name.startswith(others)] == []


def test_a_linkage_is_drawn_without_any_cam(draw: Run) -> None:
    assert [name for name in draw.modules if name.startswith(CAMS)] == []


def test_a_profile_alone_makes_no_diagrams_of_its_law() -> None:
    text = (GALLERY / "valve-cam.toml").read_text("utf-8")
    study = Study(parse_scene(text.replace('sheets = ["cam", "profile"]', 'sheets = ["profile"]')))
    study.construct()
    chapters(study, {})
    assert study.made == {"sizes", "profile"}
