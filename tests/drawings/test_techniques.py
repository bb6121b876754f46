"""What every technique must have: a row that a new one lacks is told here, not by an error of a command."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import pytest

from drawings.commands.explain import explained
from drawings.lettering.words import number
from drawings.paper.strokes import Leaf
from drawings.report import report
from drawings.report.report import report_of
from drawings.sheets.kind import sheet_kind
from plans.bench.quantities import roads
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.quantity import Comparison, Quantity
from plans.scene.scene import read_scene
from plans.study import Study
from plans.techniques import TECHNIQUES, Technique, sheet_of, techniques
from plans.words.words import ENGLISH, languages, words
from tests.gallery import GALLERY


def study_of(technique: str) -> Study:
    """Study the shortest scene of the gallery that has the first sheet of a technique, and something found by it."""
    paths = sorted(GALLERY.glob("*.toml"), key=lambda path: path.stat().st_size)
    asked = (path for path in paths if sheet_of(technique) in read_scene(path).sheets)
    studies = (Study(read_scene(path)) for path in asked)
    return next(study for study in studies if study.comparison(technique).findings)


class Shown(NamedTuple):
    """A scene of a technique, and the leaves of the sheet that shows it."""

    technique: str
    study: Study
    sheet: str
    leaves: Sequence[Leaf]


@pytest.fixture(scope="module", params=TECHNIQUES)
def shown(request: pytest.FixtureRequest) -> Shown:
    study, sheet = study_of(request.param), sheet_of(request.param)
    return Shown(request.param, study, sheet, sheet_kind(sheet).leaves(study))


def test_its_quantities_have_names_by_both_roads_and_words_in_both_languages(shown: Shown) -> None:
    compared: Comparison = shown.study.comparison(shown.technique)
    told: Sequence[Quantity] = shown.study.quantities(shown.technique)
    assert compared.agrees and {one.name for one in compared.findings} <= {one.name for one in told}
    for language in languages():
        known = words(language)
        assert {f"plan.{one.plan}" for one in told} <= known.keys()
        lettered = {one.unit for one in told if re.search("[A-Za-z]", one.unit)}
        assert {f"unit.{unit}" for unit in lettered} <= known.keys() or language == ENGLISH


def test_its_numbers_are_told_alike_by_both_roads(shown: Shown) -> None:
    ours, theirs = (shown.study.numbers(shown.technique, by).plain() for by in ("construction", "analysis"))
    assert ours and ours.keys() == theirs.keys()


def test_its_marks_are_explained_and_others_are_refused_with_examples(shown: Shown) -> None:
    none = techniques()[shown.technique].marks(shown.study, 0, "no such mark")
    assert isinstance(none, NoMark)
    for example in none.examples:
        found = explained(Study.of_all(shown.study.scene), 0, example)
        assert found.steps and all(mark.step.why is not None for mark in found.steps)


def test_its_sheet_its_report_its_form_and_its_bench_are_there(shown: Shown) -> None:
    assert shown.leaves and any(sheet_kind(shown.sheet).expected(shown.study, shown.leaves))
    leaves: Mapping[str, Sequence[Leaf]] = {shown.sheet: shown.leaves}
    assert any(report_of(shown.technique).chapters(shown.study, leaves))
    assert sheet_kind(shown.sheet).figures and sheet_kind(shown.sheet).tables
    assert len([*roads(shown.study, shown.technique, None)]) == 2


def test_one_that_says_no_more_is_told_by_its_quantities(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(report, "find_spec", lambda name: None)
    study, rotor = Study(read_scene(GALLERY / "four-masses.toml")), techniques()["rotor"]
    first = next(one for one in study.quantities("rotor") if one.name == "m_ID_I")
    for by, values in (("construction", first.construction), ("analysis", first.analysis)):
        told = Technique.numbers(rotor, study, by).plain()["rotor"]["m_ID_I"]
        assert complex(*told) == values[0]
    found, none = (Technique.marks(rotor, study, 0, name) for name in ("m_1D_1", "m_0D_0"))
    assert isinstance(found, Explanation) and found.steps[-1].name == "m_1D_1"
    assert isinstance(none, NoMark) and "m_ID_I" in none.names
    with pytest.raises(UnknownMark):
        Technique.marks(rotor, study, 1, "m_1D_1")
    size = number(abs(first.analysis[0]))
    told = [*report_of("rotor").chapters(study, {}).values]
    assert {f"| m_ID_I, kg·m | {size} | {size} |", "| R_A', N | 0 | 0 |"} <= {*told}
