"""The set of one run: whole as it was, or whole as it is now; what an interrupted run left is told and tidied up."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from unittest import mock

import pytest

from drawings import VERSION
from drawings.files import atomic_files, sheet_set
from drawings.files.atomic_files import FileError
from drawings.files.sheet_set import manifest_beside, manifest_of, output_folder, publish, read_manifest
from drawings.reading.seal import digest, seal
from tests.drawings.conftest import Run
from tests.parts import first

ROOT = Path(__file__).parent.parent.parent
PLAIN = ROOT / "tests/catalogue/plain.toml"
OLD = {"shaper-kinematics.svg": b"old sheet", "shaper-kinematics-2.svg": b"old second", "shaper-report.md": b"old"}
NEW = {"shaper-kinematics.svg": b"new sheet", "shaper-report.md": b"new"}


def put(folder: Path, files: dict[str, bytes]) -> list[Path]:
    """Write a set into a folder, as a run does."""
    contents = {folder / name: content for name, content in files.items()}
    with output_folder(folder), atomic_files.staged(contents) as temporaries:
        return publish(folder, manifest_of("shaper.toml", b"a scene", contents), temporaries)


def there(folder: Path) -> dict[str, bytes]:
    """Give the files of a folder, without its manifest, which must fit them; temporary files are there as well."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.name != "shaper-manifest.json"}


def fits(folder: Path) -> bool:
    manifest = read_manifest(folder / "shaper-manifest.json")
    return manifest is not None and manifest.strangers(folder) == []


def failing(number: int) -> Callable[[Path, Path], None]:
    """Fail at the n-th renaming."""
    count, real = [0], atomic_files.rename

    def rename(temporary: Path, path: Path) -> None:
        count[0] += 1
        if count[0] == number:
            raise OSError(5, "Input/output error")
        real(temporary, path)

    return rename


def unlinked(*_: object, **__: object) -> None:
    """Stand for a file system without links."""
    raise OSError(1, "Operation not permitted")


# The manifest


def test_the_manifest_names_scene_version_files_and_seals(tmp_path: Path) -> None:
    sheet = b"<svg>" + seal(b"<svg>", 1)
    put(tmp_path, {"shaper-kinematics.svg": sheet, "shaper-report.md": b"# Report"})
    assert json.loads((tmp_path / "shaper-manifest.json").read_text("utf-8")) == {
        "format": 1,
        "plandraft": VERSION,
        "set": "shaper-manifest.json",
        "scene": {"name": "shaper.toml", "sha256": digest(b"a scene")},
        "files": [
            {"name": "shaper-kinematics.svg", "sha256": digest(sheet), "seal": digest(b"<svg>")},
            {"name": "shaper-report.md", "sha256": digest(b"# Report")},
        ],
    }


def test_a_manifest_is_read_as_it_was_written(tmp_path: Path) -> None:
    manifest = manifest_of("вал.toml", b"a scene", {Path("вал-report.md"): b"# Report"})
    (tmp_path / manifest.name).write_bytes(manifest.content())
    assert "вал-report.md" in manifest.content().decode()
    assert read_manifest(tmp_path / manifest.name) == manifest


@pytest.mark.parametrize("name", ["../thesis.md", "thesis.md", ".shaper-a", "shaper-/a", "shaper-a\\u0000b"])
def test_a_manifest_that_names_files_elsewhere_is_none_of_ours(tmp_path: Path, name: str) -> None:
    path = tmp_path / "shaper-manifest.json"
    manifest = manifest_of("shaper.toml", b"a scene", {Path("shaper-report.md"): b"# Report"})
    path.write_bytes(manifest.content().replace(b"shaper-report.md", name.encode()))
    assert read_manifest(path) is None


@pytest.mark.parametrize("content", [b"", b"{", b"[]", b"null", b'{"format": 2}', b"\xff", b"[" * 100_000])
def test_what_is_no_manifest_is_read_as_none(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "shaper-manifest.json").write_bytes(content)
    assert read_manifest(tmp_path / "shaper-manifest.json") is None


@pytest.mark.parametrize("stem", ["shaper", "shaper-2", "a-kinematics"])
def test_the_manifest_of_a_sheet_is_found_by_its_name(tmp_path: Path, stem: str) -> None:
    sheet = tmp_path / f"{stem}-kinematics-2.svg"
    manifest = manifest_of(f"{stem}.toml", b"", {sheet: b""})
    (tmp_path / manifest.name).write_bytes(manifest.content())
    assert manifest_beside(sheet) == manifest
    assert manifest_beside(tmp_path / f"{stem}-kinematics-3.svg") is None


# A set that takes the place of another


def test_a_set_takes_the_place_of_the_last_and_its_surplus_sheet_goes(tmp_path: Path) -> None:
    assert put(tmp_path, OLD) == []
    assert put(tmp_path, NEW) == [tmp_path / "shaper-kinematics-2.svg"]
    assert there(tmp_path) == NEW
    assert fits(tmp_path)


@pytest.mark.parametrize("lost", ["existing_manifest", "existing_digest"])
def test_where_the_last_set_cannot_be_read_it_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, lost: str) -> None:
    """Otherwise its surplus sheets would stay beside the new set, and nothing would say that they are not of it."""
    put(tmp_path, OLD)

    def unread(_: Path) -> None:
        raise OSError(5, "Input/output error")

    with monkeypatch.context() as patch, pytest.raises(FileError, match="cannot be read: Input/output error"):
        patch.setattr(sheet_set, lost, unread)
        put(tmp_path, NEW)
    assert there(tmp_path) == OLD
    assert fits(tmp_path)


def test_a_surplus_sheet_that_was_changed_is_kept(tmp_path: Path) -> None:
    put(tmp_path, OLD)
    (tmp_path / "shaper-kinematics-2.svg").write_bytes(b"with my own notes")
    assert put(tmp_path, NEW) == []
    assert there(tmp_path) == {**NEW, "shaper-kinematics-2.svg": b"with my own notes"}


# Renamed are the surplus sheet, the sheet, the report and the manifest; without links also what was in their places.
@pytest.mark.parametrize(("number", "linked"), [*((k, True) for k in range(1, 5)), *((k, False) for k in range(1, 7))])
def test_a_renaming_that_fails_puts_all_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, linked: bool
) -> None:
    put(tmp_path, OLD)
    with monkeypatch.context() as patched:
        patched.setattr(sheet_set, "rename", failing(number))
        if not linked:
            patched.setattr(os, "link", unlinked)
        with pytest.raises(FileError, match="Input/output error"):
            put(tmp_path, NEW)
    assert there(tmp_path) == OLD
    assert fits(tmp_path)


@pytest.mark.parametrize("number", range(1, 4))
def test_a_first_set_that_fails_leaves_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int) -> None:
    monkeypatch.setattr(sheet_set, "rename", failing(number))
    with pytest.raises(FileError):
        put(tmp_path / "a" / "b", NEW)
    assert list(tmp_path.iterdir()) == []


def test_where_nothing_can_be_put_back_the_next_run_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put(tmp_path, OLD)

    def broken(temporary: Path, path: Path) -> None:
        if path.name == "shaper-report.md" or there(tmp_path)["shaper-kinematics.svg"] == b"new sheet":
            raise OSError(5, "Input/output error")
        atomic_files.rename(temporary, path)

    with monkeypatch.context() as patched:
        patched.setattr(sheet_set, "rename", broken)
        with pytest.raises(FileError):
            put(tmp_path, NEW)
    with output_folder(tmp_path) as left:
        assert left.torn == (tmp_path / "shaper-manifest.json",)
    assert not [name for name in there(tmp_path) if name.startswith(atomic_files.PREFIX)]


# A run that is killed

KILLED = """
import os, signal, sys
from pathlib import Path
from drawings.files import atomic_files, sheet_set
from tests.drawings.test_sheet_set import NEW, put
count, real = int(sys.argv[2]), sheet_set.rename
def rename(temporary, path):
    global count
    count -= 1
    if not count:
        os.kill(os.getpid(), signal.SIGKILL)
    real(temporary, path)
sheet_set.rename = rename
put(Path(sys.argv[1]), NEW)
"""


@pytest.mark.parametrize("number", first(range(1, 5)))
def test_a_set_that_was_killed_among_its_names_is_finished_by_the_next_run(tmp_path: Path, number: int) -> None:
    put(tmp_path, OLD)
    killed = subprocess.run([sys.executable, "-c", KILLED, str(tmp_path), str(number)], cwd=ROOT, check=False)
    assert killed.returncode == -9
    assert there(tmp_path) != OLD
    with output_folder(tmp_path) as left:
        assert left.finished == (tmp_path / "shaper-manifest.json",)
        assert there(tmp_path) == NEW
        assert fits(tmp_path)
        (said, *_) = map(str, left.faults(tmp_path))
        assert "a run was stopped before all files of this set had their names; they have them now" in said


def test_finishing_that_fails_is_gone_on_with_by_the_run_after(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put(tmp_path, OLD)
    subprocess.run([sys.executable, "-c", KILLED, str(tmp_path), "2"], cwd=ROOT, check=False)
    with monkeypatch.context() as patched:
        patched.setattr(sheet_set, "rename", failing(2))
        with pytest.raises(FileError), output_folder(tmp_path):
            pass
    with output_folder(tmp_path) as left:
        assert left.finished == (tmp_path / "shaper-manifest.json",)
    assert there(tmp_path) == NEW


# By the command


def test_a_second_run_in_a_folder_ends_at_once_with_7(run: Run, tmp_path: Path) -> None:
    with atomic_files.locked(tmp_path):
        code, out, err = run("draw", PLAIN, "-o", tmp_path)
    assert (code, out) == (7, "")
    assert err == f"{tmp_path}: {atomic_files.BUSY}\n"
    assert list(tmp_path.iterdir()) == []


def test_a_run_that_comes_second_leaves_the_folder_that_the_first_has_made(tmp_path: Path) -> None:
    """Both find no folder: the first makes and locks it, and the second, refused, must not take it away again."""
    folder = tmp_path / "out"
    with mock.patch.object(os.path, "lexists", return_value=False), output_folder(folder):
        with pytest.raises(FileError, match="another run"), output_folder(folder):
            pass
        assert folder.is_dir()


def test_the_lock_of_a_killed_run_is_no_lock(tmp_path: Path) -> None:
    lines = "import os, sys; from pathlib import Path; from drawings.files import atomic_files; "
    lines += "held = atomic_files.locked(Path(sys.argv[1])); held.__enter__(); os.kill(os.getpid(), 9)"
    assert subprocess.run([sys.executable, "-c", lines, str(tmp_path)], cwd=ROOT, check=False).returncode == -9
    with atomic_files.locked(tmp_path) as alone:
        assert alone


@pytest.mark.rest
def test_a_sheet_changed_since_is_told_by_measure_and_by_the_next_run(run: Run, tmp_path: Path) -> None:
    assert run("draw", PLAIN, "-o", tmp_path)[2] == ""
    sheet = tmp_path / "plain-kinematics.svg"
    assert run("measure", sheet)[2] == ""
    sheet.write_bytes(sheet.read_bytes().replace(b"</svg>", b"<!-- mine --></svg>"))
    code, _, err = run("measure", sheet)
    assert code == 0
    assert err.startswith(f"{sheet}: does not fit plain-manifest.json")
    code, _, err = run("draw", PLAIN, "-o", tmp_path)
    assert code == 0
    assert err.startswith(f"{sheet}: not as it was drawn")
    assert run("draw", PLAIN, "-o", tmp_path)[2] == ""


@pytest.mark.rest
def test_failures_and_kills_leave_no_set_in_two_halves() -> None:
    """A fiftieth of `python -m tests.catalogue.failures`."""
    command = [sys.executable, "-m", "tests.catalogue.failures", "--kills", "10", "--injections", "10", "--pairs", "1"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith("10 failures, 10 kills, 1 pairs:")
