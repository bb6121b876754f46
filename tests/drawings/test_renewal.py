"""A renewal of the gallery tells by statement what it changes; it is kept for a reason alone, and is to be listed."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from drawings.gallery import __main__ as command
from drawings.gallery.catalogue import GALLERY
from drawings.gallery.changes import LIST, changes, enter, listed, unlisted

NAME = "flywheel"
SHEET, REPORT = f"{NAME}-rotor.svg", f"{NAME}-report.md"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A gallery of one scene, listed as it is."""
    for path in (*GALLERY.glob(f"{NAME}[.-]*"), GALLERY / "alphabet.svg"):
        shutil.copyfile(path, tmp_path / path.name)
    enter(tmp_path, "as it was")
    return tmp_path


def edited(path: Path, old: str, new: str) -> Path:
    text = path.read_text("utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), "utf-8")
    return path


# What a renewal tells


def test_nothing_is_told_of_what_stays(folder: Path) -> None:
    assert [*changes(folder / SHEET, GALLERY / SHEET), *changes(folder / REPORT, GALLERY / REPORT)] == []


@pytest.mark.parametrize(
    "old, new, told",
    [
        ("M330.455 139.375", "M330.455 143.375", "letter φ = 0 on along: moved by 4 mm"),  # where it begins
        ('cx="311.986"', 'cx="312.9860"', "point m_1 on along: moved by 1 mm"),
        ('data-text="φ = 0"', 'data-text="φ = 1"', "data-text of element 263: φ = 0 -> φ = 1; nothing that is seen"),
        ("L259.8117 166.85", "L259.8117 169.85", "strokes of along: 1 end by up to 3 mm"),
    ],
)
def test_a_sheet_tells_what_changed_on_which_figure(folder: Path, old: str, new: str, told: str) -> None:
    assert changes(edited(folder / SHEET, old, new), GALLERY / SHEET) == [f"{SHEET}: {told}"]


def test_a_report_tells_what_changed_from_what_to_what(folder: Path) -> None:
    (told,) = changes(edited(folder / REPORT, "0.096", "0.069"), GALLERY / REPORT)
    assert told.startswith(f"{REPORT}: - mass 1: m·D = 0.096 ") and " -> - mass 1: m·D = 0.069 " in told


# What is kept, and listed


def test_without_a_reason_nothing_is_kept(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edited(folder / REPORT, "0.096", "0.069")
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert command.main([str(folder)]) == command.CHANGED
    assert f"{REPORT}: - mass 1: m·D = 0.069 " in capsys.readouterr().out
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_with_a_reason_it_is_kept_and_listed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edited(folder / f"{NAME}.toml", "angle = 20 ", "angle = 21 ")
    assert command.main([str(folder), "--because", "a mass was turned"]) == 0
    told = capsys.readouterr().out.splitlines()
    assert {f"{SHEET}: cell 20 on masses-1: 20 -> 21", f"{SHEET}: point m_1 on along: moved by 1.05 mm"} <= {*told}
    reasons = {name: row.because for name, row in listed(folder).items()}
    assert reasons == {"alphabet.svg": "as it was", f"{NAME}-manifest.json": "a mass was turned"}
    assert unlisted(folder) == []
    assert command.main([str(folder)]) == 0


def test_a_set_that_was_drawn_past_the_list_is_refused(folder: Path) -> None:
    assert unlisted(folder) == []
    edited(folder / f"{NAME}-manifest.json", '"sha256": "', '"sha256": "0')
    assert unlisted(folder) == [f"{NAME}-manifest.json"]
    (folder / LIST).unlink()
    assert unlisted(folder) == ["alphabet.svg", f"{NAME}-manifest.json"]


def test_a_set_that_is_listed_and_gone_is_refused(folder: Path) -> None:
    (folder / f"{NAME}-manifest.json").unlink()
    assert unlisted(folder) == [f"{NAME}-manifest.json"]
