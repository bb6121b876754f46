"""Points may have any letters: none is taken for a pole, for the end of a part, or for another point (буквы планов)."""

from __future__ import annotations

import string
from pathlib import Path

import numpy as np
import pytest

from drawings.forces.lever import hanging
from drawings.linkage.coriolis import QuarterTurn, quarter_turn
from drawings.linkage.vector_plan import diagram
from plans.analytic.kinematics import solve
from plans.forces.quantities import compare_forces
from plans.linkage.parts import AnalysedVectors
from plans.linkage.plan import PlanLetters
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.machine import Body
from plans.model.mechanism import Mechanism
from plans.scene.scene import parse_scene
from tests import parts
from tests.parts import several
from tests.plans import linkages
from tests.plans.alterations import renamed
from tests.plans.loaded import Loaded
from tests.plans.machines import machine

SIGNED = (
    "P'", "P''", "A3", "A'", "B1", "B2", "K2", "N3", "S2", "S3", "O1", "p", "p'", "π", "a", "n_B", "k_A", "Π", "Р",
)  # fmt: skip
NAMES = (*string.ascii_uppercase, *SIGNED)
MECHANISMS = {
    "slider-crank": linkages.slider_crank(0.06, 0.2, 0.02),
    "slotted lever": linkages.slotted_link(0.12, 0.35, 0.7),
}
POINTS = [
    (name, point) for name, points in {"slider-crank": "OAB", "slotted lever": "OCAB"}.items() for point in points
]


def called(mechanism: Mechanism, point: str, name: str) -> Loaded:
    """Give one point another name, and the links masses; a point that has that name takes the old one."""
    names = {one: one for link in mechanism.links.values() for one in link.points}
    other = {**names, **({name: point} if name in names else {}), point: name}
    bodies = {link: Body(link, 2.0, 0.01, 0.05 + 0.01j) for link in mechanism.links if link}
    return Loaded(renamed(mechanism, other, {link: link for link in mechanism.links}), machine(bodies), 40.0)


def wrong(one: Loaded) -> list[str]:
    """Name what the two roads, or the arrows by analysis, do not agree in, and what is lettered twice."""
    statics = one.statics
    comparison = compare_forces(statics, compare(one.study))
    findings = (*comparison.motion.findings, *comparison.findings)
    found = [finding.name for finding in findings if not (finding.excess <= 1).all()]
    drafts, plans = one.study.drafts(), statics.drafts().plans
    expected = AnalysedVectors(one.mechanism, comparison.motion.analysis, 0, drafts.velocities.written)
    arrows = expected.arrows(one.study.groups)
    for plan in (drafts.velocities, drafts.accelerations):
        drawn = diagram(plan, 0).arrows
        found += twice([arrow.name for arrow in drawn])
        for arrow in drawn:
            true = arrows.get((plan.board.subject, arrow.start.name, arrow.end.name))
            shown = arrow.ends[1] - arrow.ends[0]
            if true is not None and abs(shown - true) > 1e-9 * max(abs(value) for value in arrows.values()):
                found.append(arrow.name)
    assert plans.lever is not None
    images = [name for name, _, _ in hanging(plans.plan, plans.lever, 0).images]
    return found + twice([plans.lever.pole.name, *images])


def twice(names: list[str]) -> list[str]:
    return [name for name in dict.fromkeys(names) if names.count(name) > 1]


@pytest.mark.part
@pytest.mark.parametrize(("mechanism", "point"), several(POINTS, 4))
def test_any_letter_may_name_a_point(mechanism: str, point: str) -> None:
    seen = {name: wrong(called(MECHANISMS[mechanism], point, name)) for name in NAMES[:: 1 if parts.whole else 40]}
    assert {name: found for name, found in seen.items() if found} == {}


def test_a_point_named_as_the_pole_has_a_primed_letter() -> None:
    letters = PlanLetters(called(MECHANISMS["slider-crank"], "B", "P").mechanism)
    assert (letters.small("P"), letters.under("P", 3), letters.small("A")) == ("p'", "p'3", "a")


def test_no_two_points_share_a_letter() -> None:
    points = dict.fromkeys(("P", "P'", "p", "B", "b", "Π", "A3"), 0j)
    letters = PlanLetters(linkages.mechanism("", {0: points}, (), linkages.shaper().drive, {}, None))
    small = {point: letters.small(point) for point in (*points, "S2")}
    assert (small["b"], small["p"], small["A3"]) == ("b", "p'", "a3")
    assert len({*small.values(), "p", "π"}) == len(small) + 2


def test_two_coriolis_parts_of_a_pin_over_one_link_have_letters_of_their_own() -> None:
    letters = PlanLetters(linkages.shaper())
    for pair in ((2, 3), (5, 4), (3, 4)):
        letters.slides(pair, "A", 3 if 3 in pair else 4)
    assert [letters.coriolis("A", 3, pair) for pair in ((2, 3), (3, 4))] == ["k_A3", "k_A3'"]


SHAPER = Path(__file__).parents[2] / "drawings/gallery/shaper.toml"


def shaper(speed: str) -> LinkageStudy:
    text = SHAPER.read_text("utf-8")
    (given,) = (line for line in text.splitlines() if line.startswith("speed"))
    return LinkageStudy(parse_scene(text.replace(given, f'speed = "{speed}"')))


def rules(study: LinkageStudy, k: int) -> list[QuarterTurn]:
    marks = study.drafts().accelerations.board
    return [found for mark in marks if (found := quarter_turn(mark, k)) is not None]


@pytest.mark.parametrize("speed", ["10 rad/s", "-10 rad/s"])
def test_the_rule_shows_the_slip_and_the_acceleration_that_the_analysis_gives(speed: str) -> None:
    """Both senses of the crank, the slotted link going and coming: all four sign cases of omega and of the slip."""
    study = shaper(speed)
    motion = solve(study.mechanism, study.turn.phi, first=False)
    pin, pivot, omega = motion.points["A"], motion.points["C"], motion.links[3].omega
    assert pin.v is not None and pivot.v is not None and omega is not None
    under = pivot.v + 1j * omega * (pin.r - pivot.r)  # the velocity of the point of link 3 under the pin
    cases = set()
    for k in range(len(study.turn)):
        slip = under[k] - pin.v[k]
        along = (np.conj(pin.r[k] - pivot.r[k]) * slip).real
        for shown in rules(study, k):
            if shown.size < 1e-9:  # m/s2: the slot stands still, and the sheet shows nothing
                continue
            assert abs(shown.slip - slip / abs(slip)) < 1e-9
            acceleration = 2j * omega[k] * slip
            assert abs(shown.result - acceleration / abs(acceleration)) < 1e-9
            cases.add((omega[k] > 0, along > 0))
    assert len(cases) == 4
