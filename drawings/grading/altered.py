"""Tasks mistaken as a whole: what is due on a sheet if the machine were loaded otherwise (ошибка в условии)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TypeAlias, TypeVar

from drawings.checks.expected import Expected
from drawings.paper.strokes import Kind
from drawings.redrawn import Originals
from drawings.sheets.kind import sheet_kind
from plans.forces.statics import Statics
from plans.model.machine import ALWAYS, Force, Machine, Moment

LOADED = "dynamics"  # the kind of sheets on which all follows from the loads
Dues: TypeAlias = Mapping[tuple[Kind, str, str], Expected]  # by figures and names
L = TypeVar("L", Force, Moment)


@lru_cache(maxsize=8)
def idle_due(originals: Originals, kind: str) -> Dues:
    """Give what is due on sheets of a kind if the idle stroke is loaded as the working one; nothing if it is so."""
    machine = _idle(originals.study.of(Statics).machine) if kind == LOADED else None
    if machine is None:
        return {}
    leaves = [sheet.leaf for sheet in originals.sheets if sheet.kind == kind]
    study = originals.study.exchanged("forces", originals.study.of(Statics).bearing(machine))
    return {(row.kind, row.figure, row.name): row for row in sheet_kind(kind).expected(study, leaves)}


def _idle(machine: Machine) -> Machine | None:
    """Load the idle stroke of a machine as the working one; None where no load rests there."""
    forces, moments = tuple(map(_back, machine.forces)), tuple(map(_back, machine.moments))
    changed = (forces, moments) != (machine.forces, machine.moments)
    return replace(machine, forces=forces, moments=moments) if changed else None


def _back(load: L) -> L:
    load = load._replace(during=ALWAYS)
    if isinstance(load, Force) and load.diagram is not None and not load.diagram.back:
        return load._replace(diagram=load.diagram._replace(back=load.diagram.sizes))
    return load
