"""Atomic files: a file is either the whole old one or the whole new one, whatever happens in between.

A temporary file in the same folder is written, forced to the disk and closed before it takes the final name.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import stat
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from drawings.paper.limits import ORPHAN_AGE, SWEEP_ENTRIES
from geometry.errors import DraftError
from plans.words.words import ENGLISH, Message, message, placed, words


def json_text(value: object, encoding: str = "utf-8", indent: int | None = None) -> str:
    """Give a value as JSON; letters that the encoding lacks are escaped as JSON does it, all of them together.

    >>> json_text(["ползун"]), json_text(["ползун é"], "latin-1")
    ('["ползун"]', '["\\\\u043f\\\\u043e\\\\u043b\\\\u0437\\\\u0443\\\\u043d \\\\u00e9"]')
    """
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, indent=indent)
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return json.dumps(value, allow_nan=False, indent=indent)
    return text


def print_json(value: object) -> None:
    """Print a value as JSON."""
    print(json_text(value, getattr(sys.stdout, "encoding", None) or "utf-8"))


class Enclosure(NamedTuple):
    """A file beside a sheet: the end of its name after the scene's, its content, and what is wrong with one written."""

    name: str
    content: bytes
    faults: Callable[[bytes], Iterable[Message | str]]


# What to do about a refusal that the system words without advice.
_ADVICE = {errno.ENAMETOOLONG: "file.long_name", errno.EINVAL: "file.irregular_name"}


class FileError(DraftError, OSError):
    """A file that could not be read or written; the old file of that name is whole unless the reason says otherwise."""

    exit_code = 7

    def __init__(self, path: Path, reason: Message) -> None:
        super().__init__(placed(path, reason))
        self.path = path
        self.reason = reason


@contextlib.contextmanager
def stating_path(path: Path, what: str) -> Iterator[None]:
    """Tell of a file what the system refused to do with it, by the key of that."""
    try:
        yield
    except FileError:
        raise
    except OSError as error:
        advice = _ADVICE.get(error.errno or 0)
        raise FileError(path, message(what, reason=message(advice) if advice else of_system(error))) from error
    except ValueError:  # a NUL in a path
        raise FileError(path, message(what, reason=message("file.null"))) from None


def of_system(error: OSError) -> object:
    """Give what the system says of a file: by its number, or in its own words where it has another."""
    key = f"errno.{errno.errorcode.get(error.errno or 0, '')}"
    return message(key) if key in words(ENGLISH) else error.strerror or str(error)


BUSY = message("file.busy")

if sys.platform == "win32":
    # A file that only one process can make, and that vanishes with its handle, also when the process is killed.
    _TAKEN: tuple[type[OSError], ...] = (FileExistsError, PermissionError)

    def _hold(folder: Path) -> int:
        return os.open(folder / ".plandraft.lock", os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_TEMPORARY)

else:
    import fcntl

    _TAKEN = (BlockingIOError,)

    def _hold(folder: Path) -> int:
        handle = os.open(folder, os.O_RDONLY)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BaseException:
            os.close(handle)
            raise
        return handle


@contextlib.contextmanager
def locked(folder: Path) -> Iterator[bool]:
    """Keep other runs out of a folder, or be refused at once; tell whether its file system knows locks at all.

    The kernel keeps the lock of the folder itself and drops it with the process: nothing is left that could be stale.
    """
    handle = None
    try:
        handle = _hold(folder)
    except _TAKEN:
        raise FileError(folder, BUSY) from None
    except OSError:  # some network file systems lock no folders
        pass
    try:
        yield handle is not None
    finally:
        if handle is not None:
            with contextlib.suppress(OSError):
                os.close(handle)


PREFIX = ".plandraft-"

_CREATE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
# Seconds between tries where a viewer may hold the target open (Windows); 2.5 s together.
_PATIENCE = (0.1, 0.2, 0.4, 0.8, 1.0) if os.name == "nt" else ()


def write(path: Path, content: bytes) -> None:
    """Write a file whole or not at all; a symlink of that name is replaced, what it points to is not touched."""
    with locked(path.parent), staged({path: content}) as temporaries:
        with stating_path(path, "file.named"):
            rename(temporaries[path], path)
        with stating_path(path, "file.unforced"):
            force_folder(path.parent)


def write_new(path: Path, content: bytes) -> bool:
    """Write a file whole under a name that nothing has yet; tell whether the name was free."""
    with locked(path.parent), staged({path: content}) as temporaries, stating_path(path, "file.written"):
        return _take(temporaries[path], path)


def _take(temporary: Path, path: Path) -> bool:
    """Give a file a name that nothing has, so that no other file can come between the look and the naming."""
    try:
        os.link(temporary, path)
    except FileExistsError:
        return False
    except OSError:  # a file system without links: an empty file takes the name first
        return _take_first(temporary, path)
    return True


def _take_first(temporary: Path, path: Path) -> bool:
    try:
        os.close(os.open(path, _CREATE, 0o600))
    except FileExistsError:
        return False
    try:
        rename(temporary, path)
    except BaseException:
        discard(path)
        raise
    return True


@contextlib.contextmanager
def staged(contents: Mapping[Path, bytes]) -> Iterator[dict[Path, Path]]:
    """Write files under temporary names beside their own, given by these; those left when the block ends vanish."""
    temporaries = {path: temporary_name(path.parent) for path in contents}
    try:
        for path, content in contents.items():
            with stating_path(path, "file.written"):
                check_replaceable(path)
                create(temporaries[path], content)
        yield temporaries
    finally:
        for temporary in temporaries.values():
            discard(temporary)


def check_replaceable(path: Path) -> None:
    """Refuse a name under which there is a device, a pipe or a folder, also through a symlink; OSError says so."""
    with contextlib.suppress(FileNotFoundError):
        regular = stat.S_ISREG(path.stat().st_mode)
        stream = path.is_symlink() and str(path.readlink()).startswith("/proc/")  # /dev/stdout, even into a file
        if stream or not regular:
            raise OSError(errno.EINVAL, "not a regular file")


def prepare(folder: Path) -> int:
    """Make an output folder if there is none, with those above it, and sweep it; give the number of orphans swept."""
    make_folder(folder)
    with locked(folder) as alone:
        return sum(discard(orphan) for orphan in orphans(folder, alone))


def make_folder(folder: Path) -> None:
    """Make a folder and those above it, where there are none."""
    with stating_path(folder, "file.output"):
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except FileExistsError:
            raise FileError(folder, message("file.folder")) from None


def orphans(folder: Path, alone: bool) -> list[Path]:
    """List the temporary files that interrupted runs left; where others may be at work, those of over an hour ago."""
    with stating_path(folder, "file.read"), os.scandir(folder) as entries:
        found = list(islice(entries, SWEEP_ENTRIES + 1))
    if len(found) > SWEEP_ENTRIES:
        return []
    return sorted(Path(entry.path) for entry in found if _is_orphan(entry, 0.0 if alone else ORPHAN_AGE))


def _is_orphan(entry: os.DirEntry[str], age: float) -> bool:
    if not entry.name.startswith(PREFIX):
        return False
    try:
        found = entry.stat(follow_symlinks=False)
    except OSError:
        return False
    ours = not hasattr(os, "getuid") or found.st_uid == os.getuid()
    return stat.S_ISREG(found.st_mode) and ours and (not age or time.time() - found.st_mtime > age)


def temporary_name(folder: Path) -> Path:
    """Give a name that no file of the folder has, short enough for every file system."""
    return folder / f"{PREFIX}{os.urandom(8).hex()}"


def create(temporary: Path, content: bytes) -> None:
    """Write a file that is not there yet and force it to the disk; where that fails, there is none."""
    try:
        _fill(os.open(temporary, _CREATE, 0o600), content)
    except BaseException:
        discard(temporary)
        raise


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


def rename(temporary: Path, path: Path) -> None:
    """Give a file its name, in place of the file that has it."""
    for pause in _PATIENCE:
        with contextlib.suppress(PermissionError):
            temporary.replace(path)
            return
        time.sleep(pause)
    temporary.replace(path)


def force_folder(folder: Path) -> None:
    """A rename is safe from a power cut only when the folder itself is on the disk; Windows has no such call."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def discard(temporary: Path) -> bool:
    """Remove a temporary file if it is still there, and tell whether it was."""
    try:
        temporary.unlink()
    except OSError:
        return False
    return True
