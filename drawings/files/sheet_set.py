"""The set of one run (комплект): all its files take their names together, or the last set stays as it was.

First all files and the manifest are written beside, forced to the disk. Then they take their names, the manifest last;
what had these names waits under others until then. A run that is killed in between leaves the new manifest under
its temporary name, and the next run finishes what it finds there.
"""

import contextlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from drawings import VERSION
from drawings.files.atomic_files import (
    BUSY,
    check_replaceable,
    create,
    discard,
    force_folder,
    json_text,
    locked,
    make_folder,
    orphans,
    rename,
    stating_path,
)
from drawings.files.atomic_files import temporary_name as new_name
from drawings.files.signals import unstopped
from drawings.paper.limits import SHEET_BYTES
from drawings.reading.seal import digest, seal_of, sealed
from geometry.errors import regular_bytes
from plans.words.words import Message, message, placed

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf
    from plans.scene.scene import Scene

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
        files = [
            {"name": name, "sha256": digest} | ({"seal": self.seals[name]} if self.seals.get(name) else {})
            for name, digest in self.files.items()
        ]
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


def _parsed(plain: Any) -> Manifest:
    if plain["format"] != FORMAT:
        raise ValueError("another format")
    files = {entry["name"]: entry["sha256"] for entry in plain["files"]}
    seals = {entry["name"]: entry["seal"] for entry in plain["files"] if "seal" in entry}
    return Manifest(
        plain["set"], plain["scene"]["name"], plain["scene"]["sha256"], files, seals, version=plain["plandraft"]
    )


def _plain(name: object) -> bool:
    return isinstance(name, str) and name == Path(name).name and not name.startswith(".") and "\0" not in name


class Left(NamedTuple):
    """What an interrupted run left: sets that are now finished, sets that cannot be, temporary files swept."""

    finished: tuple[Path, ...] = ()
    torn: tuple[Path, ...] = ()
    swept: int = 0

    def faults(self, folder: Path) -> Iterator[Message]:
        """Say what was left, and what became of it."""
        yield from (placed(path, message("file.finished")) for path in self.finished)
        yield from (placed(path, message("file.torn")) for path in self.torn)
        if self.swept:
            yield placed(folder, message("file.swept", count=self.swept))


@contextlib.contextmanager
def output_folder(folder: Path) -> Iterator[Left]:
    """Make a folder, keep other runs out of it while the block lasts, and tidy up what an interrupted run left there.

    Folders that were made for a block that fails are taken away again, but not from under another run.
    """
    made = [level for level in (folder, *folder.parents) if not os.path.lexists(level)]
    try:
        make_folder(folder)
        with locked(folder) as alone:
            yield recover(folder, alone)
    except BaseException as error:
        if getattr(error, "reason", None) != BUSY:
            with contextlib.suppress(OSError):
                for level in made:
                    level.rmdir()
        raise


def publish(folder: Path, manifest: Manifest, temporaries: Mapping[Path, Path]) -> list[Path]:
    """Give the files of a set their names; give those that only the last set had, which are removed.

    Where one cannot have its name, all is put back as it was.
    """
    path, journal = folder / manifest.name, new_name(folder)
    kept: dict[Path, Path | None] = {}
    with unstopped():
        try:
            with stating_path(path, "file.written"):
                check_replaceable(path)
                create(journal, manifest.content())
                force_folder(folder)
            surplus = _exchange(folder, manifest, temporaries, journal, kept)
        except BaseException:
            if _put_back(kept):
                discard(journal)
            raise
        _finish(path, kept)
    return surplus


def recover(folder: Path, alone: bool) -> Left:
    """Finish or tidy up what an interrupted run left in a folder."""
    found = orphans(folder, alone)
    journals = {path: manifest for path in found if (manifest := read_manifest(path)) is not None}
    finished, torn = [], []
    for journal, manifest in journals.items():
        if (temporaries := _whole(folder, manifest, found)) is not None:
            kept: dict[Path, Path | None] = {}
            with unstopped():  # where that fails nothing is put back: the next run goes on
                _exchange(folder, manifest, temporaries, journal, kept)
                _finish(folder / manifest.name, kept)
            finished.append(folder / manifest.name)
        elif (last := read_manifest(folder / manifest.name)) is None or last.strangers(folder):
            torn.append(folder / manifest.name)
    return Left(tuple(finished), tuple(torn), sum(discard(orphan) for orphan in found))


def _whole(folder: Path, manifest: Manifest, found: list[Path]) -> dict[Path, Path] | None:
    """Find the files of a set that have not taken their names, by their checksums; None where one is lost."""
    digests = {digest_of(path): path for path in found}
    missing = manifest.strangers(folder)
    if not all(manifest.files[name] in digests for name in missing):
        return None
    return {folder / name: digests[manifest.files[name]] for name in missing}


def _exchange(
    folder: Path, manifest: Manifest, temporaries: Mapping[Path, Path], journal: Path, kept: dict[Path, Path | None]
) -> list[Path]:
    """Set aside and give what is no longer of the set; put files in place of those of their names, which are kept."""
    surplus = _surplus(folder, manifest)
    for path in surplus:
        with stating_path(path, "file.removed"):
            kept[path] = _set_aside(path, stays=False)
    for path, temporary in temporaries.items():
        with stating_path(path, "file.named"):
            kept[path] = _set_aside(path, stays=True)
            rename(temporary, path)
    path = folder / manifest.name
    with stating_path(path, "file.named"):
        rename(journal, path)  # in one step: the old one is not set aside, for it could be taken for a new one
    return surplus


def _finish(path: Path, kept: Mapping[Path, Path | None]) -> None:
    for former in filter(None, kept.values()):
        discard(former)
    with stating_path(path, "file.unforced"):
        force_folder(path.parent)


def _surplus(folder: Path, manifest: Manifest) -> list[Path]:
    """List the files that only the last set has, and that are still as they were written."""
    with stating_path(folder / manifest.name, "file.read"):
        last = existing_manifest(folder / manifest.name)
    found = []
    for name in sorted(set(last.files) - set(manifest.files)) if last is not None else ():
        with stating_path(folder / name, "file.read"):
            if last is not None and existing_digest(folder / name) == last.files[name]:
                found.append(folder / name)
    return found


def _set_aside(path: Path, stays: bool) -> Path | None:
    """Keep a file under another name, and give that; None where there is no file.

    Where the file system can, it stays under its own name too, until another takes that in one step.
    """
    former = new_name(path.parent)
    try:
        if stays and _linked(path, former):
            return former
        rename(path, former)
    except FileNotFoundError:
        return None
    return former


def _linked(path: Path, former: Path) -> bool:
    try:
        os.link(path, former, follow_symlinks=False)
    except FileNotFoundError:
        raise
    except OSError:
        return False
    return True


def _put_back(kept: Mapping[Path, Path | None]) -> bool:
    """Give what was set aside its names again, and take away what had none before; tell whether all went well."""
    whole = True
    for path, former in reversed(list(kept.items())):
        try:
            if former is None:
                path.unlink(missing_ok=True)
            else:
                rename(former, path)
                discard(former)  # it is still there where both names were of one file
        except OSError:
            whole = False
    return whole


def placed_sheets(
    folder: Path, stem: str, leaves: "Mapping[str, Sequence[Leaf]]"
) -> "Iterator[tuple[Path, tuple[str, Leaf]]]":
    """Give every leaf its file, with its kind."""
    for kind, group in leaves.items():
        yield from ((sheet_path(folder, stem, kind, k), (kind, leaf)) for k, leaf in enumerate(group))


def sheet_path(folder: Path, stem: str, kind: str, number: int) -> Path:
    """Name the file of a sheet, the first of its kind and those that follow."""
    return folder / (f"{stem}-{kind}-{number + 1}.svg" if number else f"{stem}-{kind}.svg")


def stem_of(scene: "Scene") -> str:
    """Give how the names of a scene's files begin."""
    return Path(os.fspath(scene.file)).stem


END = b"</svg>"
SEAL = b'id="seal"'


class Flaw(NamedTuple):
    """What is wrong with a file as a file: its kind, and in words."""

    kind: str  # torn, seal, set
    told: Message


def flaws(path: Path, source: bytes) -> Iterator[Flaw]:
    """Tell what is wrong with a sheet as a file: its seal, its set."""
    if len(source) > SHEET_BYTES:  # only its beginning was read, and whoever measures it says so
        return
    yield from _of_seal(source)
    manifest = manifest_beside(path)
    if manifest is not None:
        if digest(source) != manifest.files[path.name]:
            yield Flaw("set", message("checked.changed", set=manifest.name))
        for name, stated in manifest.files.items():
            if name != path.name and (found := digest_of(path.parent / name)) != stated:
                yield Flaw("set", message("checked.missing" if found is None else "checked.other", name=name))


def _of_seal(source: bytes) -> Iterator[Flaw]:
    if sealed(source):
        return
    if not source.rstrip().endswith(END):
        yield Flaw("torn", message("checked.torn", bytes=len(source), line=source.count(b"\n") + 1))
    else:
        yield Flaw("seal", message("checked.broken" if SEAL in source else "checked.unsealed"))
