"""plandraft new: a scene of the gallery to start from, never over a file that is there."""

from __future__ import annotations

import argparse
import difflib
from collections.abc import Sequence

from drawings.files import atomic_files
from drawings.files.atomic_files import FileError
from drawings.gallery.catalogue import Entry, catalogue
from geometry.errors import DraftError
from plans.words.words import message

WORD = 4  # letters of a word that is looked for within names and titles


class UnknownName(DraftError, ValueError):  # noqa: N818  (the message's own word)
    """A name that no scene of the gallery has."""

    exit_code = 2  # the command line is wrong


def run(options: argparse.Namespace) -> int:
    """Write a scene of the gallery into a folder, or list them all; give the exit code."""
    entries = catalogue()
    if options.name is None:
        print(listed(entries))
        return 0
    entry = found(entries, options.name)
    atomic_files.prepare(options.output)
    path = options.output / entry.path.name
    if not atomic_files.write_new(path, entry.path.read_bytes()):
        raise FileError(path, message("file.exists"))
    print(path)
    return 0


def listed(entries: Sequence[Entry]) -> str:
    """List names with their titles."""
    width = max(len(entry.name) for entry in entries)
    return "\n".join(f"{entry.name:<{width}}  {entry.title}" for entry in entries)


def found(entries: Sequence[Entry], name: str) -> Entry:
    """Find a scene by its name."""
    for entry in entries:
        if entry.name == name:
            return entry
    asked = name.removesuffix(".toml").casefold()
    holding = [entry.name for entry in entries if asked in f"{entry.name} {entry.title}".casefold()]
    named = difflib.get_close_matches(asked, [entry.name for entry in entries], 1)
    near = difflib.get_close_matches(asked, holding, 1, 0.0) if len(asked) >= WORD and holding else named
    hint = message("gallery.near", name=near[0]) if near else message("gallery.any")
    raise UnknownName(message("gallery.unknown", name=name, names=listed(entries), hint=hint))
