"""A linkage with its forces and its machine's motion: rows, paper, hands and ratios (испытание механизма)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path

from drawings.bench import hands, sheet
from drawings.bench.sheet import startup
from geometry.draughtsman import SEED
from geometry.errors import DraftError
from plans.bench import machine, roads
from plans.bench.chords import STRIPS, integration
from plans.bench.error import DEFINED, FORCES_DEFINED, SIZED, SLIPS, TRUE, sizes
from plans.bench.peers import MECHANISM, PYLINKAGE
from plans.bench.trial import BUDGET, DRAWN, Found, Goal, Order, Ratio, Row, terms, timed
from plans.dynamics.quantities import exact_turn
from plans.dynamics.study import DynamicsStudy, reduced_link
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.motion import VELOCITIES
from plans.scene.scene import Scene
from plans.study import Study
from plans.words.words import message, placed

SAMPLE = 24  # positions at which the truth is found: each takes 10 ms and more, and more of them show no other error
STARTS = 5  # cold starts at most: each takes the better part of a second, and they differ little

# Half of the work of three plans is the positions'; what a compiled loop and three fsolves a position cost more.
GOALS: Mapping[tuple[str, int], Goal] = {
    (roads.CONSTRUCTION[0], 360): Goal(0.5, least=False),
    (roads.CONSTRUCTION[0], 100_000): Goal(0.5, least=False),
    (PYLINKAGE, 360): Goal(2.0),
    (PYLINKAGE, 100_000): Goal(8.0),
    (MECHANISM, 360): Goal(1000.0),
    # Forces take about as many acts as the motion that they rest on, and are read and judged besides.
    (roads.FORCES_CONSTRUCTED, 360): Goal(3.0, least=False),
}
PAIRS = (
    (roads.CONSTRUCTION[0], roads.CONSTRUCTION[-1], "construction: positions / all"),
    *((name, roads.CONSTRUCTION[-1], f"{name} / construction: all") for name in (PYLINKAGE, MECHANISM, roads.ROUNDING)),
    (roads.FORCES_CONSTRUCTED, roads.CONSTRUCTION[-1], "construction: forces, kinematics in them / all"),
    (roads.FORCES_ANALYSED, roads.FORCES_CONSTRUCTED, f"{roads.FORCES_ANALYSED} / {roads.FORCES_CONSTRUCTED}"),
)
PENS, PENS_GOAL = "writing the sheet: svgwrite's defaults / ours", Goal(5.0)
NO_SHEET = f"a sheet shows at most {DRAWN} positions"


def linkage(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge every technique of a scene's linkage, and of its forces."""
    if not LinkageStudy(scene).mechanism.drive.turns:
        raise roads.NothingToMeasure(placed(scene.file, message("refused.bench_stroke")))
    first = roads.prepared(scene, SIZED)
    if first.lost.all():
        raise roads.NothingToMeasure.of(scene)
    largest, rows = sizes(first), list[Row]()
    for count in order.positions:
        tell(f"{count} positions")
        rows += _at(scene, count, order, largest)
    tell("the sheet by pen and by hand")
    drawn, ratio, told = _paper(scene, order, largest)
    ratios = [*_ratios(rows, order.positions), ratio]
    if order.startup:
        tell("start-up")
        ratios += _startup(scene, order)
    words = (*_words(order), *told, *((FORCES_DEFINED, hands.SCALED) if roads.asked(first) else ()))
    return Found([*rows, *drawn], words, ratios, bool(LinkageStudy(scene).lost.any()))


def _at(scene: Scene, count: int, order: Order, largest: Mapping[str, float]) -> list[Row]:
    """Give the rows of one number of positions."""
    found = roads.ground(scene, count, SAMPLE, largest)
    peers, left_out = roads.compared(found)
    ways = [*roads.roads(found), *peers]
    if count <= order.drawn:
        ways.append(sheet.road(found))
    else:
        why = NO_SHEET if count > DRAWN else "left out of a quick session"
        left_out |= dict.fromkeys((sheet.MEASURED, sheet.PRINTED), why)
    return timed(ways, order.rounds) + [Row(name, count, note=why) for name, why in left_out.items()]


def _paper(scene: Scene, order: Order, largest: Mapping[str, float]) -> tuple[Sequence[Row], Ratio, Sequence[str]]:
    """Give the rows of hand drawing, the ratio of the pens, and what is to be said of the hands."""
    count = min(order.positions)
    if count > DRAWN:
        return hands.left_out(hands.BY_HAND, NO_SHEET), Ratio(PENS, None, goal=PENS_GOAL, note=NO_SHEET), ()
    study = roads.prepared(scene, count)
    try:
        drawn = sheet.draw(study)
        rows, told = hands.of_motion(study, drawn, largest)
    except DraftError as error:
        why = f"left out: {error}"
        return hands.left_out(hands.BY_HAND, why), Ratio(PENS, None, goal=PENS_GOAL, note=why), ()
    if roads.asked(study):
        rows += hands.of_forces(study, drawn, largest)
    first, second = sheet.pens(max(drawn.leaves, key=lambda leaf: len(leaf.groups)), order.rounds)
    return rows, Ratio(PENS, count, first, second, PENS_GOAL), told


def _ratios(rows: Sequence[Row], counts: tuple[int, ...]) -> Iterator[Ratio]:
    """Hold the techniques that answer the same question against each other."""
    found = {(row.technique, row.positions): row for row in rows}
    for name, under, text in PAIRS:
        for count in counts if (name, counts[0]) in found else ():
            first, second, goal = found[name, count], found[under, count], GOALS.get((name, count))
            if goal or first.times:
                yield Ratio(text, count, first.times, second.times, goal, "" if first.times else first.note)


def _startup(scene: Scene, order: Order) -> Iterator[Ratio]:
    draw, imports, nothing = startup(Path(scene.file), min(order.rounds, STARTS))
    yield Ratio("start-up: plandraft draw / import numpy, svgwrite", None, draw, imports, Goal(2.0, least=False))
    yield Ratio("start-up: plandraft draw / python alone", None, draw, nothing)


def _words(order: Order) -> tuple[str, ...]:
    return (
        DEFINED,
        TRUE,
        f"looked at: all positions up to {SAMPLE}, of more a sample of {SAMPLE} all over the turn, the same for all "
        "techniques; the position and the plans drawn of a sheet and by hand",
        terms(order, "of the plan's largest")[0],
        f"time: wall time of one run, techniques in turns (A B C A B C), {order.rounds} times each, or until a row has "
        f"taken {BUDGET} s; a first run of each, which fills caches and compiles, is not timed; median (quartiles)",
        "the construction keeps its record; its assembly is chosen once a scene, in the set-up. Newton's rows hold its "
        "own assembly and its march round the turn. Peers, on a four-bar alone: built and compiled before; pylinkage "
        "gives r, v, a of points, mechanism angle, omega, epsilon of links as well, from the best guesses there are",
        "by hand: every act of the record on paper at the sheet's own scales, each up to "
        f"{' and '.join(f'{slip:g}' for slip in SLIPS)} mm out to either side in x and in y (evenly spread, seed "
        f"{SEED}): pricked points, ruled lines, a compass's opening, vectors carried; not timed",
    )


def dynamics(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the motion of a scene's machine: graphical integration, flywheel, run."""
    found: DynamicsStudy = Study(scene)["dynamics"]
    rounds, counts = min(order.rounds, machine.ROUNDS), STRIPS if order.startup else STRIPS[:4]
    tell("graphical integration")
    parts = [integration(rounds, counts)]
    tell("the flywheel")
    exact = partial(exact_turn, found, compare(found.linkage, VELOCITIES.number))
    asked = found.task.delta is not None
    parts.append(machine.by_strips(found, exact, rounds, counts) if asked else Found([], [machine.NO_FLYWHEEL]))
    parts.append(machine.by_positions(exact(), found.task, rounds, counts))
    tell("the run")
    if found.motor is not None and found.run is not None and found.run.failure is None:
        parts.append(machine.by_steps(reduced_link(found.works, found.constant), found.motor, found.run_task))
    return Found([row for part in parts for row in part.rows], [word for part in parts for word in part.words])
