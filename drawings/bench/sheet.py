"""The whole draw of any scene timed, its sheets judged as they are read back, its hands, its start-up (время листа)."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np

from drawings.bench import plain_pen
from drawings.checks import hold
from drawings.checks.expected import Expected, subject
from drawings.checks.readers import Read
from drawings.checks.readers import value as number
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Kind, Leaf
from drawings.pens import paths
from drawings.pens.svg import svg
from drawings.reading.sheet import SeenSheet, see
from drawings.sheets.documents import leaves_of
from drawings.sheets.kind import sheet_kind
from plans.bench.quantities import quantities
from plans.bench.trial import BUDGET, Errors, Timed, Times, Timing, interleaved
from plans.forces.marks import forces_by_hand
from plans.forces.statics import Statics
from plans.linkage.parts import MotionByHand
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.quantity import SLIP
from plans.scene.scene import Scene
from plans.study import Study

MEASURED, NUMBERS = "sheets: measured back", "sheets: their numbers"
BY_HAND = "{}: by hand to {:g} mm"
SLIPS = (SLIP / 2, SLIP)  # mm: a good hand's and a fair one's
ROUGH = 0.01  # of a number: one that may be so far off is told to two digits, or is nothing but rounding
HAND_NOTE = "within which 95 of 100 drawings are"
DEFINED = (
    "sheets: one run constructs, compares, draws, writes, reads back. Measured back: vectors and points of the written "
    "files against the analysis, in shares of the largest of their figure. Their numbers: what cells say, in shares "
    "of the largest of their row, but for what is told to two digits and what rounding may make of nothing",
    f"by hand: every mark on paper up to {' or '.join(f'{slip:g}' for slip in SLIPS)} mm out to either side in x and "
    "in y, at the sheets' own scales; the worst and the median of all shown, in shares of the plan's largest",
)


class Drawn(NamedTuple):
    """A scene whose sheets were drawn and read back, by their kinds."""

    study: Study
    sheets: tuple[tuple[str, Leaf, SeenSheet], ...]

    @property
    def scales(self) -> dict[str, float]:
        """The scales of all figures, true units a mm."""
        return {name: mu for _, leaf, _ in self.sheets for name, mu in leaf.metadata.get("scales", {}).items()}


def draw(scene: Scene) -> Drawn:
    """Draw the sheets of a scene as `plandraft draw` does, and read them back."""
    study = Study(scene)
    study.construct()
    _ = study.comparisons
    leaves = [(kind, leaf) for kind, group in leaves_of(study).items() for leaf in group]
    return Drawn(study, tuple((kind, leaf, see(svg(lettered(leaf, scene.sheet.lettering)))) for kind, leaf in leaves))


def road(scene: Scene, count: int | None, keep: Callable[[Drawn], None]) -> Timing:
    """Give the road of drawing all sheets, judged by what is measured back and by the numbers that are written."""

    def measured(drawn: Drawn) -> Errors | None:
        keep(drawn)
        return errors(drawn, by_ruler)

    judged = {MEASURED: measured, NUMBERS: lambda drawn: errors(drawn, by_cells)}
    return Timing(lambda: draw(scene), count, judged)


Pairs = Iterator[tuple[str, str, float, float]]  # name, whose largest counts, how far off, size


def errors(drawn: Drawn, read: Callable[[hold.Seen, Mapping[Any, Expected]], Pairs]) -> Errors | None:
    """Judge what is read off the sheets of a scene."""
    found: dict[str, float] = {}
    for kind, leaf, sheet in drawn.sheets:
        alike = [page for other, page, _ in drawn.sheets if other == kind and subject(page) == subject(leaf)]
        expected = {row.key: row for row in sheet_kind(kind).expected(drawn.study, alike)}
        readings = [*read(hold.readings(sheet.measured, leaf), expected)]
        most: dict[str, float] = {}
        for _, whole, _, size in readings:
            most[whole] = max(most.get(whole, 0.0), size)
        for name, whole, off, _ in readings:
            found[name] = max(found.get(name, 0.0), off / most[whole] if most[whole] else 0.0)
    return Errors.of(found)


def by_ruler(read: hold.Seen, expected: Mapping[Any, Expected]) -> Pairs:
    """Compare vectors and points with what they must be."""
    for key, row, reading in _judged(read, expected, (Kind.VECTOR, Kind.POINT)):
        if isinstance(row.value, complex | float) and isinstance(reading.value, complex | float):
            off = abs(hold.even(complex(reading.value - row.value), reading))
            yield f"{key[2]} ({key[1]})", key[1], off, abs(row.value)


def by_cells(read: hold.Seen, expected: Mapping[Any, Expected]) -> Pairs:
    """Compare numbers in cells with what they must say, without the signs that are in words."""
    for key, row, reading in _judged(read, expected, (Kind.NUMBER,)):
        said = number(str(reading.value).lstrip("±+"))
        if said is not None and isinstance(row.value, complex | float | int):
            true = abs(row.value) if isinstance(row.value, complex) else float(row.value)
            if row.allowed > ROUGH * abs(true):
                continue
            turns = row.period * round((said - true) / row.period) if row.period else 0.0
            yield key[2], f"{key[1]} {key[2].rpartition(' [')[0]}", abs(said - true - turns), abs(true)


def _judged(
    read: hold.Seen, expected: Mapping[Any, Expected], kinds: tuple[Kind, ...]
) -> Iterator[tuple[Any, Expected, Read]]:
    """Give what is read of some kinds, with what is due of it; what rounding alone decides is not judged."""
    known = ((key, expected[key], found) for key, found in read.items() if key[0] in kinds and key in expected)
    yield from ((key, row, reading) for key, row, found in known for reading in found if np.isfinite(row.allowed))


Hand = Callable[[Drawn], Mapping[tuple[str, int], float]]


def _linkage(drawn: Drawn) -> Mapping[tuple[str, int], float]:
    study = drawn.study.of(LinkageStudy)
    hand = MotionByHand(study, drawn.study.of(MotionComparison), {})
    return hand.on_sheet(range(len(study.turn)), drawn.scales)


def _forces(drawn: Drawn) -> Mapping[tuple[str, int], float]:
    found: dict[tuple[str, int], float] = {}
    for leaf in (leaf for kind, leaf, _ in drawn.sheets if kind == "forces"):
        found |= forces_by_hand(drawn.study.of(Statics), int(leaf.metadata["position"]), leaf.metadata["scales"])
    return found


HANDS: Final[Mapping[str, Hand]] = {"linkage": _linkage, "forces": _forces}


def by_hand(drawn: Drawn) -> Iterator[Timed]:
    """Give the rows of hands that slip, of the techniques whose figures are known to be drawn by hand."""
    for technique in (name for name in drawn.study.techniques if name in HANDS):
        largest = {quantity.name: quantity.largest for quantity in quantities(drawn.study, technique)}
        found = ((name, off) for (name, _), off in HANDS[technique](drawn).items() if largest.get(name))
        shares: dict[str, float] = {}
        for name, off in found:
            shares[name] = max(shares.get(name, 0.0), off / largest[name] if np.isfinite(off) else 0.0)
        whole = Errors.of(shares)
        if whole is not None:  # an error goes with the slip
            for slip in SLIPS:
                scaled = Errors(whole.worst * slip / SLIP, whole.typical * slip / SLIP, whole.name)
                yield Timed(BY_HAND.format(technique, slip), None, scaled, note=HAND_NOTE)


def pens(leaf: Leaf, rounds: int) -> tuple[Times, Times]:
    """Time svgwrite with its defaults and our pen on the same lettered leaf, in turns; letters are traced anew."""
    ready = lettered(leaf)

    def ours() -> bytes:
        paths.forget()
        return svg(ready)

    plain, timed = interleaved([lambda: plain_pen.svg(ready), ours], rounds, BUDGET)
    return plain, timed


ROOT = Path(__file__).parent.parent.parent  # where the three packages are found, installed or not
DRAW = "from drawings.commands.process import run; run()"
MADE = 0, 4  # exit codes of what was drawn, whole or with gaps
IMPORTS = "import numpy, svgwrite"


def startup(scene: Path, rounds: int) -> tuple[Times, Times, Times]:
    """Time in turns: `plandraft draw` of a scene, `python` with numpy and svgwrite imported, `python` alone."""
    with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
        commands = ([DRAW, "draw", os.fspath(scene.resolve()), "-o", folder], [IMPORTS], ["pass"])
        runs = [_process(folder, *command) for command in commands]
        # The first runs of all compile the modules, as installing them does, and fill the cache of files.
        for run in runs:
            run()
        draw, imports, nothing = interleaved(runs, rounds, float("inf"))
    return draw, imports, nothing


def _process(folder: str, *arguments: str) -> Callable[[], object]:
    paths = [os.fspath(ROOT), os.environ.get("PYTHONPATH", "")]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment |= {"PYTHONPATH": os.pathsep.join(filter(None, paths)), "PYTHONPYCACHEPREFIX": folder}
    command = [sys.executable, "-c", *arguments]

    def run() -> None:
        ended = subprocess.run(command, env=environment, capture_output=True, check=False)
        if ended.returncode not in MADE:  # no time is told of a run that made nothing
            ended.check_returncode()

    return run
