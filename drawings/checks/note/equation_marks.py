"""The self-check of what marks the equations of a note: underlines, directions, senses, scales (пометки уравнений)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from drawings.checks.note.lines import part
from drawings.checks.precise import ALL_DIGITS, tells
from drawings.checks.reading import reads
from drawings.lettering.words import number
from drawings.lettering.words import word as lettered
from drawings.paper.walk import groups
from plans.checks.compare import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.order import ACCELERATIONS, POSITIONS, VELOCITIES
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

ROUNDED = 1e-9  # share of an angle that arithmetic moves it by
SOME = "@"  # in the place of a number
FULL, DIRECTION = 2, 1  # lines under a vector
_INDEX = r"(?P<index>(?:[^{}]|\{[^{}]*\})+)"
_LETTER = rf"\\bar (?P<letter>[va])_\{{{_INDEX}\}}(?:\^\{{(?P<part>[^{{}}]*)\}})?"
_TERM = re.compile(rf"(?P<lines>(?:\\underline\{{)*){_LETTER}")
_WAY = re.compile(rf"{_LETTER} \\(?P<way>perp|parallel) (?P<line>[^$]+)\$")
_RATE = re.compile(r"- \$\\(?P<symbol>omega|varepsilon)_\{(?P<link>\d+)\} = .*\$, (?P<sense>.+)")
_SCALE = re.compile(r"\\mu_\{(?P<letter>[lva])\} = (?P<mu>[\d{},.]+)\\text")
_CORIOLIS = re.compile(r"- \$a_\{.*?\}\^\{k\} = (?P<right>.*)")
_PARTS = {"n": FULL, "k": FULL, "t": DIRECTION, r"\tau": DIRECTION, "r": DIRECTION}
_PLANS = {"l": POSITIONS.plan, "v": VELOCITIES.plan, "a": ACCELERATIONS.plan}


class EquationMarks(NamedTuple):
    """The chapter of a report on the equations of plans."""

    text: str
    study: LinkageStudy
    comparison: MotionComparison
    leaves: Mapping[str, Sequence[Leaf]]

    def faults(self) -> Iterator[Message]:
        """Hold what is known of each term, along what it goes, the senses of rates, the scales of the plans."""
        position = None
        for line in part(self.text, word(self.study.language, "report.equations")):
            position = self._position(line, position)
            right = _underlined(line) and _directed(line) and _doubled(line)
            if not right or (position is not None and not self._holds(line, position)):
                yield message("wrong.told", text=line)

    def _holds(self, line: str, k: int) -> bool:
        """Tell whether a line of a position is right in what is no equation: its head, its link, senses, scales."""
        headed = not line.startswith("### ") or tells(line, self._head(k), (0, 4), ROUNDED)
        link = self.study.mechanism.drive.link
        some, own = (word(self.study.language, "report.primary", link=one).strip() for one in (SOME, link))
        named = not line.startswith(some.partition(SOME)[0]) or line == own
        return headed and named and self._turns(line, k) and self._scaled(line, k)

    def _head(self, k: int) -> str:
        """Head what is told of a position, with the crank's angle or the drive's way with all digits."""
        drive, phi, language = self.study.mechanism.drive, float(self.study.turn.phi[k]), self.study.language
        angle = f"φ = {number(math.degrees(phi) % 360, language, ALL_DIGITS)}°"
        way = f"s = {number(1000 * drive.unit * phi, language, ALL_DIGITS)} {lettered(language, 'mm')}"
        return word(language, "report.in_position", position=k, station=way if drive.pushed else angle).strip()

    def _position(self, line: str, before: int | None) -> int | None:
        """Give the position that a head opens, or the one that was open."""
        head = word(self.study.language, "report.in_position", position=SOME, station=SOME).strip().partition(SOME)[0]
        found = re.match(rf"{re.escape(head)}(\d+),", line)
        return int(found[1]) if found else before

    def _turns(self, line: str, k: int) -> bool:
        """Tell whether a rate has the sense that the analysis gives it."""
        found = _RATE.fullmatch(line)
        if found is None:
            return True
        rates = self.comparison.analysis.links[int(found["link"])]
        rate = float((rates.omega if found["symbol"] == "omega" else rates.epsilon)[k])
        return found["sense"] == word(self.study.language, f"way.{'counter-clockwise' if rate > 0 else 'clockwise'}")

    def _scaled(self, line: str, k: int) -> bool:
        """Tell whether the scales of plans are those that their marks state."""
        seen = self._scales(k)
        for found in _SCALE.finditer(line):
            mu = seen.get(_PLANS[found["letter"]], np.nan)
            if not reads(found["mu"].replace("{,}", "."), mu, 0.0):
                return False
        return True

    def _scales(self, k: int) -> dict[str, float]:
        marks = [one.data for own in self.leaves.values() for leaf in own for one in groups(leaf.groups)]
        own = (data for data in marks if data.get("position") == str(k) and "scale" in data)
        return {data["plan"]: float(data["scale"]) for data in own if data.get("plan") in _PLANS.values()}


def _underlined(line: str) -> bool:
    """Tell whether the terms of an equation have as many lines as is known of them: those of known size and way two."""
    left, equal, right = line.partition(" = ")
    if not line.startswith("$$") or not equal or not left.lstrip("$").startswith(("\\bar", "\\underline")):
        return True
    found = [_TERM.search(term) for term in right.split(",\\quad")[0].split(" + ")]
    if None in found:
        return False
    base, *others = (one for one in found if one is not None)
    relative = all(_lines(one) == _PARTS.get(one["part"] or "r", 0) for one in others)
    return _lines(base) == FULL and not base["part"] and bool(others) and relative


def _lines(term: re.Match[str]) -> int:
    return term["lines"].count("underline")


def _doubled(line: str) -> bool:
    """Tell whether a Coriolis part is twice the product of the rate of turning and the relative velocity."""
    found = _CORIOLIS.match(line)
    return found is None or found["right"].startswith(r"2 \omega_")


def _directed(line: str) -> bool:
    """Tell whether relative velocities of a link's points are square to its line, normal parts along it."""
    for found in _WAY.finditer(line):
        own, points = (set(re.findall("[A-Z]", text)) for text in (found["index"], found["line"]))
        square = found["letter"] == "v" and own == points
        if (found["way"] == "perp") != square:
            return False
    return True
