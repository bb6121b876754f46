"""Draws the gallery anew and tells what changes; with --because REASON that is kept, and listed with the reason."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from drawings.commands.draw import draw
from drawings.files import atomic_files
from drawings.files.atomic_files import FileError
from drawings.files.sheet_set import manifest_name
from drawings.gallery.catalogue import GALLERY, catalogue
from drawings.gallery.changes import ALPHABET, changes, enter, unlisted
from drawings.gallery.index import PAGE, GalleryScene, index
from drawings.lettering.lettering import lettered
from drawings.lettering.specimen import specimen
from drawings.pens.svg import svg
from geometry.errors import DraftError
from plans.words.words import message

FILES, CHANGED = 7, 5
WRITTEN = (".svg", ".md", ".csv")  # what draw writes beside a scene


def main(arguments: Sequence[str] | None = None) -> int:
    """Tell what changes of a gallery, a line each; give 5 if that is not kept, else as the command plandraft does."""
    parser = argparse.ArgumentParser(prog="python -m drawings.gallery", description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=GALLERY, help="scenes to draw (default: the gallery)")
    parser.add_argument("--because", metavar="REASON", help="keep what changed, and list it with this reason")
    options = parser.parse_args(arguments)
    try:
        count = 0
        for line in redraw(options.folder, options.because):
            print(line, flush=True)
            count += 1
    except (DraftError, OSError) as error:
        print(error, file=sys.stderr)
        return error.exit_code if isinstance(error, DraftError) else FILES
    return CHANGED if count and not options.because else 0


def redraw(folder: Path, because: str | None = None) -> Iterator[str]:
    """Draw every scene of a folder, the alphabet and the index; yield what changes, and keep it for a reason alone.

    A set in which nothing changes stays as it is, to the last digit of another processor.
    """
    entries, exhibits = catalogue(folder), list[GalleryScene]()
    if not entries:
        raise FileError(folder, message("file.no_scenes"))
    with TemporaryDirectory() as beside:
        fresh = Path(beside)
        for entry in entries:
            drawn = draw(entry.path, fresh)
            exhibits.append(GalleryScene(entry, drawn.study, drawn.paths))
            yield from _renewed(folder, drawn.paths, fresh / manifest_name(entry.name), because)
        (fresh / ALPHABET).write_bytes(svg(lettered(specimen())))
        (fresh / PAGE).write_text(index(exhibits), "utf-8")
        for name in (ALPHABET, PAGE):
            yield from _renewed(folder, [fresh / name], None, because)
    for path in stale(folder, exhibits):
        yield f"{path.name}: went"
        if because:
            path.unlink()
    if because:
        enter(folder, because)
    else:
        yield from (f"{name}: not as it is listed" for name in unlisted(folder))


def _renewed(folder: Path, paths: Sequence[Path], manifest: Path | None, because: str | None) -> list[str]:
    """Tell what changes of a set; keep all of it, or nothing."""
    changed = [change for path in paths for change in changes(path, folder / path.name)]
    if changed and because:
        for path in (*paths, *([manifest] if manifest else ())):
            atomic_files.write(folder / path.name, path.read_bytes())
    return changed


def stale(folder: Path, exhibits: Iterable[GalleryScene]) -> list[Path]:
    """List the sheets and reports of the scenes that drawing them did not write again; other files are not ours."""
    written = {path.name for exhibit in exhibits for path in exhibit.paths}
    names = tuple(f"{exhibit.entry.name}-" for exhibit in exhibits)
    found = (path for path in folder.iterdir() if path.suffix in WRITTEN and path.name.startswith(names))
    return sorted(path for path in found if path.name not in written)


if __name__ == "__main__":
    sys.exit(main())
