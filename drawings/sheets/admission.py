"""Admission to the board (допуск): what a scene asks that no sheet can show is refused at its line, before any work."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.lettering.lettering import UnknownLetter, demand
from drawings.paper.strokes import Run, SheetError, Text
from plans.scene.faults import Path
from plans.scene.scene import Scene
from plans.words.words import placed

CELLS = ("designation", "drawn", "checked", "approved", "date", "group", "organisation")


def of_title(scene: Scene) -> None:
    """See that the title block can be lettered."""
    letter(scene, [(("title",), scene.title), *((("sheet", cell), getattr(scene.sheet, cell)) for cell in CELLS)])


def letter(scene: Scene, words: Iterator[tuple[Path, str]] | list[tuple[Path, str]]) -> None:
    """See that the alphabet has all letters of what the scene's author wrote, each with its key."""
    for path, text in words:
        try:
            demand([Text(0j, (Run(text),))])
        except UnknownLetter as unknown:
            line, column = scene.place(path)
            where = f"{scene.file}:{line}:{column}: {'.'.join(map(str, path))}"
            raise SheetError(placed(where, unknown.args[0])) from None
