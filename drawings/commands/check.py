"""plandraft check: written sheets against their scene, any time later."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from drawings.files.atomic_files import of_system, print_json
from drawings.files.sheet_set import digest_of, manifest_beside
from drawings.paper.limits import SHEET_BYTES
from drawings.redrawn import UNREADABLE, Checked, Finding, Originals, check
from geometry.errors import regular_bytes
from plans.words.words import ENGLISH, message, word

TOLD = 30  # findings of a sheet that are printed; --json has all


def run(options: argparse.Namespace) -> int:
    """Check sheets, and tell what is wrong with each; give the exit code, the gravest of all."""
    originals = cache(Originals)  # sheets of one scene are drawn again but once
    rows = []
    for path in options.sheets:
        scene: Path | None = options.scene or scene_beside(path)
        redrawn = originals(scene) if scene is not None else None
        rows.append((path, options.language or (redrawn.language if redrawn else ENGLISH), _checked(path, redrawn)))
    if options.json:
        print_json({"sheets": [plain(path, language, checked) for path, language, checked in rows]})
    else:
        print("\n".join(line for row in rows for line in lines(*row)))
    return max(checked.exit_code for *_, checked in rows)


def _checked(path: Path, originals: Originals | None) -> Checked:
    try:
        source = regular_bytes(path, SHEET_BYTES + 1)
    except OSError as error:
        return Checked((Finding("file", message("file.read", reason=of_system(error))),), refused=UNREADABLE)
    return check(path, source, originals)


def scene_beside(sheet: Path) -> Path | None:
    """Find the scene of a sheet: in its folder, the one above it or this one, by the manifest or else by its name.

    One that is as it was when the sheet was drawn goes before one that has changed.
    """
    manifest = manifest_beside(sheet)
    words = sheet.stem.split("-")
    stems = ["-".join(words[:count]) for count in range(len(words), 0, -1)]
    names = [manifest.scene] if manifest is not None else [f"{stem}.toml" for stem in stems]
    folders = (sheet.parent, sheet.parent / "..", Path())
    there = [path for name in names for folder in folders if (path := folder / Path(name).name).is_file()]
    as_drawn = (path for path in there if manifest is not None and digest_of(path) == manifest.scene_digest)
    return next(as_drawn, next(iter(there), None))


def lines(path: Path, language: str, checked: Checked) -> Iterator[str]:
    """Tell what a check found, line by line."""
    yield f"{path}: {word(language, _verdict(checked))}"
    findings = [finding.told.worded(language) for finding in checked.findings]
    yield from (f"  {line}" for line in findings[:TOLD])
    if len(findings) > TOLD:
        yield f"  {word(language, 'checked.more', count=len(findings) - TOLD)}"
    yield from (f"  {note.worded(language)}" for note in checked.notes)
    if checked.most:
        yield f"  {word(language, 'checked.same', same=checked.same, most=checked.most)}"


def _verdict(checked: Checked) -> str:
    if checked.refused == UNREADABLE:
        return "checked.unreadable"
    if checked.resaved:
        return "checked.resaved"
    return "checked.edited" if checked.findings else "checked.partly" if checked.partly else "checked.whole"


def plain(path: Path, language: str, checked: Checked) -> dict[str, object]:
    """Give what a check found as plain data."""
    return {
        "sheet": str(path),
        "verdict": _verdict(checked).removeprefix("checked."),
        "exit_code": checked.exit_code,
        "same": checked.same,
        "of": checked.most,
        "findings": [finding.plain(language) for finding in checked.findings],
        "notes": [note.worded(language) for note in checked.notes],
    }
