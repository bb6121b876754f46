"""Forces and friction in the report: loads, equilibrium of groups, reactions, losses (силы в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from drawings.forces.letters import force_letter
from drawings.forces.report_equations import drawn_scales, equations, equations_of
from drawings.lettering import words as lettering
from drawings.lettering.words import fixed, number, runs
from drawings.linkage.notes import greatest, stroke_line
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, Formula, plain, see
from drawings.report.report import ANGLE, Report, chapter, column, gap_line, gap_lines, header, heading, row, tabled
from plans.forces.cut import indices
from plans.forces.drive import BalancingQuantity, balancing_quantity
from plans.forces.loading import asks
from plans.forces.quantities import ForceComparison
from plans.forces.reading.form import ForceTable
from plans.forces.reading.pressed import BEHIND, PRESSED
from plans.forces.statics import Statics
from plans.model.kinetostatics import Friction, Kinetostatics
from plans.model.machine import BACKWARD, FORWARD, GEAR, IDLE, WORKING, Diagram, Force, Machine, Moment
from plans.model.mechanism import FRAME, ways
from plans.model.motion import FORCES, NOTHING, Floats
from plans.study import Study
from plans.words.words import Message, message, word


class Least(NamedTuple):
    """The powers W over the positions up to which there are none: lost in each pair, in all, and of useful loads."""

    pairs: tuple[Floats, ...]
    lost: Floats
    useful: Floats


def least(comparison: ForceComparison, found: Friction) -> Least:
    """Give what is but rounding.

    Beside a position that all but jams much seems nothing: it is so only if the two roads cannot tell it from none.
    """
    most = NOTHING * max(float(np.nanmax(np.abs(row), initial=0.0)) for row in (found.lost, found.useful))
    slack = {power.name: np.minimum(power.allowed, most) for power in comparison.of("friction")}
    pairs = tuple(slack[f"N_{indices(*map(int, key.split('-')))}"] for key in found.powers)
    return Least(pairs, np.minimum(np.sum(pairs, axis=0), most), slack["N_us"])


LEVER = "lever"


def drafting_of_forces(statics: Statics) -> Drafting:
    """Give what a scene asks of its sheets, with the letter that it gives reactions."""
    return drafting_of(statics.study.scene)._replace(reactions=statics.form.sheet.reactions)


def balancing_table(comparison: ForceComparison, balancing: BalancingQuantity, language: str) -> Iterator[str]:
    """Tell the balancing moment, or force, by force plans and analysis, then by the lever, powers and energy."""
    found = [quantity for quantity in comparison.of(FORCES) if quantity.name.partition(" ")[0] == balancing.name]
    if not found:
        return
    parts = {"letter": lettering.letter(language, balancing.name), "unit": lettering.word(language, balancing.unit)}
    by_plans, by_equilibrium = (word(language, key, **parts) for key in ("report.by_plans", "report.by_equilibrium"))
    columns = {by_plans: found[0].construction, by_equilibrium: found[0].analysis}
    for finding in found[1:]:  # the lever is of the construction, powers and energy are of the analysis
        columns[heading(finding, language)] = finding.construction if finding.name.endswith(LEVER) else finding.analysis
    rows = np.array([_sized(np.real(column), comparison.construction.nothing_over[1]) for column in columns.values()])
    most = greatest(rows[0])
    if most is None:
        return
    k = most[1]
    yield word(language, "report.what_balances")
    yield from header([word(language, "table.position"), *columns])
    yield row([str(k), *(column([value], language)[0] for value in rows[:, k])])
    yield ""


FIGURES = ("scheme-", "forces-", "lever")  # of a force sheet, by what their names begin with
ROUNDED = 0.005  # degrees: less is no direction
SQUARE_CM, MPA = 1e4, 1e6  # cm2 in a m2, Pa in a MPa
WAYS = {WORKING: FORWARD, IDLE: BACKWARD}  # what lets a load of a stroke act on its reversals too


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the forces of a linkage."""
    language = study.scene.sheet.language
    comparison, statics = study.of(ForceComparison), study.of(Statics)
    scales = drawn_scales(leaves)
    lines = equations(statics, comparison, drafting_of_forces(statics), scales)
    return Chapters(
        subject=masses_and_loads(statics, language),
        values=[*lines, *see(leaves, language, *FIGURES), *forces(comparison, statics, language)],
        left_out=[word(language, "report.forces_drawn", positions=", ".join(map(str, scales)))],
    )


def headline(study: Study) -> str:
    """Give the greatest balancing moment; say of loads of one stroke alone that their output reverses within it."""
    language = study.scene.sheet.language
    statics = study.of(Statics)
    lines = _greatest(statics, study.of(ForceComparison).construction, language)
    massless = () if statics.machine.bodies else (lettering.word(language, "no masses"),)
    return "\n".join([*lines, *_warnings(statics, language), *massless])


def _concluded(study: Study) -> Iterator[str]:
    statics, found = study.of(Statics), study.of(ForceComparison).construction
    language, formula = statics.study.language, Formula(drafting_of_forces(statics))
    yield from (f"- {line}" for line in _greatest(statics, found, language))
    sizes = {indices(reaction.giver, reaction.taker): greatest(reaction.force) for reaction in found.reactions.values()}
    most = {index: size for index, size in sizes.items() if size is not None}
    if most:
        index = max(most, key=lambda index: float(f"{most[index][0]:.8e}"))  # equal ones: the first
        size, position = most[index]
        letter = f"${formula.letter(f'{statics.form.sheet.reactions}_{{{index}}}')}$"
        texts = {"letter": letter, "size": number(size, language, DIGITS), "position": position}
        yield word(language, "report.greatest_reaction", **texts)
    if statics.friction is not None and statics.friction.cycle is not None:
        yield word(language, "report.cycle", efficiency=number(statics.friction.cycle, language))
    if not statics.machine.bodies:
        yield f"- {lettering.word(language, 'no masses')}"


def _greatest(statics: Statics, found: Kinetostatics, language: str) -> Iterator[str]:
    drive = statics.study.mechanism.drive
    balancing = balancing_quantity(drive)
    given = statics.given(found, statics.study.motion(2))
    least = balancing.share * found.nothing_over[balancing.unit != "N" or drive.pushed]
    largest = greatest(np.where(np.abs(given) <= least, 0.0, given))
    if largest is not None:
        texts = {"letter": lettering.letter(language, balancing.name), "unit": lettering.word(language, balancing.unit)}
        size = number(largest[0], language, DIGITS)
        yield word(language, "report.greatest", **texts, size=size, position=largest[1])


def remarks(study: Study) -> list[Message]:
    """Say which positions have no forces, and which pairs jam by friction, and where."""
    comparison, friction = study.of(ForceComparison), study.of(Statics).friction
    lines = gap_lines([gap for gap in comparison.construction.gaps if gap.plan == FORCES])
    jams = friction.jams if friction is not None else ()
    for pair in dict.fromkeys(jam.pair for jam in jams):
        jammed = [jam for jam in jams if jam.pair == pair]
        where = runs([jam.position for jam in jammed], "-")
        lines.append(message("jam.pair", pair=pair, positions=where, advice=jammed[0].advice))
    return lines


def forces(comparison: ForceComparison, statics: Statics, language: str) -> Iterator[str]:
    """Tell what acts, every reaction by construction, and what friction takes."""
    found = comparison.construction
    balancing = balancing_quantity(statics.study.mechanism.drive)
    yield from _reactions(found, balancing, statics)
    yield from balancing_table(comparison, balancing, language)
    yield from _flanks(found, statics)
    gaps, drive = (gap for gap in found.gaps if gap.plan == FORCES), statics.study.mechanism.drive
    yield from (gap_line("report.force_gap", gap, drive, language) for gap in gaps)
    if statics.friction is not None:
        yield from friction_lines(comparison, statics.friction, language)


def mass_table(machine: Machine, language: str) -> Iterator[str]:
    """List the masses of the links, each with its centre in the link's own frame."""
    for link, body in sorted(machine.bodies.items()):
        numbers = {"mass": body.mass, "inertia": body.inertia, "x": body.centre.real, "y": body.centre.imag}
        texts = {name: number(size, language) for name, size in numbers.items()}
        yield word(language, "report.body", link=link, **texts)


def masses_and_loads(statics: Statics, language: str) -> list[str]:
    """Tell masses and loads, and the strokes that loads count."""
    return [*_bodies(statics, language), *_counted_strokes(statics, language)]


def _bodies(statics: Statics, language: str) -> Iterator[str]:
    machine = statics.machine
    say, write = partial(word, language), partial(number, language=language)
    yield chapter(language, "bodies")
    yield from mass_table(machine, language)
    bare = [str(link) for link in sorted(statics.study.mechanism.links) if link not in (FRAME, *machine.bodies)]
    if not machine.bodies:
        yield f"- {lettering.word(language, 'no masses')}"
    elif bare:
        yield say("report.massless", links=", ".join(bare))
    gravity = {"x": write(machine.gravity.real), "y": write(machine.gravity.imag)}
    yield say("report.gravity", **gravity) if machine.gravity else say("report.no_gravity")
    for force, table in zip(machine.forces, statics.form.loads.forces if statics.form.loads else (), strict=True):
        ends = {"point": force.point, "link": force.link, "during": force.during}
        far = {} if force.other is None else {"far": force.other.point, "other": force.other.link}
        line = say("report.force_between" if far else "report.force", name=force.name, **ends, **far)
        yield _size(line, force.size, force.diagram, language)
        yield from _piston(table, [lettering.word(language, "one side")] if force.one_sided else [], language)
    for moment in machine.moments:
        line = say("report.moment", name=moment.name, link=moment.link, during=moment.during)
        yield say("report.load_size", line=line, size=write(moment.size), unit=lettering.word(language, "N*m"))
    for spring in machine.springs:
        ends = {"name": spring.name, "start": spring.points[0], "end": spring.points[1]}
        yield say("report.spring", **ends, stiffness=write(spring.stiffness), free=write(spring.free))


def _piston(force: ForceTable, more: Sequence[str], language: str) -> Iterator[str]:
    if not force.pressed or force.bore is None:
        return
    say, write = partial(word, language), partial(number, language=language, digits=DIGITS)
    parts = [say("report.bore", size=write(1000 * float(force.bore)))]
    if force.rod is not None:
        parts.append(say("report.rod", size=write(1000 * float(force.rod)), on=force.rod_on))
    there, other = (write(SQUARE_CM * float(force.area(side))) for side in (PRESSED, BEHIND))
    parts.append(say("report.areas", there=there, other=other))
    for key, pressure in (("behind", force.behind), ("ambient", force.ambient)):
        parts += [say(f"report.{key}", size=write(float(pressure) / MPA))] if pressure else []
    yield say("report.piston", told="; ".join((*parts, *more)))


def _size(line: str, size: float, diagram: Diagram | None, language: str) -> str:
    unit = lettering.word(language, "N")
    if diagram is None:
        return word(language, "report.load_size", line=line, size=number(size, language), unit=unit)
    most = max(map(abs, (*diagram.sizes, *diagram.back)))
    return word(language, "report.load_diagram", line=line, size=number(size * most, language), unit=unit)


def _counted_strokes(statics: Statics, language: str) -> Iterator[str]:
    loads = [load for load in statics.machine.loads if asks(load)]
    for track, stroke in statics.strokes.items():
        names = ", ".join(load.name for load in loads if load.stroke == track)
        line = stroke_line(statics.study.mechanism, stroke.output, stroke.reach, stroke.angles, language, track.point)
        yield word(language, "report.counted", names=names, line=line.removeprefix("- "))
    yield from (f"- {line}" for line in _warnings(statics, language))


def working_of(load: Force | Moment, statics: Statics, language: str) -> Iterator[str]:
    """Tell of which point the working stroke is that a load counts, and which way it goes; nothing of the output's."""
    if asks(load) and load.stroke.point:
        stroke = statics.strokes[load.stroke]
        gone = tuple(message(f"way.{name}") for name in ways(statics.study.mechanism, stroke.output, *stroke.reach))
        yield word(language, "report.working_of", point=load.stroke.point, ways=gone)


def _warnings(statics: Statics, language: str) -> Iterator[str]:
    for load in statics.machine.loads:
        if told := stretching(load, statics, language):
            yield word(language, "verdict.stretched", name=plain(force_letter(load.name, language)), **told)
    for load, rests in statics.reversals:
        name = plain(force_letter(load.name, language))
        parts = {"name": name, "during": load.during, "way": WAYS[load.during], "count": len(rests)}
        angles = ", ".join(f"{number(float(np.degrees(angle)), language)}°" for angle in rests)
        yield word(language, "verdict.reverses", **parts, angles=angles)


def stretching(load: Force | Moment, statics: Statics, language: str) -> dict[str, str]:
    """Tell the length of a diagram over lengths, mm, the stroke and the factor between them; nothing where it is 1."""
    if not isinstance(load, Force) or load.diagram is None or not load.diagram.length:
        return {}
    (begin, end), length = statics.strokes[load.stroke].reach, load.diagram.length
    sizes = {"length": 1000 * length, "stroke": 1000 * abs(end - begin), "factor": abs(end - begin) / length}
    told = {name: number(size, language, DIGITS) for name, size in sizes.items()}
    return told if told["factor"] != "1" else {}


def _reactions(found: Kinetostatics, balancing: BalancingQuantity, statics: Statics) -> Iterator[str]:
    language, formula = statics.study.language, Formula(drafting_of_forces(statics))
    symbol = statics.form.sheet.reactions
    any_reaction, drive = (f"${formula.letter(name)}$" for name in (f"{symbol}_{{ab}}", balancing.name))
    parts = {"reaction": any_reaction, "balancing": drive, "unit": lettering.word(language, balancing.unit)}
    yield f"\n{word(language, 'report.reactions', **parts)}\n"
    reactions = sorted(found.reactions.values(), key=lambda reaction: (reaction.giver, reaction.taker))
    force, moment = found.nothing_over
    least = balancing.share * (force if statics.study.mechanism.drive.ram is not None else moment)
    columns = {drive: _sized(statics.given(found, statics.study.motion(2)), least)}
    for reaction in reactions:
        index = indices(reaction.giver, reaction.taker)
        letter = f"${formula.letter(f'{symbol}_{{{index}}}')}$"
        head = word(language, "report.reaction", letter=letter, point=f"${formula.line(reaction.point)}$")
        columns[head] = _sized(reaction.force, force)
        if reaction.moment is not None and np.any(np.abs(found.counted(reaction.moment)) > moment):
            columns[f"${formula.letter(f'M_{{{index}}}')}$"] = _sized(reaction.moment, moment)
    yield from header([word(language, "table.position"), *columns])
    rows = zip(*(_polar(values, language) for values in columns.values()), strict=True)
    yield from (row([str(k), *cells]) for k, cells in enumerate(rows))


def _flanks(found: Kinetostatics, statics: Statics) -> Iterator[str]:
    if statics.machine.transmission.kind != GEAR:
        return
    turning = np.sign(statics.study.mechanism.drive.omega) * found.balancing.moment
    against = np.flatnonzero(turning < -found.nothing_over[1]).tolist()
    moment = f"${Formula(drafting_of_forces(statics)).letter('M_bal')}$"
    said = "report.coast_flank" if against else "report.drive_flank"
    yield f"{word(statics.study.language, said, count=len(against), moment=moment, positions=runs(against))}\n"


def _sized(column: Any, nothing: Any) -> Any:
    return np.where(np.abs(column) <= nothing, 0.0, column)


def _polar(values: Any, language: str) -> list[str]:
    lines = column(values, language)
    if not np.iscomplexobj(values):
        return lines
    sizes, angles = column(np.abs(values), language), np.degrees(np.angle(values))
    angles[angles < ROUNDED - 180] = 180
    polar = zip(lines, sizes, np.abs(values), angles, strict=True)
    return [f"{xy} ({size}{ANGLE}{fixed(angle, language)}°)" if most > 0 else xy for xy, size, most, angle in polar]


def friction_lines(comparison: ForceComparison, found: Friction, language: str) -> Iterator[str]:
    """Tell what friction takes: the powers W lost in every pair and position, the efficiency, the wear, what jams."""
    say, write = partial(word, language), partial(number, language=language)
    yield f"\n{say('report.friction')}\n"
    yield say("report.friction_powers")
    heads = (say(f"table.{head}") for head in ("all", "useful", "efficiency"))
    pairs, *whole = least(comparison, found)
    powers = map(_sized, (*found.powers.values(), found.lost, found.useful), (*pairs, *whole))
    yield from tabled([*found.powers, *heads], [*powers, found.efficiency], language, "—")
    if found.cycle is not None:
        yield f"\n{say('report.cycle', efficiency=write(found.cycle))}"
    elif not np.isfinite(found.efficiency).any():
        yield f"\n- {say('sheet.no useful load')}"
    shares = ", ".join(f"{key} {write(100 * share)} %" for key, share in found.wear.items())
    yield say("report.wear", count=np.isfinite(found.lost).sum(), shares=shares)
    for jam in found.jams:
        parts = {"pair": jam.pair, "position": jam.position, "advice": jam.advice}
        yield say("report.jam", **parts, ratio=write(jam.ratio))


REPORT = Report(chapters, headline, remarks, conclusion=_concluded, equations=equations_of)
