"""The laws of motion by their closed forms (законы движения толкателя в замкнутом виде, M2.2 of every handbook)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from plans.model.cam import CUBICS, LINES, SHAPE, SOFTNESSES, TABLE, Cam, Law, Phase
from plans.model.cam_motion import FollowerTravel, Shock
from plans.model.motion import Floats


class Beam(NamedTuple):
    """A bent beam: its points in shares of the phase, s there and the slopes there, (N,)."""

    share: Floats
    s: Floats
    slopes: Floats


Rates: TypeAlias = tuple[Floats, Floats, Floats]  # s, s', s'' at shares of a phase, (N,) each
Closed: TypeAlias = Callable[[Law, Floats, bool], Rates]  # by a law, shares, before a joint or after


def along_table(law: Law, k: Floats, before: bool) -> Rates:
    """Follow a table."""
    share, s = np.array(law.points, dtype=float).T
    if law.through == LINES:
        slopes = np.diff(s) / np.diff(share)
        return np.interp(k, share, s), slopes[_interval(share, k, before)], np.zeros_like(k)
    return _hermite(beam(law), k, before)


def along_shape(law: Law, k: Floats, before: bool) -> Rates:
    """Follow a shape of acceleration."""
    share, a = np.array(law.points, dtype=float).T
    wide, low, high = np.diff(share), a[:-1], a[1:]
    areas = wide * (low + high) / 2
    moments = share[:-1] * areas + wide**2 * (low + 2 * high) / 6  # about the start of the phase
    passed, turned = (np.concatenate([[0.0], np.cumsum(part)]) for part in (areas, moments))
    piece = _interval(share, k, before)
    t, rise = k - share[piece], (high - low)[piece] / wide[piece]
    s = k * passed[piece] - turned[piece] + t**2 * (low[piece] / 2 + rise * t / 6)
    whole = passed[-1] - turned[-1]
    return s / whole, (passed[piece] + t * (low[piece] + rise * t / 2)) / whole, (low[piece] + rise * t) / whole


GIVEN: Final[Mapping[str, Closed]] = {TABLE: along_table, SHAPE: along_shape}


def _interval(share: Floats, k: Floats, before: bool) -> np.ndarray[tuple[int], np.dtype[np.int_]]:
    """Give the interval of points, one beyond the other, that each share lies in."""
    interval = np.searchsorted(share, k, side="left" if before else "right") - 1
    solid = np.flatnonzero(np.diff(share) > 0)
    return np.asarray(np.clip(interval, solid[0], solid[-1]), dtype=int)


def _hermite(bent: Beam, k: Floats, before: bool) -> Rates:
    """Follow each interval by the cubic that has the ordinates and slopes of its ends."""
    piece = _interval(bent.share, k, before)
    h, rise = np.diff(bent.share)[piece], np.diff(bent.s)[piece]
    x = (k - bent.share[piece]) / h
    left, right = bent.slopes[piece] * h - rise, rise - bent.slopes[piece + 1] * h
    first = bent.s[piece] + rise * x + x * (1 - x) * (left * (1 - x) + right * x)
    second = rise + left * (1 - x) * (1 - 3 * x) + right * x * (2 - 3 * x)
    third = left * (6 * x - 4) + right * (2 - 6 * x)
    return first, second / h, third / h**2


@lru_cache(maxsize=64)
def beam(law: Law) -> Beam:
    """Lay the beam through a table's points, or on the softest springs that let it depart by its tolerance at most."""
    share, y = np.array(law.points, dtype=float).T
    yielding, low, high = y, 0, len(SOFTNESSES) if law.tolerance > 0 else 0
    sag = _influence(share[1:-1])
    while low < high:
        middle = (low + high - 1) // 2
        found = _sprung(SOFTNESSES[middle], sag, share, y)
        if np.max(np.abs(found - y)) <= law.tolerance:
            yielding, low = found, middle + 1
        else:
            high = middle
    return Beam(share, yielding, _slopes(share, yielding))


def _influence(x: Floats) -> Floats:
    """Give how far a clamped beam of stiffness 1 gives at each point under a force of 1 at each other, (N, N)."""
    near, far = np.minimum(x, x[:, None]), np.maximum(x, x[:, None])
    return np.asarray(near**2 * (1 - far) ** 2 * (3 * far - near * (1 + 2 * far)) / 6)


def _sprung(softness: float, sag: Floats, share: Floats, y: Floats) -> Floats:
    """Let springs draw the beam to the points within; each gives by its softness times its force, (N,)."""
    free = share[1:-1]
    unloaded = y[0] + (y[-1] - y[0]) * free**2 * (3 - 2 * free)
    forces = np.linalg.solve(sag + softness * np.eye(len(free)), y[1:-1] - unloaded)
    return y - softness * np.array([0.0, *forces, 0.0])


def _slopes(share: Floats, s: Floats) -> Floats:
    """Give the slopes at the points that leave no jump of curvature: none at both ends, (N,)."""
    stiff, chords = 1 / np.diff(share), np.diff(s) / np.diff(share)
    slopes = np.zeros_like(s)
    if len(s) > 2:
        matrix = np.diag(2 * (stiff[:-1] + stiff[1:])) + np.diag(stiff[1:-1], 1) + np.diag(stiff[1:-1], -1)
        slopes[1:-1] = np.linalg.solve(matrix, 3 * (stiff[:-1] * chords[:-1] + stiff[1:] * chords[1:]))
    return slopes


PI = np.pi


def _velocity(_: Law, k: Floats, before: bool) -> Rates:
    return k, np.ones_like(k), np.zeros_like(k)


def _acceleration(law: Law, k: Floats, before: bool) -> Rates:
    q, left = law.first, 1 - k
    early = k <= law.first if before else k < law.first
    r = 1 - q
    return (
        np.where(early, k**2 / q, 1 - left**2 / r),
        np.where(early, 2 * k / q, 2 * left / r),
        np.where(early, 2 / q, -2 / r),
    )


def _cosine(_: Law, k: Floats, before: bool) -> Rates:
    x = PI * k
    return (1 - np.cos(x)) / 2, PI / 2 * np.sin(x), PI**2 / 2 * np.cos(x)


def _sine(_: Law, k: Floats, before: bool) -> Rates:
    x = 2 * PI * k
    return k - np.sin(x) / (2 * PI), 1 - np.cos(x), 2 * PI * np.sin(x)


def _p345(k: Floats) -> Rates:
    return k**3 * (10 - 15 * k + 6 * k**2), 30 * k**2 * (1 - k) ** 2, 60 * k * (1 - k) * (1 - 2 * k)


def _p4567(k: Floats) -> Rates:
    s = k**4 * (35 - 84 * k + 70 * k**2 - 20 * k**3)
    return s, 140 * k**3 * (1 - k) ** 3, 420 * k**2 * (1 - k) ** 2 * (1 - 2 * k)


def _half(first: Callable[[Floats], Rates]) -> Closed:
    """Give a law of which the second half is the first one turned about the middle, so that its end loses no digit."""

    def whole(_: Law, k: Floats, before: bool) -> Rates:
        s, slope, bend = first(np.minimum(k, 1 - k))
        early = k <= 0.5
        return np.where(early, s, 1 - s), slope, np.where(early, bend, -bend)

    return whole


def _joined(k: Floats, ramp: Rates, flat: Rates, last: Rates) -> Rates:
    """Join the parts of half a law: to an eighth, to three, to the middle."""
    bounds = [k < 1 / 8, k < 3 / 8]
    s, slope, bend = (np.select(bounds, [*kept[:2]], kept[2]) for kept in zip(ramp, flat, last, strict=True))
    return s, slope, bend


def _trapezoid(k: Floats) -> Rates:
    a, q = 16 / 3, 1 / 8
    ramp = (a * k**3 / (6 * q), a * k**2 / (2 * q), a * k / q)
    x = k - q
    flat = (a * q**2 / 6 + a * q * x / 2 + a * x**2 / 2, a * q / 2 + a * x, np.full_like(k, a))
    y = 0.5 - k
    last = (0.5 - 2 * y + a * y**3 / (6 * q), 2 - a * y**2 / (2 * q), a * y / q)
    return _joined(k, ramp, flat, last)


def _modified_trapezoid(k: Floats) -> Rates:
    big = 8 * PI / (2 + PI)
    c, q = big / (4 * PI), 1 / 8
    ramp = (c * (k - np.sin(4 * PI * k) / (4 * PI)), c * (1 - np.cos(4 * PI * k)), big * np.sin(4 * PI * k))
    sq, x = c * (q - 1 / (4 * PI)), k - q
    flat = (sq + c * x + big * x**2 / 2, c + big * x, np.full_like(k, big))
    y = k - 3 * q
    s = sq + c / 4 + big / 32 + (c + big / 4) * y + c / (4 * PI) * (1 - np.cos(4 * PI * y))
    last = (s, c + big / 4 + c * np.sin(4 * PI * y), big * np.cos(4 * PI * y))
    return _joined(k, ramp, flat, last)


def _modified_sine(k: Floats) -> Rates:
    big = 4 * PI**2 / (4 + PI)
    c, q = big / (4 * PI), 1 / 8
    ramp = (c * (k - np.sin(4 * PI * k) / (4 * PI)), c * (1 - np.cos(4 * PI * k)), big * np.sin(4 * PI * k))
    x = PI / 3 + 4 * PI * k / 3
    sq = c * (q - 1 / (4 * PI))
    rest = (sq + c * (k - q) - 9 * big / (16 * PI**2) * (np.sin(x) - 1), c - 3 * c * np.cos(x), big * np.sin(x))
    s, slope, bend = (np.where(k < q, *parts) for parts in zip(ramp, rest, strict=True))
    return s, slope, bend


LAWS: Final[Mapping[str, Closed]] = {
    "constant velocity": _velocity,
    "constant acceleration": _acceleration,
    "cosine": _cosine,
    "sine": _sine,
    "3-4-5": _half(_p345),
    "4-5-6-7": _half(_p4567),
    "trapezoid": _half(_trapezoid),
    "modified trapezoid": _half(_modified_trapezoid),
    "modified sine": _half(_modified_sine),
    **GIVEN,
}
SLACK: Final = 4 * float(np.finfo(np.float64).eps)  # roundings of a place on the turn by which it may miss its share


def breaks(law: Law) -> tuple[float, ...]:
    """Give the shares of a phase, within it, at which the closed form of its law changes by a jump."""
    if law.name == "constant acceleration":
        return (law.first,)
    if law.name == SHAPE or (law.name == TABLE and law.through != CUBICS):
        return tuple(sorted({share for share, _ in law.points if 0 < share < 1}))
    return ()


def limits(law: Law, share: float, order: int, before: bool) -> float:
    """Give the limit of s, s' or s'' at a share of the phase, from before it or from after it."""
    return float(LAWS[law.name](law, np.array([share]), before)[order][0])


def travel(cam: Cam, turned: Floats, before: bool = False) -> FollowerTravel:
    """Give S, S', S'' at turns of the cam, (N,); where two laws meet those of the later one, or of the one before.

    Before the beginning of a turn is the end of the last one; a cam that translates has none before.
    """
    phi = np.asarray(turned, dtype=float)
    if before:
        phi = np.where(phi == 0.0, 0.0 if cam.translates else cam.turn, phi)
    found = np.zeros((3, len(phi)))
    # A phase ends where the next one starts: the sum of its start and its angle may be off that by a rounding.
    interval = np.searchsorted([phase.start for phase in cam.phases], phi, side="left" if before else "right") - 1
    for number, phase in enumerate(cam.phases):
        here = np.maximum(interval, 0) == number
        found[:, here] = _within(phase, phi[here], before)
    return FollowerTravel(*found)


def _within(phase: Phase, phi: Floats, before: bool) -> Floats:
    """Give S, S', S'' within a phase, (3, N): those of a return fall from the lift by 1 - s."""
    if phase.law is None:
        return np.array([np.full_like(phi, phase.level), 0 * phi, 0 * phi])
    k, closed = _shares(phase, phase.law, phi), LAWS[phase.law.name]
    s, *rates = closed(phase.law, k, before)
    ways = (phase.change * rate / phase.angle**order for order, rate in enumerate(rates, 1))
    return np.array([phase.level + phase.change * s, *ways])


def _shares(phase: Phase, law: Law, phi: Floats) -> Floats:
    """Give the shares of a phase at turns of the cam: a turn that is that of a break but for roundings is on it."""
    k = np.clip((phi - phase.start) / phase.angle, 0.0, 1.0)
    for share in breaks(law):
        k = np.where(np.abs(k - share) <= SLACK * phase.end / phase.angle, share, k)
    return np.asarray(k)


REST = (0.0, 0.0)
# A sine of a half turn leaves half an eps of its amplitude, a law by points an eps for each: of the largest S' or S''.
NOTHING = 4096 * float(np.finfo(np.float64).eps)


class Seam(NamedTuple):
    """Where two laws or two parts of one meet, rad, and S' and S'' before and after it."""

    turned: float
    before: tuple[float, float]
    after: tuple[float, float]


def shocks(cam: Cam) -> tuple[Shock, ...]:
    """Find where S' jumps, a hard shock, or S'' alone, a soft one."""
    seams = sorted(_seams(cam))
    most = [max(_usual(cam, k + 1), *(abs(side[k]) for seam in seams for side in seam[1:])) for k in (0, 1)]
    return tuple(shock for seam in seams for shock in _shock(seam, most))


def _usual(cam: Cam, order: int) -> float:
    """Give the mean S' of the steepest phase, or what it comes to once more by its angle."""
    return max((abs(phase.change) / phase.angle**order for phase in cam.phases if phase.change), default=0.0)


def _shock(seam: Seam, most: list[float]) -> Iterator[Shock]:
    for order, (earlier, other) in enumerate(zip(seam.before, seam.after, strict=True), 1):
        if abs(other - earlier) > NOTHING * most[order - 1]:
            yield Shock(seam.turned, order, other - earlier)
            return


def _seams(cam: Cam) -> Iterator[Seam]:
    """Give the seams between phases, each last one before the first, and those within the laws."""
    phases = [phase for phase in cam.phases if phase.angle > 0]
    ends = [(_side(phase, 0.0, False), _side(phase, 1.0, True)) for phase in phases]
    yield Seam(0.0, REST if cam.translates else ends[-1][1], ends[0][0])
    for (_, before), (after, _), phase in zip(ends, ends[1:], phases[1:], strict=False):
        yield Seam(phase.start, before, after)
    if cam.translates:
        yield Seam(cam.turn, ends[-1][1], REST)
    for phase in phases:
        for share in breaks(phase.law) if phase.law else ():
            yield Seam(phase.start + share * phase.angle, _side(phase, share, True), _side(phase, share, False))


def _side(phase: Phase, share: float, before: bool) -> tuple[float, float]:
    """Give S' and S'' on one side of a share of a phase."""
    if phase.law is None:
        return REST
    first, second = (limits(phase.law, share, order, before) for order in (1, 2))
    return phase.change / phase.angle * first, phase.change / phase.angle**2 * second
