"""Natural changes of the gallery's scenes: one number is changed by up to half, as a user would in the file."""

from __future__ import annotations

import re
from functools import cache
from random import Random
from typing import NamedTuple

from tests.gallery import LINKAGES

TABLE = re.compile(r"^\s*\[+([\w.]+)\]+")
NUMBER = re.compile(r"(?<![\w.'\"-])\"?(-?\d+(?:\.\d+)?)(?: mm| rpm| rad/s)?\"?(?![\w.])")
# What is changed: the mechanism's own numbers, and the drive's speed, acceleration, start and listed angles.
CHANGED = {"mechanism.frame", "mechanism.lengths", "mechanism.points", "mechanism.slides", "drive"}
FREE = 180.0  # degrees: a start of 0 is changed to any other angle


class Spot(NamedTuple):
    """A number of a scene's text: where it stands, and whether it is a start."""

    begin: int
    end: int
    start: bool


@cache
def _scenes() -> tuple[tuple[str, tuple[Spot, ...]], ...]:
    texts = [path.read_text(encoding="utf-8") for path in LINKAGES]
    return tuple((text, tuple(_spots(text))) for text in texts)


def _spots(text: str) -> list[Spot]:
    """Find the numbers that may be changed; a nought has no half, but of a start."""
    found, table, begin = [], "", 0
    for line in text.splitlines(keepends=True):
        head = TABLE.match(line)
        table = head[1] if head else table
        if table in CHANGED and not head and not re.match(r"link|positions = \d|point", line):
            found += _of_line(line.partition("#")[0], begin)
        begin += len(line)
    return [spot for spot in found if spot.start or float(text[spot.begin : spot.end])]


def _of_line(line: str, begin: int) -> list[Spot]:
    own = len(line) - len(re.sub(r"^[\w']+ = (\{ (on|link) = \d+,)?", "", line))  # the key, and the link that it is on
    start = line.startswith("start")
    return [Spot(begin + m.start(1), begin + m.end(1), start) for m in NUMBER.finditer(line, own)]


def change(chance: Random) -> str:
    """Change one number of one scene."""
    text, spots = chance.choice(_scenes())
    spot = chance.choice(spots)
    number = float(text[spot.begin : spot.end])
    changed = chance.uniform(-FREE, FREE) if spot.start and not number else number * chance.uniform(0.5, 1.5)
    return text[: spot.begin] + f"{float(f'{changed:.4g}')!r}" + text[spot.end :]
