"""The chapter of a note on velocities and accelerations: vector equations, and their numbers (планы скоростей)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np

from drawings.lettering import words as lettering
from drawings.lettering.words import number
from drawings.page.page import Scale, drafting_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from drawings.report.formula import DIRECTION, FULL, Formula, display, inline, total
from drawings.report.report import chapter
from geometry.board import Mark
from plans.linkage.plan import POLES, Turning
from plans.linkage.primary import PRIMARIES
from plans.linkage.quantities import largest_of
from plans.linkage.study import LinkageStudy
from plans.linkage.vector_sums import VectorSum, VectorSums
from plans.model.dyad import Assur, Dyad
from plans.model.motion import ACCELERATIONS, NOTHING, PLANS, POSITIONS, VELOCITIES, Motion
from plans.model.triad import Triad
from plans.study import Study
from plans.words.words import word

V, A = VELOCITIES.plan, ACCELERATIONS.plan
UNIT = {order.plan: order.point.unit for order in (VELOCITIES, ACCELERATIONS)}
SYMBOL = {order.plan: order.point.symbol for order in (VELOCITIES, ACCELERATIONS)}


class Plans(NamedTuple):
    """What equations of one position are written by: sums, scales of plans, the `fastest` rate of a link."""

    sums: VectorSums
    scales: Mapping[str, float]
    largest: Mapping[str, float]
    fastest: float


class VectorEquations:
    """Writes the equations of groups: in letters, and with the numbers of a position."""

    def __init__(self, plans: Plans, formula: Formula) -> None:
        self.plans, self.sums, self.formula = plans, plans.sums, formula
        self.language = formula.drafting.language

    def lettered(self, legs: tuple[VectorSum, ...], plans: Iterable[str] = (V, A)) -> Iterator[str]:
        """Write velocities and accelerations as sums, with what is known of each term."""
        guided = any(leg.guided for leg in legs)
        for plan in plans:
            for leg in (leg for leg in legs if not leg.guided):
                terms = self._terms(leg, plan, DIRECTION if guided else 0)
                still = rf",\quad {self._of(plan, leg.base)} = 0" if leg.fixed else ""
                yield f"{terms[0]} = {total(terms[1:])}{still}"

    def directions(self, legs: tuple[VectorSum, ...]) -> str:
        """Say along what the terms of known direction go."""
        return word(self.language, "report.directions", directions="; ".join(self._direction(leg) for leg in legs))

    def crank(self, leg: VectorSum) -> Iterator[str]:
        """Give the velocity and the acceleration of the crank's end."""
        formula, link, omega = self.formula, leg.link, self._spin(leg)
        arm, spin = self._arm(leg), formula.letter(f"ω_{link}")
        v, length = self._of(V, leg.point), formula.number(leg.length)
        yield inline(v, rf"{spin} {arm}", rf"{formula.number(omega)} \cdot {length}", self._size(V, leg.velocity[1]))
        yield from self._drawn(V, leg.velocity[1], v, "p", leg.images[2])
        yield from self._normal(leg)
        epsilon = abs(self.sums.epsilon(link))
        if self._visible(A, leg.acceleration[2]):
            product = rf"{formula.number(epsilon)} \cdot {length}"
            turning = rf"{formula.letter(f'ε_{link}')} {arm}"
            yield inline(self._part("t", leg), turning, product, self._size(A, leg.acceleration[2]))
        yield from self._whole(A, sum(leg.acceleration), leg.point, leg.images[2])

    def of_point(self, point: str) -> Iterator[str]:
        """Give the velocity and the acceleration of a point, as the plans have them."""
        image, (v, a) = self.sums.letters.small(point), self.sums.rates(point)
        yield from self._whole(V, v, point, image)
        yield from self._whole(A, a, point, image)

    def numbers(self, group: Assur) -> Iterator[str]:
        """Give what the plans tell of a group: relative parts, angular rates, its points, and points by similarity."""
        for legs in self.sums.of(group):
            yield from self._special(legs[0]) if legs[0].more[0] else self._of_legs(legs)
        if isinstance(group, Triad):
            yield from chain(*map(self._of_lead, self.sums.pair(group)))
        for point in dict.fromkeys(self.sums.others(group)):
            if point in self.sums.motion.points:
                yield from self.of_point(point)

    def _special(self, leg: VectorSum) -> Iterator[str]:
        """Give the velocity and the acceleration of a special point, as the plans have them."""
        yield from self._whole(V, sum(leg.velocity), leg.point, leg.images[2])
        yield from self._whole(A, sum(leg.acceleration) + leg.more[1], leg.point, leg.images[2])

    def _of_lead(self, leg: VectorSum) -> Iterator[str]:
        yield from self._turning(leg) if leg.turns else self._sliding(leg)

    def _of_legs(self, legs: tuple[VectorSum, ...]) -> Iterator[str]:
        for leg in sorted(legs, key=lambda leg: not leg.turns):  # a Coriolis part needs the rate of its link
            yield from self._of_lead(leg)
        first = legs[0]
        if not any(leg.turns and leg.fixed for leg in legs):
            yield from self._whole(V, sum(first.velocity), first.point, first.images[2])
        yield from self._whole(A, sum(first.acceleration), first.point, first.images[2])

    def _terms(self, leg: VectorSum, plan: str, known: int) -> list[str]:
        vector = self.formula.vector
        terms = [vector(self._letter(plan, leg.point), known), vector(self._letter(plan, leg.base), FULL)]
        if plan == V:
            return [*terms, vector(f"v_{{{leg.relative}}}", DIRECTION)]
        own, rest = ("n", "t") if leg.turns else ("k", "r")
        terms.append(vector(f"a^{own}_{{{leg.own or leg.relative}}}", FULL))
        if leg.more[0]:
            terms.append(vector(f"a^n_{{{leg.more[0]}}}", FULL))
        return [*terms, vector(f"a^{rest}_{{{leg.relative}}}", DIRECTION)]

    def _direction(self, leg: VectorSum) -> str:
        letter = self.formula.vector
        if leg.turns:
            square = rf"{letter(f'v_{{{leg.relative}}}')} \perp {self.formula.line(leg.arm)}"
            normal = rf"{letter(f'a^n_{{{leg.own or leg.relative}}}')} \parallel {self.formula.line(leg.arm)}"
            return rf"${square}$, ${normal}${self._more(leg)}"
        moving = f"v_{{{leg.point}}}" if leg.guided else f"v_{{{leg.relative}}}"
        if leg.guided:
            return word(self.language, "report.along", vector=f"${letter(moving)}$")
        if not leg.slot:  # a line that its link has by an angle
            return word(self.language, "report.along_link", vector=f"${letter(moving)}$", link=leg.link)
        return rf"${letter(moving)} \parallel {self.formula.line(leg.slot)}${self._more(leg)}"

    def _more(self, leg: VectorSum) -> str:
        """Say along what the normal part towards a special point goes."""
        if not leg.more[0]:
            return ""
        return rf", ${self.formula.vector(f'a^n_{{{leg.more[0]}}}')} \parallel {self.formula.line(leg.more[0])}$"

    def _turning(self, leg: VectorSum) -> Iterator[str]:
        formula, link = self.formula, leg.link
        v = formula.letter(f"v_{{{leg.relative}}}")
        same = f"{self._of(V, leg.point)} = {v}" if leg.fixed else v
        yield from self._read(V, leg.velocity[1], same, leg.images[0] or "p", leg.images[2])
        yield self._rate("ω", leg, self.sums.omega(link), leg.velocity[1], v)
        yield from self._normal(leg)
        t = self._part("t", leg)
        yield from self._read(A, leg.acceleration[2], t, leg.images[1], leg.images[2])
        yield self._rate("ε", leg, self.sums.epsilon(link), leg.acceleration[2], t)

    def _sliding(self, leg: VectorSum) -> Iterator[str]:
        formula = self.formula
        if leg.guided:
            return
        if "_{" in leg.base:  # a point of the guide, which only similarity gives
            yield from self._whole(V, leg.velocity[0], leg.base, leg.images[0])
            yield from self._whole(A, leg.acceleration[0], leg.base, leg.images[0])
        v = formula.letter(f"v_{{{leg.relative}}}")
        yield from self._read(V, leg.velocity[1], v, leg.images[0], leg.images[2])
        omega, slip = self._spin(leg), self._abs(V, leg.velocity[1])
        k = leg.acceleration[1] if omega * slip else 0j
        product = rf"2 \cdot {formula.number(omega)} \cdot {formula.number(slip)}"
        letters = rf"2 {formula.letter(f'ω_{leg.link}')} {v}"
        yield inline(self._part("k", leg), letters, product, formula.quantity(abs(k), UNIT[A]))
        yield from self._drawn(A, k, self._part("k", leg), leg.images[0], leg.images[1])
        yield from self._read(A, leg.acceleration[2], self._part("r", leg), leg.images[1], leg.images[2])

    def _normal(self, leg: VectorSum) -> Iterator[str]:
        formula, part = self.formula, self._part("n", leg)
        omega = self._spin(leg)
        n = leg.acceleration[1] if omega else 0j
        square = rf"{formula.letter(f'ω_{leg.link}')}^{{2}} {self._arm(leg)}"
        product = rf"{formula.number(omega)}^{{2}} \cdot {formula.number(leg.length)}"
        yield inline(part, square, product, formula.quantity(abs(n), UNIT[A]))
        yield from self._drawn(A, n, part, leg.images[0] or POLES[A], leg.images[1])

    def _rate(self, symbol: str, leg: VectorSum, rate: float, part: complex, letter: str) -> str:
        """Write ω or ε of a link from a part over the arm, with its sense."""
        formula, plan = self.formula, V if symbol == "ω" else A
        size = self._abs(plan, part)
        unit = {V: VELOCITIES.link.unit, A: ACCELERATIONS.link.unit}[plan]
        ratio = f"{formula.number(size)} / {formula.number(leg.length)}"
        amount = formula.quantity(abs(rate) if size else 0.0, unit)
        sense = "at rest" if not size else "counter-clockwise" if rate > 0 else "clockwise"
        line = inline(formula.letter(f"{symbol}_{leg.link}"), f"{letter} / {self._arm(leg)}", ratio, amount)
        return f"{line}, {word(self.language, f'way.{sense}')}" if size else line

    def _whole(self, plan: str, value: complex, point: str, image: str) -> Iterator[str]:
        yield from self._read(plan, value, self._of(plan, point), POLES[plan], image)

    def _read(self, plan: str, value: complex, letter: str, start: str, end: str) -> Iterator[str]:
        """Write a vector that is measured on a plan: its length there by the scale."""
        formula, mu = self.formula, self.plans.scales.get(plan)
        if mu is None or not self._visible(plan, value):
            yield inline(letter, self._size(plan, value))
            return
        scale = formula.letter(f"μ_{SYMBOL[plan]}")
        length = formula.number(abs(value) / mu)
        product = rf"{length} \cdot {formula.number(mu)}"
        yield inline(letter, rf"{formula.segment(start, end)} \cdot {scale}", product, self._size(plan, value))

    def _drawn(self, plan: str, value: complex, letter: str, start: str, end: str) -> Iterator[str]:
        """Write the length at which a known vector is laid off."""
        formula, mu = self.formula, self.plans.scales.get(plan)
        if mu is not None and value:
            scale = formula.letter(f"μ_{SYMBOL[plan]}")
            ratio = f"{formula.number(abs(value))} / {formula.number(mu)}"
            amount = formula.quantity(abs(value) / mu, "mm")
            yield inline(formula.segment(start, end), f"{letter} / {scale}", ratio, amount)

    def _spin(self, leg: VectorSum) -> float:
        """Give the size of a link's angular velocity, rad/s; one that is but rounding is none."""
        omega = abs(self.sums.omega(leg.link))
        visible = self._visible(V, leg.velocity[1]) if leg.turns else omega > NOTHING * self.plans.fastest
        return omega if visible else 0.0

    def _part(self, name: str, leg: VectorSum) -> str:
        return self.formula.letter(f"a^{name}_{{{leg.relative}}}")

    def _arm(self, leg: VectorSum) -> str:
        return self.formula.letter(f"l_{{{leg.arm}}}")

    def _letter(self, plan: str, point: str) -> str:
        return f"{SYMBOL[plan]}_{{{point}}}"

    def _of(self, plan: str, point: str) -> str:
        return self.formula.letter(self._letter(plan, point))

    def _visible(self, plan: str, value: complex) -> bool:
        return self._abs(plan, value) > 0

    def _abs(self, plan: str, value: complex) -> float:
        """Give the size of a vector; one that is but rounding of the plan's largest is none."""
        return abs(value) if abs(value) > NOTHING * self.plans.largest[plan] else 0.0

    def _size(self, plan: str, value: complex) -> str:
        return self.formula.quantity(self._abs(plan, value), UNIT[plan])


MOST = 6  # positions whose numbers are put in: a note of more is read by nobody, and the tables have them all
Scales = Mapping[int, Mapping[str, Scale]]  # of the plans of a position, by their names


def drawn_scales(leaves: Mapping[str, Sequence[Leaf]]) -> dict[int, dict[str, Scale]]:
    """Give the scales of the plans of positions, velocities and accelerations that sheets show, by position."""
    found: dict[int, dict[str, Scale]] = {}
    for leaf in (leaf for sheets in leaves.values() for leaf in sheets):
        for mark in groups(leaf.groups):
            data = mark.data
            if data.get("plan") in (POSITIONS.plan, V, A) and "position" in data and "scale" in data:
                letter = "l" if data["plan"] == POSITIONS.plan else data["quantity"]
                scale = Scale(float(data["scale"]), letter, data["unit"])
                found.setdefault(int(data["position"]), {})[data["plan"]] = scale
    return found


def shown_positions(leaves: Mapping[str, Sequence[Leaf]]) -> list[int]:
    """Give the positions whose plans of velocities, or whose forces, are drawn, as many as a note puts numbers in."""
    scales = drawn_scales(leaves)
    facts = (leaf.metadata for sheets in leaves.values() for leaf in sheets)
    asked = [k for k, sheets in scales.items() if V in sheets] + [f["position"] for f in facts if "position" in f]
    return sorted(dict.fromkeys(asked))[:MOST]


def equations(study: LinkageStudy, motion: Motion, scales: Scales, positions: Iterable[int]) -> Iterator[str]:
    """Write the vector equations of each group, and the numbers of each position by a motion."""
    have = [k for k in positions if not np.isnan(motion.points[study.mechanism.drive.end].v[k])]
    if motion.order < ACCELERATIONS.number or not have:
        return
    language, formula = study.language, Formula(drafting_of(study.scene))
    yield chapter(language, "equations")
    yield word(language, "report.underlines")
    first = _written(study, motion, have[0], {}, formula)
    for group in study.groups:
        yield from _lettered(first, group)
    for k in have:
        yield in_position(study, k)
        drawn = scales.get(k, {})
        yield from _scales(study, drawn)
        yield from _numbers(study, _written(study, motion, k, drawn, formula))


def equations_of(study: Study, mark: Mark, position: int) -> Iterator[str]:
    """Write the vector equations of the group whose plan gives a mark, or the vector that ends in it."""
    linkage = study.of(LinkageStudy)
    if mark.subject not in (V, A):
        return
    named = mark.step.inputs[-1].name if mark.step.op == "join" else mark.name
    written = _written(linkage, linkage.motion(ACCELERATIONS.number), position, {}, Formula(drafting_of(study.scene)))
    for group in linkage.groups:
        for legs in written.sums.of(group):
            if any(named in leg.images[1:] for leg in legs):
                yield from written.lettered(legs, (mark.subject,))


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
    plans = Plans(sums, {name: scale.mu for name, scale in scales.items()}, largest(motion), fastest)
    return VectorEquations(plans, formula)


def largest(motion: Motion) -> dict[str, float]:
    """Give the largest velocity and acceleration of named points over all positions."""
    return {
        order.plan: largest_of([np.abs(rows[order.number]) for rows in motion.points.values()])
        for order in (VELOCITIES, ACCELERATIONS)
    }


def _lettered(written: VectorEquations, group: Assur) -> Iterator[str]:
    language, kind = written.language, "of_group" if isinstance(group, Dyad) else "of_triad"
    yield word(language, f"report.{kind}", group=group.label, joints=group.kind)
    for legs in written.sums.of(group):
        for line in written.lettered(legs):
            yield from display(line)
        yield written.directions(legs)


def _scales(study: LinkageStudy, scales: Mapping[str, Scale]) -> Iterator[str]:
    formula = Formula(drafting_of(study.scene))
    lines = [_scale(scales[plan], formula) for plan in PLANS if plan in scales]
    if lines:
        yield word(study.language, "report.scales", scales=", ".join(lines)) + "\n"


def _scale(scale: Scale, formula: Formula) -> str:
    unit, mm = (formula.drafting.word(name) for name in (scale.unit, "mm"))
    true = f"({unit})" if "/" in unit else unit
    return f"${formula.letter(f'μ_{scale.letter}')} = {formula.number(scale.mu)}{formula.unit(f'{true}/{mm}')}$"


def _numbers(study: LinkageStudy, written: VectorEquations) -> Iterator[str]:
    drive = study.mechanism.drive
    yield word(written.language, "report.primary", link=drive.link)
    vectors = (one for one in PRIMARIES[drive.kind].vectors(study.mechanism) if isinstance(one, Turning))
    turned = chain(*(written.crank(written.sums.turning(vector)) for vector in vectors))
    lines = written.of_point(drive.end) if drive.pushed else turned
    yield from map("- {}".format, lines)
    for group in study.groups:
        yield word(written.language, "report.numbers_of_group", group=group.label)
        yield from map("- {}".format, written.numbers(group))
