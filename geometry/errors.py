"""The exception tree.

DraftError
├── SceneError          (plans.scene.faults)     the scene file is wrong
├── StructureError      (plans.model.mechanism)  no crank plus dyads
├── ConstructionError   a construction has no result
├── SheetError          (drawings.paper.strokes) the sheet cannot be laid out or written
├── SelfCheckFailed     (drawings.checks.verify) a sheet or a comparison failed plandraft's own check
├── Refused             (drawings.paper.limits)  a sheet that cannot be measured
├── FileError           (drawings.files)         a file could not be written
└── LimitError          a named limit was exceeded
"""

from __future__ import annotations


class DraftError(Exception):
    """Anything plandraft can say about its input or its drawing; never a bug of plandraft."""

    exit_code = 3  # the command's: the scene is wrong


class ConstructionError(DraftError, ArithmeticError):
    """A construction that has no result with the given data."""


class LimitError(DraftError):
    """A named limit was exceeded."""

    exit_code = 8
