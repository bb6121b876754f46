"""The catalogue of scenes that a command must carry to its end: exit code, messages, report and sheet."""

from __future__ import annotations

import re
import time
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

import pytest

from drawings.commands import cli
from drawings.measure.measure import check, measure_file
from plans.scene.source import language_of
from tests.parts import some

SCENES = sorted((Path(__file__).parent / "commands").glob("*.toml"))
HEADER = re.compile(r"# (run|expect|err|report|sheet): ?(.*)|# (run|expect) (.*)")


class End(NamedTuple):
    """How a command must end: which command, exit code, and what must stand where."""

    command: str
    code: int
    says: list[tuple[str, str]]


def header(path: Path) -> End:
    lines = [match for line in path.read_text("utf-8").splitlines() if (match := HEADER.fullmatch(line))]
    given = {match[3]: match[4] for match in lines if match[3]}
    return End(given["run"], int(given["expect"]), [(match[1], match[2]) for match in lines if match[1]])


@pytest.mark.parametrize("path", some(SCENES, 60), ids=lambda path: path.stem)
def test_a_command_ends_as_the_header_of_its_scene_says(
    path: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    end = header(path)
    arguments = [end.command, str(path), *(["-o", str(tmp_path)] if end.command == "draw" else [])]
    began = time.perf_counter()
    code = cli.main(arguments)
    assert time.perf_counter() - began < 60  # a hang, not a speed: about a second on a quiet machine
    out, err = capsys.readouterr()
    assert code == end.code, err
    said = {"err": err}
    drawn = end.command == "draw" and code in (0, 4)
    sheets = [*tmp_path.glob("*.svg")]
    coordinates = {".csv"} if any(sheet.stem.endswith("-profile") for sheet in sheets) else set()
    kept = {".svg", ".md", ".json"} | coordinates
    assert {file.suffix for file in tmp_path.iterdir()} == (kept if drawn else set())
    if drawn:
        for sheet in sheets:
            ET.parse(sheet)
            assert check(measure_file(sheet)) == []
        first = min(sheets, key=lambda sheet: len(sheet.name))
        said |= {"sheet": first.read_text("utf-8"), "report": (tmp_path / f"{path.stem}-report.md").read_text("utf-8")}
    for where, what in end.says:
        assert what in said[where], err
    if not any(where == "err" for where, _ in end.says) and code == 0:
        assert err == ""
    assert bool(out) == (code in (0, 4))
    assert not re.search(r"\b(nan|inf|NaN|Infinity)\b", out + said.get("report", ""))


@pytest.mark.parametrize("path", [path for path in SCENES if language_of(path) == "ru"], ids=lambda path: path.stem)
def test_a_russian_scene_is_answered_in_russian(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cli.main(["solve", str(path)])
    for line in capsys.readouterr().err.splitlines():
        assert re.search(r"[а-яё]{4}", line)
        assert not re.search(r"\b(the|is|to|expected|Fix|note|position|positions)\b", line)


def test_both_languages_are_in_the_catalogue() -> None:
    assert {language_of(path) for path in SCENES} == {"en", "ru"}
