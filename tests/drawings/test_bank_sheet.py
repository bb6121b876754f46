"""The sheets of a bank: the book's values, its polygons and its report."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import pytest

from drawings.bank.report import chapters, headline, subject
from drawings.bank.sheet import leaves, view_of
from drawings.kinds.polygon import SIDE
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.bank_scenes import bank, compensator, scene
from tests.drawings.held import faults_of
from tests.drawings.pages import texts


@cache
def study_of(name: str, size: str = "A1", language: str = "en", standard: str = "GOST") -> Study:
    return Study(parse_scene(scene(name, size, language, standard)))


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
