"""plandraft grade: sheets that students hand in, held against the scene vector by vector."""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Sequence
from functools import partial
from hashlib import sha256
from itertools import chain, count
from pathlib import Path

from drawings.commands.stderr import tell
from drawings.files.atomic_files import print_json, write
from drawings.grading.allowance import Allowances, allowance
from drawings.grading.class_list import grade_all, grade_own
from drawings.grading.feedback import HEAD, feedback, is_plain, lines, plain, plain_name, row
from drawings.grading.graded import FAIL, OURS, PASS, UNREAD, Graded, Hints, grade, idle_keys, sheet_task
from drawings.grading.verdict import Marking, read_marking
from drawings.paper.limits import SHEET_BYTES
from drawings.redrawn import Originals
from geometry.errors import regular_bytes
from plans.words.words import word

# The exit codes of a class: the gravest first.
CODES = {OURS: 1, UNREAD: 5, FAIL: 4, PASS: 0}


def run(options: argparse.Namespace) -> int:
    """Grade sheets; give the exit code."""
    marking = read_marking(options.marks) if options.marks else Marking()
    read = {name: allowance(text) for name, text in marking.tolerance.items()}
    by = Allowances(options.tolerance, {name: allowed for name, allowed in read.items() if allowed is not None})
    originals = Originals(options.scene)
    task = sheet_task(originals)
    language = options.language or originals.language
    if not task.sheets:
        tell(word(language, "accept.ungraded", scene=plain_name(options.scene)))
        return CODES[UNREAD]
    if idle := idle_keys(marking, task):
        tell(word(language, "grade.marks.idle", file=options.marks, names=idle))
    if grade_own(originals, task, by).outcome != PASS:
        tell(word(language, "grade.self"))
        return CODES[OURS]
    graded = list(grade_all(options.sheets, partial(grade, task=task, by=by)))
    _print(options, graded, task.hints, marking, language)
    if options.output:
        write_feedback(options.output, graded, task.hints, language)
    _tell_twins(graded, language)
    # Sheets that were drawn of another scene, by their own data: a variant of somebody else's.
    if names := tuple(plain_name(path) for path, sheet in graded if sheet.scene not in ("", originals.digest)):
        tell(word(language, "grade.strangers", names=names))
    outcomes = {sheet.outcome for _, sheet in graded}
    return next(code for outcome, code in CODES.items() if outcome in outcomes)


def _print(
    options: argparse.Namespace, graded: Sequence[tuple[Path, Graded]], hints: Hints, marking: Marking, language: str
) -> None:
    if options.json:
        sheets = [plain(path, sheet, marking, language) for path, sheet in graded]
        print_json({"tolerance": str(options.tolerance.stated), "sheets": sheets})
    elif options.csv:
        table = csv.writer(sys.stdout, lineterminator="\n")
        table.writerows([HEAD, *(row(path, sheet, marking, language) for path, sheet in graded)])
    else:
        for path, sheet in graded:
            print("\n".join(lines(path, sheet, marking, hints, language)))
        print(word(language, "grade.tolerance", tolerance=options.tolerance.stated))


def write_feedback(folder: Path, graded: Sequence[tuple[Path, Graded]], hints: Hints, language: str) -> None:
    """Write the feedback sheets of those that were graded, one for each file."""
    folder.mkdir(parents=True, exist_ok=True)
    taken = set[str]()
    for path, sheet in graded:
        if sheet.reason is not None:
            continue
        source = _again(path, sheet)
        if source is None or not is_plain(source):
            tell(word(language, "grade.packed" if source else "grade.changed", sheet=plain_name(path)))
            continue
        names = chain((path.stem,), (f"{path.stem}-{number}" for number in count(2)))
        stem = next(name for name in names if name.casefold() not in taken)  # however its letters are cased
        taken.add(stem.casefold())
        write(folder / f"{stem}-feedback.svg", feedback(path, source, sheet, hints, language))


def _again(path: Path, graded: Graded) -> bytes | None:
    """Read a graded sheet once more; None where it is no longer the one that was graded."""
    try:
        source = regular_bytes(path, SHEET_BYTES + 1)
    except OSError:
        return None
    return source if sha256(source).hexdigest() == graded.digest else None


def _tell_twins(graded: Sequence[tuple[Path, Graded]], language: str) -> None:
    names: dict[str, list[str]] = {}
    for path, sheet in graded:
        names.setdefault(sheet.digest, []).append(plain_name(path))
    for digest, twins in names.items():
        if digest and len(twins) > 1:
            tell(word(language, "grade.twins", names=tuple(twins)))
