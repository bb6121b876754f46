"""Marks of a machine's motion by the names that `explain` takes: M_red, J_red, A_7, A_dr, o1k, o1l, J_0 (точки)."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from geometry.board import Mark, behind
from plans.dynamics.cycle import WORKS
from plans.dynamics.loop import LOOP, Loop
from plans.dynamics.reduction import SPEEDS, Reducing
from plans.dynamics.study import DynamicsStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage import marks as motion
from plans.model.dynamics import edge_names
from plans.study import Study
from plans.words.words import Message, message

MOMENT, INERTIA, DRIVING, RESISTING = "M_red", "J_red", "M_dr", "M_us"
SIDES = (DRIVING, RESISTING, "A_dr", "A_us")  # moments and works of the loads and of the constant other side
SEGMENTS = {"o1k": 1, "o1l": 0}  # cut off the axis of energy by the tangents of the greatest and the least speed
SEGMENT = re.compile(r"^o_?1([kl])([·/].*)?$")  # as the loop and the results letter it
TANGENTS = {"ψ_max": 1, "ψ_min": 0}
POINT = re.compile(r"A_(?P<edge>\d+'*)")
ORIGIN = ("J_0", "T_0", "J_fly")  # what the origin of the whole diagram gives
RESULTS = (DRIVING, RESISTING, "A_us(2π)", "A_dr(2π)", *SEGMENTS, *ORIGIN, "J_0^*", "ω_max", "ω_min", "δ")
BRACES = str.maketrans("", "", "{}")
UNITS = {**motion.UNITS, "forces": "N", "lever": "m", WORKS: "J", LOOP: "J", SPEEDS: "rad/s"}
EXAMPLES = (MOMENT, INERTIA, "o1k")


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark: of the reduction in one position, of the diagrams in the whole turn."""
    dynamics = study.of(DynamicsStudy)
    name = SEGMENT.sub(r"o1\1", name.replace("psi_", "ψ_"))
    if name in (MOMENT, INERTIA):
        return _reduced(dynamics, position, name)
    if name in (load.name for load in dynamics.statics.machine.loads):  # as a saw's M_us
        return NoMark((), None, EXAMPLES)
    if name == DRIVING and dynamics.cycle.engine:  # the moment of its gas, drawn as it is reduced
        return _reduced(dynamics, position, name)
    targets, notes = _diagram(dynamics, name), (*_notes(dynamics, name), *_result(study, name))
    if targets is None and not notes:
        loop = (*SEGMENTS, "J_0") if dynamics.task.delta is not None else ()
        examples = EXAMPLES if loop else EXAMPLES[:-1]
        return NoMark((MOMENT, INERTIA, "A_dr", *loop), None, examples)
    return Explanation(message("explain.name", mark=name), tuple(behind(*(targets or ()))), UNITS, notes)


def _reduced(dynamics: DynamicsStudy, position: int, name: str) -> Explanation:
    linkage = dynamics.linkage
    wanted = motion.position_of(linkage, position)
    lever = Reducing(dynamics.reduction, linkage.turn.part([wanted]))
    inertial = name == INERTIA
    terms = lever.moved if inertial else lever.acting
    total = float((lever.inertia if inertial else lever.moment)[0])
    note = message("explain.sum", mark=name, value=f"{total + 0.0:.10g}", unit="kg*m2" if inertial else "N*m")
    return Explanation(motion.title(linkage, name, wanted), tuple(behind(*terms)), UNITS, (note,), motion.HOME)


def _diagram(dynamics: DynamicsStudy, name: str) -> tuple[Mark, ...] | None:
    """Find a mark of the works or of the loop."""
    point = POINT.fullmatch(name)
    if point:
        return (_work(dynamics, point["edge"]),)
    if name in SIDES:
        loads, other = dynamics.cycle.indices
        if name in (f"A_{other}", f"M_{other}"):  # a line and its slope
            return (dynamics.works.drive,)
        return (dynamics.works.curve.points[-1],) if name == f"A_{loads}" else None
    loop = dynamics.loop if name in (*SEGMENTS, *TANGENTS, *ORIGIN) else None
    if loop is None:
        return None
    if name in TANGENTS:
        return (loop.tangents[TANGENTS[name]].line,)
    return (loop.tangents[SEGMENTS[name]].cut,) if name in SEGMENTS else (loop.origin,)


def _work(dynamics: DynamicsStudy, edge: str) -> Mark:
    """Give the point of the curve of work over an edge, by the name that it has on the sheet."""
    names = edge_names(dynamics.cycle.turned, dynamics.task.divisions)
    if edge not in names:
        raise UnknownMark(message("mark.strip", edge=edge, names=", ".join(names)))
    return dynamics.works.curve.points[names.index(edge)]


def _notes(dynamics: DynamicsStudy, name: str) -> tuple[Message, ...]:
    """Say how J0 follows from the segments, which do not hang on a far meeting of two lines."""
    loop: Loop | None = dynamics.loop
    if name not in ORIGIN or loop is None:
        return ()
    wheel = loop.flywheel
    return (message("explain.whole", whole=f"{wheel.whole:.10g}", energy=f"{wheel.energy:.10g}"),)


def _result(study: Study, name: str) -> Iterator[Message]:
    """Say of what the table of results tells what the strips come to, and what it is without their error."""
    for quantity in study.quantities("dynamics") if name in RESULTS else ():
        named = SEGMENT.sub(r"o1\1", quantity.name.translate(BRACES))
        if named == name and np.isinf(quantity.allowed[0]):  # is not judged
            ours, exact = (f"{row[0]:.10g}" for row in (quantity.construction, quantity.analysis))
            yield message("explain.strips", mark=name, ours=ours, exact=exact, unit=quantity.unit)
