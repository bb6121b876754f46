"""The self-check of the angles of the output's strokes on a plan of positions: phases, swing (фазовые углы, размах)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.linkage.laid import LaidMechanism
from drawings.checks.linkage.position_marks import EXACT, named
from drawings.checks.wrong import on
from drawings.figures.linkage.swing import LETTER
from drawings.lettering.words import fixed
from drawings.paper.strokes import Arc, Fill, Leaf, Text
from drawings.symbols.symbols import HEAD
from plans.model.mechanism import FRAME
from plans.model.motion import Extremes
from plans.model.order import POSITIONS
from plans.words.words import Message, word

ROOMY, HEADS = 0.45, 5.0  # share of a rocker's arm, and heads along the arc there, at which a swing has room
INDICES = ("index.work", "index.idle")  # of the crank's angle over either stroke


class Sector(NamedTuple):
    """An angle that a plan may show: its letter, its centre on paper, where it begins and how far it goes, rad."""

    letter: str
    centre: complex
    start: float
    sweep: float

    @property
    def middle(self) -> float:
        """The direction of its middle."""
        return self.start + self.sweep / 2

    def text(self, language: str) -> str:
        """Write it with its size, as lettering is read."""
        return Text(0j, f"{self.letter} = {self.size(language)}").plain

    def size(self, language: str) -> str:
        """Write its size alone."""
        return f"{fixed(math.degrees(abs(self.sweep)), language)}°"


class Arrow(NamedTuple):
    """An arc with a head as it is drawn: its arc, and the tip of its head."""

    arc: Arc
    tip: complex

    def runs(self, sector: Sector, start: float, end: float) -> bool:
        """Tell whether it runs about a sector's centre from one direction to the other, rad."""
        arc, swept = self.arc, abs(end - start)
        tail = arc.at(0.0 if end > start else 1.0)  # drawn counter-clockwise, whichever way it points
        spots = ((arc.radius, start, tail), (arc.radius, end, self.tip))
        off = max(abs(sector.centre + cmath.rect(radius, turn) - spot) for radius, turn, spot in spots)
        return off <= EXACT and 0.0 <= swept - arc.sweep <= 2 * HEAD[0] / arc.radius


def faults(leaf: Leaf, laid: LaidMechanism, extremes: Extremes | None) -> Iterator[Message]:
    """Hold the arcs of the strokes' angles and of the swing against the analysis."""
    if extremes is None:
        return
    labels = labels_of(leaf.groups)
    for name, sectors, halves in (("phases", _phases(laid, extremes), 1), ("swing", _swing(laid, extremes), 2)):
        arrows = list(_arrows(leaf, name))
        shown = [(one, _radius(one, arrows, halves)) for one in sectors]
        lost = any(radius is None for _, radius in shown) and (bool(arrows) or _must(name, laid, sectors))
        if lost or len(arrows) != halves * sum(radius is not None for _, radius in shown):
            yield on("arc", POSITIONS.plan, name=name)
        for one, radius in shown:
            text = one.text(laid.study.language)
            spot = one.centre + cmath.rect(radius or 0.0, one.middle)
            if radius is not None and not distance(labels.get(text, ()), (spot,)) <= NEAREST:
                yield on("arc", POSITIONS.plan, name=text)


def _must(name: str, laid: LaidMechanism, sectors: list[Sector]) -> bool:
    """Tell whether arcs must be there: phases where the strokes differ or count, a swing that has room for them."""
    study = laid.study
    if name == "swing":
        arm = max(abs(laid.on(study.output.link, own) - sectors[0].centre) for own in _tips(laid))
        return ROOMY * arm * abs(sectors[0].sweep) >= HEADS * HEAD[0]
    asked = study.scene.has(("output", "working"))
    both = study.travel is not None and len(study.travel.rests) == 2
    return asked or (both and len({one.size(study.language) for one in sectors}) > 1)


def _tips(laid: LaidMechanism) -> list[complex]:
    """Give the output's point whose places are numbered, in its own frame."""
    own = laid.mechanism.links[laid.study.output.link].points
    return [own[laid.study.output.point]] if laid.study.output.point else [own[name] for name in list(own)[-1:]]


def _arrows(leaf: Leaf, name: str) -> Iterator[Arrow]:
    for group in named(leaf, name):
        for arc, head in pairwise(group.strokes):
            if isinstance(arc, Arc) and isinstance(head, Fill):
                yield Arrow(arc, head.points[0])


def _radius(sector: Sector, arrows: list[Arrow], halves: int) -> float | None:
    """Give the radius at which a sector is shown, by one arrow or by two from its middle; None if it is not."""
    start, end = sector.start, sector.start + sector.sweep
    ways = [(start, end)] if halves == 1 else [(sector.middle, start), (sector.middle, end)]
    radii = [arrow.arc.radius for way in ways for arrow in arrows if arrow.runs(sector, *way)]
    return radii[0] if len(radii) == halves else None


def _phases(laid: LaidMechanism, extremes: Extremes) -> list[Sector]:
    """Give the crank's angles over the working and the idle stroke."""
    mechanism, sense = laid.mechanism, laid.study.sense
    centre = laid.at.on(mechanism.links[FRAME].points.get(mechanism.drive.pivot, 0j))
    letters = (f"φ_{{{word(laid.study.language, index)}}}" for index in INDICES)
    spans = zip(letters, extremes.phi, extremes.phi[::-1], strict=True)
    return [Sector(one, centre, start, sense * ((sense * (end - start)) % (2 * math.pi))) for one, start, end in spans]


def _swing(laid: LaidMechanism, extremes: Extremes) -> list[Sector]:
    """Give the swing of a rocker by that of its point whose places are numbered; none of a slider."""
    links, (low, high) = laid.mechanism.links, extremes.reach
    own, fixed_points = links[laid.study.output.link].points, links[FRAME].points
    pivot = next((name for name in own if name in fixed_points), None)
    tip = laid.study.output.point or next((name for name in reversed(list(own)) if name not in fixed_points), None)
    if extremes.sliding or pivot is None or tip is None or tip == pivot:
        return []
    arm = own[tip] - own[pivot]
    return [Sector(LETTER, laid.at.on(fixed_points[pivot]), low + cmath.phase(arm), high - low)]
