"""The transfer functions by construction: those of a crank that turns by 1 rad/s evenly (передаточные функции)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import Any

import numpy as np

from geometry.board import Reading, Span
from plans.linkage.drafts import Drafts
from plans.linkage.reading.form import ChosenTable
from plans.linkage.reading.linkage import see_positions
from plans.linkage.reading.survey import LinkageSurvey
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import at_angles
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Floats, Motion, evenly
from plans.scene.scene import Meaning, TechniqueForm
from plans.scene.tables import key, table
from plans.transfer.turned import TRANSFER, TurnedPlan, turned

STEPS = 720  # of a graph over a turn: half a degree, less than the width of a line on any sheet


class TransferForm(TechniqueForm):
    """What a scene says of the transfer functions of its linkage."""

    transfer: ChosenTable = key(
        table(ChosenTable),
        ChosenTable(),
        meaning="Transfer functions u, u', S', S'' (передаточные функции), off the velocity plan turned by a quarter.",
    )


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """See that a crank turns, by whose angle all is derived, and that the positions are there."""
    survey = see_positions(meaning, TRANSFER, meaning.scene.of(TransferForm).transfer.positions)
    if survey.form.drive.stroke is not None:
        survey.report(("drive", "stroke"), "no_crank")
    return survey


class TransferFunctions:
    """The transfer function of a link that turns or of a slide on the frame, and its derivative."""

    def __init__(self, mechanism: Mechanism, of: int | Slide) -> None:
        self.of, self.unit, crank = of, "" if isinstance(of, int) else "m", mechanism.drive.link
        if isinstance(of, int):
            letter = f"u_{of}{crank}" if max(of, crank) < 10 else f"u_{of},{crank}"
            self.names = letter, f"{letter}'"
        else:
            self.names = f"S_{of.point}'", f"S_{of.point}''"

    def rows(self, motion: Motion) -> tuple[Floats, Floats]:
        """Read both off a motion at 1 rad/s, (N,) each."""
        if isinstance(self.of, int):
            return motion.links[self.of].omega, motion.links[self.of].epsilon
        along = np.conj(self.of.way(FRAME).direction)
        first, second = ((row * along).real for row in motion.points[self.of.point][1:])
        return first, second

    def read(self, plan: TurnedPlan) -> Any:
        """Read the first off the turned plan: a segment over its link, both parallel, or as it is turned back."""
        start, end = self.shown(plan)
        if isinstance(self.of, int):
            with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
                return np.real(end.point / start.point)
        return np.real(1j * end.point * np.conj(self.of.way(FRAME).direction))

    def shown(self, plan: TurnedPlan) -> Reading | Span:
        """Give what of the turned plan shows the first."""
        return plan.readings[self.of] if isinstance(self.of, int) else Span(plan.pole, plan.images[self.of.point])


def functions(mechanism: Mechanism) -> list[TransferFunctions]:
    """List what is told of a mechanism: its links that turn, of those that turn alike one, then its slides."""
    fixed, least = mechanism.links[FRAME].points, mechanism.turning_with
    alike: dict[int, list[int]] = {}
    for link in sorted(least, key=lambda n: (not mechanism.links[n].points.keys() & fixed, n)):  # hinged ones first
        alike.setdefault(least[link], []).append(link)
    turning = sorted(links[0] for first, links in alike.items() if first not in (FRAME, least[mechanism.drive.link]))
    told: list[int | Slide] = [*turning, *(slide for slide in mechanism.slides if FRAME in (slide.owner, slide.slider))]
    return [TransferFunctions(mechanism, of) for of in told]


def output_functions(study: TransferStudy) -> TransferFunctions | None:
    """Give the transfer functions of the output, which are drawn over the turn; None of one that has none."""
    link, mechanism = study.linkage.output.link, study.linkage.mechanism
    found, least = functions(mechanism), mechanism.turning_with
    sliding = (of for of in found if isinstance(of.of, Slide) and link in (of.of.slider, of.of.owner))
    turning = (of for of in found if isinstance(of.of, int) and least[of.of] == least[link])
    return next(sliding, next(turning, None))


class TransferStudy:
    """The transfer functions of a linkage by construction."""

    def __init__(self, linkage: LinkageStudy) -> None:
        self.linkage, self.unit = linkage, linkage.paced(evenly)
        self.made: dict[str, None] = {}

    def construct(self, plans: Collection[str]) -> None:
        """Draw the turned plan, if it is asked for."""
        if TRANSFER in plans:
            _ = self.turned

    @cached_property
    def turned(self) -> TurnedPlan:
        """The turned velocity plan in all positions."""
        self.made.setdefault(TRANSFER)
        return turned(self.unit.drafts().velocities)

    def around(self) -> Motion:
        """Read the course of all points and links over a turn off their plans; NaN where the crank cannot come."""
        study, turned = self.unit, np.arange(STEPS + 1) * 2 * np.pi / STEPS
        drafts = Drafts(study, at_angles(study.turn.phi[0] + study.sense * turned).paced(evenly))
        found, gone = drafts.motion(2).own(), drafts.lost | drafts.unborne
        for row in found.rows():
            row[gone] = np.nan
        return found
