"""The chapters of a rotor in the report held to the analysis: every line in its turn, and no other (ротор в отчёте)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING

from drawings.checks.documents_old import chapters
from drawings.checks.note.lines import in_report, parts
from drawings.checks.precise import precise
from drawings.checks.reading import NOTES
from drawings.checks.rotor.rotor_sentences import GRAM_MILLIMETRES, IN_REPORT, RotorSentences, tells
from drawings.checks.wrong import Wrong, within
from drawings.lettering.rotor_letters import lowered
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.limits import DECIMALS
from drawings.paper.strokes import Line
from drawings.paper.walk import groups
from plans.model.balance_quality import grade_of, letters
from plans.rotor.balancing import UNBALANCES
from plans.rotor.letters import unbalance_letters
from plans.study import Study
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

OF_RESIDUALS = 3  # digits


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold what a report says of a rotor (row of the table of reports)."""
    rotor, drafting = study["rotor"].rotor, drafting_of(study.scene)
    own = RotorSentences(rotor, study.comparison("rotor").analysis, drafting)
    masses = [*own.masses()]
    seen = _part(text, "rotor", drafting)
    if not own.settled:
        yield from _held(seen[: len(masses)], masses)
        return
    residuals = Residuals(own, [leaf for one in leaves.values() for leaf in one])
    yield from _held(seen, [*masses, *own.sums()])
    yield from _held(_part(text, "counterweights", drafting), [*own.counterweights()])
    quality, drawn = _part(text, "quality", drafting), [*residuals.lines()]
    graded = [*own.quality()]
    yield from _held(quality[: len(graded)], graded)
    yield from _held(quality[len(graded) :], drawn, OF_RESIDUALS)
    yield from _held(_part(text, "bearings", drafting), [*own.reactions()])
    shared = [] if "balance" in study.techniques else ["counterweights"]
    yield from chapters.faults(text, drafting.language, ["rotor", *shared, "left_out", "rotor_left_out"])


def _part(text: str, key: str, drafting: Drafting) -> list[str]:
    """Give the lines of a chapter up to the next head of any kind; a balanced machine's of the same head is before."""
    return [[], *parts(text, word(drafting.language, f"report.{key}"))][-1]


def headline(study: Study) -> Callable[[str], bool] | None:
    """Give what tells whether a line says the counterweights of a rotor; nothing where rounding decides."""
    own = RotorSentences(study["rotor"].rotor, study.comparison("rotor").analysis, drafting_of(study.scene))
    due = "; ".join(map(in_report, own.counterweights()))
    return (lambda line: tells(line, due, IN_REPORT)) if own.settled else None


class Residuals:
    """How far the counterweights are off as the sheets show them, to the last decimal of a file."""

    def __init__(self, own: RotorSentences, leaves: Sequence[Leaf]) -> None:
        """Read them off the last polygon."""
        self.own = own
        true = {one.plane.name: 0j if one.moment.vanishes else one.moment.value for one in own.balance.corrections}
        seen = dict(_drawn(leaves))
        self.off = {name: abs(seen.get(unbalance_letters(name), 0j) - value) for name, value in true.items()}

    def lines(self) -> Iterator[str]:
        """Give what must be said of each plane, and of the whole by a grade."""
        rotor, language, number = self.own.rotor, self.own.drafting.language, precise(self.own.drafting).number
        for name, off in self.off.items():
            told = {"letters": lowered(unbalance_letters(name), language), "residual": number(GRAM_MILLIMETRES * off)}
            yield word(language, "report.plane_residual", **told)
        left = rotor.quality(*self.off.values())
        if left is None:
            return
        found = grade_of(left)
        told = {
            "quality": number(left),
            "grade": self.own.drafting.word("no grade") if found is None else letters(found),
        }
        if rotor.dynamic:
            yield word(language, "report.residual_quality_of_two", **told)
        elif self.own.balance.couple.vanishes:
            yield word(language, "report.residual_quality", **told)
        else:
            yield word(language, "report.resultant_quality", quality=told["quality"])


def _drawn(leaves: Sequence[Leaf]) -> Iterator[tuple[str, complex]]:
    """Give the static moments that are drawn, kg*m, from their ends as a pen writes them."""
    for one in (one for leaf in leaves for one in groups(leaf.groups) if one.data.get("plan") == UNBALANCES):
        if "name" in one.data and one.strokes and isinstance(line := one.strokes[0], Line):
            ends = (complex(round(end.real, DECIMALS), round(end.imag, DECIMALS)) for end in (line.end, line.start))
            end, start = ends
            yield one.data["name"], (end - start) * float(one.data["scale"])


def _held(seen: Sequence[str], due: Sequence[str], digits: int = IN_REPORT) -> Iterator[Wrong]:
    """Hold lines one for one."""
    for line, true in zip_longest(seen, due, fillvalue=""):
        plain = in_report(true)
        if not tells(" ".join(line.removeprefix("- ").split()), plain, digits):
            yield message("wrong.told", text=line) if line else within("missing_from", NOTES, name=plain)
