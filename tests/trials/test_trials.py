"""Random mechanisms by both roads: a sixteen-hundredth of all every day, a fiftieth with --whole."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from random import Random

import numpy as np
import pytest

from geometry.errors import DraftError
from plans.analytic.kinematics import Analysis
from plans.linkage.reading.form import LinkageForm
from plans.linkage.study import LinkageStudy
from plans.model.decomposition import decompose
from plans.model.mechanism import FRAME
from plans.model.motion import Motion
from plans.scene.scene import parse_scene
from tests import parts
from tests.gallery import LINKAGES
from tests.trials.chains import KINDS as DYADS
from tests.trials.changes import change
from tests.trials.trial import KINDS, apart, study_of, text_of

SHARE = 50 if parts.whole else 1600
GAPPED = 50  # a chain in which both roads name the same gaps


@pytest.mark.part
@pytest.mark.parametrize("kind", KINDS)
def test_both_roads_give_up_the_same_positions_for_the_same_reasons_and_agree_in_the_others(kind: str) -> None:
    for number in range(0, KINDS[kind][1], SHARE):
        try:
            assert not list(apart(study_of(kind, number))), number
        except DraftError as refused:  # a crank-rocker after Grashof is never refused
            assert kind != "crank-rockers" and refused.exit_code != 5, f"{number}: {refused}"


@pytest.mark.parametrize("kind", KINDS)
def test_a_scene_is_the_same_by_its_number_and_no_other(kind: str) -> None:
    assert text_of(kind, 7) == text_of(kind, 7) != text_of(kind, 8)


def test_a_crank_rocker_obeys_grashof() -> None:
    for number in range(100):
        mechanism = LinkageStudy(parse_scene(text_of("crank-rockers", number))).mechanism
        frame = abs(mechanism.links[FRAME].points["C"])
        *short, longest = sorted(
            abs(link.points[name]) for link, name in zip(mechanism.links.values(), "CABB", strict=True)
        )
        assert mechanism.links[1].points["A"] == short[0] and longest >= frame
        assert short[0] + longest < short[1] + short[2]


def test_chains_have_all_dyads_both_senses_and_all_kinds_of_positions() -> None:
    scenes = [parse_scene(text_of("chains", number)) for number in range(100)]
    groups = Counter(dyad.kind for scene in scenes for dyad in decompose(LinkageStudy(scene).mechanism))
    assert set(groups) == set(DYADS)
    drives = [scene.of(LinkageForm).drive for scene in scenes]
    assert {drive.speed > 0 for drive in drives} == {True, False}
    assert {type(drive.positions) for drive in drives} == {int, tuple} and "extreme" in {one.start for one in drives}


def test_a_change_changes_one_line_of_the_gallery_and_no_number_of_a_link() -> None:
    gallery = [path.read_text(encoding="utf-8").splitlines() for path in LINKAGES]
    for number in range(50):
        lines = text_of("changes", number).splitlines()
        changed = [sum(a != b for a, b in zip(lines, own, strict=True)) for own in gallery if len(own) == len(lines)]
        assert min(changed) == 1
    assert not any(re.search(r"\b(link|on) = -?\d+\.", change(Random(number))) for number in range(1000))


def _silent(motion: Motion) -> Motion:
    motion = motion.own()
    for row in motion.rows():
        row[3] = np.nan
    return motion


def _otherwise(motion: Motion) -> Motion:
    return motion._replace(gaps=tuple(gap._replace(reason="dead centre") for gap in motion.gaps))


@pytest.mark.parametrize(
    ("kind", "number", "spoil"), [("crank-rockers", 0, _silent), ("chains", GAPPED, _otherwise)], ids=["silent", "why"]
)
def test_a_road_that_gives_up_in_silence_or_for_another_reason_is_told(
    kind: str, number: int, spoil: Callable[[Motion], Motion], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert not list(apart(study_of(kind, number)))
    true = Analysis.motion
    monkeypatch.setattr(Analysis, "motion", lambda self, *given: spoil(true(self, *given)))
    assert any("position" in one for one in apart(study_of(kind, number)))
