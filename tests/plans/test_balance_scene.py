"""What a scene says of balancing: read with its units, refused all at once with what would do, noted where odd."""

from __future__ import annotations

import math
import re

import pytest

from plans.balance.reading import notes_of
from plans.linkage.reading.linkage import mechanism_of
from plans.model.balance.linkage import FORCE, FULL, REACTION, SECTOR, SHARE, BalanceTask, Site
from plans.scene.faults import Fault, SceneError
from plans.scene.scene import parse_scene
from tests.gallery import GALLERY
from tests.plans.banks import ENGINE, FOUR_BAR, counterweight

ONE = counterweight("on = 1", "mass = 9")
ALL = 'aim = "full"\n'


def task(text: str, linkage: str = FOUR_BAR) -> BalanceTask:
    scene = parse_scene(linkage + text)
    mechanism_of(scene)
    found: BalanceTask = scene.meaning["balance"].task
    return found


def refused(text: str, linkage: str = FOUR_BAR) -> list[Fault]:
    with pytest.raises(SceneError) as told:
        task(text, linkage)
    assert all(re.search("[а-я]{3}", fault.worded("ru")) for fault in told.value.faults)
    return list(told.value.faults)


def said(text: str, linkage: str = FOUR_BAR) -> list[tuple[str, str]]:
    """Give what is refused, each as its place and its kind."""
    return [(".".join(map(str, fault.path)), fault.kind) for fault in refused(text, linkage)]


def test_a_task_is_read_with_its_units() -> None:
    first = counterweight("on = 1", 'radius = "150 mm"', 'density = "11.3 g/cm3"', 'thickness = "4 cm"')
    second = counterweight("on = 3", 'shape = "sector"', "half_angle = 90")
    assert task(f'[balance]\naim = "full"\n{first}{second}') == BalanceTask(
        FULL, (Site(1, radius=0.15, density=11300.0, thickness=0.04), Site(3, shape=SECTOR, half_angle=math.pi / 2))
    )


@pytest.mark.parametrize(
    ("written", "share", "least"),
    [
        ("share = 0.5", 0.5, FORCE),
        ("share = 0", 0.0, FORCE),
        ("share = 1", 1.0, FORCE),
        ('share = "37.5 %"', 0.375, FORCE),
        ('share = "force"', None, FORCE),
        ('share = "reaction"', None, REACTION),
        ("", None, FORCE),
    ],
)
def test_a_share_is_given_or_sought(written: str, share: float | None, least: str) -> None:
    found = task(f'[balance]\naim = "share"\n{written}\n{ONE}', ENGINE)
    assert (found.aim, found.share, found.least) == (SHARE, share, least)


# Others are rows of the catalogue (tests/catalogue/faults/balancing.toml).
WRONG = {
    "a link that is not there": (
        ALL + ONE + counterweight("on = 7", "mass = 1"),
        "counterweights.1.on",
        "unknown_link",
    ),
    "a share below 0": (f'aim = "share"\nshare = -0.5\n{ONE}', "share", "share_of_mass"),
    "per cent above 100": (f'aim = "share"\nshare = "150 %"\n{ONE}', "share", "share_of_mass"),
    "a share in another word": (f'aim = "share"\nshare = "weights"\n{ONE}', "share", "share_of_mass"),
    "a share without an aim": (f"share = 0.5\n{ONE}", "share", "share_aim"),
    "another word": (f'aim = "static"\n{ONE}', "aim", "choice"),
    "a sector of nothing": (
        ALL + counterweight("on = 1", "shape = 'sector'", "half_angle = 0"),
        "counterweights.0.half_angle",
        "wide_sector",
    ),
    "no mass": (ALL + counterweight("on = 1", "mass = 0"), "counterweights.0.mass", "not_positive"),
    "thickness in another unit": (
        ALL + counterweight("on = 1", "mass = 1", "thickness = '8 kg'"),
        "counterweights.0.thickness",
        "wrong_unit",
    ),
    "single brackets": ('aim = "full"\n[balance.counterweights]\non = 1\nmass = 1', "counterweights", "wrong_type"),
}


@pytest.mark.parametrize("name", WRONG)
def test_each_thing_that_is_wrong_is_one_fault_at_its_key(name: str) -> None:
    text, path, kind = WRONG[name]
    assert said(f"[balance]\n{text}", ENGINE) == [(f"balance.{path}", kind)]


def noted(text: str, linkage: str = FOUR_BAR) -> list[tuple[str, str]]:
    notes = list(notes_of(parse_scene(f"{linkage}[balance]\n{text}")))
    assert all(re.search("[а-я]{3}", note.worded("ru")) for note in notes)
    return [(".".join(map(str, note.path[1:])), note.kind) for note in notes]


@pytest.mark.parametrize(
    ("text", "notes"),
    [
        (ALL + ONE, []),
        (f'aim = "none"\n{ONE}', [("counterweights", "idle_counterweights")]),
        (f'aim = "partial"\n{ONE}', [("aim", "nothing_guided")]),
        (ALL + counterweight("on = 1", "mass = 1099"), []),
        (ALL + counterweight("on = 1", "mass = 1100"), [("counterweights.0.mass", "heavy_counterweight")]),
        (ALL + counterweight("on = 1", "mass = '1100 g'"), []),
        (ALL + counterweight("on = 1", "radius = 150"), [("counterweights.0.radius", "metres")]),
        (ALL + counterweight("on = 1", "radius = '150 m'"), []),
        (ALL + counterweight("on = 1", "at = -150"), [("counterweights.0.at", "metres")]),
        (ALL + counterweight("on = 1", "mass = 1", "density = 7.85"), [("counterweights.0.density", "light_density")]),
        (ALL + counterweight("on = 1", "mass = 1", "density = '7.85 g/cm3'"), []),
        (ALL + counterweight("on = 1", "at = -0.15", "thickness = 30"), [("counterweights.0.thickness", "enormous")]),
    ],
)
def test_what_may_be_a_slip_is_noted(text: str, notes: list[tuple[str, str]]) -> None:
    assert noted(text) == notes


def test_partial_balancing_beside_a_guide_is_no_slip() -> None:
    assert noted(f'aim = "partial"\n{ONE}', ENGINE) == []


def test_a_stone_has_no_line_to_tell_a_place_on() -> None:
    shaper = (GALLERY / "shaper-loaded.toml").read_text("utf-8")
    text = f'[balance]\naim = "full"\n{counterweight("on = 2", "at = 0.1")}'
    assert said(text, shaper) == [("balance.counterweights.0.at", "carrier_line")]
