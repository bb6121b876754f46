"""The self-check of the graph of the speeds without the flywheel, by ordinates and points (без маховика)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks.dynamics.bare_strokes import BareStrokes
from drawings.checks.dynamics.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics.dynamics_graphs import has
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Leaf
from drawings.paper.walk import group_named, texts, walk
from plans.model.dynamics import TURN
from plans.words.words import message


def bare(
    measured: Measured, leaf: Leaf, expected: Expected, plan: str, numbered: int, drafting: Drafting
) -> Iterator[Wrong]:
    """Hold the speeds without the flywheel, where they have a graph of their own.

    Each position that is numbered has its ordinate, each between two of them its point at least.
    """
    before, divisions = expected.account.before, expected.task.divisions
    if before is None:
        yield message("wrong.stranger", name=plan)
        return
    seen = {one.position: one for one in measured.vectors if one.plan == plan and one.position is not None}
    group, marked = group_named(leaf.groups, plan), sorted(seen)
    names = {text.plain for text in texts((group,))} if group is not None else set[str]()
    dots = np.array([one.centre for one in walk((group,)) if isinstance(one, Circle)] if group is not None else [])
    places = np.searchsorted(expected.cycle.turned, TURN * np.arange(divisions) / divisions - KNOWN)
    for k, omega in enumerate(before.omega[places].tolist() if divisions <= numbered else ()):
        one = seen.get(k)
        if one is None:
            between = str(k) not in names and len(marked) > 1
            ends = [seen[at] for at in (marked[0], marked[-1])] if between else []
            if not between or not has(dots, _tip(k, omega, ends), 3 * measured.quantum):
                yield on("missing_at", plan, name=str(k), position=k)
        elif not abs(one.value - 1j * omega) <= 2 * measured.quantum * one.scale + KNOWN * omega:
            yield on("differs_at", plan, name=str(k), position=k)
    scales = written_scales(group) if group is not None else {}
    if group is None or not {"φ", "ω"} <= scales.keys():
        yield message("wrong.missing", name=plan)
        return
    yield from BareStrokes(group, scales["φ"], scales["ω"], expected, before, drafting).faults()


def _tip(k: int, omega: float, ends: Sequence[MeasuredVector]) -> complex:
    """Give the place on paper of the speed at a position, by two ordinates of the graph."""
    first, last = ends
    assert first.position is not None and last.position is not None  # asked before
    step = (last.start - first.start) / (last.position - first.position)
    return first.start + (k - first.position) * step + 1j * omega / first.scale
