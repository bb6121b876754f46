"""Slips (описки): what a text that TOML refuses most likely means, in the order of what students get wrong."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator, Mapping

from plans.scene.faults import Fault, dotted
from plans.scene.guard import GUARD, STRING, Places, line_column
from plans.words.words import ENGLISH, Message, words
from plans.words.words import message as said_by

SLIPS_LIMIT = 8  # told of one text at once
TWICE = r"overwrite|twice|[Dd]uplicate|mutate|[Cc]annot redefine"  # what tomllib says of a name defined again
# Signs that word processors and other keyboards put in place of the ASCII ones, with what should stand there.
LOOKALIKES: Mapping[str, str] = {
    **dict.fromkeys("“”„«»＂″", '"'),
    **dict.fromkeys("‘’‚′＇", "'"),
    **dict.fromkeys("−–—‐‑－", "-"),
    **dict.fromkeys("\u00a0\u2007\u2009\u202f\u3000", "a space"),
    **{chr(0xFF10 + digit): str(digit) for digit in range(10)},
    **dict(zip("＝［］｛｝，．", "=[]{},.", strict=True)),
}


def slips(text: str, file: str, message: str, written: Callable[[str], str]) -> list[Fault]:
    """Give the first slips of a refused text: while each is of a line of its own, the rest is read without that line.

    `written` gives the text as it is read.
    """
    found = [slip(text, file, message)]
    while len(found) < SLIPS_LIMIT and _alone(text, found[-1].line):
        lines = text.split("\n")
        text = "\n".join([*lines[: found[-1].line - 1], "", *lines[found[-1].line :]])
        try:
            tomllib.loads(written(text))
            break
        except ValueError as error:
            further = slip(text, file, str(error))
        if not _alone(text, further.line):
            break  # it may follow from what was left out
        found.append(further)
    return found


def _alone(text: str, line: int) -> bool:
    """Tell whether a line is a whole one, "key = value": within no bracket or string, and opening none."""
    lines = text.split("\n")
    start = len("\n".join(["", *lines[: line - 1]]))
    end, depth = start + len(lines[line - 1]), {True: 0, False: 0}  # brackets open before the line, and in it
    for token in GUARD.finditer(text, 0, end + 1):
        if token.start() < start < token.end() or token.end() > end:
            return False
        depth[token.start() < start] += {"opens": 1, "closes": -1}.get(token.lastgroup or "", 0)
    return not any(depth.values()) and re.match(r"\s*[^\s\[#][^\n]*=", lines[line - 1]) is not None


def slip(text: str, file: str, message: str) -> Fault:
    """Make the fault of a text that tomllib refuses with a message."""
    at = re.search(r"\(at line (\d+), column (\d+)\)", message)
    line, column = (int(at[1]), int(at[2])) if at else line_column(text, len(text))
    lines = text.split("\n")
    written = lines[line - 1] if line <= len(lines) else ""
    if "Exceeds the limit" in message:
        longest = max(re.finditer(r"\d+", text), key=lambda match: len(match[0]))
        return Fault(file, *line_column(text, longest.start()), (), "", "huge_integer")
    hints = (_json, _yaml, _prime, _duplicate if re.search(TWICE, message) else _open_mark)
    for hint in hints:
        found = hint(text, line)
        if found:
            return Fault(file, *found[0], (), "", found[1], found[2])
    for offset, kind, details in _line_hints(written, column):
        return Fault(file, line, offset + 1, (), "", kind, details)
    bare = re.sub(r" ?\(at [^)]*\)", "", message)
    return Fault(file, line, column, (), "", "syntax", {"message": _of_toml(bare[:1].lower() + bare[1:])})


def _of_toml(message: str) -> str | Message:
    """Find what tomllib says among our words: as a whole, or with the sign that it quotes at its end."""
    if f"toml.{message}" in words(ENGLISH):
        return said_by(f"toml.{message}")
    quote = re.fullmatch(r"(.*?) (['\"].*)", message)
    key = f"toml.{quote[1]}" if quote else ""
    return said_by(key, sign=quote[2]) if quote and key in words(ENGLISH) else message


Hint = tuple[tuple[int, int], str, dict[str, object]] | None


def _json(text: str, line: int) -> Hint:
    return ((1, 1), "json", {}) if re.match(r"(?:\s|#[^\n]*\n)*+(?:\{|\[\s*[{\n])", text) else None


def _yaml(text: str, line: int) -> Hint:
    match = re.match(r"\s*(?:---\s*$|[\w-]++\s*:(?:\s|$))", text.split("\n")[line - 1])
    return ((line, 1), "yaml", {}) if match else None


def _prime(text: str, line: int) -> Hint:
    """Find a key like O' that lacks its quotes: its prime opens a string."""
    match = re.match(r"\s*([A-Za-z0-9_-]+'+)\s*=", text.split("\n")[line - 1])
    return ((line, match.start(1) + 1), "bare_key", {"text": match[1]}) if match else None


def _duplicate(text: str, line: int) -> Hint:
    duplicate = Places(text).duplicate
    if not duplicate:
        return None
    path, first, second = duplicate
    return line_column(text, second), "duplicate", {"name": dotted(path), "line": line_column(text, first)[0]}


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
    code = re.sub(STRING + r"|#.*", lambda match: " " * len(match[0]), line)
    for offset, char in enumerate(code):
        if char in LOOKALIKES:
            yield offset, "lookalike", {"code": f"{char} (U+{ord(char):04X})", "twin": LOOKALIKES[char]}
        elif not char.isprintable() and char not in "\t\r":
            yield offset, "unseen", {"code": f"U+{ord(char):04X}"}
    if match := re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]", line):  # in a text or a comment too
        yield match.start(), "unseen", {"code": f"U+{ord(match[0]):04X}"}
    if "\r" in line.removesuffix("\r"):
        yield line.index("\r"), "line_ends", {}
    if match := re.search(r"(?<==)\s*([+-]?\d+,\d+)\s*(?=[,}]|$)|\[[^][]*\d,0\d[^][]*\]", code):
        written = re.sub(r"(?<=\d),(?=\d)", ".", text := match[0].strip())
        yield match.start() + match[0].index(text), "comma", {"text": text, "written": written}
    yield from _number_hints(code)
    if match := re.match(r"\s*([^\s=\[\]\"'.]*[^\sA-Za-z0-9_=\[\]\"'.-][^\s=\[\]\".]*)\s*=", line):
        yield match.start(1), "bare_key", {"text": match[1]}
    if match := re.search(r"=\s*((?:\d+,)?\w[\w/ .-]*?)\s*$", code):
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
