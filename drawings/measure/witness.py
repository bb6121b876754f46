"""The witness: who looks on while a sheet is read, so that it is read once for all that is taken from it (очевидец)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple, Protocol

from drawings.measure.transform import Affine
from drawings.measure.viewport import Viewport
from drawings.measure.visibility import Look
from plans.words.words import Message


class Frame(NamedTuple):
    """What an open element hands to those inside: its map to paper, its look, and why a mark in it is refused."""

    tag: str
    to_paper: Affine
    look: Look
    refusal: Message | None


class Witness(Protocol):
    """Who looks on while a sheet is read, element by element, within the reader's limits."""

    def opened(self, attributes: Mapping[str, str]) -> Viewport:
        """Give the paper that a root lays what is drawn on."""

    def enter(self, frame: Frame, attributes: Mapping[str, str]) -> None:
        """See an element begin; one that is no SVG has no tag."""

    def hear(self, text: str) -> None:
        """Take the characters within the innermost element."""

    def leave(self) -> None:
        """See the innermost element end."""
