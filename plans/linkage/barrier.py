"""Barriers: parts of the turn that the crank cannot pass, and what fails at either edge of them (преграды)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

SAME = 1e-6  # rad: an edge that touches is known to half the digits of an angle


class Edge(NamedTuple):
    """An edge of a barrier: its crank angle, rad, the first that is barred, and which group fails there, and how."""

    phi: float
    beyond: float
    kind: str  # "change point", "out of reach" or "parallel guides"
    group: int
    where: str  # the mark whose loci miss or touch


class Barrier(NamedTuple):
    """A part of the turn that the crank cannot pass, from one edge counter-clockwise to the other."""

    edges: tuple[Edge, Edge]
    miss: float  # m, the largest miss seen

    @property
    def start(self) -> float:
        """Where it begins, rad."""
        return self.edges[0].phi

    @property
    def end(self) -> float:
        """Where it ends, rad."""
        return self.edges[1].phi

    @property
    def kind(self) -> str:
        """What bars the crank where it begins."""
        return self.edges[0].kind

    @property
    def group(self) -> int:
        """The group that fails where it begins."""
        return self.edges[0].group

    @property
    def where(self) -> str:
        """The mark whose loci miss or touch where it begins."""
        return self.edges[0].where

    @property
    def middle(self) -> float:
        """The angle in the middle of it, rad."""
        return (self.start + self.end) / 2


def bounding(phi: float, home: float, barriers: Sequence[Barrier]) -> Edge | None:
    """Give the edge that keeps the crank from an angle, rad: of the two that bound its way from home, the nearer."""
    if not barriers:
        return None
    turn = 2 * np.pi
    ahead = min((b.edges[0] for b in barriers), key=lambda edge: float(np.mod(edge.phi - home, turn)))
    behind = min((b.edges[1] for b in barriers), key=lambda edge: float(np.mod(home - edge.phi, turn)))
    ways = [abs(float(np.angle(np.exp(1j * (phi - edge.phi))))) for edge in (ahead, behind)]
    return ahead if ways[0] <= ways[1] + SAME else behind
