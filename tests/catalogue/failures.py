"""Failures and kills (отказы и обрывы): every call that a run makes to the system fails, or the run is killed there.

`python -m tests.catalogue.failures` makes each call fail with three errors and kills the run at each, then at random
moments, and starts runs two at a time; after each it looks at the folder, and at what the next run says and leaves.
Fewer, evenly chosen: `--kills 10 --injections 10 --pairs 1`. The exit code is 0 where no fault was found.
"""

from __future__ import annotations

import argparse
import errno
import os
import random
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from tests.catalogue.disturbed_runs import Bench, Files, Outcome, Shim

ERRORS = (errno.ENOSPC, errno.EIO, errno.EACCES)


class Case(NamedTuple):
    """Where a run begins: the folder as it is then, and the whole set that was last in it."""

    name: str
    before: Path | None
    old: Files


def cases(bench: Bench) -> list[Case]:
    """Make the folders in which runs begin: none, with a set, with a set of more sheets, with an interrupted run."""
    for name in bench.scenes:
        bench.set_out(None)
        outcome = bench.run(bench.scene(name))
        assert outcome.code == 0, outcome.told
        bench.sets[name] = bench.seen()
        bench.out.rename(bench.work / f"before-{name}")
    found = [
        Case("no folder", None, {}),
        Case("a set", bench.work / "before-old", bench.sets["old"]),
        Case("a set of more sheets", bench.work / "before-more", bench.sets["more"]),
    ]
    return [*found, interrupted(bench, found[-1])]


def interrupted(bench: Bench, case: Case) -> Case:
    """Kill a run when a sheet of the last set is set aside and one file has its new name, and the others have not."""
    bench.set_out(case.before)
    assert bench.run(bench.scene("new"), lambda: Shim(3, killed, ("replace",))).code == -signal.SIGKILL
    return Case("an interrupted run", bench.out.rename(bench.work / "before-interrupted"), case.old)


def killed() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def spread(things: Sequence[Any], count: int | None) -> list[Any]:
    """Choose some things evenly."""
    if count is None or count >= len(things):
        return list(things)
    return [things[int((k + 0.5) * len(things) / count)] for k in range(count)]


def failing(code: int) -> Callable[[], None]:
    def fail() -> None:
        raise OSError(code, os.strerror(code))

    return fail


class Judge:
    """Looks at the folder that a disturbed run left, then at what the next run, of either scene, says and leaves."""

    def __init__(self, bench: Bench, new: Files) -> None:
        self.bench, self.new = bench, new
        self.counts: Counter[str] = Counter()

    def faults(self, case: Case, outcome: Outcome, turn: int) -> list[str]:
        """Name what is wrong, and count what was found."""
        found, wholes = self.bench.seen(), (case.old, self.new)
        mixed = found not in wholes
        self.counts["mixed until the next run" if mixed else "old set" if found == case.old else "new set"] += 1
        scene = self.bench.other if turn % 2 else self.bench.scene("new")
        after = self.bench.run(scene)
        left = self.bench.seen()
        noticed = "a run was stopped" in after.told or "not as it was drawn" in after.told
        clean = case.name != "an interrupted run"
        wrong = {
            "half files": any(content not in [whole.get(name) for whole in wholes] for name, content in found.items()),
            f"exit code {outcome.code}": outcome.code not in (0, 7, -signal.SIGKILL) or "Traceback" in outcome.told,
            "exit code 0 without the new set": outcome.code == 0 and found != self.new,
            "a failure that left neither set": outcome.code == 7 and mixed and clean,
            f"the next run ends with {after.code}": after.code != 0,
            "mixed sets unnoticed": mixed and not noticed,
            "mixed sets after the next run": left not in wholes or (not turn % 2 and left != self.new),
            "orphans after the next run": bool(self.bench.orphans()),
        }
        self.counts.update(name for name, so in wrong.items() if so)
        return [f"{name} {outcome.told} {after.told}" for name, so in wrong.items() if so]


class Trial(NamedTuple):
    """One disturbed run: the call that fails or at which it is killed; without one, it is killed after some time."""

    case: Case
    number: int = 0
    error: int = 0
    delay: float = 0.0

    def run(self, bench: Bench) -> Outcome:
        """Run into the folder of the case."""
        bench.set_out(self.case.before)
        scene = bench.scene("new")
        if not self.number:
            child = bench.start(scene)
            time.sleep(self.delay)
            os.kill(child, signal.SIGKILL)
            return bench.end(child)
        instead = failing(self.error) if self.error else killed
        return bench.run(scene, lambda: Shim(self.number, instead))

    def __str__(self) -> str:
        what = errno.errorcode[self.error] if self.error else "killed"
        return f"{self.case.name}: {what} at " + (f"call {self.number}" if self.number else f"{self.delay:.3f} s")


def trials(bench: Bench, begun: Sequence[Case], kills: int | None, injections: int | None) -> list[Trial]:
    """List the disturbed runs: all calls of all cases, or some of them; kills beyond these come at random moments."""
    places = []
    for case in begun:
        bench.set_out(case.before)
        bench.run(bench.scene("new"), lambda: Shim(0, killed))
        places += [(case, number) for number in range(1, int((bench.work / "count").read_text()) + 1)]
    failures = [Trial(case, number, error) for case, number in places for error in ERRORS]
    at_calls = [Trial(case, number) for case, number in places]
    moments, duration = random.Random(9), timed(bench)
    further = max(0, (len(at_calls) if kills is None else kills) - len(at_calls))
    at_random = [Trial(begun[k % len(begun)], delay=moments.uniform(0, 1.1 * duration)) for k in range(further)]
    return [*spread(failures, injections), *spread(at_calls, kills), *at_random]


def timed(bench: Bench) -> float:
    """Time a run, s."""
    began = time.perf_counter()
    bench.run(bench.scene("new"))
    return time.perf_counter() - began


def pair(bench: Bench, delay: float) -> list[str]:
    """Start two runs of scenes of one name with a delay between them: one set is whole, and who failed says why."""
    bench.set_out(None)
    first = bench.start(bench.scene("old"))
    time.sleep(delay)
    outcomes = [bench.end(child) for child in (bench.start(bench.scene("more")), first)]
    names = [name for name, outcome in zip(("more", "old"), outcomes, strict=True) if outcome.code == 0]
    refused = [outcome for outcome in outcomes if outcome.code != 0]
    wrong = [outcome.told for outcome in refused if outcome.code != 7 or "another run" not in outcome.told]
    if bench.seen() not in [bench.sets[name] for name in names] or bench.orphans():
        wrong.append("neither set is whole")
    return wrong


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the trials and print what was counted; give 1 where a fault was found."""
    parser = argparse.ArgumentParser(prog="python -m tests.catalogue.failures", description=__doc__)
    parser.add_argument("--kills", type=int, metavar="N", help="kills (default: one at every call)")
    parser.add_argument("--injections", type=int, metavar="N", help="failing calls (default: every call, three errors)")
    parser.add_argument("--pairs", type=int, default=15, metavar="N", help="pairs of runs at once (default: 15)")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as work:
        bench = Bench(Path(work))
        begun = cases(bench)
        judge, wrong = Judge(bench, bench.sets["new"]), []
        chosen = trials(bench, begun, options.kills, options.injections)
        for turn, trial in enumerate(chosen):
            wrong += [f"{trial}: {fault}" for fault in judge.faults(trial.case, trial.run(bench), turn)]
        duration = timed(bench)
        for k in range(options.pairs):
            wrong += [f"pair {k}: {fault}" for fault in pair(bench, 1.2 * duration * k / options.pairs)]
    print(*wrong, sep="\n", end="\n" if wrong else "")
    injected = sum(bool(trial.error) for trial in chosen)
    print(f"{injected} failures, {len(chosen) - injected} kills, {options.pairs} pairs: {dict(judge.counts)}")
    print(f"faults: {len(wrong)}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
