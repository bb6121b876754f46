"""The README: its commands are those that are checked, its scenes are scenes, its program runs."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from tests import readme_keys
from tests.readme_keys import renewed

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text("utf-8")
RUN = ROOT / ".ci/run"
FRAGMENT = "# part of a scene\n"


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)


SCENES = [block for block in blocks("toml") if not block.startswith(FRAGMENT)]


def test_two_console_blocks_draw_the_shaper_and_run_the_tests() -> None:
    draw, test = blocks("console")
    assert draw.splitlines() == [
        "python -m pip install .",
        "plandraft draw drawings/gallery/shaper.toml -o out/",
    ]
    assert test.splitlines() == ['python -m pip install ".[test]"', "python -m pytest"]


@pytest.mark.skipif(os.name != "posix", reason="a shell script")
def test_what_is_checked_of_a_clone_is_what_the_readme_says() -> None:
    assert os.access(RUN, os.X_OK)
    shown = subprocess.run([str(RUN), "--show"], capture_output=True, text=True, check=True, timeout=60).stdout
    told = "".join(blocks("console"))
    assert shown.startswith(told)
    checks = shown.removeprefix(told).splitlines()
    folders = "geometry plans drawings tests"
    assert checks == [
        "python -m pytest --whole --every 80",
        "python -m pytest --whole tests/drawings/test_gallery.py",
        f"python -m ruff check {folders}",
        f"python -m ruff format --check {folders}",
        "python -m mypy",
    ]


def test_every_picture_and_file_of_the_readme_exists() -> None:
    named = re.findall(r"\]\(([\w./-]+)\)", README) + re.findall(r"drawings/gallery/[a-z-]+\.\w+", README)
    assert "drawings/gallery/shaper.toml" in named
    assert [name for name in named if not (ROOT / name).exists()] == []


def test_there_is_a_whole_scene_to_start_from() -> None:
    assert SCENES


@pytest.mark.parametrize("text", SCENES, ids=range(len(SCENES)))
def test_a_scene_of_the_readme_can_be_read_and_studied(text: str, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(text, "utf-8")
    study = LinkageStudy(read_scene(scene))
    assert len(study.turn) > 0
    assert study.motion().gaps == ()


def test_the_cam_of_the_readme_can_be_made_with_each_law_that_it_shows() -> None:
    (text,) = (block for block in blocks("toml") if "[[cam]]" in block)
    laws = re.findall(r"`law = (\{.*?\})`", README)
    assert len(laws) == 3
    for law in ('"sine"', *laws):
        (cam,) = parse_scene(text.replace('"sine"', law)).meaning["cam"].cams
        assert cam.phases[0].law.name in law


def test_its_tables_of_keys_are_what_the_keys_themselves_state() -> None:
    found = [match["part"] for match in readme_keys.BLOCK.finditer(README)]
    assert found == [*readme_keys.parts()]
    for part in found:
        assert readme_keys.tabled(part).splitlines()[2:]
    assert renewed(README) == README, "python -m tests.readme_keys writes them anew"


def test_a_wrong_default_in_a_table_of_keys_is_seen() -> None:
    assert (
        renewed(README.replace('| `start` | degrees, or "extreme" | `0` |', "| `start` | degrees | `90` |")) == README
    )


def test_the_program_of_the_readme_runs() -> None:
    (program,) = blocks("python")
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    fastest, stroke = map(float, done.stdout.split())
    assert fastest > 0
    assert stroke == pytest.approx(0.48)


def test_every_command_of_the_readme_is_a_command() -> None:
    told = set(re.findall(r"`plandraft (\w+)", README))
    files = {file.stem for file in (ROOT / "drawings/commands").glob("*.py")} - {
        "__init__",
        "cli",
        "parser",
        "talk",
        "trace",
        "process",
        "stderr",
        "edition",
        "original",
        "sheet_check",
    }
    assert told == files
