"""Admission to the board (допуск): what a scene asks that no sheet can show is refused at its line, before any work."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.lettering.lettering import UnknownLetter, demand
from drawings.paper.strokes import Run, SheetError, Text
from drawings.sheets.table import SHEETS
from plans.scene.faults import Path
from plans.scene.scene import Scene
from plans.words.words import Message, message, placed

CELLS = ("designation", "drawn", "checked", "approved", "date", "group", "organisation")


def of_title(scene: Scene) -> None:
    """See that the title block can be lettered."""
    cells = ((("sheet", cell), getattr(scene.sheet, cell)) for cell in CELLS)
    own = scene.sheet.designations
    documents = ((("sheet", "designations", kind), getattr(own, kind)) for kind in own.keys)
    letter(scene, [(("title",), scene.title), *cells, *documents])


def of_scales(scene: Scene) -> None:
    """See that the sheets draw figures of each scale that the scene states."""
    known = {key for kind in scene.sheets for key in SHEETS[kind].scales.values()}
    for name, _ in scene.sheet.scale.stated:
        if name not in known:
            raise unknown(scene, name)


def unknown(scene: Scene, name: str) -> SheetError:
    """Refuse a scale that no figure of a scene's sheets has, with those that some has."""
    keys = dict.fromkeys(key for kind in scene.sheets for key in SHEETS[kind].scales.values() if key != name)
    return SheetError(of_scale(scene, name, message("refused.scale_unknown", name=name, names=tuple(keys))))


def of_scale(scene: Scene, name: str, said: Message) -> Message:
    """Say something of a key of [sheet.scale] at its place."""
    line, column = scene.place(("sheet", "scale", name))
    return placed(f"{scene.file}:{line}:{column}", said)


def letter(scene: Scene, words: Iterator[tuple[Path, str]] | list[tuple[Path, str]]) -> None:
    """See that the alphabet has all letters of what the scene's author wrote, each with its key."""
    for path, text in words:
        try:
            demand([Text(0j, (Run(text),))])
        except UnknownLetter as unknown:
            line, column = scene.place(path)
            where = f"{scene.file}:{line}:{column}: {'.'.join(map(str, path))}"
            raise SheetError(placed(where, unknown.args[0])) from None
