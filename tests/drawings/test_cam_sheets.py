"""Sheets of cams that the gallery has not: at fault, without a speed, with limits that crowd, on other paper."""

from pathlib import Path

import pytest

from drawings.commands.draw import draw
from tests.drawings.planting import ROOT
from tests.parts import first

GALLERY = ROOT / "drawings" / "gallery"
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


def drawn(text: str, folder: Path) -> str:
    """Draw a scene, and give what its sheets say."""
    scene = folder / "scene.toml"
    scene.write_text(text, encoding="utf-8")
    sheets = draw(scene, folder)
    assert not sheets.withheld
    return "".join(f"{leaf.description}{leaf.groups}" for own in sheets.leaves.values() for leaf in own)


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
def test_a_cam_that_is_at_fault_or_has_no_speed_is_drawn_as_well(case: tuple[str, ...], tmp_path: Path) -> None:
    """Its flaws are told, in the letters and units that its motion has."""
    name, old, new, told = case
    text = (GALLERY / f"{name}.toml").read_text(encoding="utf-8").replace('language = "ru"', "")
    assert old in text
    assert told in drawn(text.replace(old, new, 1), tmp_path)


@pytest.mark.rest
def test_limits_whose_angles_crowd_have_each_its_own_letter(tmp_path: Path) -> None:
    told = drawn(CROWDED, tmp_path)
    assert "−α_{rise} = −17°" in told and "α_{rise} = 17°" in told
