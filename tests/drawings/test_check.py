"""The command check: what it says of whole, edited, torn and strange sheets, and how it ends."""

from __future__ import annotations

import re
import shutil
from functools import cache
from pathlib import Path

import pytest

from drawings.commands import check as command
from drawings.commands import cli
from drawings.files.sheet_set import manifest_of
from drawings.paper.walk import texts
from drawings.pens.svg import svg
from drawings.redrawn import Originals, check
from tests.forgeries.chance_edits import CHANGES
from tests.forgeries.leaf_edits import swapped
from tests.forgeries.sheets import GALLERY, KINDS, forged, judged
from tests.fuzz_sheets import tried
from tests.parts import first

SCENE = GALLERY / "fan.toml"
NAME = "fan-rotor.svg"
MOST = 10 * 1024**2 + 1  # bytes, one more than are read


@cache
def fan() -> Originals:
    return Originals(SCENE)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give a folder with a scene, its sheet, and the manifest of both."""
    monkeypatch.setattr(command, "Originals", replaced)
    shutil.copy(SCENE, tmp_path)
    contents = {tmp_path / NAME: fan().drawn(fan().sheets[0]), tmp_path / "fan-report.md": b"# Report\n"}
    for path, content in contents.items():
        path.write_bytes(content)
    manifest = manifest_of("fan.toml", SCENE.read_bytes(), contents)
    (tmp_path / manifest.name).write_bytes(manifest.content())
    return tmp_path


def replaced(path: Path) -> Originals:
    """Give the scene that is laid out already, if it is that one."""
    return fan() if path.read_bytes() == SCENE.read_bytes() else Originals(path)


Capture = pytest.CaptureFixture[str]


def told(capsys: Capture, *arguments: object) -> tuple[int, str]:
    code = cli.main(["check", *map(str, arguments)])
    return code, "".join(capsys.readouterr())


def test_a_sheet_as_it_was_drawn_is_whole(folder: Path, capsys: Capture) -> None:
    code, said = told(capsys, folder / NAME)
    assert code == 0 and said.splitlines()[0] == f"{folder / NAME}: лист цел"
    code, said = told(capsys, folder / NAME, "--language", "en")
    assert code == 0 and said.splitlines()[0] == f"{folder / NAME}: whole"


def test_without_a_scene_the_file_alone_is_checked(folder: Path, capsys: Capture) -> None:
    (folder / "fan.toml").unlink()
    code, said = told(capsys, folder / NAME)
    assert code == 4 and "Fix: give its scene with --scene" in said
    assert told(capsys, folder / NAME, "--scene", SCENE)[0] == 0


def test_a_drawing_that_an_editor_saved_anew_is_as_it_was(folder: Path, capsys: Capture) -> None:
    """An editor puts all into a layer, looks into styles, writes numbers otherwise, and indents."""
    text = (folder / NAME).read_text("utf-8")
    text = re.sub(
        r' stroke-linejoin="round" stroke-width="([^"]*)"', r' style="stroke-width:\1;stroke-linejoin:round"', text
    )
    text = text.replace("</metadata>\n", '</metadata>\n<g id="layer1">\n', 1)
    text = text.replace('<metadata id="seal">', "</g>\n  <metadata id='seal'>")
    text = re.sub(r'(x1|y1|cx)="(-?[\d.]+)"', lambda m: f'{m[1]} = "{float(m[2]):.6e}"', text)
    (folder / NAME).write_text(text, "utf-8")
    code, said = told(capsys, folder / NAME, "--language", "en")
    assert code == 5 and "all that is drawn is as it was" in said.splitlines()[0]
    (folder / NAME).write_bytes(other_text().replace(b"<title>", b" <title>"))
    assert "all that is drawn is as it was" not in told(capsys, folder / NAME, "--language", "en")[1]


def test_corners_drawn_otherwise_are_told(folder: Path, capsys: Capture) -> None:
    """A viewer draws corners sharp unless the file says round; a straight line has none to be told of."""
    text = (folder / NAME).read_text("utf-8")
    for element, says in (
        ("line", "all that is drawn is as it was"),
        ("path", "corners of the line miter instead of round"),
    ):
        (folder / NAME).write_text(re.sub(rf'(<{element} [^>]*) stroke-linejoin="round"', r"\1", text), "utf-8")
        code, said = told(capsys, folder / NAME, "--language", "en")
        assert code == 5 and says in said


def other_text() -> bytes:
    leaf = fan().sheets[0].leaf
    table = next(group for group in leaf.groups if group.name == "masses-1")
    cell = next(one for one in texts((table,)) if one.plain == "0,09")
    return svg(swapped(leaf, cell, cell._replace(content="0,08")))


@pytest.mark.parametrize(
    ("content", "code"),
    [(b"%PDF-1.7", 7), (b"", 7), (b"<svg", 5), (b"<svg xmlns='http://www.w3.org/2000/svg'/>", 5), (b"x" * MOST, 8)],
)  # fmt: skip
def test_what_is_no_sheet_is_told_in_one_message(tmp_path: Path, capsys: Capture, content: bytes, code: int) -> None:
    path = tmp_path / "sheet.svg"
    path.write_bytes(content)
    ended, said = told(capsys, path)
    assert ended == code and "Traceback" not in said and ("torn" in said) == (len(content) < MOST)


def test_a_sheet_that_is_not_there_and_the_next_one_are_both_told(folder: Path, capsys: Capture) -> None:
    code, said = told(capsys, folder / "none.svg", folder / NAME, "--language", "en")
    assert code == 7 and "none.svg: cannot be read" in said and f"{NAME}: whole" in said


def test_a_scene_that_is_wrong_ends_the_command(folder: Path, capsys: Capture) -> None:
    (folder / "fan.toml").write_text('title = "x"\n', "utf-8")
    assert told(capsys, folder / NAME)[0] == 3


@pytest.mark.parametrize("kind", first(KINDS))
def test_a_forgery_is_told(kind: str) -> None:
    forgery = forged(fan().sheets[0], kind)
    assert forgery is None or not judged(fan(), forgery, Path())


@pytest.mark.rest
def test_most_kinds_of_forgery_have_a_place_on_the_sheet() -> None:
    assert len([kind for kind in KINDS if forged(fan().sheets[0], kind)]) >= 45


def test_a_right_sheet_is_no_forgery() -> None:
    whole = check(Path(NAME), fan().drawn(fan().sheets[0]), fan())
    assert whole.exit_code == 0 and whole.same == whole.most > 100


@pytest.mark.parametrize("number", first(range(12)))
def test_a_sheet_that_was_changed_at_random_ends_as_it_should(number: int, tmp_path: Path) -> None:
    from random import Random

    chance = Random(f"check {number}")
    source = CHANGES[number % len(CHANGES)](fan().drawn(fan().sheets[0]), chance)
    assert tried(fan(), NAME, source, tmp_path)
