"""The textbook's machines balanced by construction: main points, counterweights, the mass centre (M7.4-M7.7; 8.2)."""

from __future__ import annotations

import numpy as np
import pytest

from plans.balance.study import BalanceStudy
from plans.model.balance.linkage import FULL, PARTIAL, Place, Task
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, asked, study

DIGITS = 5e-10  # of values that are printed with ten digits
VARIANT_A = asked(FULL, Place(1, mass=9), Place(2, mass=6))
VARIANT_B = asked(FULL, Place(1, mass=5), Place(3, mass=8))
ENGINE_FULL = asked(FULL, Place(1, mass=28), Place(2, mass=16))
SHAPER_FULL = asked(FULL, Place(1, mass=6), Place(3, mass=160), Place(4, mass=30))


def moments(its: BalanceStudy) -> dict[int, complex]:
    """Give by link the static moment kg*m of link and counterweight about the point that it counts from."""
    bodies, links = its.loaded.bodies, its.linkage.mechanism.links
    found = {}
    for one in its.counterweights:
        body = bodies[one.link]
        found[one.link] = body.mass * (body.centre - links[one.link].points[one.begin])
    return found


def test_main_points_of_the_four_bar() -> None:
    its = study(FOUR_BAR)
    assert [its.points().vectors[link].real for link in (1, 2, 3)] == pytest.approx(
        [0.08909090909, 0.2472727273, 0.05454545455], rel=DIGITS
    )
    centre = its.before.centre
    assert centre.r[0] == pytest.approx(0.2474528462 + 0.1533593396j, rel=DIGITS)
    assert centre.a[0] == pytest.approx(-6.266385528 - 2.252402396j, rel=DIGITS)
    assert centre.force[0] == pytest.approx(68.9302408 + 24.77642635j, rel=DIGITS)


def test_main_points_of_the_six_link() -> None:
    its = study(SIX_LINK)
    vectors = its.points().vectors
    told = [0.09368421053, 0.3115789474, 0.1157894737, 0.1263157895, 0.006315789474]
    assert [vectors[link].real for link in range(1, 6)] == pytest.approx(told, rel=DIGITS)
    assert its.before.centre.r[0] == pytest.approx(0.4288752518 + 0.130838553j, rel=DIGITS)


def test_four_bar_with_counterweights_on_crank_and_coupler() -> None:
    its = study(FOUR_BAR, VARIANT_A)
    found = {one.link: one for one in its.counterweights}
    assert moments(its) == pytest.approx({1: -1.3, 2: -1.2}, rel=DIGITS)
    assert found[2].centre == pytest.approx(-0.32, rel=DIGITS)
    assert found[1].centre == pytest.approx(-0.1533333333, rel=DIGITS)
    assert its.loaded.bodies[2].centre == pytest.approx(-0.12, rel=DIGITS)
    assert its.after is not None
    assert its.after.centre.r == pytest.approx(0.02692307692, rel=DIGITS)


def test_four_bar_with_counterweights_on_crank_and_rocker() -> None:
    its = study(FOUR_BAR, VARIANT_B)
    found = {one.link: one for one in its.counterweights}
    assert found[3].begin == "C"
    assert found[3].centre == pytest.approx(0.48, rel=DIGITS)
    assert its.loaded.bodies[3].mass * its.loaded.bodies[3].centre == pytest.approx(4.44, rel=DIGITS)
    assert moments(its)[1] == pytest.approx(-0.22, rel=DIGITS)
    assert found[1].centre == pytest.approx(-0.06, rel=DIGITS)
    assert its.after is not None
    assert its.after.centre.r == pytest.approx(0.2158333333, rel=DIGITS)


def test_slider_crank_balanced_in_part() -> None:
    its = study(ENGINE, asked(PARTIAL, Place(1, mass=2)))
    (one,) = its.counterweights
    assert moments(its) == pytest.approx({1: -0.25}, rel=DIGITS)
    assert one.centre == pytest.approx(-0.185, rel=DIGITS)
    assert its.after is not None
    b = its.linkage.motion(0).points["B"].r
    assert its.after.centre.r == pytest.approx(0.5588235294 * b, rel=DIGITS, abs=1e-16)
    assert its.left == pytest.approx({"B": 0.5588235294 * 17}, rel=DIGITS)
    assert its.after.shaking == pytest.approx(475, rel=DIGITS)


def test_slider_crank_balanced_in_part_by_the_rod() -> None:
    """The one counterweight of (8.9) may stand on AB as well: h1/OA = h2/AB with its mass behind the pin."""
    its = study(ENGINE, asked(PARTIAL, Place(2, mass=10)))
    kappa = (3 * 0.04 / 0.1 + 4 + 10 + 8) / 25  # h1/OA, where the counterweight's place does not enter
    assert moments(its) == pytest.approx({2: kappa * 25 * 0.4 - 8 * 0.4}, rel=DIGITS)
    assert its.after is not None
    assert its.after.centre.r == pytest.approx(kappa * its.linkage.motion(0).points["B"].r, rel=DIGITS, abs=1e-16)
    assert its.left == pytest.approx({"B": kappa * 25}, rel=DIGITS)


def test_slider_crank_balanced_in_full() -> None:
    its = study(ENGINE, ENGINE_FULL)
    assert [one.centre for one in its.counterweights] == pytest.approx([-0.1042857143, -0.2375], rel=DIGITS)
    assert its.left == {}


def test_slotted_link_balanced_in_parts_and_in_full() -> None:
    alone = SHAPER.partition("4 = {{ mass")[0]  # link 3 without what it drives
    its = study(alone, asked(FULL, Place(1, mass=6), Place(3, mass=160)))
    assert [one.centre for one in its.counterweights] == pytest.approx([-0.06333333333, -0.0225], rel=DIGITS)
    whole = study(SHAPER, SHAPER_FULL)
    told = [-0.06333333333, -0.254375, -0.1433333333]
    assert [one.centre for one in whole.counterweights] == pytest.approx(told, rel=DIGITS)
    assert whole.after is not None
    assert whole.after.centre.r == pytest.approx(-0.3329809725j, rel=DIGITS)


@pytest.mark.parametrize(
    ("text", "task", "longest"),
    [
        (FOUR_BAR, VARIANT_A, 0.4),
        (FOUR_BAR, VARIANT_B, 0.4),
        (ENGINE, ENGINE_FULL, 0.4),
        (SHAPER, SHAPER_FULL, 0.7),
    ],
)
def test_balanced_mass_centre_rests(text: str, task: Task, longest: float) -> None:
    its = study(text, task, positions=3600)
    assert its.after is not None
    r = its.after.centre.r
    assert float(np.abs(r - r[0]).max()) < 1e-14 * longest
