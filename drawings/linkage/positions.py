"""Positions: what a linkage must be to be drawn, which are shown, the plan of positions alone (план положений)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import partial
from typing import Any, cast

import numpy as np

from drawings.layout.contents import Panel
from drawings.linkage import position_plan
from drawings.linkage.notes import notes
from drawings.linkage.numbering import apart
from drawings.linkage.skeleton import Skeletons, skeletons
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf, SheetError
from drawings.paper.walk import PLACES
from drawings.sheets.documents import letter
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, Exhibit
from geometry.errors import LimitError
from plans.forces.quantities import ForceComparison
from plans.forces.reading.form import ForceForm
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison
from plans.linkage.reading.form import LinkageForm
from plans.linkage.study import LinkageStudy
from plans.model.dyad import formula
from plans.model.mechanism import output_way
from plans.model.motion import POSITIONS, Motion
from plans.scene.faults import Path
from plans.scene.scene import Scene
from plans.study import Study
from plans.words.words import message, placed

POSITIONS_DRAWN = 360  # more positions than degrees cannot be told apart on any sheet


def of_linkage(scene: Scene) -> None:
    """See that the names of a linkage can be lettered, and that its positions can be told apart."""
    letter(scene, _points(scene))
    count = scene.of(LinkageForm).drive.count
    if count > POSITIONS_DRAWN:
        most = message("limit.sheet", most=POSITIONS_DRAWN)
        raise LimitError(placed(f"{scene.file}: drive.positions = {count}", most))


def _points(scene: Scene) -> Iterator[tuple[Path, str]]:
    mechanism = scene.of(LinkageForm).mechanism
    for table in ("frame", "points"):
        yield from ((("mechanism", table, name), name) for name in getattr(mechanism, table))
    for link, letters in mechanism.links.items():
        yield from ((("mechanism", "links", str(link)), point) for point in letters)


CHOICES = 12  # positions that a message offers at most


def position(study: LinkageStudy, motion: Motion, beside: Collection[int] = ()) -> int:
    """Give the position drawn in full lines: the scene's own, the one whose forces stand beside, or the fastest one."""
    wanted = position_asked(study)
    if wanted is not None:
        return wanted
    free = ~study.lost
    named = [k for k in study.form.sheet.plans or beside if free[k]]
    return named[0] if named else _best(_telling(study, motion, 1), free & _working(study), free)


def position_asked(study: LinkageStudy) -> int | None:
    """Give the scene's own position in full lines, or any where none can be assembled; None: the scene names none."""
    wanted = study.form.sheet.position
    free = ~study.lost
    if not free.any():
        return 0  # nothing can be assembled: the sheet explains why, in the first position
    if wanted is not None and study.lost[wanted]:
        others = ", ".join(str(k) for k in np.flatnonzero(free)[:CHOICES])
        refused = message("refused.position", position=wanted, positions=others)
        raise SheetError(placed(study.scene.file, refused))
    return None if wanted is None else int(wanted)


def plans(
    study: LinkageStudy, comparison: MotionComparison, shown: int, beside: Collection[int] = ()
) -> tuple[int, ...]:
    """Give the positions whose plans are drawn: the scene's own, or the shown one, then one of a large acceleration.

    Where the forces of several positions stand beside, their inertia forces want the plans of these.
    """
    if study.lost.all():
        return ()
    if study.form.sheet.plans:
        return study.form.sheet.plans
    if len(beside) > 1:
        return tuple(sorted({shown, *beside}))
    free = ~study.lost
    free[shown] = False
    motion = comparison.construction
    telling = _telling(study, motion, 1) * _telling(study, motion, 2)  # both of its plans are open figures
    free &= ~np.isnan(telling)
    if not free.any():
        return (shown,)
    other = _best(telling, free & ~_working(study), free)
    return shown, other


def planless(study: LinkageStudy, comparison: MotionComparison, beside: Sequence[int]) -> tuple[int, ...]:
    """Give of the positions whose forces are drawn those whose plans no kinematics sheet of the set shows."""
    if "kinematics" not in study.scene.sheets:
        return tuple(beside)
    drawn = plans(study, comparison, position(study, comparison.construction, beside), beside)
    return tuple(k for k in beside if k not in drawn)


def force_positions(statics: Statics, comparison: ForceComparison) -> tuple[int, ...]:
    """Give the positions whose forces are drawn: the scene's own, or the one that is worth most to draw."""
    study = statics.study
    roads = comparison.analysis, comparison.construction
    gone = {gap.position: gap for road in roads for gap in road.gaps}
    have = [k for k in range(len(study.turn)) if k not in gone]
    if not have:
        first = gone[min(gone)]
        where = {"reason": first.reason, "where": first.where, "position": first.position, "advice": first.advice}
        raise SheetError(placed(study.scene.file, message("refused.no_force", **where)))
    form = cast("ForceForm | None", study.scene.part("forces"))
    wanted = form.sheet.forces if form else ()
    for index, k in enumerate(wanted):
        if k in gone:
            line, column = study.scene.place(("sheet", "forces", index))
            where = {"reason": gone[k].reason, "where": gone[k].where, "position": k}
            refused = message("refused.no_forces", **where, positions=", ".join(map(str, have[:CHOICES])))
            raise SheetError(placed(f"{study.scene.file}:{line}:{column}", refused))
    asked = position_asked(study)
    return wanted or (asked if asked in have else _worthiest(statics, comparison, have),)


def _worthiest(statics: Statics, comparison: ForceComparison, have: Collection[int]) -> int:
    """Give the position whose forces are worth most to draw, of those with plans before all others (see `worth`)."""
    from plans.forces.worth import worth  # noqa: PLC0415  (only a scene with force sheets needs it)

    sizes = worth(statics, comparison.construction).sizes
    possible, plans = np.zeros((2, len(sizes)), dtype=bool)
    possible[list(have)] = True
    plans[list(statics.study.form.sheet.plans)] = True
    return _best(sizes, plans & possible & (sizes > 0.0), possible)


def _telling(study: LinkageStudy, motion: Motion, order: int) -> Any:
    """Rate the positions by what their plan shows: the output moves, and the plan is an open figure, not one line."""
    motions = motion.points.values()
    ends = np.array([np.zeros(len(study.turn)), *(m.v if order == 1 else m.a for m in motions)])
    spread = ends - ends.mean(axis=0)
    across = (np.abs(spread) ** 2).mean(axis=0), (spread**2).mean(axis=0)
    area = np.sqrt(np.maximum(across[0] ** 2 - np.abs(across[1]) ** 2, 0.0))  # of the ends' ellipse, times a constant
    # The output's velocity over the positions, of its pin or of its turning
    out = study.output
    counted = output_way(study.mechanism, out)
    speed = motion.links[out.link].omega if counted is None else motion.points[counted[0]].v
    return np.sqrt(area) * np.abs(speed)


def _working(study: LinkageStudy) -> Any:
    """Tell the positions within the working stroke; all of them where the output has no extremes."""
    if study.travel is None:
        return np.ones(len(study.turn), dtype=bool)
    start, end = study.travel.extremes.phi
    ahead = np.mod(study.sense * (study.turn.phi - start), 2 * np.pi)
    return ahead < np.mod(study.sense * (end - start), 2 * np.pi)


def _best(sizes: Any, preferred: Any, allowed: Any) -> int:
    """Give the position of the largest size among the preferred, or else among the allowed: the first of equal ones."""
    known = ~np.isnan(sizes)
    chosen = preferred if (preferred & known).any() else allowed
    shares = sizes / (np.nanmax(sizes, initial=0.0) or 1.0)
    return int(np.argmax(np.where(chosen & known, np.round(shares, PLACES), -1.0)))


FOREMOST = 1.5  # the plan of positions states the scale of its sheet, and is doubled though all others are halved
SHARE = 1 / 3  # of its sheet


def shown_positions(bones: Skeletons, drafting: Drafting) -> Iterator[Exhibit]:
    """Measure the plan of positions and the detail of a tiny crank circle, to be drawn where they have their spots."""
    room = position_plan.measure(bones, POSITIONS.plan, drafting)
    yield Exhibit(Panel(room, FOREMOST, share=SHARE), partial(position_plan.draw, bones, room, drafting=drafting))
    if apart(bones):
        detail = position_plan.measure_detail(bones, drafting)
        yield Exhibit(Panel(detail), partial(position_plan.draw_detail, bones, detail, drafting=drafting))


def facts_of(study: LinkageStudy, shown: int, names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet of which mechanism it is, and which position its plan of positions shows."""
    drawn = shown if POSITIONS.plan in names else None
    return {"structure": formula(study.mechanism, study.groups), "positions": len(study.turn), "shown": drawn}


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheet of the plan of positions."""
    linkage, drafting = study.of(LinkageStudy), drafting_of(study.scene)
    # The position in full lines: the scene's own, or the first that can be assembled
    asked = position_asked(linkage)
    comparison, shown = study.of(MotionComparison), int(np.argmax(~linkage.lost)) if asked is None else asked
    bones = skeletons(linkage, comparison.construction, shown)
    figures = tuple(shown_positions(bones, drafting))

    def facts(names: Collection[str]) -> dict[str, Any]:
        return {**facts_of(linkage, shown, names), "plans": [], "vectors": []}

    words = tuple(notes(linkage, comparison, drafting.language))
    return lay_out(study.scene, [Draft("positions", drafting.word(POSITIONS.plan), figures, (), words, facts)])
