"""Fuzzing of `check` and `measure`, and with `--grade` of `grade`: `python -m tests.fuzz_sheets --seconds 600`.

Written sheets are changed at random in their bytes, elements and attributes; what is graded also in its layers, in its
length and without data. Whatever they are then, the commands must end with a verdict or one
message, and no exception of any other kind. `--seed 7` begins elsewhere.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import sys
import time
import traceback
from collections import Counter
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

from drawings.commands import cli
from drawings.commands.check import lines, plain
from drawings.files.atomic_files import json_text
from drawings.grading import feedback as told
from drawings.grading.allowance import EXACT, Allowances
from drawings.grading.feedback import feedback, is_plain
from drawings.grading.graded import SheetTask, grade, sheet_task
from drawings.grading.verdict import Marking
from drawings.redrawn import Originals, check
from tests.forgeries.chance_edits import CHANGES, HANDED_IN

GALLERY = Path(__file__).parents[1] / "drawings" / "gallery"
SCENES = ("fan", "crank-rocker", "shaper-feed", "engine-share", "valve-cam", "slider-crank")
MEASURED = {0, 3, 5, 7, 8}


class UndeclaredError(Exception):
    """An exception that is not declared, with the sheet that raised it."""


def trials(scenes: Sequence[str], seed: int) -> list[tuple[Originals, str, bytes]]:
    """Give the sheets that are changed, with their scenes."""
    found = [Originals(GALLERY / f"{name}.toml") for name in scenes]
    return [(own, sheet.name, own.drawn(sheet)) for own in found for sheet in own.sheets]


def tried(own: Originals, name: str, source: bytes, folder: Path) -> str:
    """Check and measure one sheet; give how both ended."""
    path = folder / name
    checked = check(path, source, own)
    for language in ("en", "ru"):
        json_text(plain(path, language, checked))
        list(lines(path, language, checked))
    path.write_bytes(source)
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as said:
        code = cli.main(["measure", str(path)])
    if code not in MEASURED:
        raise UndeclaredError(f"measure ended with {code}: {said.getvalue()}")
    return f"check {checked.exit_code}, measure {code}"


@cache
def asked(own: Originals) -> SheetTask:
    """Give what the sheets of a scene ask for, found once."""
    return sheet_task(own)


def handed_in(own: Originals, name: str, source: bytes, _: Path) -> str:
    """Grade one sheet, and tell of it in every form; give how it ended."""
    task = asked(own)
    for by in (Allowances(), Allowances(EXACT)):
        graded = grade(source, task, by)
    for language in ("en", "ru"):
        json_text(told.plain(Path(name), graded, Marking(), language))
        list(told.lines(Path(name), graded, Marking(), task.hints, language))
        told.row(Path(name), graded, Marking(), language)
        if graded.reason is None and is_plain(source):
            feedback(Path(name), source, graded, task.hints, language)
    return f"grade: {graded.outcome}"


def main(arguments: Sequence[str] | None = None) -> int:
    """Fuzz for a time, or so many sheets; give 1 if any undeclared exception came."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz_sheets", description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--sheets", type=int, default=sys.maxsize, help="at most so many")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--scene", action="append", help="of the gallery")
    parser.add_argument("--grade", action="store_true", help="grade the sheets instead")
    wanted = parser.parse_args(arguments)
    once, changes = (handed_in, HANDED_IN) if wanted.grade else (tried, CHANGES)
    ends, bugs, longest = Counter[str](), 0, 0.0
    own = trials(wanted.scene or SCENES, wanted.seed)
    if wanted.grade:
        own = [one for one in own if one[1] in asked(one[0]).sheets]
    until = time.monotonic() + wanted.seconds
    with TemporaryDirectory() as folder:
        for number in range(wanted.sheets):
            if time.monotonic() > until:
                break
            chance = Random(f"{wanted.seed} {number}")
            originals, name, source = chance.choice(own)
            forged, began = chance.choice(changes)(source, chance), time.process_time()
            try:
                ends[once(originals, name, forged, Path(folder))] += 1
            except Exception:
                bugs += 1
                print(f"seed {wanted.seed}, sheet {number} ({name}):\n{traceback.format_exc()}", flush=True)
            longest = max(longest, time.process_time() - began)
    for end, count in sorted(ends.items()):
        print(f"{end:<24} {count:>7}")
    print(f"sheets: {ends.total() + bugs}, undeclared exceptions: {bugs}; the longest took {longest:.1f} s of work")
    return 1 if bugs else 0


if __name__ == "__main__":
    sys.exit(main())
