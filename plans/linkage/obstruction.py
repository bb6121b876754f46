"""What keeps the crank from a full turn, by how much, and what would mend it (что мешает кривошипу провернуться)."""

from __future__ import annotations

import numpy as np

from plans.linkage.assembly_limits import FAN, Sweep, at_angles
from plans.linkage.barrier import Barrier
from plans.linkage.gaps import of_positions
from plans.linkage.margin import margins
from plans.model.motion import OUT_OF_REACH
from plans.words.words import Message, message


def obstruction(sweep: Sweep) -> Message:
    """Say what first bars the turn, at which crank angles, and what would mend it where the loci miss the most."""
    barrier = sweep.barriers[0]
    parts: dict[str, object] = {"reason": barrier.kind, "where": barrier.where}
    if barrier.end - barrier.start < 2 * np.pi:
        parts |= {name: f"{np.degrees(edge):.2f}" for name, edge in (("low", barrier.start), ("high", barrier.end))}
    key = "barrier.turn" if "low" in parts else "barrier.nowhere"
    if barrier.kind != OUT_OF_REACH:
        return message(key, **parts)
    return message(f"{key}_advice", **parts, advice=_mending(sweep, barrier))


def _mending(sweep: Sweep, barrier: Barrier) -> Message:
    phi = np.linspace(barrier.start, barrier.end, FAN)
    _, marks = margins(sweep.plan(phi), sweep.groups, sweep.sides)
    miss = np.broadcast_to(np.asarray(marks[barrier.group].miss, dtype=float), FAN)
    worst = int(np.nanargmax(miss))
    return of_positions(sweep, at_angles(phi[worst : worst + 1]), [0], None, ())[0].advice


def no_extreme(sweep: Sweep, link: int, assembled: bool) -> Message:
    """Say why an output link has no extreme positions."""
    if not assembled:
        return message("extreme.unassembled", why=obstruction(sweep))
    why = obstruction(sweep) if sweep.barred else message("extreme.turns")
    return message("extreme.none", link=link, why=why)
