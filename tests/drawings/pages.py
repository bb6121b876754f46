"""Every page that the standards have, drawn bare; and what is measured on it."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator

import pytest

from drawings.lettering.lettering import outline
from drawings.page.page import Page
from drawings.paper import walk
from drawings.paper.strokes import Box, Group, Line, Polyline, Stroke, Text
from tests.parts import some

# Which way each standard lays a format: A4 upright only, and by ISO 5457 all others along the long side only.
LAID = [
    (name, orientation, standard)
    for name, orientation, standard in itertools.product(
        ("A1", "A2", "A3", "A4"), ("landscape", "portrait"), ("GOST", "ISO")
    )
    if (orientation == "portrait" if name == "A4" else standard == "GOST" or orientation == "landscape")
]
PAGES = [
    Page(name, orientation, standard, language, "ТММ.07.03.000")
    for (name, orientation, standard), language in itertools.product(LAID, ("en", "ru"))
]
ENTRIES = {
    "en": {
        "title": "Crank shaper", "subtitle": "Kinematics of the mechanism", "designation": "TMM.07.03.000",
        "drawn": "Ivanov A. A.", "checked": "Preobrazhensky", "approved": "Smith", "date": "2026-11-21",
        "group": "M-301", "organisation": "Technical University, Department of Mechanisms", "scale": "1:2.5",
        "sheet": "2", "sheets": "14",
    },
    "ru": {
        "title": "Поперечно-строгальный станок", "subtitle": "Кинематическое исследование механизма",
        "designation": "ТММ.07.03.000", "drawn": "Щукин Й. Ё.", "checked": "Преображенский", "approved": "Утёсов",
        "date": "21.11.2026", "group": "Группа РК5-51", "organisation": "МГТУ им. Н.Э. Баумана, кафедра ТММ",
        "scale": "1:2,5", "sheet": "1", "sheets": "1",
    },
}  # fmt: skip
every_page = pytest.mark.parametrize(
    "page", some(PAGES, 3), ids=lambda p: f"{p.name}-{p.orientation}-{p.standard}-{p.language}"
)


def bare(page: Page, **entries: str) -> Group:
    """Draw a page without figures."""
    block = page.title_block(ENTRIES[page.language] | entries, page.language)
    return Group((page.frame(), page.corners(), block))


def flat(stroke: Stroke) -> list[Stroke]:
    return [*walk.flat((stroke,))]


def texts(stroke: Stroke) -> list[Text]:
    return [*walk.texts((stroke,))]


def said(stroke: Stroke) -> list[str]:
    return [text.plain for text in texts(stroke)]


def named(stroke: Stroke, name: str) -> Group:
    found = walk.group_named((stroke,), name)
    assert found is not None
    return found


def around(points: Iterable[complex], by: float) -> Box:
    points = list(points)
    across, up = [p.real for p in points], [p.imag for p in points]
    return min(across) - by, min(up) - by, max(across) + by, max(up) + by


def inked(text: Text) -> Box:
    """The box of the letters themselves, with tails, accents and the pen."""
    return around((point for chain in outline(text) for point in chain.points), text.size / 20)


def lines(stroke: Stroke) -> Iterator[tuple[Box, float]]:
    """Every straight piece of line with its width in its box; all of a page's lines are upright or level."""
    for one in flat(stroke):
        match one:
            case Line():
                ends = [(one.start, one.end)]
            case Polyline():
                ends = list(itertools.pairwise((*one.points, one.points[0])))
            case _:
                continue
        for start, end in ends:
            yield around((start, end), one.style.width / 2), one.style.width


def apart(a: Box, b: Box) -> bool:
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def inside(inner: Box, outer: Box) -> bool:
    return inner[0] >= outer[0] and inner[1] >= outer[1] and inner[2] <= outer[2] and inner[3] <= outer[3]
