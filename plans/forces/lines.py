"""Lines of action of forces between two links: both points must lie on them, or the force would turn the whole (линии).

A force and its opposite off one line are a couple that nothing gives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from plans.forces.stroke import ROUNDING
from plans.model.machine import Force, Machine
from plans.model.motion import Complexes, Motion
from plans.scene.faults import SceneError
from plans.scene.scene import Scene


def off_their_lines(machine: Machine, motion: Motion) -> Iterator[tuple[int, Force]]:
    """Give the forces between two links that are off the line they are told to act along, each with its number."""
    places = [np.nanmax(np.abs(point.r), initial=0.0) for point in motion.points.values()]
    for index, force in enumerate(machine.forces):
        if told_line(force) and _off(force, motion) > ROUNDING * max(places):
            yield index, force


def check_lines(scene: Scene, machine: Machine, motion: Callable[[int], Motion]) -> None:
    """See that forces between two links act along lines that their points lie on; `motion` makes that of an order."""
    if not any(map(told_line, machine.forces)):
        return
    off = list(off_their_lines(machine, motion(0)))
    if off:
        paths = [(("loads", "forces", index, "direction"), "".join(force.line or ())) for index, force in off]
        raise SceneError(scene.fault(path, "off_line", line=line) for path, line in paths)


def told_line(force: Force) -> bool:
    """Tell whether a force between two links acts along a line of other points than its own."""
    if force.other is None or force.line is None:
        return False
    return {*force.line} != {force.point, force.other.point}


def _off(force: Force, motion: Motion) -> float:
    """Give how far m the line is from either point of a force, at the position where it is farthest."""
    assert force.line is not None  # it is told
    assert force.other is not None

    def place(point: str) -> Complexes:
        return motion.points[point].r

    start, end = map(place, force.line)
    way = (end - start).conj()
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        across = [((place(point) - start) * way).imag / np.abs(way) for point in (force.point, force.other.point)]
    return float(np.nanmax(np.abs(across), initial=0.0))
