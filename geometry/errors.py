"""The exception tree.

DraftError
├── SceneError          (plans.scene.faults)     the scene file is wrong
├── StructureError      (plans.model.mechanism)  no crank plus dyads
├── ConstructionError   a construction has no result
├── SheetError          (drawings.paper.strokes) the sheet cannot be laid out or written
├── SelfCheckFailed     (drawings.checks.verify) a sheet or a comparison failed plandraft's own check
├── Refused             (drawings.paper.limits)  a sheet that cannot be measured
├── FileError           (drawings.files)         a file could not be written
└── LimitError          a named limit was exceeded
"""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path


class DraftError(Exception):
    """Anything plandraft can say about its input or its drawing; never a bug of plandraft."""

    exit_code = 3  # the command's: the scene is wrong


class ConstructionError(DraftError, ArithmeticError):
    """A construction that has no result with the given data."""


class LimitError(DraftError):
    """A named limit was exceeded."""

    exit_code = 8


_PART = 1 << 20  # bytes read at once
_READ = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)


def regular_bytes(path: Path, most: int) -> bytes:
    """Give the content of a regular file, of a longer one the first `most` bytes; an OSError names the file."""
    try:
        # Opened without waiting (a pipe would wait for ever), judged by the open file, read once.
        handle = os.open(path, _READ)
        try:
            if not stat.S_ISREG(os.fstat(handle).st_mode):
                raise OSError(errno.EINVAL, "not a regular file")
            return _content(handle, most)
        finally:
            os.close(handle)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error
    except ValueError as error:  # a NUL in a path
        raise OSError(errno.EINVAL, str(error), str(path)) from error


def _content(handle: int, most: int) -> bytes:
    parts = []
    while most and (part := os.read(handle, min(most, _PART))):
        parts.append(part)
        most -= len(part)
    return b"".join(parts)
