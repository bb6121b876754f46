"""The exception tree.

DraftError
├── SceneError          (plans.faults)     the scene file is wrong
├── StructureError      (plans.mechanism)  no crank plus dyads
├── ConstructionError   a construction has no result
│   ├── NoMeeting       two loci do not reach each other
│   └── Parallel        two lines have one direction
├── SheetError          (drawings.strokes) the sheet cannot be laid out or written
├── SelfCheckFailed     (drawings.verify)  a sheet or a comparison failed plandraft's own check
├── Refused             (drawings.limits)  a sheet that cannot be measured
├── PressError          (drawings.press)   a file could not be written
└── LimitError          a named limit was exceeded
"""

from __future__ import annotations


class DraftError(Exception):
    """Anything plandraft can say about its input or its drawing; never a bug of plandraft."""


class ConstructionError(DraftError, ArithmeticError):
    """A construction that has no result with the given data."""


class NoMeeting(ConstructionError):  # noqa: N818  (the tree's own word)
    """Two loci that do not reach each other; `miss` tells by how many metres."""

    def __init__(self, message: str, miss: float) -> None:
        super().__init__(message)
        self.miss = miss


class Parallel(ConstructionError):  # noqa: N818
    """Two lines of one direction have no meeting: a dead centre of the construction."""


class LimitError(DraftError):
    """A named limit was exceeded."""
