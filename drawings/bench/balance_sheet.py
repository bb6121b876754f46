"""The drawn sheet of balancing as a way to the mass centre: S and the main vector measured back (испытание листа)."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from drawings.figures.balance import shaking_hodograph
from drawings.figures.balance.scheme import BEFORE, SCHEME
from drawings.files import atomic_files
from drawings.lettering.balance_letters import CENTRE
from drawings.lettering.lettering import lettered
from drawings.measure.measure import measure_file
from drawings.pens.svg import svg
from drawings.sheets.balancing import leaves
from plans.bench.balance import PLACE, SHAKING, Ground
from plans.bench.clock import interleaved
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.scene.scene import Scene
from plans.study import Study

MEASURED = "sheet of balancing: measured back"
Marks = Mapping[str, complex]  # by plan, position and name of a mark, its measured value in true units


def row(scene: Scene, on: Ground, rounds: int, budget: float) -> Row:
    """Time and judge the sheet: S in the shown position, the main vector at those that its hodograph marks."""

    def run() -> Marks:
        with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
            return measured(scene, Path(folder))

    errors = judge(run(), on)
    (times,) = interleaved([run], rounds, budget)
    count = len(on.study.turn)
    return Row(MEASURED, count, 0, errors, times=times, note="of one run: drawn, written, measured back")


def measured(scene: Scene, folder: Path) -> Marks:
    """Draw the sheets of a scene, write them, and read the points of scheme and hodograph back."""
    found: dict[str, complex] = {}
    for number, leaf in enumerate(leaves(Study(scene))):
        path = folder / f"sheet-{number}.svg"
        atomic_files.write(path, svg(lettered(leaf)))
        points = (one for one in measure_file(path).points if one.plan in (SCHEME + BEFORE, shaking_hodograph.NAME))
        found |= {_key(one.plan, one.position, one.name): one.value for one in points}
    return found


def judge(marks: Marks, on: Ground) -> Errors:
    """Hold what was read against the truth at its positions, in shares of the largest there."""
    kinds: dict[str, float] = {}
    for kind, near, rest in zip((PLACE, SHAKING), on.near, on.rest, strict=True):
        most = float(np.abs(near).max())
        keys = [_mark(kind, k) for k in on.positions]
        off = [abs(marks[key] - n - r) for key, n, r in zip(keys, near, rest, strict=True) if key in marks]
        if off and most:
            kinds[kind] = max(off) / most
    return Errors(kinds, max(kinds, key=lambda kind: kinds[kind], default=""))


def _mark(kind: str, position: int) -> str:
    if kind == PLACE:
        return _key(SCHEME + BEFORE, position, CENTRE)
    return _key(shaking_hodograph.NAME, position, f"{BEFORE} {position}")


def _key(plan: str, position: int | None, name: str) -> str:
    return f"{plan}/{position}/{name}"
