"""The judge is judged: closed forms, difference quotients in 60 digits, and data that are changed."""

from __future__ import annotations

import pytest

from plans.analytic.kinematics import Analysis
from plans.model.mechanism import Mechanism, Output
from plans.model.motion import Motion, PointMotion
from tests.parts import first
from tests.plans.linkages import four_bar, shaper, slider_crank
from tests.plans.studies import study_of
from tests.trials.judge import EPS, MP, Case, Lost, Series, answers, case, guess, roundings, solved
from tests.trials.judgement import BORNE, judged
from tests.trials.rests import off
from tests.trials.trial import KINDS

PHI = 40.0  # degrees
ALMOST = MP.mpf(10) ** -45
NUDGE = 2.0**-20


def posed(mechanism: Mechanism, phi: object = None) -> tuple[Case, list[complex]]:
    """Set a mechanism before the judge at a crank angle, rad (that of PHI), with the analysis's guess."""
    turned = MP.radians(PHI) if phi is None else phi
    own = case(mechanism, MP.expj(turned), float(turned))
    return own, guess(own, study_of(mechanism, PHI, 1).motion(0), mechanism, 0)


def told(own: Case, q: list[Series]) -> dict[tuple[str, str], object]:
    return answers(own, [MP.mpc(z) for z in own.data], q)


def test_a_slider_crank_is_where_its_closed_form_says():
    a, b, e, omega, epsilon = 0.1, 0.35, 0.02, 10.0, 5.0
    own, near = posed(slider_crank(a, b, e, omega=omega, epsilon=epsilon))

    def place(t: object) -> object:
        phi = MP.radians(PHI) + omega * t + MP.mpf(epsilon) / 2 * t**2
        return a * MP.cos(phi) + MP.sqrt(MP.mpf(b) ** 2 - (a * MP.sin(phi) - MP.mpf(e)) ** 2)

    found = told(own, solved(own, near))
    assert abs(found["r", "B"] - MP.mpc(place(MP.mpf(0)), e)) < ALMOST
    with MP.workdps(100):
        rates = [MP.diff(place, 0, order) for order in (1, 2)]
    assert abs(found["v", "B"] - rates[0]) < ALMOST and abs(found["a", "B"] - rates[1]) < ALMOST


def test_rates_are_difference_quotients_of_places():
    h = MP.mpf(10) ** -10
    own, near = posed(shaper(omega=1.0, epsilon=0.0))
    turned = [own._replace(e=own.e * MP.expj(step)) for step in (0, h, -h)]
    here, ahead, behind = (told(each, solved(each, near)) for each in turned)
    for point in "ABD":
        r = [at["r", point] for at in (behind, here, ahead)]
        assert abs((r[2] - r[0]) / (2 * h) - here["v", point]) < 1e3 * h**2, point
        assert abs((r[2] - 2 * r[1] + r[0]) / h**2 - here["a", point]) < 1e3 * h**2, point
    for link in "345":
        turning = MP.im((ahead["angle", link] - behind["angle", link]) / (2 * h) / here["angle", link])
        assert abs(turning - here["omega", link]) < 1e3 * h**2, link
        gained = (ahead["omega", link] - behind["omega", link]) / (2 * h)
        assert abs(gained - here["epsilon", link]) < 1e3 * h**2, link


@pytest.mark.rest
def test_one_rounding_of_the_data_is_what_changed_data_do():
    mechanism = shaper()
    own, near = posed(mechanism)
    here, one = told(own, solved(own, near)), roundings(own, solved(own, near))
    summed = dict.fromkeys(here, MP.mpf(0))
    for k, number in enumerate(own.data):
        for part in (number.real, 1j * number.imag):
            data = [*own.data[:k], number + NUDGE * part, *own.data[k + 1 :]]
            turned = NUDGE * part.real if k == own.drive[0] else 0.0
            changed = own._replace(data=data, e=own.e * MP.expj(turned))
            for key, value in told(changed, solved(changed, near, 1e-3)).items() if part else ():
                summed[key] += abs(value - here[key]) / NUDGE * EPS
    for key in (("r", "D"), ("v", "D"), ("a", "D"), ("angle", "3"), ("omega", "3"), ("epsilon", "3")):
        assert float(summed[key]) + EPS * float(abs(here[key])) == pytest.approx(one[key], rel=1e-3), key


def test_another_assembly_is_no_truth_of_this_one():
    own, near = posed(slider_crank(0.1, 0.35))
    with pytest.raises(Lost):
        solved(own, [z + 1e-4 for z in near])


@pytest.mark.parametrize("kind", first(KINDS))
def test_both_roads_are_right_to_some_roundings(kind):
    verdict = judged(kind, 50)
    assert {one.road for one in verdict} == {"construction", "analysis"}
    assert [one for one in verdict if not one.roundings <= BORNE] == []


def test_a_road_that_is_wrong_in_the_last_digits_is_told(monkeypatch):
    motion = Analysis.motion

    def spoilt(self: Analysis, phi: object, order: int = 2) -> Motion:
        found = motion(self, phi, order)
        b = found.points["B"]
        return found._replace(points={**found.points, "B": PointMotion((b.r, b.v * (1 + 100 * EPS), b.a))})

    monkeypatch.setattr(Analysis, "motion", spoilt)
    wrong = [one for one in judged("crank-rockers", 1) if not one.roundings <= BORNE]
    assert wrong and {(one.road, one.key, one.name) for one in wrong} == {("analysis", "v", "B")}


def test_the_extreme_of_a_slider_crank_is_crank_and_rod_in_one_line():
    a, b, e = 0.1, 0.35, 0.02
    mechanism = slider_crank(a, b, e)
    stretched, folded = float(MP.asin(MP.mpf(e) / (a + b))), float(MP.pi + MP.asin(MP.mpf(e) / (b - a)))
    for phi in (stretched, folded):
        assert off(mechanism, Output(3, "B"), phi) <= 1.0
        assert off(mechanism, Output(3, "B"), phi + 1e-12) > BORNE


def test_the_extreme_of_a_rocker_is_judged_by_its_turning():
    a, b, c, d = 0.1, 0.4, 0.3, 0.35
    mechanism = four_bar(a, b, c, d, sketch={"B": complex(d, c)})
    rod = MP.mpf(a) + MP.mpf(b)
    stretched = float(MP.acos((MP.mpf(d) ** 2 + rod**2 - MP.mpf(c) ** 2) / (2 * MP.mpf(d) * rod)))
    assert off(mechanism, Output(3, None), stretched) <= 1.0
    assert off(mechanism, Output(3, None), stretched + 1e-12) > BORNE
