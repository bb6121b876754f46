"""The manifest of a set (опись комплекта): the files of one run with their checksums, written last of them all."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from drawings import VERSION
from drawings.files.file_error import json_text
from drawings.reading.seal import digest, seal_of
from geometry.regular_file import regular_bytes

FORMAT = 1
MOST_BYTES = 1 << 20  # a set of a thousand sheets has a fifth of that
SUFFIX = "-manifest.json"


class Manifest(NamedTuple):
    """The set of one run: its own name, what it was drawn from and by, and the checksum of each of its files."""

    name: str
    scene: str
    scene_digest: str
    files: Mapping[str, str]  # name: SHA-256
    seals: Mapping[str, str]  # of the sheets among them
    withheld: tuple[str, ...] = ()  # names of files that failed the self-check, and are not there
    version: str = VERSION

    def content(self) -> bytes:
        """Give the manifest as a file: the same bytes for the same set."""
        files = [_entry(name, digest, self.seals.get(name)) for name, digest in self.files.items()]
        scene = {"name": self.scene, "sha256": self.scene_digest}
        plain = {"format": FORMAT, "plandraft": self.version, "set": self.name, "scene": scene, "files": files}
        plain |= {"withheld": list(self.withheld)} if self.withheld else {}
        return f"{json_text(plain, indent=2)}\n".encode()

    def strangers(self, folder: Path) -> list[str]:
        """Name the files in a folder that are not those of this set, also those that are missing."""
        return [name for name, digest in self.files.items() if digest_of(folder / name) != digest]


def manifest_name(stem: str) -> str:
    """Give the name of the manifest of a scene's set."""
    return f"{stem}{SUFFIX}"


def manifest_of(
    scene: str, scene_content: bytes, contents: Mapping[Path, bytes], withheld: Iterable[str] = ()
) -> Manifest:
    """Make the manifest of the set that a scene's file gave, from the contents of its files."""
    seals = {path.name: found for path, content in contents.items() if (found := seal_of(content)) is not None}
    files = {path.name: digest(content) for path, content in contents.items()}
    named = manifest_name(Path(scene).stem), Path(scene).name, digest(scene_content)
    return Manifest(*named, files, seals, tuple(withheld))


def read_manifest(path: Path) -> Manifest | None:
    """Read a manifest; None where there is none, or none that can be read."""
    with contextlib.suppress(OSError):
        return existing_manifest(path)
    return None


def existing_manifest(path: Path) -> Manifest | None:
    """Read a manifest; None where there is none of ours: all its names are of its scene, and in its folder.

    An OSError says that there is a file that the system does not give.
    """
    with contextlib.suppress(FileNotFoundError, ValueError, LookupError, TypeError, RecursionError):
        found = _parsed(json.loads(regular_bytes(path, MOST_BYTES)))
        names, start = (found.name, *found.files), f"{found.name.removesuffix(SUFFIX)}-"
        return found if all(_plain(name) and name.startswith(start) for name in names) else None
    return None


def manifest_beside(sheet: Path) -> Manifest | None:
    """Find the manifest that names a sheet: the scene's name is the first words of the sheet's, joined by hyphens."""
    words = sheet.name.split("-")
    stems = ("-".join(words[:count]) for count in range(len(words) - 1, 0, -1))
    found = (read_manifest(sheet.parent / manifest_name(stem)) for stem in stems)
    return next((manifest for manifest in found if manifest is not None and sheet.name in manifest.files), None)


def digest_of(path: Path) -> str | None:
    """Give the checksum of a file; None where there is none that can be read."""
    with contextlib.suppress(OSError):
        return existing_digest(path)
    return None


def existing_digest(path: Path) -> str | None:
    """Give the checksum of a file; None where there is none. An OSError says that the system does not give it."""
    with contextlib.suppress(FileNotFoundError):
        return digest(regular_bytes(path, 1 << 62))
    return None


def _entry(name: str, digest: str, seal: str | None) -> dict[str, str]:
    return {"name": name, "sha256": digest} | ({"seal": seal} if seal else {})


def _parsed(plain: Any) -> Manifest:
    if plain["format"] != FORMAT:
        raise ValueError("another format")
    files = {entry["name"]: entry["sha256"] for entry in plain["files"]}
    seals = {entry["name"]: entry["seal"] for entry in plain["files"] if "seal" in entry}
    return Manifest(
        plain["set"], plain["scene"]["name"], plain["scene"]["sha256"], files, seals, version=plain["plandraft"]
    )


def _plain(name: object) -> bool:
    """Tell whether a name is that of a file in the same folder, and none that begins with a full stop."""
    return isinstance(name, str) and name == Path(name).name and not name.startswith(".") and "\0" not in name
