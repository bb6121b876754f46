"""Admission of loads: what they are called can be lettered, and so can their linkage (допуск нагрузок)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.linkage.positions import of_linkage
from drawings.sheets.documents import letter
from plans.forces.reading.form import ForceForm
from plans.scene.faults import Path
from plans.scene.scene import Scene


def of_forces(scene: Scene) -> None:
    """See that the names of loads can be lettered too."""
    letter(scene, _loads(scene))
    of_linkage(scene)


def _loads(scene: Scene) -> Iterator[tuple[Path, str]]:
    loads = scene.of(ForceForm).loads
    for kind in ("forces", "moments", "springs") if loads else ():
        named = enumerate(getattr(loads, kind))
        yield from ((("loads", kind, k, "name"), load.name) for k, load in named if load.name)
