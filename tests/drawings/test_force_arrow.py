"""Forces, couples and arms on paper: where they begin and end, what can be measured, what is known of them."""

import cmath
import math

import pytest

from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.lettering.extent import bounds
from drawings.measure.measure import check, measure
from drawings.page.scale import Scale
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Arc, Fill, Group, Leaf, Line, Polyline, Text
from drawings.pens.svg import svg
from drawings.symbols import arms, force_arrow
from drawings.symbols.arms import Arm
from drawings.symbols.couples import HALF, THREE_QUARTERS, CoupleArc
from drawings.symbols.figure import Subject

HAND = hand_of("A1")
NEWTONS = Scale(20.0, "F", "N")
POLYGON = Subject("forces-4-5", "F", 2)


def labels() -> Labels:
    return Labels(Ink(300.0, 200.0), HAND.drafted)


def test_a_force_to_scale_starts_from_its_point_and_ends_with_its_arrow() -> None:
    one = force_arrow.to_scale("R_{34}", 1200 - 1600j, 100 + 100j, NEWTONS, POLYGON)
    assert one.length == 100.0 and one.start == 100 + 100j and one.tip == pytest.approx(160 + 20j)
    shaft, head = one.draw(HAND).strokes
    assert isinstance(shaft, Line) and shaft.end == pytest.approx(160 + 20j) and shaft.style == HAND.result
    assert isinstance(head, Fill) and head.points[0] == pytest.approx(160 + 20j)


def test_a_force_may_end_at_its_point() -> None:
    one = force_arrow.not_to_scale("F_{us}", 2j, 50 + 50j, 30.0, ending=True)
    assert one.tip == 50 + 50j and one.start == 50 + 20j and one.free == one.start


def test_a_force_to_scale_is_measured_back_from_its_sheet() -> None:
    one = force_arrow.to_scale("R^t_{34}", -432.1 + 987.6j, 150 + 80j, NEWTONS, POLYGON)
    found = measure(svg(Leaf(300.0, 200.0, (one.draw(HAND),))))
    (vector,) = found.vectors
    assert vector.name == "R^t_34" and vector.unit == "N" and vector.position == 2
    assert vector.value == pytest.approx(-432.1 + 987.6j, abs=0.5) and check(found) == []


def test_a_marked_force_tells_its_direction_but_cannot_be_measured() -> None:
    drawn = force_arrow.not_to_scale("G_4", -3j, 10 + 90j, 25.0).draw(HAND)
    assert drawn.data == {"kind": "force", "name": "G_4", "direction": "0 -1"}
    assert measure(svg(Leaf(300.0, 200.0, (drawn,)))).vectors == ()


def test_a_force_known_in_direction_only_is_dashed_with_an_open_head() -> None:
    shaft, head = force_arrow.not_to_scale("R^n_{34}", 1, 40 + 40j, 30.0, unknown=True).draw(HAND).strokes
    assert isinstance(shaft, Line) and shaft.style.dash
    assert isinstance(head, Polyline) and not head.closed and head.points[1] == 70 + 40j


def test_a_vanishing_force_is_drawn_as_nothing_but_its_place() -> None:
    one = force_arrow.to_scale("Φ_5", 0j, 20 + 20j, NEWTONS, POLYGON)
    (shaft,) = one.draw(HAND).strokes
    assert isinstance(shaft, Line) and shaft.start == shaft.end == 20 + 20j


def test_a_marked_force_has_its_letter_at_the_end_away_from_its_point() -> None:
    one = force_arrow.not_to_scale("G_4", -1j, 100 + 100j, 30.0)
    text = one.letter_beside(labels(), HAND)
    assert isinstance(text, Text) and text.plain == "G4"
    assert abs(complex(bounds(text)[0], bounds(text)[3]) - one.tip) < 8.0


def test_letters_of_forces_on_one_point_do_not_touch() -> None:
    forces = [force_arrow.not_to_scale(f"R_{{{k}}}", cmath.rect(1, k * 0.4), 100 + 100j, 20.0) for k in range(15)]
    ink = Ink(300.0, 200.0)
    ink.draw([one.draw(HAND) for one in forces])
    found = [bounds(text) for text in _texts(force_arrow.letters(forces, Labels(ink, HAND.drafted), HAND))]
    assert len(found) == 15
    for k, one in enumerate(found):
        for other in found[:k]:
            assert one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]


def _texts(group: Group) -> list[Text]:
    found: list[Text] = []
    for stroke in group.strokes:
        found += _texts(stroke) if isinstance(stroke, Group) else [stroke] if isinstance(stroke, Text) else []
    return found


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("sweep", [HALF, THREE_QUARTERS])
def test_a_couples_arrowhead_leads_in_its_sense(sense: int, sweep: float) -> None:
    at = 60 + 60j
    arc, head = CoupleArc("M^Φ_4", at, sense, 8.0, math.pi / 2, sweep).draw(HAND).strokes
    assert isinstance(arc, Arc) and isinstance(head, Fill)
    tip, *wings = head.points
    ahead = tip - sum(wings) / 2
    moment = ((tip - at).conjugate() * ahead).imag
    assert math.copysign(1, moment) == sense and abs(tip - at) == pytest.approx(8.0)
    assert arc.sweep < sweep and (arc.at(0.5) - at).imag > 0  # the head ends it, and it faces upwards


def test_a_couple_has_its_letter_beyond_its_arc() -> None:
    text = CoupleArc("M^Φ_4", 100 + 100j, 1, 8.0, math.pi / 2).letter_beside(labels(), HAND)
    assert bounds(text)[1] > 108.0


def test_an_arm_is_square_to_the_line_of_action() -> None:
    one = Arm("h_1", 10 + 10j, 60 + 20j, cmath.rect(1, 2.0))
    across = one.foot - one.about
    assert (across.conjugate() * one.direction).real == pytest.approx(0.0, abs=1e-12)
    assert ((one.foot - one.at).conjugate() * one.direction).imag == pytest.approx(0.0, abs=1e-12)
    moment = ((one.at - one.about).conjugate() * one.direction).imag
    assert one.length == pytest.approx(abs(moment))


def test_an_arm_is_measured_back_in_metres() -> None:
    metres = Scale(0.002, "l", "m")
    one = arms.to_scale("h_2", 30 + 30j, 90 + 100j, 3 + 4j, metres, Subject("scheme-4-5", "l", 2))
    found = measure(svg(Leaf(300.0, 200.0, (Group(one.draw(HAND)),))))
    (vector,) = found.vectors
    assert vector.name == "h_2" and abs(vector.value) == pytest.approx(abs(60 * 4 - 70 * 3) / 5 * 0.002, abs=1e-5)
    assert check(found) == []


def test_an_arm_too_short_to_see_is_only_a_line_of_action() -> None:
    (action,) = Arm("h_1", 50 + 50.1j, 20 + 50j, 1 + 0j).draw(HAND)
    assert isinstance(action, Line) and action.start == 20 + 50j and action.end.real > 50.0


def test_a_line_of_action_through_its_own_foot_is_drawn_past_it() -> None:
    strokes = Arm("h_1", 50 + 50j, 50 + 20j, 1 + 0j).draw(HAND)
    assert isinstance(strokes[0], Line) and abs(strokes[0].end - strokes[0].start) == pytest.approx(arms.PAST)
