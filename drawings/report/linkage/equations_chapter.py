"""The chapter of a note on velocities and accelerations: vector equations, and their numbers (планы скоростей)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import TYPE_CHECKING, cast

import numpy as np

from drawings.lettering import words as lettering
from drawings.lettering.words import number
from drawings.page.drafting import Drafting, drafting_of
from drawings.page.scale import Scale
from drawings.paper.walk import groups
from drawings.report.formula import Formula, display
from drawings.report.linkage.vector_equations import A, Plans, V, VectorEquations
from drawings.report.markdown import chapter
from plans.checks.compare import largest_of
from plans.linkage.groups.vector_sums import VectorSum, VectorSums
from plans.linkage.groups.vectors import Turning
from plans.linkage.primary import PRIMARIES
from plans.linkage.study import LinkageStudy
from plans.model.dyad import Dyad
from plans.model.motion import Motion
from plans.model.order import ACCELERATIONS, PLANS, POSITIONS, VELOCITIES
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

MOST = 6  # positions whose numbers are put in: a note of more is read by nobody, and the tables have them all
Scales = Mapping[int, Mapping[str, Scale]]  # of the plans of a position, by their names


def drawn_scales(leaves: Mapping[str, Sequence[Leaf]]) -> dict[int, dict[str, Scale]]:
    """Give the scales of the plans of positions, velocities and accelerations that sheets show, by position."""
    found: dict[int, dict[str, Scale]] = {}
    for leaf in (leaf for own in leaves.values() for leaf in own):
        for mark in groups(leaf.groups):
            told = mark.data
            if told.get("plan") in (POSITIONS.plan, V, A) and "position" in told and "scale" in told:
                letter = "l" if told["plan"] == POSITIONS.plan else told["quantity"]
                scale = Scale(float(told["scale"]), letter, told["unit"])
                found.setdefault(int(told["position"]), {})[told["plan"]] = scale
    return found


def shown_positions(leaves: Mapping[str, Sequence[Leaf]]) -> list[int]:
    """Give the positions whose plans of velocities, or whose forces, are drawn, as many as a note puts numbers in."""
    scales = drawn_scales(leaves)
    asked = [k for k, own in scales.items() if V in own] + [
        leaf.metadata["position"] for own in leaves.values() for leaf in own if "position" in leaf.metadata
    ]
    return sorted(dict.fromkeys(asked))[:MOST]


def equations(
    study: LinkageStudy, motion: Motion, scales: Scales, positions: Iterable[int], drafting: Drafting | None = None
) -> Iterator[str]:
    """Write the vector equations of each group, and the numbers of each position by a motion."""
    have = [k for k in positions if not np.isnan(motion.points[study.mechanism.drive.end].v[k])]
    if motion.order < ACCELERATIONS.number or not have:
        return
    language, formula = study.language, Formula(drafting or drafting_of(study.scene))
    yield chapter(language, "equations")
    yield word(language, "report.underlines")
    first = _written(study, motion, have[0], {}, formula)
    for group in study.groups:
        yield from _lettered(first, cast(Dyad, group))
    for k in have:
        yield in_position(study, k)
        own = scales.get(k, {})
        yield from _scales(study, own)
        yield from _numbers(study, _written(study, motion, k, own, formula))


def in_position(study: LinkageStudy, k: int) -> str:
    """Head what is told of one position, with the crank's angle or the drive's way in it."""
    drive, value = study.mechanism.drive, float(study.turn.phi[k])
    angle = f"φ = {number(float(np.degrees(value)) % 360, study.language)}°"
    mm = lettering.word(study.language, "mm")
    way = f"s = {number(1000 * drive.unit * value, study.language)} {mm}"
    return word(study.language, "report.in_position", position=k, station=way if drive.pushed else angle)


def _written(
    study: LinkageStudy, motion: Motion, k: int, scales: Mapping[str, Scale], formula: Formula
) -> VectorEquations:
    sums = VectorSums(study.mechanism, motion, k, study.drafts().velocities.written)
    fastest = largest_of([np.abs(rows.omega) for rows in motion.links.values()])
    plans = Plans(sums, {name: one.mu for name, one in scales.items()}, largest(motion), fastest)
    return VectorEquations(plans, formula)


def largest(motion: Motion) -> dict[str, float]:
    """Give the largest velocity and acceleration of named points over all positions."""
    return {
        order.plan: largest_of([np.abs(rows[order.number]) for rows in motion.points.values()])
        for order in (VELOCITIES, ACCELERATIONS)
    }


def _lettered(written: VectorEquations, group: Dyad) -> Iterator[str]:
    legs, language = written.sums.of(group), written.language
    yield word(language, "report.of_group", group=group.label, joints=group.kind)
    for line in written.lettered(legs):
        yield from display(line)
    yield written.directions(legs)


def _scales(study: LinkageStudy, scales: Mapping[str, Scale]) -> Iterator[str]:
    formula = Formula(drafting_of(study.scene))
    told = [_scale(scales[plan], formula) for plan in PLANS if plan in scales]
    if told:
        yield word(study.language, "report.scales", scales=", ".join(told)) + "\n"


def _scale(scale: Scale, formula: Formula) -> str:
    unit, mm = (formula.drafting.word(name) for name in (scale.unit, "mm"))
    true = f"({unit})" if "/" in unit else unit
    return f"${formula.letter(f'μ_{scale.letter}')} = {formula.number(scale.mu)}{formula.unit(f'{true}/{mm}')}$"


def _numbers(study: LinkageStudy, written: VectorEquations) -> Iterator[str]:
    drive = study.mechanism.drive
    yield word(written.language, "report.primary", link=drive.link)
    told = written.of_point(drive.end) if drive.pushed else chain(*map(written.crank, _primary(study, written.sums)))
    yield from map("- {}".format, told)
    for group in study.groups:
        yield word(written.language, "report.numbers_of_group", group=group.label)
        yield from map("- {}".format, written.numbers(cast(Dyad, group)))


def _primary(study: LinkageStudy, sums: VectorSums) -> Iterator[VectorSum]:
    vectors = PRIMARIES[study.mechanism.drive.kind].vectors(study.mechanism)
    return (sums.turning(vector) for vector in vectors if isinstance(vector, Turning))
