"""The guard before TOML is read: texts on which tomllib would spend minutes or gigabytes are refused at a glance."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator

from geometry.errors import LimitError
from plans.scene.faults import Path
from plans.words.words import Message, message, placed

# One token of TOML. Possessive repeats keep every text, closed or not, linear; a string may lack its end.
STRING = r"\"\"\"(?:[^\"\\]|\\.|\"(?!\"\"))*+(?:\"{3,5}|\\?\Z)|'''(?:[^']|'(?!''))*+(?:'{3,5}|\Z)"
STRING += r"|\"(?:[^\"\\\n]|\\[^\n])*+\"?|'[^'\n]*+'?"
TOKEN = (
    rf"(?P<blank>[ \t\r]+|\#[^\n]*)|(?P<line>\n)|(?P<text>{STRING})"
    r"|(?P<mark>[\[\]{}=,.])|(?P<bare>[^\s\[\]{}=,.\"'\#]+)|(?P<other>.)"
)


def line_column(text: str, offset: int) -> tuple[int, int]:
    """Give line and column, both from 1, of an offset in a text."""
    return text.count("\n", 0, offset) + 1, offset - (text.rfind("\n", 0, offset) + 1) + 1


class Places:
    """The places of a text's keys and elements.

    >>> places = Places('[drive]\\nlink = 1\\n')
    >>> places.offset(("drive", "link")), places.written(("drive", "link"))
    (8, '1')
    """

    def __init__(self, text: str) -> None:
        self._text = text
        self._keys: dict[Path, int] = {(): 0}
        self._values: dict[Path, tuple[int, int]] = {}
        self._arrays: dict[Path, int] = {}  # arrays of tables, with the index of the last one
        self._headers: dict[Path, int] = {}
        self.duplicate: tuple[Path, int, int] | None = None  # the first name that is defined twice, and its offsets
        self._tokens = self._scan()
        self._kind, self._start, self._end = "line", 0, 0
        self._next()
        self._document()

    def offset(self, path: Path) -> int:
        """Give the offset of a key or element, or of the nearest one around it."""
        while path not in self._keys:
            path = path[:-1]
        return self._keys[path]

    def written(self, path: Path) -> str:
        """Give a value as the file writes it; nothing for a table with a header."""
        start, end = self._values.get(path, (0, 0))
        return self._text[start:end]

    def values(self) -> list[Path]:
        """Give the paths of all values that stand behind an equals sign or in a list, in the order of the text."""
        return list(self._values)

    # The scan: tokens one after another; `_kind` and the text from `_start` to `_end` are the present one.

    def _scan(self) -> Iterator[tuple[str, int, int]]:
        for match in re.finditer(TOKEN, self._text, re.DOTALL):  # a scene without faults is not asked for places
            if match.lastgroup != "blank":
                yield match.lastgroup or "other", match.start(), match.end()
        while True:
            yield "end", len(self._text), len(self._text)

    def _next(self) -> None:
        self._kind, self._start, self._end = next(self._tokens)

    def _is(self, *marks: str) -> bool:
        return self._kind == "mark" and self._text[self._start] in marks

    def _document(self) -> None:
        table: Path = ()
        while self._kind != "end":
            if self._kind == "line":
                self._next()
                continue
            if self._is("["):
                table = self._header()
            else:
                self._pair(table)
            while self._kind not in ("line", "end"):
                self._next()  # what no line may hold; only in a text that tomllib refuses

    def _header(self) -> Path:
        start, array = self._start, self._text.startswith("[[", self._start)
        self._next()
        if array:
            self._next()
        path: Path = ()
        parts = self._key()
        for part in parts[:-1]:
            path = self._last((*path, part))
            self._keys.setdefault(path, start)
        path = (*path, *parts[-1:])
        earlier = self._headers.get(path)
        if path in self._values or (path in self._arrays and not array):
            earlier = self._keys[path]
        self._repeat(path, earlier, start)
        self._keys.setdefault(path, start)
        if array:
            self._arrays[path] = self._arrays.get(path, -1) + 1
            path = self._last(path)
            self._keys[path] = start
        self._headers[path] = start
        return path

    def _last(self, path: Path) -> Path:
        return (*path, self._arrays[path]) if path in self._arrays else path

    def _repeat(self, path: Path, first: int | None, second: int) -> None:
        if first is not None and first != second and self.duplicate is None:
            self.duplicate = (path, first, second)

    def _key(self) -> Path:
        parts: list[str] = []
        while self._kind in ("bare", "text", "other"):
            parts.append(self._name(self._text[self._start : self._end]))
            self._next()
            if not self._is("."):
                break
            self._next()
        return tuple(parts)

    @staticmethod
    def _name(token: str) -> str:
        if token[0] == '"' and "\\" in token:
            try:
                return str(tomllib.loads(f"key = {token}")["key"])
            except tomllib.TOMLDecodeError:
                return token
        return token[1:-1] if token[0] in "\"'" else token

    def _pair(self, table: Path) -> None:
        start = self._start
        path = table
        parts = self._key()
        for part in parts:
            path = (*path, part)
            first = self._keys.setdefault(path, start)
        if not parts or not self._is("="):
            return
        self._repeat(path, first, start)
        self._next()
        self._value(path)

    def _value(self, path: Path) -> None:
        start = self._start
        if self._is("["):
            end = self._array(path)
        elif self._is("{"):
            end = self._inline(path)
        else:
            end = start
            while self._kind not in ("line", "end") and not self._is(",", "]", "}"):
                end = self._end
                self._next()
        self._values[path] = (start, end)

    def _array(self, path: Path) -> int:
        self._next()
        index = 0
        while self._kind != "end" and not self._is("]"):
            if self._kind == "line" or self._is(","):
                self._next()
                continue
            self._keys[(*path, index)] = self._start
            before = self._start
            self._value((*path, index))
            index += 1
            if self._start == before:
                self._next()  # a stray bracket in a refused text: go on rather than stand still
        return self._close()

    def _inline(self, path: Path) -> int:
        self._next()
        while self._kind != "end" and not self._is("}"):
            before = self._start
            self._pair(path)
            if self._start == before or self._is(","):
                self._next()
        return self._close()

    def _close(self) -> int:
        end = self._end
        if self._kind != "end":
            self._next()
        return end


# tomllib needs time and memory growing with the square of a dotted key's parts, and recurses into brackets.
PARTS_LIMIT = 16
NESTING_LIMIT = 32
MARKS_LIMIT = 150_000  # commas, equals signs and brackets: room for 100,000 positions; tomllib reads as many in 0.3 s

_PART = r"(?:[A-Za-z0-9_-]++|\"(?:[^\"\\\n]|\\[^\n])*+\"|'[^'\n]*+')"
# What a pre-scan has to see: comments and strings to skip, too long dotted keys, brackets.
GUARD = re.compile(
    rf"(?P<comment>#[^\n]*)|(?P<dotted>(?<![A-Za-z0-9_-])(?:{_PART}[ \t]*+\.[ \t]*+){{{PARTS_LIMIT}}})"
    rf"|(?P<string>{STRING})|(?P<opens>[\[{{])|(?P<closes>[\]}}])",
    re.DOTALL,
)


def guard(text: str, file: str) -> None:
    """See that a text is within the limits of what tomllib reads at once."""
    marks = sum(text.count(mark) for mark in ",=[{")
    if marks > MARKS_LIMIT:
        raise LimitError(placed(file, message("limit.marks", count=marks, limit=MARKS_LIMIT)))
    depth = 0
    for token in GUARD.finditer(text):
        kind = token.lastgroup
        if kind == "dotted":
            _limit(text, file, token.start(), message("limit.parts", limit=PARTS_LIMIT))
        depth += {"opens": 1, "closes": -1}.get(kind or "", 0)
        if depth > NESTING_LIMIT:
            _limit(text, file, token.start(), message("limit.nesting", limit=NESTING_LIMIT))


def _limit(text: str, file: str, offset: int, what: Message) -> None:
    line, column = line_column(text, offset)
    raise LimitError(placed(f"{file}:{line}:{column}", what))
