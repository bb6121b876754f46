"""Letters that look alike: what a text is, as it is seen, and which of the letters alike it is said to have.

What is drawn alike cannot be told apart: A is Latin, Cyrillic and Greek at once. What a file says of a text picks among
letters that look alike, and nothing else.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from typing import NamedTuple

from drawings.eye.shapes import ABOVE, DOTLESS, notations, shape
from drawings.paper.strokes import Run

_LEVELS = {"^": 1, "_": -1}
# A space is as wide as two thin ones, with the gaps between letters counted.
THIN = 1
_SPACES = {" ": 2 * THIN, "\u00a0": 2 * THIN, "\u2009": THIN, "\u202f": THIN}


class Sign(NamedTuple):
    """A letter with its accents: as it is written, as it is seen, its own level, and how much space is before it."""

    written: str
    seen: str
    level: int = 0
    space: str = ""

    @property
    def thin(self) -> int:
        """The space before it, in thin spaces."""
        return width(self.space)


def folded(plain: str) -> str:
    """Write a text as it is seen: in the first of the letters that look alike, each space as two thin ones.

    >>> folded("ВОТ") == folded("BOT"), folded("О") == folded("0"), folded("м²")
    (True, False, 'м2')
    """
    return "".join("\u2009" * sign.thin + sign.seen for sign in signs(plain))


@cache
def width(space: str) -> int:
    """Give the width of a space, in thin ones."""
    return sum(_SPACES[one] for one in space)


@lru_cache(maxsize=4096)
def signs(plain: str) -> tuple[Sign, ...]:
    """Take a text apart into letters; spaces at its end are not seen.

    >>> [(sign.seen, sign.level, sign.space) for sign in signs("5 м²")]
    [('5', 0, ''), ('м', 0, ' '), ('2', 1, '')]
    """
    return tuple(_signs(plain))


def _signs(plain: str) -> Iterator[Sign]:
    space, letter = "", ""
    for sign in (*plain, ""):
        if letter and sign and unicodedata.combining(sign):
            letter += sign
            continue
        if letter:
            yield Sign(letter, *_seen(letter), space)
            space, letter = "", ""
        if sign in _SPACES:
            space += sign
        else:
            letter = sign


@cache
def _seen(letter: str) -> tuple[str, int]:
    """Give the first letter that looks like one, and its level; of a letter that no alphabet has, the letter."""
    letter = unicodedata.normalize("NFC", letter)
    if (notation := notations().get(letter)) is not None:
        return shape(letter).letter, _LEVELS.get(notation[0], 0)
    base, *accents = list(unicodedata.normalize("NFD", letter))
    body = shape(base).letter if base in notations() else base
    if any(unicodedata.combining(accent) == ABOVE for accent in accents):
        body = DOTLESS.get(body, body)
    return "".join((body, *accents)), 0


def picked(seen: Sequence[tuple[str, int]], spaces: Sequence[int], said: str, fonts: bool = False) -> tuple[Run, ...]:
    """Give letters as they are said to be, if they look so, or else as they are seen; each with its level as seen.

    In a viewer's fonts spaces have no width of their own, and are as they are said to be.
    """
    return _picked(tuple(seen), (0, *spaces[1:]), said, fonts)


@lru_cache(maxsize=4096)  # a sheet says the same in many places, and what was laid out is read as its file is
def _picked(seen: tuple[tuple[str, int], ...], spaces: tuple[int, ...], said: str, fonts: bool) -> tuple[Run, ...]:
    return tuple(_runs(_signs_of(seen, spaces, said, fonts)))


@lru_cache(maxsize=4096)
def regular(runs: tuple[Run, ...]) -> tuple[Run, ...]:
    """Give runs as the eye sees them: signs that are raised by themselves where they stand, no spaces at the ends."""
    own = [(sign.seen, run.level or sign.level) for run in runs for sign in signs(run.text)]
    plain = "".join(run.text for run in runs)
    return picked(own, [sign.thin for sign in signs(plain)], plain)


def _signs_of(seen: Sequence[tuple[str, int]], spaces: Sequence[int], said: str, fonts: bool) -> tuple[Sign, ...]:
    own = signs(said.lstrip(" \u00a0\u2009\u202f"))
    alike = len(own) == len(seen) and all(
        sign.seen == letter and (fonts or sign.thin == space)
        for sign, (letter, _), space in zip(own, seen, spaces, strict=True)
    )
    if not alike:
        return tuple(
            Sign(letter, letter, level, " " * (space // 2) + "\u2009" * (space % 2))
            for (letter, level), space in zip(seen, spaces, strict=True)
        )
    return tuple(_as_said(sign, level) for sign, (_, level) in zip(own, seen, strict=True))


def _as_said(sign: Sign, level: int) -> Sign:
    """A raised sign is said so only where it is seen on a level of its own: in a subscript it stays."""
    if not sign.level:
        return sign._replace(level=level) if level else sign
    if level == 0:
        return Sign(sign.seen, sign.seen, 0, sign.space)
    return sign._replace(level=0 if level == sign.level else level)


def _runs(signs: Sequence[Sign]) -> Iterator[Run]:
    """Write letters on their levels; a space is on that of the letter before it, or of the text between levels."""
    text, level = "", 0
    for sign in signs:
        if sign.level != level:
            space = sign.space if sign.level == 0 else ""
            before = "" if space else sign.space
            if text or before:
                yield Run(text + before, level)
            text, level = space, sign.level
        else:
            text += sign.space
        text += sign.written
    if text:
        yield Run(text, level)
