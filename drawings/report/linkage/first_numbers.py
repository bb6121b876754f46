"""The numbers that are asked for first: stroke, time ratio, greatest rates of the output (итоги)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from drawings.lettering.words import fixed, number, word
from plans.linkage.study import LinkageStudy
from plans.model.motion import Motion
from plans.model.order import ACCELERATIONS, VELOCITIES, Order
from plans.words import words

DIGITS = 5
RATIO, ANGLE = 4, 3  # decimals of the time ratio, and of a swing in degrees


def first_numbers(study: LinkageStudy, motion: Motion) -> str:
    """Give stroke or swing, time ratio, and the output's greatest velocity and acceleration over the positions."""
    return ", ".join([*_travel(study), *_greatest(study, motion)])


def greatest(values: npt.NDArray[np.complex128 | np.float64]) -> tuple[float, int] | None:
    """Give the largest size of some values over the positions, and where it is; nothing of gaps alone.

    >>> greatest(np.array([1.0, np.nan, -3.0]))
    (3.0, 2)
    """
    sizes = np.abs(values)
    if not np.isfinite(sizes).any():
        return None
    where = int(np.nanargmax(sizes))
    return float(sizes[where]), where


def _travel(study: LinkageStudy) -> Iterator[str]:
    found = study.travel
    if found is None:
        return
    extremes, language = found.extremes, study.language
    if extremes.sliding:
        yield f"H = {number(extremes.stroke, language, DIGITS)} {word(language, 'm')}"
    else:
        yield f"ψ = {fixed(float(np.degrees(extremes.stroke)), language, ANGLE)}°"
    if len(found.rests) == 2:
        yield f"K = {fixed(extremes.ratio, language, RATIO)}"


def _greatest(study: LinkageStudy, motion: Motion) -> Iterator[str]:
    for order in (VELOCITIES, ACCELERATIONS):
        if order.number <= motion.order:
            yield from _of(study, motion, order)


def _of(study: LinkageStudy, motion: Motion, order: Order) -> Iterator[str]:
    """Tell the greatest of one order: of the output's point, or of its link where it has none."""
    out, language = study.output, study.language
    told = order.point if out.point else order.link
    values = motion.points[out.point] if out.point else motion.links[out.link]
    found = greatest(values[order.number])
    if found is not None:
        size, unit = number(found[0], language, DIGITS), word(language, told.unit)
        parts = {"letter": f"{told.symbol}_{out.point or out.link}", "size": size, "unit": unit}
        yield words.word(language, "report.greatest", **parts, position=found[1])
