"""The scheme that a form gives: the mechanism between two positions of its task, not to scale (кинематическая схема).

It is a part of what is given: nothing on it is measured, no position has a number, no force or velocity is drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from types import MappingProxyType
from typing import Final

import numpy as np

from drawings.layout.contents import Panel
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Spot
from drawings.linkage.guides import arrows
from drawings.linkage.pose import Pose, letters, measured, pose, scheme
from drawings.linkage.positions import position
from drawings.linkage.skeleton import Pairs, reference
from drawings.page.page import Drafting
from drawings.paper.strokes import GIVEN, Stroke
from drawings.sheets.stated_scales import Exhibit
from drawings.structure import scheme as structure_scheme
from drawings.structure.links import whole
from drawings.structure.scheme import StructureScheme
from drawings.symbols.figure import heading
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import at_angles
from plans.structure.study import STRUCTURE, StructureStudy
from plans.study import Study

NAME: Final = "given"
DATA: Final[Mapping[str, str]] = MappingProxyType({"kind": GIVEN})
MARGINS = Margins(2.5, 3.5, 1.5)  # paper around it for letters, stands and numbers, in sizes of letters
SIZES = (14.0, 10.0)  # of its letters: how large it is drawn, and how large where a sheet more would be taken
RATES = "ωv"  # how the letters of what the drive is given begin


def given_scheme(study: Study, kind: str, drafting: Drafting, letters_large: float) -> Iterator[Exhibit]:
    """Show the mechanism of a task on a sheet, so many letters large; none of a task that has no mechanism."""
    if kind == STRUCTURE:
        structure = study.of(StructureStudy)
        links = whole(structure, structure.structure, reference(structure.mechanism))
        words = drafting.word("form scheme"), drafting.word("form out of scale")
        shown = StructureScheme(NAME, words[0], (("", links),), said=words[1], data=DATA)
        room = _sized(structure_scheme.measure(shown, drafting), letters_large, drafting)
        yield Exhibit(Panel(room), partial(structure_scheme.draw, shown, room, drafting=drafting))
    elif "linkage" in study.techniques and (bones := _between(study)) is not None:
        title = drafting.word("form scheme")
        room = _sized(measured(NAME, bones.points, title, (MARGINS, 0.0), drafting), letters_large, drafting)
        yield Exhibit(Panel(room), partial(_draw, bones, room, drafting=drafting))


def _sized(room: Picture, letters_large: float, drafting: Drafting) -> Picture:
    """Give a picture so many letters large, at whatever scale that is."""
    return room.at(max(room.wide, room.high) / (letters_large * drafting.hand.letter))


def _between(study: Study) -> Pose | None:
    """Give the mechanism half a step past the position that shows most: the scheme is none of those that are sought.

    It stays in that position where it has no next one, or does not come so far; None where nothing can be assembled.
    """
    linkage = study.of(LinkageStudy)
    if linkage.lost.all():
        return None
    k, phi = position(linkage, linkage.motion(1)), linkage.turn.phi
    for at in ((phi[k] + phi[k + 1]) / 2, phi[k]) if k + 1 < len(phi) else (phi[k],):
        apart = linkage.at(at_angles(np.array([at])))
        if not apart.lost.any():
            return pose(apart, apart.motion(0), 0)
    return None


def _draw(bones: Pose, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot, with the sense in which its primary link moves."""
    pairs, hand = Pairs(bones, room.place(*spot), drafting.hand), drafting.hand
    head = heading(spot.box, drafting.word("form scheme"), drafting.word("form out of scale"), hand)
    senses = [arrow for arrow in arrows(pairs) if arrow.letter[0] in RATES]
    turning = (part for arrow in senses for part in arrow.strokes(pairs))

    def lettered(labels: Labels) -> Iterator[Stroke]:
        yield from (labels.beside(at, of.letter, hand.letter, 1.5, off) for of in senses for at, off in (of.middle,))
        yield from letters(pairs, (), labels)

    return LetteredFigure(NAME, (head, *scheme(pairs, None), *turning), lettered, data=DATA)
