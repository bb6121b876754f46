"""Standing: whether a written sheet is whole by its seal, and of its set by the manifest (сохранность файла листа)."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from drawings.files.manifest import Manifest, digest_of, manifest_beside
from drawings.measure.seal import digest, sealed
from plans.words.words import Message, message

END = b"</svg>"
SEAL = b'id="seal"'


class Flaw(NamedTuple):
    """What is wrong with a file as a file: its kind, and in words."""

    kind: str  # torn, seal, set
    told: Message


def flaws(path: Path, source: bytes) -> Iterator[Flaw]:
    """Tell what is wrong with a sheet as a file: its seal, its set."""
    yield from _of_seal(source)
    manifest = manifest_beside(path)
    if manifest is not None:
        yield from _of_set(path, source, manifest)


def _of_seal(source: bytes) -> Iterator[Flaw]:
    if sealed(source):
        return
    if not source.rstrip().endswith(END):
        lines = source.count(b"\n") + 1
        yield Flaw("torn", message("checked.torn", bytes=len(source), line=lines))
    else:
        yield Flaw("seal", message("checked.broken" if SEAL in source else "checked.unsealed"))


def _of_set(path: Path, source: bytes, manifest: Manifest) -> Iterator[Flaw]:
    """Tell which files of the set are others than were drawn together, and which are not there."""
    if digest(source) != manifest.files[path.name]:
        yield Flaw("set", message("checked.changed", set=manifest.name))
    for name, told in manifest.files.items():
        if name != path.name and (found := digest_of(path.parent / name)) != told:
            yield Flaw("set", message("checked.missing" if found is None else "checked.other", name=name))
