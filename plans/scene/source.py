"""The source of a scene: the file's text, its TOML tables, and where in the text each key stands."""

from __future__ import annotations

import codecs
import re
import tomllib
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path as FilePath
from typing import Any

from geometry.errors import LimitError, regular_bytes
from plans.scene.faults import TWINS, Fault, Path, SceneError
from plans.scene.guard import Places, guard, line_column
from plans.scene.units import decimal
from plans.words.words import ENGLISH, languages, message, placed

SIZE_LIMIT = 1 << 20  # bytes of a scene file
HEXADECIMAL = r"0[xob][0-9A-Fa-f]"  # also octal and binary: TOML takes them for numbers, no drawing does

# Names of points in capitals, alone or as those of a link; a unit behind a number is none.
CAPITALS = re.compile(r"#[^\n]*|(?<!\w)(?<!\d )[A-ZА-Я][A-ZА-Я0-9_]*(?!\w)")
MARK = "\ufeff"  # the byte order mark that Notepad puts at the start of a file
# A line that asks for a language, in [sheet] and at the top of the file.
IN_SHEET = re.compile(r"""language\s*=\s*["']?([\w-]+)""")
SHEET = re.compile(r"""sheet\s*(?:\.|=\s*\{[^#]*?\b)\s*language\s*=\s*["']?([\w-]+)""")
ZEROS = 16  # bytes from the start: ASCII text in UTF-16 has a zero in every other one, no other file has
ENCODINGS = (
    (codecs.BOM_UTF32_LE, "UTF-32"),
    (codecs.BOM_UTF32_BE, "UTF-32"),
    (codecs.BOM_UTF16_LE, "UTF-16"),
    (codecs.BOM_UTF16_BE, "UTF-16"),
)


@dataclass(frozen=True)
class Source:
    """A scene file that TOML accepts: its name, text and tables (numbers as exact decimals).

    `marked` tells that it began with a byte order mark.
    """

    file: str
    text: str
    tables: Mapping[str, Any]
    marked: bool = False

    @property
    def content(self) -> bytes:
        """The file's bytes."""
        return f"{MARK if self.marked else ''}{self.text}".encode()

    @cached_property
    def places(self) -> Places:
        """Where each key stands; found when first asked for, that is when there is a fault."""
        return Places(in_one_alphabet(self.text))

    def notes(self) -> Iterator[Fault]:
        """Note what of the file was left aside, or read as what it looks like."""
        if self.marked:
            yield self.fault((), "byte_order_mark")
        pairs = zip(self.text, in_one_alphabet(self.text), strict=True)
        if other := dict.fromkeys(letter for letter, latin in pairs if letter != latin):
            place = line_column(self.text, min(map(self.text.index, other)))
            yield Fault(self.file, *place, (), "", "one_alphabet", {"letters": ", ".join(other)})
        for row in re.finditer(r"\[[^\[\]\"'#]*\]", self.text):
            if (pointed := with_points(row[0])) != row[0]:
                place = line_column(self.text, row.start())
                yield Fault(self.file, *place, (), "", "mixed_commas", {"row": row[0], "pointed": pointed})

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
    data = regular_bytes(path, SIZE_LIMIT + 1)
    if len(data) > SIZE_LIMIT:
        raise LimitError(placed(path, message("limit.size", limit=SIZE_LIMIT)))
    return parse_source(_text(data, str(path)), str(path))


def language_of(path: FilePath) -> str:
    """Give the language that a scene asks for, however faulty the rest of the file is; English where it names none."""
    from plans.scene.forms import called, likely  # noqa: PLC0415  (it imports much, and a faulty scene alone needs it)

    try:  # UTF-16 too: keys are ASCII
        text = regular_bytes(path, SIZE_LIMIT + 1).replace(b"\0", b"").decode("utf-8", errors="replace")
    except (OSError, ValueError):
        return ENGLISH
    asked = next(_asked(text), ENGLISH) if "language" in text else ENGLISH
    return called(asked, languages()) or next(iter(likely(asked, languages())), ENGLISH)


def _asked(text: str) -> Iterator[str]:
    """Give what the lines of a text ask for as the language of the sheet."""
    table = ""
    for line in text.lstrip("\ufeff\ufffd").splitlines():
        written = line.strip()
        if written.startswith("["):
            table = written.partition("]")[0].strip("[ \t")
        elif found := IN_SHEET.match(written) if table == "sheet" else None if table else SHEET.match(written):
            yield found[1]


def with_points(row: str) -> str:
    """Give a list with points for the commas that no space follows, where others have one: decimal commas.

    >>> with_points("[0, 0,25]"), with_points("[1,5]"), with_points("[0,5, 1,5]")
    ('[0, 0.25]', '[1,5]', '[0.5, 1.5]')
    """
    return re.sub(r"(?<=\d),(?=\d)", ".", row) if re.search(r"\d,\s", row) else row


def in_one_alphabet(text: str) -> str:
    """Give a text with each Cyrillic capital among names of points by the Latin one that looks so, where that is there.

    >>> in_one_alphabet('[links]\\n1 = "ОА"  # О\\nO = "5 Н"') == '[links]\\n1 = "OА"  # О\\nO = "5 Н"'
    True
    """
    if text.isascii():
        return text
    parts = re.split(r"(?m)^(?=[ \t]*\[)", text)
    named = [k for k, part in enumerate(parts) if k and not re.match(r"[\[ \t]*(sheet|cam)\b", part)]
    known = {letter for k in named for name in CAPITALS.findall(parts[k]) if name[0] != "#" for letter in name}
    twins = {code: latin for code, latin in TWINS.items() if chr(latin) in known}
    for k in named:
        parts[k] = CAPITALS.sub(lambda name: name[0] if name[0][0] == "#" else name[0].translate(twins), parts[k])
    return "".join(parts)


def parse_source(text: str, file: str) -> Source:
    """Read a scene from its text; `file` is the name that faults give."""
    marked, text = text.startswith(MARK), text.removeprefix(MARK)
    guard(text, file)
    try:
        source = Source(file, text, tomllib.loads(in_one_alphabet(text), parse_float=decimal), marked)
    except ValueError as error:
        from plans.scene.slips import slips  # noqa: PLC0415  (only a refused text pays for it)

        # Also the plain ValueError of an integer with thousands of digits.
        raise SceneError(slips(text, file, str(error), in_one_alphabet)) from None
    if re.search(HEXADECIMAL, text):
        coded = [path for path in source.places.values() if re.match(HEXADECIMAL, source.places.written(path))]
        if coded:
            raise SceneError([source.fault(path, "hexadecimal") for path in coded])
    return source


def _text(data: bytes, file: str) -> str:
    encoding = _encoding(data)
    if encoding:
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


def _encoding(data: bytes) -> str:
    """Name the encoding that Notepad or a spreadsheet may have used: by its mark, or by every other byte being 0."""
    if marked := next((encoding for mark, encoding in ENCODINGS if data.startswith(mark)), ""):
        return marked
    start = data[:ZEROS]
    halves = (start[0::2], start[1::2])
    one_sided = any(half and not any(half) and b"\0" not in other for half, other in (halves, halves[::-1]))
    return "UTF-16" if one_sided and len(data) > 1 else ""
