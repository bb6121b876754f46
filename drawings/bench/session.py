"""A session at the bench: every technique of any scene timed and judged by its quantities, on one machine (испытание).

A technique needs no line here. What it has of its own stands in two tables: other roads, and series over counts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final

from drawings.bench import sheet
from geometry.errors import DraftError
from plans.bench import cams, motion, series
from plans.bench.motion import NothingToMeasure, turns, with_positions
from plans.bench.peers import MECHANISM, PYLINKAGE
from plans.bench.quantities import ANALYSIS, CONSTRUCTION, DEFINED, follows, quantities, roads
from plans.bench.trial import BUDGET, DRAWN, Bench, Demand, Goal, Ratio, Timed, Timing, machine, orders, timed
from plans.linkage.study import LinkageStudy
from plans.scene.forms import resting
from plans.scene.scene import Scene
from plans.study import Study

Others = Callable[[Study, int], tuple[list[Timing], Mapping[str, str]]]
# Of a study and a number of positions to other roads and to why some are left out, with what is said of them.
OTHERS: Final[Mapping[str, tuple[Others, str]]] = {"linkage": (motion.roads, motion.TRUE)}
# Of a study and an order to roads over several counts, with what is said of them.
SERIES: Final[Mapping[str, tuple[Callable[[Study, Demand], Iterator[Timing]], str]]] = {
    "dynamics": (series.dynamics, series.DYNAMICS_DEFINED),
    "diagrams": (series.diagrams, series.DIAGRAMS_DEFINED),
    "bank": (series.bank, series.BANK_DEFINED),
    "cam": (cams.cams, cams.DEFINED),
}
# What answers the same question, besides the two roads, and what a ratio should be: a compiled loop and three fsolves
# a position cost more than plans, and an offset by points more than the exact envelope.
PAIRS: Final = ((PYLINKAGE, motion.PLANS), (MECHANISM, motion.PLANS), (cams.ENVELOPE, cams.OFFSET))
GOALS: Final[Mapping[tuple[str, int], Goal]] = {
    (PYLINKAGE, 360): Goal(2.0),
    (PYLINKAGE, 100_000): Goal(8.0),
    (MECHANISM, 360): Goal(1000.0),
    (cams.ENVELOPE, 3600): Goal(1.0, least=False),
}
PATIENCE = 10.0  # seconds: what will take longer, by what fewer positions took, is left out
STARTS = 5  # cold starts at most: each takes the better part of a second, and they differ little
PENS, PENS_GOAL = "writing the sheet: svgwrite's defaults / ours", Goal(5.0)
STARTED = "start-up: plandraft draw / {}"


def session(scene: Scene, order: Demand, tell: Callable[[str], None]) -> Bench:
    """Run a session; `tell` hears what is being timed, and nothing when all is."""
    there, ours = machine(), Session(scene, order, tell)
    ours.run()
    tell("")
    words = (*dict.fromkeys(ours.words), *_terms(order))
    return Bench(scene.heading(), there, tuple(ours.rows), tuple(ours.ratios), words, order.accepted, ours.gaps)


class Session:
    """What is found of a scene, as it is found."""

    def __init__(self, scene: Scene, order: Demand, tell: Callable[[str], None]) -> None:
        self.scene, self.order, self.tell = scene, order, tell
        self.rows: list[Timed] = []
        self.ratios: list[Ratio] = []
        self.words: list[str] = [DEFINED]
        self.gaps = False

    def run(self) -> None:
        """Time and judge both roads at every number of positions, then the series, the sheets, the start-up."""
        counts = self.order.positions if turns(self.scene) else (None,)
        studies = [self._study(count) for count in counts]
        once: set[str] = set()  # what is the same at any number of positions
        for count, study in zip(counts, studies, strict=True):
            self.tell(f"{count or 'its own'} positions")
            for technique in (name for name in study.techniques if name not in once):
                self._technique(study, technique, count, once)
        self._series(studies[0])
        for count in (asked for asked in counts if asked is None or asked <= self.order.drawn):
            self.tell("the sheets")
            self._sheets(count)
        if self.order.startup:
            self.tell("start-up")
            draw, imports, nothing = sheet.startup(Path(self.scene.file), min(self.order.rounds, STARTS))
            goal = Goal(2.0, least=False)
            self.ratios.append(Ratio(STARTED.format("import numpy, svgwrite"), None, draw, imports, goal))
            self.ratios.append(Ratio(STARTED.format("python alone"), None, draw, nothing))

    def _study(self, count: int | None) -> Study:
        study = Study(with_positions(self.scene, count) if count else self.scene)
        if "linkage" in study.techniques and study.of(LinkageStudy).lost.all():
            raise NothingToMeasure(f"{self.scene.file}: no position can be assembled, so there is nothing to measure")
        return study

    def _technique(self, study: Study, technique: str, count: int | None, once: set[str]) -> None:
        """Time and judge a technique at a number of positions; of what is too long, or refused, it is said."""
        names = [name.format(subject) for subject in resting([technique]) for name in (CONSTRUCTION, ANALYSIS)]
        long = max((self._expected(name, count) for name in names), default=0.0)
        if long > PATIENCE:
            self._left_out((name.format(technique) for name in (CONSTRUCTION, ANALYSIS)), count, _too_long(long))
            return
        try:
            study[technique].construct(study.plans)
            found = quantities(study, technique)
        except DraftError as error:
            self._left_out([CONSTRUCTION.format(technique)], count, f"left out: {error}")
            once.add(technique)
            return
        self.gaps |= bool(study.comparison(technique).left_out)
        at, before = count if follows(found, count) else None, len(self.rows)
        if at is None:
            once.add(technique)
        ways = [*roads(study, technique, at)]
        out: Mapping[str, str] = {}
        if technique in OTHERS and count is not None:
            make, said = OTHERS[technique]
            others, out = make(study, count)
            ways += others
            self.words.append(said)
        self._timed(ways)
        for name, why in out.items():
            self._left_out([name], count, why)
        self.ratios += _ratios(self.rows[before:], technique)

    def _timed(self, ways: Sequence[Timing]) -> None:
        long = [(way, self._expected(name, way.positions)) for way in ways for name in [*way.judged][:1]]
        for way, seconds in long:
            self._left_out(way.judged if seconds > PATIENCE else (), way.positions, _too_long(seconds))
        self.rows += timed([way for way, seconds in long if seconds <= PATIENCE], self.order.rounds)

    def _expected(self, name: str, count: int | None) -> float:
        """Give the seconds that a run will take, by how the last two of fewer positions have grown."""
        rows = (row for row in self.rows if row.technique == name and not row.of)
        known = [(row.positions, row.times.median) for row in rows if row.positions and row.times]
        if count is None or not known:
            return 0.0
        (fewer, before), (last, took) = known[-2:] if len(known) > 1 else ((0, known[0][1]), known[0])
        return took + max(took - before, 0.0) * (count - last) / (last - fewer)

    def _left_out(self, names: Iterable[str], count: int | None, why: str) -> None:
        self.rows += [Timed(name, count, note=why) for name in names]

    def _series(self, study: Study) -> None:
        """Time and judge what techniques have over counts of their own, and say of which order it is."""
        for technique in (name for name in study.techniques if name in SERIES):
            self.tell(f"the series of {technique}")
            make, said = SERIES[technique]
            try:
                rows = timed([*make(study, self.order)], self.order.rounds)
            except DraftError as error:
                self._left_out([f"{technique}: series"], None, f"left out: {error}")
                continue
            self.rows += rows
            self.words += [said, *orders(rows)]
            self.ratios += _ratios(rows, technique)

    def _sheets(self, count: int | None) -> None:
        """Time and judge the whole draw; hands and pens at the first number of positions."""
        scene = with_positions(self.scene, count) if count else self.scene
        kept: list[sheet.Drawn] = []
        self._timed([sheet.road(scene, count, kept.append)])
        self.words += sheet.DEFINED
        if not kept or any(ratio.name == PENS for ratio in self.ratios):
            return
        drawn = kept[0]
        self.rows += sheet.by_hand(drawn)
        largest = max((leaf for _, leaf, _ in drawn.sheets), key=lambda leaf: len(leaf.groups))
        self.ratios.append(Ratio(PENS, count, *sheet.pens(largest, self.order.rounds), PENS_GOAL))


def _too_long(seconds: float) -> str:
    return f"left out: it would take about {seconds:.0f} s"


def _ratios(rows: Sequence[Timed], technique: str) -> Iterator[Ratio]:
    """Hold the roads that answer the same question against each other, side by side."""
    found = {(row.technique, row.positions): row for row in rows}
    for name, under in ((ANALYSIS.format(technique), CONSTRUCTION.format(technique)), *PAIRS):
        for count in [count for row_name, count in found if row_name == name and (under, count) in found]:
            first, second, goal = found[name, count], found[under, count], GOALS.get((name, count or 0))
            if goal or (first.times and second.times):
                note = "" if first.times else first.note
                yield Ratio(f"{name} / {under}", count, first.times, second.times, goal, note)


def _terms(order: Demand) -> tuple[str, ...]:
    return (
        f"accepted: an error of at most {100 * order.accepted:g} per cent",
        f"time: wall time of one run, roads in turns (A B C A B C), {order.rounds} times each, or until a row has "
        f"taken {BUDGET} s; a first run of each, which fills caches and compiles, is not timed; median (quartiles). "
        "Construction and analysis stand over what their technique rests on; the linkage's chooses its assembly as "
        f"well, its plans alone do not. Of more than {DRAWN} positions no sheet is drawn",
    )
