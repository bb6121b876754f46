"""The list of renewals: each set of the gallery by its checksum, with why it was last drawn anew (обновления)."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from drawings.files import atomic_files
from drawings.files.manifest import SUFFIX, digest_of

LIST = "renewals.json"
ALPHABET = "alphabet.svg"


class Renewal(NamedTuple):
    """What a set came out as, and why."""

    digest: str
    because: str


def listed(folder: Path) -> dict[str, Renewal]:
    """Read the list of a gallery; a gallery without one has listed nothing."""
    path = folder / LIST
    plain = json.loads(path.read_text("utf-8")) if path.exists() else {}
    return {name: Renewal(*row) for name, row in plain.items()}


def there(folder: Path) -> dict[str, str]:
    """Give the checksums of the manifests of all sets, which have those of all files, and of the alphabet."""
    paths = sorted((*folder.glob(f"*{SUFFIX}"), *folder.glob(ALPHABET)))
    return {path.name: str(digest_of(path)) for path in paths}


def unlisted(folder: Path) -> list[str]:
    """Name the sets that are not as the list has them, and those that are listed and gone."""
    known, found = listed(folder), there(folder)
    same = {name for name in known if found.get(name) == known[name].digest}
    return sorted({*known, *found} - same)


def enter(folder: Path, because: str) -> None:
    """List what is not listed, with its reason, one set a line."""
    known: Mapping[str, Renewal] = listed(folder)
    rows = {
        name: known[name] if name in known and known[name].digest == digest else Renewal(digest, because)
        for name, digest in there(folder).items()
    }
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(row, ensure_ascii=False)}" for name, row in rows.items())
    atomic_files.write(folder / LIST, f"{{\n{lines}\n}}\n".encode())
