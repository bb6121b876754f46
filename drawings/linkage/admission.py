"""Admission of a linkage: its points can be lettered, and its positions told apart (допуск механизма)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.sheets.documents import letter
from geometry.errors import LimitError
from plans.linkage.reading.form import LinkageForm
from plans.scene.faults import Path
from plans.scene.scene import Scene
from plans.words.words import message, placed

POSITIONS_DRAWN = 360  # more positions than degrees cannot be told apart on any sheet


def of_linkage(scene: Scene) -> None:
    """See that the names of a linkage can be lettered, and that its positions can be told apart."""
    letter(scene, _points(scene))
    count = scene.of(LinkageForm).drive.count
    if count > POSITIONS_DRAWN:
        most = message("limit.sheet", most=POSITIONS_DRAWN)
        raise LimitError(placed(f"{scene.file}: drive.positions = {count}", most))


def _points(scene: Scene) -> Iterator[tuple[Path, str]]:
    mechanism = scene.of(LinkageForm).mechanism
    for table in ("frame", "points"):
        yield from ((("mechanism", table, name), name) for name in getattr(mechanism, table))
    for link, letters in mechanism.links.items():
        yield from ((("mechanism", "links", str(link)), point) for point in letters)
