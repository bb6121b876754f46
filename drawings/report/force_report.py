"""The forces in the report: masses, reactions of all positions, what the drive gives, friction (силы в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from drawings.lettering.words import number, runs
from drawings.report.chapters import Chapters
from drawings.report.gap_lines import gap_lines
from plans.checks.force_comparison import ForceComparison
from plans.forces.statics import Statics
from plans.model.kinetostatics import FORCES, Kinetostatics
from plans.model.losses import Friction
from plans.study import Study

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = 10


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the forces of a linkage."""
    shown = dict.fromkeys(
        leaf.metadata["position"] for own in leaves.values() for leaf in own if "position" in leaf.metadata
    )
    return Chapters(
        values=forces(study.comparison("forces"), study["forces"]),
        left_out=[f"- Force plans are drawn for position {', '.join(map(str, shown))}; the forces of all stand above."],
    )


def headline(study: Study) -> str:
    """Say nothing more on the screen than the motion does."""
    return ""


def remarks(study: Study) -> list[str]:
    """Say which positions have no forces, and which pairs jam by friction, and where."""
    comparison, friction = study.comparison("forces"), study["forces"].friction
    lines = gap_lines([gap for gap in comparison.construction.gaps if gap.plan == FORCES])
    jams = friction.jams if friction is not None else ()
    for pair in dict.fromkeys(jam.pair for jam in jams):
        own = [jam for jam in jams if jam.pair == pair]
        where = runs([jam.position for jam in own], "-")
        lines.append(f"pair {pair} jams by friction in positions {where}: {own[0].advice}")
    return lines


def forces(comparison: ForceComparison, statics: Statics) -> Iterator[str]:
    """Tell what acts, every reaction by construction, and what friction takes."""
    found = comparison.construction
    yield from _bodies(statics)
    yield from _reactions(found)
    yield from _gaps(found)
    if statics.friction is not None:
        yield from _friction(statics.friction)


def _bodies(statics: Statics) -> Iterator[str]:
    yield "\n## Masses and loads\n"
    machine = statics.machine
    for link, body in sorted(machine.bodies.items()):
        centre = f"({number(body.centre.real)}; {number(body.centre.imag)})"
        yield f"- Link {link}: m = {number(body.mass)} kg, J = {number(body.inertia)} kg·m² about S at {centre} m"
    gravity = f"({number(machine.gravity.real)}; {number(machine.gravity.imag)}) m/s²"
    yield f"- Gravity: {gravity if machine.gravity else 'none'}"
    for force in machine.forces:
        yield f"- {force.name} at {force.point} of link {force.link}, {force.during}"
    for moment in machine.moments:
        yield f"- {moment.name} on link {moment.link}, {moment.during}"
    for spring in machine.springs:
        yield f"- {spring.name} between {spring.points[0]} and {spring.points[1]}: {number(spring.stiffness)} N/m"


def _reactions(found: Kinetostatics) -> Iterator[str]:
    yield "\n## Reactions\n"
    yield "R_ab is the force of link a on link b, N, as x; y; of a sliding pair M is its moment, N·m, about the point."
    yield "M_bal is the moment that the drive must give, N·m.\n"
    told = sorted(found.reactions.values(), key=lambda one: (one.giver, one.taker))
    force, moment = found.nothing
    heads, rows = ["M_bal"], list[Any]([_sized(found.balancing.moment, moment)])
    for one in told:
        heads.append(f"R_{one.giver}-{one.taker} at {one.point}")
        rows.append(_sized(one.force, force))
        if one.moment is not None and np.nanmax(np.abs(one.moment), initial=0.0) > moment:
            heads.append(f"M_{one.giver}-{one.taker}")
            rows.append(_sized(one.moment, moment))
    yield "| position | " + " | ".join(heads) + " |"
    yield "|---|" + "---|" * len(heads)
    for k in range(len(found.phi)):
        yield f"| {k} | " + " | ".join(_cell(row[k]) for row in rows) + " |"


def _sized(row: Any, nothing: float) -> Any:
    """Give what is but rounding as zero."""
    return np.where(np.abs(row) <= nothing, 0.0, row)


def _cell(value: complex | float) -> str:
    if np.isnan(value):
        return "gap"
    if isinstance(value, complex):
        return f"{number(value.real, digits=DIGITS)}; {number(value.imag, digits=DIGITS)}"
    return number(float(value), digits=DIGITS)


def _gaps(found: Kinetostatics) -> Iterator[str]:
    for gap in found.gaps:
        if gap.plan == "forces":
            yield f"\n- Position {gap.position} (φ = {np.degrees(gap.phi):.3f}°): {gap.reason}; {gap.advice}"


def _friction(found: Friction) -> Iterator[str]:
    yield "\n## Friction and efficiency\n"
    yield "Powers of friction W with the reactions of the frictionless machine: errors are of the order f².\n"
    yield "| position | " + " | ".join(found.powers) + " | all | useful | efficiency |"
    yield "|---|" + "---|" * (len(found.powers) + 3)
    for k in range(len(found.phi)):
        told = [*(power[k] for power in found.powers.values()), found.lost[k], found.useful[k], found.efficiency[k]]
        yield f"| {k} | " + " | ".join("—" if np.isnan(one) else number(float(one), digits=6) for one in told) + " |"
    if found.cycle is not None:
        yield f"\n- Efficiency over the cycle, of the mean powers: {number(found.cycle, digits=6)}"
    worn = ", ".join(f"{key} {number(100 * share)} %" for key, share in found.wear.items())
    yield f"- Share of wear by pair, the most worn first: {worn}"
    for jam in found.jams:
        ratio = number(jam.ratio)
        yield f"- Pair {jam.pair} jams in position {jam.position}: friction {ratio} of what drives it; {jam.advice}"
