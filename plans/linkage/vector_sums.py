"""Vector sums: the equations from which plans find a group's points, in numbers (векторные уравнения).

They are read off a motion, whichever road found it: of a tip that turns about a start a_B = a_A + a^n_BA + a^t_BA, of
a point that slides on a link a_B = a_B7 + a^k + a^r (M3.1, M3.7), of a special point by two leads (M3.10).
"""

from collections.abc import Iterator
from typing import NamedTuple

from geometry.three_leads import GUIDE, ROD, SLOT
from plans.linkage.leads import key
from plans.linkage.plan import PlanLetters, Turning
from plans.linkage.special_points import AnalysedSpecial
from plans.model.dyad import Assur, Dyad
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion
from plans.model.triad import Triad, TriadLead

Moved = tuple[complex, complex]  # velocity m/s and acceleration m/s2 of a point


class VectorSum(NamedTuple):
    """What one link of a group gives of its inner point: base, and the motion relative to it.

    `arm` are the letters of the line that turns; without them the point slides on the link along `slot`.
    `images` are the letters of the plans: of the base, of the end of a^n or a^k, and of the point.
    """

    point: str
    base: str
    link: int
    arm: str
    length: float  # m, of the arm
    slot: str
    fixed: bool  # whether the base is a point of the frame
    images: tuple[str, str, str]
    velocity: tuple[complex, complex]  # of the base, relative
    acceleration: tuple[complex, complex, complex]  # of the base, normal or Coriolis part, the rest
    own: str = ""  # the letters of the normal or Coriolis part, if not those of the relative motion
    more: tuple[str, complex] = ("", 0j)  # the letters and the value of a basis link's normal part towards S

    @property
    def turns(self) -> bool:
        """Whether the relative motion is a turning."""
        return bool(self.arm)

    @property
    def guided(self) -> bool:
        """Whether the point slides on the frame: then its direction alone is told."""
        return not self.turns and self.link == FRAME

    @property
    def relative(self) -> str:
        """The letters of the relative motion: BA."""
        return f"{self.point}{self.base}"


class VectorSums(NamedTuple):
    """The vector equations of a mechanism in one position of a motion."""

    mechanism: Mechanism
    motion: Motion
    position: int
    letters: PlanLetters

    def of(self, group: Assur) -> tuple[tuple[VectorSum, ...], ...]:
        """Give the equations from which the plans find a group's points, two for each: its inner one; S and another."""
        if isinstance(group, Triad):
            return self._special(group)
        assert isinstance(group, Dyad)  # of the groups that have equations
        return (self._inner(group),)

    def _special(self, triad: Triad) -> tuple[tuple[VectorSum, ...], ...]:
        """Give the equations of the special point by two leads, then of the third lead's point by it and by that."""
        special = AnalysedSpecial(self.mechanism, self.motion, self.letters, triad)
        k, s, out = self.position, special.name, special.out
        place, whole = complex(special.place[k]), (complex(special.moved(1)[k]), complex(special.moved(2)[k]))
        sums = [self._towards(triad, lead, (s, place), whole) for lead in special.pair]
        tip, image = (out.pin, self.letters.small(out.pin)) if out.kind != SLOT else self._below(triad, out)
        arm, end = self._place(out.pin) - place, self.carried(triad.basis, self._place(out.pin))
        normal = -(self.omega(triad.basis) ** 2) * arm
        images = self.letters.small(s), self.letters.normal(out.pin, s), image
        about = VectorSum(
            tip, s, triad.basis, f"{s}{out.pin}", abs(arm), "", False, images, (whole[0], end[0] - whole[0]),
            (whole[1], normal, end[1] - whole[1] - normal),
        )  # fmt: skip
        return tuple(sums), (self.lead(triad, out), about)

    def _towards(self, triad: Triad, lead: TriadLead, special: tuple[str, complex], whole: Moved) -> VectorSum:
        """Tell the special point from what a lead hangs on: along the line that the lead leaves its own point."""
        (s, place), own = special, self.lead(triad, lead)
        normal = -(self.omega(triad.basis) ** 2) * (place - self._place(lead.pin))
        rest = whole[1] - own.acceleration[0] - own.acceleration[1] - normal
        images = own.images[0], self.letters.normal(s, lead.pin), self.letters.small(s)
        return own._replace(
            point=s, images=images, velocity=(own.velocity[0], whole[0] - own.velocity[0]), own=own.relative,
            acceleration=(*own.acceleration[:2], rest), more=(f"{s}{lead.pin}", normal),
        )  # fmt: skip

    def pair(self, triad: Triad) -> Iterator[VectorSum]:
        """Tell the basis link's points on the leads whose lines meet in the special point."""
        special = AnalysedSpecial(self.mechanism, self.motion, self.letters, triad)
        return (self.lead(triad, lead) for lead in special.pair)

    def lead(self, triad: Triad, lead: TriadLead) -> VectorSum:
        """Tell the basis link's point on a lead from what the lead hangs on."""
        if lead.kind == ROD:
            return self.turning(Turning(lead.link, lead.hinge, lead.pin))
        pin, slide, written = lead.pin, lead.slide, self.letters
        place = self._place(pin)
        if lead.kind == GUIDE:
            images = written.under(pin, lead.host), written.coriolis(pin, lead.host, key(slide)), written.small(pin)
            rates = self.carried(lead.host, place), self.rates(pin)
            return self._slid((pin, under(pin, lead.host)), (lead.host, slide.label), rates, images)
        tip, image = self._below(triad, lead)
        images = written.small(pin), written.coriolis(pin, triad.basis, key(slide)), image
        rates = self.rates(pin), self.carried(triad.basis, place)
        return self._slid((tip, pin), (triad.basis, slide.label), rates, images)

    def _below(self, triad: Triad, lead: TriadLead) -> tuple[str, str]:
        """Letter the basis link's point under a stone, and its image."""
        return under(lead.pin, triad.basis), self.letters.under(lead.pin, triad.basis)

    def _inner(self, dyad: Dyad) -> tuple[VectorSum, VectorSum]:
        """Give the two equations of a dyad's inner point."""
        if isinstance(dyad.inner, str):
            first, second = (self._lead(dyad, end) for end in (0, 1))
            return first, second
        return self._slot(dyad), self._owner(dyad)

    def turning(self, vector: Turning) -> VectorSum:
        """Tell a tip that turns about a start."""
        _, start, tip = vector
        fixed = start in self.mechanism.links[FRAME].points
        images = start, self.letters.normal(tip, "" if fixed else start), self.letters.small(tip)
        return self._turned(vector, tip, self.rates(tip), images)

    def others(self, group: Assur) -> Iterator[str]:
        """Name the points that similarity gives of a group's links."""
        inner = group.inner_pairs if isinstance(group, Dyad) else ()
        known = {pair.joint for pair in (*group.outer_pairs, *inner)}
        if isinstance(group, Triad):
            known.add(AnalysedSpecial(self.mechanism, self.motion, self.letters, group).out.pin)
        for link in group.links:
            yield from (name for name in self.mechanism.links[link].points if name not in known)

    def _lead(self, dyad: Dyad, end: int) -> VectorSum:
        if isinstance(dyad.outer[end], str):
            return self.turning(Turning(dyad.links[end], dyad.hinge(end), dyad.pin))
        host, image = dyad.hosts[end], self.letters.small(dyad.pin)
        base, place = self.carried(host, self._place(dyad.pin)), dyad.slide(end).label
        images = self.letters.under(dyad.pin, host), self.letters.coriolis(dyad.pin, host, key(dyad.slide(end))), image
        letters = dyad.pin, under(dyad.pin, host)
        return self._slid(letters, (host, place), (base, self.rates(dyad.pin)), images)

    def _slot(self, dyad: Dyad) -> VectorSum:
        """Tell the slotted link's point under the pin from the pin itself, along the slot."""
        pin, link = dyad.hinge(0), dyad.links[1]
        whole, written = self.carried(link, self._place(pin)), self.letters
        images = written.small(pin), written.coriolis(pin, link, key(dyad.slide())), written.under(pin, link)
        return self._slid((under(pin, link), pin), (link, dyad.slide().label), (self.rates(pin), whole), images)

    def _owner(self, dyad: Dyad) -> VectorSum:
        """Tell the slotted link's point under the pin from what the slotted link hangs on."""
        pin, link, host = dyad.hinge(0), dyad.links[1], dyad.hosts[1]
        whole, image = self.carried(link, self._place(pin)), self.letters.under(pin, link)
        if isinstance(dyad.outer[1], str):
            vector = Turning(link, dyad.hinge(1), pin)
            images = vector.start, self.letters.normal(image.upper()), image
            return self._turned(vector, under(pin, link), whole, images)
        base = self.carried(host, self._place(pin))
        images = self.letters.under(pin, host), self.letters.coriolis(pin, host, key(dyad.slide(1))), image
        letters = under(pin, link), under(pin, host)
        return self._slid(letters, (host, dyad.slide(1).label), (base, whole), images)

    def _turned(self, vector: Turning, point: str, whole: Moved, images: tuple[str, str, str]) -> VectorSum:
        link, start, tip = vector
        arm, base = self._place(tip) - self._place(start), self.rates(start)
        normal = -(self.omega(link) ** 2) * arm
        velocity = base[0], whole[0] - base[0]
        acceleration = base[1], normal, whole[1] - base[1] - normal
        fixed = start in self.mechanism.links[FRAME].points
        names = ("" if fixed else self.letters.small(start)), *images[1:]
        return VectorSum(
            point, start, link, f"{start}{tip}", abs(arm), "", fixed, (names[0], names[1], names[2]), velocity,
            acceleration,
        )  # fmt: skip

    def _slid(
        self, letters: tuple[str, str], slot: tuple[int, str], rates: tuple[Moved, Moved], images: tuple[str, str, str]
    ) -> VectorSum:
        """Tell a point that slides on a link, from the base that lies under it."""
        (point, base), (link, label), (under_it, whole) = letters, slot, rates
        slip = whole[0] - under_it[0]
        coriolis = 2j * self.omega(link) * slip
        return VectorSum(
            point, base, link, "", 0.0, label, link == FRAME, images, (under_it[0], slip),
            (under_it[1], coriolis, whole[1] - under_it[1] - coriolis),
        )  # fmt: skip

    def carried(self, link: int, place: complex) -> Moved:
        """Give the velocity and the acceleration of the point of a link that lies at a place."""
        if link == FRAME:
            return 0j, 0j
        name = next(iter(self.mechanism.links[link].points))
        (v, a), reach, omega = self.rates(name), place - self._place(name), self.omega(link)
        return v + 1j * omega * reach, a + (1j * self.epsilon(link) - omega**2) * reach

    def rates(self, point: str) -> Moved:
        """Give the velocity and the acceleration of a named point; one of the frame rests."""
        if point in self.mechanism.links[FRAME].points:
            return 0j, 0j
        rows = self.motion.points[point]
        return complex(rows.v[self.position]), complex(rows.a[self.position])

    def _place(self, point: str) -> complex:
        return complex(self.motion.points[point].r[self.position])

    def omega(self, link: int) -> float:
        """Angular velocity of a link, rad/s."""
        return 0.0 if link == FRAME else float(self.motion.links[link].omega[self.position])

    def epsilon(self, link: int) -> float:
        """Angular acceleration of a link, rad/s2."""
        return 0.0 if link == FRAME else float(self.motion.links[link].epsilon[self.position])


def under(point: str, link: int) -> str:
    """Letter the point of a link that lies under another's, its prime last.

    >>> under("A", 3), under("A'", 3)
    ('A_{3}', "A_{3}'")
    """
    bare = point.rstrip("'")
    return f"{bare}_{{{link}}}{point[len(bare) :]}"
