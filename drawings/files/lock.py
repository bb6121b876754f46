"""The lock of a folder: one run at a time writes into it."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from drawings.files.file_error import FileError
from plans.words.words import message

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
