"""The sheet of a scene (лист): what stands on every sheet, whatever it shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from functools import partial
from typing import Any, ClassVar

from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import one
from plans.scene.tables import Key, Table, key, table
from plans.techniques import techniques
from plans.words.words import languages

FACTOR = units.UnitKind("scale factor", "", least=Decimal("1e-12"), most=Decimal("1e12"))
MM = Decimal("0.001")  # m
PART = r"([0-9]+(?:[.,][0-9]+)?)"
RATIO = re.compile(rf"\s*{PART}\s*:\s*{PART}\s*")


def length(value: object) -> Decimal:
    """Read a scale of lengths: metres a millimetre, or a ratio of the paper to the machine.

    >>> length("1:2"), length("2.5:1"), length(Decimal("0.005"))
    (Decimal('0.002'), Decimal('0.0004'), Decimal('0.005'))
    """
    if not isinstance(value, str):
        return units.positive(value, FACTOR)
    found = RATIO.fullmatch(value)
    paper, machine = (Decimal(part.replace(",", ".")) for part in found.groups()) if found else (Decimal(0), Decimal(0))
    if not (paper and machine):
        raise wrong("scale_ratio")
    return units.positive(units.WORKING.divide(machine, paper) * MM, FACTOR)


_number = partial(forms.quantity, FACTOR, exclusiveMinimum=0)
LENGTH = one(length, lambda: {"anyOf": [_number(), forms.text(rf"^\s*{PART}\s*:\s*{PART}\s*$")]}, 'm a mm, or "1:2"')


def _scale(unit: str, meaning: str) -> Any:
    """Declare the key of a scale: of lengths, which have no unit here, it may be a ratio."""
    factor = one(units.positive, _number, f"{unit} a mm", kind=FACTOR)
    return key(factor if unit else LENGTH, None, meaning=meaning)


class ScaleTable(Table):
    """Scales that figures must have, whatever their room; each key governs the figures that its meaning names."""

    bare: ClassVar[str] = "bare_scale"
    keys: ClassVar[Mapping[str, Key]] = {
        name: _scale(*named) for technique in techniques().values() for name, named in technique.scales.items()
    }

    @property
    def stated(self) -> Iterator[tuple[str, float]]:
        """Give the keys that the scene states, each with its scale in 12 digits, as sheets write them."""
        yield from ((name, float(f"{mu:.12g}")) for name in self.keys if (mu := getattr(self, name)) is not None)


LANGUAGES = languages()


class DesignationTable(Table):
    """Designations of kinds of sheets that are documents of their own, where they are."""

    keys: ClassVar[Mapping[str, Key]] = {
        sheet: key(f.TEXT, "", meaning=f"Of the {sheet} sheets.") for sheet in forms.SHEETS
    }


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
        text: str = getattr(self.designations, kind, "")
        return text or self.designation
