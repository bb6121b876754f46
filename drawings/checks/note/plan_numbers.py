"""What a note says of a linkage in one position: each part by the formula of the method, its numbers by analysis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from drawings.checks.note.due_math import NUMBER, Due, DueMath, Quantity
from drawings.checks.note.motion_legs import Leg, Spot, legs, others
from drawings.checks.note.solved_position import SolvedPosition
from drawings.lettering.words import word as lettered
from drawings.report.formula import Formula
from plans.linkage.letters import POLES, Letters
from plans.model.dyad import Dyad
from plans.model.mechanism import Drive
from plans.model.order import ACCELERATIONS, VELOCITIES, Order
from plans.model.order import Quantity as Of
from plans.words.words import word

SENSES = {True: "counter-clockwise", False: "clockwise"}


@dataclass(frozen=True)
class PlanNumbers:
    """The lines on one position; `scales` are those of its plans that are drawn, true units a mm."""

    solved: SolvedPosition
    letters: Letters
    scales: Mapping[str, float]
    formula: Formula

    def primary(self, drive: Drive) -> Iterator[Due]:
        """Give what is told of the primary link: a crank's end by its turning, a slide that is pushed by its point."""
        end = Spot(drive.end)
        if drive.pushed:
            yield from self._point(end)
            return
        leg = Leg(end, Spot(drive.pivot), drive.link, fixed=True)
        solved, (velocity, _, rest) = self.solved, self.solved.parts(leg)
        spin, arm, letter = self._letter(f"ω_{leg.link}"), self._arm(leg), self._of(VELOCITIES, end)
        numbers = solved.spin(leg), solved.length(leg), solved.speed(velocity)
        yield (self._line([letter, f"{spin} {arm}", rf"{NUMBER} \cdot {NUMBER}"], numbers, VELOCITIES.point),)
        yield from self._laid(VELOCITIES, letter, (POLES[VELOCITIES.plan], end.image(self.letters)), numbers[-1])
        yield from self._normal(leg)
        turned = [self._part("t", leg), rf"{self._letter(f'ε_{leg.link}')} {arm}", rf"{NUMBER} \cdot {NUMBER}"]
        gained = solved.gain(leg), solved.length(leg), solved.push(rest)
        yield (self._line(turned, gained, ACCELERATIONS.point)._replace(needed=abs(rest) > solved.floors.acceleration),)
        yield from self._whole(ACCELERATIONS, end)

    def group(self, dyad: Dyad) -> Iterator[Due]:
        """Give what is told of a group: its legs, those that turn first, its inner point, and points by similarity."""
        own = legs(dyad, self.solved.mechanism)
        for leg in (one for one in own if one.slide is None):
            yield from self._turning(leg)
        for leg in (one for one in own if one.slide is not None and not one.guided):
            yield from self._sliding(leg)
        if not any(leg.slide is None and leg.fixed for leg in own):
            yield from self._whole(VELOCITIES, own[0].point)
        yield from self._whole(ACCELERATIONS, own[0].point)
        for name in others(dyad, self.solved.mechanism):
            if name in self.solved.motion.points:
                yield from self._point(Spot(name))

    def _turning(self, leg: Leg) -> Iterator[Due]:
        """A point about another one: its velocity, rate, normal part, tangential part, and what the rate gains."""
        solved, (velocity, _, rest) = self.solved, self.solved.parts(leg)
        own, tip = self._letter(f"v_{{{leg.relative}}}"), leg.point.image(self.letters)
        same = f"{self._of(VELOCITIES, leg.point)} = {own}" if leg.fixed else own
        yield self._read(VELOCITIES, same, (self._base(VELOCITIES, leg), tip), solved.speed(velocity))
        speed = solved.speed(velocity), solved.length(leg), solved.spin(leg)
        yield self._rate(VELOCITIES, leg, own, speed, solved.omega(leg.link))
        yield from self._normal(leg)
        part = self._part("t", leg)
        yield self._read(ACCELERATIONS, part, (leg.parted(self.letters), tip), solved.push(rest))
        gain = solved.push(rest), solved.length(leg), solved.gain(leg)
        yield self._rate(ACCELERATIONS, leg, part, gain, solved.epsilon(leg.link))

    def _sliding(self, leg: Leg) -> Iterator[Due]:
        """A point along a link: the link's point under it, its slip, Coriolis part and relative part."""
        solved, (velocity, known, rest) = self.solved, self.solved.parts(leg)
        if leg.base.link is not None:
            yield from self._point(leg.base)
        own, tip, parted = self._letter(f"v_{{{leg.relative}}}"), leg.point.image(self.letters), self._part("k", leg)
        yield self._read(VELOCITIES, own, (self._base(VELOCITIES, leg), tip), solved.speed(velocity))
        numbers = solved.spin(leg), solved.speed(velocity), solved.push(known)
        sides = [parted, rf"2 {self._letter(f'ω_{leg.link}')} {own}", rf"2 \cdot {NUMBER} \cdot {NUMBER}"]
        yield (self._line(sides, numbers, ACCELERATIONS.point),)
        end = leg.parted(self.letters)
        yield from self._laid(ACCELERATIONS, parted, (self._base(ACCELERATIONS, leg), end), numbers[-1])
        yield self._read(ACCELERATIONS, self._part("r", leg), (end, tip), solved.push(rest))

    def _normal(self, leg: Leg) -> Iterator[Due]:
        """The normal part by the rate squared and the arm, and its length on the plan."""
        solved, part = self.solved, self._part("n", leg)
        numbers = solved.spin(leg), solved.length(leg), solved.push(solved.parts(leg)[1])
        square = rf"{self._letter(f'ω_{leg.link}')}^{{2}} {self._arm(leg)}"
        yield (self._line([part, square, rf"{NUMBER}^{{2}} \cdot {NUMBER}"], numbers, ACCELERATIONS.point),)
        ends = self._base(ACCELERATIONS, leg), leg.parted(self.letters)
        yield from self._laid(ACCELERATIONS, part, ends, numbers[-1])

    def _point(self, spot: Spot) -> Iterator[Due]:
        for order in (VELOCITIES, ACCELERATIONS):
            yield from self._whole(order, spot)

    def _whole(self, order: Order, spot: Spot) -> Iterator[Due]:
        """A point's velocity or acceleration from the pole."""
        solved = self.solved
        size = solved.speed(solved.v(spot)) if order is VELOCITIES else solved.push(solved.a(spot))
        yield self._read(order, self._of(order, spot), (POLES[order.plan], spot.image(self.letters)), size)

    def _read(self, order: Order, letter: str, ends: tuple[str, str], size: Quantity) -> Due:
        """A vector by its length on the plan and the scale; of a plan not drawn, or of none, by its size alone."""
        bare, mu = self._line([letter], (size,), order.point), self.scales.get(order.plan)
        if mu is None:
            return (bare,)
        product = rf"{self.formula.segment(*ends)} \cdot {self._scale(order)}"
        numbers = size.over(mu), Quantity(mu, 0.0), size
        read = self._line([letter, product, rf"{NUMBER} \cdot {NUMBER}"], numbers, order.point)
        return (read,) if size.value > size.off else (read, bare)

    def _laid(self, order: Order, letter: str, ends: tuple[str, str], size: Quantity) -> Iterator[Due]:
        """The length on paper at which a known vector is laid off, where its plan is drawn."""
        mu = self.scales.get(order.plan)
        if mu is not None:
            sides = [self.formula.segment(*ends), f"{letter} / {self._scale(order)}", f"{NUMBER} / {NUMBER}"]
            numbers = size, Quantity(mu, 0.0), size.over(mu)
            line = self._line(sides, numbers, Of("", "", "mm"))
            yield (line._replace(needed=size.value > size.off),)

    def _rate(self, order: Order, leg: Leg, part: str, numbers: tuple[Quantity, ...], rate: float) -> Due:
        """A link's rate by a part over the arm, with its sense; one that is none has no sense."""
        letter = self._letter(f"{order.link.symbol}_{leg.link}")
        line = self._line([letter, f"{part} / {self._arm(leg)}", f"{NUMBER} / {NUMBER}"], numbers, order.link)
        told = {sense: word(self.formula.drafting.language, f"way.{key}") for sense, key in SENSES.items()}
        ways = {sense: line._replace(text=f"{line.text}, {one}") for sense, one in told.items()}
        return (ways[rate > 0],) if numbers[0].value > numbers[0].off else (line, *ways.values())

    def _line(self, sides: list[str], numbers: tuple[Quantity, ...], of: Of) -> DueMath:
        """Write sides that are equal, and the last number with its unit."""
        unit = self.formula.unit(lettered(self.formula.drafting.language, of.unit))
        return DueMath(f"- ${' = '.join(sides)} = {NUMBER}{unit}$", numbers)

    def _base(self, order: Order, leg: Leg) -> str:
        return POLES[order.plan] if leg.fixed else leg.base.image(self.letters)

    def _letter(self, markup: str) -> str:
        return self.formula.letter(markup)

    def _of(self, order: Order, spot: Spot) -> str:
        return self._letter(f"{order.point.symbol}_{{{spot.letters}}}")

    def _part(self, name: str, leg: Leg) -> str:
        return self._letter(f"a^{name}_{{{leg.relative}}}")

    def _arm(self, leg: Leg) -> str:
        return self._letter(f"l_{{{leg.arm}}}")

    def _scale(self, order: Order) -> str:
        return self._letter(f"μ_{order.point.symbol}")
