"""Graph and hodograph over a turn: standard scales, measured ordinates and points, curves broken at their gaps."""

import math

import numpy as np
import pytest

from drawings.kinds import bar_chart, curve_graph, hodograph
from drawings.kinds.axes import OVER, Axes, Letter, Part, Parts, Pole
from drawings.kinds.curve_graph import GraphCurve
from drawings.kinds.hodograph import Hodograph
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import Spot
from drawings.lettering.lettering import bounds
from drawings.page.page import Drafting, Field, Scale
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Group, Leaf, Line, Polyline, Stroke, Text
from drawings.pens.svg import svg
from drawings.reading.measure import Measured, check, measure
from plans.model.cyclogram import BarRow

HAND = hand_of("A1")
AT, DENSE = np.arange(12) * 30.0, np.linspace(0.0, 360.0, 361)


def moment(phi: np.ndarray) -> np.ndarray:
    return 80.0 * np.sin(np.radians(phi)) - 25.0


CURVE = GraphCurve("M_{bal}", "N*m", DENSE, moment(DENSE), AT, moment(AT), name="balancing")


def flat(stroke: Stroke) -> list[Stroke]:
    return [one for inner in stroke.strokes for one in flat(inner)] if isinstance(stroke, Group) else [stroke]


def graph(curve: GraphCurve = CURVE, language: str = "en") -> Group:
    drafting, curve = Drafting(HAND, language), curve._replace(title="Balancing moment")
    measure_ = curve_graph.measure(curve, drafting)
    spot = Spot(Field(0, 0, *measure_.size(Scale(2.0, "φ", "°"))), Scale(2.0, "φ", "°"))
    found = curve_graph.draw(curve, measure_, spot, drafting)
    ink = Ink(400.0, 300.0)
    ink.draw(found.lines)
    return found.letter(Labels(ink, HAND.drafted))[0]


def measured(drawn: Group) -> Measured:
    found = measure(svg(Leaf(400.0, 300.0, (drawn,))))
    assert check(found) == []
    return found


def test_the_curve_is_broken_at_a_gap_and_the_gap_has_no_ordinate() -> None:
    values = CURVE.values.copy()
    values[100:140] = math.nan
    ordinates = CURVE.ordinates.copy()
    ordinates[4] = math.nan  # at 120 degrees
    drawn = graph(CURVE._replace(values=values, ordinates=ordinates))
    lines = [stroke for stroke in flat(drawn) if isinstance(stroke, Polyline)]
    assert [len(line.points) for line in lines] == [100, 221]
    assert 4 not in {vector.position for vector in measured(drawn).vectors}


def test_a_jump_is_dashed() -> None:
    """The curve is broken there, and joined by a line that is no part of it."""
    drawn = graph(CURVE._replace(values=np.where(DENSE < 100.2, moment(DENSE), moment(DENSE) - 40.0)))
    lines = [stroke for stroke in flat(drawn) if isinstance(stroke, Polyline)]
    assert [len(line.points) for line in lines] == [101, 260]
    (jump,) = (stroke for stroke in flat(drawn) if isinstance(stroke, Line) and stroke.style.dash)
    assert (jump.start, jump.end) == (lines[0].points[-1], lines[1].points[0])


def rocking(phi: np.ndarray) -> np.ndarray:
    """A moment that goes to infinity where a crank stops 130 degrees on from position 0."""
    return np.where(np.minimum(phi, 310 - phi) < 0, -1.0, 1.0) / np.where((phi < 130) | (phi > 310), 130 - phi, np.nan)


def test_a_crank_that_turns_fully_is_followed_over_its_turn_whatever_its_positions() -> None:
    few = CURVE._replace(stations=AT[:3], ordinates=CURVE.ordinates[:3])
    assert curve_graph.swing(few) is few
    assert few.closed


@pytest.mark.parametrize("off", [-6e-14, 0.0, 6e-14])
def test_a_turn_that_is_a_rounded_sum_ends_at_position_0_again(off: float) -> None:
    turn = CURVE._replace(angles=np.append(DENSE[:-1], 360 + off))
    assert [text.plain for text in flat(graph(turn)) if isinstance(text, Text)].count("0") == 2


def test_a_curve_that_outgrows_its_positions_beside_a_gap_is_broken_there() -> None:
    dense, own = rocking(DENSE), rocking(np.array([20.0, 50.0, 80.0]))
    kept = curve_graph.bounded(dense, own)
    assert np.nanmax(np.abs(kept)) <= 2 * np.max(np.abs(own))
    assert np.nanmax(np.abs(dense)) > 10 * np.max(np.abs(own))
    assert curve_graph.bounded(CURVE.values, 0.0 * CURVE.ordinates) is CURVE.values


def test_the_letter_of_a_pole_distance_stands_over_it_before_any_number_of_a_graph() -> None:
    axes, ink = Axes(100 + 100j, Scale(1.0, "φ", "°"), Scale(1.0, "a", "m/s2")), Ink(400.0, 300.0)
    pole = Pole(("P_2", "H_2"), 15.0, np.array([9.0]), np.array([10.0]), 3.0, 20j).part("pole", axes, HAND)
    parts = Parts((), (Part("row", (), (Letter(pole.letters[1].at, "15", HAND.number, OVER),)), pole))
    ink.draw(parts.lines)
    drawn = flat(Group(parts.letter(Labels(ink, HAND.drafted))))
    number, _, distance = (stroke for stroke in drawn if isinstance(stroke, Text))
    assert (number.plain, distance.plain) == ("15", "H2") and distance.at.imag > 120 > number.at.imag


def force(phi: np.ndarray) -> np.ndarray:
    return 900 * np.exp(1j * np.radians(phi)) + 400 * np.exp(-2j * np.radians(phi)) + 200j


SHOWN = Hodograph("R_{34}", "F", "N", force(DENSE[:-1]), force(AT), 2, "hodograph-3-4")


def figure(shown: Hodograph = SHOWN) -> Group:
    measure_ = hodograph.measure(shown, Drafting(HAND))
    scale = measure_.rungs(300.0, 250.0)[0].scale
    spot = Spot(Field(0, 0, *measure_.size(scale)), scale)
    found = hodograph.draw(shown, measure_, spot, Drafting(HAND))
    ink = Ink(400.0, 300.0)
    ink.draw(found.lines)
    return found.letter(Labels(ink, HAND.drafted))[0]


def test_a_whole_hodograph_is_closed_and_a_gap_breaks_it() -> None:
    (whole,) = (stroke for stroke in flat(figure()) if isinstance(stroke, Polyline))
    assert whole.closed and len(whole.points) == 360
    values = SHOWN.values.copy()
    values[50:60] = math.nan
    parts = [stroke for stroke in flat(figure(SHOWN._replace(values=values))) if isinstance(stroke, Polyline)]
    assert [(len(part.points), part.closed) for part in parts] == [(50, False), (300, False)]


def test_a_turn_that_ends_with_position_0_again_begins_with_it_also_where_the_shown_one_is_beside_it() -> None:
    at = np.arange(360.0)
    drawn = graph(CURVE._replace(stations=at, ordinates=moment(at), shown=(1,)))
    assert {0, 1} <= {vector.position for vector in measured(drawn).vectors}


def test_positions_whose_ends_fall_together_have_one_number_of_them_all() -> None:
    """A vector along a guide is the same on the way there and back: at 60 and at 300 degrees."""
    values, ends = (np.cos(np.radians(phi)) * (600 + 800j) for phi in (DENSE[:-1], AT))
    drawn = flat(figure(SHOWN._replace(values=values, ends=ends, shown=0)))
    told = {stroke.plain for stroke in drawn if isinstance(stroke, Text)}
    assert {"0", "2, 10", "6"} <= told and not {"2", "10"} & told


@pytest.mark.parametrize("setting", [0.3, 1.3, 2.3, 3.0, 5.9])
@pytest.mark.parametrize("name", ["clamp", "lever-of-the-feed-into-the-clamp"])
def test_a_setting_angle_is_told_between_the_names_and_the_end_of_the_turn(name: str, setting: float) -> None:
    chart, hand = bar_chart.Chart((BarRow(name, (), setting),)), hand_of("A4")
    room = bar_chart.measure(chart, Drafting(hand, "en"))
    spot = Spot(Field(0, 0, *room.size(scale := Scale(0.05, "φ", "rad"))), scale)
    figure = bar_chart.draw(chart, room, spot, Drafting(hand, "en"))
    told = [stroke for stroke in flat(figure.lines[0]) if isinstance(stroke, Text) and "set" in stroke.plain]
    assert told and all(-hand.text < bounds(one)[0] and bounds(one)[2] < spot.box.right for one in told)
