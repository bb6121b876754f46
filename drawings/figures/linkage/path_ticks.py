"""Ticks of the positions on the trajectories, and few of their numbers (засечки положений на траекториях)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.tracks import output_point
from drawings.figures.linkage.trajectories import Traced, traced
from drawings.layout.labels import Labels
from drawings.layout.place import Place
from drawings.paper.limits import MANY
from drawings.paper.strokes import Line, Stroke
from drawings.paper.ties import PLACES, tied
from drawings.symbols.symbols import TICK, tick
from drawings.symbols.trimming import trim

NUMBERED = 4  # about so many positions bear a number along a path
GAP = 1.0  # mm from a tick's end to its number
LONG = 40.0  # mm: a shorter path has no room for numbers


def path_ticks(pairs: Pairs) -> Iterator[Line]:
    """Tick each trajectory at the positions, across it; a tick that a symbol would cut is left out."""
    for one in traced(pairs.bones):
        for k in _shown(one):
            direction = _direction(one, k, pairs.place)
            if direction is not None:
                line = tick(pairs.place.on(complex(one.numbered[k])), direction, pairs.hand)
                yield from (line,) if list(trim([line], pairs.masks)) == [line] else ()


def path_numbers(pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Number a few ticks of each trajectory where there is room; output and crank have their numbers already."""
    drive, masses = pairs.bones.mechanism.drive, pairs.bones.masses
    known = {output_point(pairs.bones), *(name for name, (link, _) in masses.items() if link == drive.link)}
    for one in traced(pairs.bones):
        if one.name not in known and _length(one, pairs.place) >= LONG:
            yield from _numbers(pairs, one, labels)


def _numbers(pairs: Pairs, one: Traced, labels: Labels) -> Iterator[Stroke]:
    every = max(math.ceil(len(one.numbered) / NUMBERED), 1)
    for k in _shown(one):
        direction = _direction(one, k, pairs.place)
        if k % every == 0 and k != pairs.bones.shown and direction is not None:
            spot, gap = pairs.place.on(complex(one.numbered[k])), TICK * pairs.hand.symbol + GAP
            number = labels.close(spot, str(k), pairs.sheet.number, gap, cmath.phase(1j * direction))
            yield from () if number is None else (number,)


def _shown(one: Traced) -> list[int]:
    """List the positions that are ticked: of very many about as many as are drawn with all links."""
    every = max(math.ceil(len(one.numbered) / MANY), 1)
    return [k for k in range(0, len(one.numbered), every) if not math.isnan(one.numbered[k].real)]


def _direction(one: Traced, k: int, place: Place) -> complex | None:
    """Give the unit direction of a path at a position: of the longer step beside it; none of a point that stands."""
    apart = np.abs(one.way - one.numbered[k])
    if np.isnan(apart).all():
        return None
    nearest = int(np.nanargmin((apart / place.scale.mu).round(PLACES)))
    beside = one.way[max(nearest - 1, 0) : nearest + 2]
    steps = np.diff(beside[~np.isnan(beside)])
    longest = max(steps.tolist(), key=lambda step: tied(place.length(abs(step))), default=0j)
    return longest / abs(longest) if longest else None


def _length(one: Traced, place: Place) -> float:
    known = one.way[~np.isnan(one.way)]
    return place.length(float(np.abs(np.diff(known)).sum()))
