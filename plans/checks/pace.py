"""The pace that a machine gives its crank: true speed and acceleration in every position (истинный закон движения)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from geometry.errors import ConstructionError
from plans.analytic.dynamics.speeds import Swing
from plans.checks.compare import compare
from plans.checks.dynamics_comparison import compare_dynamics
from plans.dynamics.form import DYNAMICS, DynamicsForm
from plans.model.motion import Floats
from plans.model.order import VELOCITIES
from plans.model.rates import Pace, Rates
from plans.words.words import message, placed

if TYPE_CHECKING:
    from plans.dynamics.study import DynamicsStudy
    from plans.study import Study


class NoPace(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """Rates were asked of a machine that does not come to a steady motion."""


def pace_of(study: Study) -> Pace | None:
    """Give the rates of the crank in the steady motion of the machine, where the scene asks for them."""
    scene = study.scene
    if scene.of(DynamicsForm).drive.speed_from != DYNAMICS:
        return None
    dynamics: DynamicsStudy = study["dynamics"]
    found = compare_dynamics(dynamics, compare(dynamics.linkage, VELOCITIES.number))
    motion = found.after or found.before
    if not isinstance(motion, Swing):
        line, column = scene.place(("drive", "speed_from"))
        raise NoPace(placed(f"{scene.file}:{line}:{column}", message("dynamics.no_pace")))
    return _pace(motion, dynamics.reduction.start, dynamics.linkage.sense)


def _pace(motion: Swing, start: float, sense: int) -> Pace:
    def rates(phi: Floats) -> Rates:
        turned = np.mod(sense * (phi - start), 2 * np.pi)
        return Rates(sense * motion.omega(turned), sense * motion.epsilon(turned))

    return rates
