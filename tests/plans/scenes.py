"""Scenes written in few lines (постройка сцен): tables by their names, the entries of a table between semicolons."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

# What a table is called in a scene, where that is longer than its name here.
FULL = {
    **{name: f"mechanism.{name}" for name in ("frame", "links", "lengths", "points", "slides", "sketch")},
    **{name: f"loads.{name}" for name in ("forces", "moments", "springs")},
}


def scene(head: str = "", /, **tables: str | Sequence[str]) -> str:
    """Write a scene: what stands at its top, then each table; a list of entries is a table that stands several times.

    Links are numbered in the order of their letters: "OA AB B" is 1 = "OA", 2 = "AB", 3 = "B".
    """
    return "".join(f"{line}\n" for line in (*entries(head), *written(tables)))


def changed(text: str, *changes: tuple[str, str]) -> str:
    """Change some words of a scene; each must be there."""
    for old, new in changes:
        assert old in text, f"there is no {old}"
        text = text.replace(old, new)
    return text


def written(tables: Mapping[str, str | Sequence[str]]) -> Iterator[str]:
    """Give the lines of tables."""
    for name, told in tables.items():
        full, one = FULL.get(name, name.replace("_", ".")), isinstance(told, str)
        for table in (told,) if isinstance(told, str) else told:
            yield f"[{full}]" if one else f"[[{full}]]"
            yield from numbered(table) if name == "links" and "=" not in table else entries(table)


def numbered(letters: str) -> list[str]:
    """Number the links."""
    return [f'{number} = "{link}"' for number, link in enumerate(letters.split(), 1)]


def entries(told: str) -> list[str]:
    """Part the entries of a table."""
    return told.split("; ") if told else []
