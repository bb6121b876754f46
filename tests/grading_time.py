"""How long a class takes: `python -m tests.grading_time --sheets 300`.

So many whole sheets of a scene, every tenth of them no sheet, are graded as `plandraft grade` does it; told are the
wall time, the time of work a sheet, and the memory of the largest process.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from drawings.grading.allowance import Allowances
from drawings.grading.class_list import grade_all
from drawings.grading.graded import grade, sheet_task
from drawings.redrawn import Originals
from tests.gallery import GALLERY


def class_of(own: Originals, count: int, folder: Path) -> list[Path]:
    """Write what a class hands in."""
    sheets = [own.drawn(sheet) for sheet in own.sheets]
    paths = [folder / f"{number}.svg" for number in range(count)]
    for number, path in enumerate(paths):
        path.write_bytes(b"<html/>" if number % 10 == 9 else sheets[number % len(sheets)])
    return paths


def main(arguments: Sequence[str] | None = None) -> None:
    """Grade a class and tell what it takes."""
    import resource  # only Unix has it

    parser = argparse.ArgumentParser(prog="python -m tests.grading_time", description=__doc__)
    parser.add_argument("--sheets", type=int, default=300)
    parser.add_argument("--scene", default="shaper", help="of the gallery")
    wanted = parser.parse_args(arguments)
    own = Originals(GALLERY / f"{wanted.scene}.toml")
    task = sheet_task(own)
    with TemporaryDirectory() as folder:
        paths = class_of(own, wanted.sheets, Path(folder))
        began, ends = time.monotonic(), Counter[str]()
        for _, graded in grade_all(paths, partial(grade, task=task, by=Allowances())):
            ends[graded.outcome] += 1
        spent, work = time.monotonic() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{wanted.sheets} sheets: {dict(sorted(ends.items()))}")
    print(f"{spent:.1f} s; {(work.ru_utime + work.ru_stime) / wanted.sheets:.2f} s of work a sheet")
    print(f"largest process: {work.ru_maxrss / 1024:.0f} MB, what it shares with its parent included")


if __name__ == "__main__":
    main()
