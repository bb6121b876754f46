"""The centrodes of two links on the scheme of a position, where the one touches the other (центроиды)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.centres.scheme import DOT, LETTERS, MARGINS
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Picture, Spot
from drawings.linkage.pose import Pose, letters, measured, scheme
from drawings.linkage.skeleton import Pairs
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Circle, Kind, LineStyle, Polyline, Statement, Stroke
from drawings.paper.walk import stating
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import fit_dashes
from plans.centres.centrodes import Window, named, plan_of, window
from plans.centres.kennedy import Pair, letter
from plans.model.motion import Complexes

BESIDE = 1.5  # mm from a centrode to its letter


class ShownCentrodes(NamedTuple):
    """The centrodes of two links in a position: on both links, which stand as they do there."""

    bones: Pose
    pair: Pair
    column: int
    paths: Mapping[int, Complexes]  # true places, m
    centre: complex | None  # where they touch; None: at infinity there

    @property
    def plan(self) -> str:
        """What its marks belong to."""
        return plan_of(self.pair)

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"{self.plan}-{self.column}"

    @property
    def window(self) -> Window:
        """What the figure shows of them."""
        return window(self.bones.points)

    @property
    def pieces(self) -> dict[str, tuple[int, Complexes]]:
        """The pieces of both, each by its name, with its link."""
        both = ((link, named(path, link, self.window)) for link, path in self.paths.items())
        return {name: (link, piece) for link, found in both for name, piece in found.items()}

    @property
    def touching(self) -> complex | None:
        """Where they touch, if that is shown."""
        middle, most = self.window
        return self.centre if self.centre is not None and abs(self.centre - middle) <= most else None


def stood(bones: Pose, pair: Pair, k: int, paths: Mapping[int, Complexes], touching: complex | None) -> ShownCentrodes:
    """Show centrodes, given in the axes of their links, as these stand in a position."""
    bases = {link: [complex(bones.numbered.of(link, local)[0]) for local in (0j, 1 + 0j)] for link in pair}
    places = {link: start + paths[link] * (end - start) for link, (start, end) in bases.items()}
    return ShownCentrodes(bones, pair, k, places, touching)


def measure(shown: ShownCentrodes, drafting: Drafting) -> Picture:
    """Measure the room of a scheme with centrodes."""
    known = [*shown.bones.points, *(complex(spot) for _, piece in shown.pieces.values() for spot in piece)]
    known += [] if shown.touching is None else [shown.touching]
    return measured(shown.name, known, _title(shown, drafting), (MARGINS, LETTERS), drafting)


def draw(shown: ShownCentrodes, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot: the centrode of the lower link in full, that of the other one dashed."""
    place, hand = room.place(*spot), drafting.hand
    pairs, subject = Pairs(shown.bones, place, hand), Subject(shown.plan, "r", shown.column)
    styles = dict(zip(shown.pair, (hand.relative, hand.path), strict=True))
    lines = [heading(spot.box, _title(shown, drafting), drafting.scale(spot.scale), hand)]
    for name, (link, piece) in shown.pieces.items():
        spots = np.asarray(place.origin + (piece - place.zero) / place.scale.mu)
        lines.append(stating(Statement(Kind.CURVE, shown.plan, name, shown.column), *_line(spots, styles[link])))
    drawn = [*lines, *scheme(pairs, subject)]
    if shown.touching is not None:
        circle = Circle(place.on(shown.touching), DOT * hand.symbol, INK)
        drawn.append(point(subject, letter(shown.pair), shown.touching, place, circle))
    return LetteredFigure(shown.name, tuple(drawn), partial(_letters, shown, pairs))


def _line(spots: Complexes, style: LineStyle) -> Iterator[Stroke]:
    closed = bool(abs(spots[0] - spots[-1]) < DOT)
    yield from fit_dashes([Polyline(tuple(map(complex, spots[:-1] if closed else spots)), closed, style)])


def _title(shown: ShownCentrodes, drafting: Drafting) -> str:
    first, second = shown.pair
    return drafting.word("centrodes title", first=first, second=second, position=shown.column)


def _letters(shown: ShownCentrodes, pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    """Letter the points, where they touch, and each centrode once, along its longest piece."""
    touching = shown.touching
    yield from letters(pairs, [] if touching is None else [(touching, [letter(shown.pair)])], labels)
    longest = dict(sorted(shown.pieces.values(), key=lambda one: len(one[1])))
    for link, piece in longest.items():
        k = int(np.argmax(np.abs(piece - (touching if touching is not None else piece[0]))))
        ahead = complex(piece[min(k + 1, len(piece) - 1)] - piece[max(k - 1, 0)])
        side = cmath.phase(ahead) - math.pi / 2
        yield labels.beside(pairs.place.on(complex(piece[k])), f"p_{{{link}}}", pairs.sheet.letter, BESIDE, side)
