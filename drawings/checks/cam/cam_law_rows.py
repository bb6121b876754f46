"""What the rows of a law's diagrams must show by the analysis: S'', S' and S by its chords (ожидаемые диаграммы)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from drawings.checks.cam.cam_expected import Expected
from drawings.page.drafting import Drafting
from geometry.strips import departure
from plans.analytic.cam.laws import travel
from plans.model.cam_motion import Travel
from plans.model.motion import Floats

HARD, SOFT = 1, 2
SAME = 1e-12  # of a turn: a shock so near to an edge is on it
Sides = tuple[Floats, ...]  # what a curve may be at turns, (N,) each: before and after a jump
Course = Callable[[Floats], Sides]


@dataclass(frozen=True)
class ExpectedRow:
    """A row: its values at the edges after and before a jump, its curve, chords and exact curve at any turns."""

    key: str
    letter: str
    expected: Expected
    after: Floats  # (n + 1,)
    before: Floats
    curve: Course
    chords: Course
    exact: Course
    chorded: bool = True
    impulses: tuple[tuple[float, int], ...] = ()  # where S'' is infinite, rad, and its sense

    @property
    def most(self) -> float:
        """The largest value by its size."""
        return float(max(np.abs(self.after).max(), np.abs(self.before).max()))

    def said(self, drafting: Drafting) -> list[str]:
        """Give what is told under the title: places of shocks, or how far the chords are off at the most, per cent."""
        if self.key == "acceleration":
            return _shocks(self.expected, drafting)
        return [drafting.word("chords off", off=drafting.number(_off(self)))]


def expected_rows(expected: Expected) -> tuple[ExpectedRow, ...]:
    """Give the rows from the top."""
    return _acceleration(expected), _velocity(expected), _travel(expected)


def _letter(expected: Expected) -> str:
    return "ψ" if expected.cam.rocks else "S"


def _exact(expected: Expected, order: int) -> Course:
    """Give the exact course of S or a derivative, on both sides of a jump."""
    return lambda turned: tuple(travel(expected.cam, turned, before)[order] for before in (False, True))


def _acceleration(expected: Expected) -> ExpectedRow:
    exact, cam = _exact(expected, 2), expected.cam
    after, before = _sides(expected, expected.after.bend[:-1], expected.before.bend[1:], (HARD, SOFT))
    rest = (0.0, cam.turn) if cam.translates else ()

    def curve(turned: Floats) -> Sides:
        """Give S'', and 0 where a cam that translates begins and ends."""
        still = np.where(np.isin(turned, rest), 0.0, np.nan)
        return (*(np.asarray(one) for one in exact(turned)), np.where(np.isnan(still), exact(turned)[0], still))

    impulses = tuple((one.turned, 1 if one.jump > 0 else -1) for one in expected.found.shocks if one.order == HARD)
    return ExpectedRow(
        "acceleration", f"{_letter(expected)}''", expected, after, before, curve, curve, curve, False, impulses
    )


def _velocity(expected: Expected) -> ExpectedRow:
    end, gains = expected.compared.chords[0], expected.compared.gains
    begin = end - gains
    slopes = expected.after.bend[:-1], expected.before.bend[1:]
    after, before = _sides(expected, begin, end, (HARD,))
    return ExpectedRow(
        key="velocity",
        letter=f"{_letter(expected)}'",
        expected=expected,
        after=after,
        before=before,
        curve=_with_rest(expected, _piecewise(expected, (begin, end), slopes)),
        chords=_piecewise(expected, (begin, end), (gains / np.diff(expected.edges),) * 2),
        exact=_exact(expected, 1),
    )


def _travel(expected: Expected) -> ExpectedRow:
    (end, s), gains = expected.compared.chords, expected.compared.gains
    chords = np.diff(s) / np.diff(expected.edges)
    return ExpectedRow(
        key="travel",
        letter=_letter(expected),
        expected=expected,
        after=s,
        before=s,
        curve=_piecewise(expected, (s[:-1], s[1:]), (end - gains, end)),
        chords=_piecewise(expected, (s[:-1], s[1:]), (chords, chords)),
        exact=_exact(expected, 0),
    )


def means(expected: Expected, key: str) -> Floats:
    """Give the mean ordinates of the strips, (n,): of S'', or of S'."""
    over = expected.compared.gains if key == "acceleration" else np.diff(expected.compared.chords[1])
    return np.asarray(over / np.diff(expected.edges))


def _piecewise(expected: Expected, ends: tuple[Floats, Floats], slopes: tuple[Floats, Floats]) -> Course:
    """Give a course of cubics by Hermite, through ends with slopes, a strip each; at an edge that of either strip."""
    edges, (first, last), (leaving, coming) = expected.edges, ends, slopes

    def at(turned: Floats) -> Sides:
        places = (np.searchsorted(edges, turned, "right"), np.searchsorted(edges, turned, "left"))
        return tuple(_hermite(turned, np.clip(one - 1, 0, len(first) - 1)) for one in places)

    def _hermite(turned: Floats, k: np.ndarray) -> Floats:
        wide = edges[k + 1] - edges[k]
        t = (turned - edges[k]) / wide
        ends_part = (1 + 2 * t) * (1 - t) ** 2 * first[k] + t**2 * (3 - 2 * t) * last[k]
        return np.asarray(ends_part + wide * (t * (1 - t) ** 2 * leaving[k] - t**2 * (1 - t) * coming[k]))

    return at


def _with_rest(expected: Expected, course: Course) -> Course:
    """Let a course come from what is before the turn and go on to what is after it: the other end, or rest."""
    ends = np.array([0.0, expected.cam.turn])

    def at(turned: Floats) -> Sides:
        own = course(turned)
        other = np.zeros(2) if expected.cam.translates else np.array([course(ends)[1][1], course(ends)[0][0]])
        return (*own, np.where(turned == 0.0, other[0], np.where(turned == ends[1], other[1], own[0])))

    return at


def _sides(expected: Expected, begin: Floats, end: Floats, orders: tuple[int, ...]) -> tuple[Floats, Floats]:
    """Give values after and before the edges; at a shock at its ends a cam that turns goes on from its other end."""
    after, before = np.append(begin, end[-1]), np.append(begin[:1], end)
    cam = expected.cam
    turned = [one.turned for one in expected.found.shocks if one.order in orders]
    if any(one <= SAME * cam.turn for one in turned):
        before[0] = 0.0 if cam.translates else end[-1]
    if cam.translates and any(one >= cam.turn * (1 - SAME) for one in turned):
        after[-1] = 0.0
    return after, before


def _shocks(expected: Expected, drafting: Drafting) -> list[str]:
    """Name the edges at which there are shocks; the end of a turn is its beginning."""
    told = ((key, list(_places(expected, order))) for key, order in (("hard shocks", HARD), ("soft shocks", SOFT)))
    texts = [drafting.word(key, places=", ".join(dict.fromkeys(places))) for key, places in told if places]
    return [";  ".join(texts)] if texts else []


def _places(expected: Expected, order: int) -> Iterator[str]:
    for one in expected.found.shocks:
        if one.order == order:
            yield expected.names[int(np.abs(expected.edges - one.turned).argmin())]


def _off(row: ExpectedRow) -> float:
    """Give how far the chords are off at the most, per cent; what is rounding alone is 0."""
    own, chords = row.expected, row.expected.compared.chords
    exact: Travel = own.before
    found = departure(chords[0], exact.slope[1:]) if row.key == "velocity" else departure(chords[1], own.after.s)
    return 100 * found.share if found.share > ROUNDED else 0.0


ROUNDED = 1e-9  # of the largest value: the chords' own steps
