"""What is shown of a construction of synthesis: true places in metres, and how much of large circles (что показано)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from plans.model.motion import Complexes
from plans.model.synthesis.design import Design, LocusCircle
from plans.synthesis.drawn import SynthesisFigure
from plans.synthesis.quantities import letter_of
from plans.synthesis.study import SynthesisStudy

NAME = "synthesis"
LETTERS = {"offset": "e", "overlap": "θ", "ratio": "λ", "pressure": "α_{max}"}  # of demands that readings keep
LETTERS |= {"crank": "l_{1}", "frame": "l_{0}", "stroke": "H", "lever": "l_{3}", "distance": "h"}
POINTS = 181  # of an arc
AROUND = 0.7  # of the size of a mechanism, from its middle: what is shown of the lines about it
FINE = 0.03  # of the radius of the view: an angle that opens less across its shorter leg is not dimensioned
ROUNDED = 1e-12  # of the radius of the view: nearer places are one
LARGE = 1.0  # of the size of a mechanism: circles with larger radii are cut


class ShownSynthesis(NamedTuple):
    """A construction with one mechanism of it, by whichever road: what of its design a figure shows."""

    name: str
    letter: str  # of the reading of the task, where there are several
    design: Design
    figure: SynthesisFigure

    @property
    def mechanism(self) -> list[complex]:
        """The places of the mechanism."""
        names = {*self.figure.first, *self.figure.fixed, *(name for chain in self.figure.others for name in chain)}
        return [self.design.places[name] for name in sorted(names)] + [
            complex(spot) for curve in self.design.curves.values() for spot in curve[::6]
        ]

    @property
    def view(self) -> LocusCircle:
        """The circle within which lines are drawn: about the middle of the mechanism."""
        spots = np.array(self.mechanism)
        low, high = (complex(end(spots.real), end(spots.imag)) for end in (np.min, np.max))
        return LocusCircle((low + high) / 2, AROUND * abs(high - low))

    def whole(self, circle: LocusCircle) -> bool:
        """Tell whether a circle is drawn whole: it does not dwarf the mechanism."""
        return circle.radius <= LARGE / AROUND * self.view.radius

    def holds(self, spot: complex) -> bool:
        """Tell whether a place is shown: it is in view, or on a circle that is drawn whole."""
        view, whole = self.view, [circle for circle in self.design.circles.values() if self.whole(circle)]
        return abs(spot - view.centre) <= view.radius or any(
            abs(spot - circle.centre) <= circle.radius * (1 + 1e-9) for circle in whole
        )

    @property
    def places(self) -> dict[str, complex]:
        """The places that are shown; one that is the pole but for rounding is the pole."""
        least = ROUNDED * self.view.radius
        shown = ((name, spot) for name, spot in self.design.places.items() if self.holds(spot))
        return {name: spot if abs(spot) > least else 0j for name, spot in shown}

    @property
    def based(self) -> ShownSynthesis:
        """It measured from a place that it shows: from its mechanism's first where none is at the origin."""
        shows = 0j in self.places.values()
        return self if shows else self._replace(design=self.design.moved(-self.design.places[self.figure.first[0]]))

    @property
    def lengths(self) -> list[tuple[str, ...]]:
        """The dimensioned lengths whose places are shown: letter, ends."""
        return [row for row in self.figure.lengths if self.places.keys() >= {*row[1:]}]

    @property
    def angles(self) -> list[tuple[str, ...]]:
        """The dimensioned angles whose places are shown: letter, vertex, ends of the legs."""
        rows = (row for row in self.figure.angles if self.places.keys() >= {*row[1:]})
        return [row for row in rows if self._opens(*row) > FINE * self.view.radius]

    def _opens(self, letter: str, *corners: str) -> float:
        """Give how far apart the legs of an angle come, m."""
        vertex, *ends = (self.design.places[name] for name in corners)
        return self.design.sizes[letter] * min(abs(end - vertex) for end in ends)

    @property
    def circles(self) -> dict[str, Complexes]:
        """The circles by points: whole, or what of them is in view."""
        return {name: _arc(one, *self._part(one)) for name, one in self.design.circles.items()}

    def _part(self, circle: LocusCircle) -> tuple[float, float]:
        """Give where what is shown of a circle starts, and how far it goes: both circles and their distance."""
        if self.whole(circle):
            return 0.0, math.tau
        away, view = self.view.centre - circle.centre, self.view.radius
        cosine = (abs(away) ** 2 + circle.radius**2 - view**2) / (2 * abs(away) * circle.radius)
        half = math.acos(max(min(cosine, 1.0), -1.0))
        return cmath.phase(away) - half, 2 * half

    @property
    def barred(self) -> dict[str, Complexes]:
        """The arcs that admit no pivot, as far as they are shown."""
        found = {}
        for k, arc in enumerate(self.design.barred, 1):
            whole = _arc(self.design.circles[arc.circle], arc.start, arc.sweep)
            part = np.array([spot for spot in whole if self.holds(complex(spot))])
            if len(part) > 1:
                found[f"{arc.circle} barred {k}"] = part
        return found

    def cut(self, start: complex, end: complex) -> tuple[complex, complex]:
        """Cut a line from a place in view where it leaves the view, if its other end is not shown."""
        if self.holds(end):
            return start, end
        view, way = self.view, (end - start) / abs(end - start)
        from_middle = (start - view.centre) * way.conjugate()
        return start, start + way * (math.sqrt(max(view.radius**2 - from_middle.imag**2, 0.0)) - from_middle.real)

    @property
    def known(self) -> list[complex]:
        """All places that the figure must hold."""
        curves = (complex(spot) for curve in self.circles.values() for spot in curve[::6])
        ends = (self.cut(*(self.design.places[name] for name in line))[1] for line in self.figure.lines)
        return [*self.places.values(), *self.mechanism, *curves, *ends]


def _arc(circle: LocusCircle, start: float, sweep: float) -> Complexes:
    return np.asarray(circle.centre + circle.radius * np.exp(1j * np.linspace(start, start + sweep, POINTS)))


def shown(study: SynthesisStudy) -> Iterator[ShownSynthesis]:
    """Show each construction that gives a mechanism; of several mechanisms the one that is preferred."""
    found = [(k, one) for k, one in enumerate(study.synthesis.readings) if one.found]
    for number, (k, reading) in enumerate(found, 1):
        name, letter = f"{NAME}-{number}" if number > 1 else NAME, letter_of(k) if len(found) > 1 else ""
        if len({one.kept for _, one in found}) > 1:
            letter += f": {', '.join(LETTERS.get(one, one) for one in reading.kept)}"
        figure = study.drawn[k].found[reading.best].figure
        yield ShownSynthesis(name, letter, reading.found[reading.best], figure).based
