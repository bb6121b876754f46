"""What a hand may be out on the plans: held against chance drawings of the draughtsman, and against each slip tried."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest

from geometry import hand_error
from geometry.board import Reading, Span, between
from plans.forces.marks import forces_by_hand
from plans.forces.statics import Statics
from plans.linkage.parts import MotionByHand
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.motion import Floats
from plans.quantity import SLIP, Shown
from plans.scene.scene import read_scene
from tests import draughtsman
from tests.draughtsman import Draughtsman, copies
from tests.gallery import GALLERY
from tests.parts import some
from tests.plans import linkages
from tests.plans.pushed_machines import Picture, slider
from tests.plans.studies import study_of

ON_PAPER = {"positions": 200.0, "velocities": 100.0, "accelerations": 100.0}  # mm of the largest vector of a plan
DRAWINGS = 200
TENTH = 0.1
SCENES = [
    "shaper", "crank-rocker", "oscillating-cylinder", "scotch-yoke", "tangent", "walking-leg", "squeezer", "whitworth",
    "jaw-crusher", "toggle-press", "v-engine", "conveyor", "planer", "slider-crank",
    "three-lead-press", "three-lead-shaker",
]  # fmt: skip


@cache
def by_hand(name: str) -> tuple[MotionByHand, tuple[int, ...], dict[str, Floats]]:
    """Study a scene of the gallery, with the scales of its plans in all positions."""
    study = LinkageStudy(read_scene(GALLERY / f"{name}.toml"))
    told, whole = MotionByHand(study, compare(study), {}), tuple(np.flatnonzero(~study.lost).tolist())
    points = study.motion(2).points.values()
    sizes = (max(np.nanmax(np.abs(point[order])) for point in points) for order in range(3))
    ones = np.ones(len(whole))
    return told, whole, {plan: size / mm * ones for (plan, mm), size in zip(ON_PAPER.items(), sizes, strict=True)}


def off(told: Shown, drawn: Mapping[object, Floats]) -> Floats:
    """Give by how much each drawing is out in what is read off it, (drawings, positions)."""
    match told:
        case Span(start, end):
            return np.asarray(np.abs(np.abs(drawn[end] - drawn[start]) - np.abs(between(start, end))))
        case Reading(arm, turning):
            true = (np.asarray(turning.point) / np.asarray(arm.point)).imag
            return np.asarray(np.abs((drawn[turning] / drawn[arm]).imag - true))
    raise AssertionError(told)


@pytest.mark.parametrize("name", some(SCENES, len(SCENES)))
def test_95_of_100_drawings_are_within_what_is_told(name: str) -> None:
    """Of all that is read off the plans of all positions, but what is given, drawn 200 times with a fixed seed."""
    told, whole, scales = by_hand(name)
    read, errors = told.read(told.study.drafts(list(whole))), told.errors(whole, scales)
    marks = [mark for one in read.values() for mark in one]  # type: ignore[union-attr]
    drawn = copies(Draughtsman(SLIP, scales, DRAWINGS), *marks)
    shares = []
    for key in read.keys() - told.given:
        known = np.isfinite(errors[key]) & (errors[key] > 0)
        assert known.mean() > 0.5 or not known.any()
        shares.append(
            (np.broadcast_to(off(read[key], drawn), (DRAWINGS, len(whole)))[:, known] / errors[key][known]).ravel()
        )
    assert np.quantile(np.concatenate(shares), 0.95) == pytest.approx(1.0, abs=TENTH)
    # Of each quantity by itself, where its positions are drawings enough.
    own = [np.quantile(share, 0.95) for share in shares if len(share) >= 5 * DRAWINGS]
    assert np.mean(np.abs(np.array(own) - 1.0) < TENTH) >= 0.9


@pytest.mark.parametrize("name", some(SCENES, len(SCENES)))
def test_each_slip_tried_by_itself_moves_the_plans_as_its_rule_says(name: str) -> None:
    told, whole, scales = by_hand(name)
    ruled, tried = (told.errors(whole, scales, by) for by in (hand_error.slopes, draughtsman.slopes))
    for key in ruled.keys() - told.given:
        known = np.isfinite(ruled[key])
        assert ruled[key][known] == pytest.approx(tried[key][known], rel=1e-5, abs=1e-12)


def test_beside_a_dead_centre_the_slips_tell_nothing() -> None:
    """Coupler and rocker all but in line: the sine of their notch is as small as what the slips change of it."""
    near = linkages.four_bar(0.1, 0.3, 0.1505, 0.35, sketch={"B": 0.3 + 0.14j})
    study = study_of(near, positions=[90, 179])
    told = MotionByHand(study, compare(study), {})
    errors = told.errors(
        (0, 1), {"positions": np.full(2, 0.002), "velocities": np.full(2, 0.01), "accelerations": np.full(2, 0.1)}
    )
    assert np.isfinite(errors["v_A"]).all()
    assert {key for key, row in errors.items() if np.isnan(row[1])} >= {"v_B", "a_B", "ω_2", "ω_3"}
    assert all(np.isfinite(row[0]) for row in errors.values())


def test_forces_are_out_by_their_polygons_and_arms() -> None:
    """Each slip tried by itself; larger polygons leave what the arms and the directions are out."""
    scene = read_scene(GALLERY / "shaper-loaded.toml")
    statics = Statics(LinkageStudy(scene))
    scales = {"scheme-4-5": 0.002, "scheme-2-3": 0.004, "forces-4-5": 10.0, "forces-2-3": 25.0, "lever": 0.02}
    ruled, tried = (forces_by_hand(statics, 2, scales, by) for by in (hand_error.slopes, draughtsman.slopes))
    assert set(ruled) >= {("R_34", 2), ("M_bal", 2), ("P_bal", 2), ("M_bal lever", 2)}
    for key, error in ruled.items():
        assert error == pytest.approx(tried[key], rel=1e-5)
    finer = forces_by_hand(statics, 2, {**scales, "forces-2-3": 5.0, "forces-4-5": 5.0})
    assert all(finer[key] < error for key, error in ruled.items() if key[0].startswith("R_"))
    assert finer["M_bal lever", 2] == ruled["M_bal lever", 2]  # no polygon enters the lever
    own = forces_by_hand(statics, 2, {**scales, "forces-2-3": 250.0})
    assert own["R_34", 2] == ruled["R_34", 2] < own["R_12", 2] / 5  # found in the polygon of its own group alone


def test_each_position_of_a_sheet_is_out_by_the_scales_of_its_own_figures() -> None:
    told, _, _ = by_hand("shaper")
    rows = {"positions": [0.002, 0.002], "velocities": [0.01, 0.03], "accelerations": [0.2, 0.7]}
    figures = {f"{plan}-{k}": row[k] for plan, row in rows.items() for k in (0, 1) if plan != "positions"}
    due = told.errors((0, 1), {plan: np.array(row) for plan, row in rows.items()})
    found = told.on_sheet((0, 1, 2), {"positions": 0.002, **figures})  # of position 2 no plans are drawn
    assert found.keys() == {(name, k) for name in due for k in (0, 1)}
    assert all(found[name, k] == pytest.approx(due[name][k], nan_ok=True) for name, k in found)


def test_the_force_of_a_slide_is_out_in_newtons_at_any_size() -> None:
    """A machine four times as large, on figures to scales as much coarser, is out by as much more."""
    scales = {"scheme-2-3": 0.002, "forces-2-3": 2.0, "lever": 0.01}
    small = forces_by_hand(slider()["forces"], 2, scales)
    large = forces_by_hand(slider(Picture(size=4.0))["forces"], 2, {name: 4.0 * mu for name, mu in scales.items()})
    assert {("P_bal", 2), ("P_bal lever", 2), ("R_01", 2)} <= large.keys()
    for key in (("P_bal", 2), ("P_bal lever", 2), ("R_01", 2)):
        assert large[key] == pytest.approx(4.0 * small[key], rel=1e-9)


def test_a_fair_hand_slips_by_as_much_as_is_told() -> None:
    promises = (GALLERY / "promises.md").read_text(encoding="utf-8")
    assert f"out by up to {SLIP} mm to either side" in " ".join(promises.split())
