"""What stands on a bare sheet is moved to where it leaves less paper bare, apart from all else."""

from __future__ import annotations

from itertools import combinations

from drawings.layout.arrangement import Arrangement
from drawings.layout.room import room_of
from drawings.layout.slicing import GAP
from drawings.layout.standing import bareness
from drawings.page.page import Field, page_of
from plans.scene.scene import read_scene
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
