"""Arms of forces by the letters that a sheet numbers them by: whose moment each gives (плечи сил)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.forces.lever_layout import leverages
from drawings.forces.lever_plan import balance, hanging
from drawings.page.scale import drafting_of
from plans.forces.force_template import ForcePlans
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.study import Study

BARE = str.maketrans("′", "'", "{}")


def of_arm(study: Study, position: int, letter: str) -> str:
    """Name the moment that an arm gives on the record of a position, or the force that is found by it; "" if none is.

    The arm h_2 of a scheme may give D(G_4), the arm h'_3 of the lever p(F_us).
    """
    if not letter.startswith("h") or not 0 <= position < len(study.of(LinkageStudy).turn):
        return ""
    plans: ForcePlans = study.of(Statics).drafts([position]).plans
    return next((name for arm, name in _arms(study, plans) if arm.translate(BARE) == letter), "")


def _arms(study: Study, plans: ForcePlans) -> Iterator[tuple[str, str]]:
    for cut in plans.plan.cuts:
        for arm in leverages(plans.plan, cut, 0):
            moment = f"{arm.about}({arm.name})"
            yield arm.letter, moment if moment in plans.plan.board else arm.name
    if plans.lever is not None:
        for one in balance(hanging(plans.plan, plans.lever, 0), drafting_of(study.scene)):
            moment = f"{plans.lever.pole.name}({one.force.partition('/')[0]})"
            yield one.arm, moment if moment in plans.lever.board else one.force
