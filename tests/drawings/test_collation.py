"""Collation: each way of editing a sheet is told with its place, its figure, and by how much."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from typing import Any

import pytest

from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from drawings.reading.items import brought, items
from drawings.reading.transform import Affine
from drawings.sheet_diff.collate import Collation, Hidden, collate
from plans.words.words import languages

CORNERS = ("20 5", "200 5", "20 290")


def vector(name: str, start: complex, end: complex) -> Group:
    head = Fill((end, end - 3 + 1j, end - 3 - 1j))
    data = {"kind": "vector", "plan": "velocities", "quantity": "v", "name": name, "position": "2"}
    return Group((Line(start, end), head), data=data | {"value": "1 0", "scale": "0.01", "unit": "m/s"}, title=name)


def corner(text: str) -> Group:
    return Group((Circle(complex(*map(float, text.split())), 0.5),), data={"kind": "corner", "value": text})


def velocities(name: str = "velocities-2", x: float = 40) -> Group:
    heading = Group((Text(x + 95j, "Velocity plan, position 2"), Text(x + 90j, "μ_v = 0.01")))
    arrows = (vector("p a", x + 50j, x + 30 + 70j), vector("p b", x + 50j, x + 40 + 50j))
    return Group((heading, *arrows, Text(x + 31 + 71j, "a"), Line(x + 50j, x + 60j)), name)


LEAF = Leaf(
    210,
    297,
    (
        Group((Polyline((20 + 5j, 200 + 5j, 200 + 290j), True),), "frame"),
        Group(tuple(map(corner, CORNERS)), "corners"),
        Group((Text(120 + 10j, "Crank shaper"),), "title-block"),
        Group((Group((Line(30 + 200j, 90 + 200j), Text(32 + 202j, "12.5"), Text(52 + 202j, "4.7"))),), "values-1"),
        velocities(),
        Group((Line(140 + 40j, 150 + 40j), Line(150 + 40j, 160 + 50j)), "arms"),
        Group((Circle(150 + 150j, 9), Arc(150 + 150j, 12, 0, 2), Line(150 + 140j, 150 + 160j)), "scheme-1"),
    ),
    metadata={"rows": {"values": [0, 1]}},
)
VALUES, PLAN, SCHEME = 3, 4, 6


def edited(change: Callable[[Stroke], Any], leaf: Leaf = LEAF, top: int | None = None) -> Leaf:
    """Change strokes of a leaf, or of one group at its top: each is what `change` gives, gone if None."""

    def of(stroke: Stroke) -> Any:
        if isinstance(stroke, Group):
            stroke = stroke._replace(strokes=tuple(one for own in stroke.strokes if (one := of(own)) is not None))
        return change(stroke)

    groups = (of(group) if top in (None, k) else group for k, group in enumerate(leaf.groups))
    return leaf._replace(groups=tuple(group for group in groups if group is not None))


def told(there: Leaf, *hidden: Hidden) -> list[str]:
    found = collate(LEAF, there, hidden)
    return [edit.told.worded("en") for edit in found.edits] + [one.worded("en") for one in found.whole]


def mirrored_line(line: Any) -> Line:
    """Mirror a line about the upright through x = 140."""
    return line._replace(start=280 - line.start.conjugate(), end=280 - line.end.conjugate())


def named(name: str, change: Callable[[Group], Any]) -> Leaf:
    return edited(lambda one: change(one) if isinstance(one, Group) and one.data.get("name") == name else one)


def whole(name: str, change: Callable[[Group], Any]) -> Leaf:
    return edited(lambda one: change(one) if isinstance(one, Group) and one.name == name else one)


def text(was: str, change: Callable[[Text], Any]) -> Leaf:
    return edited(lambda one: change(one) if isinstance(one, Text) and one.plain == was else one)


def test_a_sheet_as_it_must_be_is_clean() -> None:
    found = collate(LEAF, LEAF)
    assert found.clean and found.same == found.most == len(items(LEAF)) - 5  # frame, title and corners are not counted


IN_PLAN = "“Velocity plan, position 2”"
STYLE = LineStyle(0.001)
FARTHEST = (20 + 12) * 2**0.5  # where the arc begins, a quarter turn about a place 20 mm off its centre
CASES = {
    "a vector is gone": (
        named("p a", lambda one: None),
        [
            f"missing: vector p a at (55.00, 60.00) mm, {IN_PLAN}",
            f"missing: arrowhead p a at (68.00, 70.00) mm, {IN_PLAN}",
        ],
    ),
    "an arrow is shifted whole": (
        named("p b", lambda one: brought(one, Affine(t=3 + 4j))),
        [f"moved by 5 mm, 0.05 m/s: vector p b with its arrow and letters at (60.00, 50.00) mm, {IN_PLAN}"],
    ),
    "an end is moved": (
        named("p b", lambda one: one._replace(strokes=(Line(40 + 50j, 82 + 50j), *one.strokes[1:]))),
        [f"one end moved by 2 mm, 0.02 m/s: vector p b at (60.00, 50.00) mm, {IN_PLAN}"],
    ),
    "a vector is drawn end for end": (
        named("p b", lambda one: one._replace(strokes=(Line(80 + 50j, 40 + 50j), *one.strokes[1:]))),
        [f"drawn end for end: vector p b at (60.00, 50.00) mm, {IN_PLAN}"],
    ),
    "a line is drawn in a hair": (
        edited(lambda one: one._replace(style=STYLE) if isinstance(one, Line) else one, top=SCHEME),
        ["line width 0.001 mm instead of 0.5 mm: line at (150.00, 150.00) mm, scheme-1"],
    ),
    "a cell says another number": (
        text("12.5", lambda one: one._replace(content="12.3")),
        ["“12.3” stands where “12.5” must: table cell “12.5” at (32.00, 202.00) mm, the table values-1"],
    ),
    "a letter is moved": (
        text("a", lambda one: one._replace(at=one.at + 2)),
        [f"moved by 2 mm, 0.02 m/s: lettering “a” at (71.00, 71.00) mm, {IN_PLAN}"],
    ),
    "a scale is another": (
        text("μv = 0.01", lambda one: one._replace(content="μ_v = 0.02")),
        [f"“μv = 0.02” stands where “μv = 0.01” must: heading “μv = 0.01” at (40.00, 90.00) mm, {IN_PLAN}"],
    ),
    "a circle is larger": (
        edited(lambda one: one._replace(radius=10) if isinstance(one, Circle) else one, top=SCHEME),
        ["the radius differs by 1 mm: circle at (150.00, 150.00) mm, scheme-1"],
    ),
    "a figure is gone": (
        whole("scheme-1", lambda one: None),
        ["missing: all of scheme-1, from (150.00, 150.00) mm"],
    ),
    "a figure is moved": (
        whole("scheme-1", lambda one: brought(one, Affine(t=-6 + 0j))),
        ["moved by 6 mm: all of scheme-1, from (150.00, 150.00) mm"],
    ),
    "a figure is turned": (
        whole("scheme-1", lambda one: brought(one, Affine(1j, 0j, (130 + 150j) * (1 - 1j)))),
        [f"turned by 90.00°, moved by up to {FARTHEST:.4g} mm: all of scheme-1, from (150.00, 150.00) mm"],
    ),
    "a figure is mirrored": (
        whole("arms", lambda one: one._replace(strokes=tuple(mirrored_line(line) for line in one.strokes))),
        ["drawn mirrored, moved by up to 40 mm: 2 lines and letters together, from (145.00, 40.00) mm, arms in links"],
    ),
    "a line is added": (
        whole("velocities-2", lambda one: one._replace(strokes=(*one.strokes, Line(50 + 55j, 60 + 90j)))),
        [f"added: line at (55.00, 72.50) mm, {IN_PLAN}"],
    ),
    "a vector is there twice": (
        whole("velocities-2", lambda one: one._replace(strokes=(*one.strokes, Line(40 + 50j, 80 + 50j)))),
        [f"there twice: line at (60.00, 50.00) mm, {IN_PLAN}"],
    ),
    "the paper is larger": (
        LEAF._replace(width=212.1),
        ["the paper is 212.1 × 297 mm; it must be 210 × 297 mm"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_an_edit_is_told(name: str) -> None:
    there, says = CASES[name]
    assert told(there) == says


def test_what_is_hidden_is_told_with_the_reason() -> None:
    arrow = next(item for item in items(LEAF) if item.name == "p a")
    gone = edited(lambda one: None if one is arrow.stroke else one)
    assert told(gone, Hidden(arrow, "pale")) == [
        f"in the file, but not seen (in the colour of paper): vector p a at (55.00, 60.00) mm, {IN_PLAN}"
    ]


def test_a_patch_is_told_with_what_it_hides() -> None:
    white = LineStyle(0.25, (), "#ffffff", "#ffffff")
    patch = Polyline((140 + 140j, 161 + 140j, 161 + 161j, 140 + 161j), True, white)
    own = items(LEAF)[0]._replace(stroke=patch)
    (said,) = told(LEAF, Hidden(own, "pale"))
    assert said.startswith(
        "a patch in the colour of paper over what is drawn, 3 in all, the first of it circle at (150.00"
    )


def test_a_drawing_that_was_moved_as_a_whole_is_laid_back() -> None:
    turned = cmath.rect(1.01, 0.02)
    moved = LEAF._replace(groups=tuple(brought(one, Affine(turned, 0j, 3 + 2j)) for one in LEAF.groups))
    found = collate(LEAF, moved)
    assert found.edits == ()
    (whole,) = found.whole
    assert "1.01 times as large" in str(whole)


def test_a_mirrored_drawing_is_refused() -> None:
    def mirrored(one: Stroke) -> Stroke:
        return one._replace(centre=-one.centre.conjugate() + 220) if isinstance(one, Circle) else one

    with pytest.raises(SheetRefused, match="mirrored"):
        collate(LEAF, edited(mirrored, top=1))


def test_another_sheet_is_strange() -> None:
    other = LEAF._replace(groups=(*LEAF.groups[:3], velocities("accelerations-5", 101.3)))
    found = collate(LEAF, other)
    assert found.strange and not collate(LEAF, edited(lambda one: one)).strange


def test_edits_are_told_in_every_language() -> None:
    found: list[Collation] = [collate(LEAF, there) for there, _ in CASES.values()]
    for language in languages():
        assert all(edit.plain(language)["told"] for one in found for edit in one.edits)
