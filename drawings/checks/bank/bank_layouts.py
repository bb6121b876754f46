"""The self-check of the layouts of compensators: shafts, masses, senses, sizes (проверка схемы компенсаторов)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from drawings.checks.bank.bank_expected import LINE, Body, Expected
from drawings.checks.bank.bank_views import View
from drawings.checks.graphs.figure_strokes import NEAR, figure
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank.compensator_layout import COMPENSATOR
from drawings.lettering.bank_letters import lowered
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Leaf, Line, Text
from plans.model.balance.bank import Compensator

DIGITS = 4  # of a dimension


def faults(
    measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting, figures: frozenset[str]
) -> Iterator[Wrong]:
    """Hold the layouts that a sheet bears."""
    for one in expected.analysis.compensators:
        name = name_of(one)
        strokes = figure(leaf, name)
        if strokes is not None and name in figures:
            yield from _Layout(strokes, expected, drafting, name, one, measured).faults()


def name_of(one: Compensator) -> str:
    """Name the figure of the compensators of an order."""
    return f"{COMPENSATOR}-{one.asked.order}"


@dataclass(frozen=True)
class _Layout(View):
    """A layout on a sheet, with what it must show; its zero is the crank's shaft."""

    name: str
    found: Compensator
    measured: Measured

    @cached_property
    def arms(self) -> list[tuple[complex, complex]]:
        """The shafts and the masses at the ends of their arms, on paper."""
        masses = [one.centre for one in self.strokes.of(Circle) if one.style.fill == "#000000"]
        lines = [(one.start, one.end) for one in self.strokes.of(Line) if one.style.width >= self.drafting.hand.main]
        return [(start, end) for start, end in lines if any(abs(end - spot) <= NEAR for spot in masses)]

    @property
    def scaled(self) -> bool:
        """Whether the arms must be to scale."""
        told = any(self.drafting.word("arms nominal") in text for text in self.strokes.texts)
        return not self.expected.nominal(self.found, told)

    def faults(self) -> Iterator[Wrong]:
        shafts = dict[str, complex]()
        bodies = list(self.expected.bodies(self.found))
        for one in bodies:
            shaft = self._shaft(one)
            if shaft is None:
                yield on("mass", self.name, name=one.name)
                continue
            shafts[one.name] = shaft
            yield from self._turning(one, shaft)
        if len(self.arms) != len(bodies):
            yield on("mass", self.name, name="?")
        if len(shafts) == len(bodies):
            own = [one for one in bodies if not one.coupled]
            turned = max((self._slack(one) for one in own), default=LINE)  # as far as the line itself may be turned
            yield from self._gears([shafts[one.name] for one in own], turned)
            yield from self._couple([shafts[one.name] for one in bodies if one.coupled], turned)
        marked = {one.name: one for one in self.measured.points if one.plan == self.name}
        known = self.scaled and self.found.asked.mass is not None
        lost = {one.name for one in bodies if known and not one.coupled} ^ marked.keys()
        yield from (on("missing_on", self.name, name=name) for name in sorted(lost))

    def _shaft(self, body: Body) -> complex | None:
        """Find the shaft of a mass: by its letter, its direction and, where it is to scale, its radius."""
        for shaft, end in self.arms:
            arm = end - shaft
            straight = abs(arm / abs(arm) - body.way) <= self._slack(body) if arm else False
            if straight and self._radius(body, abs(arm)) and self.strokes.lettered(lowered(body.name), [end]):
                return shaft
        return None

    def _slack(self, body: Body) -> float:
        """How far a direction may be off."""
        return LINE + 2 * self.expected.slack_of(self.found) / body.moment

    def _radius(self, body: Body, arm: float) -> bool:
        mass = self.found.asked.mass
        if body.coupled or mass is None or not self.scaled:
            return True
        slack = self.expected.slack_of(self.found) / mass / self.mu
        return abs(arm - body.moment / mass / self.mu) <= NEAR + slack

    def _turning(self, body: Body, shaft: complex) -> Iterator[Wrong]:
        """Hold the arrow on a shaft, and the speed that is written beside it."""
        sense = 1 if body.turns * self.expected.task.speed > 0 else -1
        own = [one for one in self.strokes.turnings if abs(one.centre - shaft) <= NEAR]
        if [one.sense for one in own] != [sense] or not self.strokes.lettered(body.speed, [own[0].middle]):
            yield on("sense", self.name, name=body.name)

    def _gears(self, shafts: list[complex], turned: float) -> Iterator[Wrong]:
        """See that two gears touch on the line of the compensators, which is so far from the crank's shaft."""
        if not shafts:
            return
        first, last = shafts[0], shafts[-1]
        line = self.expected.line(self.found)
        middle, half = (first + last) / 2 - self.zero, abs(first - last) / 2
        offset = (middle * (1j * line).conjugate()).real * self.mu
        carried = self.expected.carried(self.found)
        asked = 0.0 if carried else self.found.asked.offset
        if carried and not abs(middle) <= NEAR:
            yield on("mass", self.name, name="m_I")
        if not abs(offset - asked) <= NEAR * self.mu + turned * abs(middle) * self.mu:
            yield on("size", self.name, name="z")
        level = abs(((first - last) * line.conjugate()).real) <= NEAR + turned * half
        if not level or (first != last and not all(self.strokes.circled(one, half) for one in shafts)):
            yield on("circle", self.name, name=lowered("m"))
        yield from self._said("z", asked)

    def _couple(self, shafts: list[complex], turned: float) -> Iterator[Wrong]:
        """See that the couple's shafts stand along the line, so far from one another."""
        asked = self.found.asked.shafts
        if not shafts or asked is None:
            return
        first, last = shafts
        apart = (first - last) * self.mu - asked * self.expected.line(self.found)
        if not abs(apart) <= (NEAR + LINE) * self.mu + turned * asked:
            yield on("size", self.name, name="L")
        yield from self._said("L", asked)

    def _said(self, letter: str, size: float) -> Iterator[Wrong]:
        """Hold what a dimension says, in millimetres of the machine."""
        said = [one.plain for one in self.strokes.of(Text) if one.plain.startswith(f"{letter} = ")]
        right = all(reads(text.partition(" = ")[2], 1000 * size, 0.0, DIGITS) for text in said)
        if not right or bool(said) != bool(size):
            yield on("size", self.name, name=letter)
