"""The motion in the report: structure, extremes, every value both ways, conditions, what was left out (движение)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import chain

import numpy as np

from drawings.lettering.words import Phrase, Slot, fixed, number, phrase, slotted, span
from drawings.linkage.equations import drawn_scales, equations, equations_of, shown_positions
from drawings.linkage.notes import course, cylinder_law, first_numbers, law_said, stroke_line, subject, taken
from drawings.linkage.position_plan import drawn_every
from drawings.page.page import drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, Formula, display, inline, see
from drawings.report.report import Report, chapter, gap_line, gap_lines, header, positions, row, tabled
from plans.linkage.assembly import Barrier
from plans.linkage.parts import alike
from plans.linkage.quantities import NOT_GRADED, MotionComparison, notches
from plans.linkage.study import EXTREMES, LinkageStudy
from plans.linkage.sweep import interval
from plans.linkage.travel import ExtremePositions
from plans.model.dyad import Pair, formula, mechanism_class, pairs
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import PLANS, POSITIONS, VELOCITIES, Complexes, Floats
from plans.model.triad import Triad
from plans.quantity import Quantity
from plans.study import Study
from plans.words.words import Message, message, term, word

MM = 1000.0  # mm in a metre
ROUNDED = 6  # decimals of a degree: a rounding below zero is no whole turn


def data(study: LinkageStudy) -> Iterator[str]:
    """Tell what the scene gives: links, lengths, fixed points, slides, points by their places, the drive."""
    say, letters = partial(word, study.language), Formula(drafting_of(study.scene))
    yield chapter(study.language, "data")
    yield from header([say("table.link"), say("table.points")])
    for link in study.mechanism.links.values():
        names = ", ".join(f"${letters.line(name)}$" for name in link.points)
        yield row([str(link.number) if link.number != FRAME else say("report.frame"), names])
    yield ""
    given = study.form.mechanism.lengths
    sizes = {name: letters.quantity(MM * float(length), "mm") for name, length in given.items()}
    lines = (inline(letters.letter(f"l_{{{name}}}"), size) for name, size in sizes.items())
    if given:
        yield word(study.language, "report.lengths", lengths=", ".join(lines))
    yield from _places(study, letters)
    yield from (_slide(study, slide, letters) for slide in study.mechanism.slides)
    drive = study.mechanism.drive
    texts = {name: span(np.ravel(rate), study.language) for name, rate in course(drive, study.rates)._asdict().items()}
    texts |= {} if drive.pushed else {"taken": taken(study, study.language)}
    yield say("report.drive_way" if drive.pushed else "report.drive", link=drive.link, count=len(study.turn), **texts)
    if drive.ram is not None:
        yield say("report.cylinder", **cylinder_law(study, drive.ram))
    yield from (f"- {said[:1].upper()}{said[1:]}" for said in law_said(drive, study.language))


def structure(study: LinkageStudy) -> Iterator[str]:
    """Tell links and pairs, mobility by Chebyshev's formula, groups with their class, the formula of structure."""
    mechanism, say = study.mechanism, partial(word, study.language)
    yield chapter(study.language, "structure")
    yield from header([say(f"table.{head}") for head in ("pair", "pair_kind", "point")])
    yield from (_pair(pair, study) for pair in pairs(mechanism, study.groups))
    yield "\n" + say("report.counted_pairs", n=mechanism.moving_links, p=mechanism.lower_pairs) + "\n"
    numbers = rf"3 \cdot {mechanism.moving_links} - 2 \cdot {mechanism.lower_pairs}"
    yield from display(f"W = 3n - 2p_{{1}} - p_{{2}} = {numbers} - 0 = {mechanism.mobility}")
    for group, side in zip(study.groups, study.sweep.sides, strict=True):
        if isinstance(group, Triad):
            leads = "; ".join(f"{lead.link} {lead.kind}" for lead in group.leads)
            yield say("report.triad", group=group.label, basis=group.basis, leads=leads)
            continue
        sign = f"{side:+.0f}".replace("-", "−")
        yield say("report.group", group=group.label, joints=group.kind, order=group.order, side=sign)
    yield from [f"- {line}" for line in [_astray(study)] if line]
    whole = formula(mechanism, study.groups).replace("->", "→")
    yield say("report.formula", formula=whole, klass=mechanism_class(study.groups))


def _places(study: LinkageStudy, letters: Formula) -> Iterator[str]:
    """Tell the fixed points, and the points that links have by their places."""
    given = study.form.mechanism
    fixed = (_place(name, place, letters) for name, place in given.frame.items())
    yield word(study.language, "report.fixed_points", points=", ".join(fixed))
    for name, point in given.points.items():
        yield word(study.language, "report.own_point", link=point.on, place=_place(name, point.at, letters))


def _place(name: str, place: tuple[object, object], letters: Formula) -> str:
    return f"${letters.line(name)} {_spot([float(str(part)) for part in place], letters)}$"


def _spot(place: Iterable[float], letters: Formula) -> str:
    x, y = (letters.number(MM * part) for part in place)
    return rf"({x}; {y})\text{{ {letters.drafting.word('mm')}}}"


def _slide(study: LinkageStudy, slide: Slide, letters: Formula) -> str:
    """Say on what a link slides: on a line of two points, or on a line through a place at an angle."""
    if slide.label:
        line = message("report.line_of", owner=slide.owner, line=f"${letters.line(slide.label)}$")
    else:
        line = _line_at_angle(study, slide, letters)
    return word(study.language, "report.slide", link=slide.slider, line=line, point=f"${letters.line(slide.point)}$")


def _line_at_angle(study: LinkageStudy, slide: Slide, letters: Formula) -> Message:
    way, datum, language = slide.on_owner, study.mechanism.datum, study.language
    angle = number(math.degrees(cmath.phase(way.direction)), language)
    if slide.owner != FRAME:
        points = study.mechanism.links[slide.owner].points
        named = next((name for name, spot in points.items() if spot == way.through), None)
        place = letters.line(named) if named else _spot(_parts(way.through), letters)
        return message("report.line_of_link", owner=slide.owner, place=f"${place}$", angle=angle)
    through = way.through + complex(float(datum[0]), float(datum[1]))
    x, y = (number(MM * part, language) for part in _parts(through))
    return message("report.line_through", x=x, y=y, angle=angle)


def _parts(place: complex) -> tuple[float, float]:
    return place.real, place.imag


def _pair(pair: Pair, study: LinkageStudy) -> str:
    kind = "turning_pair" if isinstance(pair.joint, str) else "sliding_pair"
    return row([pair.key, word(study.language, f"report.{kind}"), pair.point])


NOTE, WARNING = 10.0, 60.0  # 1/sin of a notch: 6 degrees, 1 degree


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the structure and the motion of a linkage."""
    linkage, comparison = study.of(LinkageStudy), study.of(MotionComparison)
    passage = _passage(linkage, comparison)
    return Chapters(
        chain(data(linkage), structure(linkage), _extremes(linkage) if "extremes" in study.plans else (), passage),
        chain(
            equations(linkage, comparison.construction, drawn_scales(leaves), shown_positions(leaves)),
            see(leaves, linkage.language, "velocities", "accelerations"),
            _values(linkage, comparison),
        ),
        _conditions(linkage),
        _left_out(study, linkage, leaves),
    )


def headline(study: Study) -> str:
    """Say which link is the output, and who chose it; then its stroke and its greatest velocity and acceleration."""
    linkage = study.of(LinkageStudy)
    first = first_numbers(linkage, study.of(MotionComparison).construction)
    other = () if linkage.mechanism.output is not None else (word(linkage.language, "report.output_other"),)
    return "\n".join(filter(None, ("; ".join((shown(linkage), *other)), first, _astray(linkage))))


def _astray(study: LinkageStudy) -> str:
    """Say of points which the sketch shows far from their places how far it does."""
    points = ", ".join(f"{name} {number(MM * off, study.language)}" for name, off in study.astray.items())
    return word(study.language, "report.astray", points=points) if points else ""


def concluded(study: Study) -> Iterator[str]:
    """Say how the output goes, and how well it is driven."""
    linkage = study.of(LinkageStudy)
    language = linkage.language
    first = first_numbers(linkage, study.of(MotionComparison).construction)
    yield word(language, "report.output", output=shown(linkage)[1:]) + (f": {first}" if first else "")
    if linkage.groups and linkage.nodes.size:
        pressures = {group.label: interval(linkage.sweep, group, linkage.nodes) for group in linkage.groups}
        most = {label: max(abs(pressure.low), abs(pressure.high)) for label, pressure in pressures.items()}
        worst = max(most, key=lambda label: round(most[label], 9))
        yield word(language, "report.worst_pressure", angle=_degrees(most[worst], language), group=worst)


def remarks(study: Study) -> list[Message]:
    """Say why a motion is not whole: gaps, else barriers between positions; and positions not for grading."""
    linkage, gaps = study.of(LinkageStudy), study.of(MotionComparison).construction.gaps
    lines = gap_lines(gaps)
    if not gaps:
        lines += [message("verdict.between", reason=barrier.kind, where=barrier.where) for barrier in linkage.met]
    near = shallow(linkage)
    if near:
        lines.append(message("verdict.near", **positions(near)))
    return lines


def shown(study: LinkageStudy) -> str:
    """Say which link is the output, and who chose it."""
    out, named = study.output, study.mechanism.output is not None
    how = "named" if named else "framed"
    if not named and not any(pair.giver == FRAME for group in study.groups[-1:] for pair in group.outer_pairs):
        how = "last"
    point = "_along" if out.along else "_point" if out.point else ""
    parts = {"link": out.link, "point": out.point, "angle": number(out.course, study.language)}
    return word(study.language, f"report.output_{how}{point}", **parts)


def shallow(study: LinkageStudy) -> list[int]:
    """Give the assembled positions in which some group is too near a dead centre to be graded."""
    if not study.groups:
        return []
    worst = notches(study).max(axis=0)
    return [int(k) for k in np.flatnonzero(~study.lost & ~(worst < NOT_GRADED))]


def _extremes(study: LinkageStudy) -> Iterator[str]:
    yield chapter(study.language, "extremes")
    yield word(study.language, "report.output", output=shown(study)[1:])
    if study.extreme_positions is None:
        key = "report.no_extremes" if study.mechanism.drive.turns else "report.no_extremes_way"
        yield word(study.language, key, link=study.output.link)
    else:
        yield from _travel(study, study.extreme_positions)
    yield from _pressure(study)


def _travel(study: LinkageStudy, found: ExtremePositions) -> Iterator[str]:
    """Tell the extreme positions of an output, how far it goes, and its time ratio."""
    say, stated, extremes = partial(word, study.language), partial(phrase, study.language), found.extremes
    way = "report.by_notches" if found.notched else "report.by_velocity"
    yield say(way, angles=_angles(extremes.phi, study.language))
    stroke = Slot("H, m" if extremes.sliding else "ψ, rad", extremes.stroke, DIGITS)
    swing = {} if extremes.sliding else {"degrees": _stated("ψ", extremes.stroke, study.language)}
    yield stated("report.stroke" if extremes.sliding else "report.swing", stroke=stroke, **swing)
    if study.scene.has(("output", "working")):
        yield stroke_line(study.mechanism, study.output, extremes.reach, extremes.angles, study.language)
    if len(found.rests) > 2:
        yield say("report.reversals", count=len(found.rests), angles=_angles(found.rests, study.language))
    else:
        key = "report.ratio_faster" if extremes.faster else "report.ratio"
        overlap = _stated("θ", extremes.overlap, study.language)
        yield stated(key, overlap=overlap, ratio=Slot("K", extremes.ratio, DIGITS))


def _pressure(study: LinkageStudy) -> Iterator[str]:
    if study.groups and not study.nodes.size:
        yield word(study.language, "report.no_pressure")
    for group in study.groups if study.nodes.size else ():
        pressure = interval(study.sweep, group, study.nodes)
        ends = {"low": pressure.low, "high": pressure.high}
        low, high = (_stated(f"{end} {group.label}", angle, study.language) for end, angle in ends.items())
        yield phrase(study.language, "report.pressure", group=group.label, low=low, high=high)


def _degrees(angle: float, language: str) -> str:
    return fixed(float(np.degrees(angle)), language)


def _stated(quantity: str, angle: float, language: str) -> Phrase:
    return slotted("", quantity, _degrees(angle, language))


def _angles(angles: Iterable[float], language: str) -> str:
    return ", ".join(f"{_degrees(angle, language)}°" for angle in angles)


def _passage(study: LinkageStudy, comparison: MotionComparison) -> Iterator[str]:
    gaps, say = comparison.construction.gaps, partial(word, study.language)
    if not study.met and not gaps and not study.passed:
        return
    yield chapter(study.language, "passage")
    for barrier in study.passed:
        at = number(float(np.degrees((barrier.start + barrier.end) / 2)) % 360.0, study.language)
        yield say("report.carried", where=barrier.where, angle=at, through=study.mechanism.through)
    yield from (_barrier(barrier, study) for barrier in study.met)
    lost = {gap.position for gap in gaps if gap.plan == "positions"}
    yield say("report.assembled", found=len(study.turn) - len(lost), count=len(study.turn))
    yield from (gap_line("report.gap", gap, study.mechanism.drive, study.language) for gap in gaps)


def _barrier(barrier: Barrier, study: LinkageStudy) -> str:
    language = study.language
    if study.mechanism.drive.pushed:
        return word(language, "report.barrier_way", reason=barrier.kind, where=barrier.where)
    low, high = (_degrees(angle, language) for angle in (barrier.start, barrier.end))
    parts = {"reason": barrier.kind, "where": barrier.where, "low": low, "high": high}
    if not barrier.miss:
        return word(language, "report.barrier", **parts)
    return word(language, "report.barrier_miss", **parts, miss=number(barrier.miss, language, DIGITS))


def _values(study: LinkageStudy, comparison: MotionComparison) -> Iterator[str]:
    language, letters = study.language, Formula(drafting_of(study.scene))
    yield chapter(language, "values")
    for plan in PLANS:
        chosen = [finding for finding in comparison.of(plan) if np.any(finding.construction != 0)]
        if chosen:
            same = [(finding,) for finding in chosen] if plan == POSITIONS.plan else alike(chosen, study.mechanism)
            findings = [finding for finding, *_ in same]
            title = term(language, "plan", plan)
            yield word(language, "report.plan", plan=title[:1].upper() + title[1:])
            drive = study.mechanism.drive
            station = word(language, "table.way") if drive.pushed else "φ, °"
            phi = study.turn.phi
            stations = 1000 * drive.unit * phi if drive.pushed else np.round(np.degrees(phi), ROUNDED) % 360
            heads = [station, *(_heading(group, letters) for group in same)]
            yield from tabled(heads, [stations, *map(_settled, findings)], language)
            yield ""


def _heading(same: Sequence[Quantity], letters: Formula) -> str:
    """Name a quantity of a point or of a link by its letter, or by all that it has, with its unit."""
    names = (finding.name.split("_", 1) for finding in same)
    text = " = ".join(letters.letter(f"{symbol}_{{{index}}}") for symbol, index in names)
    return f"${text}$, {letters.drafting.word(same[0].unit)}"


def _settled(finding: Quantity) -> Complexes | Floats:
    """Give the values by construction; what is but rounding of the largest of its kind is 0."""
    values, least = finding.construction, 1e-10 * finding.largest
    x, y = (np.where(abs(part) < least, 0.0, part) for part in (np.real(values), np.imag(values)))
    return x + 1j * y if np.iscomplexobj(values) else x


def _conditions(study: LinkageStudy) -> Iterator[str]:
    language = study.language
    yield chapter(language, "conditions")
    if not study.groups:
        yield word(language, "report.no_meeting")
        return
    table = notches(study)
    yield word(language, "report.notches")
    yield from header([*(word(language, f"table.{head}") for head in ("group", "notch", "in_position")), ""])
    for group, kappas in zip(study.groups, np.where(study.lost, np.nan, table), strict=True):
        if not np.isnan(kappas).all():
            worst = int(np.nanargmax(kappas))
            # The sharpest notch of a group, the position of it, and what that means
            kappa = float(kappas[worst])
            grades = (("not_graded", NOT_GRADED), ("warning", WARNING), ("note", NOTE))
            grade = next((word(language, f"report.{name}") for name, least in grades if kappa >= least), "")
            sharp = fixed(math.degrees(math.asin(min(1 / kappa, 1.0))), language)
            least = f"{sharp}°" if math.isfinite(kappa) else word(language, "report.unbounded")
            yield row([group.label, least, str(worst), grade])


def _left_out(study: Study, linkage: LinkageStudy, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[str]:
    count, say = len(linkage.turn), partial(word, linkage.language)
    sheets = [leaf for sheet in leaves.values() for leaf in sheet if "shown" in leaf.metadata]
    figures = {group.name for leaf in sheets for group in leaf.groups}  # of a position without velocities none
    asked = [k for leaf in sheets for k in leaf.metadata["plans"] if f"{VELOCITIES.plan}-{k}" in figures]
    if asked:
        plans = ", ".join(map(str, asked))
        yield say("report.plans_drawn", plans=plans, count=count, shown=sheets[0].metadata["shown"])
    if sheets and (every := drawn_every(linkage)) > 1:
        yield say("report.ticks", count=count, second=every, third=2 * every)
    shown = study.made & study.plans
    missing = [term(linkage.language, "plan", plan) for plan in (EXTREMES, *PLANS) if plan not in shown]
    if missing:
        yield say("report.not_made", plans=", ".join(missing))
    turning = linkage.drafts().velocities.readings if "velocities" in linkage.made else linkage.mechanism.links
    still = [str(n) for n in sorted(linkage.mechanism.links) if n != FRAME and n not in turning]
    if still:
        yield say("report.still", links=", ".join(still), count=len(still))


REPORT = Report(chapters, headline, remarks, subject, concluded, equations_of)
