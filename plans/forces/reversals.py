"""Reversals within a stroke (обратные движения): which loads of one stroke alone count a point that has them."""

from __future__ import annotations

from collections.abc import Iterator

from plans.forces.statics import Statics
from plans.forces.stroke import counted
from plans.model.machine import IDLE, WORKING, Force, Moment


def reversals(statics: Statics) -> Iterator[tuple[Force | Moment, tuple[float, ...]]]:
    """Give the loads of one stroke alone whose output reverses within a stroke, and the crank angles of its rests."""
    study = statics.study
    for load in statics.machine.loads:
        shown = counted(study.mechanism, load, study.output) if load.during in (WORKING, IDLE) else None
        found = statics.reached(shown) if shown else None
        if found is not None and len(found.rests) > 2:
            yield load, found.rests
