"""Notes on a scene (замечания): what is allowed, but may well be a slip; each technique looks through its part."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from decimal import Decimal

from plans.scene.faults import Fault, Path, dotted
from plans.scene.forms import reading
from plans.scene.scene import Scene
from plans.techniques import TECHNIQUES, Technique, makers_of, sheet_of, techniques

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


def notes_of(scene: Scene, asked: Iterable[str] = ()) -> list[Fault]:
    """Give the notes on a scene, in the order of its file; some techniques are asked for whatever its sheets are."""
    found = [*scene.read_as, *_unused(scene, asked), *_undesignated(scene)]
    for technique in scene.techniques:
        found += techniques()[technique].notes(scene)
    return sorted(found, key=lambda note: (note.line, note.column))


def _unused(scene: Scene, asked: Iterable[str]) -> Iterator[Fault]:
    paced = (name for name, row in techniques().items() if row.paces and any(map(scene.has, _shared(row))))
    wanted_by = [*(name for sheet in scene.sheets for name in makers_of(sheet)), *asked, *paced]
    used = reading([*wanted_by, *(other for name in wanted_by for other in asked_by(scene, name))])
    for name in (name for name in scene.techniques if name not in used):
        technique = techniques()[name]
        wanted = ", ".join(f'"{sheet}"' for sheet in (*scene.sheets, sheet_of(name)))
        keys: list[Path] = [(name,) for name in technique.tables]
        keys += _shared(technique)
        yield from (scene.fault(path, "unused", wanted=wanted) for path in keys if scene.has(path))


def _undesignated(scene: Scene) -> Iterator[Fault]:
    table = scene.sheet.designations
    for kind in (key for key in table.keys if getattr(table, key) and key not in scene.sheets):
        wanted = ", ".join(f'"{sheet}"' for sheet in (*scene.sheets, kind))
        yield scene.fault(("sheet", "designations", kind), "unused", wanted=wanted)


def asked_by(scene: Scene, technique: str) -> Iterable[str]:
    """Name the techniques that the values of a scene's part in one refer to."""
    return (other for other in techniques()[technique].asks(scene) if other in TECHNIQUES)


def _shared(technique: Technique) -> list[Path]:
    """Give its keys of tables that are the scene's or another technique's."""
    return [(table, name) for table, names in technique.shares.items() for name in names]
