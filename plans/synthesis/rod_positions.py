"""A four-bar that guides its rod through two or three positions: pivots on bisectors, poles, inversion (положения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise, product
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.synthesis.design import Design
from plans.model.synthesis.positions import TIED, FunctionTask, RodTask, real
from plans.synthesis.centre_points import Bars, centres, middles, pole
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure
from plans.words.words import because

HINGES, PIVOTS = "AB", "OC"
LENGTHS = {"l_1": ("O", "A_1"), "l_2": ("A_1", "B_1"), "l_3": ("C", "B_1"), "l_4": ("O", "C")}


def rod_positions(task: RodTask) -> tuple[DrawnReading, ...]:
    """Draw every four-bar of a task on one board."""
    rod = _GuidedRod(task, Board(SYNTHESIS))
    kept = ("hinges" if task.hinges else "pivots", *(("arms",) if task.arms else ()))
    return (DrawnReading(kept, rod.board, tuple(rod.four_bars())),)


class _GuidingLink(NamedTuple):
    """A link to the frame: its pivot, and its hinge on the rod in each position."""

    pivot: Mark
    hinges: list[Mark]


class _GuidedRod:
    """The positions of a rod on a board: its point D, and its direction."""

    def __init__(self, task: RodTask, board: Board) -> None:
        self.task, self.board = task, board
        self.places = [board.given(f"D_{k}", at, because("rod_place")) for k, at in enumerate(task.places, 1)]
        self.ways = [
            board.given(f"D_{k}:u", cmath.rect(1.0, angle), because("rod_way", angle=f"{math.degrees(angle):.10g}"))
            for k, angle in enumerate(task.angles, 1)
        ]
        self.inverted: dict[str, Mark] = {}
        self.middles: dict[str, Mark] = {}  # of the ways whose bisectors are drawn, by the letter of what moves

    def four_bars(self) -> Iterator[DrawnDesign]:
        """Put every link of the one side together with every one of the other."""
        known, arms = self.task.hinges or self.task.pivots or (), self.task.arms or (None, None)
        sides = [[*self._links(k, at, arm)] for k, (at, arm) in enumerate(zip(known, arms, strict=True))]
        for first, second in product(*sides):
            bars = Bars(self.board, first.pivot, first.hinges, second.hinges, second.pivot)
            if real(bars.lengths) and (made := self._read(bars)):
                yield made

    def _links(self, side: int, at: complex, arm: float | None) -> Iterator[_GuidingLink]:
        board, hinge, pivot = self.board, HINGES[side], PIVOTS[side]
        if self.task.hinges:
            first = board.given(f"{hinge}_1", at, because("hinge_chosen"))
            places = [first, *self._carried(hinge, first)]
            for centre in centres(board, pivot, places, arm):
                self.middles |= middles(board, hinge.lower(), places)
                yield _GuidingLink(centre, places)
            return
        fixed = board.given(pivot, at, because("pivot_chosen"))
        seen = [fixed, *self._seen(pivot, fixed)]
        self.inverted |= {mark.name: mark for mark in seen[1:]}
        for first in centres(board, f"{hinge}_1", seen, arm):
            self.middles |= middles(board, pivot.lower(), seen)
            yield _GuidingLink(fixed, [first, *self._carried(hinge, first)])

    def _carried(self, name: str, first: Mark) -> Iterator[Mark]:
        """Carry a hinge with the rod into its other positions."""
        ray, prime = self.board.join(f"D_1{first.name}", self.places[0], first), first.name.removeprefix(f"{name}_1")
        for k, (place, way) in enumerate(zip(self.places[1:], self.ways[1:], strict=True), 2):
            turned = self.board.similar(f"D_{k}{name}_{k}{prime}", way, self.ways[0], ray, why=because("as_rod"))
            yield self.board.lay_off(f"{name}_{k}{prime}", place, turned)

    def _seen(self, name: str, fixed: Mark) -> Iterator[Mark]:
        """Carry a pivot with the rod back into the first position: inversion (обращение движения)."""
        for k, (place, way) in enumerate(zip(self.places[1:], self.ways[1:], strict=True), 2):
            ray = self.board.join(f"D_{k}{name}", place, fixed)
            turned = self.board.similar(f"D_1{name}_{k}", self.ways[0], way, ray, why=because("inverted"))
            yield self.board.lay_off(f"{name}_{k}", self.places[0], turned)

    def _read(self, bars: Bars) -> DrawnDesign | None:
        """Read a four-bar that one of its links can lead."""
        poles = {f"P_{i + 1}{j + 1}": self._pole(bars, i, j) for i, j in self.task.poles}
        places = {mark.name: mark for mark in self.places}
        return read(bars, "φψ", places | poles | self.inverted | self.middles, self._lines())

    def _pole(self, bars: Bars, i: int, j: int) -> Mark:
        """Draw a pole from the hinge that goes farther."""
        far = max((bars.hinges, bars.ends), key=lambda at: abs(complex(at[j].point) - complex(at[i].point)))
        return pole(self.board, f"P_{i + 1}{j + 1}", far[i], far[j], self.task.turn(i, j))

    def _lines(self) -> Iterator[tuple[str, str]]:
        """Give what is drawn beside the links: the rod's point, the bisectors, what the poles see."""
        ends = dict(zip("ab", "OC", strict=True)) | dict(zip("oc", ("A_1", "B_1"), strict=True))
        yield from ((ends[name[0]], name) for name in self.middles)
        for i, j in self.task.poles:
            yield from ((f"P_{i + 1}{j + 1}", f"A_{k + 1}") for k in (i, j))
        for k in range(1, len(self.places) + 1):
            yield from ((f"A_{k}", f"D_{k}"), (f"D_{k}", f"B_{k}"))
        for one in (name for name in self.inverted if name[-1] == "2"):
            yield from ((one[0], one), *((one, one[0] + "_3") for _ in self.places[2:]))


def read(bars: Bars, letters: str, extra: dict[str, Mark], more: Iterable[tuple[str, str]]) -> DrawnDesign | None:
    """Read a four-bar in its positions, where OA, by φ, or CB, by ψ, leads from one to the next."""
    for letter in letters:
        leading, ends = (bars, ("O", "A")) if letter == "φ" else (bars.turned, ("C", "B"))
        if (turns := leading.led()) is None:
            continue
        told = {f"{letter}_1{k}": turn for k, turn in enumerate(turns[1:], 2)}
        angles = [(name, ends[0], f"{ends[1]}_1", f"{ends[1]}_{name[-1]}") for name in told if 0 < told[name] < math.pi]
        hinged = {"O": bars.pivot, "C": bars.other}
        hinged |= {f"A_{k}": mark for k, mark in enumerate(bars.hinges, 1)}
        hinged |= {f"B_{k}": mark for k, mark in enumerate(bars.ends, 1)}
        sizes = dict(zip(LENGTHS, bars.lengths, strict=True)) | told | {"μ_min": leading.tightest}
        places = {name: complex(mark.point) for name, mark in (hinged | extra).items()}
        shown = {name: bars.board.join(name, *(hinged[end] for end in ends)) for name, ends in LENGTHS.items()}
        chains = [("O", f"A_{k}", f"B_{k}", "C") for k in range(1, len(bars.hinges) + 1)]
        ways = ((f"{one}_{k}", f"{one}_{k + 1}") for one in HINGES for k in range(1, len(bars.hinges)))
        figure = SynthesisFigure(chains[0], tuple(chains[1:]), (*ways, *more), (), frozenset(hinged), frozenset(PIVOTS))
        dimensions = tuple((name, *ends) for name, ends in LENGTHS.items())
        figure = figure._replace(lengths=dimensions, angles=tuple(angles))
        arm = min(leading.lengths[0], *(math.sin(leading.tightest) * one for one in leading.lengths[1:3]))
        design = Design(sizes, places, merit=round(leading.tightest, TIED))
        return DrawnDesign(design, shown, dict.fromkeys((*told, "μ_min", "ψ_1"), arm), figure)
    return None


def function_points(task: FunctionTask) -> tuple[DrawnReading, ...]:
    """Draw every four-bar whose rocker turns as asked: the rocker held, crank and frame turn back about C."""
    board = Board(SYNTHESIS)
    pivot, other = board.given("O", 0j, because("crank_pivot")), board.given("C", complex(task.frame))
    pins = [
        board.lay_off(f"A_{k}", pivot, board.given(f"OA_{k}", cmath.rect(task.crank, angle), because("crank_at")))
        for k, angle in enumerate(task.inputs, 1)
    ]
    seen = [pins[0]]
    for k, (pin, angle) in enumerate(zip(pins[1:], task.outputs[1:], strict=True), 2):
        ray = board.join(f"CA_{k}", other, pin)
        back = cmath.rect(1.0, task.outputs[0] - angle)
        seen.append(board.lay_off(f"A_{k}'", other, board.turn(f"CA_{k}'", ray, back, because("rocker_held"))))
    kept = ("crank", "frame", *(("rocker",) if task.rocker else ()))
    found = (
        _function(task, Bars(board, pivot, pins, [end], other), seen) for end in _rocker_ends(task, board, other, seen)
    )
    return (DrawnReading(kept, board, tuple(one for one in found if one)),)


def _rocker_ends(task: FunctionTask, board: Board, other: Mark, seen: list[Mark]) -> Iterator[Mark]:
    """Draw B in the first position, as far from every place of A that the rocker sees."""
    if task.rocker is None:
        yield from centres(board, "B_1", seen, None)
    else:
        yield from centres(board, "B_1", seen, task.rocker, about=other)


def _function(task: FunctionTask, first: Bars, seen: list[Mark]) -> DrawnDesign | None:
    board, ray = first.board, first.board.join("CB_1", first.other, first.ends[0])
    ends = [first.ends[0]]
    for k, angle in enumerate(task.outputs[1:], 2):
        turned = board.turn(f"CB_{k}", ray, cmath.rect(1.0, angle - task.outputs[0]), because("rocker_turned"))
        ends.append(board.lay_off(f"B_{k}", first.other, turned))
    bars, between = first._replace(ends=ends), middles(board, "a", seen)
    extra = {mark.name: mark for mark in seen[1:]} | between
    lines = [(name, "B_1") for name in between] + [("C", mark.name) for mark in (*bars.hinges[1:], *seen[1:])]
    made = read(bars, "φ", extra, [*lines, *pairwise(mark.name for mark in seen)]) if real(bars.lengths) else None
    if made is None:
        return None
    sizes = {**made.design.sizes, "ψ_1": cmath.phase(complex(ray.point))}
    return made._replace(design=replace(made.design, sizes=sizes))
