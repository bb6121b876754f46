"""The sheets of a cam are held to the analysis: what is drawn passes, faults planted into the drawing withhold it.

The tables are tests/cases/cam_drawing_faults.toml, and cam_line_faults.toml of lines, arrows and words.
"""

from __future__ import annotations

from functools import cache, partial
from pathlib import Path

import pytest

from drawings.checks.cam import verify_cam, verify_profile
from drawings.checks.verify import SelfCheckFailed, verify
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.sheets import cam, cam_profile
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.memo import cams_of
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

GALLERY = ROOT / "drawings" / "gallery"
CAMS = ("feed-cam", "rocker-cam", "valve-cam", "tappet-cam", "copying-cam", "table-cam", "flat-rocker-cam", "automaton")
FAULTS = drawing_faults(ROOT / "tests" / "cases" / "cam_drawing_faults.toml")
LINES = drawing_faults(ROOT / "tests" / "cases" / "cam_line_faults.toml")
# A diagram so small that the arcs of both limits of the rise would lie on one place.
CROWDED = """
title = "Crowded"
sheets = ["cam"]
[sheet]
format = "A3"
[[cam]]
speed = "-262 rpm"
[cam.follower]
motion = "rocking"
end = "roller"
swing = 4
turns = "with"
length = "253 mm"
[cam.limits]
rise = 17
return = 22
[[cam.phases]]
kind = "rise"
angle = 87
law = "constant velocity"
[[cam.phases]]
kind = "return"
angle = 117
law = "3-4-5"
[[cam.phases]]
kind = "dwell"
angle = "rest"
"""
SHEETS = {"cam": (cam.leaves, verify_cam.faults), "profile": (cam_profile.leaves, verify_profile.faults)}


@cache
def study_of(name: str, size: str = "", language: str = "", standard: str = "") -> Study:
    """Study a scene of the gallery, on other paper, in another language: its cams are the same on all."""
    lines = (GALLERY / f"{name}.toml").read_text(encoding="utf-8").splitlines()
    asked = {"format": size, "language": language, "standard": standard}
    given = [f'{key} = "{value}"' for key, value in asked.items() if value]
    kept = [one for one in lines if not one.startswith(tuple(f"{key} = " for key, value in asked.items() if value))]
    place = kept.index("[sheet]") + 1
    study = Study(parse_scene("\n".join([*kept[:place], *given, *kept[place:]])))
    return cams_of(study, study_of(name)) if given else study


def checked(leaf: Leaf, sheet: str, study: Study, folder: Path) -> None:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    verify(path, leaf, partial(SHEETS[sheet][1], study=study))


@pytest.mark.parametrize(
    "case",
    first(
        [
            (name, size, language, standard)
            for size, language, standard in (
                ("A3", "ru", "GOST"),
                ("A1", "en", "ISO"),
                ("A4", "en", "GOST"),
                ("A2", "ru", "ISO"),
                ("A1", "ru", "GOST"),
            )
            for name in CAMS
        ]
    ),
)
def test_what_is_drawn_agrees_with_the_analysis(case: tuple[str, str, str, str], tmp_path: Path) -> None:
    study = study_of(*case)
    for leaf in cam.leaves(study):
        checked(leaf, "cam", study, tmp_path)


@pytest.mark.rest
@pytest.mark.parametrize(
    "case",
    first(
        [
            ("tappet-cam", "[cam.limits]", '[cam.sizes]\nbase = "35 mm"\n[cam.limits]', "{min} = −"),
            ("rocker-cam", 'speed = "240 rpm"', "", ""),
            ("tappet-cam", 'end = "flat"', 'end = "flat"\nreach = "20 mm"', "off the face"),
            ("feed-cam", "[cam.limits]", '[cam.sizes]\nbase = "50 mm"\noffset = "-8 mm"\n[cam.limits]', "e = −8"),
            ("feed-cam", "[cam.limits]", '[cam.sizes]\nbase = "50 mm"\noffset = "0.4 mm"\n[cam.limits]', "e = 0.4"),
            ("rocker-cam", 'law = "sine"', 'law = "constant velocity"', "Corner at φ = 120°"),
            ("copying-cam", 'speed = "0.4 m/s"', "", "Soft shock at x = 100 mm: S'' jumps by"),
        ]
    ),
)
def test_a_cam_that_is_at_fault_or_has_no_speed_is_drawn_as_well(
    case: tuple[str, str, str, str], tmp_path: Path
) -> None:
    """Its flaws are told, in the letters and units that its motion has; what is drawn agrees with the analysis."""
    name, old, new, told = case
    text = (GALLERY / f"{name}.toml").read_text(encoding="utf-8").replace('language = "ru"', "")
    assert old in text
    study = Study(parse_scene(text.replace(old, new, 1)))
    leaves = cam.leaves(study)
    for leaf in leaves:
        checked(leaf, "cam", study, tmp_path)
    assert told in leaves[0].description or any(told in str(leaf.groups) for leaf in leaves)


@pytest.mark.rest
def test_limits_whose_angles_crowd_have_each_its_own_letter(tmp_path: Path) -> None:
    study = Study(parse_scene(CROWDED))
    leaf = cam.leaves(study)[0]
    assert "−α_{rise} = −17°" in str(leaf.groups) and "α_{rise} = 17°" in str(leaf.groups)
    checked(leaf, "cam", study, tmp_path)


@pytest.mark.parametrize("fault", first([*FAULTS, *LINES]), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene)
    assert study.comparison("cam").worst <= 1.0
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        for leaf in SHEETS[fault.sheet][0](study):
            checked(leaf, fault.sheet, study, tmp_path)
    assert fault.says in str(told.value)
    assert "against the analysis" not in said(told.value, "ru")


@pytest.mark.rest
@pytest.mark.parametrize(
    "fault",
    [
        ("inversion.py", "middle = sum(ends) / 2\n", "return\n    middle = 0j\n", "the turned face 4 on profile"),
        ("profile_view.py", "return -reach, reach", "return -reach, 1.1 * reach", "the turned face 0 on profile"),
    ],
)
def test_a_face_has_its_reach_and_contact_beyond_it_is_ringed(fault: tuple[str, str, str, str], tmp_path: Path) -> None:
    file, right, wrong, says = fault
    text = (GALLERY / "tappet-cam.toml").read_text(encoding="utf-8").replace('language = "ru"', "")
    study = Study(parse_scene(text.replace('end = "flat"', 'end = "flat"\nreach = "20 mm"')))
    one = DrawingFault("face", "tappet-cam", f"drawings/figures/cam/{file}", right, wrong, says)
    with planted(one), pytest.raises(SelfCheckFailed) as told:
        checked(cam.leaves(study)[0], "cam", study, tmp_path)
    assert says in str(told.value)


def test_every_fault_still_finds_the_text_that_it_replaces() -> None:
    for fault in (*FAULTS, *LINES):
        assert fault.text
