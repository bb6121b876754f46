"""What the edges of a turn's strips are called: positions by their numbers, 1' between two of them (номера границ)."""

from __future__ import annotations

from plans.model.dynamics import TURN
from plans.model.motion import Floats

SAME = 1e-9  # of a strip: an edge so near a position is that position


def edge_names(turned: Floats, divisions: int) -> tuple[str, ...]:
    """Name edges at angles turned, rad, of a turn of so many divisions.

    >>> import numpy as np
    >>> edge_names(TURN / 8 * np.array([0.0, 1.0, 1.3, 1.7, 2.0]), 8)
    ('0', '1', "1'", "1''", '2')
    """
    names: list[str] = []
    for place in turned * divisions / TURN:
        near = round(float(place))
        if abs(place - near) <= SAME:
            names.append(str(near))
        else:
            whole = str(int(place))
            names.append(whole + "'" * (1 + sum(name.startswith(f"{whole}'") for name in names)))
    return tuple(names)
