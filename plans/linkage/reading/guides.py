"""Guides (направляющие): the slides of a scene, each as two lines in the frames of its links."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from math import pi

from plans.linkage.reading.form import SlideTable
from plans.linkage.reading.line import LineTable
from plans.linkage.reading.shapes import Spot, as_complex, line_name
from plans.linkage.reading.survey import Survey
from plans.model.mechanism import FRAME, Slide, Way
from plans.scene.faults import Path, suggestion
from plans.scene.units import EXACT
from plans.words.words import message

# Directions of whole right angles have exact unit numbers.
RIGHT_ANGLES: Mapping[Decimal, complex] = {
    Decimal(0): 1 + 0j,
    Decimal(90): 1j,
    Decimal(180): -1 + 0j,
    Decimal(270): -1j,
}


def direction(angle: Decimal) -> complex:
    """Give the unit vector at an angle in degrees; whole right angles exactly.

    >>> direction(Decimal(450)), direction(Decimal(-180))
    (1j, (-1+0j))
    """
    turn = EXACT.remainder(angle, Decimal(360))
    turn = EXACT.add(turn, Decimal(360)) if turn < 0 else turn
    return RIGHT_ANGLES[turn] if turn in RIGHT_ANGLES else cmath.rect(1.0, float(turn) * pi / 180)


def from_datum(place: Spot, datum: Spot) -> Spot:
    """Measure a place from the datum, exactly."""
    return EXACT.subtract(place[0], datum[0]), EXACT.subtract(place[1], datum[1])


@dataclass(frozen=True)
class Guides:
    """Makes the slides (направляющие) of a scene from its links' shapes."""

    survey: Survey
    shapes: Mapping[int, Mapping[str, Spot]]
    datum: Spot

    def slides(self) -> tuple[Slide, ...]:
        """Give all slides whose links, points and lines are known; report the others."""
        made = (self._slide(index, table) for index, table in enumerate(self.survey.form.mechanism.slides))
        return tuple(slide for slide in made if slide)

    def _slide(self, index: int, table: SlideTable) -> Slide | None:
        path: Path = ("mechanism", "slides", index)
        if not self.survey.know_link((*path, "link"), table.link):
            return None
        point = table.point or self.survey.points_of[table.link][0]
        known = self.survey.on_link((*path, "point"), table.link, point)
        line = self._line((*path, "along"), table)
        spot = self.shapes[table.link].get(point)
        if not known or line is None or spot is None:
            return None
        owner, on_owner, label = line
        course = direction(EXACT.minus(table.angle))
        on_slider = Way(as_complex(spot) - float(table.offset) * 1j * course, course)
        return Slide(table.link, owner, on_slider, on_owner, point, label)

    def _line(self, path: Path, table: SlideTable) -> tuple[int, Way, str] | None:
        along = table.along
        if isinstance(along, LineTable):
            way = self._by_angle(path, along, table.link)
            return None if way is None else (along.link, way, "")
        if not self.survey.know(path, along):
            return None
        owner = self._owner(path, along, table.link)
        if owner is None:
            return None
        spots = [self.shapes[owner].get(name) for name in along]
        if spots[0] is None or spots[1] is None:
            return None  # the link's shape is at fault already
        if spots[0] == spots[1]:
            self.survey.report(path, "no_direction", first=along[0], second=along[1])
            return None
        run = as_complex(from_datum(spots[1], spots[0]))
        return owner, Way(as_complex(spots[0]), run / abs(run)), line_name(*along)

    def _by_angle(self, path: Path, line: LineTable, slider: int) -> Way | None:
        """Give a line of the frame or of a link by its point and its angle."""
        if line.link == slider:
            self.survey.report((*path, "link"), "not_itself")
        elif self._known(path, line):
            spot = line.place(self.shapes[line.link])
            return None if spot is None else self._through(line, spot)  # without one its shape is at fault already
        return None

    def _through(self, line: LineTable, spot: Spot) -> Way:
        course = direction(line.angle)
        if line.link != FRAME:
            return Way(as_complex(spot), course)
        through = as_complex(from_datum(spot, self.datum) if isinstance(line.through, tuple) else spot)
        # The point nearest to the datum: a guide may be named by one that is far away.
        return Way(1j * course * (course.conjugate() * through).imag, course)

    def _known(self, path: Path, line: LineTable) -> bool:
        """See that the link of a line exists, and that the letter it goes through is of that link."""
        name, survey = line.letter, self.survey
        if line.link != FRAME and not survey.know_link((*path, "link"), line.link):
            return False
        if name is None:
            return True
        if not survey.know((*path, "through"), (name,)):
            return False
        owners = survey.owners((name,))
        if "link" not in line.given and owners and FRAME not in owners:
            survey.report((*path, "through"), "line_of_link", name=name, link=owners[0])
            return False
        return survey.on_link((*path, "through"), line.link, name)

    def _owner(self, path: Path, along: tuple[str, ...], slider: int) -> int | None:
        owners = self.survey.owners(along)
        others = [link for link in owners if link != slider]
        if len(others) == 1:
            return others[0]
        if self.survey.doubtful(("mechanism", "links"), ("mechanism", "points"), ("mechanism", "frame")):
            return None
        if others:
            self.survey.report(path, "many_owners", links=", ".join(map(str, others)))
        elif owners:
            self.survey.report(path, "not_itself")
        else:
            lines = {line_name(*points[:2]): link for link, points in self.survey.points_of.items() if len(points) > 1}
            advice = suggestion(line_name(*along), lines, message("advice.two_points"))
            self.survey.report(path, "no_common_link", first=along[0], second=along[1], suggestion=advice)
        return None
