"""The machine before or after balancing: its mass centre and its forces over the scene's positions and over a turn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from geometry.precision import condition
from plans.balance.mass_centre import Drawing, MainPoints, centre_drawing
from plans.forces.statics import Statics
from plans.linkage.assembly_limits import at_angles
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.drafts import Drafts
from plans.linkage.margin import meeting
from plans.linkage.study import BLOCK, LinkageStudy
from plans.model.balance.linkage import CONSTRUCTION, STEPS, MassCentre, State
from plans.model.kinetostatics import Kinetostatics
from plans.model.motion import Floats
from plans.model.order import ACCELERATIONS


def state(points: MainPoints, statics: Statics) -> State:
    """Give the state of a machine whose main points are known; `statics` are the forces of that machine."""
    study = statics.study
    centre = mass_centre(points, study, study.turn)
    around = mass_centre(points, study, positions_around(study)) if turns(study) else centre
    return State(centre, around, forces_around(statics), _magnified(study))


def _magnified(study: LinkageStudy) -> Floats:
    """Give kappa of the worst meeting of a group over the positions of a turn: by so much it magnifies rounding."""
    drafts = Drafts(study, positions_around(study))
    found = np.ones(len(drafts.turn))
    for group in study.groups:
        found = np.fmax(found, condition(meeting(drafts.positions, group)))
    return found


def turns(study: LinkageStudy) -> bool:
    """Tell whether the crank turns fully."""
    return study.assembly.phi is not None and not study.barriers


def positions_around(study: LinkageStudy) -> CrankPositions:
    """Divide a whole turn from the first position on into even steps; of a crank that has none the scene's positions.

    The last position of a turn is the first once more.
    """
    if not turns(study):
        return study.turn
    phi = study.turn.phi[0] + study.sense * 2 * np.pi * np.arange(STEPS + 1) / STEPS
    return at_angles(phi).paced(study.pace)


def forces_around(statics: Statics) -> Kinetostatics:
    """Give the forces over a whole turn, or where the crank has none over the scene's positions."""
    return statics.around(STEPS) if turns(statics.study) else statics.forces


def mass_centre(points: MainPoints, study: LinkageStudy, turn: CrankPositions) -> MassCentre:
    """Find the mass centre at crank positions, in blocks; NaN at gaps."""
    parts = [_part(points, study, turn.part(slice(start, start + BLOCK))) for start in range(0, len(turn), BLOCK)]
    r, a, moment = (_joined([part[row] for part in parts]) for row in range(3))
    return MassCentre(CONSTRUCTION, turn.phi, points.mass, r, a, moment.real)


def drawing(points: MainPoints, drafts: Drafts) -> Drawing:
    """Draw the mass centre over the positions of some drafts."""
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN inside
        return centre_drawing(points, drafts.plan(ACCELERATIONS.number))


def _part(points: MainPoints, study: LinkageStudy, turn: CrankPositions) -> tuple[npt.NDArray[Any], ...]:
    drafts = Drafts(study, turn)
    made = drawing(points, drafts)
    rows = (np.broadcast_to(mark.point, len(turn)) for mark in (made.centre, made.accelerations.end, made.moment))
    r, a, moment = (np.array(row, dtype=complex) for row in rows)
    r[drafts.lost] = np.nan
    for row in (a, moment):
        row[drafts.lost | drafts.unborne] = np.nan
    return r, a, moment


def _joined(rows: Sequence[npt.NDArray[Any]]) -> npt.NDArray[Any]:
    return rows[0] if len(rows) == 1 else np.concatenate(rows)
