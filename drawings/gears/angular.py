"""The plan of angular velocities: through its pole parallels to the lines of links (план угловых скоростей)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.gear_letters import link_letters
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Drafting
from drawings.paper.strokes import Line, Stroke, Text
from drawings.symbols.figure import Subject, around, heading, heading_width, point
from drawings.symbols.symbols import pole
from plans.gears.kutzbach import KutzbachPlan
from plans.model.gears import FRAME

MARGINS = Margins(2.4, 3.0, 3.4)  # paper around it for letters, in their sizes
LETTERS = 16.0  # it is drawn at least so many letters large
PAST = 0.06  # of its height: how far rays go past their ends
SAME = 0.4  # mm: ends nearer than this are one
BESIDE = 0.8  # mm


class ShownAngular(NamedTuple):
    """The plan of angular velocities of a gear: rad/s, its pole at 1/tau under the line."""

    name: str
    title: str
    plan: KutzbachPlan

    @property
    def ends(self) -> dict[str, complex]:
        """The ends of the links' segments."""
        return {link: complex(complex(mark.point).real, 0) for link, mark in self.plan.level_speeds.items()}

    @property
    def pole(self) -> complex:
        """The pole."""
        return complex(0, -1 / self.plan.tau)


def measure(shown: ShownAngular, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    title = heading_width(shown.title, drafting.hand)
    corners = [0j, shown.pole, *shown.ends.values()]
    return picture(
        shown.name, corners, ("ω", "rad/s"), around(MARGINS, drafting.hand), title, LETTERS * drafting.hand.letter
    )


def draw(shown: ShownAngular, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the line, the rays from the pole, and the ends that they cut off."""
    place, hand = room.place(*spot), drafting.hand
    size = drafting.slot(Slot(f"K {shown.name}", place.length(abs(shown.pole))))
    far = joined("", ("K = ", size, f" {drafting.word('mm')}"))
    title = heading(spot.box, shown.title, drafting.scale(spot.scale), hand)
    across = [0.0, *(end.real for end in shown.ends.values())]
    past = PAST * abs(shown.pole)
    base = Line(place.on(complex(min(across) - past)), place.on(complex(max(across) + past)), hand.result)
    rays = (Line(place.on(shown.pole), place.on(end), hand.other) for end in dict.fromkeys((0j, *shown.ends.values())))
    subject, zero = Subject(shown.name, "ω", None), pole(place.on(0j))
    marks = [point(subject, FRAME, 0j, place, zero, "pole")]
    marks.append(point(subject, "P", shown.pole, place, pole(place.on(shown.pole)), "pole"))
    for link, end in shown.ends.items():
        if _shared(shown, end, place).split(", ")[0] == link:  # of links that turn alike the first bears the mark
            marks.append(point(subject, f"ω_{link}", end, place, pole(place.on(end)), title=link))
    under = place.on(shown.pole) - 1j * (2.2 * hand.text)
    beside = telling(shown.name, Text(under, far, hand.text, "middle", True), far)
    return LetteredFigure(shown.name, (title, base, *rays, *marks, beside), partial(_letters, shown, place, drafting))


def _shared(shown: ShownAngular, end: complex, place: Place) -> str:
    """Letter an end by all links whose ends fall on it, the frame first."""
    every = {FRAME: 0j} | shown.ends
    return ", ".join(link for link, other in every.items() if place.length(abs(other - end)) < SAME)


def _letters(shown: ShownAngular, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    hand = drafting.hand
    for text, end in {_shared(shown, end, place): end for end in (0j, *shown.ends.values())}.items():
        names = ", ".join(map(link_letters, text.split(", ")))
        yield labels.beside(place.on(end), names, hand.letter, BESIDE, math.pi / 2)
    yield labels.beside(place.on(shown.pole), "P", hand.letter, BESIDE, math.pi)
