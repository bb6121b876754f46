"""A crank-rocker from rocker, swing and overlap: the circle that sees the chord, and O on its arc (M1.5)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from geometry.board import Board, Mark, Span, between
from geometry.meet import Sizes, Vectors, cross
from plans.model.motion import Floats
from plans.model.synthesis.design import QUARTER, BarredArc, Design, LocusCircle
from plans.model.synthesis.extremes import CENTRES, RockerTask
from plans.model.synthesis.region import Region, stations
from plans.quantity import Shown
from plans.synthesis.chord import SYNTHESIS, DrawnCrank, ExtremeChord, circle_of, read
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure
from plans.synthesis.search import PLACED, best_of
from plans.words.words import because

KEPT = ("rocker", "swing", "overlap")


class _Base(NamedTuple):
    """A task drawn but for O: the rocker's pivot, the chord, the locus of O on one side, and where its arcs end."""

    task: RockerTask
    board: Board
    rocker: Mark  # C
    chord: ExtremeChord
    locus: Mark
    ends: tuple[Mark, ...]  # K1, K2 on the lines CB1, CB2

    @property
    def side(self) -> int:
        return self.task.sides[0]

    @property
    def admits(self) -> bool:
        """Whether some of its arc admits O."""
        return self.side > 0 or self.task.swing / 2 + self.task.overlap < QUARTER

    @property
    def left(self) -> Mark:
        """The end of the arc left of the axis."""
        return min(self.ends, key=lambda end: complex(end.point).real)

    @property
    def end(self) -> float:
        """The angle rad at M from B2 to there."""
        near, far = (complex(between(self.board[CENTRES[self.side]], one)) for one in (self.chord.folded, self.left))
        return self.side * cmath.phase(far / near) % math.tau

    def place(self, turned: Floats | float) -> Any:
        """Give the angle rad at M of what is turned on from B2."""
        return cmath.phase(complex(between(self.board[CENTRES[self.side]], self.chord.folded))) + self.side * turned

    @property
    def barred(self) -> tuple[BarredArc, ...]:
        """The arcs between the lines CB1, CB2 and beyond the chord: from the right end of each on, or from the left."""
        if not self.ends:
            return ()
        name = CENTRES[self.side]
        chord = (self.chord.stretched, self.chord.folded)
        return tuple(_arc(self.board[name], pair, self.side * sense) for pair, sense in ((self.ends, -1), (chord, 1)))


def _arc(centre: Mark, ends: tuple[Mark, ...], sense: int) -> BarredArc:
    """Give the arc above a centre, from right to left, or below it."""
    rays = sorted((complex(between(centre, end)) for end in ends), key=lambda ray: -sense * ray.real)
    return BarredArc(centre.name, cmath.phase(rays[0]), cmath.phase(rays[1] / rays[0]) % math.tau)


def _base(task: RockerTask) -> _Base:
    """Draw the rocker in both extreme places; O being on the left, B1, farther from it, is on the right."""
    board = Board(SYNTHESIS)
    pivot = board.given("C", 0j, because("rocker_pivot"))
    why = because("rocker_extreme", angle=f"{math.degrees(task.swing):.6g}")
    ends = [cmath.rect(task.rocker, QUARTER - sense * task.swing / 2) for sense in (1, -1)]
    far, near = (board.given(f"C{name}", end, why) for name, end in zip(("B_1", "B_2"), ends, strict=True))
    chord = ExtremeChord.between(board, board.lay_off("B_1", pivot, far), board.lay_off("B_2", pivot, near))
    if not task.overlap:
        return _Base(task, board, pivot, chord, chord.offset(0.0), ())
    side = task.sides[0]
    locus = chord.seen(task.overlap, side, CENTRES[side])
    ways = (board.turn(f"K_{k}:u", ray, 1 / task.rocker) for k, ray in ((1, far), (2, near)))
    lines = (board.parallel(f"K_{k}:l", pivot, way, because("assembly_line")) for k, way in enumerate(ways, 1))
    last = [board.meet(f"K_{k}", line, locus, -side, because("assembly_end")) for k, line in enumerate(lines, 1)]
    return _Base(task, board, pivot, chord, locus, tuple(last))


def drawn(task: RockerTask) -> tuple[DrawnReading, ...]:
    """Draw a task whose free parameter is known on each circle that O may lie on."""
    return tuple(_reading(_base(task._replace(side=side))) for side in task.sides)


def _reading(base: _Base) -> DrawnReading:
    pivots = [one for one in _pivots(base) if _admits(base, one).all()]
    return DrawnReading(KEPT, base.board, tuple(_drawn(base, read(base.chord, pivot)) for pivot in pivots))


def _pivots(base: _Base) -> Iterator[Mark]:
    """Put O where its frame or its angle has it."""
    task, board = base.task, base.board
    if task.place is not None:
        ray = board.given("O:r", complex(math.cos(task.place), math.sin(task.place)), because("chosen_place"))
        yield board.divide("O", base.locus, ray, because("pivot_place"))
    elif task.frame is not None:
        arc = board.arc("C:o", base.rocker, task.frame, because("frame_length"))
        for name, side in (("O", 1.0), ("O'", -1.0)):
            met = board.meet(name, base.locus, arc, side, because("pivot_loci"))
            if complex(met.point).real < 0:  # the others are mirror images
                yield met


def _admits(base: _Base, at: Mark) -> NDArray[np.bool_]:
    """Tell where O is on the arc that sees theta, and sees B1 and B2 on one side of the line OC."""
    frame, folded = between(at, base.rocker), np.asarray(between(at, base.chord.folded))
    ends = [np.sign(cross(frame, between(at, end))) for end in (base.chord.stretched, base.chord.folded)]
    beside = np.asarray(ends[0] * ends[1] > 0)
    return beside & np.asarray(base.side * folded.imag > 0 if base.task.overlap else folded.real > 0)


def _drawn(base: _Base, crank: DrawnCrank) -> DrawnDesign:
    task, board, chord = base.task, base.board, base.chord
    first, rest = (float(length) for length in crank.lengths)
    frame = complex(between(crank.pivot, base.rocker))
    least = float(_transmission(crank, frame, task.rocker))
    rockers = [complex(between(base.rocker, end)) for end in (chord.stretched, chord.folded)]
    theta, arm = crank.overlap
    sizes = {"l_1": first, "l_2": rest, "l_3": abs(rockers[0]), "l_4": abs(frame)}
    sizes |= {"ψ": cmath.phase(rockers[1] / rockers[0]), "θ": theta, "μ_min": least}
    places = {"C": complex(base.rocker.point), **crank.places}
    circles = dict[str, LocusCircle]()
    if task.overlap:
        name = CENTRES[base.side]
        places |= {one.name: complex(one.point) for one in (board[name], *base.ends)}
        circles[name] = circle_of(base.locus)
        rays = [complex(between(board[name], one)) for one in (chord.folded, crank.pivot)]
        sizes["γ"] = base.side * cmath.phase(rays[1] / rays[0]) % math.tau
    shown: dict[str, Shown] = {
        "l_1": crank.crank,
        "l_2": crank.coupler,
        "l_4": Span(crank.pivot, base.rocker),
        "θ": crank.seen,
    }
    flat = math.sin(least) * min(rest, task.rocker)
    arms = {
        "θ": arm,
        "ψ": task.rocker,
        "μ_min": flat,
        "γ": min([abs(rockers[0].real), *(one.radius for one in circles.values())]),
    }
    design = Design(sizes, places, circles, base.barred, least)
    return DrawnDesign(design, shown, arms, _figure(places))


def _figure(places: dict[str, complex]) -> SynthesisFigure:
    centres = [name for name in CENTRES.values() if name in places]
    lines = [("B_1", "B_2"), *((end, centre) for centre in centres for end in ("B_1", "B_2"))]
    lines += [("O", centre) for centre in centres] + [("C", end) for end in ("K_1", "K_2") if end in places]
    return SynthesisFigure(
        ("O", "A_1", "B_1", "C"),
        (("O", "A_2", "B_2", "C"),),
        tuple(lines),
        (("C", "O"),),
        frozenset(("A_1", "A_2", "B_1", "B_2")),
        frozenset(("O", "C")),
        lengths=(("l_3", "C", "B_1"), ("l_4", "C", "O")),
        angles=(("ψ", "C", "B_1", "B_2"), ("θ", "O", "B_1", "B_2"), *(("γ", centre, "B_2", "O") for centre in centres)),
    )


def _transmission(made: DrawnCrank, frame: Vectors, rocker: float) -> Sizes:
    """Draw the coupler with the crank on the line of the frame, towards C and away, and measure its angle at B."""
    board = Board("transmission")
    length, (crank, coupler) = np.abs(frame), made.lengths
    pivot, hinge = board.given("O", 0j), board.given("C", length + 0j)
    angles = []
    for sense in (1, -1):
        pin = board.lay_off(f"A_{sense}", pivot, board.given(f"OA_{sense}", sense * crank + 0j))
        arcs = board.arc(f"A_{sense}B", pin, coupler), board.arc(f"CB_{sense}", hinge, rocker)
        end = board.meet(f"B_{sense}", *arcs, side=1.0)
        angles.append(abs(np.angle(between(pin, end) / between(hinge, end))))
    return np.asarray(np.minimum(angles[0], math.pi - angles[1]))


def with_best(task: RockerTask) -> RockerTask:
    """Give a task with the place of O that has the largest of all least transmission angles, if none is told."""
    if task.frame is not None or task.place is not None or not task.overlap:
        return task
    found = [(*_best(base), base) for base in (_base(task._replace(side=side)) for side in task.sides) if base.admits]
    if not found:
        return task
    turned, _, base = max(found, key=lambda one: one[1])
    return task._replace(side=base.side, place=round(base.place(turned) % math.tau, PLACED), best=True)


def _best(base: _Base) -> tuple[float, float]:
    return best_of(lambda turned: _sizes_over(base.task, base.place(turned))["μ_min"], 0.0, base.end)


def region(task: RockerTask, design: Design) -> Region | None:
    """Move O over the arc of the circle that a mechanism is on, from B2 to the middle of the circle."""
    if not task.overlap:
        return None
    base = _base(task._replace(side=next(side for side, name in CENTRES.items() if name in design.circles)))
    places = stations(base.end)
    return Region(
        places,
        _sizes_over(base.task, base.place(places)),
        base.end,
        math.pi - task.overlap,
        _best(base),
        design.sizes["γ"],
    )


def _sizes_over(task: RockerTask, places: Floats) -> dict[str, Floats]:
    """Give sizes with O at each of some angles rad at M: the least transmission angle first; NaN where none is."""
    base = _base(task)
    at = base.board.divide("O", base.locus, base.board.given("O:r", np.exp(1j * places)))
    with np.errstate(invalid="ignore", divide="ignore"):
        crank, frame = read(base.chord, at), between(at, base.rocker)
        least = _transmission(crank, frame, task.rocker)
    lengths = np.array([*crank.lengths, np.full(len(places), task.rocker), np.abs(frame)])
    margin = lengths.sum(axis=0) - 2 * (lengths.min(axis=0) + lengths.max(axis=0))
    rows = {"μ_min": least, "L": lengths.max(axis=0) / task.rocker, "Δ": margin / task.rocker}
    return {name: np.where(_admits(base, at), row, np.nan) for name, row in rows.items()}


def admitted(task: RockerTask) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    """Give the places rad at M, and the frames m, between which the arcs left of the axis admit O."""
    for base in (_base(task._replace(side=side)) for side in task.sides):
        if base.admits:
            low, high = sorted(base.place(turned) % math.tau for turned in (0.0, base.end))
            short, long = sorted((task.rocker, abs(complex(base.left.point))))
            yield (low, high), (short, long)
