"""The motion in the report: structure, extremes, every value both ways, conditions, what was left out (движение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from drawings.lettering.words import number
from drawings.paper.limits import MANY
from drawings.report.chapters import Chapters
from drawings.report.gap_lines import gap_lines, position_numbers
from plans.checks.compare import NOT_GRADED, MotionComparison, notches
from plans.checks.comparison import Finding
from plans.linkage.pressure import interval
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ORDERS
from plans.model.structure import RUSSIAN, formula, mechanism_class
from plans.study import Study

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

NOTE, WARNING = 10.0, 60.0  # kappa = 1/sin of a notch: 6 degrees, 1 degree


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the structure and the motion of a linkage."""
    linkage, comparison = study["linkage"], study.comparison("linkage")
    passage = _passage(linkage, comparison)
    return Chapters(
        chain(_structure(linkage), _extremes(linkage) if "extremes" in study.plans else (), passage),
        _values(linkage, comparison),
        _conditions(linkage),
        _left_out(study, linkage, leaves),
    )


def headline(study: Study) -> str:
    """Say which link is the output, and who chose it."""
    return shown(study["linkage"])


def remarks(study: Study) -> list[str]:
    """Say why a motion is not whole: gaps, else barriers between positions; and positions not for grading."""
    linkage, gaps = study["linkage"], study.comparison("linkage").construction.gaps
    lines = gap_lines(gaps)
    if not gaps:
        lines += [f"{barrier.kind} at {barrier.where} between two positions: see the report" for barrier in linkage.met]
    near = shallow(linkage)
    if near:
        lines.append(f"{position_numbers(near)}: too near a dead centre to be graded: see Conditions in the report")
    return lines


def faults(text: str, study: Study) -> Iterator[str]:
    """Find no fault: the values of a motion are printed from the comparison that was judged."""
    yield from ()


def shown(study: LinkageStudy) -> str:
    """Say which link is the output, and who chose it."""
    out, named = study.output, study.mechanism.output is not None
    chosen = "as [output] names it" if named else "the last link on the frame; [output] names another"
    if not named and not any(FRAME in group.hosts for group in study.groups[-1:]):
        chosen = "the last link; [output] names another"
    return f"output: link {out.link}{f' by its point {out.point}' if out.point else ''}, {chosen}"


def shallow(study: LinkageStudy) -> list[int]:
    """Give the assembled positions in which some group is too near a dead centre to be graded."""
    if not study.groups:
        return []
    worst = notches(study).max(axis=0)
    return [int(k) for k in np.flatnonzero(~study.lost & ~(worst < NOT_GRADED))]


def _structure(study: LinkageStudy) -> Iterator[str]:
    mechanism = study.mechanism
    yield "\n## Structure\n"
    yield f"- Mobility W = 3·{mechanism.moving_links} - 2·{mechanism.lower_pairs} = {mechanism.mobility}"
    yield f"- Formula of structure: {formula(mechanism, study.groups)}; class {mechanism_class(study.groups)}"
    for group, side in zip(study.groups, study.sweep.sides, strict=True):
        joints = f"{group.kind} ({RUSSIAN[group.kind]})"
        yield f"- Group {group.label}: {joints}, assembly side {side:+.0f}, kept in every position"
    yield f"- Drive: link {mechanism.drive.link}, omega = {number(mechanism.drive.omega)} rad/s, " + (
        f"epsilon = {number(mechanism.drive.epsilon)} rad/s²"
    )


def _extremes(study: LinkageStudy) -> Iterator[str]:
    yield "\n## Extreme positions\n"
    yield f"- O{shown(study)[1:]}"
    if study.found is None:
        yield f"- Output link {study.output.link} has no extreme positions over the turn."
    else:
        found = study.found.extremes
        way = "by notches" if study.found.notched else "where the velocity plan gives the output no velocity"
        angles = ", ".join(f"{np.degrees(phi):.9f}°" for phi in found.phi)
        unit = "m" if found.sliding else "rad"
        yield f"- Crank angles, found {way}: {angles} (the working stroke begins at the first)"
        yield f"- {'Stroke H' if found.sliding else 'Swing'} = {number(found.stroke, digits=10)} {unit}" + (
            "" if found.sliding else f" = {np.degrees(found.stroke):.8f}°"
        )
        if len(study.found.rests) > 2:
            rests = ", ".join(f"{np.degrees(phi):.6f}°" for phi in study.found.rests)
            yield f"- The output reverses {len(study.found.rests)} times in a turn, at {rests}: no one time ratio"
        else:
            yield f"- Time-ratio angle θ = {np.degrees(found.overlap):.8f}°, K = {number(found.ratio, digits=10)}"
    if study.groups and not study.nodes.size:
        yield "- Pressure angles: none, for no position is assembled"
    for group in study.groups if study.nodes.size else ():
        seen = interval(study.sweep, group, study.nodes)
        low, high = np.degrees(seen.low), np.degrees(seen.high)
        yield f"- Pressure angle of group {group.label}: {low:.6f}° to {high:.6f}°"


def _passage(study: LinkageStudy, comparison: MotionComparison) -> Iterator[str]:
    gaps = comparison.construction.gaps
    if not study.met and not gaps and not study.passed:
        return
    yield "\n## Gaps and dead centres\n"
    for barrier in study.passed:
        at = number(float(np.degrees((barrier.start + barrier.end) / 2)) % 360.0)
        yield f'- change point at {barrier.where}, φ = {at}°: carried through (through = "{study.mechanism.through}")'
    for barrier in study.met:
        low, high = np.degrees(barrier.start), np.degrees(barrier.end)
        miss = f", the loci miss by up to {barrier.miss:.6g} m" if barrier.miss else ""
        yield f"- {barrier.kind} at {barrier.where}: crank angles {low:.6f}° to {high:.6f}°{miss}"
    lost = {gap.position for gap in gaps if gap.plan == "positions"}
    count = len(study.turn)
    yield f"- {count - len(lost)} of {count} positions are assembled"
    for gap in gaps:
        yield f"- Position {gap.position} (φ = {np.degrees(gap.phi):.3f}°), {gap.plan}: {gap.reason}; {gap.advice}"


def _values(study: LinkageStudy, comparison: MotionComparison) -> Iterator[str]:
    yield "\n## Values\n"
    yield "Every value by construction; under it by analysis where their ten digits differ. Vectors are x; y.\n"
    for plan in ORDERS:
        findings = [finding for finding in comparison.of(plan) if np.any(finding.construction != 0)]
        if findings:
            yield f"### {plan.capitalize()}\n"
            yield "| position | φ, ° | " + " | ".join(f"{f.name}, {f.unit}" for f in findings) + " |"
            yield "|---|---|" + "---|" * len(findings)
            for k, phi in enumerate(study.turn.phi):
                cells = " | ".join(_cell(finding, k) for finding in findings)
                yield f"| {k} | {np.degrees(phi):.4f} | {cells} |"
            yield ""


def _cell(finding: Finding, position: int) -> str:
    ours, theirs = (_text(values[position], finding.largest) for values in (finding.construction, finding.analysis))
    return ours if ours == theirs else f"{ours}<br>{theirs}"


def _text(value: complex | float, largest: float) -> str:
    if math.isnan(abs(value)):
        return "gap"
    if isinstance(value, complex):
        return f"{_text(value.real, largest)}; {_text(value.imag, largest)}"
    return number(0.0 if abs(value) < 1e-10 * largest else float(value), digits=10)


def _conditions(study: LinkageStudy) -> Iterator[str]:
    yield "\n## Conditions\n"
    if not study.groups:
        yield "The crank alone has no meeting."
        return
    table = notches(study)
    yield "kappa = 1/sin of the crossing angle magnifies every error of a meeting: from 10 a note, from 60 a warning"
    yield "(0.01 mm in a length moves the point by more than half a millimetre), from 600 not for grading.\n"
    yield "| group | largest kappa | in position | |"
    yield "|---|---|---|---|"
    for group, row in zip(study.groups, np.where(study.lost, np.nan, table), strict=True):
        if np.isnan(row).all():
            continue
        worst = int(np.nanargmax(row))
        said = "not for grading" if row[worst] >= NOT_GRADED else ""
        said = said or ("warning" if row[worst] >= WARNING else "note" if row[worst] >= NOTE else "")
        largest = f"{row[worst]:.4g}" if np.isfinite(row[worst]) else "no bound: a dead centre"
        yield f"| {group.label} | {largest} | {worst} | {said} |"


def _left_out(study: Study, linkage: LinkageStudy, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[str]:
    count = len(linkage.turn)
    sheets = [leaf for own in leaves.values() for leaf in own if "shown" in leaf.metadata]
    names = ", ".join(str(k) for leaf in sheets for k in leaf.metadata["plans"])
    if names:
        yield f"- Velocity and acceleration plans are drawn for positions {names} of {count}; the other values stand"
        yield f"  above. Notch arcs, pairs and letters are drawn for position {sheets[0].metadata['shown']} only."
    if sheets and count > MANY:
        yield f"- Of {count} positions about {MANY} are drawn with their links, the others by ticks; numbers that would"
        yield "  crowd each other are left out."
    missing = [plan for plan in ORDERS if plan not in study.made]
    if missing:
        yield f"- Plans not made: {', '.join(missing)}."
    still = [str(n) for n in sorted(linkage.mechanism.links) if n != FRAME and n not in _turning(linkage)]
    if still:
        yield f"- Links {', '.join(still)} do not turn: their angular velocity and acceleration have no column."


def _turning(study: LinkageStudy) -> set[int]:
    return set(study.drafts().velocities.readings) if "velocities" in study.made else set(study.mechanism.links)
