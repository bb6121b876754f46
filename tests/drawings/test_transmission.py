"""Symbols of drive and load: the pitch circle with its line of action, a coupling; forces and springs of nothing."""

import cmath
import math

import pytest

from drawings.lettering.extent import bounds
from drawings.page.scale import Scale
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Arc, Circle, Line
from drawings.symbols.couples import Gear, coupling, spring
from drawings.symbols.figure import Subject
from drawings.symbols.force_arrow import to_scale

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


def test_a_spring_without_length_is_a_point() -> None:
    assert set(spring(5j, 5j, HAND).points) == {5j}


def test_the_plates_of_a_coupling_face_each_other_across_its_shaft() -> None:
    first, second, *shafts = coupling(50 + 50j, 1j, HAND)
    assert abs(first.start - second.start) == pytest.approx(1.6) and abs(first.end - first.start) == pytest.approx(12.0)
    assert len(shafts) == 2 and bounds(shafts[0])[3] <= bounds(shafts[1])[1]


def test_a_vanishing_force_is_drawn_as_nothing_but_its_place() -> None:
    one = to_scale("Φ_5", 0j, 20 + 20j, Scale(20.0, "F", "N"), Subject("forces-4-5", "F", 2))
    (shaft,) = one.draw(HAND).strokes
    assert isinstance(shaft, Line) and shaft.start == shaft.end == 20 + 20j
