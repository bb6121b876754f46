"""A linkage in the report's first lines: links, stroke, angles, what it is called (механизм в цифрах)."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from drawings.lettering.words import fixed, number, word
from drawings.report.table import Subject
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import EQUAL, frame_slide
from plans.model.dyad import Group, formula, mechanism_class
from plans.model.machine import ways
from plans.model.mechanism import Mechanism, Output
from plans.model.motion import ACCELERATIONS, VELOCITIES, Motion, Order
from plans.study import Study
from plans.words import words
from plans.words.words import Message, message
from plans.words.words import word as plain_word

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


PAIRS = {"R": "turning", "P": "sliding"}


def subject(study: Study) -> Subject:
    """Tell the structure of a linkage and how far its output goes."""
    linkage = study.of(LinkageStudy)
    return Subject(_formula(linkage), _stroke(linkage), _sentence(linkage))


def _formula(study: LinkageStudy) -> str:
    return re.sub(r"II(\d)", r"II<sub>\1</sub>", formula(study.mechanism, study.groups).replace("->", "→"))


def _sentence(study: LinkageStudy) -> str:
    """Say the formula of structure in words: the crank, then each group with its kind and the order of its pairs."""
    groups = "; ".join(_group(group) for group in study.groups)
    return (
        f"Structure: {_formula(study)}, class {mechanism_class(study.groups)}: crank {study.mechanism.drive.link}; "
        f"{groups}. Output: {_stroke(study)}."
    )


def _group(group: Group) -> str:
    pairs = ", ".join(PAIRS[letter] for letter in group.kind)
    return f"links {' and '.join(map(str, group.links))}, {group.kind} ({pairs})"


def _stroke(study: LinkageStudy) -> str:
    """Say how far the output goes and with what time ratio, or that it has no extreme positions."""
    output, found = study.output, study.travel
    if output.point and frame_slide(study.mechanism, output.link) is None:
        return f"point {output.point} of link {output.link}"
    if found is None:
        return f"link {output.link}, within the angles given"
    extremes = found.extremes
    far = f"stroke {number(1000 * extremes.stroke)} mm"
    if not extremes.sliding:
        far = f"swing {number(float(np.degrees(extremes.stroke)))}°"
    ratio = f"K = {number(extremes.ratio)}" if len(found.rests) == 2 else f"reverses {len(found.rests)} times"
    return f"link {output.link}, {far}, {ratio}"


PLACES = 4  # decimals of an angle in degrees


def stroke_line(
    mechanism: Mechanism, output: Output, reach: tuple[float, float], angles: tuple[float, float], language: str
) -> str:
    """Say which way the working stroke goes, and how far the crank turns over it and over the idle one."""
    work, idle = (fixed(float(np.degrees(angle)), language, PLACES) for angle in angles)
    way = tuple(message(f"way.{name}") for name in ways(mechanism, output, *reach))
    return plain_word(language, "report.working", time=_time(*angles), ways=way, work=work, idle=idle)


def _time(work: float, idle: float) -> Message:
    """Say whether the working stroke takes longer than the idle one."""
    if abs(work - idle) < EQUAL:
        return message("way.equal")
    return message("way.slower" if work > idle else "way.faster")
