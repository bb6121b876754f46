"""A drawn file is held against the kept one: the last digits of another processor are nothing, all else is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from drawings.gallery.changes import differences

LETTER = '<path d="M10 20l.14 3.15" data-text="1.25" stroke="#000000"/>'
POINT = '<circle cx="5" cy="6" r="0.5" data-value="0.0123456789012" data-name="S1"/>'
SHEET = f"""<svg><title>Fan</title><g id="view">{LETTER}{POINT}</g>
<metadata id="seal">{{"sha256": "12"}}</metadata></svg>"""
REPORT = """| v_B | 0,1234567890 | 2 | 7654321 |
## Сравнение построения
| v_B | 1e-16 | 0,5 |
## Обусловленность
| 1,5 |
"""


def told(tmp_path: Path, name: str, kept: str, change: tuple[str, str]) -> list[str]:
    paths = tmp_path / "fresh" / name, tmp_path / "kept" / name
    assert change[0] in kept
    for path, text in zip(paths, (kept.replace(*change), kept), strict=True):
        path.parent.mkdir()
        path.write_text(text, "utf-8")
    return list(differences(*paths))


@pytest.mark.parametrize(
    "change", [("M10 ", "M10.001 "), (".14", ".141"), ("89012", "89013"), ('"12"', '"13"')], ids=lambda pair: pair[1]
)
def test_the_last_digits_of_a_sheet_are_no_difference(tmp_path: Path, change: tuple[str, str]) -> None:
    assert told(tmp_path, "fan.svg", SHEET, change) == []


@pytest.mark.parametrize(
    "change",
    [
        *(("M10 ", "M10.003 "), (".14", "-.14"), ("l.14", "L.14"), ("1.25", "1.26"), ("#000000", "#000001")),
        *(("S1", "S2"), ("0.0123456", "0.0123457"), ("Fan", "Fun"), (' r="0.5"', ""), ("circle", "ellipse")),
        *(('id="view"', 'id="view-1"'), ("</g>", '</g><path d="M1 1"/>')),
    ],
    ids=lambda pair: pair[1],
)
def test_any_other_difference_of_a_sheet_is_told(tmp_path: Path, change: tuple[str, str]) -> None:
    found = told(tmp_path, "fan.svg", SHEET, change)
    assert found and all(one.startswith("fan.svg: ") for one in found)


def test_strokes_in_another_order_are_told(tmp_path: Path) -> None:
    assert told(tmp_path, "fan.svg", SHEET, (LETTER + POINT, POINT + LETTER))


@pytest.mark.parametrize(
    "change", [("567890", "567892"), ("7654321", "7654322"), ("1e-16", "3.5e-17"), ("| 0,5", "| 0,61")]
)
def test_the_last_digits_of_a_report_and_its_measures_of_rounding_are_no_difference(
    tmp_path: Path, change: tuple[str, str]
) -> None:
    assert told(tmp_path, "fan-report.md", REPORT, change) == []


@pytest.mark.parametrize(
    "change", [("567890", "567893"), ("| 2 |", "| 3 |"), ("v_B | 0", "v_C | 0"), ("| 1,5 |\n", ""), ("1,5", "-1,5")]
)
def test_any_other_difference_of_a_report_is_told(tmp_path: Path, change: tuple[str, str]) -> None:
    assert len(told(tmp_path, "fan-report.md", REPORT, change)) == 1


def test_a_file_that_was_not_kept_is_told(tmp_path: Path) -> None:
    (tmp_path / "fan.svg").write_text(SHEET, "utf-8")
    assert list(differences(tmp_path / "fan.svg", tmp_path / "kept.svg")) == ["kept.svg: came"]
