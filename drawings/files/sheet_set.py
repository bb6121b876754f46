"""The set of one run (комплект): all its files take their names together, or the last set stays as it was.

First all files and the manifest are written beside, forced to the disk. Then they take their names, the manifest last;
what had these names waits under others until then. A run that is killed in between leaves the new manifest under
its temporary name, and the next run finishes what it finds there.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from drawings.files.atomic_files import check_replaceable, create, discard, force_folder, make_folder, orphans, rename
from drawings.files.atomic_files import temporary_name as new_name
from drawings.files.file_error import stating_path
from drawings.files.manifest import Manifest, digest_of, existing_digest, existing_manifest, read_manifest
from drawings.files.standing import BUSY, locked, unstopped
from plans.scene.scene import Scene
from plans.words.words import Message, message, placed

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


class Left(NamedTuple):
    """What an interrupted run left: sets that are now finished, sets that cannot be, temporary files swept."""

    finished: tuple[Path, ...] = ()
    torn: tuple[Path, ...] = ()
    swept: int = 0

    def faults(self, folder: Path) -> Iterator[Message]:
        """Say what was left, and what became of it."""
        for path in self.finished:
            yield placed(path, message("file.finished"))
        for path in self.torn:
            yield placed(path, message("file.torn"))
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
            _go_on(folder, manifest, temporaries, journal)
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


def _go_on(folder: Path, manifest: Manifest, temporaries: Mapping[Path, Path], journal: Path) -> None:
    """Finish a set; where that fails nothing is put back, so that the next run can go on."""
    kept: dict[Path, Path | None] = {}
    with unstopped():
        _exchange(folder, manifest, temporaries, journal, kept)
        _finish(folder / manifest.name, kept)


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
    folder: Path, stem: str, leaves: Mapping[str, Sequence[Leaf]]
) -> Iterator[tuple[Path, tuple[str, Leaf]]]:
    """Give every leaf its file, with its kind."""
    for kind, group in leaves.items():
        yield from ((sheet_path(folder, stem, kind, k), (kind, leaf)) for k, leaf in enumerate(group))


def sheet_path(folder: Path, stem: str, kind: str, number: int) -> Path:
    """Name the file of a sheet, the first of its kind and those that follow."""
    return folder / (f"{stem}-{kind}-{number + 1}.svg" if number else f"{stem}-{kind}.svg")


def stem_of(scene: Scene) -> str:
    """Give how the names of a scene's files begin."""
    return Path(os.fspath(scene.file)).stem
