"""Originals (подлинники): the sheets of a scene drawn once more, which written sheets are held against."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from drawings import VERSION
from drawings.checks import verify
from drawings.checks.expected import Expected, Wrong, subject
from drawings.checks.hold import stated_keys
from drawings.checks.plain import plain
from drawings.checks.verify import agree
from drawings.files.sheet_set import placed_sheets, stem_of
from drawings.lettering.lettering import lettered
from drawings.paper.limits import QUANTUM
from drawings.paper.statement import Key
from drawings.paper.strokes import Leaf
from drawings.paper.walk import flat
from drawings.pens.svg import svg
from drawings.reading.seal import digest
from drawings.reading.sheet import SeenSheet, see, without
from drawings.sheet_diff.items import items
from drawings.sheet_diff.matching import match
from drawings.sheets.documents import bind
from drawings.sheets.kind import sheet_kind
from plans.scene.scene import Scene, read_scene
from plans.study import Study


def leaves_of(study: Study) -> Mapping[str, Sequence[Leaf]]:
    """Lay out the sheets of a study, by kind; the data of each say of which scene it is, and of which version."""
    scene = study.scene
    leaves = bind({kind: sheet_kind(kind).leaves(study) for kind in scene.sheets}, scene)
    return {kind: tuple(_signed(leaf, scene) for leaf in group) for kind, group in leaves.items()}


def _signed(leaf: Leaf, scene: Scene) -> Leaf:
    return leaf._replace(metadata={**leaf.metadata, "scene": digest(scene.content), "plandraft": VERSION})


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
            agree(comparison)
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
