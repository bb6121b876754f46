"""The tachogram: the speed of the crank over time, from rest to rest, its stages marked (тахограмма)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.kinds.axes import BEYOND, OVER, UNDER, Axes, Letter, Part
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import Slot, joined, telling
from drawings.page.scale import Drafting, fitting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Group, Line, Polyline, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import TICK
from plans.model.run import Run
from plans.words.words import word

NAME = "tachogram"
RATIO = 2.2  # it is drawn so many times as long as it is high
TALLER = 1.8  # times as high as that, where there is room
MARGINS = Margins(4.0, 2.0, 2.4)  # paper around it for letters, in their sizes
LETTERS = 20.0  # it is drawn at least so many letters long
CLOSE = 0.1  # mm: rows that lie nearer are one point of the curve
LEAST = 0.05  # mm: a shorter ordinate is a point
NUMBERS = f"{NAME}-numbers"  # the name of what is told under its heading
STEADY = "ω_{st}"  # the mean speed of the steady motion that is reached: not the one that is asked for
APART = 1.6  # sizes of a text from one line to the next


class TachogramFigure:
    """A tachogram placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    def __init__(self, part: Part) -> None:
        self.part = part

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        return self.part.lines

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, lettered."""
        return (self.part.group(labels),)


def measure(run: Run, drafting: Drafting) -> Picture:
    """Measure the room of a tachogram: its scale is that of time."""
    hand, long = drafting.hand, float(run.t[-1])
    side, below, above = (size * hand.letter for size in MARGINS)
    lines = told(run, drafting)
    over = above + BEYOND + 2 * hand.title + (1 + APART * len(lines)) * hand.text
    title = text_width(Text(0j, drafting.word("tachogram"), hand.title))
    wide = max(title, *(text_width(Text(0j, line, hand.text)) for line in lines))
    high, margins = long / RATIO, Margins(side + BEYOND / 2, below, over)
    return Picture(
        NAME, long, high, complex(long, high) / 2, "t", "s", margins, wide, LETTERS * hand.letter, taller=TALLER
    )


def draw(run: Run, room: Picture, spot: Spot, drafting: Drafting) -> TachogramFigure:
    """Draw it in its spot: the speed over time, the ends of its stages measurable, the mean of the steady motion."""
    room, hand, most = room.filling(spot), drafting.hand, float(run.omega.max())
    up = fitting(most, room.high / spot.scale.mu, "ω", "rad/s", drafting.standard)
    under = room.high / spot.scale.mu - most / up.mu  # what the scale leaves over lies below, not above
    axes = Axes(room.place(*spot).on(0j) + 1j * under, spot.scale, up)
    scales = f"{drafting.scale(spot.scale)};  {drafting.scale(up)}"
    lines = (
        heading(spot.box, drafting.word("tachogram"), scales, hand),
        _written(run, spot, drafting),
        *axes.lines((0.0, float(run.t[-1])), (0.0, most), hand, NAME),
        stating(Statement(Kind.CURVE, NAME, "ω"), Polyline(tuple(_curve(run, axes)), False, hand.result)),
        *(stroke for k, row in enumerate(ends(run)) for stroke in _end(run, k, row, axes, hand)),
        *_mean(run, axes, hand),
    )
    return TachogramFigure(Part(NAME, lines, tuple(_letters(run, axes, most, drafting))))


def ends(run: Run) -> tuple[int, ...]:
    """Give the rows in which the stages end."""
    return tuple(stage.last for stage in run.stages)


def told(run: Run, drafting: Drafting) -> tuple[str, ...]:
    """Tell the instants at which the stages end, s, and the steady speed that is reached, rad/s."""
    times = (
        joined("", (f"t_{k} = ", drafting.slot(Slot(f"t_{k}", float(run.t[row])))))
        for k, row in enumerate(ends(run), 1)
    )
    instants = joined(" ", (joined(";  ", times), drafting.word("s")))
    if run.steady is None:
        return (instants,)
    numbers = {"mean": Slot(STEADY, run.steady.mean), "delta": Slot("δ", run.steady.delta)}
    return instants, drafting.phrase("steady speed", **numbers)


def _written(run: Run, spot: Spot, drafting: Drafting) -> Group:
    """Write under the heading what the tachogram tells."""
    hand, box = drafting.hand, spot.box
    at = complex(box.centre.real, box.top - 1.6 * hand.title - hand.text)
    texts = (
        telling(NAME, Text(at - 1j * APART * k * hand.text, line, hand.text, "middle", True))
        for k, line in enumerate(told(run, drafting), 1)
    )
    return Group((Group(tuple(texts)),), NUMBERS)


def _curve(run: Run, axes: Axes) -> Iterator[complex]:
    """Give the points of the curve, those left out that lie close to the last one."""
    last = complex(math.inf)
    for k, (t, omega) in enumerate(zip(run.t.tolist(), run.omega.tolist(), strict=True)):
        place = axes.on(t, omega)
        if abs(place - last) > CLOSE or k in ends(run):
            yield place
            last = place


def _end(run: Run, k: int, row: int, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the end of a stage: its tick and its ordinate, which can be measured."""
    t, omega = float(run.t[row]), float(run.omega[row])
    foot, tip = axes.on(t), axes.on(t, omega)
    yield Line(foot - TICK * 1j, foot + TICK * 1j, hand.drafted)
    if abs(tip - foot) > LEAST:
        data = Subject(NAME, axes.up.letter, None).data("vector", f"t_{k + 1}", 1j * omega, axes.up)
        yield Group((Line(foot, tip, hand.drafted),), "", data, f"t_{k + 1}")


def _mean(run: Run, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the mean of the steady motion across the whole of it."""
    if run.steady is not None:
        line = Line(axes.on(0.0, run.steady.mean), axes.on(float(run.t[-1]), run.steady.mean), hand.axis)
        yield stating(Statement(Kind.CURVE, NAME, STEADY), line)


def _letters(run: Run, axes: Axes, most: float, drafting: Drafting) -> Iterator[Letter]:
    """Letter the axes, the stages at their middles, the instants at which they end, the mean speed."""
    size = drafting.hand.letter
    yield Letter(axes.on(0.0, most) + BEYOND * 1j, f"ω, {drafting.word('rad/s')}", size, 0.0)
    yield Letter(axes.on(float(run.t[-1])) + BEYOND, f"t, {drafting.word('s')}", size, OVER)
    if run.steady is not None:
        yield Letter(axes.on(float(run.t[-1]), run.steady.mean), drafting.letter(STEADY), size, 0.0)
    for k, stage in enumerate(run.stages):
        yield Letter(axes.on(float(run.t[stage.last])), f"t_{k + 1}", size, UNDER, TICK + 0.6)
        middle = float(np.mean(run.t[[stage.first, stage.last]]))
        yield Letter(axes.on(middle, most / 4), _named(stage.name, drafting), drafting.hand.text, OVER)


def _named(stage: str, drafting: Drafting) -> str:
    """Give the name of a stage."""
    return word(drafting.language, f"run.{stage.replace('-', '_')}")
