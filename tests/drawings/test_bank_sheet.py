"""The sheets of a bank: its polygons, compensators and notes, held to the analysis on many papers."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import pytest

from drawings.figures.bank.bank_view import SIDE
from drawings.report.balance.bank_report import chapters, headline, subject
from drawings.sheets.bank import leaves, view_of
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.bank_scenes import SCENES, bank, compensator, scene
from tests.drawings.held import faults_of, measured
from tests.drawings.pages import texts
from tests.parts import first

PAPERS = (("A1", "en", "GOST"), ("A3", "ru", "ISO"), ("A4", "en", "ISO"), ("A2", "ru", "GOST"))


@cache
def study_of(name: str, size: str = "A1", language: str = "en", standard: str = "GOST") -> Study:
    return Study(parse_scene(scene(name, size, language, standard)))


@pytest.mark.rest
@pytest.mark.parametrize("case", first([(name, *paper) for paper in PAPERS for name in SCENES]))
def test_what_is_drawn_agrees_with_the_analysis(case: tuple[str, str, str, str]) -> None:
    study = study_of(*case)
    assert study.comparison("bank").worst <= 1.0
    assert faults_of(study) == []


def test_the_sheet_tells_the_textbook_s_values() -> None:
    """Methods M7.8: two masses of 0.475 kg*m, a couple of 22.8 N*m by an offset of 60 mm, 0.114 kg*m against it."""
    (leaf,) = leaves(study_of("one"))
    for told in ("F_{I} = 190 N", "F_{max} = |F_{I}|+|F_{−I}| = 380 N", "= 0.475 kg·m", "M = 22.8 N·m", "= 0.114 kg·m"):
        assert told in leaf.description
    written = [text.plain for group in leaf.groups for text in texts(group)]
    assert {"0.475", "95", "−20", "0.114"} <= set(written)


def test_places_along_the_shaft_bear_another_letter_than_the_offset() -> None:
    (leaf,) = leaves(study_of("four"))
    sizes = {text.plain.partition(" = ")[0] for group in leaf.groups for text in texts(group) if " = " in text.plain}
    assert {"h1", "h4", "z", "L"} <= sizes and not {"z1", "z4", "h"} & sizes


@pytest.mark.rest
def test_what_turns_with_the_crank_alone_is_a_counterweight_on_it() -> None:
    study = study_of("vee")
    assert faults_of(study) == []
    (leaf,) = leaves(study)
    written = {text.plain for group in leaf.groups for text in texts(group)}
    assert "Counterweight on the crank, φ = 0" in written and "Compensator of order 1, φ = 0" not in written
    assert "a counterweight on the crank itself" in leaf.description
    assert not any(text.startswith("z = ") for text in written)


@pytest.mark.rest
def test_unlike_vectors_leave_couples_that_a_counterweight_would_not() -> None:
    """Two cylinders together: what turns at their pins, 2*0.6 kg at 40 mm, is all the difference of both vectors."""
    study = study_of("unlike")
    assert faults_of(study) == []
    told = " ".join(leaf.description for leaf in leaves(study))
    assert "F_{I} and F_{−I} differ: couples by the distances of the two shafts are not counted" in told
    assert "mr_{O} = (F_{I}−F_{−I})/ω² = 0.048 kg·m\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}180°" in told


@pytest.mark.rest
def test_what_vanishes_is_said_and_has_no_arrow() -> None:
    """Six cylinders in line: orders 1, 2 and 4 close by themselves, and nothing is there to be compensated."""
    study = study_of("six")
    assert faults_of(study) == []
    sums = {
        one.name
        for leaf in leaves(study)
        for one in measured(leaf).vectors
        if "," not in one.name and one.plan.startswith("order")
    }
    assert sums == {"F_VI"}
    told = leaves(study)[0].description
    assert "Forces of order 1, 2, 4 balance one another" in told and "Moments of order 1, 2, 4, 6 balance" in told
    assert "Order 1: nothing to compensate" in told


@pytest.mark.rest
def test_what_is_too_slight_is_told_and_not_drawn() -> None:
    """Three cylinders: forces of orders 1, 2, 4 balance one another, and order 6 is 1/6700 of a cylinder's first."""
    study = study_of("three")
    assert faults_of(study) == []
    (leaf,) = leaves(study)
    assert not {"order_forces-6", "order_moments-6", "force_graph"} & set(leaf.metadata["figures"])
    assert {"order_forces-4", "order_moments-4", "moment_graph"} <= set(leaf.metadata["figures"])
    assert "Below 1/1000 of the largest, not drawn: order 6" in leaf.description
    assert "Over the turn F_{max} = 0.8806" in leaf.description


@pytest.mark.rest
def test_the_notes_say_which_polygons_are_left_out_as_mirror_images() -> None:
    """A mass that turns with the crank has no image that turns against it: order 1 is shown both ways, order 2 once."""
    study = study_of("cancelled")
    assert faults_of(study) == []
    figures = {name for leaf in leaves(study) for name in leaf.metadata["figures"]}
    assert "order_forces-1-back" in figures and "order_forces-2-back" not in figures
    told = leaves(study)[0].description
    assert "against it; of order 2, 4, 6 the latter is the mirror image in the guide, not shown" in told


@pytest.mark.rest
def test_a_bank_at_rest_in_itself_has_no_graph() -> None:
    """Two mechanisms in one place, each the other's image in the shaft: no force of any order is left."""
    study = Study(parse_scene(bank([(0, 0, 0), (180, 0, 180)], compensator(1)) + '[sheet]\nlanguage = "en"\n'))
    figures = {name for leaf in leaves(study) for name in leaf.metadata["figures"]}
    assert not figures & {"force_graph", "moment_graph", "compensator-1", "shaft"}
    assert faults_of(study) == []


def test_the_report_tells_the_bank() -> None:
    study = study_of("four")
    told = "\n".join(line for part in chapters(study, {}) for line in part)
    assert "mechanism 4: crank at 0°, place 150 mm, guide at 0°" in told
    ratio, first = 40 / 140, 0.5 * 0.04 * (100 * math.pi) ** 2
    second = first * (ratio + ratio**3 / 4 + 15 / 128 * ratio**5 + 35 / 512 * ratio**7)  # the beginning of the series
    assert f"| 2 | {second:.1f}" in told
    assert "mr_II = F_II/(2ω)² = 0.0029" in headline(study)
    assert subject(study).structure == "bank of 4 slider-cranks"


def test_a_single_vector_makes_no_polygon_and_many_make_a_convex_one() -> None:
    alone = [name for leaf in leaves(study_of("one")) for name in leaf.metadata["figures"]]
    assert not [name for name in alone if name.startswith("order_")]
    first = next(view_of(study_of("six")).shown())
    ends = [side.value for side in first.vectors if side.kind == SIDE]
    turns = [(before.conjugate() * after).imag for before, after in pairwise(ends)]
    assert len(ends) == 6 and min(turns) > -1e-9 * abs(ends[0]) ** 2
