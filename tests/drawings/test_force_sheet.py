"""The force sheet: what it says can be checked with a ruler, and which position and which loads it has."""

from __future__ import annotations

import re

import numpy as np
import pytest

from drawings.forces import sheet
from drawings.forces.arms import aside
from drawings.forces.letters import BALANCE, PAIR
from drawings.forces.lever import hanging
from drawings.forces.scheme import fan
from drawings.kinds.polygon import LaidVector, ShownVector
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import merging
from drawings.layout.picture import Place
from drawings.linkage import sheet as linkage_sheet
from drawings.linkage.positions import force_positions, planless
from drawings.page.page import Scale
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Fill, Leaf, Line, SheetError
from drawings.paper.walk import flat, texts
from drawings.reading.items import SheetFigures
from drawings.symbols.couples import not_to_scale
from drawings.symbols.figure import Arm, Subject
from plans.forces.quantities import ForceComparison, compare_forces
from plans.forces.statics import Statics
from plans.forces.worth import PositionWorth, worth
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.held import measured
from tests.gallery import GALLERY
from tests.parts import first
from tests.plans.force_cases import text_of
from tests.plans.test_statics import YOKE

Checked = tuple[LinkageStudy, ForceComparison, Statics, Leaf]


def sheets_of(study: LinkageStudy) -> tuple[ForceComparison, Statics, tuple[Leaf, ...]]:
    statics = Statics(study)
    comparison = compare_forces(statics, compare(study))
    return comparison, statics, sheet.sheets(study, comparison, statics)


@pytest.fixture(scope="module")
def checked() -> Checked:
    """The shaper at 60 degrees, driven by a gear: the worked example of methods M5.7 and M5.8."""
    study = LinkageStudy(parse_scene(text_of("shaper")))
    comparison, statics, (leaf,) = sheets_of(study)
    return study, comparison, statics, leaf


# With a ruler

# methods' worked case M5.7, N.
M57 = {
    ("forces-4-5", "Φ_4"): 14.86350455 + 5.228213782j, ("forces-4-5", "Φ_5"): 123.6578622 + 0j,
    ("forces-4-5", "G_5"): -245.25j, ("forces-4-5", "F_us"): 1500 + 0j,
    ("forces-4-5", "R^t_34"): 0.8069359265 + 10.60216184j, ("forces-4-5", "R^n_34"): -1639.328303 + 124.7701104j,
    ("forces-4-5", "R_34"): -1638.521367 + 135.3722722j, ("forces-4-5", "R_05"): 134.079514j,
    ("forces-4-5", "R_54"): 1623.657862 - 111.170486j, ("forces-2-3", "Φ_3"): 37.2201641 + 26.14106891j,
    ("forces-2-3", "R_43"): 1638.521367 - 135.3722722j, ("forces-2-3", "R_12"): -2537.127867 + 335.3600848j,
    ("forces-2-3", "R_03"): 861.3863359 - 78.97888146j, ("forces-1", "P_bal"): 1290.915752 - 1083.206931j,
    ("forces-1", "R_21"): 2537.127867 - 335.3600848j, ("forces-1", "R_01"): -3828.043619 + 1477.427016j,
}  # fmt: skip


def test_a_ruler_finds_the_forces_of_the_worked_example(checked: Checked) -> None:
    found = measured(checked[3])
    sides = {(one.plan, one.name): one for one in found.vectors}
    for key, value in M57.items():
        assert abs(sides[key].value - value) <= 2 * found.quantum * sides[key].scale + 1e-5, key  # their last digit
        assert abs(sides[key].stated - value) <= 1e-5, key


def test_inertia_forces_are_masses_by_what_the_acceleration_plan_of_the_sheet_has(checked: Checked) -> None:
    sheet_read = measured(checked[3])
    found = {(one.plan, one.name): one for one in sheet_read.vectors}
    assert ("velocities", "p d") in found
    for cut, force, end, mass in (("4-5", "Φ_4", "s4", 3.0), ("4-5", "Φ_5", "d", 25.0), ("2-3", "Φ_3", "s3", 15.0)):
        plan = found["accelerations", f"π {end}"]
        off = mass * plan.value + M57[f"forces-{cut}", force]
        assert abs(off) <= 2 * sheet_read.quantum * mass * plan.scale + 1e-5, force


def test_the_lever_of_the_worked_example_needs_its_gear_force(checked: Checked) -> None:
    """M5.8: the other forces have -2850.376673 W, and the gear force of 1685.170833 N balances them."""
    drafts = checked[2].drafts().plans
    assert drafts.lever is not None
    pushes = hanging(drafts.plan, drafts.lever, 0).forces
    (gear,) = (one for one in pushes if one.kind == BALANCE)
    assert abs(abs(gear.value) - 1685.170833) < 1e-6
    assert abs(gear.moment - 2850.376673) < 1e-6
    assert abs(sum(one.moment for one in pushes)) < 1e-6
    couples = [one for one in pushes if one.kind == PAIR]  # two forces each, none at the hinge
    assert list(dict.fromkeys(one.name for one in couples)) == ["M^Φ_1/OA", "M^Φ_3/CA", "M^Φ_4/BD"]
    assert all(one.at != 0 for one in couples)


def test_a_force_plan_closes_on_the_paper_and_each_side_is_its_force_over_the_scale(checked: Checked) -> None:
    """Lay the ruler on every side of group 4-5: its millimetres times mu_F are the newtons of the equations."""
    leaf = checked[3]
    sides = {one.name: one for one in measured(leaf).vectors if one.plan == "forces-4-5"}
    told = " ".join(text.plain for group in leaf.groups if group.name == "equations-4-5" for text in texts((group,)))
    for name, plain in (("F_us", "Fus"), ("G_5", "G5"), ("R_05", "R05"), ("R_34", "R34"), ("R_54", "R54")):
        found = re.search(rf"{plain} = ([\d.]+) N", told)
        assert found is not None, name
        millimetres = abs(sides[name].end - sides[name].start)
        assert millimetres * sides[name].scale == pytest.approx(float(found[1]), abs=0.01 * sides[name].scale + 0.05)
    assert str(SheetFigures(leaf).called("equations-4-5")) == "the workings"  # no title of a figure
    outer = ("R^n_34", "R^t_34", "Φ_4", "G_4", "Φ_5", "G_5", "F_us", "R_05")
    assert abs(sum(sides[name].value for name in outer)) < 0.1  # N, of 1700


# Positions, languages, mechanisms


@pytest.mark.parametrize("length", [1.6, 3.0, 40.0])
def test_the_head_of_a_force_stands_out_of_its_line(length: float) -> None:
    """Of ISO 129-1: a filled head of 15 to 30 degrees, at the tip."""
    place, side = Place(0j, 0j, Scale(1.0, "F", "N")), ShownVector("G_1", "side", 0j, complex(length))
    laid, hand = LaidVector(side, (0j, complex(length))), hand_of("A1")
    drawn = laid.draw(Subject("forces-1", "F", 0), "G_1", place, hand.result, hand)
    line, head = drawn.strokes
    assert isinstance(line, Line) and isinstance(head, Fill) and head.points[0] == line.end
    wide, long = abs(head.points[1] - head.points[2]), abs(head.points[0] - (head.points[1] + head.points[2]) / 2)
    assert wide > line.style.width and 15 < np.degrees(2 * np.arctan(wide / 2 / long)) < 30 + 1e-9


def test_no_dimension_lies_on_a_force() -> None:
    """A level arm is dimensioned aside of a level force at its point, and is left in place beside an upright one."""
    arm = Arm("h_1", 0j, 60 + 20j, -1j)
    for force, off in (((0j, 20 + 0j), True), ((5 + 0j, 5 + 20j), False)):
        (drawn,) = aside([arm], [force], None, hand_of("A1"))
        assert merging(arm.ends, force) is off is (drawn.aside != 0.0) and not merging(drawn.ends, force)


def test_a_short_arm_is_dimensioned_aside_of_its_pivot_by_arrows_from_outside() -> None:
    (drawn,) = aside([Arm("h_1", 0j, 6 + 40j, -1j)], [], None, hand_of("A1"))
    heads = [stroke for stroke in flat(drawn.draw(hand_of("A1"))) if isinstance(stroke, Fill)]
    assert drawn.aside and sorted(head.points[0].real for head in heads) == pytest.approx([0.0, 6.0])
    assert all(not 0 < head.points[1].real < 6 for head in heads)
    near = [Arm("h_2", 0j, 30 * turn, -1j * turn) for turn in (1, (399 + 40j) / 401)]  # feet 3 mm apart
    assert [arm.aside != 0 for arm in aside(near, [], None, hand_of("A1"))] == [False, True]  # heads do not meet


def test_the_letter_of_an_arm_stands_on_the_side_away_from_a_near_one() -> None:
    arm, hand, level = Arm("h_1", 50 + 50j, 82 + 34j, (1 + 2j) / 5**0.5), hand_of("A1"), (50 + 50j, 90 + 50j)
    for others, above in ([], True), ([level], False):
        (letter,) = texts([arm.letter_beside(Labels(Ink(99, 99), hand.drafted), hand, others)])
        assert (letter.at.imag > 42) is above


def test_a_force_that_would_run_in_a_rod_stands_beside_it() -> None:
    rod, force = [(Line(-60j, 60j), 3.0)], not_to_scale("Φ_4", -1j, 0j, 16.0)
    (inside,), (outside,) = (fan([force], [(2.0, sides)], rod, [0j], None, hand_of("A1")) for sides in ([-1, 1], []))
    assert abs(inside.at.real) > 5 and inside.lead is not None and outside.at.real == 0.0


@pytest.mark.rest
def test_without_a_word_the_forces_are_those_of_a_loaded_position_whose_plans_are_open() -> None:
    """In the middle of the cut the velocity plan of a shaper all but closes to one line: not there, nor at its ends."""
    changes = ("value = 1500", "value = 150"), ("positions = [60]", "positions = 12")
    comparison, statics, (leaf,) = sheets_of(LinkageStudy(parse_scene(text_of("shaper", *changes))))
    shown, motion = leaf.metadata["position"], comparison.motion.analysis
    (cut,) = statics.loading(motion).forces
    power = -(cut.force.conj() * motion.points["D"].v).real
    assert power[shown] > 0.7 * power.max() and np.argmax(power) != shown
    ends = np.array([0 * motion.phi, *(point.v for point in motion.points.values())])
    across = np.linalg.svd(np.stack([ends.real, ends.imag], axis=-1).swapaxes(0, 1), compute_uv=False)
    slender = across[:, 1] / across[:, 0]
    assert slender[shown] > 2 * slender[np.argmax(power)]


def test_worth_is_stable_against_last_bits() -> None:
    """A position with a mirrored twin stays the one that is chosen, whatever the last bit of either says."""
    rows = np.array([0.0, 0.9, 0.9, 0.0])
    for bit in (-1e-12, 1e-12):
        open_ = {"velocities": np.array([0.0, 0.5, 0.5 - bit, 0.0])}
        rated = PositionWorth(True, rows + np.array([0, 0, bit, 0]), open_, rows)
        assert int(np.argmax(rated.sizes)) == 1


def test_beside_an_extreme_a_position_is_not_worth_its_greater_work() -> None:
    """A crusher's loads do most 2 degrees after its extreme, where the velocity plan is a line a hand cannot open."""
    open_ = {"velocities": [0.5, 0.04, 0.547], "accelerations": [0.9, 0.861, 0.178], "forces-2-3": [0.2, 0.668, 0.565]}
    rows = {name: np.array(row) for name, row in open_.items()}
    rated = PositionWorth(True, np.array([0.0, 1.0, 0.694]), rows, np.ones(3))
    assert np.argmax(rated.sizes) == 2
    assert np.argmax(rated._replace(balancing=np.array([0.5, 1.0, 0.005])).sizes) != 2  # less than the slips of a hand


def test_the_plan_of_a_cylinder_that_is_not_loaded_is_worth_little_at_the_scale_of_the_set() -> None:
    """700 N press on the right piston as it rises; in position 10 it goes back, and but 26 N of weights are laid."""
    own = Statics(
        LinkageStudy(parse_scene(GALLERY.joinpath("v-compressor.toml").read_text("utf-8").replace("980", "9")))
    )
    seen = worth(own, own.forces).open["forces-4-5"]
    assert seen[10] < 0.1 < seen[8]


@pytest.mark.rest
def test_the_plans_of_the_position_whose_forces_are_drawn_stand_on_the_kinematics_sheet() -> None:
    """Their inertia forces are taken from its acceleration plan; alone, the sheet shows the fastest position."""
    text = text_of("shaper", ("value = 1500", "value = 150"), ("positions = [60]", "positions = 12"))
    both, alone = (
        Study(parse_scene(text.replace('sheets = ["forces"]', f"sheets = {sheets}")))
        for sheets in ('["kinematics", "forces"]', '["kinematics"]')
    )
    own = Statics(both["linkage"])
    (drawn,) = force_positions(own, compare_forces(own, both.comparison("linkage")))
    shown = [linkage_sheet.leaves(study)[0].metadata["shown"] for study in (both, alone)]
    assert shown[0] == drawn != shown[1]
    motion = both.comparison("linkage")
    assert [planless(own.study, motion, beside) for beside in ((drawn,), (0, drawn))] == [(), ()]
    assert planless(alone["linkage"], motion, (drawn,)) == ()
    asked = f"{text}\n[sheet]\nplans = [{(drawn + 3) % 12}]\n".replace('["forces"]', '["kinematics", "forces"]')
    other = Study(parse_scene(asked))
    assert planless(other["linkage"], motion, (drawn,)) == (drawn,)


@pytest.mark.rest
def test_a_position_without_forces_is_refused_with_those_that_have_them() -> None:
    text = text_of("kind-1", ("positions = [0]", "start = 0\npositions = 12"), ("AB = 0.30", "AB = 0.12"))
    text = text.replace("[0.15, 0]", "[0.06, 0]").replace("B = [0.336, 0.236]", "B = [0.2, 0.1]")
    study = LinkageStudy(parse_scene(text + "\n[sheet]\nforces = [0]\n"))
    comparison, statics, _ = sheets_of(study)
    gone = sorted({gap.position for gap in statics.forces.gaps})
    assert gone, "the dyad of kind 1 cannot follow the crank all the way round"
    wanted = LinkageStudy(parse_scene(text + f"\n[sheet]\nforces = [{gone[0]}]\n"))
    with pytest.raises(SheetError, match=rf"position {gone[0]} has no forces. Fix: choose one of 0, "):
        sheets_of(wanted)
    assert comparison.agrees


def test_a_balancing_moment_that_is_but_rounding_is_drawn_and_written_as_none() -> None:
    """A yoke twisted in its guide takes nothing from the crank: no diagram of roundings, no 0.0000000000002 N."""
    comparison, _, leaves = sheets_of(LinkageStudy(parse_scene(YOKE)))
    told = [text.plain for leaf in leaves for group in leaf.groups for text in texts((group,))]
    assert not any(re.search(r"0\.00000000|·10⁻", one) for one in told)
    assert "Mbal = 0 N·m" in told
    assert comparison.agrees


@pytest.mark.parametrize("load", first(["value = [0, 0]", 'against = "motion"\nvalue = 5']))
def test_a_load_that_is_nothing_all_the_way_round_gets_a_sheet(load: str) -> None:
    still = YOKE.partition("[[loads.moments]]")[0] + f'[[loads.forces]]\non = 1\npoint = "O"\n{load}\n'
    _, _, leaves = sheets_of(LinkageStudy(parse_scene(still)))
    assert leaves


@pytest.mark.parametrize("name", ["R_12", "G_2", "Φ_3", "M_bal", "P_bal", "M_03", "F_12"])
def test_a_load_may_not_bear_a_letter_that_the_sheet_gives_itself(name: str) -> None:
    text = YOKE.replace("value = 5", f'value = 5\nname = "{name}"')
    with pytest.raises(SceneError, match="Fix: rename the load"):
        parse_scene(text)


def test_a_spring_between_the_two_links_of_a_hinge_is_refused() -> None:
    text = YOKE + '\n[[loads.springs]]\nbetween = [{ on = 1, point = "A" }, { on = 2, point = "A" }]\nstiffness = 5\n'
    with pytest.raises(SceneError, match="A is a hinge of both links"):
        sheets_of(LinkageStudy(parse_scene(text + "free = 0.01\n")))


@pytest.mark.rest
def test_thirteen_links_have_indices_apart_and_their_rows_are_read() -> None:
    links, slides = ['1 = "OA"'], []
    frame, lengths, sketch = ["O = [0, 0]"], ["OA = 0.1"], []
    for k in range(1, 7):  # six slider-cranks on one crank pin
        links += [f'{2 * k} = ["A", "B{k}"]', f'{2 * k + 1} = ["B{k}"]']
        lengths.append(f"AB{k} = 0.4")
        slides.append(f"[[mechanism.slides]]\nlink = {2 * k + 1}\nalong = {{ through = [0, 0], angle = {60 * k} }}")
        sketch.append(f"B{k} = [{0.4 * np.cos(np.radians(60 * k)):.3f}, {0.4 * np.sin(np.radians(60 * k)):.3f}]")
    text = "\n".join(
        [
            *('title = "Star"', 'sheets = ["forces"]', "[mechanism.frame]", *frame, "[mechanism.links]", *links),
            *("[mechanism.lengths]", *lengths, *slides, "[mechanism.sketch]", *sketch),
            *("[drive]", "link = 1", "speed = 10", "positions = [20]", "[masses]"),
            *(f"{2 * k + 1} = {{ mass = {k} }}" for k in range(1, 7)),
        ]
    )
    comparison, _, leaves = sheets_of(LinkageStudy(parse_scene(text)))
    names = [
        text.plain
        for leaf in leaves
        for group in leaf.groups
        if group.name.startswith("values")
        for text in texts((group,))
    ]
    assert "R12,13, N" in names
    assert "R1,12, N" in names
    assert comparison.agrees


def test_the_moments_of_the_equation_with_the_arms_as_stated_cancel(checked: Checked) -> None:
    """ΣM_D of rod 4: the stated forces by the stated arms and the stated couple give zero."""
    leaf = checked[3]
    told = " ".join(text.plain for group in leaf.groups if group.name == "equations-4-5" for text in texts((group,)))
    value = {name: float(number) for name, number in re.findall(r"(\S+) = (-?[\d.]+)", told.replace("−", "-"))}
    arms = {"h1": value["h1"] / 1000, "h2": value["h2"] / 1000, "lBD": 0.2}
    total = 0.0
    equation = told[told.index("ΣMD") : told.index("=0") if "=0" in told else told.index("Rt34 = ")]
    for sign, force, arm in re.findall(r"([-−+]?) ?(Rt34|Φ4|G4) ?· ?(lBD|h1|h2)", equation):
        total += (-1 if sign in ("-", "−") else 1) * value[force] * arms[arm]
    couple = re.search(r"([-−+]) ?\|MΦ4\|", equation)
    assert couple is not None
    total += (-1 if couple[1] in ("-", "−") else 1) * abs(value["MΦ4"])
    assert total == pytest.approx(0, abs=2e-3)  # five digits of three newton metres
