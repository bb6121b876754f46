"""The roll: each sheet of a class graded in a process of its own, with limits of memory and time (журнал группы)."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from drawings.files.atomic_files import of_system
from drawings.grading.allowance import Allowances
from drawings.grading.graded import OURS, PASS, UNREAD, Graded, SheetTask, grade
from drawings.paper.limits import SHEET_BYTES
from drawings.redrawn import Originals
from geometry.errors import regular_bytes
from plans.words.words import message


def grade_own(originals: Originals, task: SheetTask, by: Allowances) -> Graded:
    """Grade the scene's own sheets; the first that is not right is told."""
    every = [grade(originals.drawn(sheet), task, by) for sheet in originals.sheets if sheet.name in task.sheets]
    return next((sheet for sheet in every if sheet.outcome != PASS), Graded(PASS if every else UNREAD))


# Seconds of work on one sheet: our own take under two, one of ten megabytes takes eight.
SECONDS = 30.0
# Seconds that a process may be there at all: so busy a machine may be, or so long it may wait for nothing.
PATIENCE = 4 * SECONDS
# Bytes that a process may take beyond those of the one it came from, which has some fifty: of the sheets that may be
# handed in the worst needs 61 megabytes, of ten megabytes full of lines.
MEMORY = 96 * 1024**2
# How a process ends that has worked too long; Windows knows no such end.
SPENT = getattr(signal, "SIGXCPU", 0)
_STATM = Path("/proc/self/statm")  # of Linux: how much memory a process has

Answer = TypeVar("Answer")  # of one sheet, as it is asked for: graded, or checked


class _Work(NamedTuple):
    """A process that grades a sheet, until when it may be there, and whether it has the machine to itself."""

    path: Path
    process: Any
    until: float
    alone: bool


def grade_all(
    paths: Sequence[Path], grading: Callable[[bytes], Answer], workers: int | None = None
) -> Iterator[tuple[Path, Answer | Graded]]:
    """Grade sheets, as many at a time as there are processors; each is answered for, in the order of the paths.

    One that waits too long beside the others, and has not worked too long, is tried once more when they are done.
    """
    waiting, late, done = list(dict.fromkeys(paths)), list[Path](), dict[Path, Answer | Graded]()
    running: dict[Connection, _Work] = {}
    most = workers or os.cpu_count() or 1
    for path in dict.fromkeys(paths):
        while path not in done:
            while waiting and len(running) < most:
                running |= _begun(waiting.pop(0), grading)
            if not running:
                running |= _begun(late.pop(0), grading, alone=True)
            late += _gather(running, done)
        yield path, done[path]


def _begun(path: Path, grading: Callable[[bytes], Answer], alone: bool = False) -> dict[Connection, _Work]:
    """Begin to grade a sheet in a process that knows all that this one does."""
    how: Any = multiprocessing.get_context("fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn")
    ours, theirs = how.Pipe(duplex=False)
    process = how.Process(target=_work, args=(path, grading, theirs), daemon=True)
    process.start()
    theirs.close()
    return {ours: _Work(path, process, time.monotonic() + PATIENCE, alone)}


def _gather(running: dict[Connection, _Work], done: dict[Path, Answer | Graded]) -> Iterator[Path]:
    """Take what is graded, and end what takes too long; give what may have had to wait for others."""
    first = min(work.until for work in running.values())
    ready = wait(list(running), timeout=max(first - time.monotonic(), 0.0))
    late = [end for end, work in running.items() if end not in ready and time.monotonic() >= work.until]
    for end in (*ready, *late):
        assert isinstance(end, Connection)  # nothing else is waited for
        work = running.pop(end)
        if end in ready:
            done[work.path] = _answer(end, work)
        elif work.alone:
            done[work.path] = Graded(UNREAD, reason=message("grade.late"))
        else:
            yield work.path
        work.process.kill()
        work.process.join()
        end.close()


def _answer(end: Connection, work: _Work) -> Any:
    try:
        return end.recv()
    except (EOFError, OSError):
        work.process.join(1.0)
        if work.process.exitcode == -SPENT:
            return Graded(UNREAD, reason=message("grade.late"))
        return Graded(OURS, reason=message("grade.died", code=str(work.process.exitcode)))


def _work(path: Path, grading: Callable[[bytes], object], end: Connection) -> None:
    _limit()
    end.send(answered(path, grading))
    end.close()


def answered(path: Path, grading: Callable[[bytes], Answer]) -> Answer | Graded:
    """Grade one sheet of a file: what cannot be read is rejected, and what breaks is an error of ours."""
    try:
        return grading(regular_bytes(path, SHEET_BYTES + 1))
    except OSError as error:
        return Graded(UNREAD, reason=message("file.read", reason=of_system(error)))
    except MemoryError:
        return Graded(UNREAD, reason=message("grade.memory"))
    except Exception:
        return Graded(OURS, reason=message("grade.bug", error=traceback.format_exc(limit=-3)))


def _limit() -> None:
    """Limit what this process may take."""
    if sys.platform == "win32":
        return
    import resource  # noqa: PLC0415  (only Unix has it)

    if _STATM.exists():
        taken = int(_STATM.read_text("ascii").split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (taken + MEMORY, taken + MEMORY))
    spent = int(time.process_time()) + int(SECONDS) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (spent, spent + 1))  # the signal first, its end a second later
