"""What is studied, in a few words: a row and a sentence of the gallery's page (предмет)."""

from __future__ import annotations

from typing import NamedTuple


class Subject(NamedTuple):
    """The subject of a study: its structure and what comes out of it, and both in a sentence."""

    structure: str
    output: str
    sentence: str
