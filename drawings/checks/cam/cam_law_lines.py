"""The lines and words of a law's diagrams: axes, ticks, poles, dimensions, letters (линии диаграмм закона)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from drawings.checks.cam.cam_expected import Expected, phase_name
from drawings.checks.cam.cam_law_rows import means
from drawings.checks.cam.cam_laws import LawGraph, named
from drawings.checks.cam.cam_units import UNITS
from drawings.checks.graphs.figure_strokes import FLUSH, figure
from drawings.checks.graphs.linework import FAR, Dimensioned, Linework, Way
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.law_graph import MARKED
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Line
from drawings.symbols.symbols import TICK
from plans.model.cam import TABLE, Cam

KEYS = ("travel", "velocity", "acceleration")  # by the order of the derivative


def lines(leaf: Leaf, graphs: tuple[LawGraph, ...], expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold all straight lines, heads, dots and words of the rows, their poles, the phases under them."""
    for number, one in enumerate(graphs):
        above = graphs[number - 1] if number else None
        yield from _row(one, above, drafting)
    for number, (above, below) in enumerate(pairwise(graphs), 1):
        yield from _pole(leaf, number, above, below, drafting)
    yield from _phases(leaf, graphs, expected.cam, drafting)


def _row(one: LawGraph, above: LawGraph | None, drafting: Drafting) -> Iterator[Wrong]:
    work = Linework(one.name, one.strokes, drafting.hand.symbol)
    yield from work.ways([*_axes(one), *_uprights(one)])
    yield from work.heads()
    tops = [one.on(0.0, max(one.row.most, 0.0)), one.on(one.expected.cam.turn)]
    for top, way in zip(tops, (1j, 1.0), strict=True):
        if not any(work.headed(tip) and abs(((tip - top) / way).imag) <= FLUSH for tip, _ in work.tips):
            yield on("head", one.name, name="φ" if way == 1.0 else one.row.letter)
    yield from work.dots("edge", _dots(one))
    yield from _words(work, one, above, drafting)


def _axes(one: LawGraph) -> Iterator[Way]:
    least = min(float(one.row.after.min()), float(one.row.before.min()), 0.0)
    most = max(float(one.row.after.max()), float(one.row.before.max()), 0.0)
    yield Way("φ", one.zero, one.on(one.expected.cam.turn), FAR)
    yield Way(one.row.letter, one.on(0.0, least), one.on(0.0, most), FAR)


def _uprights(one: LawGraph) -> Iterator[Way]:
    """Give the tick of each edge that has one, and its ordinate or the arrow of its impulse."""
    count = len(one.expected.edges)
    most = one.row.most / one.mu
    for k in range(count) if count <= MARKED + 1 else sorted(one.numbered):
        foot = one.on(float(one.expected.edges[k]))
        yield Way(one.expected.names[k], foot - 1j * TICK, foot + 1j * TICK)
        yield Way(one.expected.names[k], foot, one.on(float(one.expected.edges[k]), float(one.row.after[k])), due=False)
    for turned, sense in one.row.impulses:
        foot = one.on(turned)
        yield Way("∞", foot, foot + 1j * sense * max(most, 1.0), FAR, due=False)


def _dots(one: LawGraph) -> Iterator[complex]:
    """Give the places of points: at the edges, and of tables on the lowest row."""
    for k, edge in enumerate(one.expected.edges.tolist()):
        yield from (one.on(edge, float(side[k])) for side in (one.row.after, one.row.before))
    for phase in one.expected.cam.moving() if one.row.key == "travel" else ():
        if phase.law is not None and phase.law.name == TABLE:
            for share, s in phase.law.points:
                yield one.on(phase.start + share * phase.angle, phase.level + s * phase.change)


def _words(work: Linework, one: LawGraph, above: LawGraph | None, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the title with its scales, the letters of the axes, what is told; numbers are held with the rows."""
    cam, row = one.expected.cam, one.row
    unit = UNITS[cam.rocks, cam.translates][KEYS.index(row.key)]
    turn, turned = ("x", "m") if cam.translates else ("φ", "rad")
    scales = [scale_line(one.mu, f"{{{row.letter}}}", unit, drafting)] if row.most else []
    if above is None:
        scales.append(scale_line(one.along, turn, turned, drafting))
    elif row.most and above.row.most:
        number = KEYS[::-1].index(row.key)
        distance = one.mu / (above.mu * above.along)
        scales.append(f"H_{number} = {drafting.number(distance)} {drafting.word('mm')}")
    letter = f"{row.letter}, {drafting.word(unit)}" if unit != "1" else row.letter
    title = f"{drafting.word(f'law {row.key}')} {row.letter}"
    due = [title, letter, turn, *([";  ".join(scales)] if scales else [])]
    told = [text for text in one.strokes.texts if one.tells(text)]
    yield from work.words(due, [*one.expected.names, "∞", *told])
    ends = [tip for tip, back in work.tips if abs((tip - back).real) <= FLUSH and abs((tip - one.zero).real) <= FLUSH]
    if not one.strokes.lettered(row.letter, ends):
        yield on("letter", one.name, name=row.letter)
    ends = [tip for tip, back in work.tips if abs((tip - back).imag) <= FLUSH]
    if not one.strokes.lettered(turn, ends):
        yield on("letter", one.name, name=turn)


def _pole(leaf: Leaf, number: int, above: LawGraph, below: LawGraph, drafting: Drafting) -> Iterator[Wrong]:
    """Hold what a pole is drawn of: its base, rays, what they carry, the dimension of its distance."""
    strokes = figure(leaf, named(above.expected.cam, f"{above.row.key}-pole"))
    if strokes is None:
        return
    work = Linework(above.name, strokes, drafting.hand.symbol)
    at = above.zero - below.mu / (above.mu * above.along)
    middles = (above.expected.edges[:-1] + above.expected.edges[1:]) / 2
    due = [Way(f"P_{number}", at, above.zero)]
    for place, mean in zip(middles.tolist(), means(above.expected, above.row.key).tolist(), strict=True):
        tip = above.on(0.0, mean)
        due += [Way("", at, tip, due=False), Way("", tip, above.on(place, mean), due=False)]
    for one in work.dimensions([Dimensioned(f"H_{number}", at, above.zero, 1j)]):
        if isinstance(one, Way):
            due.append(one)
        else:
            yield one
    yield from work.ways(due)
    yield from work.heads()
    yield from work.dots(f"P_{number}", [at])
    yield from work.words([f"P_{number}", f"H_{number}"])


def _phases(leaf: Leaf, graphs: tuple[LawGraph, ...], cam: Cam, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the dimensions of the phases, and that their bounds go through all rows."""
    name, last = named(cam), graphs[-1]
    strokes = figure(leaf, named(cam, "phases"))
    if strokes is not None:
        work = Linework(name, strokes, drafting.hand.symbol)
        letters = [phase_name(cam, k, drafting) for k in range(len(cam.phases))]
        sizes = [
            Dimensioned(letter, last.on(one.start), last.on(one.end), -1j)
            for letter, one in zip(letters, cam.phases, strict=True)
        ]
        found = [*work.dimensions(sizes)]
        yield from (one for one in found if not isinstance(one, Way))
        yield from work.ways([one for one in found if isinstance(one, Way)])
        yield from work.heads()
        yield from work.words(letters)
    bounds = figure(leaf, named(cam, "bounds"))
    for phase in cam.phases[1:]:
        feet = [graph.on(phase.start) for graph in graphs]
        run = () if bounds is None else bounds.lines
        if not all(any(_over(line, foot) for line in run) for foot in feet):
            yield on("line_named", name, name="φ")


def _over(line: Line, foot: complex) -> bool:
    """Tell whether an upright line goes over a place."""
    low, high = sorted((line.start.imag, line.end.imag))
    return abs(line.start.real - foot.real) <= FLUSH and low - FLUSH <= foot.imag <= high + FLUSH
