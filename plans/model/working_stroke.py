"""The working stroke: what names it, and which of the two strokes of an output it is (рабочий ход).

Both roads ask here, each of the coordinates that it found.
"""

import cmath
import math

from plans.model.mechanism import FASTER, FRAME, SLOWER, Mechanism, Output, StructureError, Way
from plans.words.words import message

# What a stroke may be named by: the time that it takes, where its point goes, how its link turns, what its two points
# do to their distance.
WAYS = {"right": 1 + 0j, "left": -1 + 0j, "up": 1j, "down": -1j}
TURNS = {"counter-clockwise": 1, "clockwise": -1}
PARTINGS = {"apart": 1, "together": -1}
STROKES = (SLOWER, FASTER, *WAYS, *TURNS, *PARTINGS)
# A stroke goes another way than is asked for where so small a share of it goes that way: square to it but for rounding.
SQUARE = 1e-7
LEANING = math.sin(math.radians(90 / 8))  # of a stroke: what goes less of it that way is not told to lean


class NoWorkingStroke(StructureError):  # noqa: N818  (the exception tree's own word)
    """A working stroke that is named by a way which the output does not go."""

    def __init__(self, output: Output) -> None:
        super().__init__(message("structure.working", working=output.working, link=output.link))
        self.output = output


def by_time(output: Output) -> bool:
    """Tell whether the working stroke is named by the time that it takes."""
    return output.working in (SLOWER, FASTER)


def works(mechanism: Mechanism, output: Output, begin: float, end: float) -> bool:
    """Tell whether the stroke from a coordinate to another is the working one, of the two that are named by their way.

    Coordinates are those of Extremes.reach; a stroke that goes neither that way nor back raises NoWorkingStroke.
    """
    gone, whole = _progress(mechanism, output, begin, end)
    if not abs(gone) > SQUARE * whole:
        raise NoWorkingStroke(output)
    return gone > 0


def ways(mechanism: Mechanism, output: Output, begin: float, end: float) -> tuple[str, ...]:
    """Name the way of a stroke from a coordinate to another, by the names of working strokes, the plainest first.

    Of a slide that leans both its ways are named, unless it goes but an eighth of a right angle or less in one of them.
    """
    found = []
    for name in (*TURNS, *PARTINGS, *WAYS):
        gone, whole = _progress(mechanism, output._replace(working=name), begin, end)
        found += [name] if gone > LEANING * whole else []
    return tuple(found)


def frame_way(mechanism: Mechanism, link: int) -> tuple[str, Way] | None:
    """Give the point and the line by which a link slides on the frame."""
    slides = (slide for slide in mechanism.slides if {slide.slider, slide.owner} == {link, FRAME})
    return next(((slide.point, slide.way(FRAME)) for slide in slides), None)


def _progress(mechanism: Mechanism, output: Output, begin: float, end: float) -> tuple[float, float]:
    """Give how far an output goes in the way that names its working stroke, and how far at all; 0 where it does not."""
    whole, name = end - begin, output.working
    slide = frame_way(mechanism, output.link)
    if output.parting is not None:
        return PARTINGS.get(name, 0) * whole, abs(whole)
    if name in TURNS:
        return (0.0 if slide else TURNS[name] * whole), abs(whole)
    if name not in WAYS:
        return 0.0, abs(whole)
    went = slide[1].direction * whole if slide else _swing(mechanism, output, begin, end)
    return (WAYS[name].conjugate() * went).real, abs(went)


def _swing(mechanism: Mechanism, output: Output, begin: float, end: float) -> complex:
    """Give how a point of a link goes that swings about a fixed point; nothing of another."""
    points, fixed = mechanism.links[output.link].points, mechanism.links[FRAME].points
    pivot = next((place for name, place in points.items() if name in fixed), None)
    if pivot is None or output.point is None:
        return 0j
    arm = points[output.point] - pivot
    return arm * (cmath.rect(1.0, end) - cmath.rect(1.0, begin))
