"""The bench of drawing a sheet: stages, sizes, cold start (время листа)."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from drawings.bench import plain_pen
from drawings.layout import value_table
from drawings.lettering.lettering import lettered
from drawings.linkage import kinematics
from drawings.measure.measure import Measured, measure
from drawings.paper.strokes import Leaf
from drawings.pens import letters
from drawings.pens.svg import svg
from plans.bench.error import Errors, errors
from plans.bench.roads import Ground
from plans.bench.trial import BUDGET, Road, Times, interleaved
from plans.bench.truth import Exact, Truth, replay
from plans.linkage.quantities import MotionComparison, compare
from plans.linkage.study import LinkageStudy
from plans.model.motion import ORDERS, POINT_ORDERS

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


MEASURED, PRINTED = "sheet: measured back", "sheet: its table"
NOTE = "of one run: drawn, written, measured back"

_NAME = re.compile(r"(\w)_\{(.+?)\}")
_KINDS = {told.symbol: told.key for order in ORDERS[1:] for told in (order.point, order.link)}


@dataclass(frozen=True)
class DrawnSheets:
    """A scene's sheets drawn, written and measured together, and the comparison that their tables print."""

    leaves: tuple[Leaf, ...]
    comparison: MotionComparison
    measured: Measured

    @property
    def plans(self) -> tuple[int, ...]:
        """The positions whose plans are drawn."""
        return tuple(k for leaf in self.leaves for k in leaf.metadata["plans"])

    @property
    def shown(self) -> int:
        """The position drawn in full lines."""
        return int(self.leaves[0].metadata["shown"])


def read(leaves: Iterable[Leaf]) -> list[Measured]:
    """Write sheets and measure them back."""
    return [measure(svg(lettered(leaf))) for leaf in leaves]


def draw(study: LinkageStudy) -> DrawnSheets:
    """Draw a study's sheets, write them and measure them back."""
    comparison = compare(study)
    leaves = kinematics.sheets(study, comparison)
    found = read(leaves)
    vectors = tuple(vector for one in found for vector in one.vectors)
    points = tuple(point for one in found for point in one.points)
    return DrawnSheets(leaves, comparison, Measured(vectors, points, found[0].metadata))


def road(found: Ground) -> Road:
    """Give the road of drawing a sheet, judged by its vectors and by its table."""
    judged = {MEASURED: _judge(found, by_ruler), PRINTED: _judge(found, by_table)}
    return Road(lambda: draw(found.fresh()), len(found.study.turn), judged, NOTE)


def _judge(
    found: Ground, read: Callable[[LinkageStudy, DrawnSheets, Truth, Mapping[str, float]], Errors]
) -> Callable[[Any], Errors]:
    def judge(drawn: DrawnSheets) -> Errors:
        truth = replay(found.study, sorted({drawn.shown, *drawn.plans})).truth()
        return read(found.fresh(), drawn, truth, found.largest)

    return judge


def by_ruler(study: LinkageStudy, drawn: DrawnSheets, truth: Truth, largest: Mapping[str, float]) -> Errors:
    """Judge the points of the position in full lines and the vectors from the poles of the drawn plans."""
    seen = {("r", one.name): {drawn.shown: one.value} for one in drawn.measured.points if one.position == drawn.shown}
    drafts = study.drafts()
    for order in ORDERS[1:]:
        plan = drafts.plan(order.number)
        names = {
            f"{plan.pole.name} {plan.point(name).name}": name for key, name in truth.values if key == order.point.key
        }
        for one in drawn.measured.vectors:
            if one.plan == plan.board.subject and one.position in drawn.plans and one.name in names:
                seen.setdefault((order.point.key, names[one.name]), {})[one.position] = one.value
    known = {key: values for key, values in seen.items() if key in truth.values}
    held = Truth(truth.positions, {key: truth.of(key, list(values)) for key, values in known.items()})
    return errors({key: np.array(list(values.values())) for key, values in known.items()}, held, largest)


def by_table(study: LinkageStudy, drawn: DrawnSheets, truth: Truth, largest: Mapping[str, float]) -> Errors:
    """Judge the numbers of the table: sizes of v and a, and omega and epsilon with their signs; gaps have none."""
    language = study.scene.sheet.language
    known = [place for place, k in enumerate(drawn.plans) if not study.lost[k]]
    found = {}
    told = [(one,) for one in value_table.told(drawn.comparison)]
    for row in value_table.rows(told, drawn.plans, language):
        named = _NAME.match(row.name)
        key = (_KINDS[named[1]], named[2]) if named else ("", "")
        if key in truth.values:
            found[key] = np.array([_number(str(row.cells[3 * place])) for place in known])
    return errors(found, _sizes(truth.at([drawn.plans[place] for place in known])), largest)


def _sizes(truth: Truth) -> Truth:
    """Give a truth in which vectors are their sizes: the table has no directions."""
    sized = {
        key: Exact(np.abs(v.near), np.zeros(len(v.near))) if key[0] in POINT_ORDERS else v
        for key, v in truth.values.items()
    }
    return Truth(truth.positions, sized)


def _number(cell: str) -> float:
    try:
        return float(cell.replace("−", "-").replace(",", "."))
    except ValueError:  # a dash for a gap
        return float("nan")


def pens(leaf: Leaf, rounds: int) -> tuple[Times, Times]:
    """Time svgwrite with its defaults and our pen on the same lettered leaf, in turns; letters are traced anew."""
    ready = lettered(leaf)

    def ours() -> bytes:
        letters.forget()
        return svg(ready)

    plain, own = interleaved([lambda: plain_pen.svg(ready), ours], rounds, BUDGET)
    return plain, own
