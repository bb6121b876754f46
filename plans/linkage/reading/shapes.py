"""The shapes of links: every point in its link's own frame, from lengths, triangles and the sketch's side."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Context, Decimal, localcontext

from geometry.meet import cross
from plans.linkage.reading.fields import split_letters
from plans.linkage.reading.survey import Survey
from plans.scene.units import EXACT, WORKING
from plans.words.words import message

Spot = tuple[Decimal, Decimal]  # a place in a link's own frame, or measured from the datum: exact metres


@dataclass(frozen=True)
class Shaper:
    """Gives links their shapes; `places` are the rough places at the first position, measured from the datum."""

    survey: Survey
    places: dict[str, complex]

    def shape(self, link: int) -> dict[str, Spot]:
        """Place a moving link's points in its own frame; points that cannot be placed are left out and reported."""
        names = self.survey.points_of[link]
        spots: dict[str, Spot] = {names[0]: (Decimal(0), Decimal(0))}
        letters = self.survey.form.mechanism.links[link]
        for index, name in enumerate(names[1:], 1):
            placed = self._placed(link, name)
            if index == 1 and name in letters:
                self._second(link, name, spots)
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

    def _second(self, link: int, name: str, spots: dict[str, Spot]) -> None:
        first = next(iter(spots))
        size = self.length(first, name)
        if size is not None:
            spots[name] = (size, Decimal(0))
        elif self._placed(link, name) is None:
            self._lacks(link, first, name)

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
