"""Tasks of mechanisms with a slot: oscillating and rotating slotted link, sine, tangent (кулисные механизмы).

Values alone, SI: m, rad. Of an oscillating link the pivot C is 0, its middle position straight up, O above it; of a
rotating one and of a sine mechanism O is 0; of a tangent one the foot E of O on the guide, which is the y axis.
"""

from __future__ import annotations

from collections.abc import Collection
from itertools import combinations
from typing import Any, NamedTuple, TypeVar

from plans.model.synthesis.pace import IDLE, Pace, told


class LeverTask(NamedTuple):
    """An oscillating slotted link is wanted (качающаяся кулиса): its overlap rad, which is its swing, and lengths m.

    The stroke is the chord of the arc of its end B; a rod to a ram leans at most at the pressure angle rad.
    """

    overlap: float | None = None
    crank: float | None = None
    frame: float | None = None
    stroke: float | None = None
    lever: float | None = None
    pressure: float | None = None
    pace: Pace = IDLE

    @property
    def driven(self) -> bool:
        """Whether something is asked of the lever's end B."""
        return self.stroke is not None or self.lever is not None

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        lengths = told(l_1=self.crank, l_0=self.frame, l_3=self.lever, H=self.stroke)
        return lengths | told(θ=self.overlap, α_max=self.pressure) | self.pace.asked

    @property
    def readings(self) -> tuple[LeverTask, ...]:
        """The tasks that it may mean: as many demands as fix the figure, none of which the others tell.

        >>> [demands(one, LEVER) for one in LeverTask(0.7, 0.12, 0.35).readings]
        [('overlap', 'crank'), ('overlap', 'frame'), ('crank', 'frame')]
        """
        return _readings(self, LEVER, 3 if self.driven else 2, SAME if self.driven else ())


class WhitworthTask(NamedTuple):
    """A rotating slotted link is wanted (вращающаяся кулиса): overlap rad, crank and frame m, stroke m of a ram.

    The guide of the ram goes through C; its rod leans at most at the pressure angle rad.
    """

    overlap: float | None = None
    crank: float | None = None
    frame: float | None = None
    stroke: float | None = None
    pressure: float | None = None
    pace: Pace = IDLE

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        lengths = told(l_1=self.crank, l_0=self.frame, H=self.stroke)
        return lengths | told(θ=self.overlap, α_max=self.pressure) | self.pace.asked

    @property
    def readings(self) -> tuple[WhitworthTask, ...]:
        """The tasks that it may mean: any two of overlap, crank and frame fix the third."""
        return _readings(self, WHITWORTH, 2)


class SineTask(NamedTuple):
    """A sine mechanism is wanted (синусный механизм): its stroke m."""

    stroke: float
    pace: Pace = IDLE

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        return {"H": self.stroke, **self.pace.asked}

    @property
    def readings(self) -> tuple[SineTask, ...]:
        """The task itself."""
        return (self,)


class TangentTask(NamedTuple):
    """A tangent mechanism is wanted (тангенсный механизм): stroke m, largest pressure angle rad, distance m of guide.

    Any two fix the third; its lever leans to both sides alike, or to one side from the perpendicular of the guide.
    """

    stroke: float | None = None
    pressure: float | None = None
    distance: float | None = None
    one_sided: bool = False

    @property
    def share(self) -> float:
        """The part of the stroke that the lever leads to one side."""
        return 1.0 if self.one_sided else 0.5

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        return told(H=self.stroke, α_max=self.pressure, h=self.distance)

    @property
    def readings(self) -> tuple[TangentTask, ...]:
        """The tasks that it may mean."""
        return _readings(self, TANGENT, 2)


T = TypeVar("T", LeverTask, WhitworthTask, TangentTask)

LEVER = ("overlap", "crank", "frame", "stroke", "lever")
WHITWORTH = ("overlap", "crank", "frame")
TANGENT = ("stroke", "pressure", "distance")
SAME = frozenset(("overlap", "crank", "frame")), frozenset(("overlap", "stroke", "lever"))  # each tells half the swing


def demands(task: NamedTuple, names: Collection[str]) -> tuple[str, ...]:
    """Give those of some demands that a task makes."""
    return tuple(name for name in names if getattr(task, name) is not None)


def _readings(task: T, names: tuple[str, ...], count: int, same: Collection[Collection[str]] = ()) -> tuple[T, ...]:
    every = (one for one in combinations(demands(task, names), count) if frozenset(one) not in same)
    left_out: Any = ({name: None for name in names if name not in kept} for kept in every)
    return tuple(task._replace(**one) for one in left_out)
