"""The table of sheets (листы): what is asked of a scene before any work, what lays a sheet out, and what checks it.

A row is text alone, "module:name": nothing of a sheet is imported before a scene asks for it.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, NamedTuple


class Sheet(NamedTuple):
    """One kind of sheet."""

    admit: str  # of a scene to nothing: raises what the sheet cannot show, before any work
    leaves: str  # of a study to the leaves laid out, one or several
    due: str  # of a study and the leaves of this kind to what must stand on them, by the analysis
    scales: Mapping[str, str] = MappingProxyType({})  # how names of figures begin, and their keys of [sheet.scale]
    letters: str = ""  # of a study, a position and a letter that the sheet alone gives to what it is on the record
    enclosures: str = ""  # of a study to the files beside its sheets


SHEETS: Final[Mapping[str, Sheet]] = {
    "kinematics": Sheet(
        admit="drawings.linkage.positions:of_linkage",
        leaves="drawings.linkage.kinematics:leaves",
        due="drawings.linkage.due:due",
        scales={
            "positions": "length",
            "velocities-": "velocity",
            "accelerations-": "acceleration",
            "diagrams": "angle",
        },
    ),
    "positions": Sheet(
        admit="drawings.linkage.positions:of_linkage",
        leaves="drawings.linkage.positions:leaves",
        due="drawings.linkage.due:due",
        scales={"positions": "length"},
    ),
    "forces": Sheet(
        admit="drawings.forces.sheet:of_forces",
        leaves="drawings.forces.sheet:leaves",
        due="drawings.forces.due:due",
        letters="drawings.forces.lever:of_arm",
        scales={
            "scheme-": "scheme",
            "forces-": "force",
            "lever": "lever",
            "balancing": "moment",
            "load_diagram-": "way",
        },
    ),
    "dynamics": Sheet(
        admit="drawings.linkage.positions:of_linkage",
        leaves="drawings.dynamics.sheet:leaves",
        due="drawings.dynamics.due:due",
        scales={"flywheel_sketch": "wheel", "load_diagram-": "way"},
    ),
    "balancing": Sheet(
        admit="drawings.forces.sheet:of_forces",
        leaves="drawings.balance.sheet:leaves",
        due="drawings.balance.due:due",
        scales={"scheme-": "scheme", "static-moments": "unbalance", "shaking": "force"},
    ),
    "bank": Sheet(
        admit="drawings.bank.sheet:admit",
        leaves="drawings.bank.sheet:leaves",
        due="drawings.bank.due:due",
        scales={"star": "scheme", "shaft": "scheme", "order_forces-": "force", "order_moments-": "moment"},
    ),
    "rotor": Sheet(
        admit="drawings.rotor.sheet:admit",
        leaves="drawings.rotor.sheet:leaves",
        due="drawings.rotor.due:due",
        scales={"across": "rotor", "along": "rotor", "unbalances": "unbalance", "couples": "couple"},
    ),
    "cam": Sheet(
        admit="drawings.cam.sheet:of_cams",
        leaves="drawings.cam.sheet:leaves",
        due="drawings.cam.due:due",
        scales={"sizes": "cam", "profile": "cam"},
    ),
    "profile": Sheet(
        admit="drawings.cam.sheet:of_cams",
        leaves="drawings.cam.sheet:workshop_leaves",
        due="drawings.cam.due_notes:due",
        enclosures="drawings.cam.coordinates:enclosures",
        scales={"manufacturing": "cam"},
    ),
    "cyclogram": Sheet(
        admit="drawings.linkage.positions:of_linkage",
        leaves="drawings.cyclogram.sheet:leaves",
        due="drawings.cyclogram.due:due",
        scales={"characteristic": "length"},
    ),
}
