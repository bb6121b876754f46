"""The tables of keys beside the gallery, made of what the keys state; `python -m tests.readme_keys` writes them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from pathlib import Path
from typing import Any

from plans.scene.faults import Path as KeyPath
from plans.scene.refusal import table_name
from plans.scene.scene import Scene
from plans.scene.schema import schema
from plans.scene.tables import REQUIRED, Key, Table
from plans.techniques import techniques
from plans.words.words import spoken

PAGE = Path(__file__).parent.parent / "drawings/gallery/keys.md"
CHOICES = "Russian words of a choice"
HEAD = ("| key | value | default | meaning |", "|---|---|---|---|")
BLOCK = re.compile(r"(?<=<!-- )keys of (?P<part>[\w ]+) -->\n(?P<table>.*?)(?=<!-- end of keys -->)", re.DOTALL)


def parts() -> Mapping[str, type[Table]]:
    """Give what is tabled together: what every scene has, and the form of each technique."""
    return {"a scene": Scene, **{name: row.form() for name, row in techniques().items()}, CHOICES: Table}


def rows(kind: type[Table], path: KeyPath = ()) -> Iterator[str]:
    """Give a row a key, the tables behind the plain keys and each before its own keys."""
    tabled = {name: known for name, known in kind.keys.items() if known.field.tables or " = " in known.field.shown}
    yield from (_row(f"`{name}`", known) for name, known in kind.keys.items() if name not in tabled)
    for name, known in tabled.items():
        yield _row(f"**`{_header((*path, name), known)}`**", known)
        for steps, inner in known.field.tables:
            yield from rows(inner, (*path, name, *steps))


def _header(path: KeyPath, known: Key) -> str:
    """Write a table as its header stands in the file, a list of tables in double brackets."""
    name = str(table_name(path))
    return f"[{name}]" if known.field.shown == "[table, ...]" else name


def _row(name: str, known: Key) -> str:
    shown = "" if known.field.shown in ("table", "[table, ...]") else known.field.shown
    return f"| {name} | {shown} | {_default(known.default)} | {known.meaning} |"


def _default(value: Any) -> str:
    """Write what stands for a key that is not given; nothing where its meaning says it."""
    if value is REQUIRED:
        return "required"
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    if isinstance(value, Decimal | int):
        return f"`{value}`"
    if isinstance(value, tuple) and value:
        return f"`[{', '.join(map(str, value))}]`"
    return f'`"{value}"`' if isinstance(value, str) and value else ""


def tabled(part: str) -> str:
    """Give the table of one part as the page has it."""
    return "\n".join(russian() if part == CHOICES else (*HEAD, *rows(parts()[part]))) + "\n"


def russian() -> Iterator[str]:
    """Give a row a word that a key allows: what else it may be in Russian, however it is cased."""
    yield from ("| word | in Russian |", "|---|---|")
    known = json.dumps(schema(), ensure_ascii=False)  # what else is printed is read nowhere
    shown = " ".join(line.split(" | ")[1] for kind in [*parts().values()][:-1] for line in rows(kind))
    for name in dict.fromkeys(re.findall(r'"([^"]+)"', shown)):
        if said := [one for one in spoken("ru", name) if f'"{one}"' in known]:
            yield f'| `"{name}"` | {", ".join(said)} |'


def renewed(text: str) -> str:
    """Give the page with its tables of keys as they should be; what has none yet is put at its end."""
    known = {found["part"] for found in BLOCK.finditer(text)}
    for part in parts().keys() - known:
        text += f"\n## {part.capitalize()}\n\n<!-- keys of {part} -->\n<!-- end of keys -->\n"
    return BLOCK.sub(lambda found: f"keys of {found['part']} -->\n{tabled(found['part'])}", text)


if __name__ == "__main__":
    PAGE.write_text(renewed(PAGE.read_text("utf-8")), "utf-8")
