"""The marks of a cam's profile that must be there, and where its vectors begin (полнота знаков на профиле кулачка)."""

from __future__ import annotations

from collections.abc import Iterator, Set
from itertools import chain

import numpy as np

from drawings.checks.cam.cam_expected import Expected
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam import follower, inversion, size_marks
from drawings.figures.cam.profile_view import NAME
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.paper.hand import Hand
from plans.model.cam import DWELL
from plans.model.cam_motion import Extreme
from plans.model.motion import Complexes

FAR = 1e-9  # of the cam's reach: both roads agree in a place far better
# mm: the figure looks places between its many turns up along chords; so much is not to be seen on paper.
CHORDED = 0.01
LOOSE = 0.8  # of a bound of what has room: what is nearer to it may be drawn or not
Key = tuple[str, int | None]


def marks(measured: Measured, expected: Expected, origin: complex, mu: float, hand: Hand) -> Iterator[Wrong]:
    """See that no point or size is missing that has room, and that each vector begins where it must."""
    seen = {(one.name, one.position) for one in measured.marks if one.plan == NAME}
    slack = 2 * measured.quantum * mu + FAR * _reach(expected)
    yield from _starts(measured, expected, origin, mu, slack)
    due = chain(_due(expected, seen, mu, hand), _due_sizes(expected, mu, hand))
    yield from (_said("missing", name, k) for name, k in due if (name, k) not in seen)


def _said(key: str, name: str, k: int | None) -> Wrong:
    return on(f"{key}_on", NAME, name=name if k is None else f"{name} {k}")


def _reach(expected: Expected) -> float:
    """Give how far the cam or its pivot is from O, m."""
    return max(float(np.abs(expected.contour.pitch).max()), abs(expected.sizes.pivot))


def _divisions(expected: Expected) -> Complexes:
    """Give the divisions of the follower's way, m: of a face on its axis."""
    tip = expected.contour.tip
    flat = expected.cam.flat and not expected.cam.rocks
    return np.asarray(expected.axis + 1j * tip.imag if flat else tip)


def _due(expected: Expected, seen: Set[Key], mu: float, hand: Hand) -> Iterator[Key]:
    """Give the points that must be there: those that no marked one stands too near to."""
    cam, own = expected.cam, expected.contour
    name = "P" if expected.found.roller else "Q"
    marked = [k for one, k in seen if one == name and k is not None and k < len(own.pitch)]
    crowd = inversion.APART * hand.number * mu
    for k in range(len(own.pitch)):
        if not marked or np.abs(own.pitch[marked] - own.pitch[k]).min() >= crowd:
            yield name, k
    if expected.found.roller:
        yield from (("Q", k) for k in marked)
    if expected.sizes.pivot:
        yield from (("O_1", k) for k in (None, *range(1, len(own.pitch))))
    if not (cam.flat and cam.rocks):
        yield from _due_divisions(expected, seen, mu, hand)


def _due_divisions(expected: Expected, seen: Set[Key], mu: float, hand: Hand) -> Iterator[Key]:
    """Give the divisions that must be there, on the rise and on the return: those that stand apart from others."""
    tips, turned = _divisions(expected), expected.contour.turned
    numbered = [k for name, k in seen if name == "K" and k is not None and k < len(tips)]
    for phase in expected.cam.moving():
        inside = [k for k in range(len(tips)) if phase.start < turned[k] < phase.end]
        ends = [tips[0], *(tips[k] for k in numbered)]
        for k in inside:
            if k not in numbered and np.abs(np.array(ends) - tips[k]).min() >= follower.APART * hand.number * mu:
                yield "K", k


def _due_sizes(expected: Expected, mu: float, hand: Hand) -> Iterator[Key]:
    """Give the sizes that have room for their letters."""
    cam, sizes, least = expected.cam, expected.sizes, size_marks.LEAST * mu / LOOSE
    if cam.translates:
        return
    if sizes.base >= size_marks.ROOM * hand.symbol * mu / LOOSE:
        yield "R_0", None
    if not cam.rocks and abs(sizes.offset) > size_marks.ROUNDED * sizes.base:
        yield "e", None
    if sizes.pivot:
        yield "L", None
    one = expected.found.sharpest
    room = _reach(expected) + size_marks.LARGE * hand.letter * mu
    if one is not None and least <= one.value <= LOOSE * room and not _still(expected, one):
        yield "ρ_min", None


def _still(expected: Expected, one: Extreme) -> bool:
    """Tell whether a least radius is that of a dwell as well."""
    turns = one.turned, one.turned + expected.cam.turn
    near = FAR * expected.cam.turn
    return any(
        phase.kind == DWELL and phase.start - near <= turn <= phase.end + near
        for phase in expected.cam.phases
        for turn in turns
    )


def _starts(measured: Measured, expected: Expected, origin: complex, mu: float, slack: float) -> Iterator[Wrong]:
    """Hold the vectors of the sizes that may point anywhere, and where all of them begin or end."""
    seen = {one.name: one for one in measured.vectors if one.plan == NAME and one.position is None}
    places = {name: ((one.start - origin) * mu, (one.end - origin) * mu) for name, one in seen.items()}
    if "R_0" in seen and not _from_centre(places["R_0"], expected.sizes.base, slack):
        yield on("differs_on", NAME, name="R_0")
    if "L" in seen and not abs(places["L"][0]) <= slack:
        yield on("differs_on", NAME, name="L")
    if "e" in seen and not abs(places["e"][0].real) <= slack:
        yield on("differs_on", NAME, name="e")
    if "ρ_min" in seen and not _osculates(seen["ρ_min"], places["ρ_min"], expected, slack):
        yield on("differs_on", NAME, name="ρ_min")
    pitch = expected.contour.pitch
    for one in (one for one in measured.vectors if one.plan == NAME and one.name == "Q"):
        k = len(pitch) if one.position is None else one.position
        if not (k < len(pitch) and abs((one.start - origin) * mu - pitch[k]) <= slack):
            yield _said("differs", "Q", one.position)


def _from_centre(ends: tuple[complex, complex], size: float, slack: float) -> bool:
    return abs(ends[0]) <= slack and abs(abs(ends[1]) - size) <= slack


def _osculates(one: MeasuredVector, ends: tuple[complex, complex], expected: Expected, slack: float) -> bool:
    """Tell whether a least radius is that of the analysis, and goes to the pitch curve where it is so."""
    least = expected.found.sharpest
    if least is None or not abs(abs(one.value) - abs(least.value)) <= slack:
        return False
    return abs(ends[1] - expected.at(least.turned)) <= slack + CHORDED * one.scale
