"""The composer: what a sheet asks for by weight, by scale, by tables; and that every figure is asked alike."""

from __future__ import annotations

import importlib
import inspect
from itertools import combinations
from pathlib import Path

import pytest

from drawings.layout.composer import compose
from drawings.layout.contents import Contents, Panel
from drawings.layout.picture import Margins, Picture, picture
from drawings.layout.table import TableRow, table
from drawings.page.page import Field, Page

ROOT = Path(__file__).parent.parent.parent
FIGURES = [
    path.relative_to(ROOT).with_suffix("").as_posix().replace("/", ".")
    for path in sorted((ROOT / "drawings/figures").rglob("*.py"))
]


def figure(name: str, wide: float, high: float) -> Picture:
    return picture(name, [0j, complex(wide, high)], ("l", "m"), Margins(12.0, 10.0, 30.0), 70.0, 40.0)


def apart(one: Field, other: Field) -> bool:
    slack = 1e-6
    beside = one.right <= other.left + slack or other.right <= one.left + slack
    return beside or one.top <= other.bottom + slack or other.top <= one.bottom + slack


@pytest.mark.parametrize("page", [Page("A1"), Page("A2"), Page("A4")], ids=lambda page: page.name)
def test_figures_of_one_scale_are_drawn_at_one_that_fits_them_all(page: Page) -> None:
    views = figure("along", 0.1, 0.1), figure("across", 1.4, 0.3)
    free = compose(Contents(tuple(map(Panel, views))), page)
    one = compose(Contents(tuple(Panel(view, scale="rotor") for view in views)), page)
    scales = {name: spot.scale.mu for sheet in free for name, spot in sheet.spots.items()}
    shared = {spot.scale.mu for sheet in one for spot in sheet.spots.values()}
    assert scales["along"] != scales["across"] and shared == {max(scales.values())}


def test_a_figure_of_more_weight_is_drawn_larger() -> None:
    three = [figure(name, 1.0, 1.0) for name in "abc"]
    sizes = []
    for weight in (1.0, 4.0):
        (sheet,) = compose(
            Contents((Panel(three[0], weight, "one"), Panel(three[1]), Panel(three[2], 1.0, "one"))), Page("A2")
        )
        sizes.append(three[0].extent(sheet.spots["a"].scale) / three[1].extent(sheet.spots["b"].scale))
    assert sizes[1] > sizes[0]


def test_further_tables_stand_among_the_figures_and_on_nothing() -> None:
    lines = [TableRow(f"R_{k}", ("1.00", "2.00")) for k in range(6)]
    tables = tuple(table(lines[:k], "quantity", ("m, kg", "D, mm"), 3.5)._replace(name=f"table-{k}") for k in (6, 4, 2))
    (sheet,) = compose(Contents((Panel(figure("a", 1.0, 1.0)), Panel(figure("b", 1.0, 0.5))), tables), Page("A2"))
    assert {one.table.name for one in sheet.tables} == {"table-6", "table-4", "table-2"} and not sheet.blocks
    boxes = [spot.box for spot in sheet.spots.values()]
    for own, corner, setting in sheet.tables:
        wide, high = own.size(setting)
        boxes.append(Field(corner.real, corner.imag - high, corner.real + wide, corner.imag))
    assert all(apart(one, other) for one, other in combinations([*boxes, Page("A2").block], 2))


def test_panels_of_one_key_stand_together_wherever_they_are_named() -> None:
    a, b, c, d = (
        Panel(figure(name, 1.0, 1.0), together=key) for name, key in zip("abcd", ("1", "2", "1", ""), strict=True)
    )
    assert Contents((a, b, c, d)).groups == ((a, c), (b,), (d,))


def test_every_file_of_a_figure_measures_and_draws_it_alike() -> None:
    for name in FIGURES:
        module = importlib.import_module(name)
        draw = getattr(module, "draw", None)
        if draw is not None and draw.__module__ == name:
            assert list(inspect.signature(draw).parameters)[-2:] == ["spot", "drafting"], name
            assert list(inspect.signature(module.measure).parameters)[-1] == "drafting", name
            assert {"lines", "letter"} <= {*dir(_returned(draw)), *_returned(draw).__annotations__}, name


def _returned(draw: object) -> type:
    return inspect.get_annotations(draw, eval_str=True)["return"]  # type: ignore[arg-type, no-any-return]
