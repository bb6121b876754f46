"""The plan of positions alone: no velocities, no accelerations, no extremes are made for it (план положений)."""

from __future__ import annotations

from collections.abc import Collection
from functools import partial
from typing import Any

import numpy as np

from drawings.figures.linkage import position_plan
from drawings.figures.linkage.skeleton import skeletons
from drawings.layout.contents import Panel
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.choice import position_asked
from drawings.sheets.draft import Draft, Exhibit
from drawings.sheets.leaves import lay_out
from drawings.sheets.notes import notes
from plans.linkage.study import LinkageStudy
from plans.model.order import POSITIONS
from plans.model.structure import formula
from plans.study import Study

FOREMOST = 1.5  # it states the scale of the sheet
SHARE = 1 / 3  # of its sheet


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheet of the plan of positions."""
    linkage, drafting = study["linkage"], drafting_of(study.scene)
    comparison, shown = study.comparison("linkage"), _shown(linkage)
    bones = skeletons(linkage, comparison.construction, shown)
    room = position_plan.measure(bones, POSITIONS.plan, drafting)
    figure = Exhibit(Panel(room, FOREMOST, share=SHARE), partial(position_plan.draw, bones, room, drafting=drafting))

    def facts(names: Collection[str]) -> dict[str, Any]:
        return {
            "structure": formula(linkage.mechanism, linkage.groups),
            "positions": len(linkage.turn),
            "shown": shown if POSITIONS.plan in names else None,
            "plans": [],
            "vectors": [],
        }

    words = tuple(notes(linkage, comparison, drafting.language))
    return lay_out(study.scene, [Draft("positions", drafting.word(POSITIONS.plan), (figure,), (), words, facts)])


def _shown(study: LinkageStudy) -> int:
    """Give the position in full lines: the scene's own, or the first that can be assembled."""
    asked = position_asked(study)
    return int(np.argmax(~study.lost)) if asked is None else asked
