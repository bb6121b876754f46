"""Numbers as students write them in cells: powers, prefixes and units of either language, and what is no number."""

from __future__ import annotations

import math

from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.graded import SheetTask, grade
from drawings.grading.written_number import number
from drawings.paper.strokes import Text
from tests.drawings.cell_students import key_of, tables_of, written
from tests.drawings.students import task
from tests.rows import over

READ = [
    ("65451 g·mm", "kg·m", 0.065451), ("65451 г*мм", "кг·м", 0.065451), ("3 kg·mm", "kg·m", 0.003),
    ("654.51 g", "kg", 0.65451), ("5 N·mm", "N·m", 0.005), ("5 kNm", "N·m", 5000.0), ("15000 mm²", "m²", 0.015),
    ("15000 mm^2", "m2", 0.015), ("0.3 g m²", "kg·m²", 3e-4), ("0,3 кгм^2", "кг·м²", 0.3), ("7 м/с^2", "м/с²", 7.0),
    ("7 m·s^-2", "m/s²", 7.0), ("−2,59 1/s", "рад/с", -2.59), ("60 об/мин", "рад/с", 2 * math.pi),
    ("60 min-1", "rad/s", 2 * math.pi), ("30°15'", "°", 30.25), ("-30° 30'", "rad", -30.5 * math.pi / 180),
    ("1.52 10^-3", "m", 0.00152), ("1,52·10⁻³ m", "m", 0.00152), ("1.52*10^(-3)", "m", 0.00152),
    ("1.52e-3", "m", 0.00152), ("12 345,5", "m", 12345.5), (".5", "m", 0.5),
]  # fmt: skip
UNCLEAR = [("5 ells", "m"), ("5 N", "N·m"), ("5 m", ""), ("5 m2", "m"), ("5 kg", "m/s")]
NO_NUMBER = ["", "big", "0.0000 9.99", "0.5 999", "1,5-2", "1/2", "1,234.5", "2×3", "1.5 2", "5-", "1.2.3", "1:2"]


@over("row", READ)
def test_a_number_is_read_in_the_unit_of_its_column(row: tuple[str, str, float]) -> None:
    text, unit, value = row
    found = number([Text(0j, text)], unit)
    assert found is not None
    assert math.isclose(found.value, value, rel_tol=1e-12)


@over("row", UNCLEAR)
def test_a_unit_that_is_not_understood_is_never_the_due_one(row: tuple[str, str]) -> None:
    found = number([Text(0j, row[0])], row[1])
    assert found is not None and not found.understood


@over("text", NO_NUMBER)
def test_two_numbers_are_none(text: str) -> None:
    assert number([Text(0j, text)], "m") is None


def test_a_cell_with_a_unit_that_is_not_understood_is_told() -> None:
    own = task("shaper")
    table, sheet = own.table("values"), own.originals.sheets[0]
    texts = {key_of(table, "vB", "by plan", 2): "1.517 kn", key_of(table, "vD", "by plan", 2): "1.492 9.99"}
    assert kinds(own.tables, written(tables_of(sheet), table, texts)) == {
        "v_B (by plan)": "illegible",
        "v_D (by plan)": "wrong",
    }


def kinds(tables: tuple[TableAsked, ...], source: bytes) -> dict[str, str]:
    return {
        one.name: one.kind for one in grade(source, SheetTask(tables=tables), Allowances()).verdicts if not one.good
    }
