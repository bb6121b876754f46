"""The self-check of a force sheet's figures: written force plans and levers against the analysis (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.checks.wrong import on
from drawings.figures.forces.lever_layout import PLAN
from drawings.measure.measure import Measured
from drawings.paper.limits import SEEN
from plans.checks.force_expected import ExpectedForces, missed
from plans.model.group import Group
from plans.words.words import Message, message


def polygon_marks(
    measured: Measured, expected: ExpectedForces, groups: tuple[Group, ...], group: Group | None, allowed: float
) -> Iterator[Message]:
    """Hold the vectors of one written force plan against the analysis: each that must be there, each that is.

    `allowed` N is what the two roads may differ by; the paper's resolution comes on top.
    """
    links = (expected.mechanism.drive.link,) if group is None else group.links
    label = "-".join(map(str, links))
    plan = f"forces-{label}"
    vectors = [one for one in measured.vectors if one.plan == plan and one.position == expected.k]
    seen = {one.name: one.value for one in vectors}
    must, parts = expected.polygon(groups, group), expected.parts(group)
    scale = max((one.scale for one in vectors), default=0.0)
    slack = allowed + 2 * measured.quantum * scale
    if not vectors and any(abs(value) > slack for value in must.values()):
        yield message("wrong.force_plan", group=label, position=expected.k)
        return
    for wrong in missed(seen, must, parts, slack, SEEN * scale + slack):
        yield on("place", plan, wrong=wrong, position=expected.k)


def lever_marks(
    measured: Measured, expected: ExpectedForces, letters: Mapping[str, str], allowed: float
) -> Iterator[Message]:
    """Hold the images on a written lever against the velocities by analysis, turned by a quarter.

    `letters` are the points' letters on the velocity plan; `allowed` m/s is what the two roads may differ by.
    """
    marks = {one.name: one for one in measured.points if one.plan == PLAN and one.position == expected.k}
    for point, letter in letters.items():
        mark = marks.get(letter)
        if (
            mark is not None
            and not abs(mark.value - expected.image(point)) <= allowed + 2 * measured.quantum * mark.scale
        ):
            yield on("differs_at", PLAN, name=letter, position=expected.k)
