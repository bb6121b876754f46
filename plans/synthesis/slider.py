"""A slider-crank from its stroke: each demand is a locus of O beside the chord, and O where two loci meet (M1.6)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from geometry.board import Board, Mark, Span, between
from plans.model.motion import Floats
from plans.model.synthesis.design import EPS, QUARTER, BarredArc, Design, unit_of
from plans.model.synthesis.extremes import SliderTask
from plans.model.synthesis.region import Region, stations
from plans.quantity import Shown
from plans.synthesis.chord import SYNTHESIS, DrawnCrank, ExtremeChord, circle_of, read
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure
from plans.synthesis.pace import paced
from plans.synthesis.search import PLACED, best_of, crossed
from plans.words.words import because

FARTHEST = 0.9999  # share of the way to infinity: there a rod all but lies along the guide
NEARBY, ROUNDED = 1e-7, 64 * EPS  # of a place, about which it is tried how steeply an angle changes; roundings of it
FIGURE = SynthesisFigure(
    ("O", "A_1", "B_1"),
    (("O", "A_2", "B_2"),),
    hinges=frozenset(("A_1", "A_2", "B_1", "B_2")),
    fixed=frozenset("O"),
    blocks={"B_1": 1 + 0j, "B_2": 1 + 0j},
    axes=(("B_2", "B_1"),),
    lengths=(("H", "B_2", "B_1"),),
)


def drawn(task: SliderTask) -> tuple[DrawnReading, ...]:
    """Draw each reading of a task."""
    found = (_similar(one) if one.similar else _met(one) for one in task.readings)
    return tuple(paced(one, task.pace) for one in found)


def _met(task: SliderTask) -> DrawnReading:
    chord = _chord(task)
    loci = dict(_loci(chord, task))
    pivots = (pair for pair in _pivots(chord, task, loci) if _admits(chord, pair[0]))
    made = [_drawn(task, chord, read(chord, pivot), loci, place) for pivot, place in pivots]
    return DrawnReading(task.demands, chord.board, tuple(sorted(made, key=lambda one: -one.design.sizes["l_1"])))


def _chord(task: SliderTask) -> ExtremeChord:
    board = Board(SYNTHESIS)
    folded = board.given("B_2", complex(-task.stroke / 2, 0.0), because("guide_end"))
    along = board.given("H", complex(task.stroke, 0.0), because("stroke_given"))
    return ExtremeChord.between(board, board.lay_off("B_1", folded, along), folded)


def _pivots(chord: ExtremeChord, task: SliderTask, loci: Mapping[str, Mark]) -> Iterator[tuple[Mark, float | None]]:
    """Put O where two loci meet, or at an angle on one."""
    first, *others = loci.values()
    places = _leaning(task) if task.pressure is not None else () if task.turned is None else (task.turned,)
    for name, place in zip(("O", "O'"), places, strict=False):
        yield _at(chord, task, first, place, name), place
    for name, side in (("O", -1.0), ("O'", 1.0)) if others else ():
        yield chord.board.meet(name, first, others[0], side, because("pivot_loci")), None


def _at(chord: ExtremeChord, task: SliderTask, locus: Mark, place: Floats | float, name: str = "O") -> Mark:
    """Put O on its only locus: an angle rad from B2 on the circle, or a share of the way along the parallel."""
    board, why = chord.board, because("chosen_place")
    if task.overlap:
        near = complex(between(board["M"], chord.folded))
        ray = board.given(f"{name}:r", np.exp(1j * (cmath.phase(near) + place)), why)
        return board.divide(name, locus, ray, because("pivot_place"))
    far = task.stroke / 2 + (task.stroke + (task.offset or 0.0)) * place / (1 - np.asarray(place))
    return board.lay_off(
        name, board["E_e"], board.turn(f"{name}:x", chord.along, -far + 0j, why), because("pivot_place")
    )


def _leaning(task: SliderTask) -> list[float]:
    """Try where on its locus O has the pressure angle: on the circle before the best place and beyond it."""
    asked = QUARTER - (task.pressure or 0.0)
    ends = (0.0, _best(task)[0], math.pi - 2 * task.overlap) if task.overlap else (0.0, FARTHEST)
    value = partial(_led, task, asked)
    return [place for least, most in pairwise(ends) for place in crossed(value, least, most)]


def _led(task: SliderTask, asked: float, places: Floats) -> Floats:
    return _sizes_over(task, places)["μ_min"] - asked


def _loci(chord: ExtremeChord, task: SliderTask) -> Iterator[tuple[str, Mark]]:
    """Give the loci of O; no offset and no overlap are one demand: O on the line of the chord."""
    if task.overlap:
        yield "M", chord.seen(task.overlap, 1)
    if task.ratio is not None:
        yield "N", chord.proportioned(task.ratio)
    if task.offset or not (task.overlap or task.turned):
        yield "e", chord.offset(task.offset or 0.0)


def _admits(chord: ExtremeChord, pivot: Mark) -> Any:
    """Tell whether O is before the chord, not above it: over it B1 and B2 are of two assemblies."""
    from_folded = np.asarray(between(pivot, chord.folded))
    return (from_folded.real > 0) & (from_folded.imag >= 0)  # no meeting is not a number, and no more than anything


def _drawn(
    task: SliderTask, chord: ExtremeChord, crank: DrawnCrank, loci: dict[str, Mark], place: float | None
) -> DrawnDesign:
    """Read a mechanism; O is below the guide by the offset."""
    board = chord.board
    first, rod = (float(length) for length in crank.lengths)
    guide, across = (
        board.parallel(f"{crank.pivot.name}:g", chord.middle, chord.along),
        board.square(f"{crank.pivot.name}:e", crank.pivot, chord.along),
    )
    foot = board.meet(f"{crank.pivot.name}:F", guide, across, why=because("offset_read"))
    offset = complex(between(crank.pivot, foot)).imag
    theta, arm = crank.overlap
    stroke = abs(complex(between(chord.folded, chord.stretched)))
    shown: dict[str, Shown] = {"l_1": crank.crank, "l_2": crank.coupler, "e": Span(crank.pivot, foot), "θ": crank.seen}
    centres = {name: mark for name, mark in loci.items() if name != "e"}
    dividing = ("D_1", "D_2") if "N" in loci else ()
    points = {name: complex(board[name].point) for name in ("E", *centres, *dividing)}
    points |= {"F": complex(foot.point)} if offset else {}
    circles = {name: circle_of(mark) for name, mark in centres.items()}
    lines = tuple((end, "M") for end in ("B_1", "B_2") if "M" in centres)
    sizes = _sizes(first, rod, offset, stroke, theta)
    figure = FIGURE._replace(lines=lines)
    within = dict[str, float]()
    if place is not None and task.pressure is not None:
        moved = _wear(task, place)
        within = {
            name: moved / (1.0 if unit_of(name) == "m" else arm) * (sizes["λ"] if name == "λ" else 1.0)
            for name in sizes
        }
    elif len(loci) == 1 and centres:
        rays = [complex(between(board["M"], one)) for one in (chord.folded, crank.pivot)]
        sizes["γ"] = cmath.phase(rays[1] / rays[0]) % math.tau
        figure = figure._replace(lines=(*lines, ("O", "M")), angles=(("γ", "M", "B_2", "O"),))
    design = Design(sizes, crank.places | points, circles, _barred(chord, centres))
    return _made(design, shown, arm, figure)._replace(within=within)


def _barred(chord: ExtremeChord, centres: dict[str, Mark]) -> tuple[BarredArc, ...]:
    """Give the arcs above the chord and under it: from there B1 and B2 are not both seen ahead."""
    if "M" not in centres:
        return ()
    far, near = (complex(between(chord.board["M"], end)) for end in (chord.stretched, chord.folded))
    sweep = cmath.phase(near / far)
    return BarredArc("M", cmath.phase(far), sweep), BarredArc("M", cmath.phase(-far), sweep)


def _sizes(crank: float, rod: float, offset: float, stroke: float, theta: float) -> dict[str, float]:
    """Tell what is read off, and what follows: the rod leans most with the crank square to the guide."""
    least, most = (math.asin((offset + sense * crank) / rod) for sense in (-1, 1))
    sizes = {"l_1": crank, "l_2": rod, "e": offset, "H": stroke, "θ": theta}
    return sizes | {"λ": rod / crank, "α_max": most, "α_min": least}


def _made(design: Design, shown: Mapping[str, Shown], arm: float, figure: SynthesisFigure) -> DrawnDesign:
    rod = design.sizes["l_2"]
    arms = {name: math.cos(design.sizes[name]) * rod for name in ("α_max", "α_min")}
    if "F" in design.places:
        figure = figure._replace(axes=(("F", "B_1"),), lengths=(*figure.lengths, ("e", "F", "O")))
    if design.sizes["θ"]:
        figure = figure._replace(angles=(("θ", "O", "B_1", "B_2"), *figure.angles))
    return DrawnDesign(design, shown, {"θ": arm, **arms}, figure)


def _similar(task: SliderTask) -> DrawnReading:
    """Draw a mechanism of the crank 1 that has ratio and pressure angle, and measure how much larger the stroke is."""
    assert task.pressure is not None  # asked before
    board, sine = Board(SYNTHESIS), math.sin(task.pressure)
    ratio = 1 / sine if task.ratio is None else task.ratio
    unit = board.given("l_1:1", 1 + 0j, because("unit_crank"))
    pivot = board.given("O:1", 0j)
    long = board.turn("l_2:1", unit, ratio, because("times_ratio", ratio=f"{ratio:.6g}"))
    height = 0.0 if task.ratio is None else ratio * sine - 1
    if height < 0:
        return DrawnReading(task.demands, board, ())
    up = board.turn("e:1", unit, 1j * height, because("offset_pressure"))
    middle = board.lay_off("E:1", pivot, up)
    guide = board.parallel("e:l", middle, unit, because("offset_line"))
    places = [_end(board, pivot, guide, unit, long, sense) for sense in (1, -1)]
    steep = board.lay_off("A:1", pivot, board.turn("OA:1", unit, -1j, because("steep_crank")))
    lean = board.arc("A:o", steep, np.abs(long.point))
    there = board.meet("B:1", guide, lean, 1.0, because("steep_rod"))
    crank = read(ExtremeChord.between(board, *places), pivot)
    scale = task.stroke / abs(complex(board.join("H:1", places[1], places[0], because("unit_stroke")).point))
    why = because("times_stroke", times=f"{scale:.6g}")
    shown = {
        one.name.removesuffix(":1"): board.turn(one.name.removesuffix(":1"), one, scale, why)
        for one in (unit, long, up)
    }
    first, rod, offset = (abs(complex(one.point)) for one in shown.values())
    theta, arm = crank.overlap
    led = {"E": middle, "A": steep, "B": there}
    spots = {name: scale * spot for name, spot in crank.places.items()} | {
        name: scale * complex(mark.point) for name, mark in led.items()
    }
    design = Design(_sizes(first, rod, offset, task.stroke, theta), spots)
    figure = FIGURE._replace(lines=(("O", "A"), ("A", "B")))
    return DrawnReading(task.demands, board, (_made(design, shown, scale * arm, figure),))


def _end(board: Board, pivot: Mark, guide: Mark, crank: Mark, rod: Mark, sense: int) -> Mark:
    reach = abs(complex(rod.point)) + sense * abs(complex(crank.point))
    arc = board.arc(f"O:{sense}", pivot, reach, because("extreme_reach"))
    return board.meet("B_1" if sense > 0 else "B_2", guide, arc, 1.0, because("extreme_place"))


def with_best(task: SliderTask) -> SliderTask:
    """Give a task of an overlap alone with the place of O whose least transmission angle is the largest."""
    if task.demands != ("overlap",) or not task.overlap:
        return task
    return task._replace(turned=round(_best(task)[0], PLACED))


def _best(task: SliderTask) -> tuple[float, float]:
    assert task.overlap is not None  # asked before
    return best_of(lambda turned: _sizes_over(task, turned)["μ_min"], 0.0, math.pi - 2 * task.overlap)


def region(task: SliderTask, design: Design) -> Region | None:
    """Move O over the arc, where it is free: from B2 to the middle of the circle, as far as it is before the chord."""
    if task.turned is None or task.overlap is None:
        return None
    end = math.pi - 2 * task.overlap
    places = stations(end)
    curves = _sizes_over(task, places)
    return Region(places, curves, end, math.pi - task.overlap, _best(task), design.sizes["γ"])


def _sizes_over(task: SliderTask, turned: Floats) -> dict[str, Floats]:
    """Give sizes with O at some angles rad from B2 on: the least transmission angle first; NaN where none is."""
    chord = _chord(task)
    (locus,) = dict(_loci(chord, task)).values()
    at = _at(chord, task, locus, turned)
    with np.errstate(invalid="ignore", divide="ignore"):
        crank, rod = read(chord, at).lengths
        offset = -np.asarray(at.point).imag
        rows = {"μ_min": np.arccos((offset + crank) / rod), "λ": rod / crank, "ε": offset / task.stroke}
    return {name: np.where(_admits(chord, at), row, np.nan) for name, row in rows.items()}


def _wear(task: SliderTask, place: float) -> float:
    """Give how far rounding may move O where it is tried for a pressure angle: far where that is all but the least."""
    around = place + np.array([-NEARBY, NEARBY])
    chord = _chord(task)
    (locus,) = dict(_loci(chord, task)).values()
    moved = abs(complex(np.ptp(np.asarray(_at(chord, task, locus, around).point))))
    turned = abs(float(np.ptp(_sizes_over(task, around)["μ_min"])))
    return ROUNDED * moved / max(turned, ROUNDED)
