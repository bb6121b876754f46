"""The scales that figures may have, from the smallest on; figures of one key share one scale (общие масштабы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from statistics import fmean
from typing import NamedTuple

from drawings.layout.contents import Panel
from drawings.layout.picture import SMALLER, Picture, Rung
from drawings.page.scale import Scale

READ = 0.5  # share of the figures of one key that can be read at any scale that they share


class Steps(NamedTuple):
    """What figures of one scale may be enlarged to, from the smallest on: a rung of each figure, by its name.

    `sizes` tells how large they are at each step: the larger sides of their lines over their weight, mm.
    """

    rungs: tuple[Mapping[str, Rung], ...]
    sizes: tuple[float, ...]

    def at(self, level: float) -> int:
        """Give the last step that is no larger than a level, mm, or else the first."""
        return max(sum(size <= level for size in self.sizes) - 1, 0)


class _Figure(NamedTuple):
    """A picture with its scales, the smallest picture first."""

    picture: Picture
    weight: float
    rungs: tuple[Rung, ...]

    @property
    def read(self) -> tuple[Rung, ...]:
        """The scales at which it can be read."""
        return tuple(rung for rung in self.rungs if can_be_read(self.picture, rung))

    def at(self, scale: Scale) -> Rung:
        """Give its rung at a scale."""
        return Rung(scale, *self.picture.size(scale), self.picture.extent(scale))

    def legible(self, scale: Scale) -> Rung:
        """Give its rung at a scale; where it cannot be read there, at the next scale at which it can."""
        own = self.at(scale)
        if can_be_read(self.picture, own) or not self.rungs:
            return own
        return next(iter(self.read), self.rungs[-1])


def can_be_read(picture: Picture, rung: Rung) -> bool:
    """Tell whether a picture is large enough for its letters; a point needs no size."""
    return rung.extent == 0 or rung.extent >= picture.least * SMALLER


def steps_of(panels: Sequence[Panel], room: tuple[float, float], standard: str, legible: bool) -> tuple[Steps, ...]:
    """Give the steps of all figures that fit a room, the legible ones alone or all: those of one key together."""
    keyed: dict[tuple[str, int], list[_Figure]] = {}
    for k, panel in enumerate(panels):
        if isinstance(panel.item, Picture):
            rungs = panel.item.ladder(*room, standard).rungs[::-1]
            key = (panel.scale, 0 if panel.scale else k)
            keyed.setdefault(key, []).append(_Figure(panel.item, panel.weight, rungs))
    return tuple(_steps(own, legible) for own in keyed.values())


def _steps(figures: Sequence[_Figure], legible: bool) -> Steps:
    """Enlarge figures together, as far as the one that needs most paper fits."""
    sized = [one for one in figures if max(one.picture.wide, one.picture.high)] or figures  # a point has any scale
    largest = max(sized, key=lambda one: one.rungs[-1].scale.mu if one.rungs else math.inf)
    scales = [rung.scale for rung in largest.rungs]
    every = [
        {one.picture.name: one.legible(scale) if legible else one.at(scale) for one in figures} for scale in scales
    ]
    shares = [fmean(can_be_read(one.picture, one.at(scale)) for one in figures) for scale in scales]
    least = min(READ, max(shares, default=READ)) or READ if legible else 0.0  # of one that is never legible no step
    kept = [step for step, share in zip(every, shares, strict=True) if share >= least]
    return Steps(tuple(kept), tuple(fmean(_sizes(figures, step)) for step in kept))


def _sizes(figures: Sequence[_Figure], step: Mapping[str, Rung]) -> Iterator[float]:
    """Give the sizes of figures over their weights; a point is as large as it can be."""
    for one in figures:
        extent = step[one.picture.name].extent
        yield extent / one.weight if extent else math.inf
