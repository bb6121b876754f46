"""Forces over parts of the positions put together, and those of some positions left out (силы по участкам)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from plans.model.kinetostatics import Balancing, Kinetostatics, Reaction


def joined(parts: Sequence[Kinetostatics]) -> Kinetostatics:
    """Put the forces over parts of the positions together."""
    if len(parts) == 1:
        return parts[0]
    reactions = {}
    for key, first in parts[0].reactions.items():
        told = [part.reactions[key] for part in parts]
        rows = (_together([getattr(one, name) for one in told]) for name in ("r", "force", "moment", "along"))
        reactions[key] = Reaction(first.giver, first.taker, first.point, *rows)
    balancing = Balancing(*(_together(rows) for rows in zip(*(part.balancing for part in parts), strict=True)))
    return Kinetostatics(parts[0].by, np.concatenate([part.phi for part in parts]), reactions, balancing, ())


def without(forces: Kinetostatics, gone: npt.NDArray[np.bool_]) -> Kinetostatics:
    """Leave no force at some positions."""

    def kept(row: Any) -> Any:
        return None if row is None else np.where(gone, np.nan, row)

    reactions = {
        key: one._replace(force=kept(one.force), moment=kept(one.moment)) for key, one in forces.reactions.items()
    }
    told = forces.balancing
    balancing = Balancing(kept(told.moment), kept(told.force), told.r)
    return replace(forces, reactions=reactions, balancing=balancing)


def _together(rows: Sequence[Any]) -> Any:
    return None if rows[0] is None else np.concatenate(rows)
