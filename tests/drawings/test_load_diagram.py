"""Load diagrams: every corner where the machine's load has it, there and back, over the true stroke."""

from __future__ import annotations

from itertools import pairwise

import pytest

from drawings.forces import load_diagram
from drawings.forces.load_diagram import course_of, courses
from drawings.paper.walk import texts
from plans.forces.loading import OutputStroke
from plans.model.machine import ALWAYS, IDLE, OUTPUT, WORKING, Diagram, Force, Machine, Moment, Piston, Transmission
from plans.model.mechanism import Way
from tests.drawings.exhibits import exhibited, read_back

SLIDES = OutputStroke(0.0, 3.0, 1, (0.5, 0.3), 3, "B", Way(0j, 1 + 0j))
SWINGS = OutputStroke(0.0, 3.0, 1, (0.3, 1.3), 3)
PLANER = Force("F_us", 3, "B", 0j, 2000.0, None, WORKING, None, (0.05, 0.05))
GAS = Force("F_g", 3, "B", 0j, 1.0, -1j, ALWAYS, Diagram((0, 0.2, 1), (7500, 3200, 700), (7500, 1100, 700)))
RUBS = Force("F_D", 3, "B", 0j, 1.0, None, ALWAYS, Diagram((0, 0.2, 1), (500, 700, 1000), (100, 200, 300)), (0.1, 0.0))
SAW = Moment("M_us", 3, 50.0, True, IDLE, (0.0, 0.2))


def test_a_resistance_rests_in_the_overruns_and_on_the_way_back() -> None:
    """The planer of M4.7: 2000 N between 0.05H and 0.95H of the way out, H = 0.2 m; its area is the cycle's work."""
    found = course_of(PLANER, SLIDES)
    assert [complex(round(one.real, 12), one.imag) for one in found.out] == [
        0, 0.01, 0.01 + 2000j, 0.19 + 2000j, 0.19, 0.2
    ]  # fmt: skip
    assert found.back == ()
    area = sum((b.imag + a.imag) / 2 * (b.real - a.real) for a, b in zip(found.out, found.out[1:], strict=False))
    assert area == pytest.approx(360.0)


def test_a_force_along_a_line_keeps_its_sign_and_one_against_the_motion_turns_over() -> None:
    gas, rubs = course_of(GAS, SLIDES), course_of(RUBS, SLIDES)
    assert gas.back == pytest.approx((0.2 + 700j, 0.04 + 1100j, 7500j))
    assert rubs.out[:3] == pytest.approx((0j, 0.02, 0.02 + 600j))
    assert rubs.back == pytest.approx((0.2 - 300j, 0.04 - 200j, 0.02 - 150j, 0.02, 0j))


def test_a_link_that_swings_is_told_in_degrees() -> None:
    found = course_of(SAW, SWINGS)
    assert found.length == pytest.approx(57.29577951) and found.turning and found.couple
    assert found.out == () and found.span == (-50.0, 0.0)
    written = {text.plain for text in texts(exhibited([(load_diagram, found)]).groups)}
    assert {"ψ = 57.3°", "0.2ψ", "M, N·m", "ψ, °"} <= written


def test_loads_that_never_change_have_no_diagram() -> None:
    steady = Force("F_0", 3, "B", 0j, 10.0, 1j)
    machine = Machine({}, 0j, (steady, GAS, PLANER), (Moment("M_0", 1, 1.0), SAW), (), Transmission(), {})
    assert [one.name for one in courses(machine, {OUTPUT: SLIDES})] == ["F_g", "F_us", "M_us"]


def test_of_many_corners_every_sheet_letters_the_same() -> None:
    many = GAS._replace(diagram=Diagram(tuple(k / 15 for k in range(16)), tuple(8000 / (1 + k) for k in range(16))))
    leaves = (exhibited([(load_diagram, course_of(many, SLIDES))], size) for size in ("A1", "A3"))
    large, small = ({mark.name: round(mark.value.imag) for mark in read_back(leaf).vectors} for leaf in leaves)
    assert large == small and 4 < len(large) < 16


PISTON = Piston(0.005, 0.005, 500.0)  # 50 cm2, the air's 1 bar behind it
CARD = GAS._replace(diagram=Diagram((0, 0.2, 1), (2500, 1500, 0), (2500, 300, 0)), piston=PISTON)


def test_a_pressure_is_told_as_an_indicator_card() -> None:
    """MPa over the stroke, the air's pressure where the force is none; its area times the piston's is the work."""
    found = course_of(CARD, SLIDES)
    assert found.out == pytest.approx((0.6j, 0.04 + 0.4j, 0.2 + 0.1j))
    area = sum((b.imag + a.imag) / 2 * (b.real - a.real) for a, b in pairwise((*found.out, *found.back)))
    assert area * 1e6 * PISTON.area == pytest.approx((1500 - 300) / 2 * 0.2)
    leaf = exhibited([(load_diagram, found._replace(places=found.out[:1]))])
    written = {text.plain for text in texts(leaf.groups)}
    assert {"p, MPa", "a, 0"} <= written and any("Indicator card" in one for one in written)
    pumped = CARD._replace(diagram=Diagram((0, 0.2, 1), (2500, 300, 0), (2500, 1500, 0)))
    assert found.higher and not course_of(pumped, SLIDES).higher  # numbers of positions stand outside both branches


def test_what_rests_at_the_ends_or_turns_over_is_a_load() -> None:
    for other in (CARD._replace(overrun=(0.1, 0.0)), CARD._replace(direction=None)):
        assert not course_of(other, SLIDES).card and max(one.imag for one in course_of(other, SLIDES).out) > 1000
