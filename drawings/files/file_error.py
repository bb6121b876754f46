"""What the system refused of a file, with the file's name and the reason."""

from __future__ import annotations

import contextlib
import errno
from collections.abc import Iterator
from pathlib import Path

from geometry.errors import DraftError
from plans.words.words import ENGLISH, Message, message, placed, words

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
def told(path: Path, what: str) -> Iterator[None]:
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
