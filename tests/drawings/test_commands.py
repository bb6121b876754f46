"""The command: how it ends; its exit codes are a contract."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from drawings.commands import draw as draw_command
from drawings.commands import solve as solve_command
from tests.drawings.conftest import Run

ROOT = Path(__file__).parent.parent.parent
SHAPER = ROOT / "drawings/gallery/shaper.toml"
PLAIN = ROOT / "tests/catalogue/plain.toml"


def process(
    *arguments: object, cwd: Path = ROOT, options: tuple[str, ...] = (), **environment: str
) -> subprocess.CompletedProcess[bytes]:
    """Run the command in a process of its own."""
    command = [sys.executable, *options, "-m", "drawings.commands.process", *map(str, arguments)]
    known = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    return subprocess.run(command, cwd=cwd, env=known, capture_output=True, check=False, timeout=120)


def edited(tmp_path: Path, old: str, new: str) -> Path:
    """Give the shaper's scene with one thing changed."""
    text = SHAPER.read_text("utf-8")
    assert old in text
    scene = tmp_path / "shaper.toml"
    scene.write_text(text.replace(old, new), "utf-8")
    return scene


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["paint", SHAPER],
        ["draw"],
        ["draw", SHAPER, "--fast"],
        ["solve", SHAPER, "--by", "magic"],
        ["solve", SHAPER, "--only", "moments"],
        ["solve", SHAPER, "--only", ""],
        ["explain", SHAPER],
        ["explain", SHAPER, "B", "--position", "two"],
        ["measure"],
        ["explain", "B", SHAPER],
        ["grade", "any.svg", SHAPER],
        ["check", SHAPER],
    ],
    ids=lambda arguments: " ".join(str(getattr(part, "name", part)) for part in arguments) or "nothing",
)
def test_a_wrong_command_line_ends_with_2_and_the_usage(run: Run, arguments: list[object]) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("usage: plandraft")


def test_a_misspelt_key_ends_with_3_and_the_right_spelling(run: Run, tmp_path: Path) -> None:
    scene = edited(tmp_path, "CB = 0.700", "CB = 0.700\n[mechanism.skecth]")
    for command, *more in (["draw", "-o", tmp_path / "out"], ["solve"], ["compare"], ["explain", "B"]):
        code, out, err = run(command, scene, *more)
        assert (code, out) == (3, "")
        assert f"{scene}:" in err
        assert "sketch" in err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("lettering", ["strokes", "text"])
def test_a_letter_that_cannot_be_drawn_ends_with_3_before_anything_is_made(
    run: Run, tmp_path: Path, lettering: str
) -> None:
    scene = tmp_path / "snow.toml"
    words = f'[sheet]\nlettering = "{lettering}"\napproved = "雪 Ivanov"\n'
    scene.write_text(SHAPER.read_text("utf-8").replace("[sheet]\n", words), "utf-8")
    code, out, err = run("draw", scene, "-o", tmp_path / "out")
    assert (code, out) == (3, "")
    where, _, told = err.partition(": sheet.approved: ")
    assert re.fullmatch(rf"{re.escape(str(scene))}:\d+:1", where)
    assert told == "lettering '雪 Ivanov': the alphabet lacks '雪' (U+96EA); write it in other letters\n"
    assert not (tmp_path / "out").exists()


@pytest.mark.rest
def test_texts_are_left_to_the_viewer_where_the_scene_says_so(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "plain.toml"
    scene.write_text(PLAIN.read_text("utf-8") + 'positions = 2\n[sheet]\nlettering = "text"\n', "utf-8")
    assert run("draw", scene, "-o", tmp_path)[0] == 0
    sheet = (tmp_path / "plain-kinematics.svg").read_text("utf-8")
    assert ">Plan of positions</text>" in sheet
    # A text of several levels is a group of one for each.
    assert sheet.count("<text ") > sheet.count("data-text=") == sheet.count("aria-label=") > 100


def test_a_group_without_a_sketch_ends_with_3_and_what_to_add(run: Run, tmp_path: Path) -> None:
    scene = edited(tmp_path, "B = [0.20, 0.32]\nD = [0.40, 0.33]\n", "")
    code, out, err = run("solve", scene)
    assert (code, out) == (3, "")
    assert "sketch" in err


def test_more_positions_than_a_sheet_can_show_end_with_8_but_can_be_solved(run: Run, tmp_path: Path) -> None:
    scene = edited(tmp_path, "positions = 12", "positions = 361")
    code, out, err = run("draw", scene, "-o", tmp_path / "out")
    assert (code, out) == (8, "")
    assert "361" in err
    assert "360" in err
    assert not (tmp_path / "out").exists()
    assert run("solve", scene, "--only", "positions")[0] == 0


def test_a_scene_of_megabytes_ends_with_8(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "huge.toml"
    scene.write_bytes(b"#" * (1 << 20) + b"\n" + SHAPER.read_bytes())
    assert run("solve", scene)[0] == 8


@pytest.mark.parametrize(
    "command", [["draw"], ["solve"], ["compare"], ["explain", "B"], ["measure"]], ids=lambda c: c[0]
)
def test_a_file_that_cannot_be_read_ends_with_7_and_its_name(run: Run, tmp_path: Path, command: list[str]) -> None:
    for path in (tmp_path / "nowhere", tmp_path):
        code, out, err = run(command[0], path, *command[1:])
        assert (code, out) == (7, "")
        assert str(path) in err
        assert len(err.splitlines()) == 1


def test_a_file_that_is_no_sheet_ends_with_7(run: Run, tmp_path: Path) -> None:
    (tmp_path / "sheet.svg").write_bytes(b"%PDF-1.7")
    code, out, err = run("measure", tmp_path / "sheet.svg")
    assert (code, out) == (7, "") and "sheet.svg: this is a PDF" in err


@pytest.mark.parametrize("folder", ["taken", "taken/below"])
def test_a_folder_that_cannot_be_made_ends_with_7(run: Run, tmp_path: Path, folder: str) -> None:
    (tmp_path / "taken").write_text("a file")
    code, out, err = run("draw", SHAPER, "-o", tmp_path / folder)
    assert (code, out) == (7, "")
    assert str(tmp_path / folder) in err
    assert (tmp_path / "taken").read_text() == "a file"


def test_a_bug_of_ours_is_called_one_and_its_traceback_is_kept(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def broken(_: object) -> int:
        raise ZeroDivisionError("a slip of the pen")

    monkeypatch.setattr(solve_command, "run", broken)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    code, out, err = run("solve", SHAPER)
    assert (code, out) == (1, "")
    assert len(err.splitlines()) == 1
    assert "a bug of plandraft" in err
    (kept,) = tmp_path.glob("plandraft-bug-*.txt")
    assert str(kept) in err
    assert "ZeroDivisionError: a slip of the pen" in kept.read_text("utf-8")


def test_a_user_who_stops_it_gets_130(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr(draw_command, "run", stopped)
    assert run("draw", SHAPER) == (130, "", "")


@pytest.mark.parametrize("arguments", [["--help"], ["draw", "--help"], ["--version"]], ids=" ".join)
def test_help_and_version_end_with_0(run: Run, arguments: list[str]) -> None:
    code, out, err = run(*arguments)
    assert (code, err) == (0, "")
    assert "plandraft" in out


def test_the_help_names_every_exit_code(run: Run) -> None:
    told = run("--help")[1]
    assert set(re.findall(r"\b(\d) [a-z]", told.partition("exit codes:")[2])) == set("01234578")


# By a real process


def test_a_reader_that_leaves_early_ends_the_command_quietly(tmp_path: Path) -> None:
    scene = edited(tmp_path, "positions = 12", "positions = 3000")
    command = [sys.executable, "-m", "drawings.commands.process", "solve", str(scene)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        assert running.stdout.read(8) == b'{"scene"'
        running.stdout.close()
        err = running.stderr.read()
        assert running.wait(60) == 7
    assert err == b""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no full device")
def test_a_full_stdout_ends_with_7_and_one_line() -> None:
    with Path("/dev/full").open("wb") as full:
        command = [sys.executable, "-m", "drawings.commands.process", "solve", str(SHAPER)]
        done = subprocess.run(command, cwd=ROOT, stdout=full, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 7
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.skipif(os.name != "posix", reason="closes a stream by the shell")
def test_a_closed_stdout_ends_with_7_and_one_line() -> None:
    command = f"'{sys.executable}' -m drawings.commands.process compare '{SHAPER}' >&-"
    done = subprocess.run(["sh", "-c", command], cwd=ROOT, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 7
    assert len(done.stderr.splitlines()) == 1


def test_a_terminal_without_greek_letters_ends_no_command() -> None:
    done = process("explain", PLAIN, "a_B", "--json", PYTHONIOENCODING="ascii")
    assert "π" in {step["name"] for step in json.loads(done.stdout)}
