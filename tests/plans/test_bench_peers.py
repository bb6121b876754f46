"""The peers of the bench: which scenes they can state, what is said of the others, and how exact they are."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from plans.bench import peers as module
from plans.bench.motion import roads, with_positions
from plans.bench.peers import MECHANISM, NOT_FOUR_BAR, NOT_INSTALLED, PYLINKAGE, four_bar, peers
from plans.linkage.study import LinkageStudy
from plans.scene.scene import read_scene
from plans.study import Study

GALLERY = Path(__file__).parent.parent.parent / "drawings/gallery"
EXACT = {PYLINKAGE: 1e-10, MECHANISM: 1e-8}  # pylinkage adds steps of the crank up, fsolve stops at 1.5e-8


def test_the_crank_rocker_is_a_four_bar_with_its_coupler_point() -> None:
    found = four_bar(LinkageStudy(read_scene(GALLERY / "crank-rocker.toml")))
    assert found is not None
    assert (found.letters, found.links) == (("O", "A", "B", "C"), (1, 2, 3))
    assert [abs(side) for side in (found.crank, found.coupler, found.rocker, found.base)] == [0.1, 0.4, 0.3, 0.35]
    assert abs(found.points["E"]) == pytest.approx(math.hypot(0.200, 0.093))
    assert np.degrees(np.angle(found.points["E"])) == pytest.approx(math.degrees(math.atan2(93, 200)))


@pytest.mark.parametrize("name", ["shaper", "slider-crank"])
def test_other_mechanisms_are_left_out_and_it_is_said_why(name: str) -> None:
    ready, out = peers(LinkageStudy(read_scene(GALLERY / f"{name}.toml")))
    assert ready == []
    assert out == {PYLINKAGE: NOT_FOUR_BAR, MECHANISM: NOT_FOUR_BAR}


def test_peers_that_are_not_installed_are_told_with_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "find_spec", lambda library: None)
    ready, out = peers(LinkageStudy(read_scene(GALLERY / "crank-rocker.toml")))
    assert ready == []
    assert out == {PYLINKAGE: NOT_INSTALLED, MECHANISM: NOT_INSTALLED}
    assert "pip install" in NOT_INSTALLED


@pytest.mark.parametrize("name", [PYLINKAGE, MECHANISM])
@pytest.mark.parametrize("clockwise", [False, True])
def test_an_installed_peer_gives_the_same_motion(name: str, clockwise: bool, tmp_path: Path) -> None:
    if not all(importlib.util.find_spec(library) for library in module.NEEDED[name]):
        pytest.skip(f"{name} is not installed")
    text = (GALLERY / "crank-rocker.toml").read_text("utf-8")
    file = tmp_path / "scene.toml"
    file.write_text(text.replace('"10 rad/s"', '"-10 rad/s"') if clockwise else text, "utf-8")
    ways, _ = roads(Study(with_positions(read_scene(file), 36)), 36)
    road = next(way for way in ways if name in way.judged)
    found = road.judged[name](road.run())
    assert found.worst < EXACT[name]
