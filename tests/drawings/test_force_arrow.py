"""Forces, couples and arms on paper: where they begin and end, what can be measured, what is known of them."""

import cmath
import math

import pytest

from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.lettering.extent import bounds
from drawings.page.scale import Scale
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Arc, Fill, Line
from drawings.paper.walk import texts
from drawings.symbols import force_arrow
from drawings.symbols.couples import HALF, THREE_QUARTERS, CoupleArc
from drawings.symbols.figure import Subject

HAND = hand_of("A1")
NEWTONS = Scale(20.0, "F", "N")
POLYGON = Subject("forces-4-5", "F", 2)


def test_a_vanishing_force_is_drawn_as_nothing_but_its_place() -> None:
    one = force_arrow.to_scale("Φ_5", 0j, 20 + 20j, NEWTONS, POLYGON)
    (shaft,) = one.draw(HAND).strokes
    assert isinstance(shaft, Line) and shaft.start == shaft.end == 20 + 20j


def test_letters_of_forces_on_one_point_do_not_touch() -> None:
    forces = [force_arrow.not_to_scale(f"R_{{{k}}}", cmath.rect(1, k * 0.4), 100 + 100j, 20.0) for k in range(15)]
    ink = Ink(300.0, 200.0)
    ink.draw([one.draw(HAND) for one in forces])
    found = [bounds(text) for text in texts([force_arrow.letters(forces, Labels(ink, HAND.drafted), HAND)])]
    assert len(found) == 15
    for k, one in enumerate(found):
        for other in found[:k]:
            assert one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]


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
