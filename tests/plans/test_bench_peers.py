"""The peers of the bench: which scenes they can state, what is said of the others, and how exact they are."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

from plans.bench import peers as module
from plans.bench.motion import roads, with_positions
from plans.bench.peers import MECHANISM, PYLINKAGE
from plans.scene.scene import read_scene
from plans.study import Study

GALLERY = Path(__file__).parent.parent.parent / "drawings/gallery"
EXACT = {PYLINKAGE: 1e-10, MECHANISM: 1e-8}  # pylinkage adds steps of the crank up, fsolve stops at 1.5e-8


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
