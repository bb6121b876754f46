"""A view of a rotor as it was laid out: its scale, its axis, its masses, its title (вид ротора)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.rotor.rotor_bodies import ALONG, BodyAtRest, bodies, letter, origin
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from plans.model.rotor import Balance, Rotor

BLACK = "#000000"  # a counterweight is


@dataclass(frozen=True)
class RotorSeen:
    """A view of a rotor on paper, with the bodies that it must show."""

    plan: str
    strokes: FigureStrokes
    rotor: Rotor
    balance: Balance
    drafting: Drafting

    @cached_property
    def bodies(self) -> tuple[BodyAtRest, ...]:
        """The masses and counterweights."""
        return bodies(self.rotor, self.balance)

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(self.plan, (self.strokes.group,))

    @cached_property
    def zero(self) -> complex:
        """The axis, or its place 0, on paper."""
        mu, at = origin(self.strokes)
        return at if self.plan == ALONG else at - float(self.rotor.planes[-1].place) / mu

    @cached_property
    def mu(self) -> float:
        """The scale, m/mm."""
        return origin(self.strokes)[0]

    @property
    def known(self) -> bool:
        """Whether some radius is known, so that there is a scale."""
        return any(one.known for one in self.bodies)

    def headed(self, key: str, scaled: bool) -> None:
        """Hold the title and the line under it."""
        word, own = self.drafting.word, self.inventory
        own.text(word(key), on("title", self.plan, text=word(key)))
        under = scale_line(self.mu, "l", "m", self.drafting) if scaled else word("angles alone")
        own.text(under, on("scale_missing", self.plan, text=under))

    def spot(self, one: BodyAtRest) -> complex:
        """Give where a body is seen."""
        return self.zero + (one.centre if self.plan == ALONG else complex(one.place, one.centre.imag)) / self.mu

    def masses(self) -> None:
        """Hold the circle and the letter of every body."""
        for one in self.bodies:
            circle, wrong = self.inventory.circle(self.spot(one)), self.lost("mass", one)
            black = one.added or not one.distinct
            if wrong is not None and (circle is None or (circle.style.fill == BLACK) != black):
                self.inventory.wrong.append(wrong)
        for one in (one for one in self.bodies if one.distinct):
            text = letter(one.mark, len(self.bodies), self.drafting)
            self.inventory.letter(text, [self.spot(one)], self.lost("letter", one))

    def radius(self, one: BodyAtRest, foot: complex, dashed: bool) -> None:
        """Hold the line to a body: that to a counterweight is a result's, dashed where the radius is not known."""
        own, line, wrong = self.drafting.hand, self.inventory.line(foot, self.spot(one)), self.lost("radius", one)
        width = (own.result if one.added else own.other).width
        if wrong is not None and (line is None or line.style.width != width or bool(line.style.dash) != dashed):
            self.inventory.wrong.append(wrong)

    def lost(self, key: str, one: BodyAtRest) -> Wrong | None:
        """Say that something of a body is missing; of one that rounding may hide it may be."""
        return on(key, self.plan, name=one.mark) if one.sure else None
