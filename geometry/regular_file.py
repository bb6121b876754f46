"""Regular files: read whole and never waited for; a pipe, a device or a folder is refused at once."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path

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
