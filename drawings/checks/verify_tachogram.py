"""The self-check of a tachogram: ends of stages, curve, scales, against the run that both roads found (тахограмма)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.checks.dynamics_graphs import NONE, part, vertices, written
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics.tachogram import CLOSE, LEAST, NAME
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from plans.model.motion import Complexes
from plans.model.run import Run
from plans.words.words import message


def tachogram(measured: Measured, leaf: Leaf, run: Run | None) -> Iterator[Wrong]:
    """Hold the ends of all stages by their instants and speeds, and every row of the run by the curve."""
    group = part(leaf, NAME)
    if run is None or group is None:
        yield message("wrong.missing", name=NAME)
        return
    scales, curve = written(group), np.array(list(vertices(group)))
    across, up = scales.get("t", NONE), scales.get("ω", NONE)
    if not (np.isfinite(across) and np.isfinite(up) and curve.size):
        yield message("wrong.scale", text="μ_t, μ_ω")
        return
    places = curve[0] + (run.t - run.t[0]) / across + 1j * (run.omega - run.omega[0]) / up
    near = CLOSE + 2 * measured.quantum
    off = [np.abs(curve - place).min() > near for place in places]
    yield from [on("curve", NAME)] if any(off) else []
    yield from _ends(measured, run, places, up)


def _ends(measured: Measured, run: Run, places: Complexes, up: float) -> Iterator[Wrong]:
    seen = {one.name: one for one in measured.vectors if one.plan == NAME}
    for k, stage in enumerate(run.stages, 1):
        name, omega, near = f"t_{k}", float(run.omega[stage.last]), 3 * measured.quantum
        one = seen.get(name)
        if one is None:
            yield from [on("missing_on", NAME, name=name)] if omega / up > LEAST else []
        elif not (abs(one.value - 1j * omega) <= near * up and abs(one.end - places[stage.last]) <= 2 * near):
            yield on("differs_on", NAME, name=name)
