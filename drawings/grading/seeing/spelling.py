"""Spelling: letters as anybody may write them, and the labels of a sheet by what they look like (как написано)."""

from __future__ import annotations

import re
from functools import lru_cache

from drawings.checks.letters import Label, labels_of
from drawings.eye.alike import folded
from drawings.lettering.indices import with_index
from drawings.paper.strokes import Stroke, Text

_NAMES = {"pi": "π"}


@lru_cache(maxsize=1024)
def spelled(letter: str) -> str:
    """Write a letter as anybody may write it: without the marks of levels, as it looks.

    >>> spelled("n_A"), spelled("n_{A}") == spelled("nA"), spelled("pi") == spelled("π")
    ('nA', True, True)
    """
    plain = Text(0j, letter if "{" in letter else with_index(letter)).plain
    plain = re.sub(r"[_{}^\s]", "", plain)
    return folded(_NAMES.get(plain, plain))


def spelled_labels(strokes: tuple[Stroke, ...]) -> dict[str, list[Label]]:
    """Give the labels of strokes by how their letters look; one label may bear several."""
    found: dict[str, list[Label]] = {}
    for letter, labels in labels_of(strokes).items():
        found.setdefault(spelled(letter), []).extend(labels)
    return found
