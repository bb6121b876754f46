"""What must stand on the sheets of transfer functions, by the analysis alone (что должно быть на листе)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import numpy as np

from drawings.checks.expected import Expected, by_hand, by_roads, course
from drawings.checks.hold import stated_keys
from drawings.lettering.transfer_letters import named
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Key, Kind, Leaf
from plans.linkage.plan import PlanLetters
from plans.linkage.special_points import AnalysedSpecial
from plans.model.mechanism import FRAME
from plans.model.motion import Motion
from plans.model.triad import Triad
from plans.study import Study
from plans.transfer.quantities import TransferComparison, by_scales, listed
from plans.transfer.study import TransferStudy, output_functions
from plans.transfer.turned import TRANSFER

VALUES, SHORT = "values", 0.1  # mm: a shorter vector may be a point
FAR = 1e-9  # of what a graph goes through: both roads agree far better
STEPS, TURN = 720, 360.0  # of a turn, its degrees


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's transfer functions."""
    table = _ExpectedTransfer(study.of(TransferStudy), study.of(TransferComparison), drafting_of(study.scene), leaves)
    yield from chain(table.schemes(), table.graphs(), table.values())


@dataclass(frozen=True, eq=False, repr=False)
class _ExpectedTransfer:
    """Transfer functions by the analysis, and the sheets that show them."""

    study: TransferStudy
    comparison: TransferComparison
    drafting: Drafting
    leaves: Sequence[Leaf]

    @property
    def motion(self) -> Motion:
        return self.comparison.analysis

    @cached_property
    def keys(self) -> frozenset[Key]:
        return frozenset(chain(*map(stated_keys, self.leaves)))

    @cached_property
    def scales(self) -> Mapping[str, float]:
        return {name: mu for leaf in self.leaves for name, mu in leaf.metadata["scales"].items()}

    @cached_property
    def positions(self) -> list[int]:
        return [k for leaf in self.leaves[:1] for k in leaf.metadata["turned"]]

    def _slack(self, plan: str, k: int) -> float:
        return 2 * max((float(row.allowed[k]) for row in self.comparison.even.of(plan)), default=0.0)

    def schemes(self) -> Iterator[Expected]:
        """Give the points of each scheme, and the vectors of its turned plan."""
        pivot = self.study.linkage.mechanism.drive.pivot
        for k in (k for k in self.positions if f"turned-{k}" in self.scales):
            for name, moved in self.motion.points.items():
                if name != pivot:
                    yield Expected(Kind.POINT, TRANSFER, name, complex(moved.r[k]), self._slack("positions", k), k)
            yield from self._vectors(k, SHORT * self.scales[f"turned-{k}"])

    def _vectors(self, k: int, short: float) -> Iterator[Expected]:
        """Give the vectors between images that are stated; those of moving points from the pole must be."""
        mechanism, slack = self.study.linkage.mechanism, self._slack("velocities", k)
        letters, pole = PlanLetters(mechanism), mechanism.drive.pivot
        written = {name: mark.name for name, mark in self.study.turned.images.items()}
        images = {f"{name}'": -1j * value for name, value in self._under(letters, k)}
        images |= {f"{letters.small(name)}'": -1j * v for name, v in self._specials(k)}
        images |= {written[name]: -1j * complex(moved.v[k]) for name, moved in self.motion.points.items()} | {pole: 0j}
        moving = {written[name] for name in self.motion.points if name not in mechanism.links[FRAME].points}
        due = {f"{pole} {name}" for name in moving if abs(images[name]) > short + slack}
        stated = {name for kind, plan, name, at in self.keys if (kind, plan, at) == (Kind.VECTOR, TRANSFER, k)}
        for name in sorted(due | stated):
            start, _, end = name.partition(" ")
            if start in images and end in images:
                value = images[end] - images[start]
                yield Expected(Kind.VECTOR, TRANSFER, name, value, slack, k, may_lack=name not in due)

    def _specials(self, k: int) -> Iterator[tuple[str, complex]]:
        """Give the velocities of the special points of triads."""
        linkage = self.study.linkage
        written = linkage.drafts().velocities.written
        for triad in (group for group in linkage.groups if isinstance(group, Triad)):
            special = AnalysedSpecial(linkage.mechanism, self.motion, written, triad)
            yield special.name, complex(special.moved(1)[k])

    def _under(self, letters: PlanLetters, k: int) -> Iterator[tuple[str, complex]]:
        """Give the velocities of each link's places under pins, and of the point by which it is placed."""
        mechanism = self.study.linkage.mechanism
        pins = {slide.point for slide in mechanism.slides} | mechanism.hinges.keys()
        for number, link in mechanism.links.items():
            name = next(iter(link.points))
            omega = 0.0 if number == FRAME else self.motion.links[number].omega[k]
            for pin in pins:
                arm = self.motion.points[pin].r[k] - self.motion.points[name].r[k]
                yield letters.under(pin, number), complex(self.motion.points[name].v[k] + 1j * omega * arm)
            if not omega:
                yield letters.of_link("n", number), complex(self.motion.points[name].v[k])

    def graphs(self) -> Iterator[Expected]:
        """Give the output's transfer functions over the turn, and their ordinates at the positions."""
        of = output_functions(self.study)
        if of is None:
            return
        linkage, turned = self.study.linkage, np.linspace(0.0, TURN, STEPS + 1)
        phi = np.append(linkage.turn.phi[0], linkage.turn.phi[0] + linkage.sense * np.radians(turned))
        dense = [row[1:] for row in of.rows(self.comparison.even.road.around(phi))]
        stations = np.degrees(linkage.sense * (linkage.turn.phi - linkage.turn.phi[0])) % TURN
        for order, (name, values, at) in enumerate(zip(of.names, dense, of.rows(self.motion), strict=True), 1):
            allowed = next(float(np.nanmax(row.allowed)) for row in self.comparison.findings if row.name == name)
            free = not np.isnan(values).any()
            slack = allowed + FAR * float(np.ptp(values)) if free else math.inf
            low, high = (0.0, TURN) if free else _swing(stations[~np.isnan(at)])
            figure, value = f"transfer-{order}", course(turned, values)
            yield Expected(Kind.CURVE, figure, name, value, slack, ends=(low, high), may_lack=not free)
            for k, ordinate in enumerate(at.tolist()):
                yield Expected(Kind.VECTOR, figure, str(k), 1j * ordinate, allowed, k, may_lack=True)

    def values(self) -> Iterator[Expected]:
        """Give the cells of the table of values."""
        for k in self.positions:
            errors = by_scales(self.comparison.findings, self.scales, k)
            for found in listed(self.comparison):
                row, size = named(found, self.drafting.language), (float(found.analysis[k]), float(found.allowed[k]))
                hand = by_hand(errors.get((found.name, k), math.nan), found.largest)
                yield from by_roads(VALUES, row, size, hand, k, self.keys)


def _swing(stations: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> tuple[float, float]:
    """Give from where to where the crank goes that cannot turn fully, counted from the first position of its way."""
    reached = np.unique(stations)
    return 0.0, float(TURN - np.diff(reached, append=reached[0] + TURN).max())
