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
    faults: str  # of a measured sheet, its leaf and a study to what is wrong with it, in words
    scales: Mapping[str, str] = MappingProxyType({})  # how names of figures begin, and their keys of [sheet.scale]
    enclosures: str = ""  # of a study to the files beside its sheets
    together: str = ""  # of all measured sheets with their leaves and a study to what is wrong with them as a set


SHEETS: Final[Mapping[str, Sheet]] = {
    "kinematics": Sheet(
        admit="drawings.sheets.linkage_admission:of_linkage",
        leaves="drawings.sheets.kinematics:leaves",
        faults="drawings.checks.verify_kinematics:faults",
        together="drawings.checks.verify_kinematics:set_faults",
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
        faults="drawings.checks.verify_kinematics:faults",
        scales={"positions": "length"},
    ),
    "forces": Sheet(
        admit="drawings.sheets.force_admission:of_forces",
        leaves="drawings.sheets.forces:leaves",
        faults="drawings.checks.verify_forces:faults",
        together="drawings.checks.verify_forces:set_faults",
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
        faults="drawings.checks.dynamics.verify_dynamics:faults",
        together="drawings.checks.dynamics.verify_dynamics:set_faults",
        scales={"flywheel_sketch": "wheel", "load_diagram-": "way"},
    ),
    "balancing": Sheet(
        admit="drawings.sheets.force_admission:of_forces",
        leaves="drawings.sheets.balancing:leaves",
        faults="drawings.checks.balance.verify_balancing:faults",
        together="drawings.checks.balance.verify_balancing:set_faults",
        scales={"scheme-": "scheme", "static-moments": "unbalance", "shaking": "force"},
    ),
    "bank": Sheet(
        admit="drawings.sheets.bank:admit",
        leaves="drawings.sheets.bank:leaves",
        faults="drawings.checks.bank.verify_bank:faults",
        together="drawings.checks.bank.verify_bank:set_faults",
        scales={"star": "scheme", "shaft": "scheme", "order_forces-": "force", "order_moments-": "moment"},
    ),
    "rotor": Sheet(
        admit="drawings.sheets.rotor:admit",
        leaves="drawings.sheets.rotor:leaves",
        faults="drawings.checks.rotor.verify_rotor:faults",
        together="drawings.checks.rotor.verify_rotor:set_faults",
        scales={"across": "rotor", "along": "rotor", "unbalances": "unbalance", "couples": "couple"},
    ),
    "cam": Sheet(
        admit="drawings.sheets.cam_admission:of_cams",
        leaves="drawings.sheets.cam:leaves",
        faults="drawings.checks.cam.verify_cam:faults",
        together="drawings.checks.cam.verify_cam:set_faults",
        scales={"sizes": "cam", "profile": "cam"},
    ),
    "profile": Sheet(
        admit="drawings.sheets.cam_admission:of_cams",
        leaves="drawings.sheets.cam_profile:leaves",
        faults="drawings.checks.cam.verify_profile:faults",
        together="drawings.checks.cam.verify_profile:set_faults",
        enclosures="drawings.checks.cam.coordinates:enclosures",
        scales={"manufacturing": "cam"},
    ),
    "cyclogram": Sheet(
        admit="drawings.sheets.linkage_admission:of_linkage",
        leaves="drawings.sheets.cyclogram:leaves",
        faults="drawings.checks.cyclogram.verify_cyclogram:faults",
        together="drawings.checks.cyclogram.verify_cyclogram:set_faults",
        scales={"characteristic": "length"},
    ),
}
