"""A file is whole, old or new, and nothing is left beside it."""

import errno
import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

from drawings.files import atomic_files
from geometry.errors import DraftError

OLD, NEW = b"old" * 1000, b"new" * 2000


@pytest.fixture
def sheet(tmp_path: Path) -> Path:
    path = tmp_path / "лист 1.svg"
    path.write_bytes(OLD)
    return path


def beside(path: Path) -> list[str]:
    return sorted(entry.name for entry in path.parent.iterdir() if entry != path)


def test_writes_the_whole_content(sheet: Path) -> None:
    atomic_files.write(sheet, NEW)
    assert sheet.read_bytes() == NEW
    assert beside(sheet) == []


def test_short_writes_are_continued(sheet: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = os.write
    monkeypatch.setattr(os, "write", lambda handle, data: real(handle, bytes(data[:7])))
    atomic_files.write(sheet, NEW)
    assert sheet.read_bytes() == NEW


@pytest.mark.parametrize("step", ["open", "write", "fchmod", "fsync", "close", "replace"])
@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EIO])
def test_a_failing_step_leaves_the_old_file(sheet: Path, monkeypatch: pytest.MonkeyPatch, step: str, code: int) -> None:
    def fail(*_: object, **__: object) -> None:
        raise OSError(code, os.strerror(code))

    with monkeypatch.context() as patched:
        patched.setattr(os, step, fail)
        with pytest.raises(atomic_files.FileError, match=os.strerror(code)) as caught:
            atomic_files.write(sheet, NEW)
    assert isinstance(caught.value, DraftError)
    assert caught.value.path == sheet
    assert sheet.read_bytes() == OLD
    assert beside(sheet) == []


def test_a_disk_that_fills_halfway_leaves_the_old_file(sheet: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real, calls = os.write, []

    def write(handle: int, data: bytes) -> int:
        calls.append(handle)
        if len(calls) > 3:
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(handle, bytes(data[:100]))

    with monkeypatch.context() as patched:
        patched.setattr(os, "write", write)
        with pytest.raises(atomic_files.FileError, match="No space"):
            atomic_files.write(sheet, NEW)
    assert sheet.read_bytes() == OLD
    assert beside(sheet) == []


def test_a_folder_that_cannot_be_forced_says_that_the_file_is_new(sheet: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: Path) -> None:
        raise OSError(errno.EIO, "Input/output error")

    monkeypatch.setattr(atomic_files, "force_folder", fail)
    with pytest.raises(atomic_files.FileError, match="is written and whole"):
        atomic_files.write(sheet, NEW)
    assert sheet.read_bytes() == NEW
    assert beside(sheet) == []


def test_an_inspection_that_fails_withholds_the_file(sheet: Path) -> None:
    def inspect(temporary: Path) -> None:
        assert temporary.read_bytes() == NEW
        assert sheet.read_bytes() == OLD
        raise ValueError("a vector is off")

    with pytest.raises(ValueError, match="a vector is off"), atomic_files.staged({sheet: NEW}) as temporaries:
        inspect(temporaries[sheet])
    assert sheet.read_bytes() == OLD
    assert beside(sheet) == []


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, SystemExit])
def test_an_interruption_leaves_nothing(sheet: Path, interruption: type[BaseException]) -> None:
    with pytest.raises(interruption), atomic_files.staged({sheet: NEW}):
        raise interruption
    assert sheet.read_bytes() == OLD
    assert beside(sheet) == []


def test_a_symlink_is_replaced_and_its_target_left(tmp_path: Path) -> None:
    precious = tmp_path / "precious"
    precious.write_bytes(OLD)
    link = tmp_path / "sheet.svg"
    link.symlink_to(precious)
    atomic_files.write(link, NEW)
    assert not link.is_symlink()
    assert link.read_bytes() == NEW
    assert precious.read_bytes() == OLD


@pytest.mark.parametrize("mask", [0o022, 0o077, 0o000])
def test_the_mode_follows_the_mask(tmp_path: Path, mask: int) -> None:
    before = os.umask(mask)
    try:
        atomic_files.write(tmp_path / "sheet.svg", NEW)
        assert stat.S_IMODE((tmp_path / "sheet.svg").stat().st_mode) == 0o666 & ~mask
    finally:
        assert os.umask(before) == mask


def test_the_temporary_file_is_private_and_near(sheet: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[tuple[str, int]] = []
    real = os.fchmod

    def note(handle: int, mode: int) -> None:
        [name] = beside(sheet)
        seen.append((name, stat.S_IMODE(os.fstat(handle).st_mode)))
        real(handle, mode)

    monkeypatch.setattr(os, "fchmod", note)
    atomic_files.write(sheet, NEW)
    [(name, mode)] = seen
    assert name.startswith(atomic_files.PREFIX)
    assert mode == 0o600


@pytest.mark.parametrize("place", ["missing/sheet.svg", "file/sheet.svg", "folder", "nul\0.svg", "n" * 300])
def test_a_place_that_cannot_be_written_is_said(tmp_path: Path, place: str) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    with pytest.raises(atomic_files.FileError):
        atomic_files.write(tmp_path / place, NEW)
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["file", "folder"]


def test_prepare_makes_all_levels(tmp_path: Path) -> None:
    assert atomic_files.prepare(tmp_path / "a" / "b") == 0
    assert atomic_files.prepare(tmp_path / "a" / "b") == 0
    (tmp_path / "file").touch()
    with pytest.raises(atomic_files.FileError, match=r"file: is a file, and cannot be .* Fix: give a folder"):
        atomic_files.prepare(tmp_path / "file")
    with pytest.raises(atomic_files.FileError, match="Not a directory"):
        atomic_files.prepare(tmp_path / "file" / "b")


@pytest.mark.parametrize(("alone", "left"), [(True, 4), (False, 5)])
def test_sweep_takes_only_files_of_our_own_and_young_ones_only_where_nobody_else_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, alone: bool, left: int
) -> None:
    if not alone:
        monkeypatch.setattr(atomic_files, "_hold", lambda _: os.open(tmp_path / "no lock", os.O_RDONLY))
    old = time.time() - 2 * atomic_files.ORPHAN_AGE
    for name in (f"{atomic_files.PREFIX}old", f"{atomic_files.PREFIX}young", "plandraft-old", ".other-old"):
        (tmp_path / name).touch()
        if name.endswith("old"):
            os.utime(tmp_path / name, (old, old))
    (tmp_path / f"{atomic_files.PREFIX}folder").mkdir()
    (tmp_path / f"{atomic_files.PREFIX}link").symlink_to("plandraft-old")
    assert atomic_files.prepare(tmp_path) == 6 - left
    names = {entry.name for entry in tmp_path.iterdir()}
    assert f"{atomic_files.PREFIX}old" not in names
    assert len(names) == left


def test_a_crowded_folder_is_not_swept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(atomic_files, "SWEEP_ENTRIES", 1)
    for name in ("a", "b"):
        orphan = tmp_path / f"{atomic_files.PREFIX}{name}"
        orphan.touch()
        os.utime(orphan, (0, 0))
    assert atomic_files.prepare(tmp_path) == 0


@pytest.mark.parametrize("kind", ["pipe", "device", "folder", "link to a device", "own stdout"])
def test_what_is_no_regular_file_is_never_replaced(tmp_path: Path, kind: str) -> None:
    place = tmp_path / "schema.json"
    match kind:
        case "pipe":
            os.mkfifo(place)
        case "device":
            place = Path("/dev/null")
        case "folder":
            place.mkdir()
        case "link to a device":
            place.symlink_to("/dev/null")
        case _:
            place.symlink_to("/proc/self/fd/1")
    before = place.lstat()
    with pytest.raises(atomic_files.FileError, match="not a regular file"):
        atomic_files.write(place, NEW)
    assert place.lstat().st_ino == before.st_ino


def test_only_one_run_writes_into_a_folder(sheet: Path) -> None:
    with atomic_files.locked(sheet.parent) as alone:
        assert alone
        with pytest.raises(atomic_files.FileError, match=r"another run of plandraft .* Fix: wait until it ends"):
            atomic_files.write(sheet, NEW)
        assert sheet.read_bytes() == OLD
    atomic_files.write(sheet, NEW)
    assert sheet.read_bytes() == NEW


KILLED = """
import sys
from pathlib import Path
from drawings.files import atomic_files
path, size = Path(sys.argv[1]), 300_000
print("ready", flush=True)
for turn in range(10**9):
    atomic_files.write(path, bytes([65 + turn % 26]) * size)
"""


def test_killed_at_any_moment_the_file_is_whole(tmp_path: Path) -> None:
    sheet = tmp_path / "sheet.svg"
    root = Path(atomic_files.__file__).parents[2]
    for turn in range(10):
        child = subprocess.Popen([sys.executable, "-c", KILLED, str(sheet)], cwd=root, stdout=subprocess.PIPE)
        assert child.stdout is not None
        child.stdout.readline()
        time.sleep(0.02 + 0.0037 * turn)
        child.send_signal(signal.SIGKILL)
        child.wait()
        child.stdout.close()
        if sheet.exists():
            content = sheet.read_bytes()
            assert len(content) == 300_000
            assert content == content[:1] * 300_000
    atomic_files.prepare(tmp_path)
    assert [entry.name for entry in tmp_path.iterdir()] == ["sheet.svg"]
