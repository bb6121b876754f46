"""Tasks mistaken as a whole: what is due on a sheet if the machine were loaded otherwise (ошибка в условии)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple, TypeVar

from drawings.checks.expected import Expected
from drawings.grading import verdict
from drawings.paper.strokes import Kind
from drawings.redrawn import Original, Originals
from drawings.sheets.kind import sheet_kind
from plans.forces.statics import Statics
from plans.model.machine import ALWAYS, Force, Machine, Moment

KINDS = ("dynamics",)  # of sheets on which all follows from the loads
L = TypeVar("L", Force, Moment)


class Alteration(NamedTuple):
    """A mistake that changes all that follows from it: its kind, and what is due then, by figures and names."""

    kind: str
    due: Mapping[tuple[Kind, str, str], Expected]

    def of(self, row: Expected) -> Expected | None:
        """Give what is due in place of a row; None where nothing of its name is."""
        return self.due.get((row.kind, row.figure, row.name))


def alterations(originals: Originals, sheet: Original) -> tuple[Alteration, ...]:
    """Give what is due on a sheet by the mistakes that are known of a whole task."""
    return _found(originals, sheet.kind) if sheet.kind in KINDS else ()


@lru_cache(maxsize=8)
def _found(originals: Originals, kind: str) -> tuple[Alteration, ...]:
    leaves = [sheet.leaf for sheet in originals.sheets if sheet.kind == kind]
    machine = _idle(originals.study.of(Statics).machine)
    if machine is None:
        return ()
    study = originals.study.exchanged("forces", originals.study.of(Statics).bearing(machine))
    due = sheet_kind(kind).expected(study, leaves)
    return (Alteration(verdict.IDLE, {(row.kind, row.figure, row.name): row for row in due}),)


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
