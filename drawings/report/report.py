"""The report of a scene: chapters of its techniques, tables, agreement of the roads, gaps (пояснительная записка)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from itertools import count
from typing import Any, NamedTuple

import numpy as np

from drawings.lettering.words import RAISED, decimal, fixed, letter, number, runs, span
from drawings.page.page import Drafting
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, drawn, entry, literal, mathed
from geometry.board import Mark
from plans.model.mechanism import Drive
from plans.model.motion import Complexes, Floats, Gap
from plans.quantity import EQUILIBRIUM, SLIP, Comparison, Quantity, together
from plans.study import Study
from plans.techniques import TECHNIQUES, techniques
from plans.words.words import ENGLISH, Message, message, term, word, written


def chapter(language: str, name: str) -> str:
    """Give the head of a chapter, with what is said before its tables."""
    return f"\n{word(language, f'report.{name}')}\n"


def row(cells: Sequence[str]) -> str:
    """Write a row of a table."""
    return f"| {' | '.join(cells)} |"


def header(heads: Sequence[str]) -> list[str]:
    """Write the heads of a table's columns."""
    return [row(heads).replace("|  |", "| |"), "|" + "---|" * len(heads)]


def ruled(table: Sequence[Sequence[str]]) -> list[str]:
    """Write a table by its rows, the first of them its headings."""
    return [*header(table[0]), *map(row, table[1:])]


def united(heads: Iterable[str], drafting: Drafting) -> list[str]:
    """Write the units of the heads of columns, which stand behind a comma, in the language of the report."""
    parts = (head.partition(", ") for head in heads)
    return [f"{name}{comma}{drafting.word(unit) if unit else unit}" for name, comma, unit in parts]


def tabled(
    heads: Sequence[str], columns: Iterable[Any], language: str, gap: str = "", names: Iterable[object] = ()
) -> list[str]:
    """Write a table of positions by their names, or of all from 0 on."""
    rows = zip(*(column(values, language, gap) for values in columns), strict=True)
    named = zip(names or count(), rows, strict=False)
    return [*header([word(language, "table.position"), *heads]), *(row([str(name), *cells]) for name, cells in named)]


def column(values: Any, language: str, gap: str = "") -> list[str]:
    """Write numbers, or vectors as x; y, to the decimals that the largest of them has.

    >>> column([12.3456, 0.00012, math.nan], "en"), column([1 - 0.5j], "ru"), column([0.0, 2e6], "en")
    (['12.3456', '0.0001', 'gap'], ['1,00000; −0,50000'], ['0', '2000000'])
    """
    numbers = np.asarray(values)
    sizes = np.abs([numbers.real, numbers.imag])
    largest = float(np.max(sizes[np.isfinite(sizes)], initial=0.0))
    places = MOST - 1 - math.floor(math.log10(largest)) if largest else 0
    gap = gap or word(language, "table.gap")
    return [gap if math.isnan(abs(value)) else _cell(value, places, language) for value in numbers.tolist()]


def _cell(value: complex, places: int, language: str) -> str:
    if isinstance(value, complex):
        return f"{_cell(value.real, places, language)}; {_cell(value.imag, places, language)}"
    if math.isinf(value):
        return "∞"
    if abs(value) < 0.5 * 10.0**-places:
        return "0"
    return fixed(value, language, places) if places >= 0 else number(value, language, DIGITS)


ANGLE = "\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}"  # between the size of a vector and its direction
MOST = 6  # digits of the largest number of a column, so that a hundredth of it still has four
PLAIN = 1e-3  # a smaller number is written by its power of ten


def tiny(value: float, language: str) -> str:
    """Write a difference with two digits.

    >>> tiny(-2.46e-16, "ru"), tiny(0.165, "ru"), tiny(0.0, "ru")
    ('−2,5·10⁻¹⁶', '0,17', '0')
    """
    if abs(value) >= PLAIN or not value:
        return number(value, language, 2)
    mantissa, power = f"{value:.1e}".replace("-", "−", value < 0).split("e")
    return f"{decimal(mantissa, language)}·10{str(int(power)).translate(RAISED)}"


def heading(finding: Quantity, language: str) -> str:
    """Name a quantity with its unit, if it has one."""
    unit = term(language, "unit", finding.unit)
    return f"{quantity(finding.name, language)}, {unit}" if unit else quantity(finding.name, language)


def quantity(name: str, language: str) -> str:
    """Name a quantity: its letter, and in words what tells it from others of that letter.

    >>> quantity("M_bal lever", "en"), quantity("M_bal lever", "ru")
    ('M_bal lever', 'M_ур по рычагу')
    >>> quantity("m_cw4", "ru")
    'm_пр4'
    >>> quantity("M_red, J_red exact", "ru")
    'M_пр, J_пр без участков'
    """
    parts = name.split(" ")
    if len(parts) == 1:
        text = written(term(language, "quantity", name), language)
    else:
        text = " ".join(term(language, "quantity", term(language, "quantity_part", part)) for part in parts)
    return re.sub(r"[^\s,±]+", lambda part: letter(language, part[0]), text)


class TableSubject(NamedTuple):
    """The subject of a study: its structure and what comes out of it, and both in a sentence."""

    structure: str
    output: str
    sentence: str


def titled(study: Study) -> TableSubject:
    """Tell a scene by its title, where its first technique has no more to say."""
    title = study.scene.heading(ENGLISH)
    return TableSubject(title, "", f"{title}.")


class Report(NamedTuple):
    """What one technique tells; it is the REPORT of its file report.py."""

    chapters: Callable[[Study, Mapping[str, Sequence[Leaf]]], Chapters]  # what was found, beside the leaves by sheets
    headline: Callable[[Study], str] = lambda study: ""  # a line about it on the screen, or nothing
    remarks: Callable[[Study], Iterable[Message]] = lambda study: ()  # what is not whole: gaps, dead centres, jams
    subject: Callable[[Study], TableSubject] = titled  # what is studied, for the gallery's page: by its first technique
    conclusion: Callable[[Study], Iterable[str]] | None = None  # what follows from the numbers; None: its headline
    equations: Callable[[Study, Mark, int], Iterable[str]] = lambda study, mark, position: ()  # that give a mark


def _quantities(technique: str, study: Study, _: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the quantities of a technique by both roads."""
    language = study.scene.sheet.language
    heads = [word(language, key) for key in ("table.quantity", "sheet.by plan", "sheet.by analysis")]
    found = (finding for finding in study.quantities(technique) if finding.plan != EQUILIBRIUM)
    both = ((one, _size(one, one.construction, language), _size(one, one.analysis, language)) for one in found)
    rows = (row([heading(finding, language), *sizes]) for finding, *sizes in both)
    return Chapters(values=[chapter(language, technique), *header(heads), *rows])


def _size(finding: Quantity, road: Complexes | Floats, language: str) -> str:
    """Write how large a quantity is by a road, at the least and at the most over all positions; rounding is 0."""
    sizes = zip(abs(road).tolist(), finding.allowed.tolist(), strict=True)
    return span([size * (size > allowed) for size, allowed in sizes if math.isfinite(size)] or [0.0], language)


def report_of(technique: str) -> Report:
    """Give what tells a technique: where its folder has no report.py, its quantities in a table.

    >>> report_of("rotor").subject.__module__
    'drawings.rotor.report'
    """
    if find_spec(f"drawings.{technique}.report") is None:
        return Report(partial(_quantities, technique))
    report: Report = import_module(f"drawings.{technique}.report").REPORT
    return report


NOISE = 11  # powers of ten: a smaller share of the largest is rounding, which differs from machine to machine


def share(findings: Sequence[Quantity]) -> str:
    """Write the least power of ten of the largest values that no difference is beyond."""
    shares = [
        float(np.nanmax(finding.difference / np.fmax(np.abs(finding.construction), finding.largest), initial=0.0))
        for finding in findings
        if finding.largest > 0
    ]
    power = max(math.ceil(math.log10(max(shares, default=0.0) or math.ulp(0.0))), -NOISE)
    return f"10^{{−{-power}}}" if power else "1"


def gap_lines(gaps: Sequence[Gap]) -> list[Message]:
    """Say why positions have no result; those of one gap are told with the advice for the first of them."""
    kinds: dict[tuple[str, str, object], list[Gap]] = {}
    for gap in gaps:
        kinds.setdefault((gap.plan, gap.reason, gap.where), []).append(gap)
    return [_line(together) for together in kinds.values()]


def _line(together: Sequence[Gap]) -> Message:
    first = together[0]
    parts = {"plan": first.plan, "reason": first.reason, "where": first.where, "advice": first.advice}
    key = "verdict.gap" if len({gap.advice for gap in together}) == 1 else "verdict.gap_in"
    return message(key, **positions([gap.position for gap in together]), first=first.position, **parts)


def gap_line(key: str, gap: Gap, drive: Drive, language: str) -> str:
    """Tell one gap in the report, by the key of its line, or of a slider that drives by `key_way`."""
    parts = {"plan": gap.plan, "reason": gap.reason, "advice": gap.advice, "position": gap.position}
    if drive.pushed:
        return word(language, f"{key}_way", way=fixed(1000 * drive.unit * gap.phi, language, 3), **parts)
    return word(language, key, angle=fixed(math.degrees(gap.phi), language, 3), **parts)


def positions(numbers: Sequence[int]) -> dict[str, object]:
    """Give numbers of positions, runs of them by their ends, as the parts of a message: how many, and which."""
    return {"count": len(numbers), "positions": runs(numbers, "-")}


PLAN_WIDTH = 14  # letters of the longest plan's English word


def report(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> str:
    """Write the report beside the sheets, whose leaves are given by kind."""
    return text_of(lines(study, leaves))


def text_of(lines: Iterable[str]) -> str:
    """Write lines one under another."""
    return "\n".join(lines) + "\n"


def lines(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> list[str]:
    """Give the lines of the report; phrases among them say which quantities their numbers are."""
    chapters = [report_of(name).chapters(study, leaves) for name in study.techniques]
    language = study.scene.sheet.language
    kinds = ", ".join(term(language, "kind", kind) for kind in leaves)
    idle = (said.worded(language) for name in _idle(study) for said in techniques()[name].idle(study.scene))
    left_out = [*(line for chapter in chapters for line in chapter.left_out), *idle]
    body = [
        *([chapter(language, "sheets"), *drawn(leaves, language), ""] if any(leaves.values()) else []),
        *(line for chapter in chapters for line in chapter.subject),
        *(line for chapter in chapters for line in chapter.values),
        *_comparison(study.comparisons, language),
        *([word(language, "report.by_hand", slip=number(SLIP, language))] if any(leaves.values()) else []),
        *(line for chapter in chapters for line in chapter.conditions),
        *_conclusion(study, language),
        *((chapter(language, "left_out"), *left_out) if left_out else ()),
    ]
    title = word(language, "report.title", title=literal(study.scene.heading(language)), sheets=kinds)
    return [title, *(mathed(line, language) for line in body)]


def _conclusion(study: Study, language: str) -> Iterator[str]:
    """Say what follows from the numbers: of each technique, how far both roads agree, and what is not whole."""
    yield chapter(language, "conclusion")
    for report in map(report_of, study.techniques):
        lines = report.conclusion(study) if report.conclusion is not None else report.headline(study).splitlines()
        yield from (line if line.startswith("- ") else entry(_begun(line)) for line in lines)
    findings = together(study.comparisons)
    if findings:
        yield word(language, "report.agreed", count=len(findings), share=share(findings))
    yield from (f"- {line.worded(language)}" for line in remarks(study))


def _begun(line: str) -> str:
    """Begin a sentence with a capital; a letter of a quantity stays what it is."""
    return re.sub(r"^[^\W\d_]+\b(?![\^{]| [=≈])", lambda word: word[0][:1].upper() + word[0][1:], line)


def _idle(study: Study) -> Iterator[str]:
    """Give the techniques that rest on what is studied, and are neither asked for nor read by those that are."""
    taken = {*study.techniques, *(term for name in study.techniques for term in techniques()[name].borrows)}
    rest = (name for name in TECHNIQUES if name not in taken)
    return (name for name in rest if not set(techniques()[name].needs).isdisjoint(study.techniques))


def headlines(study: Study) -> Iterator[str]:
    """Give what each technique says first of a study."""
    yield from filter(None, (report_of(name).headline(study) for name in study.techniques))


def remarks(study: Study) -> list[Message]:
    """Give what is not whole about a study: gaps, positions that are not for grading, pairs that jam."""
    return [line for name in study.techniques for line in report_of(name).remarks(study)]


def summary(comparisons: Iterable[Comparison], language: str) -> str:
    """Give the short comparison: the worst difference of each plan in per cent of its largest, and of the allowed."""
    listed = list(comparisons)
    wide = plan_width((finding.plan for finding in together(listed)), language)
    heads = [word(language, f"table.{head}") for head in ("plan", "difference", "percent", "allowed", "in")]
    lines = [f"{heads[0]:<{wide}} {heads[1]:>18} {heads[2]:>21} {heads[3]:>15}   {heads[4]}"]
    for comparison in listed:
        for plan in dict.fromkeys(finding.plan for finding in comparison.findings):
            lines.append(f"{term(language, 'plan', plan):<{wide}} {_worst(comparison.of(plan), language)}")
    return "\n".join([*lines, *left_out(listed, language)])


def plan_width(plans: Iterable[str], language: str) -> int:
    """Give the width of a column of plans on the screen, in letters."""
    return max((PLAN_WIDTH, *(len(term(language, "plan", plan)) for plan in plans)))


def _worst(findings: Sequence[Quantity], language: str) -> str:
    worst = _worst_of(findings)
    per_cent = max(finding.per_cent for finding in findings)
    unit, name = term(language, "unit", worst.unit), quantity(worst.name, language)
    numbers = f"{peak(worst.difference):>13.2e} {unit:<7} {per_cent:>18.2e} {peak(worst.excess):>15.3f}"
    return f"{decimal(numbers, language)}   {name}"


def left_out(comparisons: Iterable[Comparison], language: str) -> list[str]:
    """Tell which positions the comparisons leave out, as both roads give them up, and how many they are."""
    return [
        word(language, "compare.left_out", plan=plan, positions=message("compare.positions", **positions(missing)))
        for comparison in comparisons
        for plan, missing in comparison.left_out.items()
    ]


def _comparison(comparisons: Iterable[Comparison], language: str) -> Iterator[str]:
    """Tell of each plan what both roads differ in most."""
    yield chapter(language, "comparison")
    heads = ("plan", "quantity", "difference", "percent", "allowed")
    yield from header([word(language, f"table.{head}") for head in heads])
    for comparison in comparisons:
        for plan in dict.fromkeys(finding.plan for finding in comparison.findings):
            worst = _worst_of(comparison.of(plan))
            numbers = peak(worst.difference), worst.per_cent, peak(worst.excess)
            cells = [tiny(value, language) for value in numbers]
            yield row([term(language, "plan", plan), heading(worst, language), *cells])
    yield f"\n{word(language, 'report.all_differences')}"


def _worst_of(findings: Sequence[Quantity]) -> Quantity:
    return max(findings, key=lambda finding: (peak(finding.excess), peak(finding.difference)))


def peak(values: np.ndarray[tuple[int, ...], np.dtype[Any]]) -> float:
    """Give the largest of some numbers, gaps left out."""
    return float(np.nanmax(values)) if np.isfinite(values).any() else float(np.max(np.nan_to_num(values, nan=0.0)))
