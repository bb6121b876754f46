"""plandraft bench: error against run time of every technique on a scene, with the ratios and their goals."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from drawings.bench import plot, report, session
from drawings.files import atomic_files
from geometry.errors import LimitError
from plans.bench.trial import ACCEPTED, DRAWN, Demand
from plans.linkage.reading.fields import POSITIONS_LIMIT
from plans.scene.scene import read_scene
from plans.words.words import message, placed

GAPS = 4
POSITIONS, QUICK_POSITIONS = (12, 360, 10_000, 100_000), (12, 360)
REPETITIONS, QUICK_REPETITIONS = 15, 3


def run(options: argparse.Namespace) -> int:
    """Run a session and report it; give the exit code, in which no time has a part."""
    scene = read_scene(options.scene)
    if options.output is not None:
        plot.ready()
        atomic_files.prepare(options.output)
    found = session.session(scene, order(options), _tell)
    print(report.json_text(found) if options.json else report.written(found))
    if options.output is not None:
        stem = options.output / f"{Path(scene.file).stem}-bench"
        written = {stem.with_suffix(".csv"): report.csv_bytes(found), stem.with_suffix(".svg"): plot.svg(found)}
        for path, content in written.items():
            atomic_files.write(path, content)
            print(path, file=sys.stderr if options.json else sys.stdout)
    return GAPS if found.gaps else 0


def order(options: argparse.Namespace) -> Demand:
    """Say what the command line orders: its own words go before those of --quick."""
    usual = (QUICK_POSITIONS, QUICK_REPETITIONS) if options.quick else (POSITIONS, REPETITIONS)
    positions = tuple(sorted(set(options.positions or usual[0])))
    if positions[-1] > POSITIONS_LIMIT:
        raise LimitError(
            placed(
                f"--positions {positions[-1]}", message("limit.fewer", name="POSITIONS_LIMIT", limit=POSITIONS_LIMIT)
            )
        )
    startup = not options.quick if options.startup is None else options.startup
    drawn = positions[0] if options.quick else DRAWN
    return Demand(positions, options.repetitions or usual[1], startup, min(drawn, DRAWN), options.accept or ACCEPTED)


def _tell(what: str) -> None:
    """Say on a terminal what is being timed, in one line that is written over; nothing wipes it."""
    if sys.stderr.isatty():
        print(f"\r\x1b[Ktiming {what} ..." if what else "\r\x1b[K", end="", file=sys.stderr, flush=True)
