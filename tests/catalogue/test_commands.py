"""The catalogue of scenes that a command must carry to its end: exit code, messages, report and sheet."""

from __future__ import annotations

import re
import time
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from drawings.commands import cli
from drawings.reading.measure import check, measure_file
from plans.scene.source import language_of
from tests.catalogue.scenes import COMMANDS, Row
from tests.parts import some

NAMES = [row.name for row in COMMANDS]
RUSSIAN = [row for row in COMMANDS if 'language = "ru"' in row.text]


@pytest.mark.parametrize("row", some(COMMANDS, 60, NAMES))
def test_a_command_ends_as_the_row_of_its_scene_says(
    row: Row, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, folder, command = row.written(tmp_path), tmp_path / "out", row.given["run"]
    folder.mkdir()
    arguments = [command, str(path), *(["-o", str(folder)] if command == "draw" else [])]
    began = time.perf_counter()
    code = cli.main(arguments)
    assert time.perf_counter() - began < 60  # a hang, not a speed: about a second on a quiet machine
    out, err = capsys.readouterr()
    assert code == row.given.get("code", 0), err
    said = {"says": err}
    drawn = command == "draw" and code in (0, 4)
    sheets = [*folder.glob("*.svg")]
    coordinates = {".csv"} if any(sheet.stem.endswith("-profile") for sheet in sheets) else set()
    kept = {".svg", ".md", ".json"} | coordinates
    assert {file.suffix for file in folder.iterdir()} == (kept if drawn else set())
    if drawn:
        for sheet in sheets:
            ET.parse(sheet)
            assert check(measure_file(sheet)) == []
        first = min(sheets, key=lambda sheet: len(sheet.name))
        said |= {"sheet": first.read_text("utf-8"), "report": (folder / f"{row.name}-report.md").read_text("utf-8")}
    for key in ("says", "report", "sheet"):
        assert all(what in said.get(key, "") for what in row.told(key)), err
    if not row.told("says") and code == 0:
        assert err == ""
    assert bool(out) == (code in (0, 4))
    assert not re.search(r"\b(nan|inf|NaN|Infinity)\b", out + said.get("report", ""))


@pytest.mark.parametrize("row", RUSSIAN, ids=lambda row: row.name)
def test_a_russian_scene_is_answered_in_russian(row: Row, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cli.main(["solve", str(row.written(tmp_path))])
    for line in capsys.readouterr().err.splitlines():
        assert re.search(r"[а-яё]{4}", line)
        assert not re.search(r"\b(the|is|to|expected|Fix|note|position|positions)\b", line)


def test_both_languages_are_in_the_catalogue(tmp_path: Path) -> None:
    assert {language_of(row.written(tmp_path)) for row in COMMANDS} == {"en", "ru"}
