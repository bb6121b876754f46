"""Forces along lines of points and between two links: their directions, both ends, and both roads."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from plans.model.machine import Force
from plans.scene.faults import SceneError, dotted
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from tests.plans.force_cases import ROADS, compared, of_road, statics_of
from tests.plans.test_loading import AGAINST, ENGINE, Loaded, loaded

PUMP = (Path(__file__).parents[1] / "cases/loads/pump.toml").read_text("utf-8")
FORCE = "[[loads.forces]]\n"
ON_ROD = f'{FORCE}on = 2\npoint = "B"\n'
A_AND_B = f'{FORCE}between = [{{ on = 1, point = "A" }}, {{ on = 3, point = "B" }}]\n'
WAYS = np.exp(1j * np.radians([0, 60, 90, 180, 270, 300]))  # of the crank at the positions of the engine


def rods() -> np.ndarray:
    """Give the unit directions from A to B of the engine, A = 0.1 from the shaft and B on the x axis, 0.4 from A."""
    a = 0.1 * WAYS
    return np.asarray((np.sqrt(0.16 - a.imag**2) - 1j * a.imag) / 0.4)


def both(found: Loaded) -> tuple[np.ndarray, np.ndarray]:
    one, other = found.loading.forces
    return one.force, other.force


@pytest.mark.parametrize("by", ROADS)
def test_a_force_along_a_link_turns_with_it(by: str) -> None:
    found = loaded(ENGINE + ON_ROD + 'value = 8\ndirection = "AB"\n', by)
    assert found.machine.forces == (Force("F_B", 2, "B", 0.4, 8.0, None, line=("A", "B")),)
    assert found.force() == pytest.approx(8 * rods(), abs=1e-14)
    back = loaded(ENGINE + ON_ROD + 'value = 8\ndirection = ["B", "A"]\n', by)
    assert back.force() == pytest.approx(-8 * rods(), abs=1e-14)


@pytest.mark.parametrize("by", ROADS)
def test_a_force_between_two_links_pushes_their_points_apart(by: str) -> None:
    found = loaded(ENGINE + A_AND_B + "value = 20\n", by)
    first, second = found.loading.forces
    assert (first.name, first.link, first.point, first.at) == ("F_AB", 1, "A", 0.1)
    assert (second.name, second.link, second.point, second.at) == ("F_AB′", 3, "B", 0)
    assert (first.useful, second.useful) == (True, True)
    assert first.force == pytest.approx(-20 * rods(), abs=1e-13)
    assert (second.force == -first.force).all()
    first, second = both(loaded(ENGINE + A_AND_B + "value = -20\n", by))
    assert first == pytest.approx(20 * rods(), abs=1e-13)
    assert (second == -first).all()


@pytest.mark.parametrize("by", ROADS)
@pytest.mark.parametrize("turned", [False, True])
def test_one_end_may_be_fixed(turned: bool, by: str) -> None:
    ends = ['"O"', '{ on = 3, point = "B" }']
    text = f"{FORCE}between = [{', '.join(ends[::-1] if turned else ends)}]\nvalue = 7\n"
    found = loaded(ENGINE + text, by)
    (end,) = found.loading.forces  # what the frame takes moves nothing
    assert (end.link, end.point) == (3, "B")
    assert end.force == pytest.approx([7] * 6, abs=1e-14)
    told = loaded(ENGINE + text + 'direction = "OB"\n', by)
    assert told.force() == pytest.approx([7 if turned else -7] * 6, abs=1e-14)  # that way on the first


@pytest.mark.parametrize("by", ROADS)
def test_a_force_against_the_motion_of_one_from_the_other(by: str) -> None:
    """Going in through 60 and 90 degrees, the piston nears the shaft: the force parts them; from 180 on it draws."""
    text = f'{FORCE}between = ["O", {{ on = 3, point = "B" }}]\nvalue = 7\n{AGAINST}'
    assert loaded(ENGINE + text, by).force() == pytest.approx([7, 7, 7, -7, -7, -7], abs=1e-14)
    pump = PUMP.replace("value", f"{AGAINST}value")
    # From 0 to 180 degrees A goes away from C and draws the rod out of the cylinder, B back through C.
    (first, second), along = both(loaded(pump, by)), np.radians(np.arange(12) * 30)
    reach = 0.6 - 0.12 * np.exp(1j * along)
    expected = np.where(np.arange(12) < 6, 1, -1) * 3000 * reach / abs(reach)
    assert first == pytest.approx(expected, abs=1e-9)
    assert (second == -first).all()


@pytest.mark.parametrize("road", ROADS)
def test_the_pump_by_both_roads(road: str) -> None:
    """The power of the pressure is P times the speed at which AC shortens: M = P d(AC)/d phi (virtual work)."""
    comparison = compared(PUMP)
    assert comparison.agrees
    phi = np.radians(np.arange(12) * 30)
    far = np.sqrt(0.12**2 + 0.6**2 - 2 * 0.12 * 0.6 * np.cos(phi))
    assert of_road(comparison, road).balancing.moment == pytest.approx(3000 * 0.12 * 0.6 * np.sin(phi) / far, abs=1e-10)


def test_a_force_between_links_of_a_pump_is_no_load_on_the_frame() -> None:
    """Pressure on piston and cylinder is in balance in itself: the frame bears at C what it bears at O."""
    told = compared(PUMP).construction.reactions
    assert told["0-1"].force == pytest.approx(-told["0-3"].force, abs=1e-10)


def test_a_line_off_the_points_of_the_force_is_refused() -> None:
    with pytest.raises(SceneError) as refused:
        _ = statics_of(PUMP.replace('"AB"\nvalue', '"OB"\nvalue')).machine
    (fault,) = refused.value.faults
    assert dotted(fault.path) == "loads.forces[0].direction"
    assert "a line that both points of the force lie on in every position, but OB is off" in str(fault)


@pytest.mark.parametrize(
    ("written", "where", "said"),
    [
        ("value = 3\n", "loads.forces[0]", 'Fix: add on = 2 and point = "B", or between = ["B", "C"]'),
        ("on = 2\nvalue = [1, 0]\n", "loads.forces[0].point", 'Fix: add it: point = "B"'),
        ('point = "B"\nvalue = [1, 0]\n', "loads.forces[0].on", "Fix: add it: on = 2"),
        ('on = 2\nbetween = ["O", "B"]\nvalue = 1\n', "loads.forces[0]", "either on or between, not both"),
        ('between = ["O"]\nvalue = 1\n', "loads.forces[0].between", "the two ends, points of two links, but found 1"),
        ('between = ["O", "B"]\nvalue = 1\n', "loads.forces[0].between[1]", "links 2, 3 have B"),
        ('between = ["O", "E"]\nvalue = 1\n', "loads.forces[0].between[1]", "no point E"),
        (
            'between = ["O", { on = 3, point = "B" }]\nvalue = [1, 2]\n',
            "loads.forces[0].value",
            "because it acts between two points",
        ),
        (
            'between = ["O", { on = 3, point = "B" }]\ndirection = 90\nvalue = 1\n',
            "loads.forces[0].direction",
            "the letters of two points, because a force between two links turns with them",
        ),
        ('on = 2\npoint = "B"\ndirection = "AE"\nvalue = 1\n', "loads.forces[0].direction", "no point E"),
        ('on = 2\npoint = "B"\ndirection = "AA"\nvalue = 1\n', "loads.forces[0].direction", "A"),
        ('on = 2\npoint = "B"\ndirection = "ABO"\nvalue = 1\n', "loads.forces[0].direction", "two points"),
        ('on = 2\npoint = "B"\ndirection = "90 mm"\nvalue = 1\n', "loads.forces[0].direction", "a unit of angle"),
        (
            'on = 2\npoint = "B"\ndirection = "AB"\nagainst = "motion"\nvalue = 1\n',
            "loads.forces[0]",
            "either against or direction",
        ),
    ],
)
def test_a_wrong_use_is_told_with_what_to_write(written: str, where: str, said: str) -> None:
    with pytest.raises(SceneError) as refused:
        loaded('sheets = ["forces"]\n' + ENGINE + FORCE + written)
    (fault,) = refused.value.faults
    assert (dotted(fault.path), said in str(fault)) == (where, True), str(fault)


def test_a_fixed_point_that_a_force_is_hung_on_is_no_spare_one() -> None:
    more = ENGINE.replace("O = [0, 0]", "O = [0, 0]\nK = [0, 1]\nL = [1, 1]")
    assert {note.kind for note in notes_of(parse_scene(more))} == {"spare_point"}
    more += f'{FORCE}between = ["K", {{ on = 3, point = "B" }}]\nvalue = 1\n' + ON_ROD + 'value = 1\ndirection = "BL"\n'
    assert "spare_point" not in {note.kind for note in notes_of(parse_scene(more))}
