"""What the system refused of a file, with the file's name and the reason."""

from __future__ import annotations

import contextlib
import errno
from collections.abc import Iterator
from pathlib import Path

from geometry.errors import DraftError

# What to do about a refusal that the system words without advice.
_ADVICE = {
    errno.ENAMETOOLONG: "Fix: give the scene's file a shorter name; its sheets' names begin with it",
    errno.EINVAL: "Fix: give another name",
}


class FileError(DraftError, OSError):
    """A file that could not be read or written; the old file of that name is whole unless the reason says otherwise."""

    exit_code = 7

    def __init__(self, path: Path, reason: str) -> None:
        super().__init__(f"{path}: {reason}")
        self.path = path
        self.reason = reason


@contextlib.contextmanager
def told(path: Path, what: str) -> Iterator[None]:
    """Tell of a file what the system refused to do with it."""
    try:
        yield
    except FileError:
        raise
    except OSError as error:
        advice = _ADVICE.get(error.errno or 0)
        reason = f"{error.strerror or error}. {advice}" if advice else error.strerror or error
        raise FileError(path, f"{what}: {reason}") from error
    except ValueError as error:  # a NUL in a path
        raise FileError(path, f"{what}: {error}") from error
