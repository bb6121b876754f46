"""The table of reports (отчёты): what each technique tells of a study beside its sheets, and on the screen."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, NamedTuple


class Subject(NamedTuple):
    """The subject of a study: its structure and what comes out of it, and both in a sentence."""

    structure: str
    output: str
    sentence: str


class Report(NamedTuple):
    """What one technique tells; each text is "module:name", imported when a scene asks for it."""

    subject: str  # of a study to what it is in a few words, for the gallery's page
    chapters: str  # of a study and the leaves by their sheets to the chapters of the report
    headline: str  # of a study to a line about it on the screen, or nothing
    remarks: str  # of a study to lines of warning: gaps, dead centres, jams
    idle: str  # of a scene whose sheets do not ask for it to lines that say what is left out of it


REPORTS: Final[Mapping[str, Report]] = {
    "linkage": Report(
        subject="drawings.report.linkage.linkage_subject:subject",
        chapters="drawings.report.linkage.motion_report:chapters",
        headline="drawings.report.linkage.motion_report:headline",
        remarks="drawings.report.linkage.motion_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
    "diagrams": Report(
        subject="drawings.report.linkage.linkage_subject:subject",
        chapters="drawings.report.diagrams_report:chapters",
        headline="drawings.report.diagrams_report:headline",
        remarks="drawings.report.diagrams_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
    "forces": Report(
        subject="drawings.report.linkage.linkage_subject:subject",
        chapters="drawings.note.force_chapters:chapters",
        headline="drawings.report.forces.force_report:headline",
        remarks="drawings.report.forces.force_report:remarks",
        idle="drawings.report.idle:of_forces",
    ),
    "dynamics": Report(
        subject="drawings.report.linkage.linkage_subject:subject",
        chapters="drawings.report.dynamics_report:chapters",
        headline="drawings.report.dynamics_report:headline",
        remarks="drawings.report.dynamics_report:remarks",
        idle="drawings.report.idle:of_dynamics",
    ),
    "balance": Report(
        subject="drawings.report.linkage.linkage_subject:subject",
        chapters="drawings.report.balance.balance_report:chapters",
        headline="drawings.report.balance.balance_report:headline",
        remarks="drawings.report.balance.balance_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
    "bank": Report(
        subject="drawings.report.balance.bank_report:subject",
        chapters="drawings.report.balance.bank_report:chapters",
        headline="drawings.report.balance.bank_report:headline",
        remarks="drawings.report.balance.bank_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
    "rotor": Report(
        subject="drawings.report.rotor_report:subject",
        chapters="drawings.report.rotor_report:chapters",
        headline="drawings.report.rotor_report:headline",
        remarks="drawings.report.rotor_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
    "cyclogram": Report(
        subject="drawings.report.cyclogram_report:subject",
        chapters="drawings.report.cyclogram_report:chapters",
        headline="drawings.report.cyclogram_report:headline",
        remarks="drawings.report.cyclogram_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
    "cam": Report(
        subject="drawings.report.cam_report:subject",
        chapters="drawings.report.cam_report:chapters",
        headline="drawings.report.cam_report:headline",
        remarks="drawings.report.cam_report:remarks",
        idle="drawings.report.idle:nothing",
    ),
}
