"""What both roads read alike - signs, sides, senses - by values worked by hand from the geometry of each case."""

from __future__ import annotations

from decimal import Decimal
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.forces.loading import OutputStroke
from plans.forces.reading.inventory import machine_of
from plans.forces.statics import Statics
from plans.linkage.reading.guides import direction, triangle
from plans.linkage.reading.linkage import mechanism_of
from plans.linkage.study import LinkageStudy
from plans.model.machine import Machine
from plans.model.mechanism import Mechanism
from plans.model.motion import LinkMotion, Motion
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene

# The datum is the crank's hinge O; the slider's line leans by 30 degrees and passes half a metre above O. Of the
# triangle ABE with sides 0.5, 0.3 and 0.4 m the foot of E is 0.18 m from A, its height 0.24 m.
LEANING = scene(
    frame="O = [1, 2]; C = [1.3, 1.6]", links="OA ABE B", lengths="OA = 0.1; AB = 0.5; AE = 0.3; BE = 0.4",
    slides=["link = 3; along = { through = [1, 2.5], angle = 30 }; offset = 0.05; angle = 20"],
    sketch="B = [1.6, 2.9]; E = [1.15, 2.35]",
    drive='link = 1; speed = "-60 rpm"; acceleration = 3; start = 30; positions = 4',
)  # fmt: skip
# The slotted link CB turns about C, 0.4 m below O; the stone's line is 0.02 m to the right of its pin A, and the
# stone's own +x axis makes 15 degrees with the line from C to B.
SLOTTED = scene(
    frame="O = [0, 0]; C = [0, -0.4]", links="OA A CB", lengths="OA = 0.1; CB = 0.7",
    slides=['link = 2; along = "CB"; offset = 0.02; angle = 15'], sketch="B = [0.1, 0.3]",
    drive="link = 1; speed = 5; positions = [0]",
)  # fmt: skip
# The crank alone, 0.4 m long, along +x: what holds it is read off by one moment.
CRANK = scene(
    'sheets = ["forces"]', frame="O = [0, 0]; D = [0.4, 0.3]", links="OA", lengths="OA = 0.4",
    drive="link = 1; speed = SPEED; acceleration = ACCELERATION; positions = [0]",
)  # fmt: skip
# Crank 0.1 m and rod 0.3 m in line with the guide: B is at 0.4 m where the crank is at 0, at 0.2 m half a turn on.
ENGINE = scene(
    'sheets = ["forces"]', frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.1; AB = 0.3",
    slides=["link = 3; along = { through = [0, 0], angle = 0 }"], sketch="B = [0.4, 0.001]",
    drive="link = 1; speed = SPEED; positions = ANGLES", forces=['on = 3; point = "B"'],
)  # fmt: skip


def mechanism(text: str) -> Mechanism:
    return mechanism_of(parse_scene(text))


def machine(text: str) -> Machine:
    scene = parse_scene(text)
    return machine_of(scene, mechanism_of(scene))


def solved(text: str, degrees: float) -> Motion:
    return Analysis(mechanism(text)).motion(np.array([radians(degrees)]))


def near(value: complex) -> object:
    return pytest.approx(value, abs=1e-12)


# Directions, places and sides


@pytest.mark.parametrize(
    ("degrees", "unit"),
    [(0, 1), (90, 1j), (180, -1), (-90, -1j), (30, sqrt(3) / 2 + 0.5j), (-60, 0.5 - sqrt(3) / 2 * 1j)],
    ids=["at 0", "at 90", "at 180", "at -90", "at 30", "at -60"],
)
def test_angles_are_counter_clockwise_from_x(degrees: int, unit: complex) -> None:
    assert direction(Decimal(degrees)) == near(unit)


def test_places_of_the_frame_are_measured_from_the_crank_s_hinge() -> None:
    read = mechanism(LEANING)
    assert read.links[0].points == {"O": 0, "C": near(0.3 - 0.4j)}
    assert read.sketch == {"B": near(0.6 + 0.9j), "E": near(0.15 + 0.35j)}
    assert (read.drive.pivot, read.drive.end) == ("O", "A")


@pytest.mark.parametrize(("sketch", "place"), [("[1.15, 2.35]", 0.18 + 0.24j), ("[1.5, 2.1]", 0.18 - 0.24j)])
def test_a_third_point_is_on_the_side_that_the_sketch_shows(sketch: str, place: complex) -> None:
    """From A at (1.087, 2.05) to B at (1.6, 2.9): (1.15, 2.35) is to the left, (1.5, 2.1) to the right."""
    assert mechanism(LEANING.replace("E = [1.15, 2.35]", f"E = {sketch}")).links[2].points["E"] == near(place)


def test_the_crank_s_end_is_where_its_first_angle_puts_it() -> None:
    """At 250 degrees A is at (0.966, 1.906): from there to B the point (1.02, 2.05) is to the left, at 30 it is not."""
    text = LEANING.replace("E = [1.15, 2.35]", "E = [1.02, 2.05]").replace("B = [1.6, 2.9]", "B = [1.0, 2.9]")
    assert mechanism(text).links[2].points["E"] == near(0.18 + 0.24j)
    other = text.replace("start = 30", "start = 110")  # A at (0.966, 2.094), E below it and to the right of B
    assert mechanism(other).links[2].points["E"] == near(0.18 - 0.24j)


def test_the_foot_of_a_blunt_triangle_is_behind_its_first_point() -> None:
    foot, height = triangle(Decimal("0.5"), Decimal("0.3"), Decimal("0.7")) or (Decimal(0), Decimal(0))
    assert (float(foot), float(height)) == pytest.approx((-0.15, sqrt(0.09 - 0.0225)))


def test_a_point_by_its_place_keeps_both_signs() -> None:
    text = (
        LEANING.replace('2 = "ABE"', '2 = "AB"').replace("AE = 0.3\nBE = 0.4\n", "").replace("E = [1.15, 2.35]\n", "")
    )
    read = mechanism(f"{text}[mechanism.points]\nE = {{ on = 2, at = [-0.2, 0.09] }}\n")
    assert read.links[2].points["E"] == near(-0.2 + 0.09j)


# Slides


def test_the_line_of_the_frame_passes_through_its_point_at_its_angle() -> None:
    """The foot of O on the line is 0.5 cos 30 = 0.433 m from it, at 120 degrees."""
    way = mechanism(LEANING).slides[0].on_owner
    assert way.direction == near(cos(radians(30)) + 0.5j)
    assert way.through == near(-0.5 * cos(radians(30)) * 0.5 + 0.5 * cos(radians(30)) ** 2 * 1j)


def test_a_slider_s_point_is_offset_to_the_left_and_its_x_axis_leans_from_the_line() -> None:
    """B is 0.05 m to the left of the line that leans by 30 degrees, and link 3 stands at 30 + 20 degrees."""
    motion = solved(LEANING, 30)
    way, b = complex(cos(radians(30)), 0.5), complex(motion.points["B"].r[0])
    assert ((b - 0.5j) * way.conjugate()).imag == near(0.05)
    assert float(np.degrees(motion.links[3].angle[0])) == pytest.approx(50)


def test_a_stone_s_pin_is_offset_to_the_left_of_the_slot_looking_along_it() -> None:
    """A at (0.1, 0), C at (0, -0.4): CA is sqrt(0.17) m at 75.96 degrees; the slot stands arcsin(0.02/CA) to its right.

    The pin is 0.02 m to the left of the slot, so the slot's direction is clockwise of CA.
    """
    motion = solved(SLOTTED, 0)
    slot = np.arctan2(0.4, 0.1) - np.arcsin(0.02 / sqrt(0.17))
    assert motion.links[3].angle[0] == near(slot)
    assert motion.links[2].angle[0] == near(slot + radians(15))


def test_a_line_by_two_letters_runs_from_the_first_to_the_second() -> None:
    there, back = (mechanism(SLOTTED.replace('"CB"\noff', f'"{line}"\noff')).slides[0] for line in ("CB", "BC"))
    assert (there.on_owner.through, there.on_owner.direction) == (0, 1)
    assert (back.on_owner.through, back.on_owner.direction) == (near(0.7), -1)


# The drive


def test_a_negative_speed_is_clockwise() -> None:
    read, study = mechanism(LEANING), LinkageStudy(parse_scene(LEANING))
    assert (read.drive.omega, read.drive.epsilon) == (pytest.approx(-2 * pi), 3)
    assert np.degrees(study.turn.phi).tolist() == pytest.approx([30, -60, -150, -240])
    a = study.motion(1).points["A"]
    assert a.r[0] == near(0.1 * complex(cos(radians(30)), sin(radians(30))))
    assert a.v[0] == near(-0.2 * pi * complex(-sin(radians(30)), cos(radians(30))))


def test_the_output_is_the_slider_at_the_point_that_is_named() -> None:
    """B belongs to links 2 and 3: it is the slider's."""
    read = mechanism(f"{LEANING}[output]\npoint = 'B'\n")
    assert read.output is not None
    assert (read.output.link, read.output.point) == (3, "B")


# Masses and loads on the crank alone: the moment that holds it, positive counter-clockwise


def held(tables: str, speed: float = 1, acceleration: float = 0) -> float:
    """Give M_bal of the crank along +x."""
    text = CRANK.replace("ACCELERATION", str(acceleration)).replace("SPEED", str(speed))
    return float(Statics(LinkageStudy(parse_scene(text + tables))).forces.balancing.moment[0])


SPRING = '[[loads.springs]]\nbetween = ["A", "D"]\nstiffness = 100\nfree = 0.1\n'
LOAD = '[[loads.forces]]\non = 1\npoint = "A"\n'
TWIST = "[[loads.moments]]\non = 1\nvalue = 5\n"


@pytest.mark.parametrize(
    ("tables", "moment"),
    [
        ('[masses]\n1 = { mass = 2, centre = "middle" }\n[loads]\ngravity = 9.81\n', 2 * 9.81 * 0.2),
        ("[masses]\n1 = { mass = 2, centre = [-0.1, 0] }\n[loads]\ngravity = 9.81\n", -2 * 9.81 * 0.1),
        ("[masses]\n1 = { mass = 2, centre = [0, 0.3] }\n[loads]\ngravity = [5, 0]\n", 2 * 5 * 0.3),
        ("[masses]\n1 = { mass = 2, centre = [0.2, -0.3] }\n[loads]\ngravity = [-5, 7]\n", 2 * (5 * 0.3 - 7 * 0.2)),
        ('[masses]\n1 = { mass = 2, centre = "A" }\n[loads]\ngravity = 9.81\n', 2 * 9.81 * 0.4),
        (LOAD + "value = [3, -10]\n", 10 * 0.4),
        (LOAD + "value = 10\ndirection = 270\n", 10 * 0.4),
        (LOAD + "value = 10\ndirection = 30\n", -10 * 0.5 * 0.4),
        (LOAD + "value = -10\ndirection = 90\n", 10 * 0.4),
        (TWIST, -5),
        (TWIST.replace("5", "-5"), 5),
        (SPRING, -100 * (0.3 - 0.1) * 0.4),
        (SPRING.replace("0.1", "0.5"), 100 * (0.5 - 0.3) * 0.4),
        (SPRING.replace('"A", "D"', '"D", "A"'), -100 * (0.3 - 0.1) * 0.4),
    ],
    ids=[
        "a weight in the middle",
        "a weight behind the hinge",
        "a weight above the crank",
        "a weight below the crank",
        "a weight at a point",
        "a force by its vector",
        "a force downwards",
        "a force that leans",
        "a negative force",
        "a moment",
        "a negative moment",
        "a spring that pulls",
        "a spring that pushes",
        "a spring named from its other end",
    ],
)
def test_what_holds_the_crank_against_weights_loads_and_springs(tables: str, moment: float) -> None:
    """A spring to D above A pulls the crank up where it is longer than free, and pushes it down where shorter."""
    assert held(tables) == near(moment)
    assert held(tables, speed=-1) == near(moment)


@pytest.mark.parametrize("speed", [2, -2])
def test_what_is_against_the_motion_is_held_with_the_motion(speed: float) -> None:
    sense = np.sign(speed)
    assert held(LOAD + 'against = "motion"\nvalue = 10\n', speed) == near(sense * 4)
    assert held(TWIST + 'against = "motion"\n', speed) == near(sense * 5)


def test_inertia_is_about_the_mass_centre_and_opposes_the_acceleration() -> None:
    body = "[masses]\n1 = { mass = 2, inertia = 0.5, centre = [0.1, 0] }\n"
    assert held(body, acceleration=3) == near((0.5 + 2 * 0.1**2) * 3)
    assert held(body, acceleration=-3) == near(-(0.5 + 2 * 0.1**2) * 3)


@pytest.mark.parametrize(("speed", "along"), [(1, -1), (-1, 1)])
def test_the_pinion_above_the_shaft_pushes_the_wheel_on_and_towards_the_shaft(speed: float, along: float) -> None:
    """5 N*m against the motion on a wheel of 0.1 m: 50 N along the tangent, 50 tan 20 N down, at (0, 0.1)."""
    gear = "[drive.gear]\nradius = 0.1\nat = 90\npressure_angle = 20\n" + TWIST + 'against = "motion"\n'
    text = CRANK.replace("ACCELERATION", "0").replace("SPEED", str(speed))
    told = Statics(LinkageStudy(parse_scene(text + gear))).forces.balancing
    assert told.force is not None and told.r is not None
    assert complex(told.force[0]) == near(complex(50 * along, -50 * np.tan(radians(20))))
    assert complex(told.r[0]) == near(0.1j)


def test_moments_of_a_spring_s_ends_belong_to_the_links_that_hold_them() -> None:
    (spring,) = machine(CRANK.replace("ACCELERATION", "0").replace("SPEED", "1") + SPRING).springs
    assert (spring.links, spring.points, spring.at) == ((1, 0), ("A", "D"), (0.4, 0.4 + 0.3j))


# Strokes: what a load is along the travel


def pressed(load: str, *degrees: float, speed: float = 1) -> list[float]:
    """Give the load N on the slider along +x at some crank angles."""
    text = ENGINE.replace("SPEED", str(speed)).replace("ANGLES", str(list(degrees)))
    statics = Statics(LinkageStudy(parse_scene(text + load)))
    (force,) = statics.drafts().loading.forces
    return [float(one.real) for one in force.force]


GONE = (0.4 - sqrt(0.08)) / 0.2  # share of the travel from 0.4 m to B at the crank's quarter turn
DIAGRAM = 'against = "motion"\ndiagram = { travel = [0, 1], force = [0, 1000], back = [300, 100] }\n'


def test_a_diagram_s_travel_runs_from_where_the_working_stroke_begins() -> None:
    """Both strokes are as long: the working one begins at 0, inwards; B resists outwards on it, inwards on the idle."""
    assert pressed(DIAGRAM, 90, 270) == pytest.approx([1000 * GONE, -(300 - 200 * GONE)])


def test_a_crank_that_turns_clockwise_works_on_the_other_half_turn() -> None:
    assert pressed(DIAGRAM, 90, 270, speed=-1) == pytest.approx([-(300 - 200 * GONE), 1000 * GONE])


@pytest.mark.parametrize(("during", "on"), [("working stroke", [1, 0]), ("idle stroke", [0, -1]), ("always", [1, -1])])
def test_a_load_acts_on_its_own_stroke(during: str, on: list[float]) -> None:
    load = f'against = "motion"\nvalue = 80\nduring = "{during}"\n'
    assert pressed(load, 90, 270) == pytest.approx([80 * one for one in on])


def test_overruns_are_shares_from_the_beginning_and_from_the_end() -> None:
    """Gone at 30, 36, 100 and 105 degrees: 0.088, 0.125, 0.670 and 0.709 of the stroke; it cuts from 0.1 to 0.7."""
    load = 'against = "motion"\nvalue = 80\nduring = "working stroke"\noverrun = [0.1, 0.3]\n'
    assert pressed(load, 30, 36, 100, 105) == [0, 80, 80, 0]


@pytest.mark.parametrize(
    ("reach", "angle", "share"),
    [((0.2, 0.8), 0.35, 0.25), ((0.8, 0.2), 0.35, 0.75), ((3.0, 3.4), 3.1 - 2 * pi, 0.25), ((0.2, 0.8), 0.9, 1.0)],
    ids=["a swing", "a swing back", "a swing across half a turn", "beyond the swing"],
)
def test_a_rocker_s_share_of_its_swing_is_counted_from_where_the_working_stroke_begins(
    reach: tuple[float, float], angle: float, share: float
) -> None:
    motion = Motion("analysis", np.zeros(1), {}, {3: LinkMotion([np.array([angle])])}, ())
    assert OutputStroke(0.0, 3.0, 1, reach, 3).share(motion)[0] == pytest.approx(share)
