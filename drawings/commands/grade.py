"""plandraft grade: sheets that students hand in, held against the scene vector by vector."""

from __future__ import annotations

import argparse
import csv
import sys
from collections import Counter
from collections.abc import Sequence
from functools import partial
from hashlib import sha256
from itertools import chain, count
from pathlib import Path

from drawings.commands.stderr import tell
from drawings.files.atomic_files import write
from drawings.files.file_error import print_json
from drawings.grading.asked import Allowances, ungraded
from drawings.grading.curves.figure_records import FIGURES
from drawings.grading.feedback import allowance, feedback, idle_keys, is_plain, written
from drawings.grading.graded import FAIL, OURS, PASS, UNREAD, Graded, grade
from drawings.grading.marking import RECORDS, Marking, MarkingError, read_marking
from drawings.grading.roll import grade_all, grade_own
from drawings.grading.sheet_task import sheet_task
from drawings.grading.told import HEAD, Hints, curve_hints, hints, lines, plain, plain_name, row
from drawings.paper.limits import SHEET_BYTES
from drawings.redrawn.originals import Originals
from geometry.regular_file import regular_bytes
from plans.words.words import message, word

# The exit codes of a class: the gravest first.
CODES = {OURS: 1, UNREAD: 5, FAIL: 4, PASS: 0}


def run(options: argparse.Namespace) -> int:
    """Grade sheets; give the exit code."""
    marking = read_marking(options.marks) if options.marks else Marking()
    by = _allowances(options, marking)
    originals = Originals(options.scene)
    task = sheet_task(originals)
    language = options.language or originals.language
    for kind in ungraded(originals, {**RECORDS, **FIGURES}):
        tell(word(language, "grade.ungraded", kind=kind))
    if not task.sheets:
        tell(word(language, "accept.ungraded", scene=plain_name(options.scene)))
        return CODES[UNREAD]
    if idle := idle_keys(marking, task):
        tell(word(language, "grade.marks.idle", file=options.marks, names=idle))
    own = grade_own(originals, task, by)
    if own.outcome != PASS:
        tell(word(language, "grade.self"))
        return CODES[OURS]
    graded = list(grade_all(options.sheets, partial(grade, task=task, by=by)))
    steps = dict(curve_hints(task.curves)) | {name: own for plan in task.plans for name, own in hints(plan)}
    _print(options, graded, steps, marking, language)
    if options.output:
        write_feedback(options.output, graded, steps, language)
    _tell_twins(graded, language)
    _tell_strangers(graded, originals.digest, language)
    return next(code for outcome, code in CODES.items() if any(one.outcome == outcome for _, one in graded))


def _allowances(options: argparse.Namespace, marking: Marking) -> Allowances:
    own = {}
    for name, text in marking.tolerance.items():
        read = allowance(text)
        if read is None:
            raise MarkingError(message("grade.marks.tolerance", file=options.marks, name=f"tolerance.{name}"))
        own[name] = read
    return Allowances(options.tolerance, own)


def _print(
    options: argparse.Namespace,
    graded: Sequence[tuple[Path, Graded]],
    steps: Hints,
    marking: Marking,
    language: str,
) -> None:
    if options.json:
        sheets = [plain(path, one, marking, language) for path, one in graded]
        print_json({"tolerance": written(options.tolerance), "sheets": sheets})
    elif options.csv:
        table = csv.writer(sys.stdout, lineterminator="\n")
        table.writerows([HEAD, *(row(path, one, marking, language) for path, one in graded)])
    else:
        for path, one in graded:
            print("\n".join(lines(path, one, marking, steps, language)))
        print(word(language, "grade.tolerance", tolerance=written(options.tolerance)))


def write_feedback(folder: Path, graded: Sequence[tuple[Path, Graded]], steps: Hints, language: str) -> None:
    """Write the feedback sheets of those that were graded, one for each file."""
    folder.mkdir(parents=True, exist_ok=True)
    taken = set[str]()
    for path, one in graded:
        if one.reason is not None:
            continue
        source = _again(path, one)
        if source is None or not is_plain(source):
            tell(word(language, "grade.packed" if source else "grade.changed", sheet=plain_name(path)))
            continue
        stem = _free(path.stem, taken)
        write(folder / f"{stem}-feedback.svg", feedback(path, source, one, steps, language))


def _again(path: Path, graded: Graded) -> bytes | None:
    """Read a graded sheet once more; None where it is no longer the one that was graded."""
    try:
        source = regular_bytes(path, SHEET_BYTES + 1)
    except OSError:
        return None
    return source if sha256(source).hexdigest() == graded.digest else None


def _free(stem: str, taken: set[str]) -> str:
    """Take a name that no other sheet has, however its letters are cased: by itself, or with a number."""
    names = chain((stem,), (f"{stem}-{number}" for number in count(2)))
    free = next(name for name in names if name.casefold() not in taken)
    taken.add(free.casefold())
    return free


def _tell_twins(graded: Sequence[tuple[Path, Graded]], language: str) -> None:
    """Say which sheets are the same file under several names."""
    times = Counter(one.digest for _, one in graded if one.digest)
    for digest in (digest for digest, often in times.items() if often > 1):
        names = tuple(plain_name(path) for path, one in graded if one.digest == digest)
        tell(word(language, "grade.twins", names=names))


def _tell_strangers(graded: Sequence[tuple[Path, Graded]], own: str, language: str) -> None:
    """Say which sheets were drawn of another scene, by their own data: a variant of somebody else's."""
    if names := tuple(plain_name(path) for path, one in graded if one.scene not in ("", own)):
        tell(word(language, "grade.strangers", names=names))
