"""Neighbours of the gallery's scenes: their sizes, loads and angles a little other, on paper of any kind.

A neighbour asks for the same sheets of the same machine: of cams, rotors, balancing, banks and dynamics too. Names,
numbers of links, counts and what is chosen of a list stay; what the change breaks, as a parallelogram, is refused or
drawn as what it then is.
"""

from __future__ import annotations

import re
from random import Random

from tests.alarms.machines import PAPER, papered
from tests.gallery import SCENES

CHANGE = 0.2  # the share by which a number differs at the most
KEPT = {  # keys whose numbers count, name or choose
    "breakdown", "centre", "divisions", "diagram", "ends", "first", "forces", "hodographs", "link", "links", "orders",
    "order", "on", "planets", "plans", "points", "positions", "shafts", "slider", "strokes", "travel", "turns",
    "working",
}  # fmt: skip
DIGITS = 4
_NUMBER = re.compile(r"(?<![\w.\"'-])-?\d+(?:\.\d+)?(?![\w.\"'])|(?<=\")-?\d+(?:[.,]\d+)?(?=\s)")


def neighbour(seed: int, number: int) -> str:
    """Write a neighbour of the scene whose turn it is: the same for ever by its seed and number."""
    chance, path = Random(f"neighbour {seed} {number}"), SCENES[number % len(SCENES)]
    text, _, sheet = path.read_text(encoding="utf-8").partition("[sheet]\n")
    changed = "\n".join(_changed(chance, line) for line in text.splitlines())
    return papered(f"{changed}\n[sheet]\n{sheet}", {key: chance.choice(values) for key, values in PAPER.items()})


def _changed(chance: Random, line: str) -> str:
    """Change the numbers of a line, but those after a key that counts or names, and all after a comment's mark."""
    bare, mark, comment = line.partition("#")
    if line.startswith(("title", "sheets", "angle", "wheels")):  # angles of phases make a turn, teeth are whole
        return line
    return _NUMBER.sub(lambda found: _other(chance, bare, found), bare) + mark + comment


def _other(chance: Random, line: str, found: re.Match[str]) -> str:
    key = re.findall(r"(\w+)\s*=", line[: found.start()])
    if not key or key[-1] in KEPT:
        return found[0]
    comma = "," in found[0]
    value = float(found[0].replace(",", ".")) * (1 + chance.uniform(-CHANGE, CHANGE))
    told = f"{value:.{DIGITS}g}"
    return told.replace(".", ",") if comma else told
