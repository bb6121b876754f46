"""Pressures on pistons, places of a stroke as shares, per cent and lengths, an indicator diagram with its branches."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.model.machine import Diagram
from plans.model.mechanism import StructureError
from plans.scene.faults import SceneError, dotted
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from tests.plans.force_cases import ROADS, compared, of_road
from tests.plans.test_loading import AT_60, AT_90, ENGINE, ON_B, loaded

PUSHED = ON_B + "direction = 180\n"
AREA = math.pi * 0.08**2 / 4  # m2, of a bore of 80 mm
CARD = 'diagram = { travel = [0, 0.5, 1], pressure = ["0.1 MPa", "0.6 MPa", "0.1 MPa"] }\nbore = "80 mm"\n'


@pytest.mark.parametrize(
    ("written", "force"),
    [
        ('pressure = "0.6 MPa"\nbore = "80 mm"\n', 0.6e6 * AREA),
        ('pressure = "6 bar"\nbore = 0.08\n', 0.6e6 * AREA),
        ('pressure = "600 кПа"\nbore = "8 cm"\n', 0.6e6 * AREA),
        ('pressure = 600000\nbore = "80 mm"\nrod = "25 mm"\n', 0.6e6 * math.pi * (0.08**2 - 0.025**2) / 4),
        ('pressure = "0.6 MPa"\nbehind = "0.1 MPa"\nbore = "80 mm"\n', 0.5e6 * AREA),
        ('pressure = "-20 kPa"\nbore = "80 mm"\n', -20e3 * AREA),
    ],
)
def test_a_pressure_on_a_piston(written: str, force: float) -> None:
    told = loaded(ENGINE + PUSHED + written)
    assert told.force() == pytest.approx([-force] * 6, rel=1e-14)
    assert told.strokes == {}


@pytest.mark.parametrize("by", ROADS)
def test_a_diagram_of_pressures(by: str) -> None:
    at_60, at_90 = 0.1e6 + 1e6 * AT_60, 0.6e6 - 1e6 * (AT_90 - 0.5)
    expected = np.array([0.1e6, at_60, at_90, 0.1e6, at_90, at_60]) * AREA
    assert loaded(ENGINE + PUSHED + CARD, by).force() == pytest.approx(-expected, rel=1e-12)
    back = CARD.replace(" }", ', back = ["0.1 MPa", 200000, "1 bar"] }')
    expected[4:] = [(0.2e6 - 0.2e6 * (AT_90 - 0.5)) * AREA, (0.1e6 + 0.2e6 * AT_60) * AREA]
    assert loaded(ENGINE + PUSHED + back, by).force() == pytest.approx(-expected, rel=1e-12)


@pytest.mark.parametrize(
    "travel",
    ["[0, 0.15, 1]", '["0 %", "15 %", "100%"]', '[0, "15 %", 1]', '["0 mm", "30 mm", "200 mm"]', '[0, "3 cm", 0.2]'],
)
def test_places_of_a_stroke_are_shares_per_cent_or_lengths(travel: str) -> None:
    card = f"diagram = {{ travel = {travel}, force = [0, 100, 300] }}\n"
    if travel.endswith("0.2]"):  # a bare number is a share, and stands among lengths by mistake
        with pytest.raises(SceneError, match=r"lengths of the stroke, as the others, but found 0\.2"):
            loaded(ENGINE + PUSHED + card)
        return
    (force,) = loaded(ENGINE + PUSHED + card).machine.forces
    assert force.diagram == Diagram((0, 0.15, 1), (0, 100, 300), (), 0.2 if "m" in travel else 0.0)


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


def compressor(count: int, behind: str) -> str:
    """Write the compressor of M4.7: stroke 0.20, clearance 0.02 m, piston 0.01 m2, 1 to 5 bar absolute, n = 1.3."""
    stroke, clearance, low, high, n = 0.2, 0.02, 1e5, 5e5, 1.3
    ratio = (high / low) ** (1 / n)
    delivers = stroke + clearance - (stroke + clearance) / ratio  # m from the beginning of compression
    filled = stroke - (clearance * ratio - clearance)  # m from there to where the residue has expanded
    assert stroke - delivers == pytest.approx(0.04379012405, abs=1e-11)
    assert stroke - filled == pytest.approx(0.04897619444, abs=1e-11)
    places = np.unique([*np.linspace(0, stroke, 300), delivers, filled])
    volume = stroke + clearance - places
    there = np.minimum(low * ((stroke + clearance) / volume) ** n, high)
    back = np.maximum(high * (clearance / volume) ** n, low)
    lists = (", ".join(f'"{1000 * place:.9f} mm"' for place in places),)
    lists += tuple(", ".join(f'"{size / 1e5:.12f} bar"' for size in row) for row in (there, back))
    card = "travel = [{}], pressure = [{}], back = [{}]".format(*lists)
    scene = ENGINE.replace("[0, 60, 90, 180, 270, 300]", str(count))
    piston = f"bore = {math.sqrt(0.04 / math.pi)!r}\n{behind}"
    return 'sheets = ["forces"]\n' + scene + ON_B + f"direction = 0\ndiagram = {{ {card} }}\n{piston}"


@pytest.mark.parametrize("road", ROADS)
def test_the_work_of_a_compressor_over_its_cycle(road: str) -> None:
    """Forward work 348.786 J, 54.436 J returned, M = 46.84718275 N m (M4.7), with the air behind or not."""
    for behind in ('behind = "1 bar"\n', ""):
        comparison = compared(compressor(360, behind))
        assert comparison.agrees
        moment = of_road(comparison, road).balancing.moment
        assert moment.mean() == pytest.approx(46.84718275, rel=2e-4)  # straight between 300 points, and a sum of 360
    told = of_road(compared(compressor(360, 'behind = "1 bar"\n')), road).balancing.moment
    there, back = told[:180].sum() * np.pi / 180, told[180:].sum() * np.pi / 180
    assert (there, -back) == pytest.approx((348.7860211, 54.43649076), rel=1e-3)


@pytest.mark.parametrize(
    ("written", "where", "said"),
    [
        ('pressure = "1 MPa"\n', "loads.forces[0].bore", 'add it: bore = "80 mm"'),
        ("diagram = { travel = [0, 1], pressure = [1, 1] }\n", "loads.forces[0].bore", 'add it: bore = "80 mm"'),
        ('value = 3\nbore = "80 mm"\n', "loads.forces[0].bore", "a pressure, which bore belongs to"),
        ('value = 3\nbehind = "1 bar"\n', "loads.forces[0].behind", "a pressure, which behind belongs to"),
        ('pressure = 1\nbore = "80 mm"\nrod = "80 mm"\n', "loads.forces[0].rod", "a rod thinner than the bore"),
        ('pressure = "1 N"\nbore = "80 mm"\n', "loads.forces[0].pressure", "a unit of pressure (Pa, kPa, MPa, bar)"),
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
        (CARD.replace("0.1 MPa", "1 bars"), "loads.forces[0].diagram.pressure[0]", 'write it as "1 bar"'),
        (CARD.replace("0.6 MPa", "6 bars"), "loads.forces[0].diagram.pressure[1]", 'bars. Fix: write it as "6 bar"'),
        (
            CARD.replace(" }", ', back = ["1 bar", "6 bars", "2 bars"] }'),
            "loads.forces[0].diagram.back[1]",
            "of force or pressure (N, kN, Pa, kPa, MPa, bar), but found bars, here and elsewhere in the list (1 more). "
            'Fix: write it as "6 bar"',
        ),
        (CARD.replace("1]", '"105 %"]'), "loads.forces[0].diagram.travel[2]", "from 0 % to 100 %, but found 105 %"),
        (CARD.replace("1]", '"-5 %"]'), "loads.forces[0].diagram.travel[2]", "from 0 % to 100 %, but found -5 %"),
        (CARD.replace("0.5", '"50 %%"'), "loads.forces[0].diagram.travel[1]", "length"),
        (CARD.replace("0.5", '"50 mm"'), "loads.forces[0].diagram.travel[2]", "write all places as lengths"),
        (CARD.replace("1]", '"90 %"]'), "loads.forces[0].diagram.travel", "it covers 0 to 0.9"),
        (
            CARD.replace("[0, 0.5, 1]", '["10 mm", "20 mm", "200 mm"]'),
            "loads.forces[0].diagram.travel",
            "it covers 0.010 to 0.200",
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
    assert all("{" not in note.worded(language) for note in told for language in ("en", "ru"))


def test_a_diagram_of_another_stroke_is_told_at_its_place() -> None:
    scene = (
        ENGINE + ON_B + "value = 1\ndirection = 0\n" + PUSHED + 'diagram = { travel = [0, "9 m"], force = [0, 1] }\n'
    )
    line = 1 + scene.splitlines().index(next(line for line in scene.splitlines() if line.startswith("diagram")))
    with pytest.raises(StructureError, match=rf":{line}:13: loads\.forces\[1\]\.diagram\.travel: the diagram of"):
        compared(scene)
