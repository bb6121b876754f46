"""plandraft new: a scene of the gallery to start from, and nothing of the user's is ever lost for it."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from drawings.commands import new
from drawings.gallery.catalogue import GALLERY, catalogue
from geometry.errors import DraftError
from tests.drawings.conftest import Run

ENTRIES = catalogue()


def test_new_writes_a_scene_of_the_gallery_to_start_from(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "mine" / "shaper.toml"
    assert run("new", "shaper", "-o", path.parent) == (0, f"{path}\n", "")
    assert path.read_bytes() == (GALLERY / "shaper.toml").read_bytes()
    assert {file.name for file in path.parent.iterdir()} == {"shaper.toml"}


def test_new_writes_into_the_folder_at_hand(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("new", "tangent") == (0, "tangent.toml\n", "")
    assert (tmp_path / "tangent.toml").read_bytes() == (GALLERY / "tangent.toml").read_bytes()


def test_new_without_a_name_lists_names_and_titles(run: Run) -> None:
    code, out, err = run("new")
    assert (code, err) == (0, "")
    lines = [line.split(maxsplit=1) for line in out.splitlines()]
    assert ["shaper", "Crank shaper"] in lines and ["whitworth", "Механизм Витворта"] in lines
    assert [name for name, _ in lines] == sorted(path.stem for path in GALLERY.glob("*.toml"))


@pytest.mark.parametrize("wrong", ["shapr", "Shaper", "shaper.toml"])
def test_new_answers_an_unknown_name_with_the_list_and_the_nearest(run: Run, tmp_path: Path, wrong: str) -> None:
    code, out, err = run("new", wrong, "-o", tmp_path)
    assert (code, out) == (2, "")
    assert f"no scene {wrong}" in err and "Fix: plandraft new shaper" in err
    assert all(entry.name in err for entry in ENTRIES)
    assert list(tmp_path.iterdir()) == []


def test_new_never_overwrites_a_file(run: Run, tmp_path: Path) -> None:
    (tmp_path / "shaper.toml").write_text("my own work", "utf-8")
    code, out, err = run("new", "shaper", "-o", tmp_path)
    assert (code, out) == (7, "")
    assert str(tmp_path / "shaper.toml") in err and "never overwritten" in err and "-o" in err
    assert (tmp_path / "shaper.toml").read_text("utf-8") == "my own work"


def test_new_says_which_folder_cannot_be_made(run: Run, tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("a file", "utf-8")
    code, out, err = run("new", "shaper", "-o", tmp_path / "taken" / "below")
    assert (code, out) == (7, "")
    assert str(tmp_path / "taken" / "below") in err


@pytest.mark.parametrize("step", ["write", "fsync", "link"])
def test_new_leaves_no_empty_file_where_the_disk_is_full(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, step, full)
    if step == "link":  # as on a file system that has none: the name is taken by an empty file, and given up again
        monkeypatch.setattr(Path, "replace", full)
    code, _, err = run("new", "shaper", "-o", tmp_path)
    assert code == 7 and "No space left on device" in err
    assert list(tmp_path.iterdir()) == []


def test_new_writes_where_the_file_system_has_no_links(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unknown(*_: object, **__: object) -> None:
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "link", unknown)
    assert run("new", "shaper", "-o", tmp_path)[0] == 0
    assert (tmp_path / "shaper.toml").read_bytes() == (GALLERY / "shaper.toml").read_bytes()
    assert run("new", "shaper", "-o", tmp_path)[0] == 7


def test_new_reads_titles_without_reading_scenes() -> None:
    """The list is there at once: nothing of numpy, of pydantic or of the drawing is imported for it."""
    lines = "import sys; from drawings.commands import cli; cli.main(['new']); print(*sys.modules, file=sys.stderr)"
    done = subprocess.run(
        [sys.executable, "-X", "utf8", "-c", lines], cwd=GALLERY.parents[1], capture_output=True, text=True, check=True
    )
    loaded = set(done.stderr.split())
    assert "drawings.gallery.catalogue" in loaded
    assert not loaded & {"numpy", "pydantic", "svgwrite", "plans.scene.scene", "drawings.gallery.index"}


@pytest.mark.parametrize(("asked", "name"), [("balance", "balance"), ("balancing", "balanc"), ("bank", "bank")])
def test_a_word_of_a_name_or_title_is_enough(asked: str, name: str) -> None:
    with pytest.raises(DraftError, match=f"Fix: plandraft new [a-z-]*{name}"):
        new.found(ENTRIES, asked)


def test_a_name_that_resembles_none_is_told_to_choose() -> None:
    with pytest.raises(DraftError, match="Fix: take one of them"):
        new.found(ENTRIES, "q")
