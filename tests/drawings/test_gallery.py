"""The gallery: one command draws all of it again as it was; each scene is drawn once for all that is asked of it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from drawings.commands.draw import SheetSet, draw
from drawings.files.sheet_set import read_manifest
from drawings.gallery import __main__ as command
from drawings.gallery import index
from drawings.gallery.catalogue import GALLERY, Entry, catalogue
from drawings.gallery.changes import ALPHABET, LIST, differences, listed, unlisted
from drawings.lettering.lettering import bounds
from drawings.page.page import page_of
from drawings.paper.walk import flat
from drawings.reading.seal import digest, sealed
from plans.scene.scene import read_scene
from plans.study import Study
from tests import parts
from tests.drawings.collisions import collisions

ENTRIES = catalogue()
# Drawn every day: between them they go through 98 % of the lines that drawing all goes through, in a third of its
# time. The others are drawn with `--whole`.
EVERYDAY = {
    "boxer", "centres-shaper", "copying-cam", "coupled-wheels", "crank-rocker", "engine-share", "fan",
    "flat-rocker-cam", "flywheel", "lambda-positions", "lanchester", "offset-engine-balance", "oscillating-cylinder",
    "press", "pulley", "ram-platform", "reciprocating-pump", "riveter", "rocker-cam", "rocking-pump", "sector-balance",
    "shaking-yoke", "shaper-feed", "six-link-balance", "slotted-lever", "slotter", "spatial-rocker", "table-cam",
    "tailgate", "tangent", "tappet-cam", "turbine", "turned-slider-crank", "two-step-cam", "valve-cam", "vee-four",
}  # fmt: skip
LINE = 0.4  # mm: half a thick line, by which a stroke on the frame reaches over it


def shown() -> Iterator[object]:
    """Give the scenes of every day, and with `--whole` the others."""
    for one in ENTRIES:
        if one.name in EVERYDAY or parts.whole:
            yield pytest.param(one, id=one.name, marks=() if one.name in EVERYDAY else pytest.mark.rest)


@pytest.fixture(scope="session", params=list(shown()))
def entry(request: pytest.FixtureRequest) -> Entry:
    """One scene after the other, so that all tests of a scene follow each other."""
    found: Entry = request.param
    return found


@pytest.fixture(scope="session")
def drawn(entry: Entry, tmp_path_factory: pytest.TempPathFactory) -> SheetSet:
    return draw(entry.path, tmp_path_factory.mktemp(entry.name))


# The files of the gallery


def test_its_sheets_and_reports_are_drawn_again_as_they_were(drawn: SheetSet, entry: Entry) -> None:
    assert [one for path in drawn.paths for one in differences(path, GALLERY / path.name)] == []
    sheets = [path for path in drawn.paths if path.suffix == ".svg"]
    assert len(sheets) == len(drawn.sheets) and all(sealed(path.read_bytes()) for path in sheets)
    longer = tuple(f"{other.name}-" for other in ENTRIES if other.name.startswith(f"{entry.name}-"))
    kept = {path.name for path in GALLERY.glob(f"{entry.name}-*.*") if path.suffix in command.WRITTEN}
    assert {name for name in kept if not longer or not name.startswith(longer)} == {p.name for p in drawn.paths}


@pytest.mark.rest  # the kept sheets were so when they were kept
def test_nothing_lies_outside_its_frame_and_no_lettering_touches_anything(drawn: SheetSet, entry: Entry) -> None:
    for leaf in drawn.sheets:
        field = page_of(drawn.study.scene).field
        for group in leaf.groups:
            if group.name != "frame" and [*flat([group])]:
                left, bottom, right, top = bounds(group)
                assert field.left - LINE <= left and right <= field.right + LINE, group.name
                assert field.bottom - LINE <= bottom and top <= field.top + LINE, group.name
    found = [one for leaf in drawn.sheets for one in collisions(leaf)]
    assert found == []


def test_the_scenes_of_every_day_are_scenes_of_the_gallery() -> None:
    assert {one.name for one in ENTRIES} >= EVERYDAY


def test_its_files_are_those_of_one_run() -> None:
    for one in ENTRIES:
        manifest = read_manifest(GALLERY / f"{one.name}-manifest.json")
        assert manifest is not None
        assert manifest.strangers(GALLERY) == []
        assert manifest.scene_digest == digest(one.path.read_bytes())


def test_every_renewal_is_listed_with_its_reason() -> None:
    """A set that was drawn anew by `python -m drawings.gallery --because "..."` is; any other is not."""
    assert unlisted(GALLERY) == []
    assert all(row.because.strip() for row in listed(GALLERY).values())


def test_every_sheet_and_report_belongs_to_a_scene() -> None:
    names = tuple(f"{entry.name}-" for entry in ENTRIES)
    files = {path.name for path in GALLERY.iterdir() if path.suffix in command.WRITTEN}
    pages = {index.PAGE, "README.ru.md", "keys.md", "grading.md", "promises.md"}
    assert [name for name in files - {ALPHABET, *pages} if not name.startswith(names)] == []


def test_every_scene_says_in_its_opening_what_the_mechanism_is_and_gives_its_russian_name() -> None:
    for one in ENTRIES:
        assert len(one.about.split()) > 40, one.name
        assert re.search(r"\([^)]*[а-яё]", one.about), one.name
        assert one.about.endswith((".", ")")), one.name


# The index page


def shaper(*names: str) -> index.GalleryScene:
    (entry,) = (entry for entry in ENTRIES if entry.name == "shaper")
    return index.GalleryScene(entry, Study(read_scene(entry.path)), tuple(map(Path, names)))


def test_the_index_page_has_the_scene_s_row_and_section_and_leads_to_all_that_was_drawn(
    drawn: SheetSet, entry: Entry
) -> None:
    page, exhibit = (GALLERY / index.PAGE).read_text("utf-8"), index.GalleryScene(entry, drawn.study, drawn.paths)
    section = index.section(exhibit)
    assert index.row(exhibit) in page and section in page
    links = set(re.findall(r"\]\(([^)#]+)\)", section))
    assert links == {f"{entry.name}.toml", *(path.name for path in drawn.paths)}


def test_the_index_page_has_nothing_else() -> None:
    page = (GALLERY / index.PAGE).read_text("utf-8")
    assert page.startswith(index.OPENING) and page.endswith(index.CLOSING)
    assert re.findall(r"^## (.*)", page, re.MULTILINE) == [entry.title for entry in ENTRIES]
    assert re.findall(r"\| `([\w-]+)` \|", page) == [entry.name for entry in ENTRIES]


def test_the_index_page_says_the_shaper_s_structure_stroke_and_time_ratio() -> None:
    """K of the crank shaper is (180 + θ)/(180 − θ) with θ = 2 arcsin(120/350), its stroke 2·700·120/350 mm."""
    row = index.row(shaper())
    assert "[Crank shaper](#crank-shaper)" in row
    assert "I(0,1) → II<sub>3</sub>(2,3) → II<sub>2</sub>(4,5)" in row
    assert "stroke 480 mm, K = 1.573" in row


def test_the_index_lists_several_sheets_of_a_scene_in_their_order() -> None:
    names = ("shaper-kinematics.svg", "shaper-kinematics-2.svg", "shaper-report.md")
    section = index.section(shaper(*names))
    assert re.findall(r"!\[[^]]*\]\(([^)]+)\)", section) == list(names[:2])


# The command that draws it again


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """A gallery of one scene, with files of older times and of other hands."""
    (tmp_path / "slider-crank.toml").write_bytes((GALLERY / "slider-crank.toml").read_bytes())
    for name in ("slider-crank-kinematics-2.svg", "slider-crank-forces.svg", "slider-notes.md", "drawn-by-hand.svg"):
        (tmp_path / name).write_text("older", "utf-8")
    return tmp_path


def test_a_reason_draws_a_gallery_and_removes_what_is_stale(small: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = ["slider-crank-kinematics.svg", "slider-crank-forces.svg", "slider-crank-report.md"]
    made += ["alphabet.svg", "README.md"]
    (small / made[1]).unlink()
    assert command.main([str(small), "--because", "the first time"]) == 0
    came = [f"{name}: came" for name in made]
    assert capsys.readouterr().out.splitlines() == [*came, "slider-crank-kinematics-2.svg: went"]
    others = {"slider-crank.toml", "slider-crank-manifest.json", "slider-notes.md", "drawn-by-hand.svg", LIST}
    assert {path.name for path in small.iterdir()} == {*made, *others}
    assert (small / "alphabet.svg").read_bytes() == (GALLERY / "alphabet.svg").read_bytes()
    assert "Engine with an offset cylinder" in (small / "README.md").read_text("utf-8")
    assert unlisted(small) == []


def test_a_scene_that_is_wrong_ends_the_command_with_its_message(
    small: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (small / "slider-crank.toml").write_text('title = "No mechanism"', "utf-8")
    assert command.main([str(small)]) == 3
    assert "slider-crank.toml" in capsys.readouterr().err
    assert (small / "slider-crank-forces.svg").exists()


def test_a_folder_without_scenes_is_no_gallery(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.main([str(tmp_path)]) == 7
    assert "holds no scenes" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
