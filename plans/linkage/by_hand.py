"""What the plans of a linkage drawn by hand may be out in, quantity by quantity (планы от руки)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from geometry.hand_error import SlippingHand, slopes
from geometry.steps import Span
from plans.by_hand import SLIP, Slipping, errors_by_hand
from plans.linkage.drafts import Drafts
from plans.linkage.parts import findings, spans
from plans.linkage.plan import Masses
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ORDERS, POSITIONS, Floats
from plans.quantity import Quantity, Shown


class MotionByHand(NamedTuple):
    """The velocities, accelerations and rates of a linkage as they are read off plans that a hand draws.

    `masses` are the mass centres that no point names, by their letters: link, and place in its own frame.
    """

    study: LinkageStudy
    comparison: MotionComparison
    masses: Masses

    @property
    def parts(self) -> tuple[Quantity, ...]:
        """The parts of all velocities and accelerations by both roads."""
        return findings(self.study, self.comparison, self.masses)

    @property
    def given(self) -> set[str]:
        """What the scene states, by its letters."""
        drive = self.study.mechanism.drive
        if drive.ram is not None:
            return set()  # what a cylinder gives the crank is found
        return {f"{k}_{drive.end}" for k in "va"} if drive.pushed else {f"{k}_{drive.link}" for k in "ωε"}

    def errors(
        self, positions: Sequence[int], scales: Mapping[str, Floats], by: Slipping = slopes
    ) -> dict[str, Floats]:
        """Give within what 95 of 100 drawings are of each quantity, (positions,), in its own unit.

        The names are those of the findings: "v_B", "ω_3", "a^n_BA"; of a vector it is the size. `scales` are those of
        the plans, true units a mm, one for each position. NaN: so near a dead centre that slips tell nothing.
        """
        return errors_by_hand(self.read(self.study.drafts(list(positions))), SlippingHand(SLIP, scales), by)

    def on_sheet(
        self, positions: Sequence[int], scales: Mapping[str, float], by: Slipping = slopes
    ) -> dict[tuple[str, int], float]:
        """Give the errors on drawn figures, by name and position; a position without its plans has none.

        `scales` are those of the figures, true units a mm, by their names: "positions", "velocities-3".
        """
        figures = {k: [o.plan if o is POSITIONS else f"{o.plan}-{k}" for o in ORDERS] for k in positions}
        whole = [k for k in positions if set(figures[k]) <= set(scales) and not self.study.lost[k]]
        if not whole:
            return {}
        rows = {order.plan: np.array([scales[figures[k][order.number]] for k in whole]) for order in ORDERS}
        found = self.errors(whole, rows, by)
        return {(name, k): float(error) for name, row in found.items() for k, error in zip(whole, row, strict=True)}

    def read(self, drafts: Drafts) -> dict[str, Shown]:
        """Give where the plans of some positions show what is read off them, by its letters."""
        found: dict[str, Shown] = {}
        fixed = self.study.mechanism.links[FRAME].points
        for order in ORDERS[1:]:
            plan = drafts.plan(order.number)
            moving = [name for name in self.comparison.construction.points if name not in fixed]
            found |= {f"{order.point.symbol}_{name}": Span(plan.pole, plan.point(name)) for name in moving}
            found |= {f"{order.link.symbol}_{link}": reading for link, reading in plan.readings.items()}
        return found | spans(self.study, drafts, self.comparison.analysis, self.masses)
