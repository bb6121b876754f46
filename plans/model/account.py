"""All that a road finds of a machine's motion, put together (динамика машины)."""

from __future__ import annotations

from dataclasses import dataclass

from plans.model.dynamics import Cycle, Flywheel, Reduced, Speeds
from plans.model.motion import Gap
from plans.model.run import Run


@dataclass(frozen=True)
class Account:
    """All that one road finds of a machine's motion; None: not asked for, or told elsewhere why there is none."""

    by: str
    reduced: Reduced
    cycle: Cycle | None = None
    flywheel: Flywheel | None = None
    speeds: Speeds | None = None
    before: Speeds | None = None
    run: Run | None = None

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """No gaps of its own: those of the reduction are the positions', which are compared with them."""
        return ()

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """The gaps of the reduction."""
        return self.reduced.gaps
