"""The diagram of the main sizes where the analysis has it: A or O1, D at any turn (диаграмма S - S', ожидаемая)."""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

from drawings.checks.cam.cam_expected import Expected
from plans.analytic.cam.contour import contour
from plans.model.cam_motion import Contour
from plans.model.motion import Complexes, Floats

DENSE = 1441  # turns of a phase at which the diagram is known
CLOSER = np.linspace(0.0, 1.0, 65)  # of the way to the next one: where it is looked at closer


@dataclass(frozen=True)
class KnownDiagram:
    """The diagram of one cam, in m, and how far on paper something is from it."""

    expected: Expected
    mu: float

    @property
    def zero(self) -> complex:
        """The origin of the diagram, seen from O, m."""
        cam, own = self.expected.cam, self.expected.sizes
        if cam.rocks:
            return own.pivot
        return 1j * own.base if cam.flat else self.lowest

    @property
    def back(self) -> complex:
        """What turns a rocker back from where it stands at the start to S = 0; a cam may begin at its top."""
        return cmath.rect(1.0, -self.expected.cam.rising * float(self.expected.contour.travel.s[0]))

    @property
    def lowest(self) -> complex:
        """Where the tip is at S = 0, seen from O, m."""
        own, pivot = self.expected.contour, self.expected.sizes.pivot
        start, s = complex(own.tip[0]), own.travel.s[0]
        return pivot + (start - pivot) * self.back if self.expected.cam.rocks else complex(start - 1j * s)

    def ends(self, own: Contour) -> Complexes:
        """Give D: on the line of OD, of a flat face S'' across from S."""
        if self.expected.cam.flat:
            return np.asarray(own.travel.bend + 1j * own.travel.s)
        return np.asarray(own.lever - self.zero)

    def off(self, spots: Complexes) -> Floats:
        """Give how far places are on paper from the nearest point of the diagram, mm, (N,)."""
        cam, found = self.expected.cam, [np.full(len(spots), np.inf)]
        for phase, before in product(cam.moving(), (False, True)):
            turned = np.linspace(phase.start, phase.end, DENSE)
            known = self._known(turned, before)
            nearest = _nearest(known, spots)[:, None]
            there = turned[nearest] + (turned[1] - turned[0]) * CLOSER
            closer = self._known(there.ravel(), before).reshape(there.shape)
            found.append(np.abs(closer - spots[:, None]).min(axis=1) / self.mu)
        return np.asarray(np.min(found, axis=0))

    def _known(self, turned: Floats, before: bool) -> Complexes:
        own = self.expected
        return self.ends(contour(own.cam, own.sizes, own.found.roller, turned, before))


def _nearest(known: Complexes, spots: Complexes) -> npt.NDArray[np.intp]:
    """Give which chord is nearest to each of some places, (N,)."""
    way, run = spots[:, None] - known[:-1], np.diff(known)
    share = np.clip((way * run.conj()).real / np.maximum(np.abs(run) ** 2, np.finfo(float).tiny), 0.0, 1.0)
    return np.asarray(np.abs(way - share * run).argmin(axis=1))
