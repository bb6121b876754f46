"""Which transfer functions a linkage has, and where a motion or the turned plan shows them (передаточные функции)."""

from __future__ import annotations

from typing import Any

import numpy as np

from geometry.board import Reading, Span
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Floats, Motion
from plans.transfer.study import TransferStudy, sliding, turning
from plans.transfer.turned import TurnedPlan


class TransferFunctions:
    """A transfer function of the first order and its derivative, as either road's motion at 1 rad/s has them."""

    def __init__(self, mechanism: Mechanism, of: int | Slide) -> None:
        self.of, self.letter, self.unit = of, ratio_letter(mechanism, of), "" if isinstance(of, int) else "m"

    @property
    def names(self) -> tuple[str, str]:
        """The names of both: u_31 and u_31', S_B' and S_B''."""
        return (self.letter, f"{self.letter}'") if isinstance(self.of, int) else (f"{self.letter}'", f"{self.letter}''")

    def rows(self, motion: Motion) -> tuple[Floats, Floats]:
        """Read both off a motion, (N,) each."""
        if isinstance(self.of, int):
            _, omega, epsilon = motion.links[self.of]
            return omega, epsilon
        _, v, a = motion.points[self.of.point]
        along = np.conj(self.of.way(FRAME).direction)
        return (v * along).real, (a * along).real

    def read(self, plan: TurnedPlan) -> Any:
        """Read the first off the turned plan."""
        if isinstance(self.of, int):
            return np.real(plan.ratio(self.of))
        return np.real(plan.slope(self.of.point) * np.conj(self.of.way(FRAME).direction))

    def shown(self, plan: TurnedPlan) -> Reading | Span:
        """Give what of the turned plan shows the first."""
        return plan.readings[self.of] if isinstance(self.of, int) else Span(plan.pole, plan.images[self.of.point])


def ratio_letter(mechanism: Mechanism, of: int | Slide) -> str:
    """Letter the ratio of a link's turning to the crank's, u_31; the way of a slider's point, S_B."""
    if not isinstance(of, int):
        return f"S_{of.point}"
    crank = mechanism.drive.link
    return f"u_{of}{crank}" if max(of, crank) < 10 else f"u_{of},{crank}"


def functions(mechanism: Mechanism) -> list[TransferFunctions]:
    """List what is told of a mechanism: its links that turn, then its sliders on the frame."""
    found: list[int | Slide] = [*turning(mechanism), *sliding(mechanism)]
    return [TransferFunctions(mechanism, of) for of in found]


def output_functions(study: TransferStudy) -> TransferFunctions | None:
    """Give the transfer functions of the output, which are drawn over the turn; None of one that does neither."""
    link, mechanism = study.linkage.output.link, study.linkage.mechanism
    alike = {n for n, least in mechanism.turning_with.items() if least == mechanism.turning_with[link]}
    found = functions(mechanism)
    own = (c for c in found if not isinstance(c.of, int) and link in (c.of.slider, c.of.owner))
    return next(own, next((course for course in found if isinstance(course.of, int) and course.of in alike), None))
