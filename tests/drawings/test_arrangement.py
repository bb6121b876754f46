"""What stands on a bare sheet is moved to where it leaves less paper bare, apart from all else."""

from __future__ import annotations

from itertools import combinations

from drawings.layout.arrangement import Arrangement, enlarged
from drawings.layout.room import room_of
from drawings.layout.slicing import GAP
from drawings.layout.standing import bareness
from drawings.page.page import Field, Page, page_of
from plans.scene.scene import read_scene
from tests.drawings.test_slicing import apart, inside
from tests.gallery import LINKAGES


def test_things_above_one_another_are_moved_apart_where_strips_would_stay_bare() -> None:
    scene = read_scene(LINKAGES[0])
    page = page_of(scene.changed(sheet=scene.sheet.changed(format="A4", orientation=None)))
    room = room_of(page)
    left = room.left + room.width / 2 - 45.0
    before = {
        0: Field(left, room.top - 120.0, left + 90.0, room.top - 40.0),
        1: Field(left, page.block.top + GAP, left + 90.0, room.top - 125.0),
    }
    after = Arrangement(page, room, 0.0, lambda k, box: (box,), lambda k: ()).arranged(before)
    assert bareness([*after.values(), *page.taken], page.field) < bareness([*before.values(), *page.taken], page.field)
    for one, other in combinations((*after.values(), page.block), 2):
        apart = one.left - other.right, other.left - one.right, one.bottom - other.top, other.bottom - one.top
        assert max(apart) > GAP - 1e-6
    assert all(room.left <= box.left and box.right <= room.right and box.top <= room.top for box in after.values())


def test_what_has_become_larger_stands_near_and_one_other_thing_makes_way_for_it() -> None:
    page = Page("A3")
    room = room_of(page)
    top, middle = room.top - 40.0, room.centre.real
    plan, table = (
        Field(middle - 50.0, top - 80.0, middle + 50.0, top),
        Field(middle + 60.0, top - 80.0, middle + 100.0, top),
    )
    assert enlarged(0, (120.0, 90.0), {0: plan}, page, room) == {
        0: Field(middle - 60.0, top - 90.0, middle + 60.0, top)
    }
    beside = enlarged(0, (120.0, 90.0), {0: plan, 1: table}, page, room)
    assert beside is not None and beside[1] == table and beside[0].right == table.left - GAP
    notes = plan._replace(left=middle - 150.0, right=middle - 100.0)
    wide = enlarged(0, (180.0, 90.0), {0: plan, 1: table, 2: notes}, page, room)
    assert wide is not None and wide[1].left == wide[0].right + GAP and wide[2] == notes
    assert all(inside(box, room) and apart(box, page.block) for box in wide.values())
    assert enlarged(0, (room.width, room.height), {0: plan}, page, room) is None
