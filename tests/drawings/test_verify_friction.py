"""What a force sheet and the report say of friction is held against the analysis: each wrong number is seen."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest

from drawings.checks import verify
from drawings.checks.verify_friction import friction_of, reads, report_of
from drawings.paper.strokes import Group, Leaf, Text
from drawings.report.forces.force_report import friction_lines
from drawings.report.report import report
from drawings.sheets import forces
from plans.checks.compare import compare
from plans.checks.force_comparison import ForceComparison, compare_forces
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from plans.words.words import said
from tests.drawings.memo import loaded_memo
from tests.gallery import LINKAGES

SHAPER = next(path for path in LINKAGES if path.stem == "shaper-loaded").read_text("utf-8")
STEEP = """
title = "Steep rod"
sheets = ["forces"]
[mechanism.frame]
O = [0, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "B"
[mechanism.lengths]
OA = 0.07
AB = 0.09
[[mechanism.slides]]
link = 3
along = { through = [0, 0], angle = 0 }
[mechanism.sketch]
B = [0.16, 0]
[drive]
link = 1
speed = 1
start = 7
positions = 12
[[loads.forces]]
on = 3
point = "B"
against = "motion"
value = 100
[friction]
coefficient = 1.0
radius = "1 mm"
[sheet]
language = "ru"
"""


class Sheet(NamedTuple):
    """A force sheet in memory, and the report beside it."""

    leaf: Leaf
    comparison: ForceComparison
    text: str
    language: str

    def wrong(self, leaf: Leaf | None = None) -> list[str]:
        position = int(self.leaf.metadata["position"])
        return list(friction_of(leaf or self.leaf, self.comparison, position, self.language))


def made(text: str) -> Sheet:
    study = LinkageStudy(parse_scene(text))
    statics = Statics(study)
    comparison = compare_forces(statics, compare(study))
    leaves = forces.sheets(study, comparison, statics)
    said = report(loaded_memo(statics, comparison), {"forces": leaves})
    return Sheet(leaves[0], comparison, said, study.scene.sheet.language)


@pytest.fixture(scope="module")
def shaper() -> Sheet:
    return made(SHAPER)


@pytest.fixture(scope="module")
def steep() -> Sheet:
    return made(STEEP)


def rewritten(leaf: Leaf, old: str, new: str) -> Leaf:
    """Write something else in the notes, in one place."""
    count = 0

    def changed(group: Group) -> Group:
        nonlocal count
        strokes = []
        for stroke in group.strokes:
            if isinstance(stroke, Text) and isinstance(stroke.content, str):
                found = re.sub(old, new, stroke.content)
                count += found != stroke.content
                stroke = replace(stroke, content=found)  # noqa: PLW2901
            strokes.append(stroke)
        return replace(group, strokes=tuple(strokes))

    other = replace(leaf, groups=tuple(changed(g) if g.name == "notes" else g for g in leaf.groups))
    assert count == 1, "the fault must be there to be seen"
    return other


def test_what_is_told_of_friction_is_what_the_analysis_gives(shaper: Sheet, steep: Sheet) -> None:
    for sheet in (shaper, steep):
        assert sheet.wrong() == []
        assert list(report_of(sheet.text, sheet.comparison, sheet.language)) == []


def test_beside_a_position_that_all_but_jams_no_power_is_written_as_nothing(steep: Sheet) -> None:
    assert steep.comparison.friction is not None
    found = steep.comparison.friction[0]
    enormous = replace(found, lost=np.where(np.arange(len(found.lost)) == len(found.lost) - 1, 1e15, found.lost))
    tables = [
        [line.split(" | ")[1:-3] for line in friction_lines(steep.comparison, one, steep.language) if line[:3] == "| 0"]
        for one in (found, enormous)
    ]
    assert tables[0] == tables[1] and tables[0] != []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (r"power lost\s", "power gained "),
        (r"(useful power\s)\d", r"\g<1>7"),
        (r"(?<!cycle\s)(η\s=\s)0\.8", r"\g<1>0.1"),
        (r"(over the cycle\sη\s=\s)0\.\d", r"\g<1>0.1"),
        (r"(2-3\s)\d", r"\g<1>1"),
    ],
)
def test_a_wrong_number_in_the_notes_is_seen(shaper: Sheet, old: str, new: str) -> None:
    words = " ".join(stroke.plain for g in shaper.leaf.groups if g.name == "notes" for stroke in g.strokes)
    assert re.search(old, words), words
    assert shaper.wrong(rewritten(shaper.leaf, old, new)) != []


def test_wrong_positions_of_a_jam_are_seen(steep: Sheet) -> None:
    assert steep.comparison.friction is not None
    assert steep.comparison.friction[1].jams
    assert steep.wrong(rewritten(steep.leaf, r"положения\s\d", "положения 0, 9")) != []


@pytest.mark.parametrize(
    "old",
    [r"\| 3 \| (\d)", r"mean powers: 0\.(\d)", r" 2-3 (\d)"],
    ids=["a power", "the efficiency over the cycle", "a share of wear"],
)
def test_a_wrong_number_in_the_report_is_seen(shaper: Sheet, old: str) -> None:
    begin = shaper.text.index("## Friction")
    found = re.compile(old).search(shaper.text, begin)
    assert found is not None
    digit = str((int(found[1]) + 1) % 10)
    wrong = shaper.text[: found.start(1)] + digit + shaper.text[found.end(1) :]
    assert list(report_of(wrong, shaper.comparison, shaper.language)) != []
    with pytest.raises(verify.SelfCheckFailed, match="the report does not tell"):
        verify.verify_report(report_of(wrong, shaper.comparison, shaper.language))


def test_a_jam_that_the_report_leaves_out_is_seen(steep: Sheet) -> None:
    wrong = re.sub(r"- Пара 0-3 заклинивает в положении \d+:.*\n", "", steep.text, count=1)
    assert list(map(str, report_of(wrong, steep.comparison, steep.language))) == ["the jams in the report"]
    with pytest.raises(verify.SelfCheckFailed) as failed:
        verify.verify_report(report_of(wrong, steep.comparison, steep.language))
    assert said(failed.value, "ru") == "отчёт не совпадает с расчётом: заклинивания в отчёте"


def test_the_last_digit_may_be_rounded_as_either_road_does() -> None:
    assert reads("0.3334", 0.33335, 1e-12, digits=4)
    assert not reads("0.3335", 0.33335, 1e-12, digits=4)
    assert reads("—", float("nan"), 0.0)
    assert not reads("—", 1.0, 0.0)
