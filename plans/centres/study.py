"""The instant centres of a linkage in its positions, and the rates that they give (мгновенные центры)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import NamedTuple

import numpy as np

from geometry.board import Mark, Reading, at
from geometry.meet import cross
from plans.centres.centrodes import Centrodes, carried, centrodes, own
from plans.centres.curvature import Curvature, Inflection, general, pins
from plans.centres.kennedy import CENTRES, InstantCentre, Kennedy, Pair, hinge_of, letter
from plans.linkage.reading import fields as g
from plans.linkage.reading.form import ChosenTable
from plans.linkage.reading.linkage import see_positions
from plans.linkage.reading.survey import LinkageSurvey
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Mechanism
from plans.scene import fields as f
from plans.scene.faults import Path
from plans.scene.readers import many
from plans.scene.scene import Meaning, TechniqueForm
from plans.scene.tables import key, table
from plans.words.words import because


class CentresTable(ChosenTable):
    """What is asked for of instant centres."""

    centrodes: tuple[str, ...] = key(
        many(g.PAIR, f.NO_REPEATS, first=f.FEW),
        (),
        meaning='Pairs of links whose centrodes are drawn (центроиды): ["0-2"], paths of P_02 on both over the turn.',
    )
    curvature: tuple[str, ...] = key(
        many(f.POINT, f.NO_REPEATS, first=f.FEW),
        (),
        meaning='Points ["K"] of links in general motion: inflection circle, centre of curvature by Bobillier.',
    )

    @property
    def rolling(self) -> tuple[Pair, ...]:
        """The pairs whose centrodes are asked for."""
        both = (pair.split("-") for pair in self.centrodes)
        return tuple((int(one), int(two)) for one, two in both)


class CentresForm(TechniqueForm):
    """What a scene says of the instant centres of its linkage."""

    centres: CentresTable = key(
        table(CentresTable),
        CentresTable(),
        meaning="Instant centres of all links (мгновенные центры), by Aronhold and Kennedy.",
    )


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """See that the positions are there, and that the links whose centrodes are asked for roll on each other."""
    asked = meaning.scene.of(CentresForm).centres
    survey = see_positions(meaning, CENTRES, asked.positions)
    mechanism = meaning.of(LinkageSurvey).mechanism
    for index, pair in enumerate(asked.rolling):
        if mechanism is not None:
            _see_rolling(survey, (CENTRES, "centrodes", index), pair, mechanism)
    for index, point in enumerate(asked.curvature):
        if mechanism is not None and survey.know((CENTRES, "curvature", index), [point]):
            _see_curving(survey, (CENTRES, "curvature", index), point, mechanism)
    return survey


def _see_curving(survey: LinkageSurvey, path: Path, point: str, mechanism: Mechanism) -> None:
    """See that a point's link moves generally, by two pins whose centres of curvature are known."""
    links = [link for link in mechanism.links if point in mechanism.links[link].points]
    pivots = (hinge for link in links if link != FRAME and (hinge := hinge_of(mechanism, (FRAME, link))))
    link = general(mechanism, point)
    if not links:
        return  # its own row is at fault
    if FRAME in links:
        survey.report(path, "curvature_fixed", point=point)
    elif (pivot := next(pivots, None)) is not None:
        survey.report(path, "curvature_pivot", point=point, pivot=pivot)
    elif link is None:
        survey.report(path, "curvature_straight", point=point)
    elif len(pins(mechanism, link)) < 2:
        survey.report(path, "curvature_pins", point=point, link=link)


def _see_rolling(survey: LinkageSurvey, path: Path, pair: Pair, mechanism: Mechanism) -> None:
    first, second = pair
    if not all(survey.know_link(path, link) for link in pair if link != FRAME):
        return
    if (hinge := hinge_of(mechanism, pair)) is not None:
        survey.report(path, "centrode_hinge", first=first, second=second, hinge=hinge)
    elif mechanism.turning_with[first] == mechanism.turning_with[second]:
        survey.report(path, "centrode_translates", first=first, second=second)


class CentreRate(NamedTuple):
    """How a link turns by its centres with the frame and with another: what it is read from; None: it does not turn."""

    value: float  # rad/s
    read: Reading | None = None


class CentresStudy:
    """The instant centres of a linkage by construction, each position drawn on a board of its own."""

    def __init__(self, linkage: LinkageStudy) -> None:
        self.linkage = linkage
        self.made: dict[str, None] = {}
        self._found: dict[int, Kennedy] = {}
        self._inflections: dict[tuple[int, int], Inflection | None] = {}
        self._centres: dict[tuple[int, str], Curvature | None] = {}

    def construct(self, plans: Collection[str]) -> None:
        """Find the centres, if they are asked for."""
        if CENTRES in plans:
            _ = self.whole

    @cached_property
    def whole(self) -> list[int]:
        """The positions that have velocities: the centres of all of them are found."""
        self.made.setdefault(CENTRES)
        motion, link = self.linkage.motion(1), self.linkage.output.link
        return [k for k in np.flatnonzero(~np.isnan(motion.links[link].omega)).tolist() if self.at(k)]

    def at(self, k: int) -> Kennedy:
        """Give the centres of a position."""
        if k not in self._found:
            self._found[k] = Kennedy(self.linkage.drafts((k,)).positions)
        return self._found[k]

    def carried(self, k: int, pair: Pair, link: int) -> Mark:
        """Give a centre of a position in the axes of a link; once carried it is used again."""
        found = self.at(k)
        name = own(letter(pair), link)
        if link != FRAME and name in found.board:
            return found.board[name]
        return carried(found.board, found.plan, found.found[pair].mark, link)

    @cached_property
    def centrodes(self) -> dict[Pair, Centrodes]:
        """The centrodes that are asked for."""
        asked = self.linkage.scene.of(CentresForm).centres.rolling
        return centrodes(self.linkage, asked) if asked else {}

    @property
    def curving(self) -> dict[str, int]:
        """The points whose centres of curvature are asked for, with their links."""
        asked = self.linkage.scene.of(CentresForm).centres.curvature
        return {point: link for point in asked if (link := general(self.linkage.mechanism, point)) is not None}

    def inflection(self, k: int, link: int) -> Inflection | None:
        """Give the inflection circle of a link in a position; None where Bobillier's rays give none."""
        if (k, link) not in self._inflections:
            self._inflections[k, link] = Inflection.of(self.at(k), link)
        return self._inflections[k, link]

    def curvature(self, k: int, point: str) -> Curvature | None:
        """Give the centre of curvature of a point's path in a position, and the radius to it."""
        if (k, point) not in self._centres:
            circle = self.inflection(k, self.curving[point])
            self._centres[k, point] = None if circle is None else circle.centre(point)
        return self._centres[k, point]

    def rates(self, k: int) -> dict[int, CentreRate]:
        """Find how each link turns in a position: from link to link, over the centres that lie farthest apart."""
        found, drive = self.at(k), self.linkage.mechanism.drive
        omega = self.linkage.rates.at(k)[0]
        known = {drive.link: CentreRate(0.0 if drive.pushed else omega)}
        for link in (n for n in sorted(self.linkage.mechanism.links) if n not in (FRAME, drive.link)):
            own = found.of(FRAME, link)
            if own is None or own.infinite:
                known |= {} if own is None else {link: CentreRate(0.0)}
                continue
            others = {n: both for n in known if (both := found.of(n, link)) is not None}
            arms = {n: abs(both.place - own.place) for n, both in others.items() if self._moves(found, n, both)}
            best = max(arms, key=lambda n: arms[n], default=None)
            alike = next((n for n, both in others.items() if both.infinite), None)
            if best is not None and arms[best] > 0:
                known[link] = self._turned(found, best, link, (known[best].value, omega))
            elif alike is not None:  # all that they have in common lies at infinity: it turns as the other does
                known[link] = known[alike]
        return known

    def _moves(self, found: Kennedy, link: int, both: InstantCentre) -> bool:
        """Tell whether the velocity of a link at a centre is known by its own centre, or by the drive."""
        drive, own = self.linkage.mechanism.drive, found.of(FRAME, link)
        return not both.infinite and own is not None and (not own.infinite or (drive.pushed and link == drive.link))

    def _turned(self, found: Kennedy, other: int, link: int, rates: tuple[float, float]) -> CentreRate:
        """Read a link's rate off the velocity of a centre in common with another, by that one's rate or the drive's."""
        board, own, base, both = found.board, found.of(FRAME, link), found.of(FRAME, other), found.of(other, link)
        assert own is not None and both is not None and base is not None  # they were looked for
        (omega, drive), guide = rates, self.linkage.mechanism.drive.guide
        arm = board.join(f"{own.mark.name}{both.mark.name}", own.mark, both.mark)
        if base.infinite and guide is not None:
            way = self.linkage.mechanism.drive.unit * drive * guide.way(FRAME).direction
            speed = board.given(f"v_{both.mark.name}", way, because("centre_slides", link=other))
        else:
            radius = board.join(f"{base.mark.name}{both.mark.name}", base.mark, both.mark)
            speed = board.turn(f"v_{both.mark.name}", radius, 1j * omega, because("centre_turns", link=other))
        reach = at(arm.point, 0)
        return CentreRate(float(cross(reach, at(speed.point, 0))) / abs(reach) ** 2, Reading(arm, speed))
