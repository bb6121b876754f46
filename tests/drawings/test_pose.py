"""Schemes of one position with what is constructed on them: equal angles, sides of the polygon, positions refused."""

from __future__ import annotations

from cmath import phase
from math import isnan
from pathlib import Path

import numpy as np
import pytest

from drawings.centres.curves import curvature
from drawings.centres.due import expected
from drawings.centres.scheme import polygon
from drawings.layout.picture import Spot
from drawings.lettering.words import with_index
from drawings.linkage.pose import pose
from drawings.page.page import Field, Scale, drafting_of
from drawings.paper.strokes import Circle, Line, SheetError
from drawings.paper.walk import flat, texts
from drawings.sheets.kind import sheet_kind
from drawings.transfer.scheme import TurnedScheme
from plans.centres.quantities import CentresComparison
from plans.centres.study import CentresStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.transfer.quantities import TransferComparison
from plans.transfer.study import TransferStudy
from tests.plans.scenes import scene
from tests.plans.test_transfer import FOUR_BAR, SIX_LINK, SLIDER_CRANK, TANGENT, study_of


@pytest.mark.parametrize(
    ("mechanism", "point", "link"), [(FOUR_BAR, "B", "A"), (SLIDER_CRANK, "B", "A"), (TANGENT, "A", "O")]
)
@pytest.mark.parametrize("angle", [25, 70])
def test_an_angle_of_the_turned_plan_is_that_at_the_point_from_its_link(mechanism, point, link, angle):
    study = study_of(mechanism, angle)
    turned, motion = study.of(TransferStudy), study.of(TransferComparison).construction
    (equal,) = TurnedScheme(pose(turned.linkage, motion, 0), turned.turned, 0).equal
    on_plan, on_scheme = (phase(ways[1] / ways[0]) for ways in (equal.on_plan, equal.on_scheme))
    assert on_plan == pytest.approx(on_scheme)
    arm = motion.points[link].r[0] - motion.points[point].r[0]
    assert min(abs(phase(arm / way)) for way in equal.on_scheme) < 1e-9


def test_the_polygon_has_a_side_for_each_centre_full_for_those_of_pairs():
    study = study_of(SIX_LINK, 60, head='sheets = ["centres"]')
    spot = Spot(Field(0, 0, 100, 100), Scale(1.0, "l", "mm"))
    drawn = list(flat(polygon(study.of(CentresStudy).at(0), spot, drafting_of(study.scene)).lines))
    sides = [one for one in drawn if isinstance(one, Line)]
    assert (len(sides), sum(not one.style.dash for one in sides)) == (15, 7)
    assert sum(isinstance(one, Circle) for one in drawn) == 6


@pytest.mark.parametrize("sheet", ["transfer", "centres"])
def test_a_position_that_is_not_reached_is_refused_with_those_that_are(sheet):
    rocking = FOUR_BAR | {"lengths": "OA = 0.2; AB = 0.25; CB = 0.15", "sketch": "B = [0.4, 0.14]"}
    drive = "link = 1; speed = 1; positions = 12"
    study = Study(parse_scene(scene(f'sheets = ["{sheet}"]', **rocking, drive=drive, **{sheet: "positions = [1, 6]"})))
    with pytest.raises(SheetError, match=rf"{sheet}.positions: .* position 6: .* one of 0, 1, 2, 10, 11"):
        sheet_kind(sheet).leaves(study)
    assert np.isnan(study.of(TransferComparison).construction.links[3].omega[6])


def test_open_centres_give_no_rate_and_their_sheet_says_so():
    """Plate 3 hangs on crank, rocker and frame by three leads: Kennedy's lines never find its centres."""
    path = Path(__file__).parents[1] / "cases/kinematics/open-centres.toml"
    study = Study(read_scene(path))
    leaves = sheet_kind("centres").leaves(study)
    told = {text.plain for leaf in leaves for text in texts(leaf.groups)}
    assert "—" in told and "nan" not in told
    assert not any(isinstance(one.value, float) and isnan(one.value) for one in expected(study, leaves))


def test_a_curvature_bears_the_letters_of_its_construction_and_arrows_to_what_lies_off_it():
    coupler = FOUR_BAR | {"points": "K = { on = 2, at = [0.2, 0.15] }"}
    asked = {"drive": "link = 1; speed = 1; positions = 7", "centres": 'curvature = ["K"]'}
    study = Study(parse_scene(scene('sheets = ["centres"]', **coupler, **asked)))
    found, motion = study.of(CentresStudy), study.of(CentresComparison)
    for k in range(7):
        shown = curvature(found, "K", pose(found.linkage, motion.construction, k), k, drafting_of(study.scene))
        far = dict(shown.away)
        assert {*shown.near, *far} >= {"Q", "Q_K", "J_A", "O_K", "P_02"}
        told = {one for _, text in shown.beside if text.startswith("to ") for one in text[3:].split(", ")}
        assert told >= {with_index(name) for name in far}
        a, b, o, c = (motion.analysis.points[name].r[k] for name in "ABOC")
        for start, end in ((a, b), (o, c)):  # Q is where the line of the pins meets that of their centres
            assert abs(((shown.built["Q"] - start) / (end - start)).imag) < 1e-9
