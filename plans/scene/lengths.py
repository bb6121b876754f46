"""Lengths that may be of another unit than their author means (длины без единиц): millimetres taken for metres."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

from plans.scene.faults import Fault, Path, dotted
from plans.scene.scene import Scene

# Metres: links and rotors of machines are shorter, and lengths in millimetres are mostly larger numbers.
METRES = Decimal(20)
HUNDREDS = 100  # times as much as anything else of its kind: mostly another unit


def odd_lengths(
    scene: Scene, lengths: Mapping[Path, Decimal], named: Callable[[Path], str] = dotted
) -> Iterator[Fault]:
    """Find that no length m without a unit is short, or that some are far longer than all others."""
    if not lengths or max(lengths.values()) < METRES:  # nothing is odd, and the file need not be searched
        return
    notes = {path: scene.fault(path, "metres") for path in lengths}
    bare = [path for path in lengths if not notes[path].value.startswith(("'", '"'))]
    if bare and all(lengths[path] >= METRES for path in bare):
        yield scene.fault(bare[0], "metres", least=METRES, example=notes[bare[0]].value)
        return
    for path in bare:
        others = max((size for other, size in lengths.items() if other != path), default=lengths[path])
        if lengths[path] >= METRES and lengths[path] >= HUNDREDS * others:
            details = {"name": named(path), "ratio": f"{lengths[path] / others:.3g}"}
            yield scene.fault(path, "enormous", example=notes[path].value, **details)
