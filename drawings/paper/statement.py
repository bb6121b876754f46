"""What a piece of ink states: its kind, the figure that it stands on, whose it is, in which position (утверждение)."""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple, TypeAlias


class Kind(StrEnum):
    """The kinds of statements; each has one reader, which alone knows how a kind is drawn."""

    VECTOR = "vector"
    POINT = "point"
    CURVE = "curve"
    LENGTH = "length"
    ANGLE = "angle"
    DIRECTION = "direction"
    NUMBER = "number"
    LETTER = "letter"
    AXIS = "axis"
    PHRASE = "phrase"


Key: TypeAlias = tuple[Kind, str, str, int | None]


class Statement(NamedTuple):
    """What ink states: its key, and how much of the true unit a millimetre of it is worth, where it is to scale.

    `figure` is the name of a plan, a graph, a table; `name` that of the vector, the row, the point.
    """

    kind: Kind
    figure: str
    name: str
    position: int | None = None
    scale: float = 0.0

    @property
    def key(self) -> Key:
        """What is stated of whom; a sheet states it once."""
        return self[:4]
