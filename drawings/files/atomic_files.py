"""Atomic files: a file is either the whole old one or the whole new one, whatever happens in between.

A temporary file in the same folder is written, forced to the disk and closed before it takes the final name.
"""

from __future__ import annotations

import contextlib
import os
import stat
import time
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from drawings.limits import ORPHAN_AGE, SWEEP_ENTRIES
from geometry.errors import DraftError

PREFIX = ".plandraft-"

_CREATE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
# Seconds between tries where a viewer may hold the target open (Windows); 2.5 s together.
_PATIENCE = (0.1, 0.2, 0.4, 0.8, 1.0) if os.name == "nt" else ()


class FileError(DraftError, OSError):
    """A file that could not be written; the old file of that name is whole unless the reason says otherwise."""

    exit_code = 7

    def __init__(self, path: Path, reason: str) -> None:
        super().__init__(f"{path}: {reason}")
        self.path = path
        self.reason = reason


def write(path: Path, content: bytes) -> None:
    """Write a file whole or not at all; a symlink of that name is replaced, what it points to is not touched."""
    with fresh(path, content):
        pass


@contextlib.contextmanager
def fresh(path: Path, content: bytes) -> Iterator[Path]:
    """Write a temporary file for inspection; it takes its final name if the block ends well, and vanishes if not."""
    with _told(path, "cannot be written"):
        temporary = _written(path, content)
    try:
        yield temporary
        with _told(path, "cannot take its name"):
            _rename(temporary, path)
    except BaseException:
        _discard(temporary)
        raise
    with _told(path, "is written and whole, but its folder could not be forced to the disk"):
        _force_folder(path.parent)


def prepare(folder: Path) -> int:
    """Make an output folder (one level) if there is none, and sweep it; give the number of orphans swept."""
    with _told(folder, "cannot be the output folder"):
        folder.mkdir(exist_ok=True)
    return sweep(folder)


def sweep(folder: Path) -> int:
    """Remove temporary files of our own that killed runs left behind over an hour ago; give their number."""
    with _told(folder, "cannot be read"), os.scandir(folder) as entries:
        found = list(islice(entries, SWEEP_ENTRIES + 1))
    if len(found) > SWEEP_ENTRIES:
        return 0
    return sum(_discard(Path(entry.path)) for entry in found if _orphan(entry))


@contextlib.contextmanager
def _told(path: Path, what: str) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise FileError(path, f"{what}: {error.strerror or error}") from error
    except ValueError as error:  # a NUL in a path
        raise FileError(path, f"{what}: {error}") from error


def _written(path: Path, content: bytes) -> Path:
    temporary = path.parent / f"{PREFIX}{os.urandom(8).hex()}"
    handle = os.open(temporary, _CREATE, 0o600)
    try:
        _fill(handle, content)
    except BaseException:
        _discard(temporary)
        raise
    return temporary


def _fill(handle: int, content: bytes) -> None:
    """Write everything and close; closing may be the first to tell of a full disk, so the collector must not do it."""
    try:
        rest = memoryview(content)
        while rest:
            rest = rest[os.write(handle, rest) :]
        if hasattr(os, "fchmod"):
            os.fchmod(handle, 0o666 & ~_umask())
        os.fsync(handle)
    except BaseException:
        with contextlib.suppress(OSError):
            os.close(handle)
        raise
    os.close(handle)


def _umask() -> int:
    """The mask can only be read by setting it; for that moment it is the strictest, never the laxest."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def _rename(temporary: Path, path: Path) -> None:
    for pause in _PATIENCE:
        with contextlib.suppress(PermissionError):
            temporary.replace(path)
            return
        time.sleep(pause)
    temporary.replace(path)


def _force_folder(folder: Path) -> None:
    """A rename is safe from a power cut only when the folder itself is on the disk; Windows has no such call."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _discard(temporary: Path) -> bool:
    """Remove a temporary file if it is still there."""
    try:
        temporary.unlink()
    except OSError:
        return False
    return True


def _orphan(entry: os.DirEntry[str]) -> bool:
    if not entry.name.startswith(PREFIX):
        return False
    try:
        found = entry.stat(follow_symlinks=False)
    except OSError:
        return False
    ours = not hasattr(os, "getuid") or found.st_uid == os.getuid()
    return stat.S_ISREG(found.st_mode) and ours and time.time() - found.st_mtime > ORPHAN_AGE
