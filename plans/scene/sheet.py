"""The sheet of a scene (лист): what stands on every sheet, whatever it shows."""

from __future__ import annotations

from plans.scene import fields as f
from plans.scene.scales import ScaleTable
from plans.scene.tables import Table, key, table
from plans.words.words import languages

LANGUAGES = languages()


class DesignationTable(Table):
    """Designations of kinds of sheets that are documents of their own, where they are."""

    kinematics: str = key(f.TEXT, "", meaning="Of the kinematics sheets.")
    positions: str = key(f.TEXT, "", meaning="Of the sheet of positions.")
    forces: str = key(f.TEXT, "", meaning="Of the force sheets.")
    dynamics: str = key(f.TEXT, "", meaning="Of the sheets of the machine's motion.")
    balancing: str = key(f.TEXT, "", meaning="Of the sheets of a balanced mechanism.")
    bank: str = key(f.TEXT, "", meaning="Of the sheets of a bank of cylinders.")
    rotor: str = key(f.TEXT, "", meaning="Of the sheets of a rotor.")
    cam: str = key(f.TEXT, "", meaning="Of the sheets of cams.")
    profile: str = key(f.TEXT, "", meaning="Of the drawings of cams' profiles.")
    cyclogram: str = key(f.TEXT, "", meaning="Of the cyclogram.")


class SheetTable(Table):
    """What stands on every sheet: language, standard, format, and the title block."""

    language: str = key(f.words(*LANGUAGES), "en", meaning="Language of sheets and messages.")
    standard: str = key(f.words("GOST", "ISO"), "GOST", meaning="Standard of the drawing.")
    format: str = key(f.words("A1", "A2", "A3", "A4"), "A1", meaning="Format of the sheet.")
    orientation: str | None = key(
        f.words("landscape", "portrait"),
        None,
        meaning="Default: landscape, and portrait for A4, which by GOST always stands upright.",
    )
    lettering: str = key(
        f.words("strokes", "text"),
        "strokes",
        meaning="Lettering as strokes of our own alphabet, or as text in the fonts of the viewer.",
    )
    notation: str = key(f.words("mu", "K"), "mu", meaning="Scale factors mu (true units a mm), or K = 1/mu.")
    scales: str = key(
        f.words("common", "each"),
        "common",
        meaning="Scales of velocity plans, and of acceleration plans: one common to the whole set, or each its own.",
    )
    designation: str = key(
        f.TEXT,
        "",
        meaning="For the title block: designation of the document, of which all sheets of the scene are sheets.",
    )
    drawn: str = key(f.TEXT, "", meaning="Who drew the sheet.")
    checked: str = key(f.TEXT, "", meaning="Who checked it.")
    approved: str = key(f.TEXT, "", meaning="Who approved it.")
    date: str = key(f.TEXT, "", meaning="Date, as it shall stand on the sheet.")
    group: str = key(f.TEXT, "", meaning="Group of students.")
    organisation: str = key(f.TEXT, "", meaning="Organisation.")
    scale: ScaleTable = key(
        table(ScaleTable),
        ScaleTable(),
        meaning="Scales that figures must have; default: the largest standard ones that fit.",
    )
    designations: DesignationTable = key(
        table(DesignationTable),
        DesignationTable(),
        meaning="Designations of sheets that are documents of their own, numbered and counted by themselves.",
    )

    def designated(self, kind: str) -> str:
        """Give the designation of the document that a kind of sheet belongs to."""
        own: str = getattr(self.designations, kind, "")
        return own or self.designation
