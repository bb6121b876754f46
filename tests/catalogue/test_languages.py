"""Languages: all that is said is in the scene's; a third one is one file of words beside the others."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from drawings.commands import cli
from drawings.commands.trace import LIBRARIES as KNOWN
from plans.words.words import FOLDER, words
from tests.parts import first

ROOT = Path(__file__).parent.parent.parent
MARK = "Ж"  # begins every word of the third language: a letter of the alphabet that no English word has
PART = re.compile(r"(\{[^{}]*\})")
# What is no phrase: the grammar of a language, and names of letters and units, which a sheet must have room for.
LIBRARIES = {*KNOWN}
GRAMMAR = ("plural", "number", "join", "placed", "unit", "index")

BETWEEN = "\0"  # what two commands say on stdout
# Runs commands one after the other, up to one that fails.
RUNNER = """
import json, sys
from pathlib import Path
from plans.words import words
words.FOLDER = Path(sys.argv[2])
from drawings.commands import cli
for place, command in enumerate(json.loads(sys.argv[1])):
    print(end="\\0" if place else "")
    if code := cli.main(command):
        sys.exit(code)
"""


def marked(phrase: str) -> str:
    """Mark every word of a phrase, but none of its parts."""
    pieces = PART.split(phrase.replace("{{", "\0").replace("}}", "\1"))
    words = (piece if PART.fullmatch(piece) else re.sub(r"[A-Za-z]{2,}", f"{MARK}\\g<0>", piece) for piece in pieces)
    return "".join(words).replace("\0", "{{").replace("\1", "}}")


def translated(entry: object, group: str = "") -> object:
    if isinstance(entry, dict):
        return {key: translated(value, group or key.partition(".")[0]) for key, value in entry.items()}
    if group in GRAMMAR:
        return entry
    return [marked(form) for form in entry] if isinstance(entry, list) else marked(str(entry))


@pytest.fixture(scope="module")
def tongue(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Give what runs plandraft where one file of words more stands beside the others."""
    home = tmp_path_factory.mktemp("third")
    for path in FOLDER.glob("*.json"):
        shutil.copy(path, home)
    (home / "xx.json").write_text(json.dumps(translated(dict(words("en"))), ensure_ascii=False), "utf-8")

    def run(*commands: Sequence[object]) -> subprocess.CompletedProcess[str]:
        ordered = json.dumps([[str(word) for word in command] for command in commands])
        settings = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONIOENCODING": "utf-8"}
        line = [sys.executable, "-c", RUNNER, ordered, str(home)]
        return subprocess.run(line, cwd=home, env=settings, capture_output=True, text=True, check=False)

    return run


def asking(language: str, folder: Path, name: str = "slider-crank") -> Path:
    """Write a scene of the gallery that asks for a language."""
    text = (ROOT / f"drawings/gallery/{name}.toml").read_text("utf-8")
    path = folder / "scene.toml"
    path.write_text(
        re.sub(r"^\[sheet\]$|\Z", f'[sheet]\nlanguage = "{language}"\n', text, count=1, flags=re.M), "utf-8"
    )
    return path


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    return asking("xx", tmp_path)


@pytest.fixture(params=first(["crank-rocker", "slider-crank"]))
def shown(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    return asking("xx", tmp_path, request.param)


def untranslated(text: str) -> set[str]:
    """Give the English words of a text that bear no mark: letters, keys, names of marks and of math's signs aside."""
    text = re.sub(r"\\[a-z]+", "", text)
    return set(re.findall(r"(?<![\w\"./-])[a-z]{4,}(?![\w./=-])", text)) - {"omega", "epsilon", "kappa"}


def test_a_sheet_and_a_report_speak_it(tongue: Callable[..., subprocess.CompletedProcess[str]], shown: Path) -> None:
    done = tongue(("draw", shown, "-o", shown.parent))
    assert (done.returncode, done.stderr) == (0, "")
    report = (shown.parent / "scene-report.md").read_text("utf-8")
    assert f"## {MARK}Structure" in report
    assert untranslated(report.partition("\n")[2]) == set()
    assert f"{MARK}plan" in done.stdout
    assert f"{MARK}Velocity {MARK}plan" in "".join(path.read_text("utf-8") for path in shown.parent.glob("*.svg"))


@pytest.mark.rest
def test_comparison_and_explain_speak_it(tongue: Callable[..., subprocess.CompletedProcess[str]], scene: Path) -> None:
    done = tongue(("compare", scene), ("explain", scene, "a_B"), ("explain", scene, "M_bal", "--all"))
    assert (done.returncode, done.stderr) == (0, "")
    told = done.stdout.split(BETWEEN)
    assert len(told) == 3 and all(MARK in text for text in told)
    assert untranslated(done.stdout) == set()


def test_a_message_speaks_it(tongue: Callable[..., subprocess.CompletedProcess[str]], scene: Path) -> None:
    scene.write_text(scene.read_text("utf-8").replace('"60 rpm"', '"60 rmp"').replace("speed", "speet"), "utf-8")
    done = tongue(("draw", scene, "-o", scene.parent))
    assert done.returncode == 3
    assert f"{MARK}Fix: {MARK}did {MARK}you {MARK}mean" in done.stderr


def test_json_is_english_in_every_language(
    tongue: Callable[..., subprocess.CompletedProcess[str]], scene: Path
) -> None:
    done = tongue(("compare", scene, "--json"), ("explain", scene, "a_B", "--json"), ("solve", scene))
    assert done.returncode == 0 and MARK not in done.stdout
    told = done.stdout.split(BETWEEN)
    assert len(told) == 3
    for text in told:
        json.loads(text)


# Words that only English text has: keys of the scene, letters and units are the same in every language.
ENGLISH = re.compile(r"(?<![\w\"./-])(?!omega|epsilon|kappa|nan)[a-z]{4,}(?![\w./=-])")


MARKS = {"slider-crank": "R_12", "shaper-loaded": "R_12", "four-masses": "R_A"}  # that are explained


REST = (pytest.param(name, marks=pytest.mark.rest) for name in ("shaper-loaded", "slider-crank", "walking-leg"))


@pytest.mark.parametrize("name", ["four-masses", *REST])
def test_a_russian_scene_is_told_in_russian(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, text = asking("ru", tmp_path, name), []
    for arguments in (["draw", "-o", str(tmp_path), "--trace"], ["compare"], ["explain", "--all"]):
        marks = [MARKS.get(name, "a_B")] if arguments[0] == "explain" else []
        cli.main([arguments[0], str(path), *marks, *arguments[1:]])
        text += capsys.readouterr()
    report = (tmp_path / "scene-report.md").read_text("utf-8")
    assert "## Сравнение построения и аналитического расчёта" in report
    lines = [line for line in ("".join(text) + report.partition("\n")[2]).splitlines() if str(tmp_path) not in line]
    assert {
        word
        for line in lines
        for word in ENGLISH.findall(re.sub(r"`.*?`|\[output\]|through = \S+|--all|\\[a-z]+", "", line))
    } <= LIBRARIES
