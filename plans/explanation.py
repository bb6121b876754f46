"""An explanation (пояснение): the drafting steps behind a mark, in order, as a technique gives them to be told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from geometry.board import Mark
from geometry.errors import DraftError
from plans.words.words import Message


class UnknownMark(DraftError, ValueError):  # noqa: N818  (the message's own word)
    """A name that no plan of the scene has."""


class Explanation(NamedTuple):
    """The steps behind a mark, with the units of the plans that they were drawn on, and what follows from them."""

    title: Message
    steps: tuple[Mark, ...]
    units: Mapping[str, str]
    notes: tuple[Message, ...] = ()
    home: str = ""  # the plan whose marks are named without it
    letters: Callable[[str, str], str] = lambda name, language: name  # a name as a language writes it
    zeros: frozenset[Mark] = frozenset()  # marks whose coordinates are nothing but rounding


class NoMark(NamedTuple):
    """That a technique has no mark of a name: which names it has, in words, and what else it can explain."""

    names: tuple[str, ...]
    listed: Message | None
    examples: tuple[str, ...]
