"""The names of a scene's files (имена файлов листов)."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from plans.scene.scene import Scene

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def placed_sheets(
    folder: Path, stem: str, leaves: Mapping[str, Sequence[Leaf]]
) -> Iterator[tuple[Path, tuple[str, Leaf]]]:
    """Give every leaf its file, with its kind."""
    for kind, own in leaves.items():
        yield from ((sheet_path(folder, stem, kind, k), (kind, leaf)) for k, leaf in enumerate(own))


def sheet_path(folder: Path, stem: str, kind: str, number: int) -> Path:
    """Name the file of a sheet, the first of its kind and those that follow."""
    return folder / (f"{stem}-{kind}-{number + 1}.svg" if number else f"{stem}-{kind}.svg")


def stem_of(scene: Scene) -> str:
    """Give how the names of a scene's files begin."""
    return Path(os.fspath(scene.file)).stem
