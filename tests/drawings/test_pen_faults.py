"""What the pen writes is what was laid out: a specimen with every kind of line and letter, and faults of the pen.

The table is tests/cases/pen_faults.toml.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from pathlib import Path

import pytest

from drawings.checks.verify import SelfCheckFailed, verify
from drawings.eye.sheet import SeenSheet
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import (
    INK,
    Arc,
    Circle,
    Curve,
    Fill,
    Group,
    Leaf,
    Line,
    LineStyle,
    Polyline,
    Stroke,
    Text,
    stated,
)
from drawings.pens.svg import svg
from geometry.curve import CubicPiece, RoundPiece
from plans.words.words import said
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "pen_faults.toml")
MAIN, THIN, DASHED = LineStyle(0.5), LineStyle(0.25), LineStyle(0.25, (4.0, 1.5))
SCALE = {"plan": "velocities", "quantity": "v", "scale": "0.01", "unit": "m/s"}


def vector(name: str, start: complex, end: complex) -> Group:
    head = tuple(end + cmath.rect(size, cmath.phase(end - start) + turn) for size, turn in ((0, 0), (3, 2.9), (3, 3.4)))
    data = {"kind": "vector", "name": name, "value": stated((end - start) * 0.01), **SCALE}
    return Group((Line(start, end, MAIN), Fill(head)), data=data, title=name)


def lettering() -> tuple[Stroke, ...]:
    """Texts of every kind: on levels, slanted, centred, turned, with accents, in both scripts."""
    return (
        Text(60 + 120j, "План скоростей, положение 3", 5.0, anchor="middle", slanted=True),
        Text(70 + 110j, "v_{BA} = 0,375 м/с²;  a^n_{3} = −13.8", 3.5, slanted=True),
        Text(60 + 100j, "№ 38: Ø25 h6 (G\u0304_5)", 2.5, anchor="end"),
        Text(10 + 60j, "Подп. и дата", 2.5, rotation=90.0),
        Text(100 + 60j, "38° — 83°", 3.5, rotation=50.0),
        Text(100 + 20j, "TMM.03.08.00", 5.0, slanted=True, rotation=180.0),
    )


def specimen() -> Leaf:
    """Lay out a sheet with every kind of line and letter."""
    pole = Group((Circle(40 + 40j, 0.6, MAIN),), data={"kind": "pole", "name": "p", "value": "0 0", **SCALE})
    bend = CubicPiece(90 + 70j, 95 + 80j, 105 + 80j, 110 + 72j)
    lines = (
        Polyline((0j, 148j, 210 + 148j, 210 + 0j), closed=True, style=LineStyle(0.25, fill="#ffffff")),
        Line(5 + 5j, 205 + 5j, LineStyle(0.7, cap="round")),
        Polyline((20 + 20j, 30 + 27j, 41 + 22j, 55 + 33j), style=DASHED),
        Arc(150 + 60j, 20.0, 0.3, 5.2, MAIN),
        Arc(150 + 60j, 30.0, 0.2, 1.4, DASHED),
        Circle(180 + 100j, 7.5, LineStyle(0.5, fill="#ffffff")),
        Fill((180 + 100j, 184 + 101j, 184 + 99j)),
        Curve((bend, RoundPiece(bend.end, 110 + 62j, -math.pi * 0.75)), style=MAIN),
        Curve((CubicPiece(120 + 20j, 125 + 35j, 140 + 35j, 150 + 20j),), style=THIN),
    )
    plan = Group((pole, vector("p b", 40 + 40j, 62 + 51j), vector("b c", 62 + 51j, 58 + 66j)), "velocities")
    texts = Group((Line(60 + 98j, 20 + 98j, THIN), Group(lettering()), *lettering()[:1]), "table", title="Table")
    letters = Group((Text(63 + 52j, "b"), Text(59 + 67j, "c"), Text(36 + 36j, "p")), "letters")
    return Leaf(210.0, 148.0, (Group(lines, "frame"), plan, texts, letters), "Specimen", "Every kind of line")


def drawn(leaf: Leaf, mode: str, folder: Path) -> SeenSheet:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf, mode)))
    return verify(path, leaf, lambda measured, seen: ())


@pytest.mark.parametrize("mode", ["strokes", "text"])
def test_the_specimen_is_seen_as_it_was_laid_out(mode: str, tmp_path: Path) -> None:
    seen = drawn(specimen(), mode, tmp_path)
    assert seen.unseen == ()
    assert seen.leaf.lettering == mode


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
def test_a_fault_of_the_pen_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        drawn(specimen(), fault.sheet, tmp_path)
    assert fault.says in str(told.value)
    assert fault.says not in said(told.value, "ru")


def test_ink_of_another_colour_is_another_line(tmp_path: Path) -> None:
    leaf = specimen()
    grey = replace(leaf, groups=(*leaf.groups[:-1], Group((Text(63 + 52j, "b", style=INK._replace(fill="#333333")),))))
    path = tmp_path / "sheet.svg"
    path.write_bytes(svg(lettered(grey)))
    with pytest.raises(SelfCheckFailed):
        verify(path, leaf, lambda measured, seen: ())
