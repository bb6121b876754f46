"""Instant centres: three of three links in one line, one velocity in each; by them the rates of the plans (M3.2)."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from geometry.meet import EPS, cross
from plans.centres.centrodes import named
from plans.centres.curvature import circle_of
from plans.centres.kennedy import Kennedy
from plans.centres.quantities import CentresComparison, SolvedCentrodes
from plans.centres.study import CentresStudy
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.scenes import scene
from tests.plans.test_transfer import FOUR_BAR, SINE, SIX_LINK, SLIDER_CRANK, SLOTTED, TANGENT, study_of

RAM = {
    "frame": "O = [0, 0]; C = [0.3, 0.1]", "links": "OA AB B", "lengths": "OA = 0.1; AB = 0.3",
    "slides": ["link = 3; along = { through = [0, 0], angle = 0 }"], "sketch": "A = [0.05, 0.09]",
}  # fmt: skip
MECHANISMS = {
    "four-bar": FOUR_BAR, "slider-crank": SLIDER_CRANK, "slotted link": SLOTTED, "sine": SINE, "tangent": TANGENT,
    "six-link": SIX_LINK,
}  # fmt: skip
ANGLES = (17.0, 29.3, 41.0)


def drawn(mechanism: dict[str, str | list[str]], drive: str, centres: str = "") -> Study:
    return Study(parse_scene(scene('sheets = ["centres"]', **mechanism, drive=drive, centres=centres)))


def asked(name: str) -> Study:
    return study_of(MECHANISMS[name], *ANGLES, head='sheets = ["centres"]')


def test_the_centre_of_a_rod_lies_where_it_was_worked():
    found = study_of(FOUR_BAR, 60, head='sheets = ["centres"]').of(CentresStudy).at(0)
    assert found.found[0, 2].place == pytest.approx(0.4563219069 + 0.7903727274j, rel=1e-9)


@pytest.mark.parametrize("name", MECHANISMS)
def test_both_roads_find_all_centres_and_the_rates_by_them_are_those_of_the_plans(name):
    study = asked(name)
    compared, linkage = study.of(CentresComparison), study.of(CentresStudy).linkage
    assert compared.agrees
    links = len(linkage.mechanism.links)
    assert len(study.of(CentresStudy).at(0).found) == links * (links - 1) / 2
    plans = {row.name: row for row in compared.plans.findings}
    kappa = max(1 / sharpness for k in range(len(ANGLES)) for sharpness in sharpnesses(study.of(CentresStudy).at(k)))
    for row in compared.findings:
        if row.unit == "rad/s":
            off = np.abs(row.construction - plans[row.name].construction)
            assert off.max() <= 8 * EPS * kappa * plans[row.name].largest, row.name


def sharpnesses(found: Kennedy) -> list[float]:
    return [
        float(np.ravel(mark.sharpness)[0]) for mark in (*found.board, *found.plan.board) if mark.sharpness is not None
    ]


@pytest.mark.parametrize("name", MECHANISMS)
def test_three_links_have_their_centres_in_one_line(name):
    found = asked(name).of(CentresStudy).at(1)
    for three in combinations(sorted(found.plan.mechanism.links), 3):
        centres = [found.found[pair] for pair in combinations(three, 2)]
        places = [one.place for one in centres if not one.infinite]
        ways = [one.place for one in centres if one.infinite] if len(places) > 1 else []
        ways += [place - places[0] for place in places[1:] if abs(place - places[0]) > 1e-9]
        assert all(abs(cross(one, two)) < 1e-12 * abs(one) * abs(two) for one, two in combinations(ways, 2)), three


@pytest.mark.parametrize("name", MECHANISMS)
def test_each_centre_has_one_velocity_on_both_of_its_links(name):
    study = asked(name)
    linkage, motion = study.of(CentresStudy).linkage, study.of(CentresComparison).plans.construction

    def velocity(link: int, place: complex) -> complex:
        point = next(iter(linkage.mechanism.links[link].points))
        omega = motion.links[link].omega[1] if link else 0.0
        return complex(motion.points[point].v[1] + 1j * omega * (place - motion.points[point].r[1]))

    for (one, two), centre in study.of(CentresStudy).at(1).found.items():
        if centre.infinite:
            assert motion.links[two].omega[1] == pytest.approx(motion.links[one].omega[1] if one else 0.0, abs=1e-12)
        else:
            assert velocity(one, centre.place) == pytest.approx(velocity(two, centre.place), abs=1e-12)


def test_a_slide_that_drives_gives_the_rates_too():
    stroke = "link = 3; stroke = { from = 0.25, to = 0.35, speed = 0.2 }; positions = 4"
    compared = drawn(RAM, stroke).of(CentresComparison)
    assert compared.agrees and {"ω_1", "ω_2"} <= {
        row.name for row in compared.findings if np.abs(row.construction).max() > 0
    }


def test_what_lies_on_one_line_alone_is_left_open():
    """A crank in line with its rod: P_02 may be anywhere on that line for all that its centres tell."""
    flat = SLIDER_CRANK | {"slides": ["link = 3; along = { through = [0, 0], angle = 0 }"], "sketch": "B = [0.26, 0]"}
    found = study_of(flat, 0, 40, head='sheets = ["centres"]').of(CentresStudy)
    assert found.at(0).found[0, 2].place == pytest.approx(0.26)
    assert found.at(0).found[1, 3].place == pytest.approx(0.0)


def test_a_drive_that_rests_has_its_centres_too_and_no_rates():
    compared = drawn(FOUR_BAR, "link = 1; speed = 0; acceleration = 2; positions = [30, 70]").of(CentresComparison)
    assert compared.agrees
    assert all(np.abs(one.analysis).max() == 0 for one in compared.findings if one.unit == "rad/s")
    assert np.isfinite(next(one for one in compared.findings if one.name == "P_02").analysis).all()


ASKED = 'centrodes = ["0-2"]'
CARDAN = SLIDER_CRANK | {
    "lengths": "OA = 0.2; AB = 0.2",
    "slides": ["link = 3; along = { through = [0, 0], angle = 0 }"],
    "sketch": "B = [0.3, 0]",
}
CROSSED = FOUR_BAR | {"frame": "O = [0, 0]; C = [0.2, 0]", "lengths": "OA = 0.3; AB = 0.2; CB = 0.3"}
CROSSED |= {"sketch": "A = [0.15, 0.26]; B = [-0.04, 0.19]"}


def rolling(mechanism: dict[str, str | list[str]], asked: str = ASKED, first: float = 60.0) -> Study:
    return drawn(mechanism, f"link = 1; speed = -7; positions = [{first}, {first + 10}]", asked)


def paths(study: Study) -> list[np.ndarray]:
    [(pair, made)] = study.of(CentresStudy).centrodes.items()
    both = [made.path(link) for link in pair]
    return [path[~np.isnan(both[0] + both[1])] for path in both]


def test_the_centrodes_of_a_cross_slide_are_circles_of_which_the_smaller_rolls_in_the_greater():
    fixed, moving = paths(rolling(CARDAN))
    assert len(fixed) > 300 and np.abs(fixed) == pytest.approx(0.4, rel=1e-9)
    assert np.abs(moving) == pytest.approx(0.2, rel=1e-9)  # about A, where the rod's own axes begin


def test_the_centrodes_of_a_crossed_parallelogram_are_equal_ellipses():
    for path in paths(rolling(CROSSED)):  # about O and C, and about A and B
        assert len(path) > 300 and np.abs(path) + np.abs(path - 0.2) == pytest.approx(0.3, rel=1e-6)


@pytest.mark.parametrize(("name", "pair"), [("four-bar", "0-2"), ("four-bar", "1-3"), ("six-link", "2-4")])
def test_centrodes_roll_on_each_other_without_slipping(name, pair):
    study = rolling(MECHANISMS[name], f'centrodes = ["{pair}"]', 30.0)
    one, two = (np.abs(np.diff(path)) for path in paths(study))
    even = (one < 0.02) & (two < 0.02)  # a step that is no passage through infinity, in which a chord is as an arc
    assert even.sum() > 100 and one[even] == pytest.approx(two[even], rel=1e-2, abs=1e-7)
    assert study.of(CentresComparison).agrees
    assert {row.name for row in study.of(CentresComparison).findings} > {f"P_{pair[0]}{pair[2]}^{pair[2]}"}


@pytest.mark.parametrize("name", ["four-bar", "six-link"])
def test_both_roads_find_the_same_centrodes(name):
    found = rolling(MECHANISMS[name], ASKED, 30.0).of(CentresStudy)
    solved = SolvedCentrodes.of(found, (0, 2))
    for link, path in solved.paths.items():
        off = np.abs(found.centrodes[0, 2].path(link) - path) / solved.allowed
        assert np.isfinite(off).sum() > 600 and np.nanmax(off) < 1


def test_links_that_turn_alike_by_their_lengths_are_told():
    even = FOUR_BAR | {"frame": "O = [0, 0]; C = [0.4, 0]", "lengths": "OA = 0.1; AB = 0.4; CB = 0.1"}
    study = rolling(even | {"sketch": "A = [0.05, 0.09]; B = [0.45, 0.09]"}, 'centrodes = ["0-2", "1-3"]')
    with pytest.raises(SceneError) as told:
        study.of(CentresComparison)
    assert [fault.path[-1] for fault in told.value.faults] == [0, 1] and "only translate" in str(told.value)


CROSS_SLIDE = {
    "frame": "O = [0, 0]", "links": "B BC C", "lengths": "BC = 0.2", "points": "K = { on = 2, at = [0.06, 0] }",
    "slides": [f"link = {n}; along = {{ through = [0, 0], angle = {way} }}" for n, way in ((1, 0), (3, 90))],
    "sketch": "B = [0.1, 0]; C = [0, 0.17]",
}  # fmt: skip
COUPLER = FOUR_BAR | {"points": "K = { on = 2, at = [0.2, 0.15] }"}
ROD = SLIDER_CRANK | {"points": "K = { on = 2, at = [0.07, -0.03] }"}


def curving(mechanism: dict[str, str | list[str]], drive: str = "link = 1; speed = -7; positions = 7") -> Study:
    return drawn(mechanism, drive, 'curvature = ["K"]')


def test_a_trammel_has_the_radius_of_its_ellipse_and_its_rod_as_diameter():
    """K parts the rod in 60 and 140 mm: half axes of its ellipse, whose radius is (a⁴y² + b⁴x²)^1.5/(ab)⁴."""
    study = curving(CROSS_SLIDE, "link = 1; stroke = { from = 0.02, to = 0.18, speed = 0.2 }; positions = 5")
    found = {row.name: row for row in study.of(CentresComparison).findings}
    assert found["δ_2"].construction == pytest.approx(0.2)
    assert np.abs(found["W_2"].construction).max() < 1e-12
    k, (a, b) = study.of(CentresComparison).analysis.points["K"].r, (0.14, 0.06)
    worked = (a**4 * k.imag**2 + b**4 * k.real**2) ** 1.5 / (a * b) ** 4
    assert found["ρ_K"].construction == pytest.approx(worked)
    assert np.abs(circle_of(0.1j, 0.3j) - 0.2j) == pytest.approx(0.1)


@pytest.mark.parametrize("mechanism", [COUPLER, ROD], ids=["four-bar", "slider-crank"])
def test_bobillier_finds_the_curvature_that_accelerations_tell(mechanism):
    study = curving(mechanism)
    compared = study.of(CentresComparison)
    rows = [row for row in compared.findings if row.name in ("W_2", "δ_2", "O_K", "ρ_K")]
    assert compared.agrees and len(rows) == 4
    for row in rows:
        known = np.isfinite(row.analysis)
        assert known.sum() >= 5 and (row.allowed[known] < 1e-8 * (1 + np.abs(row.analysis[known]) ** 2)).all(), row.name


TOLD = [
    (FOUR_BAR, "positions = [4]", "a position from 0 to 3"),
    (SLIDER_CRANK, 'centrodes = ["0-1"]', "their hinge O"), (SLIDER_CRANK, 'centrodes = ["0-3"]', "only translate"),
    (SLIDER_CRANK, 'centrodes = ["0-4"]', "there is no link 4"), (COUPLER, 'curvature = ["O"]', "is fixed"),
    (COUPLER, 'curvature = ["A"]', "circle about O"), (ROD, 'curvature = ["B"]', "straight guide"),
    (COUPLER, 'curvature = ["Z"]', "no point Z"),
    (SIX_LINK | {"points": "K = { on = 2, at = [0.1, 0] }"}, 'curvature = ["K"]', "two pins"),
]  # fmt: skip


@pytest.mark.parametrize(("mechanism", "asked", "said"), TOLD)
def test_what_has_no_centre_centrode_or_such_a_curvature_is_told(mechanism, asked, said):
    assert said in str(drawn(mechanism, "link = 1; speed = 1; positions = 4", asked).scene.meaning.faults[0])


@pytest.mark.parametrize(
    ("path", "pieces", "length"),
    [
        (lambda t: np.exp(1j * np.cos(t + 1)), 1, 2.0), (lambda t: np.exp(2j * t), 1, 2 * np.pi),
        (lambda t: t - 3 - 1j * np.exp(-1j * (t - 3)), 2, 8.0), (np.ones_like, 0, 0.0),
    ],
    ids=["there and back", "twice round", "a cycloid's cusp", "one place"],
)  # fmt: skip
def test_a_curve_is_drawn_once(path, pieces, length):
    found = named(path(np.linspace(0, 2 * np.pi, 721) + 0j), "p", (0j, 9.0))
    assert len(found) == pieces
    assert sum(np.abs(np.diff(piece)).sum() for piece in found.values()) == pytest.approx(length, rel=1e-2)
