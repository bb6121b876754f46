"""The pieces of a cam's profile timed and judged: how far arcs and cubics are off, by their number (куски профиля)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from plans.bench.clock import interleaved
from plans.bench.convergence import order
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.cam.path import ProfilePath, path
from plans.model.cam import Cam
from plans.model.cam_motion import Sizes

COUNTS: Final = (36, 72, 144, 288)  # cubics to the turn
PIECES, POINT = "profile: arcs and cubics", "Q"
DEFINED = (
    "pieces: how far arcs and cubics are at most from the exact profile, in shares of the length of its base circle's "
    "radius or of the lift; positions are the pieces of a whole turn"
)


def rows(
    cam: Cam, sizes: Sizes, away: float, rounds: int, budget: float, counts: Sequence[int] = COUNTS
) -> tuple[list[Row], list[str]]:
    """Time and judge the pieces of a profile `away` m outward of the pitch curve; give rows, and the order in words."""
    whole = sizes.base or cam.lift
    found = [_path(cam, sizes, away, count)() for count in counts]
    times = interleaved([_path(cam, sizes, away, count) for count in counts], rounds, budget)
    off = [one.deviation for one in found]
    made = [
        Row(PIECES, count, count, Errors({POINT: one / whole}, POINT), times=taken)
        for count, one, taken in zip(counts, off, times, strict=True)
    ]
    if min(off) <= 0:
        return made, [DEFINED]
    return made, [DEFINED, f"  {PIECES}: order {order(off, counts):.2f} from {counts[0]} to {counts[-1]} pieces"]


def _path(cam: Cam, sizes: Sizes, away: float, count: int) -> Callable[[], ProfilePath]:
    return lambda: path(cam, sizes, away, count, exact=False)
