"""The scenes of the catalogue: each is a sound scene with a little changed, and what must come of it (правки сцен).

A file of rows holds a table a scene. `of` names the sound scene, for all rows of a file or for one; in its text
`replace` exchanges pieces, `after` adds lines after a line, `remove` takes lines out, and `add` puts some at the end.
Each piece must stand there just once. `text` gives the whole scene instead. What must come of it is `code` and `says`.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).parent
GALLERY = HERE.parents[1] / "drawings/gallery"
SOUND: Mapping[str, str] = {path.stem: path.read_text("utf-8") for path in sorted(HERE.glob("*.toml"))}
KEYS = {"of", "text", "replace", "after", "remove", "add", "code", "says", "run", "report", "sheet"}


class Row(NamedTuple):
    """A scene of the catalogue: its name, its text, and what must come of it."""

    name: str
    text: str
    given: Mapping[str, Any]

    def told(self, key: str) -> list[str]:
        """Give what must be told: one text or several."""
        told = self.given.get(key, [])
        return [told] if isinstance(told, str) else list(told)

    def written(self, folder: Path) -> Path:
        """Write the scene under its name."""
        path = folder / f"{self.name}.toml"
        path.write_text(self.text, "utf-8", newline="")
        return path


def sound(name: str) -> str:
    """Read a sound scene, of this folder or of the gallery."""
    return SOUND[name] if name in SOUND else (GALLERY / f"{name.removeprefix('gallery/')}.toml").read_text("utf-8")


def exchanged(text: str, old: str, new: str) -> str:
    """Exchange what stands in a text just once."""
    if text.count(old) != 1:
        raise ValueError(f"{old!r} stands {text.count(old)} times in the sound scene")
    return text.replace(old, new)


def changed(text: str, given: Mapping[str, Any]) -> str:
    """Change a sound scene as a row says."""
    for old, new in given.get("replace", ()):
        text = exchanged(text, old, new)
    for line, more in given.get("after", ()):
        text = exchanged(text, f"{line}\n", f"{line}\n{more}\n")
    for lines in given.get("remove", ()):
        text = exchanged(text, f"{lines}\n", "")
    return text + (f"{given['add']}\n" if "add" in given else "")


def rows(folder: str) -> Iterator[Row]:
    """Read the rows of a folder."""
    for path in sorted((HERE / folder).glob("*.toml")):
        told = tomllib.loads(path.read_text("utf-8"))
        default = told.pop("of")
        for name, given in told.items():
            if given.keys() - KEYS:
                raise ValueError(f"{name}: no key of a row: {given.keys() - KEYS}")
            yield Row(
                name, given["text"] if "text" in given else changed(sound(given.get("of", default)), given), given
            )


FAULTS = tuple(rows("faults"))
COMMANDS = tuple(rows("commands"))
TEXTS: Mapping[str, str] = {row.name: row.text for row in (*FAULTS, *COMMANDS)}
