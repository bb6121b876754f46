"""The kinematic diagrams on a sheet of their own: no letter is touched, and their poles stand on the paper."""

from __future__ import annotations

from functools import cache, partial

import pytest

from drawings.figures.diagrams import kinematic_diagrams
from drawings.figures.diagrams.diagram_notes import diagram_notes
from drawings.figures.diagrams.frame import NAME
from drawings.figures.diagrams.output_table import output_table
from drawings.layout.contents import Panel
from drawings.page.drafting import drafting_of
from drawings.page.page import page_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, Exhibit
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.collisions import collisions
from tests.gallery import GALLERY
from tests.parts import first

# A slider, a crank that gathers speed, one that swings, outputs that turn to and fro and fully.
SCENES = ("slider-crank", "shaper", "tangent", "squeezer")
DRAWN = ("positions", "velocities", "accelerations", "diagrams")


@cache
def study_of(name: str) -> Study:
    return Study(read_scene(GALLERY / f"{name}.toml"), ("extremes", *DRAWN))


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


@pytest.mark.parametrize("name", first(SCENES))
def test_what_is_drawn_touches_no_letter(name: str) -> None:
    assert [found for leaf in leaves(study_of(name)) for found in collisions(leaf)] == []


@pytest.mark.rest
def test_the_poles_of_a_part_of_a_turn_stand_on_the_paper() -> None:
    """What goes forth alone wants poles far from its axis, though the graphs be as high as ever."""
    text = (GALLERY / "crank-rocker.toml").read_text(encoding="utf-8").partition("[sheet]")[0]
    swing = text.replace('start = "extreme"\npositions = 12', "positions = [40, 50, 60, 70, 80]\n[output]\npoint = 'B'")
    study = Study(
        parse_scene(swing.replace('sheets = ["kinematics", "forces"]', "").replace("forces = [2]", "")), DRAWN
    )
    leaf, field = leaves(study)[0], page_of(study.scene).field
    poles = [mark.at for mark in texts(leaf.groups) if mark.plain in ("P1", "P2", "H1", "H2")]
    assert len(poles) == 4
    heads = [text.plain for text in texts(leaf.groups)]
    assert "Kinematic diagrams of link 3" in heads, "an angle is that of a link, though the output be told by its point"
    assert all(field.left < at.real < field.right and field.bottom < at.imag < field.top for at in poles)
