"""A plan of velocities or accelerations on its sheet with all that the analysis has of it (план на листе)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from drawings.checks.linkage.position_marks import EXACT
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Group, Leaf
from drawings.paper.walk import group_named, groups
from plans.checks.expected import Expected
from plans.linkage.groups.vector_sums import VectorSums
from plans.linkage.letters import POLES
from plans.model.group import Group as AssurGroup


@dataclass(frozen=True, eq=False)
class LaidVectorPlan:
    """A plan of one position on its sheet: its vectors as measured, what the analysis has of it.

    `allowed` is what paper and both roads leave open, mm.
    """

    leaf: Leaf
    plan: str
    expected: Expected
    groups: tuple[AssurGroup, ...]
    vectors: tuple[MeasuredVector, ...]
    allowed: float
    centres: Mapping[str, tuple[int, complex]]
    drafting: Drafting

    @property
    def position(self) -> int:
        """The position."""
        return self.expected.k

    @property
    def near(self) -> float:
        """How far a stroke may be from its true place, mm."""
        return EXACT + self.allowed

    @cached_property
    def figure(self) -> Group | None:
        """The strokes of the plan; None where the sheet has none."""
        name = f"{self.plan}-{self.position}"
        return group_named(self.leaf.groups, name)

    @cached_property
    def pole(self) -> complex | None:
        """The place of the pole on paper."""
        own = (one for one in groups((self.figure,) if self.figure else ()) if one.data.get("kind") == "pole")
        return next((one.strokes[0].centre for one in own if isinstance(one.strokes[0], Circle)), None)

    @property
    def scale(self) -> float:
        """True units a mm."""
        return self.vectors[0].scale if self.vectors else 1.0

    @cached_property
    def sums(self) -> VectorSums:
        """The vector equations by the analysis."""
        return VectorSums(self.expected.mechanism, self.expected.motion, self.position, self.expected.letters)

    @cached_property
    def images(self) -> dict[str, complex]:
        """The true images of all letters, from the pole."""
        found = {POLES[self.plan]: 0j}
        left = {key[1:]: value for key, value in self.expected.arrows(self.groups).items() if key[0] == self.plan}
        while known := {ends: value for ends, value in left.items() if ends[0] in found}:
            for (start, end), value in known.items():
                found.setdefault(end, found[start] + value)
                del left[start, end]
        return found

    def on(self, value: complex) -> complex:
        """Place a true value on paper."""
        return (self.pole or 0j) + value / self.scale
