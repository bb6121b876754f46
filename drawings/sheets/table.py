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
    enclosures: str = ""  # of a study to the files beside its sheets


SHEETS: Final[Mapping[str, Sheet]] = {
    "kinematics": Sheet(
        admit="drawings.sheets.linkage_admission:of_linkage",
        leaves="drawings.sheets.kinematics:leaves",
        due="drawings.due.linkage:due",
        scales={
            "positions": "length",
            "velocities-": "velocity",
            "accelerations-": "acceleration",
            "diagrams": "angle",
        },
    ),
    "positions": Sheet(
        admit="drawings.sheets.linkage_admission:of_linkage",
        leaves="drawings.sheets.positions:leaves",
        due="drawings.due.linkage:due",
        scales={"positions": "length"},
    ),
    "forces": Sheet(
        admit="drawings.sheets.force_admission:of_forces",
        leaves="drawings.sheets.forces:leaves",
        due="drawings.due.forces:due",
        scales={
            "scheme-": "scheme",
            "forces-": "force",
            "lever": "lever",
            "balancing": "moment",
            "load_diagram-": "way",
        },
    ),
    "dynamics": Sheet(
        admit="drawings.sheets.linkage_admission:of_linkage",
        leaves="drawings.sheets.dynamics:leaves",
        due="drawings.due.dynamics:due",
        scales={"flywheel_sketch": "wheel", "load_diagram-": "way"},
    ),
    "balancing": Sheet(
        admit="drawings.sheets.force_admission:of_forces",
        leaves="drawings.sheets.balancing:leaves",
        due="drawings.due.balancing:due",
        scales={"scheme-": "scheme", "static-moments": "unbalance", "shaking": "force"},
    ),
    "bank": Sheet(
        admit="drawings.sheets.bank:admit",
        leaves="drawings.sheets.bank:leaves",
        due="drawings.due.bank:due",
        scales={"star": "scheme", "shaft": "scheme", "order_forces-": "force", "order_moments-": "moment"},
    ),
    "rotor": Sheet(
        admit="drawings.sheets.rotor:admit",
        leaves="drawings.sheets.rotor:leaves",
        due="drawings.due.rotor:due",
        scales={"across": "rotor", "along": "rotor", "unbalances": "unbalance", "couples": "couple"},
    ),
    "cam": Sheet(
        admit="drawings.sheets.cam_admission:of_cams",
        leaves="drawings.sheets.cam:leaves",
        due="drawings.due.cam:due",
        scales={"sizes": "cam", "profile": "cam"},
    ),
    "profile": Sheet(
        admit="drawings.sheets.cam_admission:of_cams",
        leaves="drawings.sheets.cam_profile:leaves",
        due="drawings.due.profile:due",
        enclosures="drawings.due.coordinates:enclosures",
        scales={"manufacturing": "cam"},
    ),
    "cyclogram": Sheet(
        admit="drawings.sheets.linkage_admission:of_linkage",
        leaves="drawings.sheets.cyclogram:leaves",
        due="drawings.due.cyclogram:due",
        scales={"characteristic": "length"},
    ),
}
