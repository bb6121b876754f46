"""The sheets that are forged: of every technique, in both languages and standards."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from random import Random

from drawings.pens.svg import svg
from drawings.reading.seal import sealed
from drawings.redrawn import Checked, Original, Originals, check
from tests.forgeries.file_edits import FILE_EDITS
from tests.forgeries.forgery import Forgery, Told
from tests.forgeries.leaf_edits import LEAF_EDITS

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
SCENES = (
    "crank-rocker", "slider-crank", "toggle-press", "scotch-yoke", "jaw-crusher", "compressor", "press", "valve-cam",
    "copying-cam", "fan", "four-masses", "engine-share", "six-link-balance", "lanchester", "shaper-feed",
)  # fmt: skip


PLANS = re.compile(r"^(plans = \[)([0-9]+)", re.MULTILINE)
KINDS = (*LEAF_EDITS, *FILE_EDITS)


def forged(sheet: Original, kind: str, seed: int = 0) -> Forgery | None:
    """Make an edit of a kind; None where the sheet has no place for it."""
    chance = Random(f"{seed} {sheet.name} {kind}")
    if kind in LEAF_EDITS:
        found = LEAF_EDITS[kind](sheet.leaf, chance)
        return None if found is None else Forgery(kind, sheet.name, svg(found[0]), found[1])
    made = FILE_EDITS[kind](sheet.leaf, chance)
    return None if made is None else Forgery(kind, sheet.name, *made)


def forgeries(originals: Originals, sheet: Original, seed: int = 0, every: int = 1) -> Iterator[Forgery]:
    """Give every so many kinds of edits that a sheet has a place for, other kinds for the next sheet."""
    first = sum(map(ord, sheet.name)) % every
    yield from filter(None, (forged(sheet, kind, seed) for kind in KINDS[first::every]))
    for other in originals.sheets:
        if other.name != sheet.name:
            yield Forgery("exchanged in its set", sheet.name, originals.drawn(other), Told(("name",), says=other.name))


def strangers(known: Mapping[str, Originals]) -> Iterator[tuple[Originals, Forgery]]:
    """Give sheets of other scenes, under the names of those that must be; what they say of their scene is forged."""
    names = list(known)
    for name, other in zip(names[1:], names, strict=False):
        own, strange = known[name], known[other].sheets[0].leaf
        leaf = strange._replace(metadata={**strange.metadata, "scene": own.digest})
        yield own, Forgery("a sheet of another scene", own.sheets[0].name, svg(leaf), Told(("strange",)))


def displaced(known: Mapping[str, Originals], folder: Path) -> Iterator[tuple[Originals, Forgery]]:
    """Give sheets with the plans of the next position, under the name of those that must be, signed as these are."""
    for name, own in known.items():
        text = (GALLERY / f"{name}.toml").read_text("utf-8")
        scene = folder / f"{name}.toml"
        scene.write_text(PLANS.sub(lambda found: f"{found[1]}{int(found[2]) + 1}", text, count=1), "utf-8")
        if PLANS.search(text):
            sheet = Originals(scene).sheets[0]
            leaf = sheet.leaf._replace(metadata={**sheet.leaf.metadata, "scene": own.digest})
            told = Told(("missing",), figure=f"velocities-{PLANS.findall(text)[0][1]}")
            yield own, Forgery("plans of another position", sheet.name, svg(leaf), told)


def judged(originals: Originals, forgery: Forgery, folder: Path) -> str:
    """Check a forgery; give "" if it was told rightly, or else what was told."""
    assert forgery.kind in ("torn", "the seal broken", "the seal lost") or sealed(forgery.source)
    checked: Checked = check(folder / forgery.sheet, forgery.source, originals)
    plain = [finding.plain("en") for finding in checked.findings]
    if forgery.told.kinds == ("version",):
        right = bool(checked.notes) or any(forgery.told.fits(one) for one in plain)
    else:
        right = checked.exit_code != 0 and any(forgery.told.fits(one) for one in plain)
    return "" if right else f"{forgery.told}\n    told: {[one['told'] for one in plain[:4]]} of {len(plain)}"
