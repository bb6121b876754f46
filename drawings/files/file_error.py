"""Files beside the sheets, JSON as people read it, and what the system refused of a file."""

from __future__ import annotations

import contextlib
import errno
import json
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

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
