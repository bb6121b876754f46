"""plandraft measure: the vectors and points of an SVG sheet, read back in true units."""

from __future__ import annotations

import argparse
from pathlib import Path

from drawings.commands.stderr import tell
from drawings.files.json_text import print_json
from drawings.files.manifest import manifest_beside
from drawings.measure.measure import Measured, check, measure_file
from drawings.paper.limits import SheetRefused

FAILED = 5


def run(options: argparse.Namespace) -> int:
    """Print what a sheet shows; give the exit code."""
    try:
        measured = measure_file(options.sheet)
    except SheetRefused as refused:
        raise type(refused)(f"{options.sheet}: {refused.reason}") from None
    if not measured.marks:
        raise SheetRefused(
            f"{options.sheet}: this SVG has no vectors or points of a plandraft sheet. Fix: give one it drew"
        )
    _tell_strangers(options.sheet)
    wrong = check(measured)
    off = {miss.key for miss in wrong}
    if options.json:
        print_json({"vectors": _plain(measured, "vectors"), "points": _plain(measured, "points")})
    else:
        for mark in measured.marks:
            sign = "DIFFERS from the stated" if mark.key in off else ""
            value = f"({mark.value.real:.6g}, {mark.value.imag:.6g})"
            print(f"{mark.plan:<14} {mark.position!s:>4}  {mark.name:<10} {value:<26} {mark.unit:<6} {sign}".rstrip())
        for note in measured.notes:
            print(f"left aside: {note}")
    return FAILED if wrong else 0


def _tell_strangers(sheet: Path) -> None:
    """Say which files of the sheet's set are not those that were drawn together."""
    manifest = manifest_beside(sheet)
    if manifest is not None:
        for name in manifest.strangers(sheet.parent):
            fault = f"does not fit {manifest.name}: changed since it was drawn, or its run was stopped"
            tell(f"{sheet.with_name(name)}: {fault}")


def _plain(measured: Measured, kind: str) -> list[dict[str, object]]:
    return [
        {
            "plan": mark.plan, "quantity": mark.quantity, "name": mark.name, "position": mark.position,
            "value": [mark.value.real, mark.value.imag], "size": abs(mark.value),
            "stated": [mark.stated.real, mark.stated.imag], "unit": mark.unit, "scale": mark.scale,
        }
        for mark in getattr(measured, kind)
    ]  # fmt: skip
