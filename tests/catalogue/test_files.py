"""The catalogue's rows about what is read and written: standard input, names of files, and formats."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from drawings.commands import cli
from tests.parts import some

PLAIN = (Path(__file__).parent / "plain.toml").read_text("utf-8")


def test_a24_standard_input_is_no_scene(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A scene is a file: - is the name of one, and what comes through a pipe is not waited for."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", io.StringIO(PLAIN))
    assert cli.main(["draw", "-"]) == 7
    assert capsys.readouterr().err == "-: No such file or directory\n"


@pytest.mark.rest
@pytest.mark.parametrize("name", some(["CON", "nul.svg", "aux", "COM1", "dot.", "space "], 6))
def test_c11_a_sheet_is_named_after_its_scene_and_never_bare(name: str, tmp_path: Path) -> None:
    """A device's name with more behind it is no device, and a name ends with .svg or .md."""
    scene, out = tmp_path / f"{name}.toml", tmp_path / "out"
    scene.write_text(PLAIN, "utf-8")
    assert cli.main(["draw", str(scene), "-o", str(out)]) == 0
    assert {file.name for file in out.iterdir() if not file.name.startswith(".")} >= {f"{name}-kinematics.svg"}


@pytest.mark.rest
def test_k16_svg_is_the_only_format(tmp_path: Path) -> None:
    scene, out = tmp_path / "plain.toml", tmp_path / "out"
    scene.write_text(PLAIN, "utf-8")
    assert cli.main(["draw", str(scene), "-o", str(out)]) == 0
    assert {file.suffix for file in out.iterdir() if not file.name.startswith(".")} == {".svg", ".md", ".json"}


@pytest.mark.parametrize("asked", [["--format", "pdf"], ["--format=dxf"]])
def test_k20_no_other_format_can_be_asked_for(
    asked: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene, out = tmp_path / "plain.toml", tmp_path / "out"
    scene.write_text(PLAIN, "utf-8")
    assert cli.main(["draw", str(scene), "-o", str(out), *asked]) == 2
    assert "unrecognized arguments: --format" in capsys.readouterr().err
    assert not out.exists()
