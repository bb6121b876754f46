"""Same scene, same bytes: whatever the hash seed, locale, time zone, folder, umask, or the optimiser of the program."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple

import pytest

from tests import homes, parts
from tests.parts import some

ROOT = Path(__file__).parent.parent
NAME, SHEETS = ("slider-crank", ("kinematics", "forces")) if parts.whole else ("crank-rocker", ("kinematics",))
SCENE = (ROOT / f"drawings/gallery/{NAME}.toml").read_text("utf-8")
COMMANDS = (("draw", "-o", "out"), ("solve",), ("solve", "--by", "analysis"), ("compare",))
# Runs several commands in one process, as a program would that uses another locale than ours.
RUNNER = """
import locale, os, sys
if sys.argv[1]:
    try:
        locale.setlocale(locale.LC_ALL, sys.argv[1])
    except locale.Error:
        sys.exit(77)
os.umask(int(sys.argv[2], 8))
from drawings.commands import cli
for command in sys.argv[3:]:
    name, *rest = command.split(" ")
    print(command, cli.main([name, "scene.toml", *rest]), flush=True)
"""
LACKING = 77  # the exit code that stands for a locale that the system does not have


class Surroundings(NamedTuple):
    """What may differ between two machines that draw the same scene."""

    environment: Mapping[str, str]
    options: tuple[str, ...] = ()
    locale: str = ""
    umask: str = "022"
    folder: str = "here"


PLAIN = Surroundings({"PYTHONHASHSEED": "0", "LC_ALL": "C.UTF-8", "TZ": "UTC"}, umask="027")
ODD = {
    "C locale, no UTF-8 mode, another seed and zone, private files": Surroundings(
        {"PYTHONHASHSEED": "1", "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "TZ": "Asia/Tokyo"},
        umask="077",
        folder="сцены и листы",
    ),
    "a program with decimal commas, without asserts": Surroundings(
        {"PYTHONHASHSEED": "2", "TZ": "America/St_Johns"}, ("-O",), "ru_RU.UTF-8", "000"
    ),
    "a Turkish program that takes warnings for errors": Surroundings(
        {"PYTHONHASHSEED": "424242", "TZ": "Europe/Istanbul"}, ("-W", "error"), "tr_TR.UTF-8", folder="a" * 100
    ),
}


@pytest.fixture(scope="module")
def locales(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Give a folder for the locales that the system may lack."""
    return str(tmp_path_factory.mktemp("locales"))


def made(locale: str, locales: str) -> bool:
    """Make a locale, once; where nothing can, the system's own are all there are."""
    path = Path(locales, locale)
    if shutil.which("localedef") and not path.exists():
        command = ["localedef", "-i", path.stem, "-f", "UTF-8", str(path)]
        subprocess.run(command, capture_output=True, check=False, timeout=60)
    return path.exists()


def run(
    folder: Path, around: Surroundings, locales: str, commands: tuple[tuple[str, ...], ...] = COMMANDS
) -> tuple[dict[str, bytes], bytes]:
    """Give the files that the commands write, and what they print, in some surroundings."""
    here = folder / around.folder
    here.mkdir()
    (here / "scene.toml").write_text(SCENE, "utf-8")
    command = [sys.executable, *around.options, "-c", RUNNER, around.locale, around.umask, *map(" ".join, commands)]
    inherited = {
        name: os.environ[name] for name in ("PATH", "SYSTEMROOT", "HOME", "PYTHONPYCACHEPREFIX") if name in os.environ
    }
    environment = {**inherited, "PYTHONPATH": str(ROOT), **around.environment}
    if around.locale and made(around.locale, locales):
        environment["LOCPATH"] = locales
    done = subprocess.run(command, cwd=here, env=environment, capture_output=True, check=False, timeout=120)
    if done.returncode == LACKING:
        pytest.skip(f"this system has no locale {around.locale}")
    assert done.returncode == 0, done.stderr.decode()
    assert done.stderr == b""
    return {path.name: path.read_bytes() for path in sorted((here / "out").iterdir())}, done.stdout


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("reference")


@pytest.fixture(scope="module")
def reference(home: Path, locales: str) -> tuple[dict[str, bytes], bytes]:
    return run(home, PLAIN, locales)


@pytest.mark.part
@pytest.mark.skipif(os.name != "posix", reason="locales of another kind")
@pytest.mark.parametrize("name", some(ODD, 3))
def test_the_same_scene_gives_the_same_bytes_in_any_surroundings(
    name: str, tmp_path: Path, locales: str, reference: tuple[dict[str, bytes], bytes]
) -> None:
    files, printed = run(tmp_path, ODD[name], locales)
    assert set(files) == {*(f"scene-{sheet}.svg" for sheet in SHEETS), "scene-report.md", "scene-manifest.json"}
    assert files == reference[0]
    expected = reference[1]
    if ODD[name].environment.get("LC_ALL") == "C":  # a terminal of ASCII shows other signs by their numbers
        expected = expected.decode("utf-8").encode("ascii", "backslashreplace")
    assert printed == expected


def test_files_have_the_mode_of_the_mask(home: Path, reference: tuple[dict[str, bytes], bytes]) -> None:
    modes = {path.name: path.stat().st_mode & 0o777 for path in (home / PLAIN.folder / "out").iterdir()}
    assert modes == dict.fromkeys(reference[0], 0o640)


def test_files_end_their_lines_with_lf_and_are_utf_8(reference: tuple[dict[str, bytes], bytes]) -> None:
    for data in reference[0].values():
        assert b"\r" not in data
        assert data.decode("utf-8").endswith("\n")


def test_what_a_worker_keeps_of_a_mechanism_is_not_told_of_another_in_its_place_in_memory() -> None:
    kept = homes._kept(lambda shape: shape.size)
    assert [kept(SimpleNamespace(mechanism=object(), size=size)) for size in range(9)] == [*range(9)]
