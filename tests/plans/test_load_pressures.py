"""Pressures on pistons, places of a stroke as shares, per cent and lengths, an indicator diagram with its branches."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.model.mechanism import StructureError
from plans.scene.faults import SceneError, dotted
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from tests.plans.force_cases import ROADS
from tests.plans.test_loading import AT_60, AT_90, ENGINE, ON_B, loaded

PUSHED = ON_B + "direction = 180\n"
AREA = math.pi * 0.08**2 / 4  # m2, of a bore of 80 mm
CARD = 'diagram = { travel = [0, 0.5, 1], pressure = ["0.1 MPa", "0.6 MPa", "0.1 MPa"] }\nbore = "80 mm"\n'


WITH_ROD = 'pressure = "8 bar"\nbore = "100 mm"\nrod = "60 mm"\nbehind = "3 bar"\n'
FACE, SECTION = math.pi * 0.1**2 / 4, math.pi * 0.06**2 / 4  # m2, of the piston and of its rod


@pytest.mark.parametrize(
    ("written", "force"),
    [
        ("", 8e5 * (FACE - SECTION) - 3e5 * FACE),
        ('rod_on = "behind"\n', 8e5 * FACE - 3e5 * (FACE - SECTION)),
        ('rod_on = "both"\n', 5e5 * (FACE - SECTION)),
        ('ambient = "1 bar"\n', 8e5 * (FACE - SECTION) + 1e5 * SECTION - 3e5 * FACE),
        ('rod_on = "behind"\nambient = "1 bar"\n', 8e5 * FACE - 3e5 * (FACE - SECTION) - 1e5 * SECTION),
    ],
)
def test_each_pressure_acts_on_its_own_side_of_the_piston(written: str, force: float) -> None:
    assert loaded(ENGINE + PUSHED + WITH_ROD + written).force().real == pytest.approx(-force, rel=1e-13)


@pytest.mark.parametrize("side", ["pressure", "behind", "both"])
def test_a_piston_with_one_pressure_all_round_is_not_pushed(side: str) -> None:
    written = WITH_ROD.replace("8 bar", "3 bar") + f'rod_on = "{side}"\nambient = "3 bar"\n'
    assert abs(loaded(ENGINE + PUSHED + written).force()) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("by", ROADS)
@pytest.mark.parametrize(
    ("last", "said"),
    [
        ("230 mm", "covers 230 mm, 30 mm more than the stroke of link 3, 200 mm"),
        ("0.18 m", "covers 180 mm, 20 mm less than the stroke of link 3, 200 mm"),
    ],
)
def test_lengths_of_another_stroke_are_refused_with_the_difference(last: str, said: str, by: str) -> None:
    card = f'diagram = {{ travel = [0, "{last}"], force = [0, 100] }}\n'
    with pytest.raises(StructureError, match=said):
        loaded(ENGINE + PUSHED + card, by)
    near = card.replace(last, "199.5 mm")  # read off a drawing
    assert abs(loaded(ENGINE + PUSHED + near, by).force()) == pytest.approx(
        [0, 100 * AT_60, 100 * AT_90, 100, 100 * AT_90, 100 * AT_60], abs=1e-11
    )


def test_a_diagram_of_a_pump_over_lengths_counts_how_far_piston_and_cylinder_are_apart() -> None:
    ends = '[[loads.forces]]\nbetween = ["O", { on = 3, point = "B" }]\n'
    card = 'diagram = { travel = ["0 mm", "200 mm"], pressure = ["0 MPa", "1 MPa"] }\nbore = "80 mm"\n'
    expected = 1e6 * AREA * np.array([0, AT_60, AT_90, 1, AT_90, AT_60])
    assert loaded(ENGINE + ends + card).force() == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(
    ("written", "where", "said"),
    [
        ('pressure = "1 MPa"\n', "loads.forces[0].bore", 'add it: bore = "80 mm"'),
        ("diagram = { travel = [0, 1], pressure = [1, 1] }\n", "loads.forces[0].bore", 'add it: bore = "80 mm"'),
        ('value = 3\nbore = "80 mm"\n', "loads.forces[0].bore", "a pressure, which bore belongs to"),
        ('value = 3\nbehind = "1 bar"\n', "loads.forces[0].behind", "a pressure, which behind belongs to"),
        ('pressure = 1\nbore = "80 mm"\nambient = 3\n', "loads.forces[0].rod", 'add it: rod = "30 mm"'),
        ('pressure = 1\nbore = "80 mm"\nrod = "80 mm"\n', "loads.forces[0].rod", "a rod thinner than the bore"),
        (
            'pressure = "1 N"\nbore = "80 mm"\n',
            "loads.forces[0].pressure",
            "a unit of pressure (Pa, kPa, MPa, bar, at, atm",
        ),
        ('value = 1\npressure = 1\nbore = "80 mm"\n', "loads.forces[0]", "either value or pressure, not both"),
        (
            CARD.replace("pressure", "force = [0, 1, 2], pressure"),
            "loads.forces[0].diagram",
            "either force or pressure, not both",
        ),
        ("diagram = { travel = [0, 1] }\n", "loads.forces[0].diagram.force", "add it: force = [1500, 1500]"),
        (
            CARD.replace(" }", ', back = ["1 N", 0, 0] }'),
            "loads.forces[0].diagram.back[0]",
            "sizes in the unit of pressure",
        ),
        (
            'diagram = { travel = [0, 1], force = [0, 0], back = [0, "1 bar"] }\n',
            "loads.forces[0].diagram.back[1]",
            "sizes in the unit of force",
        ),
        (CARD.replace("0.5", "50"), "loads.forces[0].diagram.travel[1]", 'or write "15 %" or "15 mm"'),
        (
            CARD.replace("0.1 MPa", "1 bars"),
            "loads.forces[0].diagram.pressure[0]",
            "bars, here and elsewhere in the list (1 more)",
        ),
        (CARD.replace("0.1 MPa", "1 bars"), "loads.forces[0].diagram.pressure[0]", 'did you mean "1 bar"'),
        (CARD.replace("0.6 MPa", "6 bars"), "loads.forces[0].diagram.pressure[1]", 'bars. Fix: did you mean "6 bar"'),
        (
            CARD.replace(" }", ', back = ["1 bar", "6 bars", "2 bars"] }'),
            "loads.forces[0].diagram.back[1]",
            "of force or pressure (N, kN, kgf, Pa, kPa, MPa, bar, at and others), but found bars, here and elsewhere "
            "in the list (1 more). "
            'Fix: did you mean "6 bar"',
        ),
        (CARD.replace("1]", '"105 %"]'), "loads.forces[0].diagram.travel[2]", "from 0 % to 100 %, but found 105 %"),
        (CARD.replace("1]", '"-5 %"]'), "loads.forces[0].diagram.travel[2]", "from 0 % to 100 %, but found -5 %"),
        (CARD.replace("0.5", '"50 %%"'), "loads.forces[0].diagram.travel[1]", "length"),
        (CARD.replace("0.5", '"50 mm"'), "loads.forces[0].diagram.travel[2]", "write all places as lengths"),
        (CARD.replace("1]", '"90 %"]'), "loads.forces[0].diagram.travel", "it covers 0 to 0.9"),
        (
            CARD.replace("[0, 0.5, 1]", '["10 mm", "20 mm", "200 mm"]'),
            "loads.forces[0].diagram.travel",
            "it covers 0.01 to 0.2",
        ),
        (CARD.replace("[0, 0.5, 1]", '[0, "20 mm", "10 mm"]'), "loads.forces[0].diagram", "travel rising"),
    ],
)
def test_a_wrong_use_is_told_with_what_to_write(written: str, where: str, said: str) -> None:
    with pytest.raises(SceneError) as refused:
        loaded(ENGINE + PUSHED + written)
    (fault,) = refused.value.faults
    assert (dotted(fault.path), said in str(fault)) == (where, True), str(fault)


@pytest.mark.parametrize(
    ("written", "notes"),
    [
        (CARD, []),
        (CARD.replace("0.6 MPa", "600 MPa"), ["high_pressure"]),
        ('pressure = 1000000000\nbore = "80 mm"\n', ["high_pressure"]),
        ('pressure = 0.6\nbore = "80 mm"\n', ["low_pressure"]),
        ('pressure = 0\nbore = "80 mm"\n', []),
        ('pressure = "1 MPa"\nbore = 80\n', ["wide_bore"]),
        (CARD.replace(" }", ', back = ["0.1 MPa", 0, 0] }'), ["open_diagram"]),
        (CARD + "behind = 0.1\n", ["uneven_pressures"]),
        (CARD + 'behind = "100 Pa"\n', []),
        (CARD.replace(" }", ', back = ["0.1 MPa", 0.1, "0.1 MPa"] }'), ["uneven_pressures"]),
        ('pressure = "0.6 MPa"\nbehind = 0.1\nbore = "80 mm"\n', ["uneven_pressures"]),
    ],
)
def test_likely_slips_are_noted(written: str, notes: list[str]) -> None:
    told = list(notes_of(parse_scene('sheets = ["forces"]\n' + ENGINE + PUSHED + written)))
    assert [note.kind for note in told] == notes
    said = [note.worded(language) for note in told for language in ("en", "ru")]
    assert not any("{" in one or "100000 Pa;" in one for one in said)
