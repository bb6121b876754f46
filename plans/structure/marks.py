"""What of a structure is explained: the formulas worked out, a group, a pair, by their letters (пояснения)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from plans.explanation import Explanation, NoMark, UnknownMark
from plans.structure.study import StructureStudy
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.study import Study


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Tell how a number of a structure is found, or what a group is; a structure is the same in every position."""
    known = _told(study.of(StructureStudy))
    if name not in known:
        return NoMark(tuple(known), message("mark.marks", marks=", ".join(known)), ())
    if position:
        raise UnknownMark(message("mark.no_position", mark=name, position=position))
    return Explanation(message("explain.name", mark=name), (), {}, (known[name],))


def _told(study: StructureStudy) -> Mapping[str, Message]:
    """Say all that there is to be said, by its letters."""
    structure, freedom = study.structure, study.freedom
    n, counts = len(structure.links), {f"p{k}": count for k, count in enumerate(structure.counts, 1)}
    parts = {"n": n, "w": _signed(freedom.mobility), "spatial": _signed(structure.spatial)}
    plane = {"p1": structure.lower, "p2": structure.higher, "planar": _signed(structure.planar)}
    spatial = f"({parts['spatial']})" if structure.spatial < 0 else parts["spatial"]
    found = {
        "W": message("structure.told_w", **plane, n=n, w=parts["w"], within=freedom.within),
        "W_s": message("structure.told_spatial", n=n, **counts, spatial=parts["spatial"]),
        "q": message("structure.told_q", w=parts["w"], spatial=spatial, q=freedom.redundant),
    }
    for division in study.divisions:
        for group in division.groups:
            links = ", ".join(map(str, group.links))
            sizes = {"n": len(group.links), "p": 3 * len(group.links) // 2, "order": group.order}
            found[group.label] = message("structure.told_group", links=links, rank=group.roman, **sizes)
    numbers = {one.letters: one.rank for one in study.divisions} | {"N": len(study.replacements)}
    numbers |= {"W'": freedom.mobility, "W'_s": study.freed.spatial, "q'": freedom.within}
    told = {name: message("structure.told_number", mark=name, value=str(value)) for name, value in numbers.items()}
    return told | found


def _signed(value: int) -> str:
    return str(value).replace("-", "\N{MINUS SIGN}")
