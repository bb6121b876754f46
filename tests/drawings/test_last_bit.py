"""No layout hangs on a last bit: where a processor rounds sines and roots otherwise, all stands where it stood."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from drawings.gallery.changes import differences
from tests import parts
from tests.drawings.other_processor import sheets
from tests.gallery import GALLERY, SCENES

ROOT = Path(__file__).parents[2]
BEGUN = "down", "plunger-pump"  # two closed paths are begun at another of their points: nothing else differs
EVERYDAY = ("up", "tappet-cam"), ("down", "crank-rocker")


def drawn_alike(way: str, scene: Path, folder: Path) -> None:
    command = [sys.executable, "-m", "tests.drawings.other_processor", way, str(folder), str(scene)]
    subprocess.run(command, cwd=ROOT, check=True)
    for name, content in sheets(scene):
        (kept := folder / "kept" / name).parent.mkdir(exist_ok=True)
        kept.write_bytes(content)
        assert list(differences(folder / name, kept)) == []


WAYS = [(way, scene) for scene in SCENES for way in ("up", "down") if parts.whole or (way, scene.stem) in EVERYDAY]


def tried(way: str, scene: Path) -> object:
    marks = [] if (way, scene.stem) in EVERYDAY else [pytest.mark.rest]
    marks += [pytest.mark.xfail(reason="not on every processor")] if (way, scene.stem) == BEGUN else []
    return pytest.param(way, scene, id=f"{scene.stem}-{way}", marks=marks)


@pytest.mark.parametrize(("way", "scene"), [tried(*one) for one in WAYS])
def test_a_processor_that_rounds_otherwise_draws_the_same(way: str, scene: Path, tmp_path: Path) -> None:
    drawn_alike(way, scene, tmp_path)


def test_a_tie_that_hangs_on_a_last_bit_is_told(tmp_path: Path) -> None:
    with pytest.raises(AssertionError):
        drawn_alike("up-exact", GALLERY / "four-masses.toml", tmp_path)
