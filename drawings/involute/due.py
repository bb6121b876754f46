"""What must stand on the sheet of an involute pair, by formulas alone (лист эвольвентной передачи)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import NOTES, Expected, by_hand, cells, measured
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.involute import flank, sliding
from plans.involute.quantities import SIZES as SIZED
from plans.involute.study import InvoluteStudy
from plans.model.involute import InvolutePair, PairSizes
from plans.model.motion import Complexes
from plans.model.teeth import placed, racked
from plans.quantity import Comparison, Quantity
from plans.quantity import by_hand as slipping
from plans.study import Study

MESH, GENERATION, SLIDING, PAIR, SIZES, DATA = "mesh", "generation", "sliding", "pair", "sizes", "data"
MILLIMETRES = 3  # decimals
UNITS = {"m": (1e3, "mm"), "rad": (math.degrees(1.0), "°"), "1": (1.0, "")}  # times which a quantity is told, in which
DIGITS, TOLD = 9, 5  # enough for all decimals of data and notes; digits beside a slip
SHARES = 4  # decimals of modules, degrees
FAR = 1e-9  # of a place: both roads agree far better
POINTS = 81  # of a flank
EXACT = 12  # decimals of a module: what is less is rounding, where the axes are as far apart as without shift
LEAST, BEYOND = -2.0, 1.5  # the graph goes down at least so far, or so many times the largest sliding
FINE = {"α", "α_w", "y", "Δy", "x_Σ", "k", "u_12"}  # told with more decimals than millimetres are
Row = tuple[str, list[float | None], int]  # its name, its cells, their decimals


def pair_rows(comparison: Comparison, drafting: Drafting) -> Iterator[tuple[str, Quantity]]:
    """Give what both wheels have in common by the names of its rows, in the units that it is told in."""
    known = {one.name: one for one in comparison.findings}
    for name in ("α_w", "a_w", "g_α", "ε_α", "λ_B1", "λ_B2"):
        one = known[name]
        times, unit = UNITS[one.unit]
        ours, theirs = times * one.construction, times * one.analysis
        row = f"{with_index(name)}, {drafting.word(unit)}" if unit else with_index(name)
        yield row, one._replace(construction=ours, analysis=theirs, largest=times * one.largest)


def slips(comparison: Comparison, scales: Mapping[str, float]) -> dict[tuple[str, int], float]:
    """Give within what hands are of what both wheels have in common, by the figure of the mesh."""
    units = {one.name: UNITS[one.unit][0] for one in comparison.findings}
    found = slipping(comparison.findings, {"involute": scales[MESH]})
    return {key: units[key[0]] * error for key, error in found.items()}


def size_rows(comparison: Comparison, drafting: Drafting) -> Iterator[Row]:
    """Give the rows of sizes: for each wheel as drawn, by formulas."""
    known = {one.name: one for one in comparison.findings if one.unit == "m"}
    for letter in ("d_w", "d_a", "d_f", "d_l", *(letter for letter, _, _ in SIZED[2:])):
        values = list[float | None]()
        for number in (1, 2):
            one = known.get(f"{letter}{number}")
            values += [None, None] if one is None else [1e3 * float(one.construction[0]), 1e3 * float(one.analysis[0])]
        yield f"{with_index(letter.rstrip('_'))}, {drafting.word('mm')}", values, MILLIMETRES


def data_rows(pair: InvolutePair, sizes: PairSizes, drafting: Drafting) -> Iterator[tuple[str, list[float | None]]]:
    """Give the rows of the data of both wheels, as GOST 2.403 has them: module, teeth, shift, circles, measuring."""
    mm, wheels = drafting.word("mm"), pair.wheels
    rows = {
        "m": [1e3 * pair.rack.module] * 2, "z": pair.teeth, "x": pair.shifts,
        "d": [2e3 * wheel.radius for wheel in wheels], "d_b": [2e3 * wheel.base for wheel in wheels],
        "h": [1e3 * abs(one.tip - one.root) for one in sizes.wheels],
        "k": [wheel.spanned for wheel in wheels], "D": [1e3 * one.pin for one in sizes.wheels],
    }  # fmt: skip
    for letter, both in rows.items():
        row = f"{drafting.word(f'involute {letter}')} {with_index(letter)}{'' if letter in 'zxk' else f', {mm}'}"
        places = SHARES if letter == "x" else MILLIMETRES
        yield row, [None if math.isnan(one) else round(one, places) for one in both]


def noted(pair: InvolutePair, sizes: PairSizes) -> dict[str, float]:
    """Give the numbers of the notes by the names of their quantities: mm, degrees, modules, rounded as in tables."""
    rack = pair.rack
    moved = round((sizes.distance - pair.standard) / rack.module, EXACT) + 0.0
    found = {"α": math.degrees(rack.angle), "h*": rack.head, "c*": rack.clearance, "ρ*": rack.rounding}
    found |= {"a": 1e3 * pair.standard, "a_w": 1e3 * sizes.distance, "y": moved}
    found |= {"Δy": round(pair.total - moved, EXACT) + 0.0, "α_w": math.degrees(sizes.angle), "ε_α": sizes.ratio}
    found |= {"k": pair.tip_relief, "g_α": 1e3 * sizes.active, "p_b": 1e3 * rack.base_pitch, "p": 1e3 * rack.pitch}
    found |= {"x_Σ": pair.total, "u_12": -pair.sense * pair.teeth[1] / pair.teeth[0]}
    found |= {f"s_a{n}/m": one.tip_thickness / rack.module for n, one in enumerate(sizes.wheels, 1)}
    return {name: round(one, SHARES if name in FINE else MILLIMETRES) for name, one in found.items()}


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's pair."""
    comparison, drafting = study.comparison("involute"), drafting_of(study.scene)
    pair, sizes = study.of(InvoluteStudy).pair, comparison.analysis
    yield from chain(_mesh(pair, sizes), _generation(pair, sizes), _sliding(pair, sizes))
    off = slips(comparison, {name: mu for leaf in leaves for name, mu in leaf.metadata["scales"].items()})
    for row, quantity in pair_rows(comparison, drafting):
        roads = [(float(quantity.analysis[0]), FAR)] * 2
        yield from cells(PAIR, row, (*roads, by_hand(off[quantity.name, 0], quantity.largest)), digits=TOLD)
    for row, values, places in size_rows(comparison, drafting):  # by formulas, in the columns of both roads
        known = [None if one is None else (one, 10.0**-places / 2) for one in values[1::2]]
        yield from cells(SIZES, row, [one for one in known for _ in range(2)])
    for row, both in data_rows(pair, sizes, drafting):
        numbers = [one if one is None or isinstance(one, int) else (one, FAR) for one in both]
        yield from cells(DATA, row, numbers, digits=DIGITS)
    for name, value in noted(pair, sizes).items():
        lack = name in ("k", "x_Σ")
        yield Expected(Kind.PHRASE, NOTES, name, value, FAR * max(abs(value), 1.0), may_lack=lack, digits=DIGITS)


def _side(pair: InvolutePair, sizes: PairSizes, number: int) -> Complexes:
    found = sizes.wheels[number]
    return flank(pair.wheels[number], found.tip, found.root, POINTS)


def _mesh(pair: InvolutePair, sizes: PairSizes) -> Iterator[Expected]:
    """Give the points on the line of action, the centres, teeth and circles."""
    along = complex(math.cos(sizes.angle), math.sin(sizes.angle))
    first, second = (one.operating * math.sin(sizes.angle) for one in sizes.wheels)
    tips = [math.sqrt(one.tip**2 - wheel.base**2) for one, wheel in zip(sizes.wheels, pair.wheels, strict=True)]
    spots = {"P": 0.0, "N_1": -first, "N_2": pair.sense * second, "B_2": tips[0] - first}
    spots["B_1"] = pair.sense * (second - tips[1])
    for name, far in spots.items():
        yield Expected(Kind.POINT, MESH, name, far * along, FAR * sizes.distance, may_lack=name == "P")
    yield Expected(Kind.ANGLE, MESH, "α_w", sizes.angle, FAR)
    wheels = placed(pair, sizes)
    shown = [one.shown for one in wheels]
    apart = Expected(Kind.LENGTH, MESH, "a_w", sizes.distance, FAR * sizes.distance)  # broken off where one is far
    both = [*measured(apart, noted(pair, sizes)["a_w"], digits=DIGITS)]
    yield from both[not all(shown) :] if any(shown) else ()
    for k, one in enumerate(wheels):
        n, slack = one.wheel.number, FAR * one.sizes.operating
        yield Expected(Kind.DIRECTION, MESH, f"ω_{n}", -1.0 if one.up == 1j else 1.0)
        if one.shown:
            yield Expected(Kind.POINT, MESH, f"O_{n}", one.centre, slack)
        more = tips[k] / one.wheel.base - math.tan(sizes.angle) if one.unrolled else 0.0
        for name, curve in one.circles(sizes.angle + more).items():
            yield Expected(Kind.CURVE, MESH, name, curve, slack)
        yield Expected(Kind.CURVE, MESH, f"teeth {n}", one.teeth(_side(pair, sizes, k)), slack)


def _generation(pair: InvolutePair, sizes: PairSizes) -> Iterator[Expected]:
    """Give the tooth of wheel 1, the rack in its positions, the circles, the shift."""
    one = placed(pair, sizes)[0]
    wheel, slack = one.wheel, FAR * one.wheel.radius
    yield Expected(Kind.CURVE, GENERATION, "tooth", one.tooth(_side(pair, sizes, 0)), slack)
    for name, curve in racked(wheel.rack, wheel.shift, wheel.radius).items():
        yield Expected(Kind.CURVE, GENERATION, name, curve, slack)
    ways = np.exp(1j * np.linspace(-0.75, 0.75, 65) * math.tau / wheel.teeth)
    for name, radius in (("d_1", wheel.radius), ("d_b1", wheel.base)):
        yield Expected(Kind.CURVE, GENERATION, name, 1j * (ways * radius - wheel.radius), slack)
    yield Expected(Kind.ANGLE, GENERATION, "α", wheel.rack.angle, FAR)
    shift = wheel.shift * wheel.rack.module
    row = Expected(Kind.LENGTH, GENERATION, "x_1m", abs(shift), slack, may_lack=True)
    yield from measured(row, 1e3 * shift, digits=4, may_lack=True) if shift else ()


class Reach(NamedTuple):
    """How far the graph of sliding goes: along the line from N_1, m, and down; where each course begins and ends."""

    length: float
    low: float
    spans: tuple[tuple[float, float], tuple[float, float]]


def reach(pair: InvolutePair, far: float, end: float, slides: Sequence[float]) -> Reach:
    """Give how far the graph goes: to N_2, of an internal pair past B_2; down to below the sliding at the feet."""
    low, ratio = min(LEAST, BEYOND * min(slides)), pair.teeth[0] / pair.teeth[1]
    length = BEYOND * end if pair.internal else far
    first = ratio * far / (1 - low + pair.sense * ratio)
    share = 1 + pair.sense * ratio * (1 - low)  # of an internal pair wheel 2 never slides so much
    last = min(ratio * far * (1 - low) / share, length) if share > 0 else length
    return Reach(length, low, ((first, length), (0.0, last)))


def _sliding(pair: InvolutePair, sizes: PairSizes) -> Iterator[Expected]:
    """Give the courses of sliding, what it is at the feet, the active part and the base pitch."""
    far = sizes.distance * math.sin(sizes.angle)
    end = math.sqrt(sizes.wheels[0].tip ** 2 - pair.wheels[0].base ** 2)
    slides = [one.sliding for one in sizes.wheels]
    ends = reach(pair, far, end, slides).spans
    for k, (name, span) in enumerate(zip(("λ_1", "λ_2"), ends, strict=True)):

        def course(x: np.ndarray, k: int = k) -> np.ndarray:
            with np.errstate(divide="ignore"):
                return sliding(pair, x)[k]

        yield Expected(Kind.CURVE, SLIDING, name, course, 1e-3, ends=span)
        yield Expected(Kind.VECTOR, SLIDING, f"λ_B{k + 1}", 1j * slides[k], 1e-9)
    for name, size in (("g_α", sizes.active), ("p_b", pair.rack.base_pitch)):
        yield from measured(Expected(Kind.LENGTH, SLIDING, name, size, FAR), 1e3 * size, digits=4)
