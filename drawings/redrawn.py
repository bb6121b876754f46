"""Sheets drawn once more (подлинники), and written ones checked: as a file, against original and analysis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from drawings import VERSION
from drawings.checks import verify
from drawings.checks.differences import plain
from drawings.checks.expected import Expected, Wrong, subject
from drawings.checks.hold import stated_keys
from drawings.files.sheet_set import flaws, placed_sheets, stem_of
from drawings.lettering.lettering import lettered
from drawings.paper.limits import QUANTUM, OverLimit, SheetRefused
from drawings.paper.strokes import Key, Leaf
from drawings.paper.walk import flat
from drawings.pens.svg import svg
from drawings.reading.items import inside, items
from drawings.reading.seal import digest
from drawings.reading.sheet import SeenSheet, see, without
from drawings.sheet_diff.collate import Collation, Hidden, collate
from drawings.sheet_diff.edit import Edit
from drawings.sheet_diff.matching import match
from drawings.sheets.documents import leaves_of
from drawings.sheets.kind import sheet_kind
from geometry.errors import DraftError
from plans.scene.scene import read_scene
from plans.study import Study
from plans.words.words import Message, message


class Original(NamedTuple):
    """A sheet of a scene as it must be: the name of its file, its kind, its leaf."""

    name: str
    kind: str
    leaf: Leaf

    def says(self, data: Mapping[str, Any]) -> bool:
        """Tell whether the data of a written sheet are those of this one: its kind, and its number among them."""
        metadata = self.leaf.metadata
        return all(data.get(key) == metadata.get(key) for key in ("sheet", "number"))


class Originals:
    """The sheets of a scene; each is drawn and seen when it is first asked for."""

    def __init__(self, scene: Path) -> None:
        self.path = scene
        self.study = Study(read_scene(scene))
        self._drawn: dict[str, bytes] = {}
        self._sheets: dict[str, SeenSheet] = {}
        self._expected: dict[tuple[str, str], Mapping[Key, Expected]] = {}

    @property
    def language(self) -> str:
        """The language of the scene."""
        return self.study.scene.sheet.language

    @property
    def digest(self) -> str:
        """The checksum of the scene."""
        return digest(self.study.scene.content)

    @cached_property
    def sheets(self) -> tuple[Original, ...]:
        """All sheets, laid out as they are drawn: the two roads agree."""
        self.study.construct()
        for comparison in self.study.comparisons:
            if failed := verify.disagreement(comparison):
                raise failed
        scene = self.study.scene
        placed = placed_sheets(Path(), stem_of(scene), leaves_of(self.study))
        return tuple(Original(path.name, kind, lettered(leaf, scene.sheet.lettering)) for path, (kind, leaf) in placed)

    def drawn(self, sheet: Original) -> bytes:
        """Give the file of a sheet as it must be."""
        if sheet.name not in self._drawn:
            self._drawn[sheet.name] = svg(sheet.leaf)
        return self._drawn[sheet.name]

    def read_back(self, sheet: Original) -> SeenSheet:
        """Give what is seen of a sheet as it must be."""
        if sheet.name not in self._sheets:
            self._sheets[sheet.name] = see(self.drawn(sheet))
        return self._sheets[sheet.name]

    def expected(self, sheet: Original) -> Mapping[Key, Expected]:
        """Give what must stand on a sheet and those of its kind that are of the same subject, by the analysis."""
        of = sheet.kind, subject(sheet.leaf)
        if of not in self._expected:
            leaves = [original.leaf for original in self.sheets if (original.kind, subject(original.leaf)) == of]
            self._expected[of] = {row.key: row for row in sheet_kind(sheet.kind).expected(self.study, leaves)}
        return self._expected[of]

    def wrongs(self, sheet: Original, drawn: SeenSheet) -> list[Wrong]:
        """List what the self-check of a sheet finds wrong with what is seen of a written one.

        What is there as it must be is taken with all its digits, as it was laid out before it was rounded.
        """
        only = stated_keys(sheet.leaf)
        return [*verify.measured_wrongs(drawn.measured, self._left(sheet, drawn), self.expected(sheet), only)]

    def _left(self, sheet: Original, drawn: SeenSheet) -> Leaf:
        """Give what is left of a sheet as it was laid out on a written one: the strokes that are still there."""
        redrawn = self.read_back(sheet)
        leaf = plain(sheet.leaf, redrawn.leaf.lettering)
        exact = dict(zip(map(id, flat(redrawn.written.groups)), flat(leaf.groups), strict=True))
        there = {
            id(exact[id(ours.stroke)]) for ours, _ in match(items(redrawn.written), items(drawn.written), QUANTUM).same
        }
        return without(leaf, [stroke for stroke in flat(leaf.groups) if id(stroke) not in there])

    def of(self, name: str, data: Mapping[str, Any]) -> tuple[Original, ...]:
        """Give the sheets that a written one may be: by its data and by its name, and all if by neither."""
        said = [sheet for sheet in self.sheets if sheet.says(data)]
        called = [sheet for sheet in self.sheets if sheet.name == name and sheet not in said]
        return (*said, *called) or self.sheets


# What the self-check of a sheet may meet where the sheet is not laid out as it expects.
UNFOLLOWED = (LookupError, ValueError, TypeError, AttributeError, ArithmeticError, DraftError)
LONGEST = 40  # letters of a version
NEVER = ("hidden", "unseen", "unread", "copied", "patch")  # how no sheet is drawn
WHOLE, PARTLY, EDITED, UNREADABLE = 0, 4, 5, 7


class Finding(NamedTuple):
    """One thing that is wrong with a sheet: its kind, in words, and the edit that it is."""

    kind: str
    told: Message
    edit: Edit | None = None

    def plain(self, language: str) -> dict[str, Any]:
        """Give it as plain data."""
        data = {"finding": self.kind, "told": self.told.worded(language)}
        return data if self.edit is None else data | self.edit.plain(language)


class Checked(NamedTuple):
    """What a check found: what is wrong, what could not be checked, and how much is as it must be."""

    findings: tuple[Finding, ...]
    notes: tuple[Message, ...] = ()
    partly: bool = False  # something could not be checked
    same: int = 0
    most: int = 0
    refused: int = 0  # exit code of a sheet that cannot be read at all

    @property
    def resaved(self) -> bool:
        """Whether nothing but the file differs: what is drawn is all there, as it must be, and nothing else."""
        kinds = {finding.kind for finding in self.findings}
        return "seal" in kinds and kinds <= {"seal", "set"} and 0 < self.same == self.most and not self.partly

    @property
    def exit_code(self) -> int:
        """The command's exit code, were this its only sheet."""
        return self.refused or (EDITED if self.findings else PARTLY if self.partly else WHOLE)


def check(path: Path, source: bytes, originals: Originals | None) -> Checked:
    """Check a written sheet, by its scene where that is at hand."""
    findings = tuple(Finding(kind, fault) for kind, fault in flaws(path, source))
    try:
        sheet = see(source)
    except OverLimit as refused:
        return Checked((*findings, _refused(refused)), refused=refused.exit_code)
    except SheetRefused as refused:
        return Checked((*findings, _refused(refused)), refused=EDITED if b"<svg" in source else UNREADABLE)
    if originals is None:
        return Checked(findings, (message("checked.alone"),), partly=True)
    return _against(path, sheet, originals, findings)


def _refused(refused: SheetRefused) -> Finding:
    return Finding("refused", message("checked.refused", reason=refused.reason))


def _against(path: Path, sheet: SeenSheet, originals: Originals, findings: tuple[Finding, ...]) -> Checked:
    """Hold a sheet against the original that it is nearest to."""
    data = sheet.leaf.metadata
    try:
        collations = [(_collated(originals.read_back(ours), sheet), ours) for ours in originals.of(path.name, data)]
    except SheetRefused as refused:  # stretched or mirrored
        return Checked((*findings, _refused(refused)))
    collation, original = max(collations, key=lambda pair: pair[0].same / max(pair[0].most, 1))
    other = data.get("plandraft", VERSION) != VERSION and not collation.clean
    found = (*_identity(path, data, original, originals), *_edits(collation, other))
    version, count = str(data.get("plandraft"))[:LONGEST], len(collation.edits) + len(collation.whole)
    notes = (message("checked.version", version=version, own=VERSION, count=count),) if other else ()
    analysed = _analysis(sheet, original, originals)
    return Checked((*findings, *found, *analysed), notes, other, collation.same, collation.most)


def _hidden(sheet: SeenSheet) -> list[Hidden]:
    return [Hidden(item, lost.reason) for lost in sheet.unseen for item in inside(lost.stroke, lost.group)]


def _collated(right: SeenSheet, there: SeenSheet) -> Collation:
    return collate(right.leaf, there.leaf, _hidden(there), _hidden(right))


def _identity(path: Path, data: Mapping[str, Any], original: Original, originals: Originals) -> Iterator[Finding]:
    """Tell a sheet of another scene, and one under the name of another sheet of its set."""
    if data.get("scene", originals.digest) != originals.digest:
        yield Finding("scene", message("checked.scene", scene=originals.path.name))
    named = {sheet.name for sheet in originals.sheets}
    if path.name in named and path.name != original.name:
        yield Finding("name", message("checked.name", name=original.name))
    if not original.says(data):
        yield Finding("data", message("checked.data", name=original.name))


def _edits(collation: Collation, other: bool) -> Iterator[Finding]:
    """Tell what was edited; of a sheet that another version laid out otherwise only what no version would draw."""
    if other:
        yield from (Finding("edit", edit.told, edit) for edit in collation.edits if edit.how in NEVER)
        return
    if collation.strange:
        yield Finding("strange", message("checked.strange", same=collation.same, most=collation.most))
    yield from (Finding("whole", fault) for fault in collation.whole)
    yield from (Finding("edit", edit.told, edit) for edit in collation.edits)


def _analysis(sheet: SeenSheet, original: Original, originals: Originals) -> Iterator[Finding]:
    """Tell what the self-check of such a sheet finds in it by the analysis, also where its lines are as they must be.

    The data of its groups may have been edited, which say what a line is and which letter it bears.
    """
    try:
        wrong = originals.wrongs(original, sheet)
    except UNFOLLOWED:
        yield Finding("analysis", message("checked.unfollowed"))
        return
    if wrong:
        yield Finding("analysis", message("checked.analysis", wrong=verify.first(wrong)))
