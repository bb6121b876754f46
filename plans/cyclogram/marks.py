"""Marks of a cyclogram by the names that `explain` takes: phi_1 is the crank in position 1 (точки циклограммы)."""

from __future__ import annotations

import re

import numpy as np

from geometry.board import behind
from plans.cyclogram.stations import alone, crank
from plans.cyclogram.study import CyclogramStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.model.cyclogram import BEGIN, END
from plans.model.motion import POSITIONS
from plans.study import Study
from plans.words.words import message

NAME = re.compile(r"(?:φ|phi)_(?P<number>\d+)")
UNITS = {POSITIONS.plan: "m"}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps from the tool back to the crank in a characteristic position."""
    found = study.of(CyclogramStudy)
    positions, asked = found.cyclogram.positions, NAME.fullmatch(name)
    if asked is None:
        inner = (k for k, stage in enumerate(positions) if stage.role not in (BEGIN, END) and stage.notched)
        examples = tuple(f"phi_{k}" for k in inner)
        return NoMark(examples, message("mark.characteristic", last=len(positions) - 1), examples[:1])
    number = int(asked["number"])
    if number >= len(positions):
        raise UnknownMark(message("mark.position", position=number, last=len(positions) - 1))
    plan = alone(found.stations, positions, number)
    if plan is None:
        raise UnknownMark(message("mark.not_notched", position=number))
    parts = {"mark": name, "position": number, "angle": f"{np.degrees(positions[number].turned):.10g}"}
    return Explanation(message("explain.title", **parts), tuple(behind(crank(plan))), UNITS, (), POSITIONS.plan)
