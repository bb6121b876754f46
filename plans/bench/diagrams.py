"""Kinematic diagrams timed and judged: the error of chords against the number of positions (диаграммы)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from plans.bench.clock import interleaved
from plans.bench.convergence import order
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.bench.roads import prepared
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Diagrams, chord_error
from plans.scene.scene import Scene
from plans.words.words import Message

CHORDS = "diagrams: v and a by chords"
COUNTS = (12, 24, 48, 96, 192, 360)
SPEED, GROWTH = "v", "a"
DEFINED = (
    "kinematic diagrams: the largest differences of v by the chords of S and of a by the chords of v from the exact "
    "ones where they belong, in shares of the largest of each"
)
WITHOUT = "left out: {why}"


def rows(scene: Scene, rounds: int, budget: float, counts: Sequence[int] = COUNTS) -> tuple[list[Row], list[str]]:
    """Time and judge the diagrams of a scene at several numbers of positions; give the rows, and the orders."""
    studies = [DiagramsStudy(prepared(scene, count), True) for count in counts]
    why = next((one.left_out for one in studies if one.left_out), None)
    if why is not None:
        return [_without(why)], [DEFINED]
    errors = [judged(one.drawn) for one in studies]
    times = interleaved([_run(one) for one in studies], rounds, budget)
    made = [
        Row(CHORDS, count, count, Errors(own, max(own, key=own.__getitem__)), times=taken)
        for count, own, taken in zip(counts, errors, times, strict=True)
    ]
    return made, [DEFINED, *_orders(errors, counts)]


def judged(found: Diagrams) -> dict[str, float]:
    """Give how far v and a by chords are out, in shares of the largest."""
    pairs = {SPEED: (found.speeds, found.true_speeds), GROWTH: (found.growths, found.true_growths)}
    errors = {name: chord_error(*pair) for name, pair in pairs.items()}
    return {name: error.share if error else 0.0 for name, error in errors.items()}


def _without(why: Message) -> Row:
    return Row(CHORDS, None, note=WITHOUT.format(why=why))


def _run(study: DiagramsStudy) -> Callable[[], Diagrams]:
    """Draw the diagrams over plans that are there."""
    return lambda: DiagramsStudy(study.linkage, True).drawn


def _orders(errors: Sequence[dict[str, float]], counts: Sequence[int]) -> Iterator[str]:
    for name in (SPEED, GROWTH):
        own = [one[name] for one in errors]
        if min(own) > 0:
            yield f"  {CHORDS}, {name}: order {order(own, counts):.2f} from {counts[0]} to {counts[-1]} positions"
