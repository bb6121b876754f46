"""What is drawn by the command: the set that it writes, what it withholds or leaves alone, what is measured of it."""

from __future__ import annotations

import errno
import json
import re
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import NamedTuple

import pytest

from drawings.commands import cli
from drawings.files import atomic_files
from tests.drawings.conftest import Run
from tests.drawings.test_solved import mislead
from tests.gallery import GALLERY

SHAPER = GALLERY / "shaper.toml"
PLAIN = GALLERY.parents[1] / "tests/catalogue/plain.toml"


class Done(NamedTuple):
    folder: Path
    code: int
    out: str
    err: str


@pytest.fixture(scope="module")
def shaper(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """Draw the shaper once, by the command, for all that is asked of it; nothing is changed in its folder."""
    return drawn_in(tmp_path_factory.mktemp("shaper") / "not/made/yet")


def drawn_in(folder: Path, scene: Path = SHAPER) -> Done:
    """Draw a scene, or the shaper, by the command."""
    with redirect_stdout(StringIO()) as out, redirect_stderr(StringIO()) as err:
        code = cli.main(["draw", str(scene), "-o", str(folder)])
    return Done(folder, code, out.getvalue(), err.getvalue())


@pytest.fixture(scope="module")
def over_older(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """Draw a four-bar linkage once where two sheets of earlier runs lie."""
    folder = tmp_path_factory.mktemp("older")
    for name in ("plain-kinematics.svg", "plain-kinematics-2.svg"):
        (folder / name).write_text("old", "utf-8")
    return drawn_in(folder, PLAIN)


def test_draw_writes_the_sheet_and_the_report_and_prints_the_comparison(shaper: Done) -> None:
    folder, code, out, err = shaper
    assert (code, err) == (0, "")
    sheet, beside = folder / "shaper-kinematics.svg", folder / "shaper-report.md"
    assert {file.name for file in folder.iterdir()} == {sheet.name, beside.name, "shaper-manifest.json"}
    lines = out.splitlines()
    assert lines[-2:] == [str(sheet), str(beside)]
    assert [line.split()[0] for line in lines[1:4]] == ["positions", "velocities", "accelerations"]
    assert all(0 <= float(line.split()[4]) <= 1 for line in lines[1:4])
    assert beside.read_text("utf-8").startswith("# Crank shaper: kinematics\n")


@pytest.mark.rest
def test_the_output_is_told_and_who_chose_it(run: Run, shaper: Done, tmp_path: Path) -> None:
    report = (shaper.folder / "shaper-report.md").read_text("utf-8")
    chosen = "utput: link 5 by its point D, the last link on the frame"
    assert f"\no{chosen}; [output] names another\n" in shaper.out
    assert f"\n- O{chosen}\n" in report
    named = tmp_path / "plain.toml"
    named.write_text(PLAIN.read_text("utf-8") + "positions = 2\n[output]\nlink = 3\n", "utf-8")
    assert "\noutput: link 3, as the scene names it\n" in run("draw", named, "-o", tmp_path)[1]


@pytest.mark.rest
def test_a_following_sheet_of_an_earlier_run_is_named(over_older: Done) -> None:
    left = over_older.folder / "plain-kinematics-2.svg"
    assert over_older.code == 0
    assert over_older.err.startswith(f"{left}: left by an earlier run with more sheets")
    assert left.read_text("utf-8") == "old"


@pytest.mark.rest
def test_a_sheet_with_gaps_is_drawn_and_each_gap_is_told_with_its_reason(
    run: Run, gapped: Path, tmp_path: Path
) -> None:
    code, out, err = run("draw", gapped, "-o", tmp_path / "out")
    assert code == 4
    assert (tmp_path / "out/rockers-kinematics.svg").exists()
    assert len(err.splitlines()) == 1  # one reason, one line
    told = re.match(r"positions ([\d, -]+): positions: out of reach at B, in position \d: A and C are ", err)
    gaps = [gap["position"] for gap in json.loads(run("solve", gapped)[1])["gaps"]]
    assert told
    assert told[1] == f"{gaps[0]}-{gaps[-1]}"
    assert "m apart" in err and "reach from" in err
    assert "miss each other by" not in out


# The self-check


@pytest.fixture(scope="module")
def good(shaper: Done) -> dict[str, bytes]:
    """Give the files of a good sheet, drawn once."""
    return {file.name: file.read_bytes() for file in shaper.folder.iterdir()}


def copied(files: dict[str, bytes], folder: Path) -> Path:
    """Put the files of a drawn set into another folder; give the sheet."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder / "shaper-kinematics.svg"


@pytest.fixture
def before(good: dict[str, bytes], tmp_path: Path) -> Iterator[Path]:
    """A folder with a good sheet, which must be left as it is; and nothing beside it."""
    assert len(good) == 3
    copied(good, tmp_path)
    yield tmp_path
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == good


def test_a_sheet_that_the_analysis_does_not_confirm_is_withheld(
    run: Run, before: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mislead(monkeypatch)
    code, out, err = run("draw", SHAPER, "-o", before)
    assert (code, out) == (5, "")
    assert "construction and analysis differ in v_D" in err
    assert "withheld" in err


@pytest.mark.rest
def test_a_full_disk_ends_with_7_and_leaves_the_old_sheet(
    run: Run, before: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(atomic_files.os, "write", full)
    code, _, err = run("draw", SHAPER, "-o", before)
    monkeypatch.undo()
    assert code == 7
    assert "No space left on device" in err


# measure


def test_measure_says_of_a_foreign_drawing_that_it_is_none_of_ours(run: Run, tmp_path: Path) -> None:
    foreign = tmp_path / "foreign.svg"
    foreign.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"/>', "utf-8")
    code, out, err = run("measure", foreign)
    assert (code, out) == (7, "")
    assert err.startswith(f"{foreign}: this SVG has no vectors or points of a plandraft sheet")


def test_measure_ends_with_8_where_a_sheet_exceeds_a_limit(run: Run, tmp_path: Path) -> None:
    deep = tmp_path / "deep.svg"
    body = "<g>" * 300 + "</g>" * 300
    deep.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm">{body}</svg>', "utf-8")
    code, out, err = run("measure", deep)
    assert (code, out) == (8, "")
    assert err.startswith(f"{deep}: elements are nested over 256 deep")
