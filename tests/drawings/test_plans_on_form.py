"""Plans on a form whose letters crowd: what is too short to see shares a spot; a figure is that of its place."""

from __future__ import annotations

import pytest

from drawings.grading.asked import PlanAsked, VectorAsked
from drawings.grading.drawing_faults import drawing_faults
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.form_place import FormPlace
from drawings.grading.onlooker import Segment, spelled_labels
from drawings.grading.plans_on_form import plans_on_form
from drawings.paper.strokes import Group, Leaf, Text

SPOTS = {"π": 0j, "a": 60 + 0j, "n_BA": 60 + 0.6j, "b": 30 + 40j}  # mm from the pole: n_BA is hardly off a
PAIRS = [("π", "a"), ("a", "n_BA"), ("n_BA", "b"), ("π", "b")]


def plan(position: int, turn: complex = 1 + 0j) -> PlanAsked:
    own = tuple(VectorAsked(f"a_{end}", start, end, (SPOTS[end] - SPOTS[start]) * turn, None) for start, end in PAIRS)
    return PlanAsked("accelerations", position, "sheet", "m/s2", own, {"accelerations": 1.0}, symbol="a")


def drawn(one: PlanAsked, at: complex) -> tuple[list[Segment], list[Text]]:
    """Draw a plan at 1 (m/s2)/mm, each letter a little beside its place."""
    turn = one.vectors[0].true / SPOTS["a"]
    lines = [Segment(at + SPOTS[start] * turn, at + SPOTS[end] * turn, True) for start, end in PAIRS]
    return lines, [Text(at + spot * turn + 1 + 1j, letter, 3.5) for letter, spot in SPOTS.items()]


def read(*own: tuple[list[Segment], list[Text]]) -> list[DrawnPlan]:
    """Read figures on a form that has the places of two plans, one over the other."""
    places = [FormPlace(("accelerations", k), None, low, low + 120 + 90j) for k, low in ((2, 60 + 90j), (8, 60 - 60j))]
    words = [text for _, texts in own for text in texts]
    labels = spelled_labels(tuple(words))
    return list(
        plans_on_form([plan(2), plan(8, -1j)], [line for lines, _ in own for line in lines], words, labels, places)
    )


def test_a_part_too_short_for_a_place_of_its_own_shares_that_of_another() -> None:
    (found,) = read(drawn(plan(2), 100 + 100j))
    assert found.asked.position == 2
    assert found.lacking == []
    assert all(abs(found.arrows[one.letters].vector - one.true) < 1e-9 for one in found.asked.vectors)


def test_a_figure_is_the_plan_of_its_place_whatever_it_fits() -> None:
    found = read(drawn(plan(8, -1j), 100 + 160j), drawn(plan(2), 100 - 50j))
    assert {one.asked.position: one.places["π"] for one in found} == {2: 100 + 160j, 8: 100 - 50j}


def test_a_figure_outside_all_places_is_no_plan() -> None:
    assert read(drawn(plan(2), 400 + 100j)) == []


def test_an_arrow_back_to_front_is_that_of_its_letters() -> None:
    lines, words = drawn(plan(2), 100 + 100j)
    back = lines[3]._replace(start=lines[3].end, end=lines[3].start)
    (found,) = read(([*lines[:3], back], words))
    assert found.unread is None
    assert found.arrows["π", "b"].vector == pytest.approx(-SPOTS["b"])
    assert found.places["b"] == pytest.approx(100 + 100j + SPOTS["b"])


@pytest.mark.parametrize(("letter", "lacking"), [("b", []), ("πab", ["a_a", "a_n_BA", "a_b", "a_b"])])
def test_a_letter_too_few_is_told_by_its_arrow_and_of_none_that_is_read_nothing_is_graded(
    letter: str, lacking: list[str]
) -> None:
    lines, words = drawn(plan(2), 100 + 100j)
    kept = [one for one in words if one.plain not in letter and not (lacking and one.plain != letter)]
    (found,) = read((lines, kept))
    assert [one.name for one in found.lacking] == lacking
    assert (found.unread is not None) == bool(lacking)


def test_letters_in_each_others_place_are_told_and_the_plan_is_right() -> None:
    lines, words = drawn(plan(2), 100 + 100j)
    names = {"a": "b", "b": "a"}
    words = [*words, Text(95 + 130j, "μ_a = 1 (m/s2)/mm", 3.5)]
    (found,) = read((lines, [one._replace(content=names.get(one.plain, one.plain)) for one in words]))
    assert all(abs(found.arrows[one.letters].vector - one.true) < 1e-9 for one in found.asked.vectors)
    leaf = Leaf(400, 400, (Group(tuple(words)),))
    said = {one.name for one in drawing_faults(leaf, spelled_labels(tuple(words)), found) if one.kind == "swapped"}
    assert said == set()  # as they should stand; and as they do:
    labels = spelled_labels(tuple(one._replace(content=names.get(one.plain, one.plain)) for one in words))
    assert {one.name for one in drawing_faults(leaf, labels, found) if one.kind == "swapped"} == {"a", "b"}


def test_lines_without_heads_go_as_their_letters_say_and_are_told() -> None:
    lines, words = drawn(plan(2), 100 + 100j)
    bare = lines[3]._replace(start=lines[3].end, end=lines[3].start, headed=False)
    (found,) = read(([*lines[:3], bare], words))
    assert (found.lacking, found.headless) == ([], ("a_b",))
    assert found.arrows["π", "b"].vector == pytest.approx(SPOTS["b"])


def test_what_lies_on_another_arrow_need_not_be_drawn_and_both_cost_once() -> None:
    asked = plan(2)
    twin = VectorAsked("a^n_A", "π", "n_A", asked.vectors[0].true, None)
    asked = asked._replace(vectors=(twin, *asked.vectors))
    lines, words = drawn(plan(2), 100 + 100j)
    place = [FormPlace(("accelerations", 2), None, 60 + 90j, 180 + 180j)]
    kept, gone = (
        next(plans_on_form([asked], some, words, spelled_labels(tuple(words)), place)) for some in (lines, lines[1:])
    )
    assert kept.lacking == []
    assert [(one.name, gone.is_covered(one)) for one in gone.lacking] == [("a^n_A", True), ("a_a", False)]
