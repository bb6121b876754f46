"""A part of the long trials: an eight-hundredth, a fiftieth with --whole; `python -m tests.trials` makes them all."""

from __future__ import annotations

import gc
import re
import warnings
from collections import Counter
from collections.abc import Callable
from random import Random

import numpy as np
import pytest

from geometry.errors import DraftError
from plans.analytic.kinematics import Analysis
from plans.linkage.reading.form import LinkageForm
from plans.linkage.study import LinkageStudy
from plans.model.dyad import decompose
from plans.model.mechanism import FRAME
from plans.model.motion import Motion
from plans.scene.scene import Scene, parse_scene
from tests import parts
from tests.gallery import LINKAGES
from tests.trials import trial
from tests.trials.__main__ import main
from tests.trials.chains import KINDS as DYADS
from tests.trials.changes import change
from tests.trials.series import trials
from tests.trials.table import failing, table
from tests.trials.trial import ALONE, APART, KINDS, SLOW, TRACEBACK, WARNED, WITHHELD, text_of, tried

SHARE = 50 if parts.whole else 1600


@pytest.mark.part
@pytest.mark.parametrize("kind", KINDS)
def test_a_part_of_the_long_trials(kind):
    verdicts = [tried(kind, number) for number in range(0, KINDS[kind][1], SHARE)]
    assert not any(verdict.faults for verdict in verdicts), "\n".join([table(verdicts), *failing(verdicts)])


@pytest.mark.rest
def test_a_series_is_the_same_trials_shared_between_the_cores():
    assert [*trials(("changes",), 500)] == [tried("changes", number) for number in range(0, 2000, 500)]


@pytest.mark.parametrize("kind", KINDS)
def test_a_scene_is_the_same_by_its_number_and_no_other(kind):
    assert text_of(kind, 7) == text_of(kind, 7) != text_of(kind, 8)


def test_the_number_of_a_link_is_not_changed():
    assert not any(re.search(r"\b(link|on) = -?\d+\.", change(Random(number))) for number in range(1000))


def test_a_crank_rocker_obeys_grashof():
    for number in range(100):
        mechanism = LinkageStudy(parse_scene(text_of("crank-rockers", number))).mechanism
        frame = abs(mechanism.links[FRAME].points["C"])
        *short, longest = sorted(
            abs(link.points[name]) for link, name in zip(mechanism.links.values(), "CABB", strict=True)
        )
        assert mechanism.links[1].points["A"] == short[0] and longest >= frame
        assert short[0] + longest < short[1] + short[2]


def test_chains_have_all_dyads_both_senses_and_all_kinds_of_positions():
    scenes = [parse_scene(text_of("chains", number)) for number in range(100)]
    groups = Counter(dyad.kind for scene in scenes for dyad in decompose(LinkageStudy(scene).mechanism))
    assert set(groups) == set(DYADS)
    assert {1, 5} <= {len(scene.of(LinkageForm).mechanism.links) // 2 for scene in scenes}
    assert {scene.of(LinkageForm).drive.speed > 0 for scene in scenes} == {True, False}
    assert {type(scene.of(LinkageForm).drive.positions) for scene in scenes} == {int, tuple}
    assert any(scene.of(LinkageForm).drive.start == "extreme" for scene in scenes)


def test_a_change_changes_one_line_of_the_gallery():
    gallery = [path.read_text(encoding="utf-8").splitlines() for path in LINKAGES]
    for number in range(50):
        lines = text_of("changes", number).splitlines()
        changed = [sum(a != b for a, b in zip(lines, own, strict=True)) for own in gallery if len(own) == len(lines)]
        assert min(changed) == 1


def broken(monkeypatch: pytest.MonkeyPatch, spoil: Callable[[Motion], Motion]) -> None:
    """Let the analysis tell something else than it found."""
    motion = Analysis.motion
    monkeypatch.setattr(Analysis, "motion", lambda self, *given: spoil(motion(self, *given)))


def test_a_road_that_gives_up_a_position_in_silence_is_told(monkeypatch):
    def silent(motion: Motion) -> Motion:
        motion = motion.own()
        for row in motion.rows():
            row[3] = np.nan
        return motion

    broken(monkeypatch, silent)
    verdict = tried("crank-rockers", 0)
    assert {fault for fault, _ in verdict.faults} == {ALONE, WITHHELD}


GAPPED = 50  # a chain in which both roads name the same gaps


def test_a_road_with_another_reason_for_a_gap_is_told(monkeypatch):
    assert tried("chains", GAPPED).outcome == trial.GAPS and not tried("chains", GAPPED).faults
    broken(monkeypatch, lambda found: found._replace(gaps=tuple(g._replace(reason="dead centre") for g in found.gaps)))
    assert {fault for fault, _ in tried("chains", GAPPED).faults} == {APART, trial.WITHHELD}


def test_a_bug_is_a_traceback_and_no_refusal(monkeypatch):
    def fails(study: LinkageStudy) -> None:
        raise IndexError("list index out of range")

    monkeypatch.setattr(trial, "compare", fails)
    assert [fault for fault, _ in tried("crank-rockers", 0).faults] == [TRACEBACK]


def test_a_crank_rocker_that_is_refused_fails_the_trial(monkeypatch):
    def refuses(study: LinkageStudy) -> None:
        raise DraftError("scene.toml:1: no")

    monkeypatch.setattr(trial, "compare", refuses)
    assert tried("crank-rockers", 0).faults and not tried("chains", 0).faults


def test_one_scene_is_shown_by_its_number(capsys):
    assert main(["--kind", "chains", "--only", "12", "--show"]) == 0
    assert capsys.readouterr().out == text_of("chains", 12) + "\n"


def test_a_scene_that_takes_too_long_is_ended(monkeypatch):
    monkeypatch.setattr(trial, "LONGEST", 1e-3)
    gc.disable()  # an alarm within a callback of the collector would be a warning of its own
    try:
        assert tried("chains", GAPPED).outcome == SLOW
    finally:
        gc.enable()


def test_a_warning_is_told(monkeypatch):
    def warns(scene: Scene) -> LinkageStudy:
        warnings.warn("overflow", RuntimeWarning, stacklevel=1)
        return LinkageStudy(scene)

    monkeypatch.setattr(trial, "_study", warns)
    assert tried("crank-rockers", 0).faults == ((WARNED, "overflow"),)
