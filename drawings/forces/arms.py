"""The arms of forces in equations of moments: those of a cut, and those of the lever (плечи сил)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from drawings.forces.letters import BALANCE, PAIR, letter_of
from drawings.kinds.outlines import is_centre
from drawings.kinds.polygon import ShownVector
from drawings.layout.parallel_offsets import APART, Segment, crossing, merging
from drawings.lettering.words import letter as by_language
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, Field
from drawings.paper.hand import Hand
from drawings.paper.walk import tied, tied_spot
from drawings.symbols.figure import Arm
from geometry.board import Mark, at
from plans.forces.cut import CutGroup, ForcePlan, MomentEquation
from plans.model.motion import NOTHING


class Leverage(NamedTuple):
    """A force's arm about a point, m, in true units; the sense of its moment is +1 counter-clockwise, -1 clockwise.

    The letter is "h_{2}", or "l_{BD}" where the perpendicular is the line between the two named points itself.
    """

    equation: MomentEquation  # in which it stands
    name: str
    about: str
    letter: str
    length: float
    sense: int
    pivot: complex
    at: complex  # where the force acts
    direction: complex  # its unit direction

    @property
    def foot(self) -> complex:
        """The foot of the perpendicular on the line of action."""
        return self.at + self.direction * ((self.pivot - self.at) * self.direction.conjugate()).real

    @property
    def dimensioned(self) -> bool:
        """Whether the scheme draws it: what is a distance between named points has no arm of its own."""
        return self.letter.startswith("h")


def leverages(plan: ForcePlan, cut: CutGroup, column: int) -> tuple[Leverage, ...]:
    """Give the arms of all forces in a cut's equations, the force that each gives last; one without moment has none.

    Letters h are numbered through the cuts of the plan, so that a sheet has each of them once; forces on one line of
    action have one arm.
    """
    arms: list[Leverage] = []
    start = 0
    for numbered in plan.cuts:
        arms = list(_of(plan, numbered, column, start))
        if numbered is cut:
            break
        start += len({arm.letter for arm in arms if arm.dimensioned})
    return tuple(arms)


def largest(plan: ForcePlan, column: int) -> float:
    """Give the largest force of all cuts of a plan, N: what is but rounding beside it is none on any of them."""
    forces = [load.force for cut in plan.cuts for load in cut.loads]
    forces += [support.force for cut in plan.cuts for support in cut.supports]
    return max((abs(at(force.point, column)) for force in forces), default=0.0)


def _of(plan: ForcePlan, cut: CutGroup, column: int, start: int) -> Iterator[Leverage]:
    known: list[Leverage] = []
    least = NOTHING * largest(plan, column)
    letters = {mark: name for name, mark in plan.positions.letters.items()}
    for equation in cut.equations:
        about = letters.get(equation.about, equation.about.name)
        for name, spot, force in _terms(equation):
            value = at(force.point, column)
            if not abs(value) > least:
                continue
            pivot, place = at(equation.about.point, column), at(spot.point, column)
            bare = Leverage(equation, name, about, "", 0.0, 1, pivot, place, value / abs(value))
            moment = ((place - pivot).conjugate() * bare.direction).imag
            if abs(moment) <= NOTHING * abs(place - pivot):
                continue
            letter = _lead(plan, equation, spot, bare) or _number(bare, known, start)
            known.append(bare._replace(letter=letter, length=abs(moment), sense=1 if moment > 0 else -1))
    yield from known


def _terms(equation: MomentEquation) -> Iterator[tuple[str, Mark, Mark]]:
    """Give the forces of an equation, the one that it finds last: name, point, vector."""
    for load in equation.loads:
        yield load.name, load.at, load.force
    if equation.line is not None:
        yield equation.found.name, equation.line.step.inputs[0], equation.found


def _lead(plan: ForcePlan, equation: MomentEquation, spot: Mark, bare: Leverage) -> str:
    """Letter an arm that is the line between two named points, as the lead there is lettered; "" where it is not."""
    arm = bare.at - bare.pivot
    square = abs((arm * bare.direction.conjugate()).real) <= NOTHING * abs(arm)
    names = {mark: name for name, mark in plan.positions.letters.items() if not is_centre(name)}
    if not square or spot not in names:
        return ""
    ends = bare.about + names[spot]
    lines = (equation.line.step.inputs if equation.line is not None else ())[1:]
    return f"l_{{{next((line.name for line in lines if sorted(line.name) == sorted(ends)), ends)}}}"


def _number(bare: Leverage, known: list[Leverage], start: int) -> str:
    """Letter an arm by a number: forces on one line of action have one."""
    alike = (one for one in known if one.about == bare.about and one.dimensioned)
    same = next((o.letter for o in alike if abs(o.foot - bare.foot) <= NOTHING * abs(o.at - o.pivot)), "")
    return same or f"h_{{{start + len({other.letter for other in known if other.dimensioned}) + 1}}}"


BESIDE, ASIDES = 7.0, 6  # mm from one perpendicular to the next where they run along one another, and how many at most
# What speaks against a place: that it, or the line to it from the pivot, runs along a line, out of the figure, across
# an arm or heads meet, that the symbol of its pivot would hide arrows that stand outside, how far it is from its own.
ON_LINE, OUTSIDE, ACROSS, HIDDEN, FURTHER = 4, 3, 1, 3, 0.2


def aside(arms: Iterable[Arm], lines: Iterable[Segment], box: Field | None, hand: Hand) -> list[Arm]:
    """Draw each arm at the nearest place where it runs along no line and none of those before it."""
    around, kept = list(lines), list[Arm]()
    for arm in arms:
        kept.append(_aside(arm, around, [other.reach(hand) for other in kept], box, hand))
    return kept


def _aside(arm: Arm, around: Sequence[Segment], before: Sequence[Segment], box: Field | None, hand: Hand) -> Arm:
    def cost(trial: Arm) -> float:
        reach = trial.reach(hand)
        over = ON_LINE * sum(merging(reach, other) for other in (*around, *before))
        over += ON_LINE * any(merging((arm.about, trial.ends[0]), line) for line in around if trial.aside)
        outside = OUTSIDE * sum(box is not None and not within(end, box) for end in reach)
        tight = reach != trial.ends
        across = ACROSS * sum(crossing(reach, other) for other in ((*around, *before) if tight else before))
        hidden = HIDDEN * (tight and not trial.aside)
        heads = reach if trial.aside else reach[1:]  # those at the pivot meet
        across += ACROSS * any(abs(head - end) < APART for head in heads for other in before for end in other)
        return over + outside + across + hidden + FURTHER * abs(trial.aside) / BESIDE

    steps = (sign * k * BESIDE for k in range(ASIDES + 1) for sign in (1, -1))
    return min((arm._replace(aside=step) for step in steps), key=cost)


def within(spot: complex, box: Field) -> bool:
    """Tell whether a place is in a box."""
    spot = tied_spot(spot)
    return box.left <= spot.real <= box.right and box.bottom <= spot.imag <= box.top


POLE = "p"
ARM = "h′"  # how the letters of arms begin that the lever draws; a line may begin with the image h of a point


class LeverTerm(NamedTuple):
    """A term of the lever's equation of moments: a force N by its arm m/s; the sense is +1 counter-clockwise.

    The arm is "h′_{2}" where it is a line of its own, or "bd" where it is one between two images.
    """

    force: str  # as the plan names it
    letter: str  # as the sheet writes it: "G_{4}", "M^Φ_{4}/l_{BD}"
    size: float
    arm: str
    length: float
    sense: int
    at: complex  # where it acts, m/s
    direction: complex

    @property
    def dimensioned(self) -> bool:
        """Whether the lever draws its arm."""
        return self.arm.startswith(ARM)

    @property
    def written(self) -> tuple[str, str]:
        """Its sign, and the product of its letters."""
        return "+" if self.sense > 0 else "−", f"{self.letter}·{self.arm}"


def terms(
    forces: Sequence[ShownVector], images: Sequence[tuple[complex, str]], drafting: Drafting
) -> tuple[LeverTerm, ...]:
    """Give the terms in the order of hanging, the balancing force first; what has no moment about the pole is none."""
    # What rounding leaves of the greatest force at the greatest speed is no moment, even where there are no others.
    furthest = max((abs(force.at) for force in forces), default=0.0)
    greatest = max((abs(force.value) for force in forces), default=0.0) * furthest
    found, number = list[LeverTerm](), 0
    for name, pair in _together(forces).items():
        moment = sum(force.moment for force in pair)
        first, size = pair[0], abs(pair[0].value)
        if not abs(moment) > NOTHING * greatest:
            continue
        length, sense = abs(moment) / size, 1 if moment > 0 else -1
        arm = _line(pair, images, length)
        if not arm:
            number += first.kind != BALANCE
            arm = by_language(drafting.language, f"{ARM}_{{{'bal' if first.kind == BALANCE else number}}}")
        letter = _couple(name, drafting) if first.kind == PAIR else letter_of(name, drafting)
        found.append(LeverTerm(name, letter, size, arm, length, sense, first.at, first.direction))
    return tuple(found)


def _together(forces: Sequence[ShownVector]) -> dict[str, list[ShownVector]]:
    named: dict[str, list[ShownVector]] = {}
    for force in forces:
        named.setdefault(force.name, []).append(force)
    return named


def _couple(name: str, drafting: Drafting) -> str:
    moment, _, line = name.partition("/")
    return f"{letter_of(moment, drafting)}/l_{{{line}}}"


def _line(pair: Sequence[ShownVector], images: Sequence[tuple[complex, str]], length: float) -> str:
    """Letter an arm that is a line between two images, or from the pole to one; "" where it is not."""
    places = [force.at for force in pair]
    start = places[1] if len(places) > 1 else 0j
    if pair[0].kind != PAIR and not abs(abs(places[0] - start) - length) <= NOTHING * length:
        return ""
    return "".join(_image(place, images) for place in (start, places[0]))


def _image(place: complex, images: Sequence[tuple[complex, str]]) -> str:
    """Name the image nearest to a place; of those that fall on one place the last."""
    if not place:
        return POLE
    return with_index(min(reversed(images), key=lambda image: tied(abs(image[0] - place) / abs(place)))[1])


def statements(equation: Sequence[LeverTerm]) -> Iterator[tuple[str, float]]:
    """Give each arm once, by its letter and its length m/s."""
    yield from {term.arm: term.length for term in equation}.items()
