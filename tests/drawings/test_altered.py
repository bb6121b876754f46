"""Of every kind that a sheet states, what is drawn or written a little otherwise is told by its statement."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import pytest

from drawings.checks import hold
from drawings.checks.expected import Expected
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Arc, Fill, Group, Key, Kind, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat, groups
from drawings.pens.svg import svg
from drawings.reading.items import brought
from drawings.reading.measure import measure
from drawings.reading.transform import Affine
from drawings.sheets.documents import leaves_of
from drawings.sheets.kind import sheet_kind
from plans.scene.scene import read_scene
from plans.study import Study
from tests import parts
from tests.drawings.slips import changed, shifted
from tests.gallery import SCENES

ASIDE = Affine(1 + 0j, 0j, 0.3 + 0.4j)  # half a millimetre
EVERYDAY = ("fan", "slider-crank")


def moved(stroke: Stroke) -> Stroke:
    return brought(stroke, ASIDE)


def last_moved(group: Group) -> Group:
    """Move the last arrowhead of a dimension along it, else the end of its line."""
    heads = [one for one in flat((group,)) if isinstance(one, Fill)]
    line = next(one for one in flat((group,)) if isinstance(one, Line))
    along = (line.end - line.start) / abs(line.end - line.start) / 2
    longer = line._replace(end=line.end + along)
    by = {id(heads[-1]): brought(heads[-1], Affine(1 + 0j, 0j, along))} if heads else {id(line): longer}
    return within(group, lambda one: by.get(id(one), one))


def opened(group: Group) -> Group:
    """Draw an angle too wide: its last arrowhead further about its centre, or its arcs further where it has not two."""
    arcs = [one for one in flat((group,)) if isinstance(one, Arc)]
    heads = [one for one in flat((group,)) if isinstance(one, Fill)]
    further, about = cmath.rect(1.0, 0.02), arcs[0].centre
    wider = {id(one): one._replace(end_angle=one.end_angle + 0.02) for one in arcs}
    last = {id(heads[-1]): brought(heads[-1], Affine(further, 0j, about * (1 - further)))} if len(heads) == 2 else wider
    return within(group, lambda one: last.get(id(one), one))


def turned_head(stroke: Stroke) -> Stroke:
    """Let an arrowhead look the other way."""
    if isinstance(stroke, Fill | Polyline) and len(stroke.points) == 3:
        middle = sum(stroke.points) / 3
        return stroke._replace(points=tuple(2 * middle - point for point in stroke.points))
    return stroke


def misread(stroke: Stroke) -> Stroke:
    """Write the first digit of a text otherwise."""
    if not isinstance(stroke, Text) or not isinstance(stroke.content, str):
        return stroke
    place = next((k for k, sign in enumerate(stroke.content) if sign in "123456789"), None)
    if place is None:
        return stroke
    digit = str(int(stroke.content[place]) % 9 + 1)
    return stroke._replace(content=stroke.content[:place] + digit + stroke.content[place + 1 :])


def within(group: Group, change: Callable[[Stroke], Stroke]) -> Group:
    return changed(Leaf(1.0, 1.0, (group,)), change).groups[0]


def longer(stroke: Stroke) -> Stroke:
    return stroke._replace(end=stroke.end + ASIDE.t) if isinstance(stroke, Line) else stroke


ALTERED: Mapping[Kind, Callable[[Group], Group]] = {
    Kind.VECTOR: lambda group: within(group, longer),
    Kind.POINT: lambda group: within(group, lambda one: one if isinstance(one, Group) else moved(one)),
    Kind.CURVE: lambda group: within(group, lambda one: one if isinstance(one, Group) else moved(one)),
    Kind.LENGTH: last_moved,
    Kind.ANGLE: opened,
    Kind.DIRECTION: lambda group: within(group, turned_head),
    Kind.NUMBER: lambda group: within(group, misread),
    Kind.LETTER: lambda group: within(
        group, lambda one: one._replace(content="Ж") if isinstance(one, Text) else one
    ),
}  # fmt: skip


def chosen(leaf: Leaf, due: Mapping[Key, Expected]) -> Iterator[tuple[Key, Group, Group]]:
    """Choose what is altered: of each kind the first that is held closely, and how it is then."""
    known: set[Kind] = set()
    for group in groups(leaf.groups):
        for key in hold._keys(group):
            row = due.get(key)
            if row is None or key[0] in known or key[0] not in ALTERED or not close(row):
                continue
            kind, plan, name, _ = key
            mark = group.states is None
            if mark and kind is Kind.CURVE:  # a profile is measured from where it says that it begins
                continue
            other = shifted(name, plan, ASIDE.t)(group) if mark else ALTERED[kind](group)
            if other != group:
                known.add(kind)
                assert isinstance(other, Group)
                yield key, group, other


def close(row: Expected) -> bool:
    """Tell whether a row is held closely: by a text, a curve, or a number that rounding does not hide."""
    single = isinstance(row.value, complex | float | int)
    return row.allowed < math.inf and (not single or row.allowed <= 1e-4 * abs(row.value))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(one, id=one.stem, marks=() if one.stem in EVERYDAY else pytest.mark.rest)
        for one in SCENES
        if parts.whole or one.stem in EVERYDAY
    ],
)
def test_what_is_altered_is_told(path: Path) -> None:
    study, tried = Study(read_scene(path)), []
    for kind, leaves in leaves_of(study).items():
        due = {row.key: row for row in sheet_kind(kind).expected(study, leaves)}
        for leaf in leaves:
            own = [*chosen(leaf, due)]
            others = {id(group): other for _, group, other in own}
            spoilt = changed(leaf, lambda one, others=others: others.get(id(one), one))
            told = {*hold.faults(hold.readings(measure(svg(lettered(spoilt))), spoilt), due)}
            assert {hold.wrong("differs_on", key) for key, _, _ in own} <= told
            tried += own
    assert tried
