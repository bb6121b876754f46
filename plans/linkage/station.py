"""Where the drive is, in words: the angle of a crank, the way of a slider that is pushed along (положение привода)."""

from __future__ import annotations

import numpy as np

from plans.model.mechanism import Drive
from plans.words.words import Message, message

PLACES = 4  # decimals of degrees, and of millimetres


def told_at(key: str, drive: Drive, phi: float, /, **parts: object) -> Message:
    """Say something at a coordinate of the drive: by a key with its angle in degrees, or `key_way` with millimetres.

    >>> told_at("explain.title", Drive(1, "O", "A", 1.0, 0.0), 0.5, mark="B", position=1).worded("en")
    'B in position 1 (φ = 28.6479°)'
    """
    if not drive.pushed:
        return message(key, angle=f"{np.degrees(phi):.{PLACES}f}", **parts)
    return message(f"{key}_way", way=f"{1000 * drive.unit * phi:.{PLACES}f}", **parts)
