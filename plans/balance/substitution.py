"""Substitution of masses: what counterweights must weigh, group by group from the last to the crank (замещение масс).

Every link is point masses and pure static moments in its own frame. A group hands its masses on to its hosts at its
outer hinges, once its static moments about one of them are zero, by a counterweight or because they were.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from plans.balance.mass_centre import EMPTY
from plans.balance.sums import Sums, SumTerm
from plans.balance.weights import CARRIED, FREE, NEEDED, NO_MASS, Unmade, weight_of
from plans.model.balance.linkage import EPS, FULL, PARTIAL, ROUNDING, BalanceTask, Counterweight, Site
from plans.model.dyad import Dyad
from plans.model.machine import Body
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.words.words import because


class PointMass(NamedTuple):
    """A mass at a point of a link: its letter, its place in the link's own frame."""

    point: str
    at: complex
    mass: SumTerm


class Substitution:
    """The masses of a mechanism on their way from the last group to the crank."""

    def __init__(self, mechanism: Mechanism, bodies: Mapping[int, Body], task: BalanceTask) -> None:
        self.mechanism, self.bodies, self.task, self.sums = mechanism, bodies, task, Sums()
        self.masses: dict[int, list[PointMass]] = {link: [] for link in mechanism.links}
        self.pure: dict[int, list[SumTerm]] = {link: [] for link in mechanism.links}
        self.counterweights: dict[int, Counterweight] = {}
        self.needs: dict[int, SumTerm] = {}  # by link the static moment that its counterweight must have
        self.left: dict[str, SumTerm] = {}
        for link, body in sorted(bodies.items()):
            if body.mass:
                mass = self.sums.mass(f"m_{link}", body.mass, because("own_mass", link=link))
                self.put(link, f"S{link}", body.centre, mass)

    def put(self, link: int, point: str, at: complex, mass: SumTerm) -> None:
        """Put a mass on a link; on the frame it does nothing, and one that is nothing but rounding is none."""
        if link != FRAME and not mass.vanishes:
            self.masses[link].append(PointMass(point, at, mass))

    def at_point(self, link: int, point: str) -> complex:
        """Give the place of a named point in a link's own frame."""
        return self.mechanism.links[link].points[point]

    def hand_on(self, host: int, point: str, mass: SumTerm) -> None:
        """Hand a mass on to the host of a hinge."""
        self.put(host, point, self.at_point(host, point), mass)

    def mass(self, link: int) -> SumTerm:
        """Sum the masses that a link bears."""
        terms = (mass.mass for mass in self.masses[link])
        return self.sums.total(f"Σm_{link}", terms, self.sums.no_mass, because("borne", link=link))

    def moment(self, link: int, begin: str) -> SumTerm:
        """Sum the static moments of a link about one of its points, the pure ones among them."""
        origin, terms = self.at_point(link, begin), list(self.pure[link])
        for mass in self.masses[link]:
            if mass.at != origin:
                arm = self.sums.arm(f"{begin}{mass.point}", origin, mass.at, link)
                name = f"{mass.mass.mark.name}·{arm.name}"
                terms.append(self.sums.moment(name, mass.mass, arm, because("moment_about", point=begin)))
        why = because("moments_about", link=link, point=begin)
        return self.sums.total(f"H_{link}", terms, self.sums.no_moment, why)

    def share(self, link: int, outer: str, inner: str) -> SumTerm:
        """Find the mass at the inner hinge of a link that has its static moment about the outer one."""
        arm = self.sums.arm(f"{outer}{inner}", self.at_point(link, outer), self.at_point(link, inner), link)
        why = because("replacing_mass", link=link, point=inner, other=outer)
        return self.sums.share(f"m_{inner}{link}", self.moment(link, outer), arm, why)

    def turn_onto(self, link: int, begin: str, other: int, slide: Slide) -> None:
        """Turn a link's static moments onto another that a slide keeps at a fixed angle to it."""
        moment = self.moment(link, begin)
        if other == FRAME or moment.vanishes:
            return
        by = slide.way(other).direction * slide.way(link).direction.conjugate()
        why = because("fixed_angle", link=link, other=other)
        self.pure[other].append(self.sums.turned(f"H_{link}→{other}", moment, by, why))

    def balance(self, link: int, begin: str, would_do: Sequence[int]) -> None:
        """Bring a link's static moment about a point to zero by the counterweight that it may carry."""
        moment = self.moment(link, begin)
        place = self.task.place(link)
        if self._rests(link, moment):
            return
        if place is None:
            raise Unmade(NEEDED, links=tuple(map(str, would_do)), link=would_do[0])
        mark = self.sums.moments.close(f"U_{link}", moment.mark, why=because("counterweight_moment", link=link))
        found = self._carried(place, begin, SumTerm(mark, moment.size))
        self.put(link, begin, found.origin, self._added(found))

    def _carried(self, place: Site, begin: str, need: SumTerm) -> Counterweight:
        """Put down the counterweight of a link by the static moment that it must have."""
        found = weight_of(self.mechanism, place, begin, need)
        self.counterweights[place.link], self.needs[place.link] = found, need
        return found

    def _added(self, found: Counterweight) -> SumTerm:
        return self.sums.mass(f"m_cw{found.link}", found.mass, because("counterweight_mass", link=found.link))

    def balance_by_rod(self, rod: Dyad, pivot: str) -> None:
        """Bring the crank's static moment to zero by a counterweight on the rod: its masses at both hinges do it (8.9).

        With static moment U about the crank's pin it is U/AB at the slider, and the rest of its mass at the pin.
        """
        (link, _), (crank, _), outer = rod.links, rod.hosts, rod.hinge(0)
        place = self.task.place(link)
        assert place is not None  # asked before
        if self._rests(crank, self.moment(crank, pivot)):
            return
        if place.mass is None:
            raise Unmade(NO_MASS, link)
        added = self.sums.mass(f"m_cw{link}", place.mass, because("counterweight_mass", link=link))
        terms, why = (added, self.share(crank, pivot, outer)), because("rod_for_crank", link=link, point=rod.pin)
        at_slider = self.sums.total(f"m_{rod.pin}{link}′", terms, self.sums.no_mass, why)
        arm = self.sums.arm(f"{outer}{rod.pin}", self.at_point(link, outer), self.at_point(link, rod.pin), link)
        why = because("counterweight_moment", link=link)
        self._carried(place, outer, self.sums.moment(f"U_{link}", at_slider, arm, why))
        self.keep(rod.pin, at_slider)
        rest = self.sums.less(f"m_{outer}{link}′", added, at_slider, because("rest_of_mass", link=link))
        self.hand_on(crank, outer, rest)

    def _rests(self, link: int, moment: SumTerm) -> bool:
        """Tell whether a static moment is none: the place of a mass centre is rounded, too, as the lengths are."""
        whole = self.bodies.get(link, EMPTY).mass * self.longest
        return abs(moment.value) <= ROUNDING * EPS * (moment.size + whole)

    @cached_property
    def longest(self) -> float:
        """The longest distance m of two points of a moving link."""
        links = (link.points.values() for number, link in self.mechanism.links.items() if number != FRAME)
        return max(abs(place - other) for places in links for place in places for other in places)

    def keep(self, point: str, mass: SumTerm) -> None:
        """Leave a mass at a slider: it moves along the guide."""
        if mass.vanishes:
            return
        before = (self.left[point],) if point in self.left else ()
        why = because("left_at_slider", point=point)
        self.left[point] = self.sums.total(f"m_left{point}", (*before, mass), self.sums.no_mass, why)


def carrier(task: BalanceTask, dyad: Dyad) -> int:
    """Choose which of a group's two links carries: one that may, of two the one hinged to the frame, else the first."""
    allowed = [end for end in (0, 1) if task.place(dyad.links[end]) is not None] or [0, 1]
    return next((end for end in allowed if dyad.hosts[end] == FRAME), allowed[0])


def instead_of_crank(mechanism: Mechanism, task: BalanceTask, dyad: Dyad) -> bool:
    """Tell whether a rod on the crank balances it in part, the crank itself having no place for a counterweight."""
    hung = (dyad.kind, dyad.hosts) == ("RRP", (mechanism.drive.link, FRAME))
    return hung and task.aim == PARTIAL and None is task.place(mechanism.drive.link) != task.place(dyad.links[0])


def _rrr(found: Substitution, dyad: Dyad) -> None:
    """Replace the other link's masses at its hinges, and balance the carrying link with that at the inner one."""
    end = carrier(found.task, dyad)
    link, other = dyad.links[end], dyad.links[1 - end]
    outer, far, pin = dyad.hinge(end), dyad.hinge(1 - end), dyad.pin
    at_pin = found.share(other, far, pin)
    found.put(link, pin, found.at_point(link, pin), at_pin)
    found.balance(link, outer, dyad.links)
    rest = found.sums.less(f"m_{far}{other}", found.mass(other), at_pin, because("rest_of_mass", link=other))
    found.hand_on(dyad.hosts[1 - end], far, rest)
    found.hand_on(dyad.hosts[end], outer, found.mass(link))


def _rrp(found: Substitution, dyad: Dyad) -> None:
    """Take the slider's mass for one at its hinge; the rod is balanced with it, or a share is left on the guide."""
    rod, slider = dyad.links
    outer, pin = dyad.hinge(0), dyad.pin
    found.turn_onto(slider, pin, dyad.hosts[1], dyad.slide(1))
    found.put(rod, pin, found.at_point(rod, pin), found.mass(slider))
    free = found.task.place(rod) is None or instead_of_crank(found.mechanism, found.task, dyad)
    if found.task.aim != FULL and dyad.hosts[1] == FRAME and free:
        stays = found.share(rod, outer, pin)
        found.keep(pin, stays)
        whole = found.sums.less(f"m_{outer}{rod}", found.mass(rod), stays, because("rest_of_mass", link=rod))
    else:
        found.balance(rod, outer, (rod,))
        whole = found.mass(rod)
    found.hand_on(dyad.hosts[0], outer, whole)


def _rpr(found: Substitution, dyad: Dyad) -> None:
    """Turn the one link's static moment onto the other, with which it keeps its angle; each mass is at its hinge."""
    end = carrier(found.task, dyad)
    link, other = dyad.links[end], dyad.links[1 - end]
    found.turn_onto(other, dyad.hinge(1 - end), link, dyad.slide())
    found.balance(link, dyad.hinge(end), dyad.links)
    for end in (0, 1):
        found.hand_on(dyad.hosts[end], dyad.hinge(end), found.mass(dyad.links[end]))


def _prp(found: Substitution, dyad: Dyad) -> None:
    """Leave both masses on a guide of the frame: no counterweight on these links could bring them to rest."""
    guided = next((end for end in (1, 0) if dyad.hosts[end] == FRAME), 1)
    other, pin = dyad.links[1 - guided], dyad.pin
    for end in (0, 1):
        found.turn_onto(dyad.links[end], pin, dyad.hosts[end], dyad.slide(end))
    both = [found.mass(dyad.links[guided]), found.mass(other)]
    mass = found.sums.total(f"m_{pin}", both, found.sums.no_mass, because("borne_together"))
    _leave(found, dyad, guided, pin, mass)


def _rpp(found: Substitution, dyad: Dyad) -> None:
    """Hand the hinged link's mass to its host; that of the guided one stays on a guide of the frame."""
    hinged, guided = dyad.links
    outer, slide = dyad.hinge(0), dyad.slide(1)
    found.turn_onto(hinged, outer, guided, dyad.slide())
    found.hand_on(dyad.hosts[0], outer, found.mass(hinged))
    point = slide.point if slide.slider == guided else next(iter(found.mechanism.links[guided].points))
    found.turn_onto(guided, point, dyad.hosts[1], slide)
    _leave(found, dyad, 1, point, found.mass(guided))


def _leave(found: Substitution, dyad: Dyad, end: int, point: str, mass: SumTerm) -> None:
    """Leave a mass on the guide of one end, which must be the frame's and allowed to move."""
    if mass.vanishes:
        return
    if found.task.aim == FULL or dyad.hosts[end] != FRAME:
        raise Unmade(FREE if dyad.hosts[end] == FRAME else CARRIED, link=dyad.links[end])
    found.keep(point, mass)


KINDS = {"RRR": _rrr, "RRP": _rrp, "RPR": _rpr, "PRP": _prp, "RPP": _rpp}
