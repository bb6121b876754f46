"""The source of a scene: the file's text, its TOML tables, and where in the text each key stands."""

from __future__ import annotations

import codecs
import errno
import os
import re
import stat
import tomllib
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path as FilePath
from typing import Any

from geometry.errors import LimitError
from plans.faults import Fault, Path, SceneError
from plans.places import Places, line_column
from plans.units import decimal

SIZE_LIMIT = 1 << 20  # bytes of a scene file
# tomllib needs time and memory growing with the square of a dotted key's parts, and recurses into brackets.
PARTS_LIMIT = 16
NESTING_LIMIT = 32
MARKS_LIMIT = 150_000  # commas, equals signs and brackets: room for 100,000 positions; tomllib reads as many in 0.3 s

_STRING = r"\"\"\"(?:[^\"\\]|\\.|\"(?!\"\"))*+(?:\"{3,5}|\\?\Z)|'''(?:[^']|'(?!''))*+(?:'{3,5}|\Z)"
_STRING += r"|\"(?:[^\"\\\n]|\\[^\n])*+\"?|'[^'\n]*+'?"
_PART = r"(?:[A-Za-z0-9_-]++|\"(?:[^\"\\\n]|\\[^\n])*+\"|'[^'\n]*+')"
# What a pre-scan has to see: comments and strings to skip, too long dotted keys, brackets.
GUARD = re.compile(
    rf"(?P<comment>#[^\n]*)|(?P<dotted>(?<![A-Za-z0-9_-])(?:{_PART}[ \t]*+\.[ \t]*+){{{PARTS_LIMIT}}})"
    rf"|(?P<string>{_STRING})|(?P<opens>[\[{{])|(?P<closes>[\]}}])",
    re.DOTALL,
)

TWICE = r"overwrite|twice|[Dd]uplicate|mutate|[Cc]annot redefine"  # what tomllib says of a name defined again
HEXADECIMAL = r"0[xob][0-9A-Fa-f]"  # also octal and binary: TOML takes them for numbers, no drawing does

# Signs that word processors and other keyboards put in place of the ASCII ones, with what should stand there.
LOOKALIKES: Mapping[str, str] = {
    **dict.fromkeys("“”„«»＂″", '"'),
    **dict.fromkeys("‘’‚′＇", "'"),
    **dict.fromkeys("−–—‐‑－", "-"),
    **dict.fromkeys("\u00a0\u2007\u2009\u202f\u3000", "a space"),
    **{chr(0xFF10 + digit): str(digit) for digit in range(10)},
    **dict(zip("＝［］｛｝，．", "=[]{},.", strict=True)),
}
ENCODINGS = (
    (codecs.BOM_UTF32_LE, "UTF-32"),
    (codecs.BOM_UTF32_BE, "UTF-32"),
    (codecs.BOM_UTF16_LE, "UTF-16"),
    (codecs.BOM_UTF16_BE, "UTF-16"),
)


@dataclass(frozen=True)
class Source:
    """A scene file that TOML accepts: its name, text and tables (numbers as exact decimals)."""

    file: str
    text: str
    tables: Mapping[str, Any]

    @cached_property
    def places(self) -> Places:
        """Where each key stands; found when first asked for, that is when there is a fault."""
        return Places(self.text)

    @cached_property
    def _lines(self) -> list[int]:
        return [0, *(match.end() for match in re.finditer("\n", self.text))]

    def place(self, path: Path) -> tuple[int, int]:
        """Give line and column of a key or element, or of the nearest table around it."""
        offset = self.places.offset(path)
        line = bisect_right(self._lines, offset)
        return line, offset - self._lines[line - 1] + 1

    def fault(self, path: Path, kind: str, /, **details: object) -> Fault:
        """Make a fault at a path of this file, quoting the value that is written there."""
        line, column = self.place(path)
        return Fault(self.file, line, column, path, self.places.written(path), kind, details)


def read_source(path: FilePath) -> Source:
    """Read a scene file: a regular file of UTF-8 text within SIZE_LIMIT, a BOM at its start allowed."""
    return parse_source(_text(_bytes(path), str(path)), str(path))


def parse_source(text: str, file: str) -> Source:
    """Read a scene from its text; `file` is the name that faults give."""
    text = text.removeprefix("\ufeff")
    _guard(text, file)
    try:
        source = Source(file, text, tomllib.loads(text, parse_float=decimal))
    except ValueError as error:
        # Also the plain ValueError of an integer with thousands of digits.
        raise SceneError([_syntax_fault(text, file, str(error))]) from None
    if re.search(HEXADECIMAL, text):
        coded = [path for path in source.places.values() if re.match(HEXADECIMAL, source.places.written(path))]
        if coded:
            raise SceneError([source.fault(path, "hexadecimal") for path in coded])
    return source


def _bytes(path: FilePath) -> bytes:
    # Opened without waiting (a pipe would wait for ever), judged by the open file, read once.
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    handle = os.open(path, flags)
    try:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            raise OSError(errno.EINVAL, "not a regular file", str(path))
        with os.fdopen(os.dup(handle), "rb") as stream:
            data = stream.read(SIZE_LIMIT + 1)
    finally:
        os.close(handle)
    if len(data) > SIZE_LIMIT:
        raise LimitError(f"{path}: the file is longer than SIZE_LIMIT = {SIZE_LIMIT} bytes")
    return data


def _text(data: bytes, file: str) -> str:
    for mark, encoding in ENCODINGS:
        if data.startswith(mark):
            raise SceneError([Fault(file, 1, 1, (), "", "utf16", {"encoding": encoding})])
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        before = data[: error.start].decode("utf-8")
        line, column = line_column(before, len(before))
        kind = "not_text" if b"\0" in data else "not_utf8"
        raise SceneError([Fault(file, line, column, (), "", kind, {"offset": error.start})]) from None
    if "\0" in text:
        line, column = line_column(text, text.index("\0"))
        raise SceneError([Fault(file, line, column, (), "", "not_text")])
    return text


def _guard(text: str, file: str) -> None:
    marks = sum(text.count(mark) for mark in ",=[{")
    if marks > MARKS_LIMIT:
        raise LimitError(f"{file}: {marks} commas, equals signs and brackets: more than MARKS_LIMIT = {MARKS_LIMIT}")
    depth = 0
    for token in GUARD.finditer(text):
        kind = token.lastgroup
        if kind == "dotted":
            _limit(text, file, token.start(), f"a dotted key of more than PARTS_LIMIT = {PARTS_LIMIT} parts")
        depth += {"opens": 1, "closes": -1}.get(kind or "", 0)
        if depth > NESTING_LIMIT:
            _limit(text, file, token.start(), f"brackets nested deeper than NESTING_LIMIT = {NESTING_LIMIT}")


def _limit(text: str, file: str, offset: int, what: str) -> None:
    line, column = line_column(text, offset)
    raise LimitError(f"{file}:{line}:{column}: {what}")


def _syntax_fault(text: str, file: str, message: str) -> Fault:
    """Word what tomllib refuses; the hints come in the order of what students get wrong."""
    at = re.search(r"\(at line (\d+), column (\d+)\)", message)
    line, column = (int(at[1]), int(at[2])) if at else line_column(text, len(text))
    lines = text.split("\n")
    written = lines[line - 1] if line <= len(lines) else ""
    if "Exceeds the limit" in message:
        return Fault(file, *_huge(text), (), "", "huge_integer")
    hints = (_json, _prime, _duplicate if re.search(TWICE, message) else _open_mark)
    for hint in hints:
        found = hint(text, line)
        if found:
            return Fault(file, *found[0], (), "", found[1], found[2])
    for offset, kind, details in _line_hints(written, column):
        return Fault(file, line, offset + 1, (), "", kind, details)
    bare = re.sub(r" ?\(at [^)]*\)", "", message)
    return Fault(file, line, column, (), "", "syntax", {"message": bare[:1].lower() + bare[1:]})


Hint = tuple[tuple[int, int], str, dict[str, object]] | None


def _json(text: str, line: int) -> Hint:
    return ((1, 1), "json", {}) if re.match(r"(?:\s|#[^\n]*\n)*+\{", text) else None


def _prime(text: str, line: int) -> Hint:
    """Find a key like O' that lacks its quotes: its prime opens a string."""
    match = re.match(r"\s*([A-Za-z0-9_-]+'+)\s*=", text.split("\n")[line - 1])
    return ((line, match.start(1) + 1), "bare_key", {"text": match[1]}) if match else None


def _duplicate(text: str, line: int) -> Hint:
    duplicate = Places(text).duplicate
    if not duplicate:
        return None
    first, second = (line_column(text, offset) for offset in duplicate)
    return second, "duplicate", {"line": first[0]}


def _open_mark(text: str, line: int) -> Hint:
    """Find a quote or bracket left open: an error is noticed only behind it."""
    end = len("\n".join(text.split("\n")[:line]))
    stack: list[int] = []
    for token in GUARD.finditer(text):
        start, kind, written = token.start(), token.lastgroup, token.group()
        if start >= end:
            break
        if kind == "opens":
            stack.append(start)
        elif kind == "closes" and stack:
            stack.pop()
        elif kind == "string" and not _closed(written):
            return line_column(text, start), "open_quote", {}
    place = line_column(text, stack[-1]) if stack else None
    # A bracket of the very line that is wrong may be closed behind the error: other hints know better.
    return (place, "open_bracket", {"bracket": text[stack[-1]]}) if place and place[0] < line else None


def _closed(string: str) -> bool:
    mark = string[0] * 3 if string.startswith((3 * string[0],)) and len(string) != 2 else string[0]
    return len(string) >= 2 * len(mark) and string.endswith(mark)


def _line_hints(line: str, column: int) -> Iterator[tuple[int, str, dict[str, object]]]:
    """Give the usual mistakes that a refused line shows, with the offset in the line."""
    code = re.sub(_STRING + r"|#.*", lambda match: " " * len(match[0]), line)
    for offset, char in enumerate(code):
        if char in LOOKALIKES:
            yield offset, "lookalike", {"code": f"{char} (U+{ord(char):04X})", "twin": LOOKALIKES[char]}
        elif not char.isprintable() and char not in "\t\r":
            yield offset, "unseen", {"code": f"U+{ord(char):04X}"}
    if "\r" in line.removesuffix("\r"):
        yield line.index("\r"), "line_ends", {}
    if match := re.search(r"=\s*([+-]?\d+),(\d+)\s*$", code):
        yield match.start(1), "comma", {"written": f"{match[1]}.{match[2]}"}
    yield from _number_hints(code)
    if match := re.match(r"\s*([^\s=\[\]\"'.]*[^\sA-Za-z0-9_=\[\]\"'.-][^\s=\[\]\".]*)\s*=", line):
        yield match.start(1), "bare_key", {"text": match[1]}
    if match := re.search(r"=\s*(\w[\w/ .-]*?)\s*$", code):
        yield match.start(1), "bare_text", {"text": match[1]}


def _number_hints(code: str) -> Iterator[tuple[int, str, dict[str, object]]]:
    for pattern, written in (
        (r"(?<![\w.])[+-]?()(\.\d+)", "0{}"),
        (r"(?<![\w.])[+-]?()(\d+\.)(?![\d])", "{}0"),
        (r"(?<![\w.+-])[+-]?(0+)(\d[\d.]*)", "{}"),
    ):
        if match := re.search(r"[=,\[]\s*" + pattern, code):
            yield match.start(2), "number_form", {"written": written.format(match[2])}
    if match := re.search(r"\d[eE][+-]?(?!\d)", code):
        yield match.start(), "exponent", {}


def _huge(text: str) -> tuple[int, int]:
    longest = max(re.finditer(r"\d+", text), key=lambda match: len(match[0]))
    return line_column(text, longest.start())
