"""The sheets of a bank are held to the analysis: what is drawn passes, faults planted into the drawing withhold it.

The tables are tests/cases/bank_faults.toml, bank_line_faults.toml line by line, bank_told_faults.toml of the report.
"""

from __future__ import annotations

import math
import re
from functools import cache, partial
from itertools import pairwise
from pathlib import Path

import pytest
from drawings.checks.bank.verify_bank import faults, set_faults

from drawings.checks.verify import SelfCheckFailed, verify
from drawings.figures.bank.bank_view import SIDE
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.report.balance.bank_report import chapters, headline, subject
from drawings.report.report import faults as told_otherwise
from drawings.report.report import report
from drawings.sheets.bank import leaves, view_of
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.bank_scenes import SCENES, bank, compensator, scene
from tests.drawings.conftest import Run
from tests.drawings.pages import texts
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.drawings.slips import Change, changed, dropped, note, reworded, row_dropped, shifted, turned, without
from tests.parts import first

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "bank_faults.toml")
TOLD = drawing_faults(ROOT / "tests" / "cases" / "bank_told_faults.toml")
LINES = drawing_faults(ROOT / "tests" / "cases" / "bank_line_faults.toml")
PAPERS = (("A1", "en", "GOST"), ("A3", "ru", "ISO"), ("A4", "en", "ISO"), ("A2", "ru", "GOST"))


@cache
def study_of(name: str, size: str = "A1", language: str = "en", standard: str = "GOST") -> Study:
    return Study(parse_scene(scene(name, size, language, standard)))


def checked(leaf: Leaf, study: Study, folder: Path) -> Measured:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    return verify(path, leaf, partial(faults, study=study)).measured


def all_checked(study: Study, folder: Path) -> list[Measured]:
    return [checked(leaf, study, folder) for leaf in leaves(study)]


@pytest.mark.rest
@pytest.mark.parametrize("case", first([(name, *paper) for paper in PAPERS for name in SCENES]))
def test_what_is_drawn_agrees_with_the_analysis(case: tuple[str, str, str, str], tmp_path: Path) -> None:
    study = study_of(*case)
    assert study.comparison("bank").worst <= 1.0
    assert all_checked(study, tmp_path)


@pytest.mark.parametrize("fault", first([*FAULTS, *LINES]), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene)
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        all_checked(study, tmp_path)
    assert fault.says in str(told.value)
    assert told.value.exit_code == 5
    assert "against the analysis" not in said(told.value, "ru")


@pytest.mark.rest
def test_what_is_on_no_sheet_of_a_set_is_missed() -> None:
    study, seen = study_of("one", "A4", "en", "ISO"), Measured((), ())
    own = [(seen, leaf) for leaf in leaves(study)]
    assert len(own) > 1
    assert list(set_faults(own, study)) == []
    told = [[str(fault) for fault in set_faults(own[:k] + own[k + 1 :], study)] for k in range(len(own))]
    lost = {fault.removesuffix(" is missing") for faults_of_one in told for fault in faults_of_one}
    assert all(told)
    assert lost == {
        "the figure star of cranks is not on one sheet",
        "the figure force_graph is not on one sheet",
        "the figure compensator-1 is not on one sheet",
        "the figure compensator-2 is not on one sheet",
        "the notes, which stand on 0 sheets",
        "orders",
        "compensators",
        "results",
    }
    assert list(set_faults([*own, own[-1]], study))


def test_every_fault_still_finds_the_text_that_it_replaces() -> None:
    assert len(FAULTS) >= 15
    for fault in (*FAULTS, *LINES, *TOLD):
        assert fault.text


@pytest.mark.rest
def test_a_fault_withholds_the_sheet_at_the_command(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "four.toml"
    path.write_text(scene("four"), "utf-8")
    with planted(FAULTS[0]):
        code, _, err = run("draw", path, "-o", tmp_path / "out")
    assert code == 5
    assert FAULTS[0].says in err
    assert not list((tmp_path / "out").glob("*.svg"))


@pytest.mark.rest
@pytest.mark.parametrize(
    "slip",
    first(
        [
            (dropped("F_II,3", "order_forces-2"), "F_II,3 on forces of order 2 is missing"),
            (turned("F_II", "order_forces-2"), "F_II on forces of order 2 (against the analysis)"),
            (shifted("3", "shaft", 0.001), "3 on view across the shaft (against the analysis)"),
            (dropped("2", "star"), "2 on star of cranks is missing"),
            (dropped("m_II", "compensator-2"), "m_II on compensator of order 2"),
            (without("orders-1"), "1 is missing from the table of orders"),
            (without("compensators-1"), "mII is missing from the table of compensators"),
            (row_dropped("4"), "the letter 4 on force_graph"),
            (reworded("2303.8", "2303.9"), "2303.9 for 2 in the table of orders"),
            (reworded("58.356", "58.357"), "58.357 for mII in the table of compensators"),
            (reworded("−628.32", "628.32"), "628.32 for m−II in the table of compensators"),
            (note("1151.9", "1152.9"), "in the notes"),
            (note("138.23", "138.32"), "in the notes"),
            (note("2303.8", "1151.9"), "in the notes"),
            (note("180°", "0°"), "in the notes"),
            (note("order 1, 2, 4, 6 balance", "order 1, 2, 4 balance"), "in the notes"),
            (without("notes"), "n is missing from the notes"),
            (without("force_graph"), "force_graph is missing"),
        ]
    ),
)
def test_a_slip_is_seen(slip: tuple[Change, str], tmp_path: Path) -> None:
    change, wrong = slip
    study = study_of("four")
    (leaf,) = leaves(study)
    spoilt = changed(leaf, change)
    assert spoilt != leaf
    with pytest.raises(SelfCheckFailed) as told:
        checked(spoilt, study, tmp_path)
    assert wrong in str(told.value)
    assert not re.search(r"\b(the|is|on|in|for|against)\b", said(told.value, "ru"))


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
def test_what_turns_with_the_crank_alone_is_a_counterweight_on_it(tmp_path: Path) -> None:
    study = study_of("vee")
    all_checked(study, tmp_path)
    (leaf,) = leaves(study)
    written = {text.plain for group in leaf.groups for text in texts(group)}
    assert "Counterweight on the crank, φ = 0" in written and "Compensator of order 1, φ = 0" not in written
    assert "a counterweight on the crank itself" in leaf.description
    assert not any(text.startswith("z = ") for text in written)


@pytest.mark.rest
def test_unlike_vectors_leave_couples_that_a_counterweight_would_not(tmp_path: Path) -> None:
    """Two cylinders together: what turns at their pins, 2*0.6 kg at 40 mm, is all the difference of both vectors."""
    study = study_of("unlike")
    all_checked(study, tmp_path)
    told = " ".join(leaf.description for leaf in leaves(study))
    assert "F_{I} and F_{−I} differ: couples by the distances of the two shafts are not counted" in told
    assert "mr_{O} = (F_{I}−F_{−I})/ω² = 0.048 kg·m\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}180°" in told


@pytest.mark.rest
def test_what_vanishes_is_said_and_has_no_arrow(tmp_path: Path) -> None:
    """Six cylinders in line: orders 1, 2 and 4 close by themselves, and nothing is there to be compensated."""
    study = study_of("six")
    measured = all_checked(study, tmp_path)
    sums = {
        one.name for page in measured for one in page.vectors if "," not in one.name and one.plan.startswith("order")
    }
    assert sums == {"F_VI"}
    told = leaves(study)[0].description
    assert "Forces of order 1, 2, 4 balance one another" in told and "Moments of order 1, 2, 4, 6 balance" in told
    assert "Order 1: nothing to compensate" in told


@pytest.mark.rest
def test_what_is_too_slight_is_told_and_not_drawn(tmp_path: Path) -> None:
    """Three cylinders: forces of orders 1, 2, 4 balance one another, and order 6 is 1/6700 of a cylinder's first."""
    study = study_of("three")
    all_checked(study, tmp_path)
    (leaf,) = leaves(study)
    assert not {"order_forces-6", "order_moments-6", "force_graph"} & set(leaf.metadata["figures"])
    assert {"order_forces-4", "order_moments-4", "moment_graph"} <= set(leaf.metadata["figures"])
    assert "Below 1/1000 of the largest, not drawn: order 6" in leaf.description
    assert "Over the turn F_{max} = 0.8806" in leaf.description


@pytest.mark.rest
def test_the_notes_say_which_polygons_are_left_out_as_mirror_images(tmp_path: Path) -> None:
    """A mass that turns with the crank has no image that turns against it: order 1 is shown both ways, order 2 once."""
    study = study_of("cancelled")
    all_checked(study, tmp_path)
    figures = {name for leaf in leaves(study) for name in leaf.metadata["figures"]}
    assert "order_forces-1-back" in figures and "order_forces-2-back" not in figures
    told = leaves(study)[0].description
    assert "against it; of order 2, 4, 6 the latter is the mirror image in the guide, not shown" in told


@pytest.mark.rest
def test_a_bank_at_rest_in_itself_has_no_graph(tmp_path: Path) -> None:
    """Two mechanisms in one place, each the other's image in the shaft: no force of any order is left."""
    study = Study(parse_scene(bank([(0, 0, 0), (180, 0, 180)], compensator(1)) + '[sheet]\nlanguage = "en"\n'))
    figures = {name for leaf in leaves(study) for name in leaf.metadata["figures"]}
    assert not figures & {"force_graph", "moment_graph", "compensator-1", "shaft"}
    all_checked(study, tmp_path)


def test_the_report_tells_the_bank() -> None:
    study = study_of("four")
    told = "\n".join(line for part in chapters(study, {}) for line in part)
    assert "mechanism 4: crank at 0°, place 150 mm, guide at 0°" in told
    ratio, first = 40 / 140, 0.5 * 0.04 * (100 * math.pi) ** 2
    second = first * (ratio + ratio**3 / 4 + 15 / 128 * ratio**5 + 35 / 512 * ratio**7)  # the beginning of the series
    assert f"| 2 | {second:.1f}" in told
    assert "mr_II = F_II/(2ω)² = 0.0029" in headline(study)
    assert subject(study).structure == "bank of 4 slider-cranks"


@pytest.mark.parametrize("case", first([(name, "A1", language) for language in ("en", "ru") for name in SCENES]))
def test_a_report_that_tells_the_truth_has_no_faults(case: tuple[str, str, str]) -> None:
    own = study_of(*case)
    assert list(told_otherwise(report(own, {}), own, {})) == []


@pytest.mark.parametrize("fault", first(TOLD), ids=lambda fault: fault.name)
def test_a_report_told_otherwise_is_seen(fault: DrawingFault) -> None:
    own = study_of(fault.scene)
    _ = own.comparison("bank")
    with planted(fault):
        text = report(own, {})
    assert fault.says in "; ".join(map(str, told_otherwise(text, own, {})))


def test_a_single_vector_makes_no_polygon_and_many_make_a_convex_one() -> None:
    alone = [name for leaf in leaves(study_of("one")) for name in leaf.metadata["figures"]]
    assert not [name for name in alone if name.startswith("order_")]
    first = next(view_of(study_of("six")).shown())
    ends = [side.value for side in first.vectors if side.kind == SIDE]
    turns = [(before.conjugate() * after).imag for before, after in pairwise(ends)]
    assert len(ends) == 6 and min(turns) > -1e-9 * abs(ends[0]) ** 2
