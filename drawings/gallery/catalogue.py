"""The catalogue of the gallery: its scenes by name, title and opening words, without studying any (каталог)."""

from __future__ import annotations

import tomllib
from itertools import takewhile
from pathlib import Path
from typing import NamedTuple

GALLERY = Path(__file__).parent


class Entry(NamedTuple):
    """A scene of the gallery: its name, its title, and what its opening comment says about the mechanism."""

    name: str
    title: str
    about: str
    path: Path


def catalogue(folder: Path = GALLERY) -> list[Entry]:
    """List the scenes of a folder in the order of their names."""
    return [_entry(path) for path in sorted(folder.glob("*.toml"), key=lambda path: path.stem)]


def _entry(path: Path) -> Entry:
    text = path.read_text("utf-8")
    opening = takewhile(lambda line: line.startswith("#"), text.splitlines())
    about = " ".join(line.lstrip("# ") for line in opening)
    return Entry(path.stem, tomllib.loads(text).get("title", path.stem), about, path)
