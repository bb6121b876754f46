"""Symbols of drive and load: the pitch circle with its line of action, a spring between its ends, a coupling."""

import cmath
import math

import pytest

from drawings.lettering.extent import bounds
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Arc, Circle, Line
from drawings.symbols.couples import Gear, coupling, spring

HAND = hand_of("A1")


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("at", [0.0, 1.1, math.radians(210), 5.0])
def test_the_line_of_action_leaves_the_pitch_tangent_by_the_pressure_angle(at: float, sense: int) -> None:
    pressure = math.radians(20)
    action = 1j * sense * cmath.rect(1, at + sense * pressure)
    gear = Gear(100 + 100j, 60.0, at, action)
    circle, tangent, line, arc, contact = gear.draw(HAND)
    assert isinstance(circle, Arc) and circle.radius == 60.0 and circle.style.dash
    assert isinstance(contact, Circle) and abs(contact.centre - gear.centre) == pytest.approx(60.0)
    assert isinstance(arc, Arc) and arc.sweep == pytest.approx(pressure)
    for stroke in (tangent, line):
        assert isinstance(stroke, Line) and (stroke.start + stroke.end) / 2 == pytest.approx(contact.centre)
    ends = {round(cmath.phase(arc.at(k) - contact.centre), 6) for k in (0, 1)}
    assert ends == {round(cmath.phase(action), 6), round(cmath.phase(gear.tangent), 6)}
    # square to the line of action from the shaft: the base circle
    assert abs(((gear.centre - gear.contact) * action.conjugate()).imag) == pytest.approx(60 * math.cos(pressure))


def test_a_large_wheel_may_be_drawn_by_the_arc_at_the_pinion() -> None:
    arc = Gear(0j, 200.0, 1.0, 1j).draw(HAND, whole=False)[0]
    assert isinstance(arc, Arc) and arc.sweep < math.pi / 2 and arc.at(0.5) == pytest.approx(cmath.rect(200, 1.0))


@pytest.mark.parametrize("end", [40 + 0j, 10 + 30j, 3 + 0j])
def test_a_spring_runs_between_its_ends_and_keeps_its_width(end: complex) -> None:
    points = spring(0j, end, HAND).points
    assert points[0] == 0j and points[-1] == end
    turned = [point * end.conjugate() / abs(end) for point in points]
    assert max(abs(point.imag) for point in turned) <= 3.0 + 1e-9
    assert sum(turned[k].imag * turned[k + 1].imag < 0 for k in range(len(turned) - 1)) == 9
    assert [point.real for point in turned] == sorted(point.real for point in turned)


def test_a_spring_without_length_is_a_point() -> None:
    assert set(spring(5j, 5j, HAND).points) == {5j}


def test_the_plates_of_a_coupling_face_each_other_across_its_shaft() -> None:
    first, second, *shafts = coupling(50 + 50j, 1j, HAND)
    assert abs(first.start - second.start) == pytest.approx(1.6) and abs(first.end - first.start) == pytest.approx(12.0)
    assert len(shafts) == 2 and bounds(shafts[0])[3] <= bounds(shafts[1])[1]
