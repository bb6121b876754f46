"""The machine of a scene: masses, loads, drive and friction in numbers, and every fault in what is said of them."""

from __future__ import annotations

import math
import re

import pytest

from plans.forces.reading.form import ForceForm, LoadsTable
from plans.forces.reading.inventory import letters, machine_of
from plans.linkage.reading.linkage import mechanism_of
from plans.model.machine import (
    ALWAYS,
    GEAR,
    IDLE,
    OUTPUT,
    WORKING,
    Body,
    Diagram,
    Machine,
    Rubbing,
    Spring,
    Track,
    Transmission,
)
from plans.scene.faults import Fault, SceneError, dotted
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene
from tests.plans.test_loading import SHAPER as MACHINE

SHAPER = f'sheets = ["forces"]\n{MACHINE.partition("acceleration")[0]}'
# The shaper of the worked case: what stands in [masses], [loads] and [drive.gear].
WORKED = scene(
    drive_gear="radius = 0.18; at = 210",
    masses='1 = { mass = 6, inertia = 0.25 }; 3 = { mass = "15 kg", inertia = 0.6, centre = "middle" }; '
    "4 = { mass = 3, inertia = 0.01, centre = [0.1, 0] }; 5 = { mass = 25 }",
    loads="gravity = 9.81",
    forces=['on = 5; point = "D"; against = "motion"; value = 1500; during = "working stroke"'],
)
ON_D = '[[loads.forces]]\non = 5\npoint = "D"\n'
# A hinge of three links: connecting rods 2 and 4 both hang on the crank's end.
TWIN = scene(
    frame="O = [0, 0]", links="OA AB B AD D", lengths="OA = 0.1; AB = 0.4; AD = 0.4",
    slides=["link = 3; along = { through = [0, 0] }", "link = 5; along = { through = [0, 0], angle = 90 }"],
    sketch="B = [0.5, 0]; D = [0, 0.4]", drive="link = 1; speed = 10",
)  # fmt: skip


def machine(text: str) -> Machine:
    scene = parse_scene(text)
    return machine_of(scene, mechanism_of(scene))


def faults(text: str) -> tuple[Fault, ...]:
    with pytest.raises(SceneError) as refused:
        machine(text)
    return refused.value.faults


def loads(text: str) -> LoadsTable:
    found = parse_scene(SHAPER + "[loads]\n" + text).of(ForceForm).loads
    assert found is not None
    return found


def test_the_worked_shaper() -> None:
    found = machine(SHAPER + WORKED)
    assert found.bodies == {
        1: Body(1, 6.0, 0.25, 0j),
        3: Body(3, 15.0, 0.6, 0.35 + 0j),
        4: Body(4, 3.0, 0.01, 0.1 + 0j),
        5: Body(5, 25.0, 0.0, 0j),
    }
    assert found.gravity == -9.81j
    (useful,) = found.forces
    assert (useful.name, useful.link, useful.point, useful.at) == ("F_us", 5, "D", 0)
    assert (useful.size, useful.direction, useful.during, useful.useful) == (1500.0, None, WORKING, True)
    assert (useful.diagram, useful.overrun, useful.stroke) == (None, (0.0, 0.0), OUTPUT)
    assert found.transmission == Transmission(GEAR, 0.18, pytest.approx(7 * math.pi / 6), pytest.approx(math.pi / 9))
    assert (found.moments, found.springs, found.friction) == ((), (), {})


@pytest.mark.parametrize(
    ("written", "vector"),
    [
        ("9.81", -9.81j),
        ("0", 0j),
        ("[0, -9.81]", -9.81j),
        ("[1.5, 2]", 1.5 + 2j),
        ('"9810 mm/s2"', -9.81j),
        ('"981 cm/s2"', -9.81j),
    ],
)
def test_gravity_is_downward_or_a_vector(written: str, vector: complex) -> None:
    found = machine(SHAPER + f"[masses]\n5 = {{ mass = 1 }}\n[loads]\ngravity = {written}\n").gravity
    assert found == vector
    assert math.copysign(1, found.imag) == math.copysign(1, vector.imag)


@pytest.mark.parametrize(
    ("written", "size", "direction"),
    [
        ("value = [1500, 0]", 1500, 1),
        ("value = [0, -20]", 20, -1j),
        ('value = ["0.3 kN", 400]', 500, 0.6 + 0.8j),
        ("value = [0, 0]", 0, 1),
        ("value = 1500\ndirection = 180", 1500, -1),
        ('value = 1500\ndirection = "90 deg"', 1500, 1j),
        ('value = 1500\nagainst = "motion"', 1500, None),
    ],
)
def test_a_force_has_a_size_and_a_direction(written: str, size: float, direction: complex | None) -> None:
    (force,) = machine(SHAPER + ON_D + written).forces
    assert (force.size, force.during) == (size, ALWAYS)
    assert force.direction == (None if direction is None else pytest.approx(direction, abs=1e-15))
    if size != 500:  # right angles are exact
        assert force.direction == direction


STEPS = "diagram = { travel = [0, 0.05, 0.95, 1], force = [0, 1500, 1500, 0]"


@pytest.mark.parametrize(
    ("written", "during"),
    [
        (STEPS + ' }\nagainst = "motion"', WORKING),
        (STEPS + ' }\nagainst = "motion"\nduring = "always"', ALWAYS),
        (STEPS + ' }\nagainst = "motion"\nduring = "idle stroke"', IDLE),
        (STEPS + " }\ndirection = 180", ALWAYS),
        (STEPS + ', back = [0, 1, 2, 0] }\nagainst = "motion"', ALWAYS),
        (STEPS + ", back = [0, 1, 2, 0] }\ndirection = 180", ALWAYS),
    ],
)
def test_a_diagram_against_the_motion_is_of_the_working_stroke_unless_it_gives_both(written: str, during: str) -> None:
    (force,) = machine(SHAPER + ON_D + written).forces
    back = (0, 1, 2, 0) if "back" in written else ()
    assert force.diagram == Diagram((0, 0.05, 0.95, 1), (0, 1500, 1500, 0), back)
    assert (force.size, force.during) == (1.0, during)


def test_overruns_the_point_of_the_stroke_and_what_is_no_purpose() -> None:
    more = 'value = 900\nagainst = "motion"\noverrun = [0.05, 0.1]\nstroke = "B"\nuseful = false\nname = "F_т"\n'
    (force,) = machine(SHAPER + ON_D + more).forces
    assert (force.overrun, force.stroke, force.useful, force.name) == ((0.05, 0.1), Track("B"), False, "F_т")
    (both,) = machine(SHAPER + ON_D + 'value = 900\nagainst = "motion"\noverrun = 0.1').forces
    assert both.overrun == (0.1, 0.1)


def test_a_spring_joins_points_of_two_links_or_of_the_frame() -> None:
    springs = machine(
        SHAPER
        + '[[loads.springs]]\nbetween = [{ on = 3, point = "B" }, "O"]\nstiffness = "20 N/mm"\nfree = "80 mm"\n'
        + '[[loads.springs]]\nbetween = [{ on = 1, point = "A" }, { on = 5, point = "D" }]\nstiffness = 500\nfree = 0\n'
    ).springs
    assert springs == (
        Spring("F_s", (3, 0), ("B", "O"), (0.7, 0), 20_000.0, 0.08),
        Spring("F_s1", (1, 5), ("A", "D"), (0.12, 0), 500.0, 0.0),
    )


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (ON_D + 'value = 1\nagainst = "motion"\n' + ON_D + "value = [1, 0]\n", ["F_us", "F_D"]),
        (ON_D + 'value = 1\nagainst = "motion"\n' + ON_D + 'value = 2\nagainst = "motion"\n', ["F_D", "F_D1"]),
        (
            ON_D + 'value = 1\nagainst = "motion"\nuseful = false\n' + ON_D + 'value = 2\nagainst = "motion"\n',
            ["F_D", "F_us"],
        ),
        (ON_D + "value = [1, 0]\n" + ON_D + 'value = [2, 0]\nname = "F_D"\n', ["F_D1", "F_D"]),
        ("[[loads.moments]]\non = 3\nvalue = 1\n" * 2, ["M_3", "M_31"]),
    ],
)
def test_loads_have_letters_of_their_own(text: str, named: list[str]) -> None:
    assert letters(loads(text)) == named


def test_friction_is_that_of_all_pairs_but_those_that_have_their_own() -> None:
    text = SHAPER + "[friction]\ncoefficient = 0.12\nradius = 0.02\nlength = 0.1\n[friction.pairs]\n"
    found = machine(text + '"0-1" = { radius = "30 mm" }\n"0-5" = { coefficient = 0.05 }\n' + LOADED).friction
    assert found == {
        "0-1": Rubbing(0.12, 0.03),
        "0-3": Rubbing(0.12, 0.02),
        "0-5": Rubbing(0.05, 0.0, 0.1),
        "1-2": Rubbing(0.12, 0.02),
        "2-3": Rubbing(0.12, 0.0, 0.1),
        "3-4": Rubbing(0.12, 0.02),
        "4-5": Rubbing(0.12, 0.02),
    }


LOADED = ON_D + "value = [1, 0]\n"
RUBBING = "[friction]\ncoefficient = 0.1\nradius = 0.02\n[friction.pairs]\n"


@pytest.mark.parametrize(
    ("text", "where", "said"),
    [
        ("[[loads.forces]]\non = 0\npoint = 'C'\nvalue = [1, 0]", "loads.forces[0].on", "a load on the frame"),
        ("[[loads.forces]]\non = 5\npoint = 'E'\nvalue = [1, 0]", "loads.forces[0].point", "E is none"),
        (ON_D + "value = 5", "loads.forces[0].value", 'or add against = "motion" or direction'),
        (ON_D + "value = [1, 2]\ndirection = 3", "loads.forces[0].value", "because its direction is given"),
        (ON_D + 'value = 5\ndirection = 3\nagainst = "motion"', "loads.forces[0]", "either against or direction"),
        (ON_D + STEPS + " }", "loads.forces[0].diagram", "or direction in degrees"),
        (ON_D + STEPS + ", back = [1, 2] }\ndirection = 0", "loads.forces[0].diagram", "travel and back lists"),
        (ON_D + STEPS + ", back = [] }\ndirection = 0", "loads.forces[0].diagram", "travel and back lists"),
        (
            ON_D + STEPS + ', back = [0, 1, 1, 0] }\ndirection = 0\nduring = "working stroke"',
            "loads.forces[0].during",
            "leave during out, or back",
        ),
        (
            ON_D + "diagram = { travel = [0.1, 0.6], force = [1, 2] }\ndirection = 0",
            "loads.forces[0].diagram.travel",
            "it covers 0.1 to 0.6",
        ),
        (
            ON_D + "diagram = { travel = [0.1, 1], force = [1, 2] }\ndirection = 0",
            "loads.forces[0].diagram.travel",
            "it covers 0.1 to 1",
        ),
        (ON_D + "diagram = { travel = [], force = [] }\ndirection = 0", "loads.forces[0].diagram.travel", "one entry"),
        (ON_D + "value = [1, 0]\noverrun = 1.2", "loads.forces[0].overrun", "a share of the stroke"),
        (ON_D + "value = [1, 0]\noverrun = [0.1]", "loads.forces[0].overrun", "write [start, end]"),
        (ON_D + "value = [1, 0]\noverrun = [0.5, 0.5]", "loads.forces[0].overrun", "a part of the stroke"),
        (ON_D + "value = [1, 0]\nstroke = 'D'", "loads.forces[0].stroke", "changes over a stroke"),
        (ON_D + "value = [1, 0]\noverrun = 0.1\nstroke = 'C'", "loads.forces[0].stroke", "C is fixed"),
        (ON_D + "value = [1, 0]\noverrun = 0.1\nstroke = 'E'", "loads.forces[0].stroke", "no point E"),
        (ON_D + "value = [1, 0]\nuseful = 1", "loads.forces[0].useful", "true or false"),
        (ON_D + "value = [1, 0]\nname = 'F us'", "loads.forces[0].name", "the letters of a load"),
        (LOADED + "name = 'Q'\n" + LOADED + "name = 'Q'\n", "loads.forces[1].name", "Q is repeated"),
        (
            LOADED + "name = 'Q'\n[[loads.moments]]\non = 3\nvalue = 1\nname = 'Q'\n",
            "loads.moments[0].name",
            "Q is repeated",
        ),
        ("[[loads.springs]]\nbetween = ['B']\nstiffness = 1\nfree = 0", "loads.springs[0].between", "the two ends"),
        (
            "[[loads.springs]]\nbetween = ['D', 'O']\nstiffness = 1\nfree = 0",
            "loads.springs[0].between[0]",
            'links 4, 5 have D. Fix: write { on = 4, point = "D" }',
        ),
        (
            "[[loads.springs]]\nbetween = ['C', 'O']\nstiffness = 1\nfree = 0",
            "loads.springs[0].between",
            "both are on link 0",
        ),
        (
            "[[loads.springs]]\nbetween = [{ on = 4, point = 'C' }, 'O']\nstiffness = 1\nfree = 0",
            "loads.springs[0].between[0].point",
            "C is none",
        ),
        (
            "[[loads.springs]]\nbetween = ['O', { on = 4, point = 'B' }]\nstiffness = 0\nfree = 0",
            "loads.springs[0].stiffness",
            "this stiffness to be greater than 0",
        ),
        (
            "[[loads.springs]]\nbetween = ['O', { on = 4, point = 'B' }]\nstiffness = '3 N*m'\nfree = 0",
            "loads.springs[0].stiffness",
            "a unit of stiffness (N/m, kN/m, N/cm, N/mm, kgf/cm and others)",
        ),
        ("[drive.gear]\nradius = 0.1\nat = 0\npressure_angle = 90\n" + LOADED, "drive.gear.pressure_angle", "45 deg"),
        ("[friction]\nradius = 0.02\n" + LOADED, "friction.coefficient", "coefficient = 0.1"),
        ("[friction]\ncoefficient = -1\nradius = 0.02\n" + LOADED, "friction.coefficient", "not to be negative"),
        (RUBBING + "'0-2' = { radius = 0.1 }\n" + LOADED, "friction.pairs.0-2", "the pairs are 0-1, 0-3, 0-5, 1-2"),
        (RUBBING + "'1-0' = { radius = 0.1 }\n" + LOADED, "friction.pairs.1-0", 'Fix: write "0-1"'),
        (RUBBING + "'A' = { radius = 0.1 }\n" + LOADED, "friction.pairs.A", "the lower number first"),
        (RUBBING + "'0-5' = { radius = 0.1 }\n" + LOADED, "friction.pairs.0-5.radius", "a hinge, which alone has a"),
        (RUBBING + "'0-1' = { length = 0.1 }\n" + LOADED, "friction.pairs.0-1.length", "leave length out"),
        ("[sheet]\nhodographs = ['0-4']\n" + LOADED, "sheet.hodographs[0]", "there is no pair 0-4"),
        ("[sheet]\nhodographs = ['3-2']\n" + LOADED, "sheet.hodographs[0]", 'write "2-3"'),
        ("[sheet]\nforces = [2, 12]\n" + LOADED, "sheet.forces[1]", "a position from 0 to 11"),
        ("[sheet]\nreactions = 'Q'\n" + LOADED, "sheet.reactions", "one of R, P, F"),
    ],
)
def test_a_fault_names_its_key_and_says_what_to_do(text: str, where: str, said: str) -> None:
    (fault,) = faults(SHAPER + text)
    assert dotted(fault.path) == where
    assert said in str(fault)
    assert "Fix: " in str(fault)
    russian = fault.worded("ru").partition("ожидается")
    assert not re.search(r"\b(the|a|of|is|are|or|and|write|but|found|which|leave|link|links)\b", russian[2]), russian


def test_a_pair_of_a_hinge_of_three_links_must_be_one_that_the_groups_hang_on() -> None:
    rubbing = "[friction]\ncoefficient = 0.1\nradius = 0.02\n"
    assert {"1-2", "1-4", "2-4"} <= machine(TWIN + rubbing).friction.keys()
    assert machine(TWIN + rubbing + "[friction.pairs]\n'1-4' = { radius = 0.03 }\n").friction["1-4"].radius == 0.03
    (fault,) = faults(TWIN + rubbing + "[friction.pairs]\n'2-4' = { radius = 0.03 }\n")
    assert "there is no pair 2-4. Fix: the pairs are 0-1, 1-2, 0-3, 2-3, 1-4, 0-5, 4-5" in str(fault)


@pytest.mark.parametrize("text", ["", "[loads]\ngravity = 9.81\n", "[masses]\n3 = { mass = 0 }\n"])
def test_a_sheet_of_forces_needs_something_that_acts(text: str) -> None:
    (fault,) = faults(SHAPER + text)
    assert (fault.kind, fault.path) == ("nothing_acts", ("sheets",))
    assert "add [masses], or forces, moments or springs in [loads]" in str(fault)
    machine(SHAPER.replace('["forces"]', '["kinematics"]') + text)


def noted(text: str) -> list[tuple[str, str]]:
    return [(note.kind, dotted(note.path)) for note in notes_of(parse_scene(text))]


def test_an_inertia_too_large_for_its_link_is_noted_but_of_a_crank_that_may_have_a_flywheel() -> None:
    masses = "[loads]\ngravity = 9.81\n[masses]\n1 = { mass = 6, inertia = 0.25 }\n5 = { mass = 1, inertia = 9 }\n"
    assert noted(SHAPER + WORKED) == []
    assert noted(SHAPER + masses + "4 = { mass = 3, inertia = 0.12 }\n") == []
    assert noted(SHAPER + masses + "4 = { mass = 3, inertia = 0.121 }\n") == [("large_inertia", "masses.4.inertia")]


def test_a_mass_centre_is_noted_that_is_a_whole_length_off_its_link() -> None:
    at = "[loads]\ngravity = 9.81\n[masses]\n{} = {{ mass = 1, centre = [{}, 0] }}\n"
    assert noted(SHAPER + at.format(4, 0.39)) == noted(SHAPER + at.format(4, -0.19)) == []
    assert noted(SHAPER + at.format(4, 0.41)) == [("far_centre", "masses.4.centre")]
    assert noted(SHAPER + at.format(5, 0.69)) == []  # a ram may be as long as the longest link
    assert noted(SHAPER + at.format(5, 0.71)) == [("far_centre", "masses.5.centre")]


def test_weights_left_out_are_noted_where_forces_are_wanted_and_zero_says_that_it_is_meant() -> None:
    masses = "[masses]\n5 = { mass = 1 }\n"
    assert noted(SHAPER + masses) == [("weightless", "masses")]
    assert noted(SHAPER + masses + "[loads]\ngravity = 0\n") == []
    assert noted(SHAPER.replace('["forces"]', '["kinematics"]') + masses) == [("unused", "masses")]
    assert noted(SHAPER + LOADED) == []


@pytest.mark.parametrize(
    ("there", "back", "share"),
    [
        ("5, 5, 7", "6, 6, 9", "1"),  # both ends jump, the last one by more
        ("5, 6, 7", "5, 6, 9", "1"),
        ("5, 5, 5", "2, 2, 2", ""),  # a pump without clearance
        ("9, 9, 5", "2, 3, 5", "0"),
        ("9, 9, 5", "2, 2, 5", ""),
    ],
)
def test_an_indicator_diagram_that_does_not_close_is_noted_once_and_not_where_its_strokes_are_level(
    there: str, back: str, share: str
) -> None:
    card = f"diagram = {{ travel = [0, 0.5, 1], force = [{there}], back = [{back}] }}\ndirection = 0\n"
    found = notes_of(parse_scene(SHAPER + ON_D + card))
    assert [fault.details["travel"] for fault in found] == [share] * bool(share)


def test_a_load_of_a_scene_with_other_faults_is_examined_too() -> None:
    found = faults(SHAPER.replace("OA = 0.120", "OA = 0") + ON_D.replace('"D"', '"E"') + "value = [1, 0]\n")
    assert [fault.kind for fault in found] == ["not_positive", "not_of_link"]


def test_the_middle_is_that_of_the_two_letters_wherever_the_second_has_its_place() -> None:
    """Link 4's second letter D is a point of the ram too, and a point of its own is named before both."""
    placed = '[mechanism.points]\nA1 = { on = 4, at = [0.5, 0.5] }\n[masses]\n4 = { mass = 1, centre = "middle" }\n'
    scene = parse_scene(SHAPER + placed)
    found = machine_of(scene, mechanism_of(scene)).bodies[4].centre
    assert found == pytest.approx(0.1, abs=1e-15)  # half of BD = 0.2, on the link's own x axis


def test_a_gear_is_a_drive_of_its_own_kind() -> None:
    gear = "[drive.gear]\nradius = 0.1\nat = 0\n"
    (fault,) = faults(TWIN + 'balancing = "coupling"\n' + gear)
    assert "either balancing or gear, not both" in str(fault)
    assert machine(TWIN + gear).transmission.kind == GEAR
