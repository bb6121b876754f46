"""Why no mechanism meets a task of positions or of a rocker-slider, with the nearest demand that one meets (отказ)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Final

from plans.analytic.dwell import crank, dwells, turns
from plans.analytic.guided import centres, functions, moves_of, rods
from plans.analytic.rocker_slider import least_ratio, rocker_sliders
from plans.model.synthesis.positions import DwellTask, FunctionTask, RodTask
from plans.model.synthesis.swings import RockerSliderTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene

MILLIMETRES = 1000.0
STEPS, TIMES = 400, 20.0  # tried times of a length, from a twentieth to twenty
CLOSER: Final = 30  # halvings of the way to the nearest


def _mm(length: float) -> str:
    return f"{MILLIMETRES * length:.6g}"


def _spot(at: complex) -> str:
    return f"({_mm(at.real)}, {_mm(at.imag)})"


def nearest(meets: Callable[[float], bool]) -> float | None:
    """Give the number nearest to 1, as times go, that meets a demand which 1 does not; None where none tried does.

    >>> round(nearest(lambda times: times > 1.5), 4)
    1.5
    """
    for k in range(1, STEPS + 1):
        for sense in (1, -1):
            if meets(found := TIMES ** (sense * k / STEPS)):
                return _closer(meets, TIMES ** (sense * (k - 1) / STEPS), found)
    return None


def _closer(meets: Callable[[float], bool], failing: float, found: float) -> float:
    for _ in range(CLOSER):
        middle = (failing + found) / 2
        failing, found = (failing, middle) if meets(middle) else (middle, found)
    return found


def slider_faults(scene: Scene, task: RockerSliderTask) -> Iterator[Fault]:
    """Say what is too little, and how large a ratio must or may be."""
    path: Path = ("synthesis", "rocker_slider")
    most = "" if task.angles is None else f"{1 / math.sin(task.steepest):.6g}"
    if task.angles is not None and task.ratio is None and task.pressure is None:
        yield scene.fault(path, "synthesis_any_ratio", most=most)
    elif task.angles is not None and task.ratio is not None and task.ratio * math.sin(task.steepest) >= 1:
        yield scene.fault((*path, "ratio"), "synthesis_reach", most=most)
    elif not any(one.found for one in rocker_sliders(task)):
        assert task.pressure is not None  # with a ratio that reaches the slider moves, but of rods as long as rockers
        yield scene.fault((*path, "ratio"), "synthesis_turns_back", least=f"{least_ratio(task.pressure):.6g}")


def rod_faults(scene: Scene, task: RodTask) -> Iterator[Fault]:
    """Say which hinge has no pivot, and by how much; or that no link leads through the positions in their order."""
    if rods(task).found:
        return
    path: Path = ("synthesis", "rod_positions")
    kind, known = ("hinges", task.hinges) if task.hinges else ("pivots", task.pivots)
    assert known is not None  # one of them is told
    moves = [*moves_of(task)]
    if kind == "pivots":
        moves = [(1 / turn, -shift / turn) for turn, shift in moves]  # the frame, seen from the rod
    alone = False
    for k, (name, at) in enumerate(zip("AB" if kind == "hinges" else "OC", known, strict=True)):
        places = [turn * at + shift for turn, shift in moves]
        if not [*centres(places, task.arms and task.arms[k])]:
            alone = True
            yield _alone(scene, (*path, kind, k), name, places, moves, task)
    if not alone:
        yield _unled(scene, (*path, kind), task, known)


def _alone(
    scene: Scene,
    at: Path,
    name: str,
    places: Sequence[complex],
    moves: Sequence[tuple[complex, complex]],
    task: RodTask,
) -> Fault:
    """Tell of a hinge that stands, that goes straight, or whose arm is too short."""
    still = [(i, j) for i in range(len(places)) for j in range(i) if abs(places[i] - places[j]) < STANDS]
    if still:
        return scene.fault(at, "synthesis_hinge_still", hinge=name, first=still[0][1] + 1, second=still[0][0] + 1)
    if task.arms:
        arms: Path = (*at[:2], "arms", at[-1])
        return scene.fault(arms, "synthesis_arm", least=_mm(abs(places[1] - places[0]) / 2))
    centre, radius = straight(moves)
    return scene.fault(at, "synthesis_hinge_straight", hinge=name, centre=_spot(centre), radius=_mm(radius))


STANDS: Final = 1e-9  # m, the least length of a scene


def straight(moves: Sequence[tuple[complex, complex]]) -> tuple[complex, float]:
    """Give the circle of the points of a body that are on one line in three positions: its centre and radius.

    Im((p a + s)(q a + t)*) = 0, where the moves take a by p a + s and q a + t on.
    """
    (p, s), (q, t) = ((turn - 1, shift) for turn, shift in moves[1:])
    both = (p * q.conjugate()).imag
    if not both:  # the body turns between two positions alone: it is a line
        return complex(math.inf), math.inf
    centre = -1j * (p * t.conjugate() - s.conjugate() * q).conjugate() / (2 * both)
    return centre, math.sqrt(max(abs(centre) ** 2 - (s * t.conjugate()).imag / both, 0.0))


def _unled(scene: Scene, path: Path, task: RodTask, known: tuple[complex, complex]) -> Fault:
    first, second = known

    def moved(times: float) -> RodTask:
        pair = first, first + times * (second - first)
        return task._replace(hinges=pair) if task.hinges else task._replace(pivots=pair)

    times = nearest(lambda times: bool(rods(moved(times)).found))
    name = "B" if task.hinges else "C"
    met = "—" if times is None else f"{name} {_spot(first + times * (second - first))}"
    return scene.fault(path, "synthesis_not_led", met=met)


def function_faults(scene: Scene, task: FunctionTask) -> Iterator[Fault]:
    """Say that the rocker is too short, or with which crank the function is met."""
    if functions(task).found:
        return
    path: Path = ("synthesis", "function_points")
    pins = [cmath.rect(task.crank, angle) - task.frame for angle in task.inputs]
    seen = [pin * cmath.rect(1.0, task.outputs[0] - angle) for pin, angle in zip(pins, task.outputs, strict=True)]
    if task.rocker is not None and abs(seen[1] - seen[0]) > 0:
        least = abs(abs(seen[1]) ** 2 - abs(seen[0]) ** 2) / (2 * abs(seen[1] - seen[0]))
        if least >= task.rocker:
            yield scene.fault((*path, "rocker"), "synthesis_rocker", least=_mm(least))
            return
    times = nearest(lambda times: bool(functions(task._replace(crank=times * task.crank)).found))
    met = "—" if times is None else f"{_mm(times * task.crank)} mm"
    none = task.rocker is None and not [*centres(seen, None)]
    yield scene.fault((*path, "crank"), "synthesis_pins_straight" if none else "synthesis_function", met=met)


def dwell_faults(scene: Scene, task: DwellTask) -> Iterator[Fault]:
    """Say that the crank does not go round, that K goes straight, or which rockers follow."""
    path: Path = ("synthesis", "dwell")
    if not turns(task):
        _, l2, l3, l4 = task.lengths
        most = min(l2 + l3 - l4, l4 - abs(l2 - l3))
        yield scene.fault((*path, "crank"), "synthesis_goes_round", most=_mm(most) if most > 0 else "—")
    elif not [*centres(near := [crank(task, task.stations[k])[2] for k in (0, 2, 4)], None)]:
        yield scene.fault((*path, "dwell"), "synthesis_point_straight", off=_mm(_sagitta(near)))
    elif not dwells(task).found:
        within = [
            f"{_mm(low)} … {_mm(high)}" for side in (1, -1) for low, high in (following(task, side),) if low < high
        ]
        yield scene.fault((*path, "output"), "synthesis_follows", within="; ".join(within) or "—")


def following(task: DwellTask, side: int) -> tuple[float, float]:
    """Give between what lengths m a rocker follows K over the whole turn, its pivot to one side of the rod.

    With d from D to K and v from D to the pivot's side, (rod - r)^2 < |d - r v|^2 < (rod + r)^2 is linear in r.
    """
    places = [crank(task, math.tau * k / TRIED)[2] for k in range(TRIED)]
    near = [crank(task, task.stations[k])[2] for k in (0, 2, 4)]
    (centre,) = centres(near, None)
    rod, way = abs(near[1] - centre), side * 1j * (near[1] - centre) / abs(near[1] - centre)
    low, high = 0.0, math.inf
    for place in places:
        off, along = abs(place - centre) ** 2 - rod**2, ((place - centre) * way.conjugate()).real
        for slope, least in ((2 * (rod + along), off), (2 * (rod - along), -off)):  # r slope > least
            if slope > 0:
                low = max(low, least / slope)
            elif slope < 0:
                high = min(high, least / slope)
    return low, high


TRIED: Final = 3600  # crank angles


def _sagitta(places: Sequence[complex]) -> float:
    """Give how far the middle of three places is off the line of the others, m."""
    chord = places[2] - places[0]
    return abs(((places[1] - places[0]) * chord.conjugate()).imag) / abs(chord) if chord else 0.0
