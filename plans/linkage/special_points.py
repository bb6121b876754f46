"""Special points by the analysis: where the lines of two leads meet, how they move, the vectors there (M3.10)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from geometry.three_leads import GUIDE, ROD, SLOT
from plans.linkage.leads import key
from plans.linkage.plan import POLES, PlanLetters, SpecialPoint, special_name
from plans.model.dyad import Assur
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import ACCELERATIONS, VELOCITIES, Complexes, Motion, Order
from plans.model.triad import Triad, TriadLead


class SpecialRow(NamedTuple):
    """A vector of a plan at a special point: the letters of its ends and its own, its values over the positions."""

    order: Order
    start: str
    end: str
    letter: str
    values: Complexes


class AnalysedSpecial(NamedTuple):
    """The special point of a triad in all positions of a motion."""

    mechanism: Mechanism
    motion: Motion
    letters: PlanLetters
    triad: Triad

    @property
    def name(self) -> str:
        """Its letter."""
        return self.letters.specials[self.triad.basis].name

    @property
    def pair(self) -> list[TriadLead]:
        """The leads whose lines meet in it."""
        return [lead for lead in self.triad.leads if lead is not self.out]

    @property
    def out(self) -> TriadLead:
        """The lead that it leaves out."""
        return self.triad.leads[self.letters.specials[self.triad.basis].out]

    def moved(self, order: int) -> Complexes:
        """Give its place, velocity or acceleration, as of a point of the basis link."""
        return self.of_link(self.triad.basis, self.place, order)

    @property
    def place(self) -> Complexes:
        """Its place: on the lines of both leads."""
        return crossing(self.motion, self.triad, self.pair)

    def of_link(self, link: int, place: Complexes, order: int) -> Complexes:
        """Give the place, velocity or acceleration of a link's point that lies at a place."""
        if link == FRAME:
            return place if order == 0 else 0 * place
        rates = self.motion.links[link]
        name = next(iter(self.mechanism.links[link].points))
        spun = (1.0, 1j * rates[1], 0.0)[order] if order < 2 else 1j * rates[2] - rates[1] ** 2
        return np.asarray(self.motion.points[name][order] + spun * (place - self.motion.points[name].r))

    def rows(self) -> Iterator[SpecialRow]:
        """Give the vectors that the plans have at it."""
        s, basis = self.letters.small(self.name), self.triad.basis
        spin = self.motion.links[basis].omega
        for order in (VELOCITIES, ACCELERATIONS):
            whole = self.moved(order.number)
            yield SpecialRow(order, POLES[order.plan], s, f"{order.point.symbol}_{self.name}", whole)
        for lead in self.pair:
            start, known = self._start(lead, VELOCITIES)
            over = self.name + (lead.hinge if lead.kind == ROD else str(lead.link))
            yield SpecialRow(VELOCITIES, start, s, f"v_{over}", self.moved(1) - known)
            start, known = self._start(lead, ACCELERATIONS)
            end, normal = self.letters.normal(self.name, lead.pin), -(spin**2) * (self.place - self._point(lead.pin, 0))
            yield SpecialRow(ACCELERATIONS, start, end, f"a^n_{self.name}{lead.pin}", normal)
            part = "t" if lead.kind == ROD else "r"
            yield SpecialRow(ACCELERATIONS, end, s, f"a^{part}_{over}", self.moved(2) - known - normal)
        pin, end = self.out.pin, self.letters.normal(self.out.pin, self.name)
        tip = self.letters.small(pin) if self.out.kind != SLOT else self.letters.under(pin, basis)
        over = f"{tip.upper().replace('_', '') if self.out.kind == SLOT else pin}{self.name}"
        contact = self._point(pin, 0)
        rest = [self.of_link(basis, contact, k) - self.moved(k) for k in (1, 2)]
        normal = -(spin**2) * (contact - self.place)
        yield SpecialRow(VELOCITIES, s, tip, f"v_{over}", rest[0])
        yield SpecialRow(ACCELERATIONS, s, end, f"a^n_{over}", normal)
        yield SpecialRow(ACCELERATIONS, end, tip, f"a^t_{over}", rest[1] - normal)

    def _start(self, lead: TriadLead, order: Order) -> tuple[str, Complexes]:
        """Give the letter from which a lead's line is drawn on a plan, and the value there."""
        pin, k, letters = lead.pin, order.number, self.letters
        if lead.kind == ROD:
            still = lead.hinge in self.mechanism.links[FRAME].points
            image, value = POLES[order.plan] if still else letters.small(lead.hinge), self._point(lead.hinge, k)
            if k == VELOCITIES.number:
                return image, value
            arm = self._point(pin, 0) - self._point(lead.hinge, 0)
            normal = -(self.motion.links[lead.link].omega ** 2) * arm
            return letters.normal(pin, "" if still else lead.hinge), value + normal
        host = lead.host if lead.kind == GUIDE else self.triad.basis
        below, rate = (self.of_link(host, self._point(pin, 0), n) for n in (k, 1))
        slip = self._point(pin, 1) - rate
        if lead.kind == SLOT:
            slip, value = -slip, self._point(pin, k)
            image = POLES[order.plan] if pin in self.mechanism.links[FRAME].points else letters.small(pin)
        else:
            image, value = letters.under(pin, host), below
            if self.mechanism.turning_with[host] == FRAME:
                return POLES[order.plan] if host == FRAME else image, value
        if k == VELOCITIES.number:
            return image, value
        return letters.coriolis(pin, host, key(lead.slide)), value + 2j * self.motion.links[host].omega * slip

    def _point(self, name: str, order: int) -> Complexes:
        return self.motion.points[name][order]


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN
def crossing(motion: Motion, triad: Triad, pair: Sequence[TriadLead]) -> Complexes:
    """Give the places, (N,) m, where the lines of force of two leads meet."""
    (start, way), (other, along) = (_line(motion, triad, lead) for lead in pair)
    return np.asarray(start + way * ((other - start).conj() * along).imag / (way.conj() * along).imag)


def _line(motion: Motion, triad: Triad, lead: TriadLead) -> tuple[Complexes, Complexes]:
    pin = motion.points[lead.pin].r
    if lead.kind == ROD:
        return pin, pin - motion.points[lead.hinge].r
    host = lead.host if lead.kind == GUIDE else triad.basis
    turned = 0.0 if host == FRAME else motion.links[host].angle
    return pin, np.asarray(1j * lead.slide.way(host).direction * np.exp(1j * turned) * np.ones(len(pin)))


def special_places(motion: Motion, groups: Iterable[Assur]) -> dict[str, Complexes]:
    """Give the places of all special points that triads may have, (N,) m, by their letters."""
    triads = (group for group in groups if isinstance(group, Triad))
    pairs = ((triad, pair) for triad in triads for pair in combinations(triad.leads, 2))
    return {special_name(pair, motion.points): crossing(motion, triad, pair) for triad, pair in pairs}


def special_rows(mechanism: Mechanism, motion: Motion, letters: PlanLetters, vector: SpecialPoint) -> list[SpecialRow]:
    """Give the vectors at the special point of a triad."""
    return list(AnalysedSpecial(mechanism, motion, letters, vector.triad).rows())
