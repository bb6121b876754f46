"""A session at the bench: every technique on one scene at several numbers of positions, then the ratios (испытание)."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from drawings.bench import force_sheet, sheet
from drawings.bench.force_sheet import FORCES_BY_HAND, SCALED
from drawings.bench.startup import startup
from geometry.draughtsman import DRAWINGS, SEED
from geometry.errors import DraftError
from plans.bench import draughtsman
from plans.bench.computer import machine
from plans.bench.draughtsman import Toll
from plans.bench.error import DEFINED, FORCES_DEFINED, SIZED, TRUE, Errors, sizes
from plans.bench.forces import FORCES_ANALYSED, FORCES_CONSTRUCTED, asked
from plans.bench.peers import MECHANISM, PYLINKAGE
from plans.bench.result import Bench, Goal, Ratio, Row
from plans.bench.roads import CONSTRUCTION, ROUNDING, compared, ground, prepared, roads, timed
from plans.linkage.study import LinkageStudy
from plans.scene.scene import Scene
from plans.words.words import message, placed

SAMPLE = 24  # positions at which the truth is found: each takes 10 ms and more, and more of them show no other error
BUDGET = 1.0  # seconds of a row, after which it is repeated no more: the whole stays within a minute
STARTS = 5  # cold starts at most: each takes the better part of a second, and they differ little
ACCEPTED = 1e-4  # of the plan's largest: the fifth digit, the last that a sheet's table prints

# Half of the work of three plans is the positions'; what a compiled loop and three fsolves a position cost more.
GOALS: Mapping[tuple[str, int], Goal] = {
    (CONSTRUCTION[0], 360): Goal(0.5, least=False),
    (CONSTRUCTION[0], 100_000): Goal(0.5, least=False),
    (PYLINKAGE, 360): Goal(2.0),
    (PYLINKAGE, 100_000): Goal(8.0),
    (MECHANISM, 360): Goal(1000.0),
    # Forces take about as many acts as the motion that they rest on, and are read and judged besides.
    (FORCES_CONSTRUCTED, 360): Goal(3.0, least=False),
}
PENS, PENS_GOAL = "writing the sheet: svgwrite's defaults / ours", Goal(5.0)
NO_SHEET = f"a sheet shows at most {sheet.DRAWN} positions"

# Of 73 values that three textbooks print from their drawings (Khurmi and Gupta, Bevan, Sarkar), against exact ones, %.
BOOKS_MEDIAN, BOOKS_MOST = 0.84, 3.9


@dataclass(frozen=True)
class Order:
    """What is asked of a session."""

    positions: tuple[int, ...]
    rounds: int
    startup: bool = True
    drawn: int = sheet.DRAWN  # of more positions no sheet is drawn
    accepted: float = ACCEPTED


class NothingToMeasure(DraftError):  # noqa: N818  (the message's own word)
    """A scene without a position that can be assembled, or whose drive has no turn."""

    exit_code = 4


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session; `tell` hears what is being timed, and nothing when all is."""
    if not LinkageStudy(scene).mechanism.drive.turns:
        raise NothingToMeasure(placed(scene.file, message("refused.bench_stroke")))
    there, first = machine(), prepared(scene, SIZED)
    if first.lost.all():
        raise NothingToMeasure(f"{scene.file}: no position can be assembled, so there is nothing to measure")
    largest = sizes(first)
    rows: list[Row] = []
    for count in order.positions:
        tell(f"{count} positions")
        rows += _at(scene, count, order, largest)
    tell("the sheet by pen and by hand")
    hands, ratio, told = _paper(scene, order, largest)
    if asked(first):
        told += [FORCES_DEFINED, SCALED]
    ratios = [*_ratios(rows, order.positions), ratio]
    if order.startup:
        tell("start-up")
        ratios += _startup(scene, order)
    tell("")
    words = (*_words(order), *told)
    gaps = bool(LinkageStudy(scene).lost.any())
    return Bench(scene.heading(), there, (*rows, *hands), tuple(ratios), words, order.accepted, gaps)


def _at(scene: Scene, count: int, order: Order, largest: Mapping[str, float]) -> list[Row]:
    """Give the rows of one number of positions."""
    found = ground(scene, count, SAMPLE, largest)
    peers, left_out = compared(found)
    ways = [*roads(found), *peers]
    if count <= order.drawn:
        ways.append(sheet.road(found))
    else:
        why = NO_SHEET if count > sheet.DRAWN else "left out of a quick session"
        left_out |= dict.fromkeys((sheet.MEASURED, sheet.PRINTED), why)
    missing = [Row(name, count, note=why) for name, why in left_out.items()]
    return timed(ways, count, order.rounds, BUDGET) + missing


def _paper(scene: Scene, order: Order, largest: Mapping[str, float]) -> tuple[list[Row], Ratio, list[str]]:
    """Give the rows of hand drawing, the ratio of the pens, and what is to be said of the hands."""
    count = min(order.positions)
    if count > sheet.DRAWN:
        return _no_paper(NO_SHEET)
    study = prepared(scene, count)
    try:
        with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
            drawn = sheet.draw(study, Path(folder))
        tolls = sheet.by_hand(study, drawn, largest)
    except DraftError as error:
        return _no_paper(f"left out: {error}")
    rows = [_hand(name, toll, len(drawn.plans)) for name, toll in tolls.items()]
    if asked(study):
        rows += _forces_by_hand(study, drawn, largest)
    first, second = sheet.pens(max(drawn.leaves, key=lambda leaf: len(leaf.groups)), order.rounds, BUDGET)
    return rows, Ratio(PENS, count, first, second, PENS_GOAL), list(_told(tolls))


def _no_paper(why: str) -> tuple[list[Row], Ratio, list[str]]:
    names = [sheet.BY_HAND.format(slip) for slip in draughtsman.SLIPS]
    return [Row(name, None, note=why) for name in names], Ratio(PENS, None, goal=PENS_GOAL, note=why), []


def _forces_by_hand(study: LinkageStudy, drawn: sheet.DrawnSheets, largest: Mapping[str, float]) -> list[Row]:
    """Give the rows of forces drawn by hand, at the positions of the force sheets."""
    try:
        with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
            tolls, count = force_sheet.by_hand(study, drawn, largest, Path(folder))
    except DraftError as error:
        names = [FORCES_BY_HAND.format(slip) for slip in draughtsman.SLIPS]
        return [Row(name, None, note=f"left out: {error}") for name in names]
    return [_hand(name, toll, count) for name, toll in tolls.items()]


def _hand(name: str, toll: Toll, count: int) -> Row:
    note = f"median of {DRAWINGS} chance drawings; in brackets 95 of 100 are under"
    kinds = {kind: float(np.median(values)) for kind, values in toll.kinds.items()}
    worst = float(np.median(toll.worst))
    return Row(name, None, count, Errors(kinds, "", worst), float(np.quantile(toll.worst, 0.95)), note=note)


def _told(tolls: Mapping[str, Toll]) -> Iterator[str]:
    """Hold the hands against real ones, whose printed values are known in shares of themselves."""
    yield (
        "real hands: values that three textbooks print from their drawings are out by "
        f"{BOOKS_MEDIAN}% (median), nine of ten by less than {BOOKS_MOST}% of themselves; here v, a, omega, epsilon are"
    )
    middle = 0.0
    for name, toll in tolls.items():
        middle, most = (100 * float(np.quantile(toll.single, share)) for share in (0.5, 0.9))
        yield f"  {name}: {middle:.2g}% (median), nine of ten by less than {most:.2g}%"
    if middle > 0:  # an error goes with the slip
        like = draughtsman.SLIPS[-1] * BOOKS_MEDIAN / middle
        yield f"  so the books' hands are like one of {like:.1f} mm on this sheet"


def _ratios(rows: list[Row], counts: tuple[int, ...]) -> Iterator[Ratio]:
    """Hold the techniques that answer the same question against each other."""
    found = {(row.technique, row.positions): row for row in rows}
    pairs = [(CONSTRUCTION[0], CONSTRUCTION[-1], "construction: positions / all")]
    pairs += [(name, CONSTRUCTION[-1], f"{name} / construction: all") for name in (PYLINKAGE, MECHANISM, ROUNDING)]
    pairs.append((FORCES_CONSTRUCTED, CONSTRUCTION[-1], "construction: forces, kinematics in them / all"))
    pairs.append((FORCES_ANALYSED, FORCES_CONSTRUCTED, f"{FORCES_ANALYSED} / {FORCES_CONSTRUCTED}"))
    for name, under, text in pairs:
        for count in counts if (name, counts[0]) in found else ():
            first, second, goal = found[name, count], found[under, count], GOALS.get((name, count))
            if goal or first.times:
                yield Ratio(text, count, first.times, second.times, goal, "" if first.times else first.note)


def _startup(scene: Scene, order: Order) -> Iterator[Ratio]:
    draw, imports, nothing = startup(Path(scene.file), min(order.rounds, STARTS))
    yield Ratio("start-up: plandraft draw / import numpy, svgwrite", None, draw, imports, Goal(2.0, least=False))
    yield Ratio("start-up: plandraft draw / python alone", None, draw, nothing)


def _words(order: Order) -> Iterator[str]:
    yield DEFINED
    yield TRUE
    yield (
        f"looked at: all positions up to {SAMPLE}, of more a sample of {SAMPLE} all over the turn, the same for all "
        "techniques; the position and the plans drawn of a sheet and by hand"
    )
    yield f"accepted: an error of at most {order.accepted:.0e} of the plan's largest"
    yield (
        f"time: wall time of one run, techniques in turns (A B C A B C), {order.rounds} times each, or until a row has "
        f"taken {BUDGET} s; a first run of each, which fills caches and compiles, is not timed; median (quartiles)"
    )
    yield (
        "the construction keeps its record; its assembly is chosen once a scene, in the set-up. Newton's rows hold its "
        "own assembly and its march round the turn. Peers, on a four-bar alone: built and compiled before; pylinkage "
        "gives r, v, a of points, mechanism angle, omega, epsilon of links as well, from the best guesses there are"
    )
    slips = " and ".join(f"{slip:g}" for slip in draughtsman.SLIPS)
    yield (
        f"by hand: every act of the record on paper at the sheet's own scales, each up to {slips} mm out to either "
        f"side in x and in y (evenly spread, seed {SEED}): pricked points, ruled lines, a compass's "
        "opening, vectors carried; not timed"
    )
