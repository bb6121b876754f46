"""What is common to the checks of the figures of balancing: vectors, points, curves of lines, titles (знаки)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from drawings.checks.balance.balance_expected import Side
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredPoint, MeasuredVector
from drawings.paper.strokes import Circle, Group, Line, Polyline, Stroke, Text
from drawings.paper.walk import groups, texts, walk
from plans.model.motion import Complexes

CLEAR = 3.0  # mm: so near to a point a line may be cut off by its symbol


def pole(part: Group | None) -> complex:
    """Give the place on paper of the pole of a figure, mm."""
    poles = (one for one in groups(() if part is None else (part,)) if one.data.get("kind") == "pole")
    return next((one.strokes[0].centre for one in poles if isinstance(one.strokes[0], Circle)), 0j)


def lettering(part: Group | None) -> list[str]:
    """Give what is lettered within a part."""
    return [] if part is None else [text.plain for text in texts((part,))]


def titled(part: Group | None, plan: str, title: str) -> Iterator[Wrong]:
    """See that a figure bears its title."""
    if Text(0j, title).plain not in lettering(part):
        yield on("title", plan, text=title)


def vectors(measured: Measured, plan: str) -> dict[str, MeasuredVector]:
    """Give the vectors of a figure by their names."""
    return {one.name: one for one in measured.vectors if one.plan == plan}


def points(measured: Measured, plan: str) -> dict[str, MeasuredPoint]:
    """Give the points of a figure by their names."""
    return {one.name: one for one in measured.points if one.plan == plan}


def scale(measured: Measured, plan: str) -> float:
    """Give the scale of a figure's marks, true units a mm; 1 of one without marks."""
    return next((one.scale for one in measured.marks if one.plan == plan), 1.0)


def held(
    seen: Mapping[str, MeasuredVector | MeasuredPoint], due: Mapping[str, complex], plan: str, slack: float
) -> Iterator[Wrong]:
    """Hold marks by their names: each that is there, each that is not; of none is there more."""
    for name, one in seen.items():
        if name not in due:
            yield on("stranger_on", plan, name=name)
        elif not abs(one.value - due[name]) <= slack:
            yield on("differs_on", plan, name=name)
    yield from (on("missing_on", plan, name=name) for name in due if name not in seen)


def laid(
    seen: Mapping[str, MeasuredVector], sides: Iterable[Side], plan: str, origin: complex, near: float, lane: float
) -> Iterator[Wrong]:
    """See that each vector begins where it must; in a lane it may stand so far aside, mm, but not along itself."""
    for side in sides:
        one = seen.get(side.name)
        if one is None or not side.value:
            continue
        off = (one.start - origin - side.start / one.scale) / (side.value / abs(side.value))
        if not (abs(off.real) <= near and abs(off.imag) <= lane + near):
            yield on("start", plan, name=side.name)


def lines(part: Group | None) -> list[Sequence[complex]]:
    """Give the chains of lines of a part, single lines among them."""
    return [_ends(one) for one in walk(() if part is None else (part,)) if isinstance(one, Polyline | Line)]


def _ends(one: Stroke) -> Sequence[complex]:
    assert isinstance(one, Polyline | Line)
    return one.points if isinstance(one, Polyline) else (one.start, one.end)


class Cover(NamedTuple):
    """A symbol that lines are cut off at: its middle mm, the way that it lies, half its length and width mm."""

    at: complex
    way: complex = 1 + 0j
    half: tuple[float, float] | None = None  # None: what stands about a point

    def hides(self, spots: Complexes, near: float) -> npt.NDArray[np.bool_]:
        """Tell which spots it covers."""
        off = (spots - self.at) * self.way.conjugate()
        if self.half is None:
            return np.asarray(np.abs(off) <= CLEAR)
        along, across = (size + near for size in self.half)
        return np.asarray((np.abs(off.real) <= along) & (np.abs(off.imag) <= across))


def thinner(before: Group | None, after: Group | None, plan: str) -> Iterator[Wrong]:
    """See that what was before is in a thinner line than what is after, where both are there."""
    widths = [
        [one.style.width for one in walk(() if part is None else (part,)) if isinstance(one, Polyline)]
        for part in (before, after)
    ]
    if all(widths) and max(widths[0]) >= min(widths[1]):
        yield on("thinner", plan)


def explained(part: Group | None, plan: str, text: str, holds: bool) -> Iterator[Wrong]:
    """See that a heading says what the thin line is, where there is one, and else does not."""
    if part is not None and (Text(0j, text).plain in " ".join(lettering(part))) != holds:
        yield on("title", plan, text=text)


def follows(
    chains: Sequence[Sequence[complex]], spots: Sequence[complex], near: float, covers: Iterable[Cover] = ()
) -> bool:
    """Tell whether chains follow a curve: all their corners are on it, and all its spots are corners.

    A curve is cut off by what covers it; one that is covered all along is not to be seen.
    """
    true, drawn = np.array(spots), np.array([corner for chain in chains for corner in chain])
    if len(true) < 2:
        return False
    far = ~np.any([np.zeros(len(true), bool), *(cover.hides(true, near) for cover in covers)], axis=0)
    if not drawn.size:
        return not far.any()
    return bool((_nearest(true[far], drawn) <= near).all()) and all(_off(true, corner) <= near for corner in drawn)


def goes_through(chains: Sequence[Sequence[complex]], runs: Sequence[Sequence[complex]], near: float) -> bool:
    """Tell whether chains follow a curve that gaps cut into runs: each run is met, each chain lies on one of them."""
    long = [np.array(run) for run in runs if len(run) > 1]
    drawn = np.array([corner for chain in chains for corner in chain])
    met = all(drawn.size and (_nearest(run, drawn) <= near).all() for run in long)
    return met and all(any(all(_off(run, corner) <= near for corner in chain) for run in long) for chain in chains)


def _nearest(true: Complexes, drawn: Complexes) -> npt.NDArray[np.float64]:
    return np.array([np.abs(drawn - spot).min() for spot in true])


def _off(true: np.ndarray[tuple[int, ...], np.dtype[np.complex128]], spot: complex) -> float:
    """Give how far a spot is from a chain of true places, mm."""
    starts, steps = true[:-1], np.diff(true)
    sizes = np.maximum(np.abs(steps) ** 2, np.finfo(float).tiny)
    shares = np.clip(((spot - starts) * steps.conj()).real / sizes, 0.0, 1.0)
    return float(np.abs(spot - starts - shares * steps).min())
