"""Tasks whose mechanisms are found by their extreme positions: swing or stroke, overlap (синтез по крайним положениям).

Values alone, SI: m, rad. A rocker turns about C = 0, its middle position straight up; of a slider the middle of the
stroke is 0, its guide the x axis, and the crank's pivot O lies left of it, not above the guide.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from plans.model.synthesis.pace import IDLE, Pace, told

TOWARDS, BEYOND = 1, -1  # the centre M of the circle on the rocker's side of the chord, or beyond it
CENTRES: Final = {TOWARDS: "M", BEYOND: "M'"}  # of the circles, by their sides


def overlap_of(ratio: float) -> float:
    """Give the overlap angle rad of a coefficient of mean speeds K.

    >>> round(math.degrees(overlap_of(1.5)), 6)
    36.0
    """
    return math.pi * (ratio - 1) / (ratio + 1)


class RockerTask(NamedTuple):
    """A crank-rocker is wanted: length of its rocker m, swing psi and overlap theta rad (угол перекрытия).

    One parameter is free: the frame m, or the angle rad at M of the ray to O, told or the best: that with the largest
    least transmission angle. It is asked of one circle of the two, by its side, or of both.
    """

    rocker: float
    swing: float
    overlap: float
    frame: float | None = None
    place: float | None = None
    side: int | None = None
    best: bool = False

    @property
    def half(self) -> float:
        """Half of the chord between the extreme places of the rocker's end, m."""
        return self.rocker * math.sin(self.swing / 2)

    @property
    def height(self) -> float:
        """The distance of the chord from C, m."""
        return self.rocker * math.cos(self.swing / 2)

    @property
    def sides(self) -> tuple[int, ...]:
        """The circles that O may lie on; with no overlap it lies on a line."""
        return ((TOWARDS, BEYOND) if self.overlap else (TOWARDS,)) if self.side is None else (self.side,)

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        place = None if self.best else self.place
        return told(l_3=self.rocker, ψ=self.swing, θ=self.overlap, l_4=self.frame, φ=place)


class DoubleCrankTask(NamedTuple):
    """A double crank is wanted (двухкривошипный механизм): a crank-rocker whose crank is fixed has the same indices.

    Its coupler was the rocker, its driver the frame.
    """

    inverted: RockerTask

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        letters = {"l_3": "l_2", "l_4": "l_1"}
        return {letters.get(name, name): one for name, one in self.inverted.asked.items()}


class SliderTask(NamedTuple):
    """A slider-crank is wanted: its stroke m, and of offset m, overlap rad, ratio l2/l1, pressure angle rad some.

    With the overlap alone O is free on its circle: it is put where it is best, an angle rad at M from B2 on.
    """

    stroke: float
    offset: float | None = None
    overlap: float | None = None
    ratio: float | None = None
    pressure: float | None = None
    turned: float | None = None
    pace: Pace = IDLE

    @property
    def demands(self) -> tuple[str, ...]:
        """The demands beside the stroke, by their names.

        >>> SliderTask(0.12, 0.03, ratio=5.0).demands
        ('offset', 'ratio')
        """
        return tuple(name for name in self._fields[1:5] if getattr(self, name) is not None)

    @property
    def asked(self) -> dict[str, float]:
        """The demands by their letters."""
        found = told(H=self.stroke, e=self.offset, θ=self.overlap, λ=self.ratio, α_max=self.pressure)
        return found | self.pace.asked

    @property
    def similar(self) -> bool:
        """Whether a pressure angle is met by a similar figure: beside a ratio, or with O on the guide."""
        return self.pressure is not None and (self.ratio is not None or not (self.offset or self.overlap))

    def only(self, *demands: str) -> SliderTask:
        """Give the task with these demands alone."""
        return SliderTask(self.stroke, pace=self.pace, **{name: getattr(self, name) for name in demands})

    @property
    def readings(self) -> tuple[SliderTask, ...]:
        """The tasks that it may mean: two demands fix the mechanism, and one does with no offset.

        >>> [one.demands for one in SliderTask(0.12, 0.03, 0.113, 5.0).readings]
        [('overlap', 'ratio'), ('offset', 'overlap'), ('offset', 'ratio')]
        """
        names = self.demands
        if len(names) <= PAIR:
            return (self,)
        pairs = [(first, last) for k, first in enumerate(names) for last in names[k + 1 :]]
        return tuple(self.only(*pair) for pair in sorted(pairs, key=lambda pair: "offset" in pair))


PAIR: Final = 2
