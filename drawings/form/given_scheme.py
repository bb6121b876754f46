"""The scheme that a form gives: the mechanism between two of its positions, not to scale (кинематическая схема)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from drawings.layout.contents import Panel
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Spot
from drawings.linkage.guides import arrows
from drawings.linkage.pose import Pose, general, letters, measured, pose, scheme
from drawings.linkage.skeleton import Pairs
from drawings.page.page import Drafting
from drawings.paper.strokes import GIVEN, Stroke
from drawings.sheets.stated_scales import Exhibit
from drawings.symbols.figure import heading
from geometry.errors import DraftError
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import at_angles
from plans.study import Study

MARGINS = Margins(3.0, 3.5, 3.4)  # paper around it for letters, stands, guides and numbers, in sizes of letters
SIZES = (14.0, 10.0)  # of its letters: how large it is drawn, and how large where a sheet more would be taken


def given_scheme(study: Study, drafting: Drafting, size: float) -> Iterator[Exhibit]:
    """Show the mechanism of a task, so many letters large; of a task without one, or that no position has, nothing."""
    if (bones := _between(study)) is None:
        return
    room = measured(GIVEN, bones.points, drafting.word("form scheme"), (MARGINS, 0.0), drafting)
    room = room.at(max(room.wide, room.high) / (size * drafting.hand.letter))
    yield Exhibit(Panel(room), partial(_draw, bones, room, drafting=drafting))


def _between(task: Study) -> Pose | None:
    """Give the pose that is shown; a structure of a class that is not constructed has none."""
    try:
        return _halfway(task.of(LinkageStudy)) if "linkage" in task.scene.techniques else None
    except DraftError:
        return None


def _halfway(study: LinkageStudy) -> Pose | None:
    """Give the most general pose half-way between two positions, which is none of those that are sought."""
    phi = study.turn.phi
    for angles in ((phi[:-1] + phi[1:]) / 2, phi):
        between = study.at(at_angles(angles))
        if len(angles) and not between.lost.all():
            open_most = general([point.r for point in between.motion(0).points.values()])
            k = int(np.nanargmax(np.where(between.lost, np.nan, open_most)))
            shown = study.at(at_angles(angles[k : k + 1]))
            return pose(shown, shown.motion(0), 0)
    return None


def _draw(bones: Pose, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot, with the sense in which its primary link moves; nothing on it can be measured."""
    pairs, hand = Pairs(bones, room.place(*spot), drafting.hand), drafting.hand
    head = heading(spot.box, drafting.word("form scheme"), drafting.word("form out of scale"), hand)
    senses = [arrow for arrow in arrows(pairs) if arrow.letter[0] in "ωv"]  # its rate, not how that changes

    def lettered(labels: Labels) -> Iterator[Stroke]:
        for arrow in senses:
            yield labels.beside(arrow.middle[0], arrow.letter, hand.letter, 1.5, arrow.middle[1])
        yield from letters(pairs, (), labels)

    lines = (head, *scheme(pairs, None), *(part for arrow in senses for part in arrow.strokes(pairs)))
    return LetteredFigure(GIVEN, lines, lettered, data={"kind": GIVEN})
