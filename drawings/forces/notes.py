"""What a force sheet says in words: masses, drive, agreement of the roads, friction and efficiency (пояснения)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from drawings.forces.letters import force_letter
from drawings.forces.report import least, stretching, working_of
from drawings.lettering.words import Slot, joined, number, numbered, phrase, runs, with_index, word
from drawings.linkage.notes import driving, lengths
from drawings.report.report import ANGLE
from geometry.board import at
from plans.forces.quantities import ForceComparison
from plans.forces.statics import Statics, told_line
from plans.forces.worth import worth
from plans.model.machine import ALWAYS, GEAR, Force, Moment
from plans.model.motion import NOTHING, Rates
from plans.words.words import term

NBSP = "\N{NO-BREAK SPACE}"
INDEX = ("friction index", "useful index")  # of powers


def notes(statics: Statics, comparison: ForceComparison, position: int, language: str) -> list[str]:
    """Write what the sheet says in words: what is given, what the lever carries, what friction takes."""
    rates = Rates(*statics.study.rates.at(position))
    given = [driving(statics.study, rates, language), *lengths(statics.study, language)]
    given += [*masses(statics, language), *_loads(statics, language)]
    return [
        *given,
        word(language, "known lines"),
        *_balanced(statics, position, language),
        *_friction(statics, comparison, position, language),
        *_choice(statics, comparison, position, language),
    ]


def _choice(statics: Statics, comparison: ForceComparison, position: int, language: str) -> Iterator[str]:
    asked = statics.study.form.sheet
    if statics.form.sheet.forces or asked.position is not None or position in asked.plans:
        return
    rated = worth(statics, comparison.construction)
    if rated.loaded and rated.hardest != position:
        yield word(language, "position chosen", position=position, hardest=rated.hardest)
    if rated.lines:
        yield word(language, "no open plans", plans=", ".join(_plan(name, language) for name in rated.lines))


def _plan(name: str, language: str) -> str:
    _, _, group = name.partition("-")
    title = word(language, "force plan", group=group) if group else term(language, "plan", name)
    return f"{title[:1].lower()}{title[1:]}"


def _loads(statics: Statics, language: str) -> Iterator[str]:
    yield from loads_given(statics.machine.loads, statics, language)
    how = statics.machine.transmission
    if how.kind == GEAR:
        radius = f"{number(1000 * how.radius, language)}{NBSP}{word(language, 'mm')}"
        at, pressure = (number(float(np.degrees(angle)), language) for angle in (how.at, how.pressure))
        yield word(language, "gear given", radius=radius, at=at, pressure=pressure)


def loads_given(loads: Iterable[Force | Moment], statics: Statics, language: str) -> Iterator[str]:
    """Tell loads by their laws, and the springs."""
    yield from (load_given(load, statics, language) for load in loads)
    for spring in statics.machine.springs:
        stiffness = f"{number(spring.stiffness, language)}{NBSP}{word(language, 'N/m')}"
        free = f"{number(spring.free, language)}{NBSP}{word(language, 'm')}"
        ends = {"name": force_letter(spring.name, language), "start": spring.points[0], "end": spring.points[1]}
        yield word(language, "spring given", **ends, stiffness=stiffness, free=free)


def load_given(load: Force | Moment, statics: Statics, language: str) -> str:
    """Tell one load: its size and law, on which stroke, with what overrun, and what its diagram was stretched by."""
    name, unit = force_letter(load.name, language), word(language, "N" if isinstance(load, Force) else "N*m")
    size = f"{number(load.size, language)}{NBSP}{unit}"
    if isinstance(load, Force) and load.diagram is not None:
        said = word(language, "load diagram", name=name)
    elif isinstance(load, Force) and load.direction is None and load.line is None:
        said = word(language, "load against", name=name, size=size, point=load.point)
    elif isinstance(load, Moment) and load.against:
        said = word(language, "moment against", name=name, size=size, link=load.link)
    else:
        on = {} if isinstance(load, Force) else {"link": load.link}
        said = word(language, "load on link" if on else "load always", name=name, size=size, **on)
    during = [*_place(load, language), *_sides(load, language)] if isinstance(load, Force) else []
    during += [] if load.during == ALWAYS else [word(language, load.during)]
    during += working_of(load, statics, language)
    if load.overrun != (0.0, 0.0):
        shares = dict.fromkeys(number(share, language) for share in load.overrun)
        during.append(word(language, "overrun", share="; ".join(shares)))
    if told := stretching(load, statics, language):
        during.append(word(language, "load stretched", **told))
    return ", ".join([said, *during])


def _place(force: Force, language: str) -> Iterator[str]:
    if force.direction is not None:
        angle = number(float(np.degrees(np.angle(force.direction))), language)
        yield word(language, "load at", point=force.point, angle=angle)
    if force.other is not None:
        yield word(language, "load between", start=force.point, end=force.other.point)
    if force.line is not None and (force.other is None or told_line(force)):
        yield word(language, "load along", line="".join(force.line))
    if force.resists:
        yield word(language, "load resisting")


def _sides(force: Force, language: str) -> Iterator[str]:
    """Tell the areas of a piston whose pressure is drawn or whose sides differ by its rod, and what presses behind."""
    piston = force.piston
    if piston is not None and (force.card or piston.area != piston.other):
        sizes = {"there": 1e4 * piston.area, "other": 1e4 * piston.other, "behind": piston.behind}
        yield word(language, "piston sides", **{name: number(size, language) for name, size in sizes.items()})
    yield from [word(language, "one side")] if force.one_sided else []


def _balanced(statics: Statics, position: int, language: str) -> Iterator[str]:
    """Tell that the lever balances without a moment of the crank, where a cylinder drives."""
    lever = statics.drafts().plans.lever
    moved = lever is not None and any(at(moment.point, position).real for _, moment in lever.moments)
    if moved and statics.study.mechanism.drive.ram is not None:
        yield word(language, "balanced lever")


def masses(statics: Statics, language: str) -> Iterator[str]:
    """Tell the masses and moments of inertia of the links."""
    told = []
    for link, body in sorted(statics.machine.bodies.items()):
        if body.mass:
            told.append(f"m_{{{link}}} = {number(body.mass, language)}{NBSP}{word(language, 'kg')}")
        if body.inertia:
            told.append(f"J_{{S{link}}} = {number(body.inertia, language)}{NBSP}{word(language, 'kg*m2')}")
    yield ",  ".join(told) or word(language, "no masses")


def given(statics: Statics, language: str) -> Iterator[str]:
    """Tell lengths, masses, mass centres and gravity where no scheme of forces shows them."""
    yield from (*lengths(statics.study, language), *masses(statics, language))
    told, gravity = [], statics.machine.gravity
    for link, body in sorted(statics.machine.bodies.items()):
        name = "".join(map(with_index, [*statics.study.mechanism.links[link].points][:2]))
        at = "; ".join(number(1000 * size, language) for size in (body.centre.real, body.centre.imag))
        told.append(f"{name}: S_{{{link}}} ({at})")
    if told:
        size, way = (number(part, language) for part in (abs(gravity), np.degrees(np.angle(gravity))))
        yield word(language, "centres given", given=",  ".join(told))
        yield f"g = {size}{NBSP}{word(language, 'm/s2')}{ANGLE}{way}°" if gravity else word(language, "no weights")


def _friction(statics: Statics, comparison: ForceComparison, position: int, language: str) -> Iterator[str]:
    found = statics.friction
    if found is None or not np.isfinite(found.lost[position]):
        return
    none = least(comparison, found)[1:]
    rows = zip((found.lost, found.useful), none, strict=True)
    power = (float(row[position]) if abs(row[position]) > few[position] else 0.0 for row, few in rows)
    lines = list[str]()
    served = bool(np.isfinite(found.efficiency).any())
    for said, value in zip(INDEX if served else INDEX[:1], power, strict=served):
        watts = joined(NBSP, (numbered(language, Slot(f"{said} {position}", value)), word(language, "W")))
        lines.append(phrase(language, said, power=watts))
    if np.isfinite(found.efficiency[position]):
        slot = Slot(f"η {position}", float(found.efficiency[position]), 3)
        lines.append(joined("", ("η = ", numbered(language, slot))))
    if not served:
        lines.append(word(language, "no useful load"))
    if found.cycle is not None:
        lines.append(phrase(language, "cycle efficiency", eta=Slot("η", found.cycle, 3)))
    coefficients = sorted({pair.coefficient for pair in statics.machine.friction.values()})
    given = "; ".join(number(coefficient, language) for coefficient in coefficients)
    yield joined("", (f"{word(language, 'coefficients', f=given)}: ", joined(", ", lines)))
    if any(pair.coefficient * pair.radius > 0 for pair in statics.machine.friction.values()):
        yield word(language, "friction circles")
    if found.wear:
        slots = {key: Slot(f"wear {key}", 100 * share, 3) for key, share in found.wear.items() if share > NOTHING}
        worn = (joined(NBSP, (key, numbered(language, slot), "%")) for key, slot in slots.items())
        yield joined("", (f"{word(language, 'wear', count=np.isfinite(found.lost).sum())}: ", joined(", ", worn)))
    if found.jams:
        pairs = ", ".join(dict.fromkeys(jam.pair for jam in found.jams))
        yield word(language, "jams", pairs=pairs, positions=runs(sorted({jam.position for jam in found.jams})))
