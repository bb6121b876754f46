"""Curves on the scheme of a position: the centrodes of two links, the inflection circle of one (центроиды, круг)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.centres.scheme import DOT, LETTERS, MARGINS
from drawings.kinds.vector_plan import SAME
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Picture, Place, Spot
from drawings.lettering.words import with_index
from drawings.linkage.pose import Pose, letters, measured, scheme
from drawings.linkage.skeleton import Pairs
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Circle, Kind, Line, LineStyle, Polyline, Statement, Stroke
from drawings.paper.walk import stating, tied_spot
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import arrowhead, fit_dashes
from geometry.board import at
from plans.centres.centrodes import Window, named, plan_of, window
from plans.centres.curvature import circle_of, curvature_plan
from plans.centres.kennedy import Pair, letter
from plans.centres.study import CentresStudy
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes

BESIDE = 1.5  # mm from a curve to its letter
BUILT = ("Q", "J")  # letters of Bobillier's points: of collineation axes, of inflection
TANGENT = 0.35  # sizes of the mechanism to both sides of the pole, that the common tangent is drawn long


class ShownCurves(NamedTuple):
    """Curves in a position, with points and lines of their construction."""

    bones: Pose
    column: int
    plan: str  # what their marks belong to
    title: str
    paths: Mapping[str, Complexes]  # true places, m; every other one is dashed
    marked: Mapping[str, complex]
    lines: tuple[tuple[complex, complex], ...] = ()
    beside: tuple[tuple[complex, str], ...] = ()  # letters of lines, at their ends
    built: Mapping[str, complex] = {}  # points of the construction alone

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"{self.plan}-{self.column}"

    @property
    def window(self) -> Window:
        """What the figure shows of them."""
        return window(self.bones.points)

    @property
    def pieces(self) -> dict[str, tuple[str, Complexes]]:
        """The pieces that are shown, each by its name, with its curve."""
        both = ((name, named(path, name, self.window)) for name, path in self.paths.items())
        return {piece: (name, spots) for name, found in both for piece, spots in found.items()}

    @property
    def near(self) -> dict[str, complex]:
        """The points that are shown."""
        middle, most = self.window
        return {name: spot for name, spot in {**self.marked, **self.built}.items() if abs(spot - middle) <= most}

    @property
    def away(self) -> list[tuple[str, tuple[complex, complex]]]:
        """The shown part of each line to a point that lies off the figure, with the point's letter."""
        far = {spot: name for name, spot in {**self.marked, **self.built}.items() if name not in self.near}
        lines = (line for line in self.lines if line[1] in far and abs(line[0] - self.window[0]) <= self.window[1])
        return [(far[line[1]], self._within(*line)) for line in lines]

    @property
    def drawn(self) -> list[tuple[complex, complex]]:
        """The lines, as far as they are shown."""
        return [self._within(*line) for line in self.lines if abs(line[0] - self.window[0]) <= self.window[1]]

    def _within(self, start: complex, end: complex) -> tuple[complex, complex]:
        middle, most = self.window
        if abs(end - middle) <= most:
            return start, end
        way, off = (end - start) / abs(end - start), start - middle
        along = (off * way.conjugate()).real
        return start, start + way * (math.sqrt(along**2 + most**2 - abs(off) ** 2) - along)


def centrodes(study: CentresStudy, pair: Pair, bones: Pose, k: int, drafting: Drafting) -> ShownCurves:
    """Show the centrodes of two links as these stand in a position, and where they touch."""
    bases = {link: [complex(bones.numbered.of(link, local)[0]) for local in (0j, 1 + 0j)] for link in pair}
    made = study.centrodes[pair]
    paths = {f"p_{link}": start + made.path(link) * (end - start) for link, (start, end) in bases.items()}
    title = drafting.word("centrodes title", first=pair[0], second=pair[1], position=k)
    return ShownCurves(bones, k, plan_of(pair), title, paths, _centre(study, pair, k))


def curvature(study: CentresStudy, name: str, bones: Pose, k: int, drafting: Drafting) -> ShownCurves:
    """Show the inflection circle of a link, and Bobillier's construction of a centre of curvature."""
    link, title = study.curving[name], drafting.word("curvature title", point=name, position=k)
    marked, circle, found = _centre(study, (FRAME, link), k), study.inflection(k, link), study.curvature(k, name)
    if circle is None:
        return ShownCurves(bones, k, curvature_plan(name), title, {}, marked)
    pole, end, tangent = (at(mark.point, 0) for mark in (circle.pole, circle.inflection, circle.tangent))
    lines = [*circle.lines, *(found.lines if found else ())]
    spots = {mark: at(mark.point, 0) for line in lines for mark in line}
    places = [(spots[one], spots[other]) for one, other in lines]
    reach = tangent / abs(tangent) * TANGENT * study.at(k).size
    places += [(pole, pole + reach), (pole, pole - reach)]
    marked |= {circle.inflection.name: end} | ({found.centre.name: spots[found.centre]} if found else {})
    built = {mark.name: spot for mark, spot in spots.items() if mark.name.partition("_")[0] in BUILT}
    shown = ShownCurves(bones, k, curvature_plan(name), title, {f"i_{link}": circle_of(pole, end)}, marked)
    shown = shown._replace(lines=_from_near(places), built=built)
    tips = {tied_spot(tip): (tip, with_index(far)) for far, (_, tip) in shown.away}.values()  # some share their line
    away = ((tip, drafting.word("centre far", letter=far)) for tip, far in tips)
    start, tip = dict(shown.away).get(circle.inflection.name, (pole, end))
    diameter = start + (tip - start) / 3, with_index(circle.diameter.name)  # clear of its middle, where a pin may be
    own = ((pole + reach, "t"), diameter) if circle.pole.name in shown.near else ()
    return shown._replace(beside=(*own, *away))


def _from_near(lines: list[tuple[complex, complex]]) -> tuple[tuple[complex, complex], ...]:
    """Direct lines so that they begin at the end that is nearer to the frame's origin: the other may be far off."""
    return tuple((one, two) if abs(one) <= abs(two) else (two, one) for one, two in lines)


def _centre(study: CentresStudy, pair: Pair, k: int) -> dict[str, complex]:
    centre = study.at(k).found.get(pair)
    return {} if centre is None or centre.infinite else {letter(pair): centre.place}


def measure(shown: ShownCurves, drafting: Drafting) -> Picture:
    """Measure the room of a scheme with curves."""
    known = [*shown.bones.points, *(complex(spot) for _, piece in shown.pieces.values() for spot in piece)]
    known += [*shown.near.values(), *(spot for line in shown.drawn for spot in line)]
    return measured(shown.name, known, shown.title, (MARGINS, LETTERS), drafting)


def draw(shown: ShownCurves, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot: the first curve in full, the second one dashed."""
    place, hand = room.place(*spot), drafting.hand
    pairs, subject = Pairs(shown.bones, place, hand), Subject(shown.plan, "r", shown.column)
    styles = dict(zip(shown.paths, (hand.relative, hand.path), strict=False))
    lines: list[Stroke] = [heading(spot.box, shown.title, drafting.scale(spot.scale), hand)]
    for name, (curve, piece) in shown.pieces.items():
        strokes = _line(piece, place, styles[curve])
        lines.append(stating(Statement(Kind.CURVE, shown.plan, name, shown.column), *strokes))
    paper = [(place.on(start), place.on(end)) for start, end in shown.drawn]
    lines += [Line(start, end, hand.drafted) for start, end in paper if abs(end - start) > SAME]
    lines += filter(None, (arrowhead(place.on(a), place.on(b), hand.symbol) for _, (a, b) in shown.away))
    lines += scheme(pairs, subject)
    for name, spot_of in shown.near.items():
        circle = Circle(place.on(spot_of), DOT * hand.symbol, INK)
        lines.append(circle if name in shown.built else point(subject, name, spot_of, place, circle))
    return LetteredFigure(shown.name, tuple(lines), partial(_letters, shown, pairs))


def _line(piece: Complexes, place: Place, style: LineStyle) -> Iterator[Stroke]:
    spots = np.asarray(place.origin + (piece - place.zero) / place.scale.mu)
    closed = bool(abs(spots[0] - spots[-1]) < DOT)
    yield from fit_dashes([Polyline(tuple(map(complex, spots[:-1] if closed else spots)), closed, style)])


def _letters(shown: ShownCurves, pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Letter points and lines, and each curve once, along its longest piece."""
    size, place = pairs.sheet.letter, pairs.place
    yield from letters(pairs, ((spot, [name]) for name, spot in shown.near.items()), labels)
    for spot, text in shown.beside:
        yield labels.beside(place.on(spot), text, size, BESIDE, math.pi / 2)
    longest = dict(sorted(shown.pieces.values(), key=lambda one: len(one[1])))
    for name, piece in longest.items():
        touching = next(iter(shown.near.values()), complex(piece[0]))
        k = int(np.argmax(np.abs(piece - touching)))
        ahead = complex(piece[min(k + 1, len(piece) - 1)] - piece[max(k - 1, 0)])
        side = cmath.phase(ahead) - math.pi / 2
        yield labels.beside(place.on(complex(piece[k])), with_index(name), size, BESIDE, side)
