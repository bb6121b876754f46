"""What a kinematics sheet says in words: structure, drive, stroke, time ratio, pressure angles, gaps (пояснения)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from drawings.lettering.phrase import Slot, joined, phrase, slotted
from drawings.lettering.words import fixed, number, runs, span, word
from drawings.report.report import share
from plans.by_hand import SLIP
from plans.linkage.pressure import interval
from plans.linkage.quantities import MotionComparison
from plans.linkage.ram import law
from plans.linkage.study import LinkageStudy
from plans.model.dyad import formula, mechanism_class
from plans.model.mechanism import Ram
from plans.model.motion import Floats, Rates
from plans.quantity import Quantity
from plans.words.words import said as worded

ALIKE = 1 - 1e-6  # conditions of positions that mirror each other differ by their rounding alone
MOST_LENGTHS = 16  # of a mechanism with more the report and the scene tell them


def notes(study: LinkageStudy, comparison: MotionComparison, language: str, by_hand: bool = True) -> list[str]:
    """Write what the sheet says in words: structure, drive, stroke, time ratio, pressure angles, gaps, agreement.

    What a hand makes of it is said where a table has its column.
    """
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
        said.append(_travel(study, language))
    for group in study.groups:
        found = interval(study.sweep, group, study.nodes)
        low, high = (fixed(float(np.degrees(angle)), language) for angle in (found.low, found.high))
        if low != high:
            ends = {end: slotted("", f"{end} {group.label}", told) for end, told in (("low", low), ("high", high))}
            said.append(phrase(language, "pressure", group=group.label, **ends))
    said += [*_gaps(comparison, language), *_why(study, comparison)]
    both = accord(comparison.findings, comparison.kappa, language)
    return [*said, *both, *([word(language, "hand note", slip=number(SLIP, language))] if both and by_hand else [])]


def accord(findings: Sequence[Quantity], kappa: Floats, language: str) -> list[str]:
    """Say once how far plan and analysis are apart, and where the mechanism is worst conditioned; nothing of gaps."""
    known = np.flatnonzero(np.isfinite(kappa))
    if not len(known):
        return []
    worst = next(int(k) for k in known if kappa[k] >= ALIKE * np.max(kappa[known]))
    told = number(float(kappa[worst]), language, 2)
    return [word(language, "accord", share=share(findings), position=worst, kappa=told)]


def driving(study: LinkageStudy, rates: Rates, language: str) -> str:
    """Tell how the primary link moves: a crank turns, a slider is pushed over its stroke."""
    drive = study.mechanism.drive
    omega, epsilon = (span(np.ravel(rate) * drive.unit, language) for rate in rates)
    if drive.ram is not None:
        return _cylinder(drive.ram, drive.link, (omega, epsilon), law(study.mechanism, study.turn.phi), language)
    if not drive.pushed:
        key = "crank" if np.any(rates.epsilon) else "even crank"
        return word(language, key, link=drive.link, omega=omega, **({"epsilon": epsilon} if key == "crank" else {}))
    ends = (number(1000 * drive.unit * float(phi), language) for phi in study.turn.phi[[0, -1]])
    return word(language, "pushed", point=drive.end, v=omega, a=epsilon, stroke=" … ".join(ends))


def _cylinder(ram: Ram, link: int, rates: tuple[str, str], growth: tuple[Floats, Floats], language: str) -> str:
    """Tell how a cylinder turns the crank: the law m/s, m/s2 of its length, and the crank's rates as written."""
    stroke = " … ".join(number(1000 * way, language) for way in (ram.begin, ram.end))
    v, a = (span(np.ravel(rate), language) for rate in growth)
    parts = {"link": link, "omega": rates[0], "epsilon": rates[1], "line": f"{ram.foot}{ram.point}"}
    return word(language, "cylinder", stroke=stroke, v=v, a=a, **parts)


def lengths(study: LinkageStudy, language: str) -> list[str]:
    """Tell the lengths of the scene, where they are not too many."""
    given = study.form.mechanism.lengths
    if not 0 < len(given) <= MOST_LENGTHS:
        return []
    told = (f"l_{{{name}}} = {number(1000 * float(length), language)}" for name, length in given.items())
    return [word(language, "lengths", lengths=",  ".join(told))]


def _gaps(comparison: MotionComparison, language: str) -> list[str]:
    """Name the gaps, those of one reason together, runs of positions as first-last."""
    reasons: dict[tuple[str, object], list[int]] = {}
    for gap in comparison.construction.gaps:
        reasons.setdefault((gap.reason, gap.where), []).append(gap.position)
    return [
        word(language, "gap", positions=runs(positions), reason=word(language, reason), where=where)
        for (reason, where), positions in reasons.items()
    ]


def _why(study: LinkageStudy, comparison: MotionComparison) -> list[str]:
    """Say on a sheet without any position what would mend the mechanism."""
    return [worded(comparison.construction.gaps[0].advice, study.scene.sheet.language)] if study.lost.all() else []


def _travel(study: LinkageStudy, language: str) -> str:
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
