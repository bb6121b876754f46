"""The region of a free parameter: a size over the place of O, where none is admitted, the best (область параметра)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.kinds import curve_graph
from drawings.kinds.axes import Letter, Part
from drawings.kinds.curve_graph import ANGLE, GraphCurve
from drawings.kinds.graph import BESIDE, Graph, GraphForm, standing
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.words import fixed, with_index
from drawings.page.page import Drafting
from drawings.paper.strokes import Line
from drawings.symbols.symbols import TICK, ground
from drawings.synthesis.due import BEST, region_name, told_in
from plans.model.synthesis.region import Region

FORM = GraphForm(1.6, 1.6, Margins(3.2, 2.4, 1.0), 14.0)
LETTER, STEP = "γ", 30  # degrees from number to number
APART = 3.0  # sizes of a number from one ordinate's to the next, at least


class ShownRegion(NamedTuple):
    """One curve of a region, by its letter."""

    letter: str
    region: Region


def shown(region: Region | None) -> Iterator[ShownRegion]:
    """Give a graph for each curve."""
    if region is not None:
        yield from (ShownRegion(letter, region) for letter in region.curves)


def _curve(found: ShownRegion, drafting: Drafting) -> GraphCurve:
    region, (times, unit) = found.region, told_in(found.letter)
    angles = np.degrees([*region.places, region.whole])
    values = np.array([*(times * region.curves[found.letter]), math.nan])
    none, axis = np.array([]), (LETTER, ANGLE[1])
    title, name = drafting.word(f"synthesis over {found.letter}"), region_name(found.letter)
    letter = with_index(found.letter)
    return GraphCurve(
        letter, unit or "1", angles, values, none, none, title, axis=axis, name=name, states=found.letter, form=FORM
    )


def measure(found: ShownRegion, drafting: Drafting) -> Picture:
    """Measure the room of the graph."""
    return curve_graph.measure(_curve(found, drafting), drafting)


def draw(found: ShownRegion, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the graph; where no O is admitted its axis is hatched, and the best O has its ordinate."""
    curve, hand = _curve(found, drafting), drafting.hand
    part = curve_graph.draw(curve, room, spot, drafting)
    graph = Graph(room.name, standing(room, spot, curve.span, (curve.symbol, curve.unit), drafting), hand)
    region, times = found.region, told_in(found.letter)[0]
    end, whole = (graph.axes.on(math.degrees(one)) for one in (region.end, region.whole))
    lines = [*part.lines, *(ground(end, whole, -1j, hand) if whole.real > end.real else ())]
    letters = [*part.letters]
    marks = {"O": region.chosen, BEST: region.best[0]}
    if abs(marks["O"] - marks[BEST]) * math.degrees(1) < curve.angles[-1] * 1e-3:
        del marks[BEST]
    for turned in range(0, math.floor(curve.angles[-1]), STEP):
        lines.append(graph.tick(turned))
        letters.append(graph.number(turned, str(turned)))
    for value, places in _ordinates(curve.span, APART * hand.number * graph.axes.up.mu):
        at, half = graph.axes.on(0.0, value), TICK * graph.axes.along
        lines.append(Line(at - half, at + half, hand.drafted))
        letters.append(Letter(at, fixed(value, drafting.language, places), hand.number, math.pi, TICK + BESIDE))
    for name, place in marks.items():
        x = math.degrees(place)
        value = times * float(np.interp(place, region.places, region.curves[found.letter]))
        lines += [*graph.ordinate(x, value, name), graph.dot(x, value)]
        letters.append(Letter(graph.axes.on(x, value), with_index(name), hand.letter, math.pi / 2))
    return part._replace(lines=tuple(lines), letters=tuple(letters))


def _ordinates(span: tuple[float, float], least: float) -> Iterator[tuple[float, int]]:
    """Give round ordinates, no nearer to each other than the least, and their decimals.

    >>> [*_ordinates((0.0, 50.0), 12.0)], [*_ordinates((0.0, 0.5), 0.11)]
    ([(20.0, 0), (40.0, 0)], [(0.2, 1), (0.4, 1)])
    """
    power = math.floor(math.log10(least))
    step = next(one * 10.0**power for one in (1, 2, 5, 10) if one * 10.0**power >= least)
    whole = range(math.ceil(span[0] / step), math.floor(span[1] / step) + 1)
    yield from ((k * step, max(-math.floor(math.log10(step)), 0)) for k in whole if k)
