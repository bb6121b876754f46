"""The self-check of the positions on a load diagram: each number stands where its load is by analysis (проверка)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.dynamics.dynamics_expected import KNOWN
from drawings.checks.dynamics.dynamics_graphs import has
from drawings.checks.dynamics.dynamics_sizes import loads as corners
from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.wrong import Wrong, on
from drawings.figures.dynamics import load_diagram
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Leaf
from drawings.paper.walk import group_named, texts, walk
from plans.forces.loading import size_of, working_of
from plans.forces.stroke import Stroke, asks
from plans.model.machine import Force, Machine, Moment, Track
from plans.model.motion import Floats, Motion


def loads(
    measured: Measured,
    leaf: Leaf,
    machine: Machine,
    strokes: Mapping[Track, Stroke],
    motion: Motion,
    drafting: Drafting,
) -> Iterator[Wrong]:
    """Hold each load diagram of a force sheet: its corners, and the load in every position that bears a number."""
    shown = [load for load in machine.loads if asks(load) and group_named(leaf.groups, _name(load)) is not None]
    spots = {_name(load): _spots(measured, load, strokes, motion) for load in shown}
    yield from corners([*spots], measured, leaf, machine, strokes, drafting, spots)
    for load in shown:
        yield from _positions(measured, leaf, load, spots[_name(load)])


def _name(load: Force | Moment) -> str:
    return f"{load_diagram.NAME}-{load.name}"


def _spots(
    measured: Measured, load: Force | Moment, strokes: Mapping[Track, Stroke], motion: Motion
) -> Sequence[complex]:
    """Give where the load is in each position, on paper; none where the diagram tells no place."""
    own = {one.name: one for one in measured.vectors if one.plan == _name(load)}
    whole = own.get("H") or own.get("ψ")
    ordinate = next((one for one in own.values() if one.value.imag), None)
    if whole is None or ordinate is None:
        return ()  # told of by the check of the corners
    way = abs(whole.value) * strokes[load.stroke].share(motion) / whole.scale
    base = complex(whole.start.real, ordinate.start.imag)
    return [complex(spot) for spot in base + way + 1j * _signed(load, strokes, motion) / ordinate.scale]


def _positions(measured: Measured, leaf: Leaf, load: Force | Moment, spots: Sequence[complex]) -> Iterator[Wrong]:
    plan, group = _name(load), group_named(leaf.groups, _name(load))
    own = {one.name: one for one in measured.vectors if one.plan == plan}
    whole = own.get("H") or own.get("ψ")
    if group is None or whole is None or not spots:
        return
    dots = np.array([one.centre for one in walk((group,)) if isinstance(one, Circle)])
    labels = labels_of((group,))
    told = {int(text.plain) for text in texts((group,)) if text.plain.isdigit()} | {int(leaf.metadata["position"])}
    lettered = not any(name.isdigit() for name in own)  # else numbers of corners stand among those of positions
    near = 3 * measured.quantum + KNOWN * abs(whole.value) / whole.scale
    for k in sorted(one for one in told if one < len(spots) and not math.isnan(spots[one].real)):
        off = [distance([label], [spots[k]]) for label in labels.get(str(k), ())]
        astray = max(off, default=math.inf) if lettered else min(off, default=math.inf)
        if not has(dots, spots[k], near) or not astray <= NEAREST:
            yield on("differs_at", plan, name=str(k), position=k)


def _signed(load: Force | Moment, strokes: Mapping[Track, Stroke], motion: Motion) -> Floats:
    """Give a load over the positions as its diagram has it: one against the motion stands below on the way back."""
    turns = load.against if isinstance(load, Moment) else load.resists or (load.direction is None and load.line is None)
    idle = ~working_of(load, strokes[load.stroke], motion)
    return np.where(idle & turns, -1.0, 1.0) * size_of(load, motion, strokes)
