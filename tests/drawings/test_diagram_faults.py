"""The kinematic diagrams are held to the analysis: what is drawn passes, faults planted into the drawing withhold it.

The table is tests/cases/diagram_faults.toml; a sheet is laid out that shows the diagrams alone.
"""

from __future__ import annotations

from functools import cache, partial
from pathlib import Path

import pytest
from drawings.checks.diagrams.verify_diagrams import faults

from drawings.checks.verify import SelfCheckFailed, verify
from drawings.figures.diagrams import kinematic_diagrams
from drawings.figures.diagrams.diagram_notes import diagram_notes
from drawings.figures.diagrams.frame import NAME
from drawings.figures.diagrams.output_table import output_table
from drawings.layout.contents import Panel
from drawings.lettering.lettering import lettered
from drawings.page.drafting import drafting_of
from drawings.page.page import page_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from drawings.pens.svg import svg
from drawings.sheets.draft import Draft, Exhibit
from drawings.sheets.leaves import lay_out
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.collisions import collisions
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "diagram_faults.toml")
# A slider, a crank that gathers speed, one that swings, outputs that turn to and fro and fully.
SCENES = ("slider-crank", "shaper", "tangent", "squeezer")


@cache
def study_of(name: str) -> Study:
    return Study(read_scene(ROOT / "drawings" / "gallery" / f"{name}.toml"), ("extremes", *DRAWN))


DRAWN = ("positions", "velocities", "accelerations", "diagrams")


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out a sheet of the diagrams, the table and the notes."""
    own, drafting = study["diagrams"], drafting_of(study.scene)
    figure = Exhibit(
        Panel(kinematic_diagrams.measure(own, drafting)), partial(kinematic_diagrams.draw, own, drafting=drafting)
    )
    draft = Draft(
        "kinematics",
        "",
        (figure,),
        (output_table(own, drafting),),
        tuple(diagram_notes(own, drafting)),
        lambda names: {"diagrams": NAME in names},
    )
    return lay_out(study.scene, [draft])


def checked(leaf: Leaf, study: Study, folder: Path) -> None:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    verify(path, leaf, partial(faults, study=study))


@pytest.mark.parametrize("name", first(SCENES))
def test_what_is_drawn_agrees_with_the_analysis_and_touches_no_letter(name: str, tmp_path: Path) -> None:
    study = study_of(name)
    for leaf in leaves(study):
        checked(leaf, study, tmp_path)
        assert collisions(leaf) == []


@pytest.mark.rest
def test_the_poles_of_a_part_of_a_turn_stand_on_the_paper(tmp_path: Path) -> None:
    """What goes forth alone wants poles far from its axis, though the graphs be as high as ever."""
    text = (ROOT / "drawings" / "gallery" / "crank-rocker.toml").read_text(encoding="utf-8").partition("[sheet]")[0]
    swing = text.replace('start = "extreme"\npositions = 12', "positions = [40, 50, 60, 70, 80]\n[output]\npoint = 'B'")
    study = Study(
        parse_scene(swing.replace('sheets = ["kinematics", "forces"]', "").replace("forces = [2]", "")), DRAWN
    )
    leaf, field = leaves(study)[0], page_of(study.scene).field
    checked(leaf, study, tmp_path)
    poles = [mark.at for mark in texts(leaf.groups) if mark.plain in ("P1", "P2", "H1", "H2")]
    assert len(poles) == 4
    heads = [text.plain for text in texts(leaf.groups)]
    assert "Kinematic diagrams of link 3" in heads, "an angle is that of a link, though the output be told by its point"
    assert all(field.left < at.real < field.right and field.bottom < at.imag < field.top for at in poles)


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene)
    assert study.comparison("diagrams").worst <= 1.0
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        for leaf in leaves(study):
            checked(leaf, study, tmp_path)
    assert fault.says in str(told.value)
    assert "against the analysis" not in said(told.value, "ru")
