"""The self-check of a tachogram: ends of stages, curve, scales, against the run that both roads found (тахограмма)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.checks.dynamics.dynamics_graphs import NONE, vertices
from drawings.checks.dynamics.tachogram_strokes import CLOSE, SHORT, TACHOGRAM, TachogramStrokes
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf, Polyline
from drawings.paper.walk import group_named, walk
from plans.model.motion import Complexes
from plans.model.run import Run
from plans.words.words import message


def tachogram(measured: Measured, leaf: Leaf, run: Run | None, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the ends of all stages by their instants and speeds, and every row of the run by the curve."""
    group = group_named(leaf.groups, TACHOGRAM)
    if run is None or group is None:
        yield message("wrong.missing", name=TACHOGRAM)
        return
    scales, curve = written_scales(group), _corners(group)
    across, up = scales.get("t", NONE), scales.get("ω", NONE)
    if not (np.isfinite(across) and np.isfinite(up) and curve.size):
        yield message("wrong.scale", text="μ_t, μ_ω")
        return
    places = curve[0] + (run.t - run.t[0]) / across + 1j * (run.omega - run.omega[0]) / up
    near = CLOSE + 2 * measured.quantum
    off = [np.abs(curve - place).min() > near for place in places]
    yield from [on("curve", TACHOGRAM)] if any(off) else []
    yield from _ends(measured, run, places, up)
    zero = complex(curve[0] - run.t[0] / across - 1j * run.omega[0] / up)
    yield from TachogramStrokes(group, run, zero, across, up, drafting).faults()


def _corners(group: Group) -> Complexes:
    """Give the corners of the curve: of the longest chain."""
    chains = [one.points for one in walk((group,)) if isinstance(one, Polyline)]
    return np.array(max(chains, key=len, default=tuple(vertices(group))))


def _ends(measured: Measured, run: Run, places: Complexes, up: float) -> Iterator[Wrong]:
    seen = {one.name: one for one in measured.vectors if one.plan == TACHOGRAM}
    for k, stage in enumerate(run.stages, 1):
        name, omega, near = f"t_{k}", float(run.omega[stage.last]), 3 * measured.quantum
        one = seen.get(name)
        if one is None:
            yield from [on("missing_on", TACHOGRAM, name=name)] if omega / up > SHORT else []
        elif not (abs(one.value - 1j * omega) <= near * up and abs(one.end - places[stage.last]) <= 2 * near):
            yield on("differs_on", TACHOGRAM, name=name)
