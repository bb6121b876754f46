"""The lever on paper: where its forces, their arms and the stand of its pole find room (рычаг Жуковского)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.forces.letters import BALANCE, PAIR, letter_of
from drawings.kinds.outlines import is_centre
from drawings.kinds.polygon import ShownVector
from drawings.layout.parallel_offsets import Segment, merging
from drawings.layout.picture import Place
from drawings.lettering.vector_letters import with_index
from drawings.lettering.words import letter as by_language
from drawings.page.page import Field
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.walk import tied, tied_spot
from drawings.symbols.dimension import LEAST, Arm, to_scale
from drawings.symbols.figure import Subject
from drawings.symbols.force_arrow import ForceArrow, not_to_scale
from drawings.symbols.symbols import STAND
from geometry.board import Mark, at
from plans.forces.cut import Cut, Equation, ForcePlan
from plans.model.motion import NOTHING


class Leverage(NamedTuple):
    """A force's arm about a point, m, in true units; the sense of its moment is +1 counter-clockwise, -1 clockwise.

    The letter is "h_{2}", or "l_{BD}" where the perpendicular is the line between the two named points itself.
    """

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


def leverages(plan: ForcePlan, cut: Cut, column: int) -> tuple[Leverage, ...]:
    """Give the arms of all forces in a cut's equations, the force that each gives last; one without moment has none.

    Letters h are numbered through the cuts of the plan, so that a sheet has each of them once; forces on one line of
    action have one arm.
    """
    arms: list[Leverage] = []
    start = 0
    for one in plan.cuts:
        arms = list(_of(plan, one, column, start))
        if one is cut:
            break
        start += len({arm.letter for arm in arms if arm.dimensioned})
    return tuple(arms)


def largest(plan: ForcePlan, column: int) -> float:
    """Give the largest force of all cuts of a plan, N: what is but rounding beside it is none on any of them."""
    forces = [load.force for cut in plan.cuts for load in cut.loads]
    forces += [support.force for cut in plan.cuts for support in cut.supports]
    return max((abs(at(force.point, column)) for force in forces), default=0.0)


def _of(plan: ForcePlan, cut: Cut, column: int, start: int) -> Iterator[Leverage]:
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
            bare = Leverage(name, about, "", 0.0, 1, pivot, place, value / abs(value))
            moment = ((place - pivot).conjugate() * bare.direction).imag
            if abs(moment) <= NOTHING * abs(place - pivot):
                continue
            letter = _lead(plan, equation, spot, bare) or _number(bare, known, start)
            known.append(bare._replace(letter=letter, length=abs(moment), sense=1 if moment > 0 else -1))
    yield from known


def _terms(equation: Equation) -> Iterator[tuple[str, Mark, Mark]]:
    """Give the forces of an equation, the one that it finds last: name, point, vector."""
    for load in equation.loads:
        yield load.name, load.at, load.force
    if equation.line is not None:
        yield equation.found.name, equation.line.step.inputs[0], equation.found


def _lead(plan: ForcePlan, equation: Equation, spot: Mark, bare: Leverage) -> str:
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
    same = next((other.letter for other in known if _one_line(other, bare)), "")
    return same or f"h_{{{start + len({other.letter for other in known if other.dimensioned}) + 1}}}"


def _one_line(one: Leverage, other: Leverage) -> bool:
    """Tell whether two forces have one line of action and one point of moments."""
    near = NOTHING * abs(one.at - one.pivot)
    return one.about == other.about and abs(one.foot - other.foot) <= near and one.dimensioned


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
    greatest = max((abs(one.value) for one in forces), default=0.0) * max((abs(one.at) for one in forces), default=0.0)
    told, number = list[LeverTerm](), 0
    for name, own in _together(forces).items():
        moment = sum(one.moment for one in own)
        first, size = own[0], abs(own[0].value)
        if not abs(moment) > NOTHING * greatest:
            continue
        length, sense = abs(moment) / size, 1 if moment > 0 else -1
        arm = _line(own, images, length)
        if not arm:
            number += first.kind != BALANCE
            arm = by_language(drafting.language, f"{ARM}_{{{'bal' if first.kind == BALANCE else number}}}")
        letter = _couple(name, drafting) if first.kind == PAIR else letter_of(name, drafting)
        told.append(LeverTerm(name, letter, size, arm, length, sense, first.at, first.direction))
    return tuple(told)


def _together(forces: Sequence[ShownVector]) -> dict[str, list[ShownVector]]:
    """Take both forces of a couple together."""
    own: dict[str, list[ShownVector]] = {}
    for one in forces:
        own.setdefault(one.name, []).append(one)
    return own


def _couple(name: str, drafting: Drafting) -> str:
    """Write a couple's force by its moment and the length of its link's line: M^Φ_4/l_BD."""
    moment, _, line = name.partition("/")
    return f"{letter_of(moment, drafting)}/l_{{{line}}}"


def _line(own: Sequence[ShownVector], images: Sequence[tuple[complex, str]], length: float) -> str:
    """Letter an arm that is a line between two images, or from the pole to one; "" where it is not."""
    places = [one.at for one in own]
    start = places[1] if len(places) > 1 else 0j
    if own[0].kind != PAIR and not abs(abs(places[0] - start) - length) <= NOTHING * length:
        return ""
    return "".join(_image(place, images) for place in (start, places[0]))


def _image(place: complex, images: Sequence[tuple[complex, str]]) -> str:
    """Name the image nearest to a place; of those that fall on one place the last."""
    if not place:
        return POLE
    return with_index(min(reversed(images), key=lambda one: tied(abs(one[0] - place) / abs(place)))[1])


def statements(told: Sequence[LeverTerm]) -> Iterator[tuple[str, float]]:
    """Give each arm once, by its letter and its length m/s."""
    yield from {one.arm: one.length for one in told}.items()


PLAN, SYMBOL, UNIT = "lever", "v", "m/s"
LONGEST, SHORTEST = 26.0, 13.0  # mm, to the factor of the hand's symbols: the greatest force, and one that is nothing
AFTER = 2.0  # mm between two forces that follow one another on one line of action
BESIDE, ASIDES = 7.0, 6  # mm from one perpendicular to the next where they run along one another, and how many at most
FURTHER = 0.2  # what each of them costs
# What speaks against a place of a force: that it runs along another, out of the figure, is away from its image.
ON_FORCE, OUTSIDE, AWAY = 4, 3, 2
STANDS = 12  # directions tried for the stand of the pole
BOTH, PARALLEL = 2, 0.1  # of forces on one line through an image one comes and one goes; parallel to 3 degrees
SAME = 0.5  # mm: places nearer than this are one


class Taken(NamedTuple):
    """Lines on paper that a force should not run along: the rods of the lever, and the forces drawn before."""

    rods: list[Segment]
    forces: list[Segment]
    box: Field  # of the figure


def forces(pushes: Sequence[ShownVector], place: Place, taken: Taken, drafting: Drafting) -> list[ForceArrow]:
    """Place the forces, the greatest first: each from its image or to it, where it runs along no other line."""
    greatest = max((abs(one.value) for one in pushes), default=1.0)
    arrows = []
    for one in sorted(pushes, key=lambda one: -tied(abs(one.value) / greatest)):
        length = (SHORTEST + (LONGEST - SHORTEST) * abs(one.value) / greatest) * drafting.hand.symbol
        arrow = _beside(letter_of(one.name, drafting), one.value, place.on(one.at), length, taken)
        taken.forces.append((arrow.start, arrow.tip))
        arrows.append(arrow)
    return arrows


def _beside(letter: str, force: complex, image: complex, length: float, taken: Taken) -> ForceArrow:
    """Draw a force from its image or to it; where both run along others, further on along its line of action."""
    along, step = force / abs(force), length + AFTER
    tries = [not_to_scale(letter, force, image, length), not_to_scale(letter, force, image, length, ending=True)]
    tries += [not_to_scale(letter, force, image + along * step * k, length, ending=k < 0) for k in (1, -1, 2, -2)]

    def cost(arrow: ForceArrow) -> int:
        ends = arrow.start, arrow.tip
        over = ON_FORCE * sum(merging(ends, other) for other in taken.forces)
        over += OUTSIDE * (not _within(arrow.free, taken.box))
        return over + any(merging(ends, rod) for rod in taken.rods) + AWAY * (abs(arrow.at - image) > SAME)

    return min(tries, key=cost)


def _within(spot: complex, box: Field) -> bool:
    spot = tied_spot(spot)
    return box.left <= spot.real <= box.right and box.bottom <= spot.imag <= box.top


def reach(pushes: Sequence[ShownVector]) -> float:
    """Give how far forces reach from their images, mm: one of their length, or two where many share a line there."""
    lines = [(tied_spot(one.at), one.direction**2) for one in pushes]
    most = max((sum(at == image and abs(way - own) < PARALLEL for image, way in lines) for at, own in lines), default=0)
    return LONGEST + (SHORTEST + AFTER if most > BOTH else 0.0)


def arms(terms: Sequence[LeverTerm], place: Place, taken: Taken, column: int) -> list[Arm]:
    """Draw the arms of forces, the longest last: each square to its force, aside where it would run along others."""
    subject, lines = Subject(PLAN, SYMBOL, column), [*taken.rods, *taken.forces]
    kept = []
    for one in sorted((one for one in terms if one.dimensioned), key=lambda one: tied(place.length(one.length))):
        arm = to_scale(one.arm, place.on(0j), place.on(one.at), one.direction, place.scale, subject)
        if arm.length < LEAST:
            continue
        arm = _aside(arm, lines, taken.box)
        lines.append(arm.ends)
        kept.append(arm)
    return kept


def _aside(arm: Arm, lines: Sequence[Segment], box: Field) -> Arm:
    """Give the nearest place of an arm where its line runs along no other."""

    def cost(trial: Arm) -> float:
        over = ON_FORCE * sum(merging(trial.ends, other) for other in lines)
        outside = OUTSIDE * sum(not _within(end, box) for end in trial.ends)
        return over + outside + FURTHER * abs(trial.aside) / BESIDE

    steps = (sign * k * BESIDE for k in range(ASIDES + 1) for sign in (1, -1))
    return min((arm._replace(aside=step) for step in steps), key=cost)


def downward(lines: list[Segment], pole: complex, hand: Hand) -> complex:
    """Turn the stand of the pole to where no line runs; downward if it can be."""
    depth = STAND[0] * hand.symbol
    turns = sorted((math.remainder(math.tau * k / STANDS, math.tau) for k in range(STANDS)), key=abs)

    def clear(turn: float) -> float:
        return min((_distance(pole - 1j * depth * cmath.rect(1.0, turn), line) for line in lines), default=math.inf)

    free = [turn for turn in turns if clear(turn) > (STAND[1] + STAND[2]) * hand.symbol]
    return -1j * cmath.rect(1.0, free[0] if free else max(turns, key=clear))


def _distance(spot: complex, line: Segment) -> float:
    start, along = line[0], line[1] - line[0]
    share = ((spot - start) * along.conjugate()).real / abs(along) ** 2 if along else 0.0
    return abs(spot - start - along * min(max(share, 0.0), 1.0))
