"""Force polygons: what a ruler finds on them, and whether each force can be read."""

from __future__ import annotations

from drawings.forces.letters import WHOLE
from drawings.forces.polygon import WIDE, ForcePolygon, draw, polygon
from drawings.forces.polygon import measure as room_of
from drawings.kinds.polygon import ShownVector, lay
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import merging, offset, parallel_offsets
from drawings.measure.measure import measure
from drawings.measure.measured import MeasuredVector
from drawings.page.page import Field
from drawings.page.scale import Drafting
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Line, Text
from drawings.paper.walk import flat
from drawings.pens.svg import svg
from plans.forces.cut import CLOSING, KNOWN
from tests.drawings.force_cases import CASES, Forced, forced, leaf, polygons, sheet, spot

A1 = hand_of("A1")


def written(name: str, k: int) -> dict[tuple[str, str], MeasuredVector]:
    return {(one.plan, one.name): one for one in measure(svg(sheet(name, k))).vectors}


# methods' worked case M5.7, N: the shaper at 60 degrees, driven by a gear.
M57 = {
    ("forces-4-5", "Φ_4"): 14.86350455 + 5.228213782j,
    ("forces-4-5", "Φ_5"): 123.6578622 + 0j,
    ("forces-4-5", "G_5"): -245.25j,
    ("forces-4-5", "F_us"): 1500 + 0j,
    ("forces-4-5", "R^t_34"): 0.8069359265 + 10.60216184j,
    ("forces-4-5", "R^n_34"): -1639.328303 + 124.7701104j,
    ("forces-4-5", "R_34"): -1638.521367 + 135.3722722j,
    ("forces-4-5", "R_05"): 134.079514j,
    ("forces-4-5", "R_54"): 1623.657862 - 111.170486j,
    ("forces-2-3", "Φ_3"): 37.2201641 + 26.14106891j,
    ("forces-2-3", "R_43"): 1638.521367 - 135.3722722j,
    ("forces-2-3", "R_12"): -2537.127867 + 335.3600848j,
    ("forces-2-3", "R_03"): 861.3863359 - 78.97888146j,
    ("forces-1", "P_bal"): 1290.915752 - 1083.206931j,
    ("forces-1", "R_21"): 2537.127867 - 335.3600848j,
    ("forces-1", "R_01"): -3828.043619 + 1477.427016j,
}  # fmt: skip


def test_a_ruler_finds_the_forces_of_the_worked_example() -> None:
    found = written("shaper at 60", 0)
    paper = 2 * measure(svg(sheet("shaper at 60", 0))).quantum
    for key, value in M57.items():
        assert abs(found[key].value - value) <= paper * found[key].scale + 1e-5, key  # 1e-5 N: their last digit
        assert abs(found[key].stated - value) <= 1e-5, key


def test_a_vector_beside_its_place_keeps_its_value_and_thin_lines_lead_to_it() -> None:
    """Weights on a vertical guide: the reaction goes back over them, and is drawn in a lane of its own."""
    down = (
        ShownVector("G_2", KNOWN, 0j, -40j),
        ShownVector("G_3", KNOWN, -40j, -60j),
        ShownVector("R_03", CLOSING, -100j, 100j),
    )
    shown = ForcePolygon("2-3", True, 0, down, ())
    measure_ = room_of(shown, Drafting(A1))
    placed = spot(measure_, Field(10, 10, 300, 300))
    drawn = draw(shown, measure_, placed, Drafting(A1))
    arrows = lay(shown.forces, WHOLE, measure_.place(*placed), placed.box, WIDE, A1).seen
    assert [arrow.vector.name for arrow in arrows if arrow.shift] == ["G_3", "G_2"]  # the longest keeps its place
    assert len({arrow.shift for arrow in arrows if arrow.shift}) == 1  # both on one side, in one lane
    for one in measure(svg(leaf([drawn], A1))).vectors:
        assert abs(one.value - one.stated) <= 2e-3 * one.scale
    for arrow in (arrow for arrow in arrows if arrow.shift):
        for end in arrow.ends:
            lead = [
                line
                for line in flat(drawn.lines)
                if isinstance(line, Line) and abs(line.start - (end - arrow.shift)) < 1e-9
            ]
            assert any(abs(((line.end - line.start) * arrow.shift.conjugate()).imag) < 1e-9 for line in lead)


def test_small_forces_among_huge_ones_are_named_for_the_table() -> None:
    """The press: 4 MN on the ram, the links' weights are 10^4 times less and more; the polygon closes all the same."""
    case = forced("press")
    drawn = polygons(case, 3, A1)[0]
    head = " ".join(one.plain for one in flat(drawn.lines) if isinstance(one, Text))
    faint = set(head.partition(": ")[2].split(", "))
    lettered = {one.plain for one in flat(drawn.letters(Labels(Ink(920, 460), A1.drafted))) if isinstance(one, Text)}
    assert {"G4", "G5", "Φ4", "Φ5"} <= faint
    assert {"Fus", "R05", "R54"} <= lettered
    assert lettered.isdisjoint(faint)


def test_a_force_that_is_zero_is_left_out() -> None:
    case = Forced(CASES["shaper"]._replace(load=(5, "D", 0j)))
    names = {one.name for one in polygon(case.plan, case.plan.cuts[0], 2).forces}
    assert "F_us" not in names
    assert {"Φ_5", "G_5", "R_05"} <= names


def test_a_polygon_without_any_force_says_so() -> None:
    case = Forced(CASES["shaper"]._replace(load=(5, "D", 0j), bodies={}))
    (first, *_) = polygons(case, 2, A1)
    texts = [stroke.plain for stroke in flat(first.lines) if isinstance(stroke, Text)]
    assert texts == ["Force plan of group 4-5, position 2", "no force acts: every reaction is zero"]


def test_lanes_keep_the_first_and_shift_what_runs_along_it() -> None:
    segments = [(0j, 100 + 0j), (100 + 0j, 40 + 0.2j), (40 + 0.2j, 40 + 60j), (0j, 30 + 0j)]
    shifts = parallel_offsets(segments, 4.0, 12 + 10j)
    assert shifts[0] == 0
    assert shifts[2] == 0
    placed = [offset(one, shift) for one, shift in zip(segments, shifts, strict=True)]
    assert not any(merging(one, other) for k, one in enumerate(placed) for other in placed[:k])
    for one, shift in zip(segments, shifts, strict=True):
        assert abs(((one[1] - one[0]) * shift.conjugate()).real) < 1e-9  # a shift is square to its line
