"""The catalogue's rows about what is inked: curves through drawn points only, and no meaning by colour alone."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).parent.parent.parent
SHEETS = sorted((ROOT / "drawings/gallery").glob("*-kinematics.svg"))


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.stem)
def test_e21_no_curve_runs_beyond_the_points_that_were_constructed(sheet: Path) -> None:
    """Trajectories are chains of straight lines and arcs: a spline would overshoot at a cusp. Letters are curves."""
    drawn = ElementTree.fromstring(sheet.read_text("utf-8"))
    written = {path for text in drawn.iterfind(".//*[@data-text]") for path in text.iter()}
    chains = [path.get("d", "") for path in drawn.iter() if path not in written]
    commands = set(re.findall("[A-Za-z]", " ".join(chains)))
    assert commands & set("Aa") and commands & set("Ll")
    assert commands <= set("MmLlHhVvAaZz")


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.stem)
def test_k18_all_lines_are_black(sheet: Path) -> None:
    ink = set(re.findall(r'(?:stroke|fill)(?:="|:\s*)([^;"]*)', sheet.read_text("utf-8")))
    assert ink <= {"none", "black", "#000", "#000000", "white", "#fff", "#ffffff", "currentColor"}
