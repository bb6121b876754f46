"""A scene tried by chance hands: how many of its drawings are accepted, and what share of its values is out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.grading.asked import PlanAsked
from drawings.grading.curves.figure_records import POINTS, FigureAsked
from drawings.grading.verdict import UNGRADED, Verdict
from plans.quantity import SLIP
from tests.drawings.curve_draughtsman import drawings as curves_by_hand
from tests.drawings.students import task
from tests.hands.plans_by_hand import Ends, Key, PlansByHand, beside_one_another
from tests.hands.shares import Share, foretold, promised

POOR = 2.0  # mm: nobody's hand
BETWEEN = (0.4, 0.8, 1.2)  # mm
GRADED = 20  # drawings of each slip that are graded as sheets are
DRAWN = 400  # drawings of each slip in which every vector is held against what is allowed to it
CURVES = 60  # drawings of curves, each of which takes as long as a sheet
FORETOLD = 2000


class Held(NamedTuple):
    """One vector or figure at one slip: the share that is out as it was drawn, and as its slips say."""

    name: str
    drawn: Share
    told: Share
    most: bool = False  # whether the drawn share is only to be no larger: of what may follow and be right by that

    @property
    def fair(self) -> bool:
        """Whether the tolerance does what it says."""
        return self.drawn.agrees(self.told) or (self.most and self.drawn.part < self.told.part)


class Slipped(NamedTuple):
    """A scene drawn by hands that slip by so many mm: how many are accepted of how many, and each value by itself."""

    slip: float
    accepted: int
    graded: int
    held: tuple[Held, ...] = ()

    @property
    def faults(self) -> list[str]:
        """What is not as the tolerance says."""
        told = (
            f"{one.name}: {one.drawn.part:.1%} are out, foretold {one.told.part:.1%}"
            for one in self.held
            if not one.fair
        )
        refused = ["a fair hand is refused"] if self.slip == SLIP and self.accepted < self.graded else []
        passed = ["a poor hand is accepted"] if self.slip == POOR and self.accepted else []
        return [*refused, *told, *passed]


def of_scene(scene: str, seed: int = 7) -> Iterator[Slipped]:
    """Try a scene of the gallery with a fair hand, with poorer ones and with a poor one."""
    plans, figures = task(scene).plans, task(scene).figures
    return tried(plans, figures, seed) if plans or figures else iter(())


def tried(plans: Sequence[PlanAsked], figures: tuple[FigureAsked, ...], seed: int) -> Iterator[Slipped]:
    """Try what is asked for with each hand."""
    groups = beside_one_another(plans)
    sheets = [tuple(one for one in figures if one.sheet == name) for name in dict.fromkeys(f.sheet for f in figures)]
    for slip in (SLIP, *BETWEEN, POOR):
        chance = np.random.default_rng(seed)
        drawn = [group.arrows(slip, DRAWN, chance) for group in groups]
        ends = [_all_good(groups, drawn, k) for k in range(GRADED)]
        between = slip in BETWEEN
        curves = [list(curves_by_hand(sheet, slip, CURVES if between else GRADED)) for sheet in sheets]
        accepted = sum(end and all(_good(own[k]) for own in curves) for k, end in enumerate(ends))
        held = list(_vectors(groups, drawn, slip, chance)) if between else []
        for sheet, own in zip(sheets, curves, strict=True) if between else ():
            held += _figures(sheet, own, slip, chance)
        yield Slipped(slip, accepted, GRADED, tuple(held))


def _all_good(groups: Sequence[PlansByHand], drawn: Sequence[dict[Key, Ends]], number: int) -> bool:
    return all(_good(group.verdicts(group.drawn(own, number))) for group, own in zip(groups, drawn, strict=True))


def _good(verdicts: Sequence[Verdict] | Iterator[Verdict]) -> bool:
    return all(one.good or one.kind in UNGRADED for one in verdicts)


def _vectors(
    groups: Sequence[PlansByHand], drawn: Sequence[dict[Key, Ends]], slip: float, chance: np.random.Generator
) -> Iterator[Held]:
    """Hold each vector of which the slips tell anything."""
    for group, arrows in zip(groups, drawn, strict=True):
        allowed, asked = group.allowed(), group.asked
        for key, slips in group.slips(slip).items():
            if np.isfinite(allowed[key]):
                off = np.abs(arrows[key][1] - arrows[key][0] - asked[key].true)
                out = Share(int((~(off <= allowed[key])).sum()), DRAWN)
                yield Held(
                    f"{key[0]} {asked[key].name}", out, foretold(slips, promised(slips) * SLIP / slip, FORETOLD, chance)
                )


def _figures(
    figures: Sequence[FigureAsked], curves: Sequence[Sequence[Verdict]], slip: float, chance: np.random.Generator
) -> Iterator[Held]:
    """Hold each figure as a whole: its values are out together, so that there are no more than there are drawings."""
    for one in figures:
        names = {(one.plan, item.called) for item in one.items}
        own = [[said for said in told if (said.plan, said.name) in names] for told in curves]
        bad = [np.mean([not said.good for said in values]) for values in own]
        ways = np.array([1, 1, 1j, 1j] if one.kind == POINTS else [1, 1]) / np.sqrt(2)  # two slips each way
        slips = [slip * one.scale * one.error[k] * ways for k in one.places]
        allowed = [promised(own) * SLIP / slip + slack for own, slack in zip(slips, one.slack[one.places], strict=True)]
        told = [foretold(*row, FORETOLD, chance).part for row in zip(slips, allowed, strict=True)]
        shares = (round(float(np.sum(bad))), len(bad)), (round(float(np.mean(told)) * FORETOLD), FORETOLD)
        yield Held(f"{one.plan} {one.key}", Share(*shares[0]), Share(*shares[1]), most=True)
