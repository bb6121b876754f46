"""Redraws the gallery: every scene's sheets and reports, the alphabet and the index page; stale files are removed."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from drawings.commands.draw import draw
from drawings.files import atomic_files
from drawings.files.file_error import FileError
from drawings.gallery.catalogue import GALLERY, catalogue
from drawings.gallery.index import PAGE, GalleryScene, index
from drawings.lettering.lettering import lettered
from drawings.lettering.specimen import specimen
from drawings.pens.svg import svg
from geometry.errors import DraftError
from plans.words.words import message

FILES = 7
ALPHABET = "alphabet.svg"
WRITTEN = (".svg", ".md", ".csv")  # what draw writes beside a scene


def main(arguments: Sequence[str] | None = None) -> int:
    """Redraw a gallery and print each file that was written; give the exit code, as the command plandraft does."""
    parser = argparse.ArgumentParser(prog="python -m drawings.gallery", description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=GALLERY, help="scenes to draw (default: the gallery)")
    folder: Path = parser.parse_args(arguments).folder
    try:
        for path in redraw(folder):
            print(path, flush=True)
    except (DraftError, OSError) as error:
        print(error, file=sys.stderr)
        return error.exit_code if isinstance(error, DraftError) else FILES
    return 0


def redraw(folder: Path) -> Iterator[Path]:
    """Draw every scene of a folder into it, then the alphabet and the index; yield the files as they are written."""
    entries, exhibits = catalogue(folder), list[GalleryScene]()
    if not entries:
        raise FileError(folder, message("file.no_scenes"))
    for entry in entries:
        drawn = draw(entry.path, folder)
        exhibits.append(GalleryScene(entry, drawn.study, drawn.paths))
        yield from drawn.paths
    for path, content in (
        (folder / ALPHABET, svg(lettered(specimen()))),
        (folder / PAGE, index(exhibits).encode("utf-8")),
    ):
        atomic_files.write(path, content)
        yield path
    for path in stale(folder, exhibits):
        path.unlink()


def stale(folder: Path, exhibits: Iterable[GalleryScene]) -> list[Path]:
    """List the sheets and reports of the scenes that drawing them did not write again; other files are not ours."""
    written = {path.name for exhibit in exhibits for path in exhibit.paths}
    names = tuple(f"{exhibit.entry.name}-" for exhibit in exhibits)
    found = (path for path in folder.iterdir() if path.suffix in WRITTEN and path.name.startswith(names))
    return sorted(path for path in found if path.name not in written)


if __name__ == "__main__":
    sys.exit(main())
