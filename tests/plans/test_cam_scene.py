"""Cams are read from a scene: angles, ways, laws, sizes and loads, exact; what is odd is noted, what is wrong told."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plans.cam.reading.keyways import KEYWAYS
from plans.cam.reading.phase_form import AccelerationShape, cancelled
from plans.model.cam import RETURN, RISE, Cam, Law
from plans.scene.faults import Fault, SceneError
from plans.scene.notes import notes_of
from plans.scene.scene import Scene, parse_scene

FOLLOWER = '[cam.follower]\nmotion = "translating"\nend = "roller"\nlift = "30 mm"\n'
ROCKER = '[cam.follower]\nmotion = "rocking"\nend = "roller"\nswing = 25\nlength = "120 mm"\n'
RISING = '[[cam.phases]]\nkind = "rise"\nangle = 120\nlaw = "sine"\n'
TOP = '[[cam.phases]]\nkind = "dwell"\nangle = 30\n'
BACK = '[[cam.phases]]\nkind = "return"\nangle = 90\nlaw = "3-4-5"\n'
REST = '[[cam.phases]]\nkind = "dwell"\nangle = "rest"\n'
PHASES = RISING + TOP + BACK + REST
LIMITS = "[cam.limits]\nrise = 30\n"


def scene_of(*parts: str, head: str = "") -> Scene:
    return parse_scene(f"[[cam]]\n{head}\n" + "".join(parts))


def cam_of(*parts: str, head: str = "") -> Cam:
    (cam,) = scene_of(*parts, head=head).meaning["cam"].cams
    assert isinstance(cam, Cam)
    return cam


def notes(*parts: str, head: str = "") -> list[Fault]:
    return notes_of(scene_of(*parts, head=head))


def kinds(found: list[Fault]) -> list[str]:
    return [one.kind for one in found]


def refused(*parts: str, head: str = "") -> list[Fault]:
    with pytest.raises(SceneError) as told:
        scene_of(*parts, head=head)
    return list(told.value.faults)


def lawful(law: str, phase: str = RISING) -> Cam:
    return cam_of(FOLLOWER, phase.replace('law = "sine"', f"law = {law}"), TOP, BACK, REST)


def test_a_flat_rocker_has_no_length_but_a_face() -> None:
    flat = '[cam.follower]\nmotion = "rocking"\nend = "flat"\nswing = 20\nface = "-5 mm"\n'
    cam = cam_of(flat, '[cam.sizes]\ncentre = "150 mm"\n', "[cam.limits]\ncurvature = '4 mm'\n", PHASES)
    assert (cam.flat, cam.rocks, cam.follower.length, cam.follower.face, cam.limits.curvature) == (
        *(True, True, None, -0.005),
        0.004,
    )


def test_a_cam_that_translates_goes_by_its_travels() -> None:
    phases = "".join(
        one.replace(f"angle = {old}", f'travel = "{new} mm"')
        for one, old, new in ((RISING, "120", 60), (TOP, "30", 20), (BACK.replace("return", "rise"), "90", 40))
    ).replace('kind = "rise"\n', 'kind = "rise"\nlift = "15 mm"\n')
    cam = cam_of(FOLLOWER, phases, head='speed = "-0.2 m/s"')
    assert (cam.translates, cam.sense, cam.speed, cam.angles) == (True, -1, 0.2, ())
    assert cam_of(FOLLOWER, phases, head='speed = "200 mm/s"').speed == pytest.approx(0.2, rel=1e-15)
    assert cam.turn == pytest.approx(0.12, rel=1e-15)
    assert [one.start for one in cam.phases] == [0, 0.06, 0.08]
    assert cam.lift == pytest.approx(0.03)  # it need not come back: the cam itself does


def test_a_dwell_of_no_angle_is_none() -> None:
    cam = cam_of(FOLLOWER, RISING, TOP.replace("30", "0"), BACK.replace("90", "240"), REST)
    assert ([one.kind for one in cam.phases], cam.angles) == ([RISE, RETURN], (120, 240))


@pytest.mark.parametrize("off", ["1e-6", "-1e-6", "1e-9"])
def test_a_sum_near_a_whole_turn_is_taken_for_one_and_that_is_said(off: str) -> None:
    last = REST.replace('"rest"', str(130 + float(off)))
    phases = RISING + TOP + BACK.replace("90", "80") + last
    assert sum(cam_of(FOLLOWER, phases).angles) == 360
    (note,) = [one for one in notes(FOLLOWER, LIMITS, phases) if one.kind == "turn_snapped"]
    assert note.path == ("cam", 0, "phases", 3, "angle")
    assert str(note.details["found"]).startswith(("360.0", "359.9"))


def test_thirds_of_a_turn_in_radians_make_a_whole_one() -> None:
    third = '"2.0943951023931953 rad"'
    phases = RISING.replace("120", third) + BACK.replace("90", third) + REST.replace('"rest"', third)
    assert sum(cam_of(FOLLOWER, phases).angles) == 360


def test_a_law_by_name_and_share() -> None:
    assert lawful('{ name = "constant acceleration", first = 0.3 }').phases[0].law == Law("constant acceleration", 0.3)
    assert lawful('{ name = "cosine" }').phases[0].law == Law("cosine")


def test_a_table_is_in_shares_of_its_phase_and_its_lift() -> None:
    law = lawful(
        '{ name = "table", points = [[0, 0], [30, "6 mm"], [90, "27 mm"], [120, 0.03]], tolerance = "0.3 mm" }'
    )
    assert law.phases[0].law == Law("table", points=((0, 0), (0.25, 0.2), (0.75, 0.9), (1, 1)), tolerance=0.01)


def test_a_shape_is_taken_as_it_is_if_it_cancels() -> None:
    law = lawful('{ name = "shape", points = [[0, 2], [0.25, 2], [0.25, 0], [0.75, 0], [0.75, -2], [1, -2]] }')
    assert law.phases[0].law == Law("shape", points=((0, 2), (0.25, 2), (0.25, 0), (0.75, 0), (0.75, -2), (1, -2)))


@settings(max_examples=20, deadline=None)
@given(st.lists(st.tuples(st.integers(1, 9), st.integers(-9, 9)), min_size=2, max_size=6))
def test_the_areas_of_a_shape_are_its_whole_area_and_its_factor_cancels_them(pieces: list[tuple[int, int]]) -> None:
    widths = [Fraction(width) for width, _ in pieces]
    points = tuple((sum(widths[:k]) / sum(widths[:-1]), Fraction(y)) for k, (_, y) in enumerate(pieces))
    shape = AccelerationShape(points)
    net = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in pairwise(points))
    assert shape.above - shape.below == net
    if shape.factor:
        found = cancelled(shape)
        assert found.above == found.below


def test_a_shape_lifts_by_what_two_integrations_give() -> None:
    """Of 1 - 2k that is k - k2, then k2/2 - k3/3."""
    assert AccelerationShape(((Fraction(0), Fraction(1)), (Fraction(1), Fraction(-1)))).lift == Fraction(1, 6)


ALL_AT_ONCE = """
[[cam]]
speed = "1 m/s"
[cam.follower]
motion = "rocking"
end = "pointed"
swing = 25
length = "120 mm"
lift = "30 mm"
[cam.sizes]
offset = "5 mm"
roller = "5 mm"
[[cam.phases]]
kind = "rise"
angle = 120
law = { name = "shape", points = [[0, 1], [1, 1]] }
[[cam.phases]]
kind = "return"
angle = 120
law = "sine"
[[cam]]
[cam.follower]
motion = "translating"
end = "flat"
lift = "30 mm"
[[cam.phases]]
kind = "dwell"
angle = 350
law = "sine"
"""


def test_all_that_is_wrong_with_all_cams_is_told_at_once() -> None:
    with pytest.raises(SceneError) as told:
        parse_scene(ALL_AT_ONCE)
    assert [(*fault.path[1:2], fault.kind) for fault in told.value.faults] == [
        (0, "wrong_unit"),
        (0, "out_of_place"),
        (0, "out_of_place"),
        (0, "out_of_place"),
        (0, "phases_short"),
        (1, "way_not_whole"),
        (1, "phases_short"),
        (1, "out_of_place"),
    ]


SIZED = '[cam.sizes]\nbase = "15 mm"\noffset = 0\n'
TABLE = RISING.replace(
    '"sine"', '{ name = "table", points = [[0, 0], [50, "15 mm"], [120, "30 mm"]], tolerance = 0.001 }'
)


@pytest.mark.parametrize(
    ("parts", "head", "expected"),
    [
        ((FOLLOWER, LIMITS, PHASES), "", []),
        ((FOLLOWER, PHASES), "", ["book_rise"]),
        ((FOLLOWER, PHASES), 'closure = "groove"', ["book_rise", "book_return"]),
        ((FOLLOWER, LIMITS, PHASES), 'closure = "groove"', ["book_return"]),
        ((FOLLOWER.replace("roller", "flat"), PHASES), "", ["sharp_face"]),
        ((FOLLOWER.replace("roller", "flat"), '[cam.limits]\ncurvature = "5 mm"\n', PHASES), "", []),
        ((FOLLOWER.replace("roller", "flat"), '[cam.sizes]\nbase = "60 mm"\n', PHASES), "", []),
        ((FOLLOWER, SIZED.replace("15", "16"), PHASES), "", []),
        ((FOLLOWER, SIZED.replace("15", "16").replace("offset = 0\n", ""), PHASES), "", []),
        ((FOLLOWER, SIZED.replace("offset = 0\n", ""), LIMITS, PHASES), "", ["high_lift"]),
        ((FOLLOWER, SIZED, PHASES), "", ["high_lift"]),
        (
            (FOLLOWER, SIZED.replace("offset = 0\n", ""), LIMITS, PHASES),
            'closure = "groove"',
            ["book_return", "high_lift"],
        ),
        ((FOLLOWER, LIMITS, "return = 40\n", PHASES), "", ["free_return"]),
        ((FOLLOWER, LIMITS, "return = 40\n", PHASES), 'closure = "groove"', []),
        ((FOLLOWER, LIMITS, RISING, TOP, TOP, BACK, REST), "", ["two_dwells"]),
        ((FOLLOWER, LIMITS, TABLE, TOP, BACK, REST), "", ["sparse_table", "smoothed"]),
        ((FOLLOWER.replace("roller", "flat"), LIMITS, PHASES), "", ["sharp_face", "level_face"]),
        (
            (FOLLOWER.replace("roller", "flat"), "[cam.sizes]\noffset = 0.01\n", PHASES),
            "",
            ["sharp_face", "spare_offset"],
        ),
        (
            (FOLLOWER, LIMITS, "return = 40\n", PHASES, "[cam.load]\npreload = 5\n"),
            'closure = "groove"',
            ["idle_spring"],
        ),
        ((FOLLOWER, LIMITS, PHASES, "[cam.load]\nmass = 5\n"), "", ["still_cam"]),
        ((FOLLOWER, LIMITS, PHASES, "[cam.load]\nmass = 5\n"), "speed = 5", []),
        ((FOLLOWER.replace('"30 mm"', "30"), LIMITS, PHASES), "", ["metres"]),
    ],
)
def test_what_is_odd_is_noted(parts: tuple[str, ...], head: str, expected: list[str]) -> None:
    assert kinds(notes(*parts, head=head)) == expected


@pytest.mark.parametrize(("speed", "expected"), [("10", []), ("-10", ["other_pace"]), ("11", ["other_pace"])])
def test_cams_of_one_shaft_have_one_speed(speed: str, expected: list[str]) -> None:
    first, second = (f"[[cam]]\nspeed = {one}\n{FOLLOWER}{LIMITS}{PHASES}" for one in ("10", speed))
    assert kinds(notes_of(parse_scene(first + second))) == expected


def test_a_follower_may_stand_still() -> None:
    still = FOLLOWER.replace('"30 mm"', "0")
    assert cam_of(still, PHASES).lift == 0
    assert "no_lift" in kinds(notes(still, PHASES))


def test_a_limit_below_a_degree_is_one_in_radians() -> None:
    (fault,) = refused(FOLLOWER, LIMITS.replace("30", "0.52"), PHASES)
    assert (fault.kind, '"0.52 rad"' in fault.advice) == ("pressure_limit_tiny", True)
    assert cam_of(FOLLOWER, LIMITS.replace("30", '"0.52 rad"'), PHASES).limits.rise == pytest.approx(0.52)
    assert cam_of(FOLLOWER, LIMITS.replace("30", "1"), PHASES).limits.rise == pytest.approx(math.radians(1))


def test_a_roller_is_smaller_than_the_least_radius() -> None:
    sizes = '[cam.sizes]\nbase = "16 mm"\nroller = "15.9 mm"\n'
    assert cam_of(FOLLOWER, sizes, PHASES).roller == 0.0159
    assert kinds(refused(FOLLOWER, sizes.replace("15.9", "16"), PHASES)) == ["roller_beyond"]


@pytest.mark.parametrize(
    ("follower", "roller", "expected"),
    [
        (FOLLOWER, "10", ["huge_roller"]),
        (ROCKER, "10", ["huge_roller"]),
        (FOLLOWER.replace('"30 mm"', "0.05"), "4.9", []),
        (FOLLOWER.replace('"30 mm"', '"0.1 mm"'), '"20 mm"', []),
    ],
)
def test_a_roller_in_metres_is_a_slip(follower: str, roller: str, expected: list[str]) -> None:
    scene = (follower, LIMITS, f"[cam.sizes]\nroller = {roller}\n", PHASES)
    if not expected:
        assert cam_of(*scene).roller is not None
        return
    (fault,) = refused(*scene)
    assert [fault.kind] == expected
    assert '"10 mm"' in fault.advice


# GOST 23360-78: height of the key, and depth in the shaft, mm, of the keys for ever thicker shafts.
KEYS = (
    "2 1.2, 3 1.8, 4 2.5, 5 3, 6 3.5, 7 4, 8 5, 8 5, 9 5.5, 10 6, 11 7, 12 7.5, 14 9, 14 9, 16 10, 18 11, 20 12, "
    "22 13, 25 15, 28 17"
)


def test_a_key_has_room_above_it_in_the_hub() -> None:
    """Both keyways together are deeper than the key is high, by 0.2 to 0.4 mm, more for a larger one."""
    keys = [[Fraction(size) for size in key.split()] for key in KEYS.split(", ")]
    room = [Fraction(row.depth) + shaft - high for row, (high, shaft) in zip(KEYWAYS, keys, strict=True)]
    assert room == sorted(room) and {*room} == {Fraction(1, 5), Fraction(3, 10), Fraction(2, 5)}
    assert all(row.most == other.above and row.width < other.width for row, other in pairwise(KEYWAYS))


def test_a_keyway_is_that_of_the_bore_where_none_is_given() -> None:
    for bore, told, width, depth, standard in (
        (30, "", 8, 3.3, True),  # over 22 to 30 mm
        (31, "", 10, 3.3, True),
        (30, 'width = "7 mm"\n', 7, 3.3, False),
        (5, "width = 0\n", 0, 0, False),
    ):
        hub = cam_of(FOLLOWER, f'[cam.hub]\nbore = "{bore} mm"\n{told}', PHASES).hub
        assert hub is not None and hub.standard == standard
        assert (1000 * hub.width, 1000 * hub.depth) == pytest.approx((width, depth))
