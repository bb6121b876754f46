"""What keeps the crank from a full turn, by how much, and what would mend it (что мешает кривошипу провернуться)."""

from __future__ import annotations

import numpy as np

from plans.linkage.assembly_limits import FAN, Sweep, at_angles
from plans.linkage.barrier import GAP, Barrier
from plans.linkage.gaps import of_positions
from plans.linkage.margin import margins


def obstruction(sweep: Sweep) -> str:
    """Say what first bars the turn, at which crank angles, and what would mend it where the loci miss the most."""
    barrier = sweep.barriers[0]
    advice = f": {_mending(sweep, barrier)}" if barrier.kind == GAP else ""
    if barrier.end - barrier.start >= 2 * np.pi:
        return f"the mechanism cannot be assembled at any crank angle: {barrier.kind} at {barrier.where}{advice}"
    edges = f"{np.degrees(barrier.start):.2f} to {np.degrees(barrier.end):.2f} degrees"
    return f"the crank does not turn fully ({barrier.kind} at {barrier.where}, {edges}){advice}"


def _mending(sweep: Sweep, barrier: Barrier) -> str:
    phi = np.linspace(barrier.start, barrier.end, FAN)
    _, marks = margins(sweep.plan(phi), sweep.groups, sweep.sides)
    miss = np.broadcast_to(np.asarray(marks[barrier.group].miss, dtype=float), FAN)
    worst = int(np.nanargmax(miss))
    return of_positions(sweep, at_angles(phi[worst : worst + 1]), [0], None, ())[0].advice
