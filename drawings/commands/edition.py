"""An edition (издание): the sheets of a scene laid out, with the names of their files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from drawings import VERSION
from drawings.measure.seal import digest
from drawings.sheets.table import SHEETS
from plans.scene.scene import Scene
from plans.study import Study
from plans.techniques import named

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

Leaves = Mapping[str, Sequence["Leaf"]]


def leaves_of(study: Study) -> Leaves:
    """Lay out the sheets of a study, by kind; the data of each say of which scene it is, and of which version."""
    from drawings.sheets.documents import bind

    scene = study.scene
    leaves = bind({kind: named(SHEETS[kind].leaves)(study) for kind in scene.sheets}, scene)
    return {kind: tuple(_signed(leaf, scene) for leaf in own) for kind, own in leaves.items()}


def _signed(leaf: Leaf, scene: Scene) -> Leaf:
    return replace(leaf, metadata={**leaf.metadata, "scene": digest(scene.content), "plandraft": VERSION})


def placed_sheets(folder: Path, stem: str, leaves: Leaves) -> Iterator[tuple[Path, tuple[str, Leaf]]]:
    """Give every leaf its file."""
    for kind, own in leaves.items():
        yield from ((sheet_path(folder, stem, kind, k), (kind, leaf)) for k, leaf in enumerate(own))


def sheet_path(folder: Path, stem: str, kind: str, number: int) -> Path:
    """Name the file of a sheet, the first of its kind and those that follow."""
    return folder / (f"{stem}-{kind}-{number + 1}.svg" if number else f"{stem}-{kind}.svg")


def stem_of(scene: Scene) -> str:
    """Give how the names of a scene's files begin."""
    return Path(os.fspath(scene.file)).stem
