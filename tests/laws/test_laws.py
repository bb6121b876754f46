"""Laws of drawing, on sheets of the gallery and of random scenes of every technique; and what each law finds.

A law knows no technique: it holds what states nothing, lines, symbols, arrowheads, lettering.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

import pytest

from drawings.paper.hand import SIZES, Hand, hand_of
from drawings.paper.strokes import Circle, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from drawings.sheets.documents import leaves_of
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests import parts
from tests.alarms.scenes import drawn
from tests.drawings.slips import Change, changed, in_part, stretched
from tests.gallery import GALLERY, SCENES
from tests.laws import arrows, bar, lettering, letters, polygons, repeats, symbols, widths

LAWS = (arrows, bar, letters, lettering, polygons, repeats, symbols, widths)
EVERYDAY = ("four-masses", "slider-crank")
RANDOM = (63,)  # of every day, by their numbers; others with --whole
OTHERS = [k for k in range(60) if k not in RANDOM] if parts.whole else []
CROWDED = "lettering that has no room touches ink"
KNOWN: set[str | int] = set()  # sheets that are right and badly drawn, to be mended
WHITE = LineStyle(0.25, fill="#ffffff")


def hand(leaf: Leaf, standard: str) -> Hand:
    """Give the hand in which a leaf is drawn, by its format."""
    size = {round(leaf.width, 3), round(leaf.height, 3)}
    return hand_of(next(name for name, own in SIZES.items() if set(own) == size), standard)


def breaches(leaves: Mapping[str, Sequence[Leaf]], standard: str, laws: Sequence[object] = LAWS) -> Iterator[str]:
    """Name what on sheets breaks a law."""
    for kind, own in leaves.items():
        for leaf in own:
            for law in laws:
                found = law.breaches(leaf, hand(leaf, standard))  # type: ignore[attr-defined]
                yield from (f"{kind}: {law.__name__}: {one}" for one in found)  # type: ignore[attr-defined]


def marks(name: str | int, everyday: Sequence[str | int]) -> list[pytest.MarkDecorator]:
    known = [pytest.mark.xfail(reason=CROWDED, strict=True)] if name in KNOWN else []
    return known + [pytest.mark.rest] * (name not in everyday)


@cache
def sheets(name: str) -> tuple[Mapping[str, Sequence[Leaf]], str]:
    """Lay out the sheets of a scene of the gallery; give them with their standard."""
    study = Study(read_scene(GALLERY / f"{name}.toml"))
    return leaves_of(study), study.scene.sheet.standard


SHOWN = [one for one in SCENES if parts.whole or one.stem in EVERYDAY]


@pytest.mark.parametrize("path", [pytest.param(one, id=one.stem, marks=marks(one.stem, EVERYDAY)) for one in SHOWN])
def test_sheets_of_the_gallery_keep_the_laws(path: Path) -> None:
    leaves, standard = sheets(path.stem)
    assert list(breaches(leaves, standard)) == []


@pytest.mark.parametrize("number", [pytest.param(k, marks=marks(k, RANDOM)) for k in (*RANDOM, *OTHERS)])
def test_sheets_of_random_scenes_keep_the_laws(number: int) -> None:
    made, leaves = drawn(1, number)
    assert not leaves or list(breaches(leaves, parse_scene(made.text).sheet.standard)) == []  # else it is refused


def sheet(name: str, kind: str) -> Leaf:
    return sheets(name)[0][kind][0]


def plus(name: str, *strokes: Stroke) -> Change:
    """Add strokes to a part of a sheet."""
    return lambda one: (
        one._replace(strokes=(*one.strokes, *strokes)) if isinstance(one, Group) and one.name == name else one
    )


def each(kind: type[Stroke], change: Callable[..., Stroke]) -> Change:
    return lambda one: change(one) if isinstance(one, kind) else one


def more(kind: type[Stroke], field: str, by: float) -> Change:
    return each(kind, lambda one: one._replace(**{field: getattr(one, field) + by}))


def pen(width: float) -> Change:
    return each(Line, lambda one: one._replace(style=one.style._replace(width=width)))


def longer(one: Line) -> Line:
    return one._replace(end=one.start + 1.1 * (one.end - one.start))


def larger(one: Fill) -> Fill:
    return one._replace(points=tuple(one.points[0] + 1.5 * (spot - one.points[0]) for spot in one.points))


def blunter(one: Fill) -> Fill:
    tip, *back = one.points
    return one._replace(points=(tip, *(sum(back) / 2 + 1.5 * (spot - sum(back) / 2) for spot in back)))


def bent(one: Polyline) -> Polyline:
    return one._replace(points=(one.points[0] + 1, *one.points[1:])) if len(one.points) == 4 else one


OVER = Text(200 + 200j, "B"), Line(190 + 201j, 220 + 201j)
BREACHES: Mapping[str, tuple[object, str, Change]] = {
    "a head too large": (arrows, "forces", in_part("scheme-2-3-2", each(Fill, larger))),
    "a blunt head of a long vector": (arrows, "forces", in_part("forces-2-3-2", each(Fill, blunter))),
    "a vector longer than to its head": (arrows, "forces", in_part("forces-2-3-2", each(Line, longer))),
    "a force off its image": (arrows, "forces", in_part("lever-2", more(Circle, "centre", 1))),
    "a tick of the bar aside": (bar, "forces", in_part("control-bar", more(Line, "start", 1))),
    "a bar too long": (bar, "forces", in_part("control-bar", each(Line, longer))),
    "a text over a line": (lettering, "forces", plus("scheme-2-3-2", *OVER)),
    "a text covered": (lettering, "forces", plus("notes", Fill((0j, 800 + 0j, 800 + 300j, 300j), WHITE))),
    "a side of a polygon too long": (polygons, "forces", stretched("R_03", "forces-2-3", 1.5)),
    "a letter twice": (repeats, "forces", plus("scheme-2-3-2", OVER[0], OVER[0])),
    "a block out of square": (symbols, "kinematics", in_part("positions", each(Polyline, bent))),
    "a hinge too small": (symbols, "kinematics", in_part("positions", more(Circle, "radius", -0.2))),
    "a line by a pen of no hand": (widths, "kinematics", in_part("shown-position", pen(0.3))),
    "a long force drawn thin": (widths, "forces", in_part("forces-2-3-2", pen(0.35))),
    "a position shown thin": (widths, "kinematics", in_part("shown-position", pen(0.35))),
}


@pytest.mark.parametrize(("law", "kind", "change"), BREACHES.values(), ids=BREACHES)
def test_a_breach_is_found(law: object, kind: str, change: Change) -> None:
    leaf = sheet("slider-crank", kind)
    spoilt = changed(leaf, change)
    assert spoilt != leaf
    assert list(breaches({kind: [spoilt]}, "GOST", [law])) != []


def test_letters_that_are_exchanged_are_found() -> None:
    leaf = sheet("four-masses", "rotor")
    swap = {"m1": "m_{2}", "m2": "m_{1}"}
    spoilt = changed(leaf, each(Text, lambda one: one._replace(content=swap.get(one.plain, one.content))))
    assert spoilt != leaf
    assert list(breaches({"rotor": [spoilt]}, "GOST", [letters])) != []


@pytest.mark.parametrize(
    ("text", "wrong"),
    [("v = 1.5 м/с", True), ("v = 1,5 м/с", False), ("ГОСТ 2.304-81", False), ("(8.5)", False), ("G6.3", False)],
)
def test_a_decimal_point_is_one_in_a_number(text: str, wrong: bool) -> None:
    assert lettering.has_point(text) is wrong
