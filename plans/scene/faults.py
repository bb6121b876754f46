"""Faults of a scene (ошибки исходных данных): where, what stands there, what was expected, and what to change."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from geometry.errors import DraftError
from plans.words.words import ENGLISH, Message, message, said, word, words

Path = tuple[str | int, ...]

SHOWN = 20  # faults that an error message lists before "and n more"
VALUE_WIDTH = 60  # characters of a value that a message quotes
DETAIL_WIDTH = 200  # characters of whatever else of the file a message quotes
NAME_WIDTH = 100  # characters of a misspelt name that are compared with the known ones
BARE = re.compile(r"[A-Za-z0-9_-]+")


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of a scene: file, line and column from 1, path of keys, value as written, kind and its details."""

    file: str
    line: int
    column: int
    path: Path
    value: str
    kind: str
    details: Mapping[str, object] = field(default_factory=dict)
    settles: Sequence[Path] = ()  # keys of which nothing else need be said: what is to be changed here changes them

    @property
    def expected(self) -> str:
        """What should stand there, in English."""
        return self._worded(ENGLISH, "expected")

    @property
    def advice(self) -> str:
        """What the author of the scene should change, in English."""
        return self._worded(ENGLISH, "advice")

    def worded(self, language: str) -> str:
        """Say on one line where the fault is, what was expected and what to change; or what a note has to say."""
        subject = quoted(dotted(self.path), DETAIL_WIDTH)
        if self.path and self.value:
            subject += f" = {quoted(self.value)}"
        subject += ": " if subject else ""
        parts = {part: self._worded(language, part) for part in ("expected", "advice")}
        text = word(language, f"message.{self._group}", **parts)
        end = "" if text.endswith("?") else "."
        return f"{quoted(self.file, 0)}:{self.line}:{self.column}: {subject}{text}{end}"

    @property
    def _group(self) -> str:
        return "fault" if f"fault.{self.kind}.expected" in words(ENGLISH) else "note"

    def _worded(self, language: str, part: str) -> str:
        details = {name: _shown(value, language) for name, value in self.details.items()}
        return word(language, f"{self._group}.{self.kind}.{part}", **details)

    def __str__(self) -> str:
        return self.worded(ENGLISH)


class SceneError(DraftError, ValueError):
    """A scene file with faults; `faults` holds them in the order of the file, `unlisted` counts any beyond them."""

    def __init__(self, faults: Iterable[Fault], unlisted: int = 0) -> None:
        self.faults = tuple(sorted(faults, key=lambda fault: (fault.line, fault.column)))
        self.unlisted = unlisted
        super().__init__(self.worded(ENGLISH))

    def worded(self, language: str) -> str:
        """Say the first faults, one a line, and how many there are beyond them."""
        lines = [fault.worded(language) for fault in self.faults[:SHOWN]]
        more = len(self.faults[SHOWN:]) + self.unlisted
        if more:
            lines.append(word(language, "message.more", count=more))
        return "\n".join(lines)


class Wrong(ValueError):  # noqa: N818  (it is caught and worded, never shown)
    """What is wrong with one value: the kind of fault and its details; the reader of the scene adds where it stands."""

    def __init__(self, kind: str, details: Mapping[str, object]) -> None:
        super().__init__(kind)
        self.kind, self.details = kind, details

    @property
    def at(self) -> Path:
        """The keys that lead from the checked value to the part that is wrong."""
        at = self.details.get("at", ())
        return at if isinstance(at, tuple) else ()


def wrong(kind: str, /, **details: object) -> Wrong:
    """Make the error that a check raises, a detail `at` saying which part of the value is wrong."""
    return Wrong(kind, details)


def dotted(path: Path) -> str:
    """Write a path as the file would: mechanism.slides[1].along, with quotes where TOML needs them.

    >>> dotted(("mechanism", "slides", 1, "along")), dotted(("frame", "O'"))
    ('mechanism.slides[1].along', 'frame."O\\'"')
    """
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part}]"
        else:
            text += ("." if text else "") + (part if BARE.fullmatch(part) else f'"{part}"')
    return text


def quoted(text: str, width: int = VALUE_WIDTH) -> str:
    """Show a text of the file on one line: no control or invisible characters, at most `width` long (0: any)."""
    shown = "".join(
        char if char.isprintable() else " " if char in "\r\n\t" else f"<U+{ord(char):04X}>" for char in text
    )
    return shown[: width - 3] + "..." if width and len(shown) > width else shown


def _shown(value: object, language: str) -> object:
    """Show a detail of a fault on one line; a list is put together by the phrase that names it."""
    whole = isinstance(value, Message) or not isinstance(value, tuple)
    return quoted(said(value, language), DETAIL_WIDTH) if whole else value


# Capitals that look alike in both alphabets: a Cyrillic А beside a Latin A is the commonest unknown point.
TWINS = str.maketrans("АВЕКМНОРСТУХ", "ABEKMHOPCTYX")
SPELLING = message("advice.spelling")


def suggestion(name: str, known: Iterable[str], otherwise: Message = SPELLING) -> Message:
    """Name the nearest of the known names."""
    found = nearest(name, known)
    return message("advice.meant", names=tuple(f'"{other}"' for other in found)) if found else otherwise


def nearest(name: str, known: Iterable[str]) -> list[str]:
    """Give up to three known names that are spelt nearly so, the nearest first."""
    import difflib  # noqa: PLC0415  (only a misspelt name needs it)

    folded = {other.casefold(): other for other in sorted(known)}
    return [folded[match] for match in difflib.get_close_matches(name[:NAME_WIDTH].casefold(), folded)]
