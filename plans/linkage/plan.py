"""A plan: a board with the images of links on it, which gives any point of any link by similarity (теорема подобия)."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from typing import NamedTuple, TypeVar

from geometry.board import Board, Mark
from geometry.steps import Reading
from plans.linkage.letters import POLES, Letters
from plans.model.mechanism import FRAME, Mechanism
from plans.words.words import because

Key = TypeVar("Key")


class Image(NamedTuple):
    """A link on a plan: the image of one of its points and of one of its vectors; no arm: the link does not turn.

    `at` is the point and `span` the vector in the link's own frame; they are the same on all plans of one position.
    """

    origin: Mark
    arm: Mark | None
    at: complex
    span: complex


class Plan:
    """A plan of positions, velocities or accelerations; `below` are the plans that it rests on."""

    def __init__(self, subject: str, mechanism: Mechanism, below: tuple[Plan, ...] = ()) -> None:
        self.board = Board(subject)
        self.mechanism = mechanism
        self.below = below
        self.images: dict[int, Image] = {}
        self.letters: dict[str, Mark] = {}
        self.placed: dict[tuple[int, complex, str], Mark] = {}  # images of places of links, by the letter they got
        self.readings: dict[int, Reading] = {}
        self.units: dict[tuple[int, int], Mark | None] = {}  # sliding line of (slider, owner): image of its direction
        self.slips: dict[tuple[int, int], Mark] = {}  # velocity of the pin along that line
        self.reaches: dict[tuple[int, int], Mark] = {}  # vector from the pivot of a slotted group to its pin
        self.written: Letters = below[0].written if below else Letters(mechanism)
        self.pole = self.board.given(POLES[subject], 0j, _POLE_WHY[subject])

    @property
    def positions(self) -> Plan:
        """The plan of positions that this one rests on, or is."""
        return self.below[0] if self.below else self

    @property
    def velocities(self) -> Plan:
        """The velocity plan that an acceleration plan rests on."""
        return self.below[1]

    def arm(self, link: int) -> Mark:
        """Give a link's vector on the plan of positions, where every link has one."""
        arm = self.positions.images[link].arm
        assert arm is not None  # a vector's image is missing only where a link does not turn
        return arm

    def trial(self) -> Plan:
        """Give a copy to try an assembly on; the board is shared, what is known of links and points is not."""
        other = copy(self)
        other.images, other.letters, other.placed = dict(self.images), dict(self.letters), dict(self.placed)
        other.units, other.readings = dict(self.units), dict(self.readings)
        return other

    def redraw(self, board: Board, made: Mapping[Mark, Mark], below: tuple[Plan, ...]) -> Plan:
        """Give this plan as it is on another board, whose marks are named by those of this one."""

        def images(known: Mapping[Key, Mark]) -> dict[Key, Mark]:
            return {key: made[mark] for key, mark in known.items()}

        other = copy(self)
        other.board, other.below, other.pole = board, below, made[self.pole]
        other.letters, other.slips, other.reaches = images(self.letters), images(self.slips), images(self.reaches)
        other.placed = {key: made[mark] for key, mark in self.placed.items() if mark in made}  # others may come later
        other.units = {key: mark and made[mark] for key, mark in self.units.items()}
        other.images = {
            link: image._replace(origin=made[image.origin], arm=image.arm and made[image.arm])
            for link, image in self.images.items()
        }
        other.readings = {
            link: Reading(made[reading.arm], made[reading.turning]) for link, reading in self.readings.items()
        }
        return other

    def letter(self, point: str) -> str:
        """Write a point as this plan does: B on the plan of positions, b on the others."""
        return self.written.small(point) if self.below else point

    def name(self, point: str, mark: Mark) -> Mark:
        """Keep a mark as the image of a named point."""
        self.letters[point] = mark
        return mark

    def point(self, point: str) -> Mark:
        """Give the image of a named point, drawn by similarity where it is not drawn yet."""
        if point in self.letters:
            return self.letters[point]
        return self.name(point, self._construct(point))

    def _construct(self, point: str) -> Mark:
        if point in self.mechanism.links[FRAME].points:
            if self.below:
                return self.pole
            return self.board.given(point, self.mechanism.links[FRAME].points[point], because("fixed"))
        link = min(n for n in self.images if point in self.mechanism.links[n].points)
        return self.place(link, self.mechanism.links[link].points[point], self.letter(point))

    def place(self, link: int, local: complex, name: str) -> Mark:
        """Give the image of a point of a link by its place in the link's own frame; once placed it is used again."""
        known = self.placed.get((link, local, name))
        return known or self.placed.setdefault((link, local, name), self._place(link, local, name))

    def _place(self, link: int, local: complex, name: str) -> Mark:
        if link == FRAME:
            return self.pole if self.below else self.board.given(name, local, because("fixed"))
        image = self.images[link]
        if image.arm is None or local == image.at:
            return image.origin
        vector = self.vector(link, local - image.at, f"{image.origin.name}{name}")
        assert vector is not None  # an image with an arm has vectors
        return self.board.lay_off(name, image.origin, vector, because("similar", point=name, link=link))

    def vector(self, link: int, local: complex, name: str) -> Mark | None:
        """Give the image of a vector of a link; None where the link does not turn."""
        if link == FRAME:
            return None if self.below else self.board.given(name, local, because("frame_direction"))
        image = self.images[link]
        if image.arm is None or local == image.span:
            return image.arm
        return self.board.turn(name, image.arm, local / image.span, because("similar_figure", link=link))

    def transport(self, link: int, point: Mark, name: str) -> Mark:
        """Give the image of the point of a link that lies under a point of the plan of positions (переносное)."""
        image = self.images.get(link)
        if link == FRAME or image is None:
            return self.pole
        base = self.positions.images[link]
        if image.arm is None or base.arm is None or point is base.origin:
            return image.origin
        reach = self.positions.board.join(f"{base.origin.name}{point.name}", base.origin, point)
        carried = self.board.similar(
            f"{image.origin.name}{name}", image.arm, base.arm, reach, why=because("turns", link=link)
        )
        return self.board.lay_off(name, image.origin, carried, because("under", link=link, point=point.name))

    def carry(self, mark: Mark) -> Mark:
        """Carry a vector of a plan below to this one with the set square; once carried it is used again."""
        if mark.name in self.board and self.board[mark.name].step.inputs == (mark,):
            return self.board[mark.name]
        return self.board.transfer(mark.name, mark, because("transfer", plan=mark.subject))


_POLE_WHY = {
    "positions": because("drive_hinge"),
    "velocities": because("velocity_pole"),
    "accelerations": because("acceleration_pole"),
}
