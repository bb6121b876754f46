"""Guides (направляющие): the slides of a scene, each as two lines in the frames of its links."""

import cmath
from collections.abc import Mapping
from decimal import Context, Decimal, localcontext
from math import pi
from typing import NamedTuple

from geometry.meet import cross
from plans.linkage.reading.fields import LineTable, split_letters
from plans.linkage.reading.form import SlideTable
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.mechanism import FRAME, Slide, Way
from plans.scene.faults import Path, suggestion
from plans.scene.units import EXACT, WORKING
from plans.words.words import message

Spot = tuple[Decimal, Decimal]  # a place in a link's own frame, or measured from the datum: exact metres


class Shaper(NamedTuple):
    """Gives links their shapes; `places` are the rough places at the first position, measured from the datum."""

    survey: LinkageSurvey
    places: dict[str, complex]

    def shape(self, link: int) -> dict[str, Spot]:
        """Place a moving link's points in its own frame; points that cannot be placed are left out and reported."""
        names = self.survey.points_of[link]
        spots: dict[str, Spot] = {names[0]: (Decimal(0), Decimal(0))}
        letters = self.survey.form.mechanism.links[link]
        for index, name in enumerate(names[1:], 1):
            placed = self._placed(link, name)
            if index == 1 and name in letters:
                first = next(iter(spots))
                size = self.length(first, name)
                if size is not None:
                    spots[name] = (size, Decimal(0))
                elif self._placed(link, name) is None:
                    self._lacks(link, first, name)
            elif placed:
                spots[name] = placed
            else:
                self._third(link, name, spots)
        return spots

    def _placed(self, link: int, name: str) -> Spot | None:
        point = self.survey.form.mechanism.points.get(name)
        return point.at if point and point.on == link else None

    def length(self, *ends: str) -> Decimal | None:
        """Give the length between two points, in either order of its letters."""
        key = self.survey.lengths.get(frozenset(ends))
        return self.survey.form.mechanism.lengths[key] if key else None

    def _lacks(self, link: int, first: str, name: str) -> None:
        if not self.survey.may_lack(first, name):
            self.survey.report(("mechanism", "links", str(link)), "no_length", name=line_name(first, name), link=link)

    def _third(self, link: int, name: str, spots: dict[str, Spot]) -> None:
        first, second = self.survey.points_of[link][:2]
        near, far = self.length(first, name), self.length(second, name)
        if near is None or far is None:
            lacking = [(end, name) for end, size in ((first, near), (second, far)) if size is None]
            doubted = any(self.survey.may_lack(*ends) for ends in lacking)
            if not doubted and not self.survey.doubtful(("mechanism", "points", name)):
                path, lengths = ("mechanism", "links", str(link)), tuple(line_name(*ends) for ends in lacking)
                self.survey.report(path, "no_place", name=name, link=link, lengths=lengths)
            return
        if second not in spots:
            return  # the base of the triangle is at fault already
        height = triangle(spots[second][0], near, far)
        if height is None:
            self._open(first, second, name, spots[second][0], near)
            return
        side = self._side(link, name) if height[1] else 1
        if side:
            spots[name] = (height[0], height[1] * side)

    def _open(self, first: str, second: str, name: str, base: Decimal, near: Decimal) -> None:
        path = ("mechanism", "lengths", self.survey.lengths[frozenset((second, name))])
        least, most = EXACT.abs(EXACT.subtract(base, near)), EXACT.add(base, near)
        others = (line_name(first, second), line_name(first, name))
        self.survey.report(path, "open_triangle", name=path[2], least=plain(least), most=plain(most), others=others)

    def _side(self, link: int, name: str) -> int:
        """Tell on which side of the link's axis the sketch shows a point: 1 left, -1 right, 0 where it cannot."""
        first, second = self.survey.points_of[link][:2]
        unseen = [point for point in (first, second, name) if point not in self.places]
        turn = 0.0
        if not unseen:
            start = self.places[first]
            turn = float(cross(self.places[second] - start, self.places[name] - start))
        if turn:
            return 1 if turn > 0 else -1
        if not self.survey.doubtful(
            *(("mechanism", table, point) for table in ("sketch", "frame") for point in unseen), ("drive",)
        ):
            reason = message("side.no_place", points=", ".join(unseen)) if unseen else message("side.in_line")
            path = ("mechanism", "links", str(link))
            points = ", ".join(unseen) or name
            line = line_name(first, second)
            self.survey.report(path, "side", line=line, name=name, reason=reason, points=points, link=link)
        return 0


def triangle(base: Decimal, near: Decimal, far: Decimal) -> Spot | None:
    """Give foot and height of a triangle on its base, by the sides from its two ends; nothing if it does not close.

    >>> triangle(Decimal(5), Decimal(3), Decimal(4))
    (Decimal('1.8'), Decimal('2.4'))
    """
    if EXACT.add(near, far) < base or EXACT.abs(EXACT.subtract(near, far)) > base:
        return None
    if EXACT.add(near, base) == far:
        return -near, Decimal(0)
    if base in (EXACT.add(near, far), EXACT.subtract(near, far)):
        return near, Decimal(0)
    with localcontext(WORKING):
        foot = ((near - far) * (near + far) / base + base) / 2
        area = (near + far + base) * (near + far - base) * (base + near - far) * (base - near + far)
        return foot, area.sqrt() / (2 * base)


def line_name(first: str, second: str) -> str:
    """Name a line by its ends as the key of a length: AB, or crank-pin for longer names."""
    return first + second if split_letters(first + second) == (first, second) else f"{first}-{second}"


def plain(number: Decimal) -> str:
    """Write a number without exponent or needless zeros, in at most 12 figures."""
    return f"{Context(prec=12).plus(number).normalize():f}"


def as_complex(spot: Spot) -> complex:
    """Round an exact place to the nearest floats, once."""
    return complex(float(spot[0]), float(spot[1]))


# Directions of whole right angles have exact unit numbers.
RIGHT_ANGLES = {Decimal(0): 1 + 0j, Decimal(90): 1j, Decimal(180): -1 + 0j, Decimal(270): -1j}


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


class Guides(NamedTuple):
    """Makes the slides (направляющие) of a scene from its links' shapes."""

    survey: LinkageSurvey
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
