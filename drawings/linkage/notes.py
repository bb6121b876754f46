"""A linkage in words: the notes of its sheets, the first lines of its report (пояснения)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

import numpy as np
import numpy.typing as npt

from drawings.lettering.words import Slot, fixed, joined, number, phrase, runs, slotted, span, with_index, word
from drawings.report.report import TableSubject
from plans.linkage.quantities import MotionComparison
from plans.linkage.reading.fields import LineTable, Place
from plans.linkage.reading.form import MechanismTable
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import interval
from plans.linkage.travel import EQUAL
from plans.model.diagrams import STILL
from plans.model.dyad import Assur, formula, mechanism_class
from plans.model.mechanism import FRAME, Drive, Mechanism, Output, Ram, output_way, ways
from plans.model.motion import ACCELERATIONS, NOTHING, VELOCITIES, Motion, Order, Rates, law_ends
from plans.model.triad import Triad
from plans.study import Study
from plans.words import words
from plans.words.words import Message, message
from plans.words.words import said as worded
from plans.words.words import word as plain_word

NBSP = "\N{NO-BREAK SPACE}"
MOST_LENGTHS = 16  # of a mechanism with more the report and the scene tell them


def notes(study: LinkageStudy, comparison: MotionComparison, language: str) -> list[str]:
    """Write what the sheet says in words: structure, drive, stroke, time ratio, pressure angles, gaps."""
    mechanism = study.mechanism
    said = [
        word(
            language, "structure", n=mechanism.moving_links, p=mechanism.lower_pairs, w=mechanism.mobility,
            formula=formula(mechanism, study.groups).replace("->", "→"), klass=mechanism_class(study.groups),
        ),
        driving(study, study.rates, language),
    ]  # fmt: skip
    said += lengths(study, language)
    if study.travel is not None:
        said.append(_extremes_said(study, language))
    for group in study.groups:
        found = interval(study.sweep, group, study.nodes)
        low, high = (fixed(float(np.degrees(angle)), language) for angle in (found.low, found.high))
        if low != high:
            ends = {end: slotted("", f"{end} {group.label}", angle) for end, angle in (("low", low), ("high", high))}
            said.append(phrase(language, "pressure", group=group.label, **ends))
    said += _gaps(comparison, language)
    # Without any position, what would mend the mechanism
    return [*said, worded(comparison.construction.gaps[0].advice, language)] if study.lost.all() else said


def driving(study: LinkageStudy, rates: Rates, language: str) -> str:
    """Tell how the primary link moves: a crank turns, a slider is pushed over its stroke."""
    drive = study.mechanism.drive
    omega, epsilon = (span(np.ravel(rate), language) for rate in course(drive, rates))
    law = "".join(f";  {said}" for said in law_said(drive, language))
    if drive.ram is not None:
        parts = {"link": drive.link, "omega": omega, "epsilon": epsilon}
        return word(language, "cylinder", **parts, **cylinder_law(study, drive.ram)) + law
    if not drive.pushed:
        key = "crank" if np.any(rates.epsilon) else "even crank"
        said = word(language, key, link=drive.link, omega=omega, **({"epsilon": epsilon} if key == "crank" else {}))
        return f"{said}{taken(study, language)}"
    ends = (number(1000 * drive.unit * float(phi), language) for phi in study.turn.phi[[0, -1]])
    return word(language, "pushed", point=drive.end, v=omega, a=epsilon, stroke=" … ".join(ends)) + law


def course(drive: Drive, rates: Rates) -> Rates:
    """Give the rates between which a drive has all its others: of a slide over its whole stroke those of its law."""
    if drive.law and drive.pushed and np.ndim(rates.omega):
        return law_ends(drive.law)
    return Rates(*(drive.unit * np.ravel(rate) for rate in rates))


def law_said(drive: Drive, language: str) -> Iterator[str]:
    """Say the law of a stroke by its points: the speed at each place (закон движения)."""
    if drive.law:
        points = "; ".join(f"{number(1000 * s, language)}{NBSP}→{NBSP}{number(v, language)}" for s, v in drive.law)
        resting = any(not v for _, v in drive.law)
        yield word(language, "law from rest" if resting else "law of stroke", points=points)


def taken(study: LinkageStudy, language: str) -> str:
    """Say of the machine's own speeds whether its motor or a constant moment makes them, by which they differ."""
    if study.pace is None or study.mechanism.drive.ram is not None or study.mechanism.drive.pushed:
        return ""
    return f" ({word(language, 'with motor' if study.scene.has(('dynamics', 'motor')) else 'under constant moment')})"


def cylinder_law(study: LinkageStudy, ram: Ram) -> dict[str, str]:
    """Write the points of the cylinder that turns the crank, its lengths in mm, and how fast they grow."""
    stroke = " … ".join(number(1000 * way, study.language) for way in (ram.begin, ram.end))
    law = study.mechanism.drive.law
    rates = law_ends(law) if law else Rates(ram.speed, ram.acceleration)
    v, a = (span(np.ravel(rate), study.language) for rate in rates)
    return {"line": f"{ram.foot}{ram.point}", "stroke": stroke, "v": v, "a": a}


def lengths(study: LinkageStudy, language: str) -> list[str]:
    """Tell the lengths of the scene, and where its frame holds the links, where they are not too many."""
    given = study.form.mechanism.lengths
    texts = [f"l_{{{name}}} = {number(1000 * float(length), language)}" for name, length in given.items()]
    told = (("lengths", texts), ("fixed places", [*_places(study.form.mechanism, language)]))
    return [word(language, key, given=",  ".join(texts)) for key, texts in told if 0 < len(texts) <= MOST_LENGTHS]


def assembly(sketch: Mapping[str, complex], language: str) -> Iterator[str]:
    """Say how a mechanism is assembled: on which sides the points of its sketch lie, measured from the datum."""
    if sketch:
        sides = ", ".join(f"{with_index(name)} {_side(apart, language)}" for name, apart in sketch.items())
        yield word(language, "form assembly", sides=sides)


def _side(apart: complex, language: str) -> str:
    ways = (apart.imag, "above", "below"), (apart.real, "right", "left")
    return " ".join(word(language, f"form {ahead if part > 0 else back}") for part, ahead, back in ways if part)


def _places(form: MechanismTable, language: str) -> Iterator[str]:
    """Tell the fixed points, if there are several, and the guides that lie elsewhere than along x from the origin."""
    for name, at in form.frame.items() if len(form.frame) > 1 else ():
        yield f"{with_index(name)} {_place(at, language)}"
    for slide in form.slides:
        if isinstance(slide.along, LineTable) and slide.along.link == FRAME:
            through, angle = slide.along.place(form.frame), slide.along.angle
            if through and any((*through, angle)):
                parts = {"place": _place(through, language), "angle": number(float(angle), language)}
                yield word(language, "guide of frame", link=slide.link, **parts)


def _place(at: Place, language: str) -> str:
    sizes = (number(1000 * float(size), language) for size in at)
    return f"({'; '.join(sizes)})"


def _gaps(comparison: MotionComparison, language: str) -> list[str]:
    """Name the gaps, those of one reason together, runs of positions as first-last."""
    reasons: dict[tuple[str, object], list[int]] = {}
    for gap in comparison.construction.gaps:
        reasons.setdefault((gap.reason, gap.where), []).append(gap.position)
    return [
        word(language, "gap", positions=runs(positions), reason=word(language, reason), where=where)
        for (reason, where), positions in reasons.items()
    ]


def _extremes_said(study: LinkageStudy, language: str) -> str:
    found = study.travel
    assert found is not None  # asked only where there are extremes
    extremes = found.extremes
    key, theta = "overlap faster" if extremes.faster else "overlap", float(np.degrees(extremes.overlap))
    ratio = slotted("", "K", fixed(extremes.ratio, language, 3))
    overlap: str = phrase(language, key, overlap=slotted("", "θ", fixed(theta, language)), ratio=ratio)
    if len(found.rests) > 2:  # a stroke between two reversals of several has no time ratio
        overlap = word(language, "reversals", count=len(found.rests))
    if extremes.sliding:
        return joined(";  ", (phrase(language, "stroke", stroke=Slot("H", 1000 * extremes.stroke)), overlap))
    swing = slotted("", "ψ", fixed(float(np.degrees(extremes.stroke)), language))
    return joined(";  ", (phrase(language, "swing", link=study.output.link, stroke=swing), overlap))


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
    largest = float(np.nanmax(sizes))
    return largest, int(np.argmax(sizes >= largest * (1 - NOTHING)))


def _travel(study: LinkageStudy) -> Iterator[str]:
    found = study.travel
    if found is None:
        return
    extremes, language = found.extremes, study.language
    if extremes.sliding:
        yield f"H = {number(extremes.stroke, language, DIGITS)} {word(language, 'm')}"
    else:
        letter = f"ψ_{study.output.link}" if study.coupler_point else "ψ"
        yield f"{letter} = {fixed(float(np.degrees(extremes.stroke)), language, ANGLE)}°"
    if len(found.rests) == 2:
        yield f"K = {fixed(extremes.ratio, language, RATIO)}"


def _greatest(study: LinkageStudy, motion: Motion) -> Iterator[str]:
    for order in (VELOCITIES, ACCELERATIONS):
        if order.number <= motion.order:
            yield from _of(study, motion, order)


def _of(study: LinkageStudy, motion: Motion, order: Order) -> Iterator[str]:
    """Tell the greatest of one order: of the output's point, or of its link where it has none."""
    out, language = study.output, study.language
    lettered = order.point if out.point else order.link
    values = motion.points[out.point] if out.point else motion.links[out.link]
    found = greatest(values[order.number])
    if found is not None:
        moves = found[0] > STILL * abs(study.mechanism.drive.omega) ** order.number  # less is rounding
        size, unit = number(found[0] if moves else 0.0, language, DIGITS), word(language, lettered.unit)
        parts = {"letter": f"{lettered.symbol}_{out.point or out.link}", "size": size, "unit": unit}
        yield words.word(language, "report.greatest", **parts, position=found[1] if moves else 0)


PAIRS = {"R": "turning", "P": "sliding"}


def subject(study: Study) -> TableSubject:
    """Tell the structure of a linkage and how far its output goes."""
    linkage = study.of(LinkageStudy)
    return TableSubject(_formula(linkage), _stroke(linkage), _sentence(linkage))


def _formula(study: LinkageStudy) -> str:
    return re.sub(r"II(\d)", r"II<sub>\1</sub>", formula(study.mechanism, study.groups).replace("->", "→"))


def _sentence(study: LinkageStudy) -> str:
    """Say the formula of structure in words: the crank, then each group with its kind and the order of its pairs."""
    groups = "; ".join(_group(group) for group in study.groups)
    return (
        f"Structure: {_formula(study)}, class {mechanism_class(study.groups)}: crank {study.mechanism.drive.link}; "
        f"{groups}. Output: {_stroke(study)}."
    )


def _group(group: Assur) -> str:
    if isinstance(group, Triad):
        return f"links {', '.join(map(str, sorted(group.links)))}, three leads on link {group.basis}"
    pairs = ", ".join(PAIRS[letter] for letter in group.kind)
    return f"links {' and '.join(map(str, group.links))}, {group.kind} ({pairs})"


def _stroke(study: LinkageStudy) -> str:
    """Say how far the output goes and with what time ratio, or that it has no extreme positions."""
    output, found = study.output, study.travel
    if output.point and output_way(study.mechanism, output) is None:
        return f"point {output.point} of link {output.link}"
    if found is None:
        return f"link {output.link}, within the angles given"
    extremes = found.extremes
    far = f"stroke {number(1000 * extremes.stroke)} mm"
    if not extremes.sliding:
        far = f"swing {number(float(np.degrees(extremes.stroke)))}°"
    ratio = f"K = {number(extremes.ratio)}" if len(found.rests) == 2 else f"reverses {len(found.rests)} times"
    return f"link {output.link}, {far}, {ratio}"


def stroke_line(
    mechanism: Mechanism, output: Output, reach: tuple[float, float], angles: tuple[float, float], language: str,
    point: str = "",
) -> str:  # fmt: skip
    """Say which way the working stroke goes, of a point where it is not the output's, and how far the crank turns."""
    work, idle = (fixed(float(np.degrees(angle)), language) for angle in angles)
    way = tuple(message(f"way.{name}") for name in ways(mechanism, output, *reach))
    key, of = ("report.working_point", {"point": point}) if point else ("report.working", {})
    return plain_word(language, key, time=_time(*angles), ways=way, work=work, idle=idle, **of)


def _time(work: float, idle: float) -> Message:
    """Say whether the working stroke takes longer than the idle one."""
    if abs(work - idle) < EQUAL:
        return message("way.equal")
    return message("way.slower" if work > idle else "way.faster")
