"""Every stroke and letter of a layout of compensators ticked off, and none beside (опись схемы компенсаторов)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

from drawings.checks.balance import figure_parts as parts
from drawings.checks.bank.bank_expected import LINE, Body, Expected
from drawings.checks.bank.bank_views import origin
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.letters import along
from drawings.checks.line_kind import DASHED, MAIN, Kind
from drawings.checks.line_kind import FULL as FULL_LINE
from drawings.checks.wrong import Wrong, on
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Fill, Group, Line, Text
from plans.model.balance.bank import Compensator

ZERO = "O"  # the letter of the shaft
FULL = "#000000"  # a mass is a black circle


@dataclass(frozen=True)
class CompensatorStrokes:
    """A layout of compensators on paper: arms, masses and senses with their letters; sizes are held by themselves."""

    part: Group
    expected: Expected
    by: Drafting
    found: Compensator

    @cached_property
    def ink(self) -> Inventory:
        """What is drawn."""
        return parts.inventory(self.part.name, self.part)

    @cached_property
    def strokes(self) -> FigureStrokes:
        """The same by kinds."""
        return FigureStrokes(self.part)

    @property
    def carried(self) -> bool:
        """Whether it is a counterweight on the crank."""
        return self.expected.carried(self.found)

    @property
    def unscaled(self) -> bool:
        """Whether the arms are not to scale."""
        told = any(self.by.word("arms nominal") in text for text in self.strokes.texts)
        return self.expected.nominal(self.found, told)

    def faults(self) -> Iterator[Wrong]:
        """Hold the heading, the shaft, each mass, and the lines that they stand on."""
        zero, mu = origin(self.strokes)
        self._headed(mu)
        parts.spot(self.ink, zero, ZERO, ZERO)
        couple = self._masses()
        if self.expected.directed(self.found):
            self._lines(zero, mu, couple)
        else:
            for kind in (Line, Fill):
                self.ink.every(kind, lambda one: True)
            self.ink.every(Text, lambda one: one.plain.startswith(("z = ", "L = ")))
        return self.ink.faults()

    def _headed(self, mu: float) -> None:
        order = {} if self.carried else {"order": self.found.asked.order}
        title = self.by.word("compensator of order" if order else "counterweight on crank", **order)
        nominal = [self.by.word("arms nominal")] if self.unscaled else []
        parts.headed(self.ink, title, [scale_line(mu, "l", "m", self.by), *nominal])

    def _masses(self) -> list[complex]:
        """Tick off each mass with its letter and its arm; give the shafts of those of a couple."""
        masses, couple = [one for one in self.strokes.circles if one.style.fill == FULL], list[complex]()
        for body in self.expected.bodies(self.found):
            mass = self._mass(lowered(body.name), masses)
            if mass is None:
                self.ink.wrong.append(on("mass", self.part.name, name=body.name))
                continue
            masses.remove(mass)
            couple += self._borne(body, mass)
        return couple

    def _mass(self, name: str, masses: Sequence[Circle]) -> Circle | None:
        """Give the mass that bears a letter; without the letter the first that is left."""
        text = next((one for one in self.ink.left(Text) if one.plain == read(name)), None)
        near = [one for one in masses if text is not None and self.ink.beside(text, [one.centre])]
        return next(iter(near or masses), None)

    def _borne(self, body: Body, mass: Circle) -> list[complex]:
        """Tick off a mass, its letter, its arm, which is dashed where it is not to scale, and its shaft."""
        ink, name, wrong = self.ink, lowered(body.name), on("mass", self.part.name, name=body.name)
        ink.circle(mass.centre, wrong, mass.radius)
        ink.letter(read(name), [mass.centre], wrong)
        arm = ink.take(Line, partial(_ends, at=mass.centre), wrong)
        if arm is None:
            return []
        kind = Kind((MAIN,), DASHED if body.coupled or self.unscaled else FULL_LINE)
        if not kind.takes(arm, self.by.hand):
            ink.wrong.append(on("line_named", self.part.name, name=body.name))
        _on_shaft(ink, arm.start, 1 if body.turns * self.expected.task.speed > 0 else -1, body.speed)
        if not body.coupled and not self.carried:
            ink.take(Circle, partial(_about, at=arm.start), on("circle", self.part.name, name=name))
        return [arm.start] if body.coupled else []

    def _lines(self, zero: complex, mu: float, couple: Sequence[complex]) -> None:
        """Tick off the lines of the force and of the compensators, and the dimensions of what is between."""
        offset, way = 0.0 if self.carried else self.found.asked.offset / mu, self.expected.line(self.found)
        _axes(self.ink, zero, way, offset)
        _dimension(self.ink, "z", zero, zero + 1j * offset * way)
        if len(couple) == 2:
            _dimension(self.ink, "L", *couple)


def turning(ink: Inventory, centre: complex, sense: int, letter: str) -> None:
    """Tick off an arrow about a place, with what stands beside it."""
    wrong = on("sense", ink.plan, name=letter)
    middle = ink.turning(centre, sense, wrong)
    if middle is not None:
        ink.letter(letter, [middle], wrong)


def _on_shaft(ink: Inventory, at: complex, sense: int, letter: str) -> None:
    turning(ink, at, sense, letter)
    smallest = min((one.radius for one in ink.left(Circle) if abs(one.centre - at) <= parts.NEAR), default=0.0)
    ink.circle(at, on("circle", ink.plan, name=letter), smallest)


def _ends(one: Line, at: complex) -> bool:
    return abs(one.end - at) <= parts.NEAR


def _about(one: Circle, at: complex) -> bool:
    return abs(one.centre - at) <= parts.NEAR


def _axes(ink: Inventory, zero: complex, way: complex, offset: float) -> None:
    """Tick off the line of the force through the shaft of the crank, and that of the compensators on its left."""
    for aside in dict.fromkeys((0.0, offset)):
        ink.take(Line, partial(_along, zero=zero + 1j * aside * way, way=way), on("line", ink.plan))


def _along(one: Line, zero: complex, way: complex) -> bool:
    start, end = (one.start - zero) / way, (one.end - zero) / way
    off = max(abs(start.imag), abs(end.imag))
    return off <= parts.NEAR + LINE * abs(end - start) and start.real < -parts.NEAR < parts.NEAR < end.real


def _dimension(ink: Inventory, letter: str, start: complex, end: complex) -> None:
    """Tick off the dimension of a size, which is told elsewhere, by its letter; of none there is none."""
    if start == end:
        return
    wrong = on("size", ink.plan, name=letter)
    line = ink.dimension(start, end, wrong)
    if line is not None:
        spots = along(line.start, line.end)
        ink.take(Text, lambda one: one.plain.startswith(f"{letter} = ") and ink.beside(one, spots), wrong)
