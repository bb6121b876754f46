"""The sheet of a cam to be made: its table tells the radii that formulas give, its radii are measured back."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from drawings.checks.letters import unlettered
from drawings.figures.cam import sizes_table
from drawings.figures.cam.manufacturing_figure import Manufacture, manufacture
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.cam_profile import sheets
from plans.scene.scene import Scene, parse_scene
from tests.drawings.cam_contours import EVERY, levers, view_of
from tests.drawings.collisions import collisions
from tests.drawings.exhibits import SHEET, read_back
from tests.drawings.pages import said
from tests.parts import first, several


def scene(size: str = "A3", language: str = "en") -> Scene:
    return parse_scene(SHEET.format(format=size, language=language))


@cache
def made(name: str, size: str = "A3", language: str = "en") -> tuple[Manufacture, tuple[Leaf, ...]]:
    shown = manufacture(view_of(name).found)
    return shown, sheets(scene(size, language), [shown])


@cache
def measured(name: str) -> Measured:
    return read_back(made(name)[1][0])


def table(name: str, size: str = "A3") -> dict[str, tuple[str, ...]]:
    """Give the rows of the table as they are read."""
    _, leaves = made(name, size)
    rows: dict[str, tuple[str, ...]] = {}
    for group in (one for leaf in leaves for one in leaf.groups if one.name.startswith("radii")):
        told = said(group)[3:]
        rows |= {told[k]: tuple(told[k + 1 : k + 3]) for k in range(0, len(told), 3)}
    return rows


@pytest.mark.parametrize("name", first(["clockwise", "offset", "flat", "rocker", "against", "flat rocker"]))
def test_the_table_tells_the_radii_of_formulas(name: str) -> None:
    """Polar radius and angle from the first point, against the rotation; of a groove those of its middle."""
    shown, _ = made(name)
    rows, cam = table(name), shown.view.cam
    phi = np.radians([float(turned) for turned in rows])
    tip, lever = levers(cam, shown.view.sizes, phi)
    off = 0.0 if shown.table.grooved else shown.view.found.roller
    spots = (tip - off * lever / abs(lever)) * np.exp(-1j * cam.sense * phi)
    turns = np.degrees(-cam.sense * np.angle(spots / spots[0]))
    for (radius, angle), spot, turn in zip(rows.values(), spots, turns, strict=True):
        assert float(radius) == pytest.approx(1000 * abs(spot), abs=5.01e-4)
        assert math.remainder(float(angle) - turn, 360.0) == pytest.approx(0.0, abs=5.01e-4)


def test_a_cam_that_translates_is_told_by_coordinates() -> None:
    shown, _ = made("wedge")
    rows = table("wedge")
    x = np.array([float(travelled) for travelled in rows]) / 1000
    tip, lever = levers(shown.view.cam, shown.view.sizes, x)
    spots = 1000 * (tip + shown.view.cam.sense * x - shown.view.found.roller * lever / abs(lever))
    for cells, spot in zip(rows.values(), spots, strict=True):
        across, up = (float(cell.replace("−", "-")) for cell in cells)
        assert complex(across, up) == pytest.approx(spot, abs=8e-4)


@pytest.mark.parametrize("name", first(["groove", "wedge", "clockwise", "undercut"]))
def test_radii_are_measured_back(name: str) -> None:
    shown, _ = made(name)
    seen = {one.position: one for one in measured(name).vectors}
    rays = dict(enumerate(shown.table.rays()))
    assert seen.keys() == rays.keys()
    for number, (k, _) in rays.items():
        end = complex(shown.table.told[k])
        start = complex(end.real) if shown.view.cam.translates else 0j
        assert abs(seen[number].value - (end - start)) < 2 * measured(name).quantum * seen[number].scale


@pytest.mark.rest
def test_as_many_rows_as_the_paper_takes() -> None:
    assert list(table("groove"))[:3] == ["0", "5", "10"]
    assert len(table("groove")) == 72
    assert list(table("against", "A4"))[:3] == ["0", "10", "20"]
    assert len(made("against", "A4")[1]) == 1


def test_it_is_drawn_at_its_own_size_where_it_can_be() -> None:
    scales = {one.scale for name in ("groove", "wedge") for one in measured(name).vectors}
    assert scales == {0.001}


@pytest.mark.parametrize(("name", "format_", "wide"), [("groove", "A1", 420.0), ("rocker", "A1", 420.0)])
def test_it_lies_on_the_smallest_format_that_takes_it_at_its_own_size(name: str, format_: str, wide: float) -> None:
    """The format of the scene is the largest: what stands at 1:1 with its whole table on A3 lies on A3."""
    (leaf,) = made(name, format_)[1]
    assert leaf.width == wide
    assert {one.scale for one in read_back(leaf).vectors} == {0.001}
    assert "1:1" in [text for group in leaf.groups if group.name == "title-block" for text in said(group)]
    assert len(table(name, format_)) == 72


def test_a_smaller_format_lies_as_the_scene_wants_it() -> None:
    """A4 only stands upright: a scene that wants its sheets lying has the profile on no less than A3."""
    lying = scene().changed(sheet=scene().sheet.changed(orientation="landscape"))
    assert [leaf.width for leaf in sheets(lying, [made("wedge")[0]])] == [420.0]


def test_where_nothing_takes_it_at_its_own_size_it_lies_on_the_format_of_the_scene() -> None:
    (leaf,) = made("rocker", "A4")[1]
    assert leaf.width == 210.0
    assert {one.scale for one in read_back(leaf).vectors} == {0.002}


@pytest.mark.parametrize(
    ("name", "language", "notes"),
    several(
        [
            ("groove", "en", ("counter-clockwise", "Groove 26.132 mm wide", "r_{r} = 13.066 mm", "path of the mill's")),
            (
                "clockwise",
                "ru",
                ("по часовой стрелке", "Паз шириной 26,132 мм", "r_{р} = 13,066", "32,665, φ 240 … 360°"),
            ),
            ("undercut", "en", ("Roller", "Not to be made: ", "undercut", "crosses itself", "0.0001 mm at most")),
            ("wedge", "en", ("goes to the left", "Datum: O, where the follower's point")),
        ],
        2,
    ),
)
def test_notes_tell_what_a_workshop_must_know(name: str, language: str, notes: tuple[str, ...]) -> None:
    _, (leaf, *_) = made(name, "A3", language)
    for one in notes:
        assert one in leaf.description, one


@pytest.mark.parametrize(
    "case",
    first([(name, size, language) for name in EVERY for size, language in (("A3", "en"), ("A4", "ru"), ("A1", "ru"))]),
)
def test_letters_are_clear_of_all_lines(case: tuple[str, str, str]) -> None:
    for leaf in made(*case)[1]:
        assert collisions(leaf) == []
        assert list(unlettered(leaf)) == []


@pytest.mark.rest
def test_several_cams_have_a_sheet_each() -> None:
    leaves = sheets(scene(), [made("groove")[0], made("wedge")[0]])
    assert [leaf.metadata["number"] for leaf in leaves] == [1, 2]
    assert all(leaf.metadata["cam"] == "K1" and "K1" in leaf.title for leaf in leaves)


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        (
            "groove",
            {"R0, mm": "32.665", "e, mm": "2.2204", "S0, mm": "32.589", "rr, mm": "13.066", "ρmin, mm": "29.610"},
        ),
        ("rocker", {"L, mm": "136.37", "ψ0, °": "14.866", "Ψ, °": "25.000"}),
    ],
)
def test_sizes_are_told_as_the_book_has_them(name: str, rows: dict[str, str]) -> None:
    """Numbers of M2.7, M2.9 and M2.13."""
    found = view_of(name).found
    own = sizes_table.quantities(found)
    block = sizes_table.sizes(own, own, True, drafting_of(scene()))
    told = {line.name.replace("_", "").replace("{", "").replace("}", ""): line.cells for line in block.lines}
    assert {name: told[name][0] for name in rows} == rows
    assert told["Ψ, °" if name == "rocker" else "H, mm"][1] == "given"


def test_shocks_are_told_with_their_places() -> None:
    """M2.5: under constant acceleration the jump in the middle is twice that at the ends."""
    found = view_of("radial").found
    own = {one.letter + one.where: one.value for one in sizes_table.quantities(found)}
    omega, angle = 10.0, math.radians(120)
    end = 4 * 0.03 / angle**2 * omega**2
    assert own["Δa_{1}"] == pytest.approx(end)
    assert own["Δa_{2}"] == pytest.approx(-2 * end)
    assert own["Δa_{2}cam angle at"] == pytest.approx(60.0)
    assert own["v_{max}"] == pytest.approx(max(2 * 0.03 / angle, math.pi / 2 * 0.03 / math.radians(90)) * omega)
