"""The README in both languages and its pages: commands are those that are checked, scenes are scenes, programs run."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from drawings.commands.parser import parser
from drawings.gallery import index
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from tests import readme_keys
from tests.readme_keys import renewed

ROOT = Path(__file__).parent.parent
GALLERY = ROOT / "drawings/gallery"
README, RUSSIAN, KEYS = (
    file.read_text("utf-8") for file in (ROOT / "README.md", GALLERY / "README.ru.md", GALLERY / "keys.md")
)
BOTH = pytest.mark.parametrize("page", [README, RUSSIAN], ids=["English", "Russian"])
PAGES = (
    *(ROOT / name for name in ("README.md", "tests/README.md", "CHANGELOG.md")),
    *(GALLERY / f"{name}.md" for name in ("README", "README.ru", "keys", "grading", "promises")),
)
LONGEST = 450  # lines that a reader who comes first bears
RUN = ROOT / ".ci/run"
FRAGMENT = "# part of a scene\n"


def blocks(language: str, page: str = README) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)


SCENES = [block for page in (README, RUSSIAN, KEYS) for block in blocks("toml", page) if not block.startswith(FRAGMENT)]


@pytest.mark.parametrize(("page", "scene"), [(README, "shaper"), (RUSSIAN, "conveyor")], ids=["English", "Russian"])
def test_two_console_blocks_run_the_tests_and_draw_a_sheet(page: str, scene: str) -> None:
    test, draw = blocks("console", page)
    assert test.splitlines() == ['python -m pip install ".[test]"', "python -m pytest"]
    assert draw.splitlines() == [f"plandraft draw drawings/gallery/{scene}.toml -o out/"]
    assert f"({scene}-kinematics.svg)" in page.replace("drawings/gallery/", "")


@BOTH
def test_it_is_short(page: str) -> None:
    assert len(page.splitlines()) <= LONGEST


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


def anchors(page: Path) -> set[str]:
    """Give the anchors that readers of Markdown make of the headings of a page."""
    text = re.sub(r"^```.*?^```$", "", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL)
    return {index.anchor(heading) for heading in re.findall(r"^#+ (.+)$", text, re.MULTILINE)}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_link_of_a_page_leads_somewhere(page: Path) -> None:
    links = re.findall(r"\]\((?!https?:)([^)\s#]*)#?([^)\s]*)\)", page.read_text("utf-8"))
    files = [(page.parent / name if name else page, anchor) for name, anchor in links]
    assert [file for file, _ in files if not file.exists()] == []
    assert [(file, anchor) for file, anchor in files if anchor and anchor not in anchors(file)] == []


def test_every_scene_that_a_page_names_is_in_the_gallery() -> None:
    named = {name for page in PAGES for name in re.findall(r"drawings/gallery/([a-z-]+\.\w+)", page.read_text("utf-8"))}
    named |= {
        f"{name}.toml" for page in (README, RUSSIAN) for name in re.findall(r"(?:Scene|Сцена):\s`([a-z-]+)`", page)
    }
    assert {"shaper.toml", "conveyor.toml", "press.toml"} <= named
    assert [name for name in named if not (GALLERY / name).exists()] == []


def test_there_is_a_whole_scene_to_start_from() -> None:
    assert len(SCENES) == 3


@pytest.mark.parametrize("text", SCENES, ids=range(len(SCENES)))
def test_a_scene_of_the_readme_can_be_read_and_studied(text: str, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(text, "utf-8")
    study = LinkageStudy(read_scene(scene))
    assert len(study.turn) > 0
    assert study.motion().gaps == ()


def test_the_cam_of_the_readme_can_be_made_with_each_law_that_it_shows() -> None:
    (text,) = (block for block in blocks("toml", KEYS) if "[[cam]]" in block)
    laws = re.findall(r"`law = (\{.*?\})`", KEYS)
    assert len(laws) == 3
    for law in ('"sine"', *laws):
        (cam,) = parse_scene(text.replace('"sine"', law)).meaning["cam"].cams
        assert cam.phases[0].law.name in law


def test_its_tables_of_keys_are_what_the_keys_themselves_state() -> None:
    found = [match["part"] for match in readme_keys.BLOCK.finditer(KEYS)]
    assert found == [*readme_keys.parts()]
    for part in found:
        assert readme_keys.tabled(part).splitlines()[2:]
    assert renewed(KEYS) == KEYS, "python -m tests.readme_keys writes them anew"


def test_a_wrong_default_in_a_table_of_keys_is_seen() -> None:
    assert renewed(KEYS.replace('| `start` | degrees, or "extreme" | `0` |', "| `start` | degrees | `90` |")) == KEYS


def test_the_program_of_the_readme_runs() -> None:
    (program,) = blocks("python")
    (same,) = blocks("python", RUSSIAN)
    assert [line.split("#")[0] for line in same.splitlines()] == [line.split("#")[0] for line in program.splitlines()]
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    fastest, stroke = map(float, done.stdout.split())
    assert fastest > 0
    assert stroke == pytest.approx(0.48)


@BOTH
def test_every_command_of_the_readme_is_a_command(page: str) -> None:
    told = set(re.findall(r"`plandraft (\w+)", page))
    assert told == set(re.findall(r"^    (\w+)", parser().format_help(), re.MULTILINE))
