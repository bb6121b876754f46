"""The self-check of friction: what a force sheet and the report say of it, against the analysis (проверка трения)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.lettering.words import number, runs, word
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import indices
from plans.model.kinetostatics import NOTHING
from plans.model.losses import Friction
from plans.model.motion import Floats
from plans.words import words
from plans.words.words import Message, message

_SIGNS = str.maketrans({"\N{NO-BREAK SPACE}": " ", "\n": " "})
FIGURE = r"[−\d.,]+\d|\d"


@dataclass(frozen=True)
class Told:
    """What the analysis finds of friction, as numbers that may be written, with what the two roads may differ by."""

    comparison: ForceComparison

    @property
    def found(self) -> Friction:
        """Give what friction takes by analysis."""
        assert self.comparison.friction is not None  # a scene with friction compares it
        return self.comparison.friction[1]

    @cached_property
    def slack(self) -> Mapping[str, Floats]:
        """Give the allowed differences by the names of the findings."""
        return {one.name: one.allowed for one in self.comparison.of("friction")}

    def power(self, key: str, k: int) -> tuple[float, float]:
        """Give the power W lost in a pair, and its allowed difference."""
        return float(self.found.powers[key][k]), float(self.slack[f"N_{_index(key)}"][k])

    def lost(self, k: int) -> tuple[float, float]:
        """Give the power W lost in all pairs."""
        return float(self.found.lost[k]), sum(self.power(key, k)[1] for key in self.found.powers)

    def useful(self, k: int) -> tuple[float, float]:
        """Give the power W of the useful loads."""
        return float(self.found.useful[k]), float(self.slack["N_us"][k])

    def efficiency(self, k: int) -> tuple[float, float]:
        """Give the instantaneous efficiency."""
        return float(self.found.efficiency[k]), float(self.slack["η"][k])

    def cycle(self) -> tuple[float, float] | None:
        """Give the efficiency over the cycle."""
        return None if self.found.cycle is None else (self.found.cycle, self._one("η cycle"))

    def wear(self) -> dict[str, tuple[float, float]]:
        """Give the shares of the pairs, per cent."""
        return {key: (100 * part, 100 * self._one(f"wear {_index(key)}")) for key, part in self.found.wear.items()}

    def _one(self, name: str) -> float:
        return float(self.slack[name][0]) if name in self.slack else np.inf

    def jams(self) -> dict[str, list[int]]:
        """Give the positions in which pairs jam; where it hangs on a rounding, as the construction says."""
        assert self.comparison.friction is not None
        both = [{(jam.pair, jam.position) for jam in one.jams} for one in self.comparison.friction]
        edge = {(pair, k) for pair, k in both[0] ^ both[1] if self.slack[f"jam {_index(pair)}"][k] > 0}
        told = sorted(((both[1] - edge) | (both[0] & edge)), key=lambda jam: (jam[1], jam[0]))
        return {pair: [k for other, k in told if other == pair] for pair, _ in told}


def friction_of(leaf: Leaf, comparison: ForceComparison, position: int, language: str) -> Iterator[Message]:
    """Read what the notes of a force sheet say of friction."""
    notes = [group for group in leaf.groups if group.name == "notes"]
    told = Told(comparison) if comparison.friction is not None else None
    if told is None or not notes or not np.isfinite(told.found.lost[position]):
        return
    said = " ".join(text.plain for group in notes for text in texts((group,))).translate(_SIGNS)
    for key, power in (("friction index", told.lost(position)), ("useful index", told.useful(position))):
        yield from _held(said, word(language, key, power=f"@ {word(language, 'W')}"), power, language, 4)
    if np.isfinite(told.efficiency(position)[0]):
        yield from _held(said, ", η = @", told.efficiency(position), language, 3)
    if told.cycle() is not None:
        yield from _held(said, word(language, "cycle efficiency", eta="@"), told.cycle(), language, 3)
    for pair, share in told.wear().items():
        if share[0] > 100 * (NOTHING + share[1]):
            yield from _held(said, f"{pair} @ %", share, language, 3)
    yield from _jams(said, told, language)


def _jams(said: str, told: Told, language: str) -> Iterator[Message]:
    jams = told.jams()
    pairs, positions = ", ".join(jams), runs(sorted({k for own in jams.values() for k in own}))
    sentence = word(language, "jams", pairs=pairs, positions=positions).translate(_SIGNS)
    begins = word(language, "jams", pairs="@", positions="").partition("@")[0]
    if (sentence not in said) if jams else (begins in said):
        yield message("wrong.friction", text=f"{begins}...")


def _held(said: str, pattern: str, value: tuple[float, float] | None, language: str, digits: int) -> Iterator[Message]:
    """Find a phrase in the notes, and hold its number against what may be written there."""
    found = re.search(re.escape(pattern.translate(_SIGNS)).replace("@", f"({FIGURE})"), said)
    if found is None:
        yield message("wrong.missing", name=pattern.replace("@", "..."))
    elif value is not None and not reads(found[1], *value, language, digits):
        yield message("wrong.friction", text=found[0])


def reads(text: str, value: float, slack: float, language: str = "en", digits: int = 4) -> bool:
    """Tell whether a text is a number as it is written, but for what the two roads may differ by; a gap is a dash.

    >>> reads("0.2", 0.19996, 1e-9), reads("0.2", 0.19994, 1e-9), reads("0.1999", 0.19994, 1e-9)
    (True, False, True)
    """
    if not np.isfinite(value) or text == "—":
        return text == "—" and not np.isfinite(value)
    near = [one for one in (value, value - slack, value + slack) if np.isfinite(one)]
    if text in {number(one, language, digits) for one in near}:
        return True
    return abs(float(text.replace("−", "-").replace(",", ".")) - value) <= slack


def report_of(text: str, comparison: ForceComparison, language: str) -> Iterator[Message]:
    """Read what the report says of friction: every cell of its table, the cycle and the shares."""
    if comparison.friction is None:
        return
    told, (_, _, part) = Told(comparison), text.partition(f"\n{words.word(language, 'report.friction')}\n")
    part = part.partition("\n## ")[0]
    rows = [row.strip("| ").split(" | ") for row in part.splitlines() if re.match(r"\| \d", row)]
    if len(rows) != len(told.found.phi):
        yield message("wrong.friction_table")
        return
    for k, row in enumerate(rows):
        cells = [told.power(key, k) for key in told.found.powers]
        cells += [told.lost(k), told.useful(k), told.efficiency(k)]
        for cell, value in zip(row[1:], cells, strict=True):
            if not reads(cell, *value, language, digits=6):
                yield message("wrong.friction_cell", text=cell, position=k)
    yield from _further(part, told, language)
    jam = words.word(language, "report.jam", pair="@", position="#", ratio="%", advice="").partition("%")[0]
    pattern = re.escape(jam).replace("@", r"(\S+)").replace(r"\#", r"(\d+)")
    shown = {(pair, int(k)) for pair, k in re.findall(pattern, part)}
    if shown != {(pair, k) for pair, own in told.jams().items() for k in own}:
        yield message("wrong.jams")


def _further(part: str, told: Told, language: str) -> Iterator[Message]:
    """Read the cycle's efficiency and the shares of wear below the table."""
    cycle = told.cycle()
    if cycle is not None:
        yield from _held(part, words.word(language, "report.cycle", efficiency="@"), cycle, language, 6)
    for pair, share in told.wear().items():
        yield from _held(part, f" {pair} @ %", share, language, 4)


def _index(key: str) -> str:
    giver, taker = map(int, key.split("-"))
    return indices(giver, taker)
