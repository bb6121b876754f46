"""What balances on the lever: each force or couple with its arm about the pole, lettered (члены уравнения рычага)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.figures.forces.force_kinds import BALANCE, PAIR
from drawings.figures.forces.force_letters import letter_of
from drawings.lettering.indices import with_index
from drawings.lettering.words import letter as by_language
from drawings.page.drafting import Drafting
from drawings.symbols.polygon import ShownVector
from plans.model.kinetostatics import NOTHING

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


def terms(forces: Sequence[ShownVector], images: Mapping[complex, str], drafting: Drafting) -> tuple[LeverTerm, ...]:
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


def _line(own: Sequence[ShownVector], images: Mapping[complex, str], length: float) -> str:
    """Letter an arm that is a line between two images, or from the pole to one; "" where it is not."""
    places = [one.at for one in own]
    start = places[1] if len(places) > 1 else 0j
    if own[0].kind != PAIR and not abs(abs(places[0] - start) - length) <= NOTHING * length:
        return ""
    return "".join(_image(place, images) for place in (start, places[0]))


def _image(place: complex, images: Mapping[complex, str]) -> str:
    return with_index(images[min(images, key=lambda true: abs(true - place))]) if place else POLE


def statements(told: Sequence[LeverTerm]) -> Iterator[tuple[str, float]]:
    """Give each arm once, by its letter and its length m/s."""
    yield from {one.arm: one.length for one in told}.items()
