"""Admission to the board (допуск): what a scene asks that no sheet can show is refused at its line, before any work."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.lettering.lettering import UnknownLetter, demand
from drawings.paper.strokes import Run, SheetError, Text
from geometry.errors import LimitError
from plans.forces.reading.form import ForceForm
from plans.linkage.reading.form import LinkageForm
from plans.scene.faults import Path
from plans.scene.scene import Scene
from plans.words.words import message, placed

POSITIONS_DRAWN = 360  # more positions than degrees cannot be told apart on any sheet
CELLS = ("designation", "drawn", "checked", "approved", "date", "group", "organisation")


def of_linkage(scene: Scene) -> None:
    """See that the names of a linkage can be lettered, and that its positions can be told apart."""
    letter(scene, _points(scene))
    count = scene.of(LinkageForm).drive.count
    if count > POSITIONS_DRAWN:
        most = message("limit.sheet", most=POSITIONS_DRAWN)
        raise LimitError(placed(f"{scene.file}: drive.positions = {count}", most))


def of_forces(scene: Scene) -> None:
    """See that the names of loads can be lettered too."""
    letter(scene, _loads(scene))
    of_linkage(scene)


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


def _points(scene: Scene) -> Iterator[tuple[Path, str]]:
    mechanism = scene.of(LinkageForm).mechanism
    for table in ("frame", "points"):
        yield from ((("mechanism", table, name), name) for name in getattr(mechanism, table))
    for link, letters in mechanism.links.items():
        yield from ((("mechanism", "links", str(link)), point) for point in letters)


def _loads(scene: Scene) -> Iterator[tuple[Path, str]]:
    loads = scene.of(ForceForm).loads
    for kind in ("forces", "moments", "springs") if loads else ():
        named = enumerate(getattr(loads, kind))
        yield from ((("loads", kind, k, "name"), load.name) for k, load in named if load.name)
