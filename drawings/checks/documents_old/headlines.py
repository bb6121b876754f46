"""What is said first of a scene, held to the analysis: stroke, time ratio, greatest rates, drive (проверка итогов)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Final, NamedTuple

import numpy as np

from drawings.checks.precise import KNOWN
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.lettering import words as lettering
from plans.checks.comparison import Finding
from plans.model.order import ACCELERATIONS, VELOCITIES
from plans.study import Study
from plans.techniques import named
from plans.words.words import message, term, word

BALANCING = "plans.forces.primary:balancing_quantity"  # which a scene with forces alone has imported

DIGITS = 5
RATIO, ANGLE = 4, 3  # decimals of the time ratio, and of a swing in degrees
BEGUN = re.compile(r"[Hψ] = |K = |\|.+\|\w+ = ")  # how each number that is said first begins

# Of a study to what tells whether a line is what a technique says of it; to None where none is sure to be said.
SENTENCES: Final[Mapping[str, str]] = {
    "dynamics": "drawings.checks.dynamics.report_told:headline",
    "balance": "drawings.checks.balance_words.balance_report:headline",
    "bank": "drawings.checks.balance_words.bank_report:headline",
    "rotor": "drawings.checks.rotor.reported:headline",
    "cyclogram": "drawings.checks.cyclogram.reported:headline",
}
OPEN: Final = ("dynamics", "rotor")  # whose sentence rounding or a gap may leave open; that of others is then not due
# Of a study to the lines that are said as they stand.
WHOLE: Final[Mapping[str, str]] = {
    "linkage": "drawings.checks.note.motion_lines:said_first",
    "forces": "drawings.checks.note.force_note:said_first",
}
KINDS: Final = {"balance": "balancing"}  # of sheets, by techniques whose names are others


class Due(NamedTuple):
    """A number that is due: what stands before and behind it, its value, what both roads differ by; where it may be.

    It has so many decimals, or digits where it has no fixed number of them; no `places`: it is of no position.
    """

    before: str
    behind: str
    value: float
    slack: float
    decimals: int | None = None
    places: frozenset[int] = frozenset()

    def tells(self, said: str) -> bool:
        """Tell whether what is said is this number, rounded."""
        found = re.fullmatch(f"{re.escape(self.before)}([−\\d.,-]+){self.behind}", said)
        if found is None or (self.places and int(found[2]) not in self.places):
            return False
        places = len(re.split("[.,]", found[1])[-1]) if re.search("[.,]", found[1]) else 0
        if self.decimals is not None and places != self.decimals:
            return False
        return reads(found[1], self.value, self.slack, DIGITS if self.decimals is None else 0)


def faults(lines: Iterable[str], study: Study) -> Iterator[Wrong]:
    """See that each line and number that is said first is due, and that each that is due is said once."""
    told = [*lines]
    said = [part for line in told for one in line.splitlines() for part in one.split(", ") if BEGUN.match(part)]
    due = [*_motion(study)] if "linkage" in study.techniques else []
    due += [*_drive(study)] if "forces" in study.techniques else []
    yield from (message("wrong.told", text=part) for part in said if not any(one.tells(part) for one in due))
    for one in due:
        if sum(one.tells(part) for part in said) != 1:
            yield message("wrong.missing", name=one.before.partition(" = ")[0])
    yield from _sentences([one for line in told for one in line.splitlines()], study)


def _sentences(said: Sequence[str], study: Study) -> Iterator[Wrong]:
    """See that what each technique says in a sentence is said once, as the analysis has it, and nothing else is."""
    names = [one for one in study.techniques if one in SENTENCES]
    sentences = [named(SENTENCES[name])(study) for name in names]
    for name, tells in zip(names, sentences, strict=True):
        if tells is not None and sum(map(tells, said)) != 1:
            yield message("wrong.missing", name=term(study.scene.sheet.language, "kind", KINDS.get(name, name)))
    left_open = sum(tells is None and name in OPEN for name, tells in zip(names, sentences, strict=True))
    whole = [*_whole(study)]
    yield from (message("wrong.missing", name=one) for one in whole if said.count(one) != 1)
    others = [one for one in said if one not in whole and not any(tells and tells(one) for tells in sentences)]
    strange = [one for one in others if not all(BEGUN.match(part) for part in one.split(", "))]
    yield from (message("wrong.told", text=one) for one in strange[left_open:])


def _whole(study: Study) -> Iterator[str]:
    """Give the lines that stand as they are: the output, and loads of one stroke that reverse within it."""
    for name in (one for one in study.techniques if one in WHOLE):
        yield from named(WHOLE[name])(study)


def _motion(study: Study) -> Iterator[Due]:
    """Give the stroke or the swing with the time ratio, and the greatest velocity and acceleration of the output."""
    own, comparison, language = study["linkage"], study.comparison("linkage"), study.scene.sheet.language
    extremes = None if own.travel is None else comparison.road.extremes(own.output)
    if extremes is not None:
        unit = f" {re.escape(lettering.word(language, 'm'))}"
        degrees = math.degrees(extremes.stroke)
        if extremes.sliding:
            yield Due("H = ", unit, extremes.stroke, KNOWN * extremes.stroke)
        else:
            yield Due("ψ = ", "°", degrees, KNOWN * degrees, ANGLE)
        if len(own.travel.rests) == 2:
            yield Due("K = ", "", extremes.ratio, KNOWN * extremes.ratio, RATIO)
    for order in (VELOCITIES, ACCELERATIONS):
        letter = (order.point if own.output.point else order.link).symbol
        name = f"{letter}_{own.output.point or own.output.link}"
        known = (one for one in comparison.of(order.plan) if one.name == name and np.isfinite(one.analysis).any())
        yield from (_greatest(one, name, language) for one in known)


def _drive(study: Study) -> Iterator[Due]:
    """Give the greatest of what balances the drive; what is but rounding is none."""
    statics, comparison, language = study["forces"], study.comparison("forces"), study.scene.sheet.language
    told = named(BALANCING)(statics.study.mechanism.drive)
    by_force = told.unit != "N" or statics.study.mechanism.drive.pushed
    nothing = float(told.share * comparison.construction.nothing[by_force])
    letter = lettering.letter(language, told.name)
    known = (one for one in comparison.findings if one.name == told.name and np.isfinite(one.analysis).any())
    yield from (_greatest(one, letter, language, nothing) for one in known)


def _greatest(finding: Finding, letter: str, language: str, nothing: float = 0.0) -> Due:
    sizes, allowed = np.abs(finding.analysis), finding.allowed[np.isfinite(finding.allowed)]
    slack = float(allowed.max(initial=0.0)) + nothing
    largest = float(sizes[np.isfinite(sizes)].max(initial=0.0))
    parts = {"letter": letter, "unit": lettering.word(language, finding.unit), "size": "\0", "position": "\0"}
    before, unit, behind = word(language, "report.greatest", **parts).split("\0")
    own = largest + KNOWN * largest <= sizes + slack + 2 * KNOWN * largest
    places = frozenset(np.flatnonzero(own).tolist()) | ({0} if largest <= slack else frozenset())
    return Due(before, f"{re.escape(unit)}(\\d+){re.escape(behind)}", largest, slack + KNOWN * largest, None, places)
