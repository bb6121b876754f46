"""No layout hangs on a last bit: where a processor rounds sines and roots otherwise, all stands where it stood."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from drawings.gallery.alike import differences
from tests.drawings.other_processor import sheets
from tests.gallery import GALLERY, SCENES

ROOT = Path(__file__).parents[2]
EVERYDAY = [GALLERY / f"{name}.toml" for name in ("crank-rocker", "four-masses", "tappet-cam")]
SETS = {
    "everyday": EVERYDAY,
    **{scene.stem: [scene] for scene in SCENES if scene not in EVERYDAY},
}


def drawn_alike(way: str, scenes: Sequence[Path], folder: Path) -> None:
    command = [sys.executable, "-m", "tests.drawings.other_processor", way, str(folder), *map(str, scenes)]
    subprocess.run(command, cwd=ROOT, check=True)
    for scene in scenes:
        for name, content in sheets(scene):
            (kept := folder / "kept" / name).parent.mkdir(exist_ok=True)
            kept.write_bytes(content)
            assert list(differences(folder / name, kept)) == []


@pytest.mark.parametrize("way", ["up", "down"])
@pytest.mark.parametrize(
    "scenes",
    [pytest.param(own, id=name, marks=() if name == "everyday" else pytest.mark.rest) for name, own in SETS.items()],
)
def test_a_processor_that_rounds_otherwise_draws_the_same(way: str, scenes: Sequence[Path], tmp_path: Path) -> None:
    drawn_alike(way, scenes, tmp_path)


def test_a_tie_that_hangs_on_a_last_bit_is_told(tmp_path: Path) -> None:
    with pytest.raises(AssertionError):
        drawn_alike("up-exact", EVERYDAY[1:2], tmp_path)
