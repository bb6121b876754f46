"""The wheel: what a user installs is the three packages, the gallery, the command and the licence, and nothing else."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGES = ("geometry", "plans", "drawings")
# What lies beside the sources in a folder that is worked in, and is no part of them.
CACHES = ("__pycache__",)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> zipfile.ZipFile:
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", os.fspath(folder)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    (built,) = folder.glob("*.whl")
    return zipfile.ZipFile(built)


@pytest.fixture(scope="module")
def info(wheel: zipfile.ZipFile) -> str:
    (metadata,) = (name for name in wheel.namelist() if name.endswith(".dist-info/METADATA"))
    return metadata.removesuffix("METADATA")


def sources() -> set[str]:
    found = (file for package in PACKAGES for file in (ROOT / package).rglob("*") if file.is_file())
    paths = {file.relative_to(ROOT) for file in found}
    return {path.as_posix() for path in paths if not set(path.parts) & set(CACHES)}


@pytest.mark.rest
def test_it_holds_every_file_of_the_three_packages_and_nothing_else(wheel: zipfile.ZipFile, info: str) -> None:
    packed = {name for name in wheel.namelist() if not name.startswith(info)}
    assert packed == sources()


@pytest.mark.rest
def test_it_holds_no_tests_and_nothing_of_the_workshop(wheel: zipfile.ZipFile) -> None:
    assert not [name for name in wheel.namelist() if "test" in Path(name).stem or "/." in f"/{name}"]


@pytest.mark.parametrize("package", PACKAGES)
def test_each_package_says_that_it_is_typed(wheel: zipfile.ZipFile, package: str) -> None:
    assert f"{package}/py.typed" in wheel.namelist()


def test_it_holds_the_gallery(wheel: zipfile.ZipFile) -> None:
    packed = {name for name in wheel.namelist() if name.startswith("drawings/gallery/")}
    scenes = {f"drawings/gallery/{file.name}" for file in (ROOT / "drawings/gallery").glob("*.toml")}
    sheets = {f"drawings/gallery/{file.name}" for file in (ROOT / "drawings/gallery").glob("*.svg")}
    assert "drawings/gallery/shaper.toml" in packed
    assert scenes | sheets <= packed


def test_it_installs_the_command_and_the_plugin_of_pytest(wheel: zipfile.ZipFile, info: str) -> None:
    lines = wheel.read(f"{info}entry_points.txt").decode().splitlines()
    assert "plandraft = drawings.commands.process:run" in lines
    assert lines[lines.index("[pytest11]") + 1] == "plandraft = drawings.pytest_plugin.plugin"


def test_it_holds_the_licence_and_says_what_it_needs(wheel: zipfile.ZipFile, info: str) -> None:
    assert wheel.read(f"{info}licenses/LICENSE") == (ROOT / "LICENSE").read_bytes()
    metadata = wheel.read(f"{info}METADATA").decode()
    needed = [line for line in metadata.splitlines() if line.startswith("Requires-Dist:") and "extra ==" not in line]
    assert len(needed) == 3
    assert {line.split()[1].split(">")[0] for line in needed} == {"numpy", "scipy", "svgwrite"}
    assert "Name: plandraft\n" in metadata
