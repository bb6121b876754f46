"""The composition of sheets: the largest standard scales, nothing over anything else, following sheets where needed."""

from __future__ import annotations

import itertools
import math

import pytest

from drawings.layout.composer import compose
from drawings.layout.contents import Composition, Contents, Panel
from drawings.layout.footing import Notes, feet
from drawings.layout.grid import Grid, grid
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.table import RuledTable, Setting, TableRow
from drawings.page.page import Field, Page

BLOCK = Field(215.0, 0.0, 400.0, 55.0)


def plan(name: str, wide: float, high: float, least: float = 0.0) -> Picture:
    return picture(name, [0j, complex(wide, high)], ("v", "m/s"), Margins(10.0, 10.0, 20.0), 60.0, least)


def table(rows: int, positions: int) -> RuledTable:
    lines = tuple(TableRow(f"v_{k}", ("1.0",) * 3 * positions) for k in range(rows))
    return RuledTable(lines, tuple(range(positions)), 3.5, 20.0, 20.0)


def inside(box: Field, room: Field) -> bool:
    slack = 1e-6
    return (
        box.left >= room.left - slack
        and box.bottom >= room.bottom - slack
        and box.right <= room.right + slack
        and box.top <= room.top + slack
    )


def apart(one: Field, other: Field) -> bool:
    slack = 1e-6
    return (
        one.right <= other.left + slack
        or other.right <= one.left + slack
        or one.top <= other.bottom + slack
        or other.top <= one.bottom + slack
    )


def test_a_ladder_lists_the_standard_scales_from_the_largest_that_fits() -> None:
    rungs = plan("p", 2.0, 1.0).ladder(220.0, 200.0).rungs
    assert [rung.scale.mu for rung in rungs[:5]] == [0.01, 0.02, 0.025, 0.04, 0.05]
    assert rungs[0].wide == 220.0 and rungs[0].extent == 200.0 and rungs[0].high == 130.0


def test_a_picture_that_is_one_point_has_one_scale() -> None:
    assert len(plan("at rest", 0.0, 0.0).ladder(100.0, 100.0).rungs) == 1


@pytest.mark.parametrize("size", [(400.0, 300.0), (250.0, 500.0), (600.0, 200.0)])
def test_every_picture_of_a_grid_stands_in_its_room_and_apart_from_the_others(size: tuple[float, float]) -> None:
    pictures = [plan("a", 1.3, 0.4), plan("b", 0.2, 0.7), plan("c", 3.0, 2.9), plan("d", 0.05, 0.01)]
    ladders = [one.ladder(*size) for one in pictures]
    found = grid([ladders[:2], ladders[2:]], *size)
    assert found is not None
    room = Field(0.0, 0.0, *size)
    boxes = [spot.box for spot in found.spots(room).values()]
    assert len(boxes) == 4 and all(inside(box, room) for box in boxes)
    assert all(apart(one, other) for one, other in itertools.combinations(boxes, 2))


def test_no_picture_of_a_grid_could_be_drawn_larger() -> None:
    ladders = [one.ladder(400.0, 300.0) for one in (plan("a", 1.3, 0.4), plan("b", 0.2, 0.7))]
    found = grid([ladders], 400.0, 300.0)
    assert found is not None
    for k, (one, rung) in enumerate(zip(ladders, found.rungs[0], strict=True)):
        place = one.rungs.index(rung)
        if place:
            grown = [*found.rungs[0]]
            grown[k] = one.rungs[place - 1]
            larger = Grid([ladders], (tuple(grown),)).size
            assert larger[0] > 400.0 or larger[1] > 300.0


def test_pictures_that_no_scale_fits_into_a_room_make_no_grid() -> None:
    assert grid([[plan("a", 1.0, 1.0).ladder(50.0, 50.0)]], 50.0, 50.0) is None


@pytest.mark.parametrize("block", [None, BLOCK])
@pytest.mark.parametrize("setting", [None, Setting(2, 1), Setting(1, 2)])
@pytest.mark.parametrize("notes", [None, Notes((120.0, 40.0, 200.0), 6.3)])
def test_table_notes_and_title_block_never_stand_on_each_other(
    block: Field | None, setting: Setting | None, notes: Notes | None
) -> None:
    column, values = Field(0.0, 6.0, 400.0, 300.0), table(8, 2)
    ways = list(feet(column, block, values if setting else None, setting, notes))
    assert ways
    for foot in ways:
        parts = [] if block is None else [block]
        if setting is not None:
            assert foot.table is not None
            wide, high = values.size(setting)
            left, top = foot.table.real, foot.table.imag
            parts.append(Field(left, top - high, left + wide, top))
        if notes is not None:
            assert foot.notes is not None
            parts.append(foot.notes)
        assert all(apart(one, other) for one, other in itertools.combinations(parts, 2)), foot
        assert all(part.top <= foot.top + 1e-6 for part in parts) and all(part.right <= 400.0 for part in parts)


MECHANISM = picture("positions", [0j, 0.5 + 0.3j], ("l", "m"), Margins(18.0, 18.0, 70.0), 80.0)


def contents(count: int, rows: int = 10, least: float = 60.0, main: Picture = MECHANISM) -> Contents:
    velocities = [Panel(plan(f"velocities-{k}", 1.0 + 0.3 * k, 0.8, least), together=f"{k}") for k in range(count)]
    others = [Panel(plan(f"accelerations-{k}", 9.0, 4.0 + k, least), together=f"{k}") for k in range(count)]
    panels = (Panel(main, 1.5), *velocities, *others)
    return Contents(panels, (table(rows, count),), Notes((150.0, 60.0, 90.0), 6.3))


def main_of(one: Composition) -> Spot:
    return one.spots["positions"]


def test_two_positions_of_a_crank_rocker_go_on_one_sheet_and_fill_it() -> None:
    (only,) = compose(contents(2), Page("A1"))
    assert main_of(only).scale.mu in (0.001, 0.002)
    field = Page("A1").field
    boxes = [spot.box for spot in only.spots.values()]
    assert all(inside(box, field) for box in boxes)
    assert all(apart(one, other) for one, other in itertools.combinations([*boxes, Page("A1").block], 2))
    assert sum(box.width * box.height for box in boxes) > 0.5 * field.width * field.height


def test_plans_that_would_be_drawn_smaller_than_their_letters_go_on_a_following_sheet() -> None:
    composed = compose(contents(6, least=100.0), Page("A2"))
    assert len(composed) > 1 and list(composed[0].spots) == ["positions"]
    shown = [name for one in composed for name in one.spots if name.startswith("velocities")]
    assert shown == [f"velocities-{k}" for k in range(6)]
    assert all("positions" not in one.spots for one in composed[1:])


def test_a_tall_mechanism_on_a_sheet_of_its_own_stands_beside_the_title_block() -> None:
    tall = contents(6, least=100.0, main=picture("positions", [0j, 0.45 + 1.2j], ("l", "m"), Margins(12, 12, 50), 80))
    page = Page("A3", standard="ISO")
    first = compose(tall, page)[0]
    assert main_of(first).scale.mu == 0.01
    low = picture("positions", [0j, 0.8 + 0.9j], ("l", "m"), Margins(12, 12, 50), 80)
    first = compose(contents(6, least=100.0, main=low), page)[0]
    assert main_of(first).scale.mu == 0.005
    assert apart(main_of(first).box, page.block) and inside(main_of(first).box, page.field)


def test_a_table_longer_than_a_sheet_is_continued_on_the_next() -> None:
    composed = compose(contents(2, rows=400), Page("A2"))
    rows = [len(own.table.lines) for one in composed for own in one.tables]
    assert sum(rows) == 400 and len(rows) > 1


def test_the_plan_of_positions_takes_about_half_the_sheet() -> None:
    long = picture("positions", [0j, 1.5 + 0.1j], ("l", "m"), Margins(18, 18, 70), 80.0)
    (only,) = compose(contents(2, main=long), Page("A1"))
    assert main_of(only).box.width >= 0.45 * Page("A1").field.width


def test_a_wide_table_is_set_in_bands_under_each_other() -> None:
    values = table(5, 6)
    sizes = {setting: values.size(setting) for setting in values.settings() if setting.parts == 1}
    widths = [sizes[Setting(across, 1)][0] for across in (6, 3, 2, 1)]
    assert widths == [380.0, 200.0, 140.0, 80.0]
    assert math.isclose(sizes[Setting(3, 1)][1], 2 * 7 * 7.0 + 6.0)
