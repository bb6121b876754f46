"""Marks of instant centres by the names that `explain` takes: P_02, P_13 (мгновенные центры)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.board import behind
from plans.centres.kennedy import CENTRES, letter, pairs
from plans.centres.study import CentresStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage.marks import position_of, title
from plans.model.motion import POSITIONS
from plans.words.words import message

if TYPE_CHECKING:
    from plans.study import Study


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a centre in a position."""
    found = study.of(CentresStudy)
    named = {letter(pair): pair for pair in pairs(list(found.linkage.mechanism.links))}
    if name not in named:
        return NoMark(tuple(named), message("mark.marks", marks=", ".join(named)), tuple(named)[:1])
    wanted = position_of(found.linkage, position)
    centre = found.at(wanted).found.get(named[name])
    if centre is None:
        raise UnknownMark(message("mark.open_centre", mark=name, position=wanted))
    steps, units = tuple(behind(centre.mark)), {CENTRES: "m", POSITIONS.plan: "m"}
    return Explanation(title(found.linkage, name, wanted), steps, units, (), POSITIONS.plan)
