"""The self-check of a tachogram: ends of stages, curve, scales, against the run that both roads found (тахограмма)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.checks.dynamics_graphs import NONE, part, vertices, written
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics.tachogram import CLOSE, LEAST, NAME, NUMBERS, told
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf, Polyline, Text
from drawings.paper.walk import groups, texts, walk
from plans.model.motion import Complexes
from plans.model.run import Run
from plans.words.words import message

DIGITS = 4  # of the numbers that are written


def tachogram(measured: Measured, leaf: Leaf, run: Run | None, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the ends of all stages by their instants and speeds, and every row of the run by the curve."""
    group = part(leaf, NAME)
    if run is None or group is None:
        yield message("wrong.missing", name=NAME)
        return
    yield from _numbers(group, run, drafting)
    scales, curve = written(group), _corners(group)
    across, up = scales.get("t", NONE), scales.get("ω", NONE)
    if not (np.isfinite(across) and np.isfinite(up) and curve.size):
        yield message("wrong.scale", text="μ_t, μ_ω")
        return
    places = curve[0] + (run.t - run.t[0]) / across + 1j * (run.omega - run.omega[0]) / up
    near = CLOSE + 2 * measured.quantum
    off = [np.abs(curve - place).min() > near for place in places]
    yield from [on("curve", NAME)] if any(off) else []
    yield from _ends(measured, run, places, up)


def _corners(group: Group) -> Complexes:
    """Give the corners of the curve: of the longest chain."""
    chains = [one.points for one in walk((group,)) if isinstance(one, Polyline)]
    return np.array(max(chains, key=len, default=tuple(vertices(group))))


def _numbers(group: Group, run: Run, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the instants and the steady speed that are written, each number to its last digit."""
    seen = [text.plain for one in groups((group,)) if one.name == NUMBERS for text in texts((one,))]
    due = [Text(0j, line).plain for line in told(run, precise(drafting))]
    if len(seen) < len(due):
        yield message("wrong.missing", name="t_1")
    for text, true in zip(seen, due, strict=False):
        if not tells(text, true, (DIGITS,)):
            yield message("wrong.told", text=text)


def _ends(measured: Measured, run: Run, places: Complexes, up: float) -> Iterator[Wrong]:
    seen = {one.name: one for one in measured.vectors if one.plan == NAME}
    for k, stage in enumerate(run.stages, 1):
        name, omega, near = f"t_{k}", float(run.omega[stage.last]), 3 * measured.quantum
        one = seen.get(name)
        if one is None:
            yield from [on("missing_on", NAME, name=name)] if omega / up > LEAST else []
        elif not (abs(one.value - 1j * omega) <= near * up and abs(one.end - places[stage.last]) <= 2 * near):
            yield on("differs_on", NAME, name=name)
