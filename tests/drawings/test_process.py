"""The process: how it ends when it is told to, and where its streams are full or closed; nothing is left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from drawings.commands import cli
from drawings.files import signals
from tests.drawings.conftest import Run
from tests.parts import first

ROOT = Path(__file__).parent.parent.parent
PLAIN = ROOT / "tests/catalogue/plain.toml"
ROTOR = ROOT / "drawings/gallery/four-masses.toml"  # drawn the soonest
FULL = Path("/dev/full")
COMMAND = (sys.executable, "-c", "from drawings.commands.process import run; run()")
# Draws, and waits where the sheet is measured until it is told to end; says so first.
WAITING = """
import time
from drawings.commands import process; from drawings.checks import verify
own = verify.written
def wait(*told):
    print("measuring", flush=True)
    time.sleep(60)
    return own(*told)
verify.written = wait
process.run()
"""
# Waits while the command is imported, until it is told to end.
IMPORTING = """
import sys, time
class Slow:
    def find_spec(self, name, *_):
        if name == "drawings.commands.cli":
            print("importing", flush=True)
            time.sleep(60)
sys.meta_path.insert(0, Slow())
from drawings.commands.process import run
run()
"""
CODES = {"SIGINT": 130, "SIGTERM": 143, "SIGHUP": 129}

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals and streams of POSIX")


def shell(command: str, *arguments: object) -> subprocess.CompletedProcess[bytes]:
    """Run plandraft by the shell, which opens or closes its streams."""
    line = ["sh", "-c", f'"$@" {command}', "sh", *COMMAND, *map(str, arguments)]
    return subprocess.run(line, cwd=ROOT, capture_output=True, check=False, timeout=60)


@pytest.mark.parametrize("name", first(CODES))
def test_a_run_told_to_end_leaves_nothing_and_says_so_by_its_code(tmp_path: Path, name: str) -> None:
    command = [sys.executable, "-c", WAITING, "draw", str(ROTOR), "-o", str(tmp_path / "a" / "b")]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None and running.stderr is not None
        assert running.stdout.readline() == b"measuring\n"
        assert list((tmp_path / "a" / "b").iterdir())  # temporary files
        running.send_signal(getattr(signal, name))
        assert (running.stderr.read(), running.wait(20)) == (b"", CODES[name])
    assert list(tmp_path.iterdir()) == []


def test_ctrl_c_while_plandraft_is_still_being_imported_shows_no_traceback() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", IMPORTING], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as running:
        assert running.stdout is not None and running.stderr is not None
        assert running.stdout.readline() == b"importing\n"
        running.send_signal(signal.SIGINT)
        assert (running.stderr.read(), running.wait(20)) == (b"", 130)


def test_what_is_done_in_a_moment_is_done_wholly() -> None:
    done = []
    with pytest.raises(KeyboardInterrupt), signals.unstopped():
        signal.raise_signal(signal.SIGINT)
        done.append("all of it")
    assert done == ["all of it"]


@pytest.mark.rest
def test_an_ignored_signal_stays_ignored(tmp_path: Path) -> None:
    """nohup plandraft draw: the terminal may be closed."""
    command = ["sh", "-c", 'trap "" HUP; exec "$@"', "sh", sys.executable, "-c", WAITING.replace("60", "0.2")]
    command += ["draw", str(PLAIN), "-o", str(tmp_path)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None
        assert running.stdout.readline() == b"measuring\n"
        running.send_signal(signal.SIGHUP)
        assert running.wait(20) == 0


@pytest.mark.skipif(not FULL.exists(), reason="this system has no full device")
@pytest.mark.parametrize("arguments", first([["--help"], ["--version"], ["draw", "--help"]]), ids=" ".join)
def test_help_and_version_onto_a_full_device_end_with_7(arguments: list[str]) -> None:
    done = shell(f">{FULL}", *arguments)
    assert done.returncode == 7
    assert done.stderr == b"No space left on device\n"


def test_help_without_any_stdout_ends_with_7() -> None:
    done = shell(">&-", "--help")
    assert (done.returncode, done.stdout) == (7, b"")
    assert done.stderr.startswith(b"standard output is closed")


@pytest.mark.rest
@pytest.mark.parametrize("out", first(["closed", "full"]))
def test_notes_that_nobody_hears_reach_neither_stdout_nor_a_file(tmp_path: Path, out: str) -> None:
    scene = tmp_path / "noted.toml"
    scene.write_text("\ufeff" + PLAIN.read_text("utf-8"), "utf-8")  # its mark is noted
    heard = shell("", "draw", scene, "-o", tmp_path / "heard")
    assert b"note" in heard.stderr
    assert heard.returncode == 0
    unheard = shell({"closed": "2>&-", "full": "2>/dev/full"}[out], "draw", scene, "-o", tmp_path / out)
    assert unheard.returncode == 0
    assert unheard.stdout == heard.stdout.replace(b"/heard/", f"/{out}/".encode())
    for path in (tmp_path / "heard").iterdir():
        assert (tmp_path / out / path.name).read_bytes() == path.read_bytes()


def test_a_fault_that_nobody_hears_is_told_by_the_code() -> None:
    done = shell("2>&-", "solve", "nowhere.toml")
    assert (done.returncode, done.stdout) == (7, b"")
    assert shell("2>&-", "unknown").returncode == 2


@pytest.mark.parametrize("command", first([["measure"], ["draw"], ["solve"]]), ids=lambda c: c[0])
def test_a_pipe_is_refused_at_once(tmp_path: Path, command: list[str]) -> None:
    os.mkfifo(tmp_path / "pipe")
    done = shell("", *command, tmp_path / "pipe")
    assert done.returncode == 7
    assert done.stderr.decode() == f"{tmp_path / 'pipe'}: not a regular file\n"


@pytest.mark.parametrize("place", first(["folder", "pipe", "/dev/null"]))
def test_the_schema_replaces_nothing_but_files(tmp_path: Path, place: str) -> None:
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    before = (tmp_path / place).stat()
    done = shell("", "schema", "-o", tmp_path / place)
    assert done.returncode == 7
    assert b"not a regular file. Fix:" in done.stderr
    assert (tmp_path / place).stat().st_ino == before.st_ino


@pytest.mark.parametrize(("letters", "code"), [(250, 7), pytest.param(240, 0, marks=pytest.mark.rest)])
def test_a_scene_of_a_very_long_name_is_drawn_or_told_to_be_too_long(
    tmp_path: Path, run: Run, letters: int, code: int
) -> None:
    scene = tmp_path / f"{'n' * letters}.toml"
    scene.write_bytes(PLAIN.read_bytes())
    ended, _, err = run("draw", scene, "-o", tmp_path / "out")
    assert ended == code, err
    assert code == 0 or "File name too long. Fix: give the scene's file a shorter name" in err
    assert (tmp_path / "out").exists() == (code == 0)


@pytest.mark.parametrize(
    "command", first([["solve"], ["compare", "--json"], ["explain", "B", "--json"]]), ids=lambda c: c[0]
)
def test_json_has_cyrillic_letters_as_they_are(tmp_path: Path, command: list[str]) -> None:
    scene = tmp_path / "a.toml"
    scene.write_text(PLAIN.read_text("utf-8").replace("Crank-rocker", "Механизм"), "utf-8")
    done = shell("", command[0], scene, *command[1:])
    assert done.returncode == 0
    assert b"\\u04" not in done.stdout
    if command[0] != "explain":
        assert "Механизм" in done.stdout.decode()


def test_a_library_that_cannot_be_read_ends_with_7(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def lost(_: str) -> None:
        raise ImportError("cannot import name 'svg'")

    monkeypatch.setattr(cli, "import_module", lost)
    assert cli.main(["draw", str(PLAIN)]) == 7
    assert "install it again" in capsys.readouterr().err
