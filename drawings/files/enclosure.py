"""Enclosures: files that are written beside the sheets, and are of their set (приложения к листам)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from plans.words.words import Message


class Enclosure(NamedTuple):
    """A file beside a sheet: the end of its name after the scene's, its content, and what is wrong with one written."""

    name: str
    content: bytes
    faults: Callable[[bytes], Iterable[Message | str]]
