"""Standing of a set: whole by seal and manifest, locked by one run at a time, tidied up at a signal."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from types import FrameType
from typing import NamedTuple

from drawings.files.file_error import FileError
from drawings.files.manifest import Manifest, digest_of, manifest_beside
from drawings.paper.limits import SHEET_BYTES
from drawings.reading.seal import digest, sealed
from plans.words.words import Message, message

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


NAMES = ("SIGINT", "SIGTERM", "SIGHUP")  # SIGHUP is unknown to Windows
ENDING = tuple(getattr(signal, name) for name in NAMES if hasattr(signal, name))


class Stopped(BaseException):
    """The run was told to end; `exit_code` is 128 and the number of the signal, as the shell says it."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.exit_code = 128 + number


def raise_signals() -> None:
    """From now on let a signal end the run by an exception; those after the first do not disturb the tidying up."""
    for number in _heard():
        signal.signal(number, _stop)


def _stop(number: int, _: FrameType | None) -> None:
    for other in ENDING:
        signal.signal(other, signal.SIG_IGN)
    raise Stopped(number)


@contextlib.contextmanager
def unstopped() -> Iterator[None]:
    """Let signals wait until the block has ended: what it does is done wholly, and in a moment."""
    waiting: list[int] = []
    try:
        before = {number: signal.signal(number, lambda which, _: waiting.append(which)) for number in _heard()}
    except ValueError:  # another thread than the first: signals do not come here
        before = {}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for which in waiting[:1]:
            signal.raise_signal(which)


def _heard() -> list[signal.Signals]:
    """Give the signals that are not ignored: nohup and shells in the background ask for that."""
    return [number for number in ENDING if signal.getsignal(number) not in (signal.SIG_IGN, None)]


END = b"</svg>"
SEAL = b'id="seal"'


class Flaw(NamedTuple):
    """What is wrong with a file as a file: its kind, and in words."""

    kind: str  # torn, seal, set
    told: Message


def flaws(path: Path, source: bytes) -> Iterator[Flaw]:
    """Tell what is wrong with a sheet as a file: its seal, its set."""
    if len(source) > SHEET_BYTES:  # only its beginning was read, and whoever measures it says so
        return
    yield from _of_seal(source)
    manifest = manifest_beside(path)
    if manifest is not None:
        yield from _of_set(path, source, manifest)


def _of_seal(source: bytes) -> Iterator[Flaw]:
    if sealed(source):
        return
    if not source.rstrip().endswith(END):
        lines = source.count(b"\n") + 1
        yield Flaw("torn", message("checked.torn", bytes=len(source), line=lines))
    else:
        yield Flaw("seal", message("checked.broken" if SEAL in source else "checked.unsealed"))


def _of_set(path: Path, source: bytes, manifest: Manifest) -> Iterator[Flaw]:
    """Tell which files of the set are others than were drawn together, and which are not there."""
    if digest(source) != manifest.files[path.name]:
        yield Flaw("set", message("checked.changed", set=manifest.name))
    for name, stated in manifest.files.items():
        if name != path.name and (found := digest_of(path.parent / name)) != stated:
            yield Flaw("set", message("checked.missing" if found is None else "checked.other", name=name))
